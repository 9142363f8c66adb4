//! Parts that are known by their name and a few dimensions: bolts, washers, pins, caps, brackets, and any body of revolution.
//!
//! Each makes a closed outline and what it weighs, and goes on as every other outline does.
//!
//! A body of revolution moves with its axis in the plane. Plates are straight across the plane, so what touches them is the shadow of the body along
//! that direction: its profile and the mirror image of it. A hollow that opens along the axis lies within the shadow. No plate that is as wide as the
//! part reaches into it, so it takes weight away and touches nothing.

mod body;
mod bolt;
mod bracket;
mod cap;
mod pin;
mod revolved;
mod size;
mod washer;

pub(crate) use bolt::{Bolt, HeadWord};
pub(crate) use bracket::Bracket;
pub(crate) use cap::Cap;
pub(crate) use pin::{Pin, PinEnds};
pub(crate) use revolved::Revolved;
pub(crate) use size::{PIN_CHAMFER, Size, bolt_row, pin_row, read_size, washer_row};
pub(crate) use washer::Washer;

use crate::problem::{Problem, ProblemKind};
use crate::quantity::Quantity;
use crate::unit::Dimension;
use carom_motion::planar::{AxialMoments, ChainPoint};
use carom_num::Vec2;

/// A part of the library as it is written.
#[derive(Clone, Debug, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "a scene has one, behind a pointer")]
pub(crate) enum LibraryPart {
    Bolt(Bolt),
    Washer(Washer),
    Pin(Pin),
    Cap(Cap),
    Bracket(Bracket),
    Revolved(Revolved),
}

/// What a part of the library is made into.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Made {
    /// The outline, closed and counter-clockwise.
    pub(crate) outline: Vec<ChainPoint>,
    /// What is hollow within it, closed: it weighs nothing, and touches nothing.
    pub(crate) hollow: Vec<ChainPoint>,
    /// Of a body of revolution, whose axis is the x axis, from `zero` on; a flat part is as thick as its depth.
    pub(crate) axial: Option<AxialMoments>,
    /// [m]
    pub(crate) zero: f64,
    pub(crate) notes: Vec<String>,
}

impl LibraryPart {
    /// The outline and what it weighs, or what is wrong with the dimensions.
    pub(crate) fn make(&self) -> Result<Made, Vec<Problem>> {
        match self {
            Self::Bolt(part) => part.make(),
            Self::Washer(part) => part.make(),
            Self::Pin(part) => part.make(),
            Self::Cap(part) => part.make(),
            Self::Bracket(part) => part.make(),
            Self::Revolved(part) => part.make(),
        }
    }

    /// Its dimensions that are one quantity each, by their keys.
    pub(crate) fn dimensions(&mut self) -> Vec<(&'static str, &mut Quantity)> {
        match self {
            Self::Bolt(part) => part.dimensions(),
            Self::Washer(part) => part.dimensions(),
            Self::Pin(part) => part.dimensions(),
            Self::Cap(part) => part.dimensions(),
            Self::Bracket(part) => part.dimensions(),
            Self::Revolved(_) => vec![],
        }
    }
}

/// A dimension that leaves no part.
fn problem(key: &str, quantity: &Quantity, message: String) -> Problem {
    Problem::new(ProblemKind::Geometry, format!("part.{key}"), message, quantity.span.clone())
}

/// A length as it is told.
fn shown(length: f64) -> String {
    Dimension::Length.show(length)
}

/// The points of a profile, one after the other; none twice.
#[derive(Default)]
struct Course(Vec<ChainPoint>);

impl Course {
    /// On to a point, straight.
    fn to(&mut self, z: f64, r: f64) {
        self.bend_to(0.0, z, r);
    }

    /// On to a point, turning by `sweep` on the way.
    fn bend_to(&mut self, sweep: f64, z: f64, r: f64) {
        let at = Vec2::new(z, r);
        if let Some(last) = self.0.last_mut() {
            if last.at == at {
                return;
            }
            last.sweep = sweep;
        }
        self.0.push(ChainPoint::straight(at));
    }
}

/// The closed outline of a body of revolution, counter-clockwise from its lower side: a profile from the axis to the axis and its mirror image.
fn mirrored(profile: &[ChainPoint]) -> Vec<ChainPoint> {
    let mut out = vec![];
    let (Some(last), Some(edges)) = (profile.last(), profile.len().checked_sub(1)) else { return out };
    // A flat end runs straight through the axis, where it has no point.
    let is_flat = |i: usize| profile[i].sweep == 0.0 && profile[i].at.x == profile[i + 1].at.x;
    for (i, p) in profile[..edges].iter().enumerate() {
        if i > 0 || !is_flat(0) {
            out.push(ChainPoint { at: Vec2::new(p.at.x, -p.at.y), sweep: -p.sweep });
        }
    }
    for i in (0..edges).rev() {
        let at = if i + 1 == edges { last.at } else { profile[i + 1].at };
        if i + 1 < edges || !is_flat(i) {
            out.push(ChainPoint { at, sweep: -profile[i].sweep });
        }
    }
    out
}

/// The closed outline of a hollow: what lies between its profile and the axis, and the mirror image of that.
fn closed_to_axis(bore: &[ChainPoint]) -> Vec<ChainPoint> {
    let (Some(first), Some(last)) = (bore.first(), bore.last()) else { return vec![] };
    let mut profile = Course::default();
    profile.to(first.at.x, 0.0);
    if first.at.y > 0.0 {
        profile.to(first.at.x, first.at.y);
    }
    for pair in bore.windows(2) {
        profile.bend_to(pair[0].sweep, pair[1].at.x, pair[1].at.y);
    }
    profile.to(last.at.x, 0.0);
    profile.0
}

/// A body of revolution with this profile and this hollow; neither of both runs back along the axis.
fn revolved(profile: &[ChainPoint], bore: &[ChainPoint], notes: Vec<String>) -> Made {
    let hollow = closed_to_axis(bore);
    // Moments are taken from the profile's own end, so that far from the drawing's zero they keep their digits.
    let zero = profile.first().map_or(0.0, |first| first.at.x);
    let near = |chain: &[ChainPoint]| {
        let moved = |p: &ChainPoint| ChainPoint { at: p.at - Vec2::new(zero, 0.0), ..*p };
        AxialMoments::of_revolution(&chain.iter().map(moved).collect::<Vec<_>>())
    };
    let axial = Some(near(profile).without(near(&hollow)));
    Made { outline: mirrored(profile), hollow: mirrored(&hollow), axial, zero, notes }
}
