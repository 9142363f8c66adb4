//! Outlines of segments and arcs: parts with hollows, bent plates, sheets with rounded edges.

use crate::draw::{between, magnitude, signed};
use arbitrary::{Result, Unstructured};
use carom_feeder::{Form, Part, PartKind};
use carom_motion::planar::{Body, ChainPoint, MassProperties, Shape};
use carom_num::Vec2;
use std::f64::consts::{PI, TAU};

/// Most points of an outline.
const MOST_POINTS: usize = 10;
/// Most bends of a plate or wall.
const MOST_BENDS: u32 = 4;

/// True for one case in four, and never once the bytes have run out: an old input keeps its meaning.
pub(crate) fn sometimes(u: &mut Unstructured<'_>) -> Result<bool> {
    Ok(u.int_in_range(0..=3)? == 3)
}

/// By how much a stretch turns [rad]: mostly not at all.
fn sweep(u: &mut Unstructured<'_>) -> Result<f64> {
    if sometimes(u)? { signed(u, PI, 9) } else { Ok(0.0) }
}

/// What a plate or wall from `from` to `to` looks like, for parts of this size.
pub(crate) fn form(u: &mut Unstructured<'_>, from: Vec2, to: Vec2, size: f64) -> Result<Form> {
    let edge_radius = if sometimes(u)? { size * magnitude(u, 1e-6, 1.0)? } else { 0.0 };
    let mut course = vec![];
    if sometimes(u)? {
        course.push(ChainPoint { at: from, sweep: sweep(u)? });
        let (along, bends) = (to - from, u.int_in_range(0..=MOST_BENDS)?);
        for i in 1..=bends {
            let aside = along.turned_left() * signed(u, 0.5, 9)?;
            let at = from + along * (f64::from(i) / f64::from(bends + 1)) + aside;
            course.push(ChainPoint { at, sweep: sweep(u)? });
        }
        course.push(ChainPoint::straight(to));
    }
    Ok(Form { course, edge_radius })
}

/// A part of any outline: points around a circle at any distance from its middle, arcs between some. `None` where it crosses itself.
pub(crate) fn part(u: &mut Unstructured<'_>, size: f64, mass: f64) -> Result<Option<Part>> {
    let mut angles = vec![];
    for _ in 0..u.int_in_range(3..=MOST_POINTS)? {
        angles.push(between(u, 0.0, TAU)?);
    }
    angles.sort_by(f64::total_cmp);
    let mut points = vec![];
    for angle in angles {
        let at = Vec2::at_angle(angle) * (size * magnitude(u, 0.05, 1.0)?);
        points.push(ChainPoint { at, sweep: sweep(u)? });
    }
    Ok(Shape::of_chain(&points).ok().map(|drawn| uniform(PartKind::Polygon, &drawn, mass)))
}

/// A part of this outline, of one density, about its mass centre.
pub(crate) fn uniform(kind: PartKind, drawn: &Shape, mass: f64) -> Part {
    let moments = MassProperties::of(drawn);
    let inertia = mass * moments.gyration_squared;
    Part { kind, body: Body { shape: drawn.shifted(-moments.centroid), mass, inertia } }
}
