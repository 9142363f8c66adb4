//! Where bodies are during a smooth piece of motion, at any time of it.

use super::events::{Vector, unpack};
use crate::planar::geometry::State;
use carom_num::Vec2;
use carom_num::ode8::Step;
use std::fmt::Debug;
use std::sync::Arc;

/// A part of a piece that is known everywhere in it.
pub(in crate::planar) trait Stretch<const B: usize>: Debug + Send + Sync {
    /// Length [s].
    fn length(&self) -> f64;
    /// The states at its start.
    fn start(&self) -> [State; B];
    /// The states at a fraction of it.
    fn states(&self, fraction: f64) -> [State; B];
}

impl<const B: usize> Stretch<B> for Step<Vector<B>> {
    fn length(&self) -> f64 {
        self.length
    }

    fn start(&self) -> [State; B] {
        unpack(&self.start)
    }

    fn states(&self, fraction: f64) -> [State; B] {
        unpack(&self.at(fraction))
    }
}

/// A part of a piece that one formula describes.
#[derive(Clone, Debug)]
pub(in crate::planar) struct Leg<const B: usize> {
    /// Start [s].
    pub(in crate::planar) start: f64,
    /// Length [s].
    pub(in crate::planar) length: f64,
    pub(in crate::planar) course: Course<B>,
}

/// How bodies move along a leg.
#[derive(Clone, Debug)]
pub(in crate::planar) enum Course<const B: usize> {
    /// Free flight from these states under gravity [m/s²].
    Flight([State; B], Vec2),
    /// A step of the integration.
    Along(Arc<dyn Stretch<B>>),
    /// Rest.
    Rest([State; B]),
}

impl<const B: usize> Leg<B> {
    pub(in crate::planar) fn end(&self) -> f64 {
        self.start + self.length
    }

    /// The states at a time [s].
    pub(in crate::planar) fn at(&self, time: f64) -> [State; B] {
        let since = time - self.start;
        match &self.course {
            Course::Flight(states, gravity) => states.map(|s| s.flown(*gravity, since)),
            // A leg that ended at once is its start.
            Course::Along(stretch) if stretch.length() > 0.0 => {
                stretch.states((since / stretch.length()).clamp(0.0, 1.0))
            }
            Course::Along(stretch) => stretch.start(),
            Course::Rest(states) => *states,
        }
    }
}
