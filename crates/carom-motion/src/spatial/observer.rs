//! Who looks on while a body moves.

use super::{Closing, Impact, Mode, Piece, State};
use std::ops::ControlFlow;

/// Who looks on. `()` looks at nothing.
pub trait Observer {
    /// True: samples are made and handed over.
    fn is_dense(&self) -> bool {
        false
    }

    /// An instant of the present stretch; only where [`Observer::is_dense`].
    fn sample(&mut self, time: f64, mode: Mode, state: &State) {
        let _ = (time, mode, state);
    }

    /// A stretch of motion has ended.
    fn piece(&mut self, piece: &Piece) {
        let _ = piece;
    }

    /// An impact; the answer may end the run.
    fn impact(&mut self, impact: &Impact) -> ControlFlow<()> {
        let _ = impact;
        ControlFlow::Continue(())
    }

    /// A series of impacts was closed at its limit.
    fn closing(&mut self, closing: &Closing) {
        let _ = closing;
    }
}

impl Observer for () {}

/// Keeps the stretches and the samples.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Samples {
    /// Time \[s\], what the body does and its state, in the order of time.
    pub instants: Vec<(f64, Mode, State)>,
    /// The stretches between events.
    pub pieces: Vec<Piece>,
}

impl Observer for Samples {
    fn is_dense(&self) -> bool {
        true
    }

    fn sample(&mut self, time: f64, mode: Mode, state: &State) {
        self.instants.push((time, mode, *state));
    }

    fn piece(&mut self, piece: &Piece) {
        self.pieces.push(*piece);
    }
}
