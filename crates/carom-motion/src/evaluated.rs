//! What gaps, turns, flights and equations of motion are evaluated to: every such number passes here once, and one that is none is noted.
//!
//! A comparison with what is no number is false, whichever way it is asked: an event would be passed over without a word. Whoever moves bodies
//! asks at the end whether a number was lost on the way, and does not hand on what it has come to. A step that is tried and loses one is not taken: it is
//! tried again, shorter, and what it lost is forgotten.

#[cfg(test)]
pub(crate) mod faults;

use crate::MotionError;
use std::cell::Cell;

thread_local! {
    /// A number was lost on this thread since somebody asked.
    static LOST: Cell<bool> = const { Cell::new(false) };
}

/// What a number is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Quantity {
    /// The turn of a body.
    Turn,
    /// The gap of a pair of features.
    Gap,
    /// How far a body is from what it does not touch.
    Distance,
    /// The acceleration of a mode.
    Acceleration,
    /// A coefficient of a motion's series.
    Coefficient,
    /// The place of a body in flight.
    Flight,
    /// An event function.
    Event,
}

/// The number itself; where it is none that is noted.
#[inline(always)]
pub(crate) fn evaluated(of: Quantity, value: f64) -> f64 {
    let value = met(of, value);
    if value.is_nan() {
        lose();
    }
    value
}

/// Nothing but the evaluation itself makes it fail.
#[cfg(not(test))]
#[inline(always)]
fn met(_: Quantity, value: f64) -> f64 {
    value
}

#[cfg(test)]
use faults::met;

#[cold]
fn lose() {
    LOST.set(true);
}

/// Does something; returns what came of it, and whether a number was lost in it.
pub(crate) fn watched<R>(work: impl FnOnce() -> R) -> (R, bool) {
    let before = LOST.replace(false);
    let done = work();
    (done, LOST.replace(before))
}

/// True where a number has been lost since somebody began to watch.
pub(crate) fn lost() -> bool {
    LOST.get()
}

/// Does something at this time, unless numbers have been lost: what it has come to then is not to be relied on, now or later. `lost` is where that is kept.
pub(crate) fn unless_lost<T, R>(
    of: &mut T,
    lost: fn(&mut T) -> &mut bool,
    time: f64,
    work: impl FnOnce(&mut T) -> Result<R, MotionError>,
) -> Result<R, MotionError> {
    if !*lost(of) {
        let (done, now) = watched(|| work(of));
        *lost(of) = now;
        if !now || done.is_err() {
            return done;
        }
    }
    Err(MotionError::NotFinite { time })
}
