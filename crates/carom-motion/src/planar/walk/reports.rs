//! What a walk says of its pieces to those who look on.

use super::path::{Course, Leg};
use super::walker::Walker;
use crate::planar::geometry::State;
use crate::planar::record::{
    observer::{Observers, PieceFacts},
    trace::PieceEnd,
};

impl<const B: usize> Walker<'_, B> {
    /// Notes the next part of the present piece, for those who want to know.
    pub(super) fn note_leg(&mut self, length: f64, course: impl FnOnce() -> Course<B>) {
        if let Some(path) = &mut self.path {
            path.push(Leg { start: self.time, length, course: course() });
        }
    }

    /// Hands over the states that are asked for within the next part of the present piece; at its end something may happen, so that is not within it.
    pub(super) fn show_instants(
        &self,
        length: f64,
        after: impl Fn(f64) -> [State; B],
        observers: &mut Observers<'_, B>,
    ) {
        for (body, observer) in observers.iter_mut().enumerate().take(self.world.bodies.len()) {
            let Some(observer) = observer else { continue };
            let mut next = observer.next_instant();
            while next < self.time + length {
                observer.instant(next, &after((next - self.time).max(0.0))[body]);
                let asked = std::mem::replace(&mut next, observer.next_instant());
                if next <= asked {
                    break;
                }
            }
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
