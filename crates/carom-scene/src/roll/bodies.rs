//! What every kind builds: a body, segments and a start.

use crate::drawing::{INERTIA, MASS};
use crate::problem::{Problem, ProblemKind};
use crate::quantity::{Allowed, Kind, Quantity};
use crate::section::Section;
use crate::unit::Dimension;
use carom_motion::planar::{Body, State};
use carom_num::Vec2;

pub(super) const RATIO: Kind = Kind::new(Dimension::Number, Allowed::Positive);
pub(super) const ROLL_RATE: Kind = Kind::new(Dimension::Spin, Allowed::Any);
pub(super) const ANGLE: Kind = Kind::new(Dimension::Angle, Allowed::Slope);
pub(super) const ANY_SPEED: Kind = Kind::new(Dimension::Speed, Allowed::Any);

/// Mass where none is written [kg].
const DEFAULT_MASS: f64 = 1.0;

/// A body among named segments, and its start.
pub(super) struct Setup {
    pub(super) body: Body,
    pub(super) segments: Vec<(String, [Vec2; 2])>,
    /// What is drawn beside them and never reached.
    pub(super) unreached: Vec<[Vec2; 2]>,
    pub(super) start: State,
}

/// Mass and moment of inertia.
pub(super) struct Heft {
    pub(super) mass: f64,
    inertia: Option<f64>,
    ratio: Option<f64>,
}

impl Heft {
    /// Reads `mass`, and `inertia` or `inertia_ratio`.
    pub(super) fn read(root: &Section<'_>) -> Self {
        let value = |q: Option<Quantity>| q.map(|q| q.value);
        let mass = value(root.quantity("mass", MASS)).unwrap_or(DEFAULT_MASS);
        let inertia = value(root.quantity("inertia", INERTIA));
        let ratio = value(root.quantity("inertia_ratio", RATIO));
        exclusive(root, "inertia", &["inertia_ratio"]);
        Self { mass, inertia, ratio }
    }

    /// Moment of inertia: as written, by its ratio to m a², or else of a radius of gyration.
    pub(super) fn inertia(&self, arm: f64, gyration_squared: f64) -> f64 {
        let ratio = self.ratio.map(|ratio| ratio * self.mass * arm * arm);
        self.inertia.or(ratio).unwrap_or(self.mass * gyration_squared)
    }
}

/// Says that `key` does not go together with any of `others`.
pub(super) fn exclusive(root: &Section<'_>, key: &'static str, others: &[&'static str]) {
    if !root.has(key) {
        return;
    }
    for other in others.iter().filter(|other| root.has(other)) {
        let message = format!("does not go together with {key}: each says the same thing in its way");
        let span = Some(root.key_span(other));
        root.sink().push(Problem::new(ProblemKind::Conflict, *other, message, span));
    }
}

/// Says that a key's value does not fit the others.
pub(super) fn unfit(root: &Section<'_>, key: &'static str, message: impl Into<String>) {
    let span = root.has(key).then(|| root.key_span(key));
    root.sink().push(Problem::new(ProblemKind::Geometry, key, message, span));
}
