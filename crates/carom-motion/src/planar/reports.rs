//! What a walk says of its pieces to those who look on.

use super::State;
use super::observer::{Observers, PieceFacts};
use super::path::{Course, Leg};
use super::trace::PieceEnd;
use super::walker::Walker;

impl<const B: usize> Walker<'_, B> {
    /// Notes the next part of the present piece, for those who want to know.
    pub(super) fn note_leg(&mut self, length: f64, course: impl FnOnce() -> Course<B>) {
        if let Some(path) = &mut self.path {
            path.push(Leg { start: self.time, length, course: course() });
        }
    }

    /// Says that a piece starts, to those who look on each body.
    pub(super) fn report_start(&self, observers: &mut Observers<'_, B>) {
        for (body, observer) in observers.iter_mut().enumerate().take(self.world.bodies.len()) {
            let Some(observer) = observer else { continue };
            observer.starts(self.time, &self.states[body], &mut self.held_of(body));
        }
    }

    /// Says that a piece has ended, to those who look on each body.
    pub(super) fn report_piece(
        &self,
        start_time: f64,
        starts: &[State; B],
        ended_by: impl Fn(usize) -> PieceEnd,
        observers: &mut Observers<'_, B>,
    ) {
        for (body, observer) in observers.iter_mut().enumerate().take(self.world.bodies.len()) {
            let Some(observer) = observer else { continue };
            let (start, end) = (starts[body], self.states[body]);
            let ended_by = ended_by(body);
            observer.piece(&PieceFacts { start_time, end_time: self.time, start, end, ended_by });
        }
    }
}
