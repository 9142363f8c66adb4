//! Where bodies are during a smooth piece of motion, at any time of it.

use super::State;
use super::events::{Vector, unpack};
use carom_num::Vec2;
use carom_num::ode8::Step;

/// A part of a piece that one formula describes.
#[derive(Clone, Debug)]
pub(super) struct Leg<const B: usize> {
    /// Start [s].
    pub(super) start: f64,
    /// Length [s].
    pub(super) length: f64,
    pub(super) course: Course<B>,
}

/// How bodies move along a leg.
#[derive(Clone, Debug)]
pub(super) enum Course<const B: usize> {
    /// Free flight from these states under gravity [m/s²].
    Flight([State; B], Vec2),
    /// A step of the integration, its dense output.
    Step(Box<Step<Vector<B>>>),
    /// Rest.
    Rest([State; B]),
}

impl<const B: usize> Leg<B> {
    pub(super) fn end(&self) -> f64 {
        self.start + self.length
    }

    /// The states at a time [s].
    pub(super) fn at(&self, time: f64) -> [State; B] {
        let since = time - self.start;
        match &self.course {
            Course::Flight(states, gravity) => states.map(|s| s.flown(*gravity, since)),
            Course::Step(step) => unpack(&step.at((since / step.length).clamp(0.0, 1.0))),
            Course::Rest(states) => *states,
        }
    }
}
