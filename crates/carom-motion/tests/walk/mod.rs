//! A walk that is followed up to a time.

use carom_motion::planar::trace::Trace;
use carom_motion::planar::{Happening, Options, Recorder, State, Walker, World};

/// Where the walk is then, all that was on the way, and how it ended. `sides` says of each obstacle whether the body is on its left.
pub(crate) fn followed(
    world: &World,
    start: State,
    sides: Vec<bool>,
    until: f64,
) -> (State, Trace, Happening) {
    followed_with(world, start, sides, Options { most_time: until, ..Options::default() })
}

/// As [`followed`], with options.
pub(crate) fn followed_with(
    world: &World,
    start: State,
    sides: Vec<bool>,
    options: Options,
) -> (State, Trace, Happening) {
    let mut walker = Walker::new(world, start, sides, options).unwrap();
    let mut recorder = Recorder::default();
    let end = loop {
        match walker.advance(&mut recorder).unwrap() {
            Happening::Moves => {}
            other => break other,
        }
    };
    (*walker.state(), recorder.into_trace(), end)
}
