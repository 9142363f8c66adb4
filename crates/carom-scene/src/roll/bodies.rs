//! What every kind builds: a body, segments and a start.

use crate::grammar::Section;
use crate::problem::ProblemKind;
use carom_motion::planar::{Body, State};
use carom_num::Vec2;

/// A body among named segments, and its start.
pub(super) struct Setup {
    pub(super) body: Body,
    pub(super) segments: Vec<(String, [Vec2; 2])>,
    /// What is drawn beside them and never reached.
    pub(super) unreached: Vec<[Vec2; 2]>,
    pub(super) start: State,
}

/// Mass and moment of inertia.
pub(super) struct MassSpec {
    pub(super) mass: f64,
    inertia: Option<f64>,
    ratio: Option<f64>,
}

impl MassSpec {
    /// Reads `mass`, and `inertia` or `inertia_ratio`.
    pub(super) fn read(root: &Section<'_>) -> Self {
        let (mass, inertia, ratio) =
            (root.number("mass"), root.value("inertia"), root.value("inertia_ratio"));
        Self { mass, inertia, ratio }
    }

    /// Moment of inertia: as written, by its ratio to m a², or else of a radius of gyration.
    pub(super) fn inertia(&self, arm: f64, gyration_squared: f64) -> f64 {
        let ratio = self.ratio.map(|ratio| ratio * self.mass * arm * arm);
        self.inertia.or(ratio).unwrap_or(self.mass * gyration_squared)
    }
}

/// Says that a key's value does not fit the others.
pub(super) fn unfit(root: &Section<'_>, key: &'static str, message: impl Into<String>) {
    root.blame(ProblemKind::Geometry, key, message);
}
