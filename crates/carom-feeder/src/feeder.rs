//! What stands on a feeder's drawing, checked and in SI units.

use crate::form::Form;
use crate::tolerance::PLATES_TOUCH;
use carom_impact::Law;
use carom_motion::planar::{Body, Shape};
use carom_num::Vec2;
use carom_num::segment::properly_cross;
use std::fmt;

/// What kind of part it is: decides the words of its verdicts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PartKind {
    /// Two opposed faces: lands the same or turned.
    Rod,
    /// Faces 0 and 2 long, 1 and 3 its ends.
    Box,
    /// Verdicts are face numbers.
    Polygon,
    /// No flat.
    Disc,
}

/// The part.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Its kind.
    pub kind: PartKind,
    /// Shape, mass, inertia.
    pub body: Body,
}

/// A plate, from its uphill end to its free edge.
#[derive(Clone, Debug, PartialEq)]
pub struct Plate {
    /// Its name.
    pub name: String,
    /// Uphill end [m].
    pub uphill: Vec2,
    /// Free edge, the downhill end [m].
    pub edge: Vec2,
    /// Friction against the part.
    pub friction: f64,
    /// Restitution against the part.
    pub restitution: f64,
    /// True where the drawing gives the plate no length and it is as long as needed: pictures may cut it.
    pub unbounded: bool,
    /// What it looks like between its ends.
    pub form: Form,
}

/// A wall: another obstacle.
#[derive(Clone, Debug, PartialEq)]
pub struct Wall {
    /// Its name.
    pub name: String,
    /// One end [m].
    pub from: Vec2,
    /// Other end [m].
    pub to: Vec2,
    /// Friction against the part.
    pub friction: f64,
    /// Restitution against the part.
    pub restitution: f64,
    /// What it looks like between its ends.
    pub form: Form,
}

/// How the part starts: lying flat on the first plate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start {
    /// From the mass centre to the first plate's free edge, along the plate [m].
    pub to_edge: f64,
    /// Speed down the plate [m/s].
    pub speed: f64,
    /// The face that is down (0 for a disc).
    pub face: usize,
}

/// When a run stops.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Stop {
    /// Flat on the last plate.
    #[default]
    Landed,
    /// Left over the last plate's edge.
    Delivered,
}

/// A feeder.
#[derive(Clone, Debug, PartialEq)]
pub struct Feeder {
    /// Gravity, downwards [m/s²].
    pub gravity: f64,
    /// When a run stops.
    pub stop: Stop,
    /// Restitution law.
    pub law: Law,
    /// The part.
    pub part: Part,
    /// How it starts.
    pub start: Start,
    /// The plates, in the order the part meets them.
    pub plates: Vec<Plate>,
    /// Other obstacles.
    pub walls: Vec<Wall>,
}

/// Why a feeder cannot be run.
#[derive(Clone, Debug, PartialEq)]
pub enum FeederProblem {
    /// A quantity out of range: its path (`part.mass`, `plate.lower.friction`), its value and what is allowed.
    OutOfRange {
        /// Path of the quantity.
        path: String,
        /// Its value, SI.
        value: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// A plate or wall of no length.
    NoLength {
        /// `plate.lower`
        path: String,
    },
    /// A plate or wall crosses the part where it starts.
    CrossesStart {
        /// `plate.lower`
        path: String,
    },
    /// What a plate or wall looks like makes no shape.
    Form {
        /// `plate.lower`
        path: String,
        /// What is wrong.
        why: &'static str,
    },
    /// Of all that stands there no world can be made.
    World {
        /// What is wrong.
        why: String,
    },
    /// No plates.
    NoPlates,
}

impl fmt::Display for FeederProblem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfRange { path, value, allowed } => write!(f, "{path} = {value}: {allowed}"),
            Self::NoLength { path } => write!(f, "{path} has no length"),
            Self::CrossesStart { path } => write!(f, "{path} crosses the part where it starts"),
            Self::Form { path, why } => write!(f, "{path}: {why}"),
            Self::World { why } => f.write_str(why),
            Self::NoPlates => write!(f, "a feeder needs at least one plate"),
        }
    }
}

impl Feeder {
    /// Pairs of plates that cross, by their numbers: such a feeder can be run, but not built. Plates that only touch do not cross, and plates as long as
    /// needed do not count.
    pub fn crossing_plates(&self) -> Vec<(usize, usize)> {
        let drawn = |plate: &Plate| if plate.unbounded { vec![] } else { plate.pieces() };
        crossing(&self.plates.iter().map(drawn).collect::<Vec<_>>())
    }
}

/// Pairs of plates that cross, of plates that are made of these pieces; one without any does not count.
pub(crate) fn crossing(plates: &[Vec<(Vec2, Vec2)>]) -> Vec<(usize, usize)> {
    let numbered = || plates.iter().enumerate();
    let pairs = numbered().flat_map(|a| numbered().skip(a.0 + 1).map(move |b| (a, b)));
    pairs.filter(|((_, a), (_, b))| cross(a, b)).map(|((i, _), (j, _))| (i, j)).collect()
}

/// True where two plates cross.
fn cross(a: &[(Vec2, Vec2)], b: &[(Vec2, Vec2)]) -> bool {
    let ends = |plate: &[(Vec2, Vec2)]| Some((plate.last()?.1 - plate.first()?.0).norm());
    let (Some(one), Some(other)) = (ends(a), ends(b)) else { return false };
    let longer = one.max(other);
    a.iter().any(|a| b.iter().any(|b| properly_cross(*a, *b, PLATES_TOUCH * longer)))
}

impl Part {
    /// A thin rod [m, kg, kg m²]: vertex 0 is its uphill end when face 0 is down and downhill is to the right.
    pub fn rod(length: f64, mass: f64, inertia: f64) -> Option<Self> {
        let half = 0.5 * length;
        let shape = Shape::new(vec![Vec2::new(-half, 0.0), Vec2::new(half, 0.0)], 0.0).ok()?;
        Some(Self { kind: PartKind::Rod, body: Body { shape, mass, inertia } })
    }

    /// A box [m, kg, kg m²]; face 0 is its lower long side.
    pub fn rectangle(length: f64, height: f64, mass: f64, inertia: f64) -> Option<Self> {
        let (a, b) = (0.5 * length, 0.5 * height);
        let corners = vec![Vec2::new(-a, -b), Vec2::new(a, -b), Vec2::new(a, b), Vec2::new(-a, b)];
        let shape = Shape::new(corners, 0.0).ok()?;
        Some(Self { kind: PartKind::Box, body: Body { shape, mass, inertia } })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plates_that_touch_or_end_before_do_not_cross() {
        let plate = |uphill: (f64, f64), edge: (f64, f64)| Plate {
            name: String::new(),
            uphill: Vec2::new(uphill.0, uphill.1),
            edge: Vec2::new(edge.0, edge.1),
            friction: 0.1,
            restitution: 0.0,
            unbounded: false,
            form: Default::default(),
        };
        let line = plate((0.0, 0.0), (1.0, -0.5));
        assert!(cross(&line.pieces(), &plate((0.5, 0.0), (0.5, -1.0)).pieces()));
        assert!(!cross(&line.pieces(), &plate((1.5, 0.0), (1.5, -1.0)).pieces()));
        assert!(!cross(&line.pieces(), &plate((0.5, -0.25), (0.5, -1.0)).pieces()));
    }
}
