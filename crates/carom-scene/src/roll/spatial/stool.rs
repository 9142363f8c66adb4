//! A body on n supports, evenly on a circle, that is let go standing on one of them.

use super::homogeneous;
use super::setup::{MassSpec, Setup, SpatialDrawing, count, triple};
use crate::grammar::Section;
use crate::roll::bodies::unfit;
use carom_motion::spatial::State;
use carom_num::elementary::sin_cos;
use carom_num::{Rotation, Vec3};
use std::f64::consts::{SQRT_2, TAU};

/// Height of the solid by the circle's radius where nothing is written: on four supports a cube.
const DEFAULT_RATIO: f64 = SQRT_2;
/// Towards the neighbours of support 0, beside the symmetric fall: with it a cube would stop at once.
const DEFAULT_AXIS: Vec3 = Vec3::new(0.25, 1.0, 0.0);
/// Seat of a stool whose shape is not given: its radius and thickness by the circle's radius.
const SEAT: f64 = 0.8;
const THICKNESS: f64 = 0.14;

pub(super) fn read(root: &Section<'_>) -> Option<Setup> {
    let mass = MassSpec::read(root);
    let tilt = root.number("tilt");
    let axis = triple(root, "axis").unwrap_or(DEFAULT_AXIS);
    let spin = triple(root, "spin").unwrap_or(Vec3::ZERO);
    let about = axis.unit();
    if about.is_none() {
        unfit(root, "axis", "must have a direction: not all of its components can be 0");
    }
    let form = form(root)?;
    let Form { supports, radius, centre, height } = form;
    let solid = homogeneous::prism(mass.mass, supports, radius, height);
    let places = ring(supports, radius, -centre);
    let body = mass.body(root, solid, places.clone(), "circle_radius")?;
    let start = State::standing(&body, 0, Rotation::by(about? * tilt), spin);
    Some(Setup {
        body,
        points: (0..supports).map(|j| j.to_string()).collect(),
        drawing: if mass.is_open() && !root.has("centre_height") {
            prism(&places, height)
        } else {
            legs(&form, places)
        },
        faces: vec![Vec3::Z],
        pyramid: None,
        thrown: None,
        start,
    })
}

/// Where supports and mass centre are.
struct Form {
    supports: u32,
    radius: f64,
    /// Of the mass centre above the supports.
    centre: f64,
    /// Of the solid prism whose moments it has where none are written.
    height: f64,
}

fn form(root: &Section<'_>) -> Option<Form> {
    let supports = count(root, "supports");
    let radius = root.number("circle_radius");
    let centre = root.value("centre_height");
    let height = root.value("height").or(centre.map(|c| 2.0 * c)).unwrap_or(DEFAULT_RATIO * radius);
    let supports = supports?;
    Some(Form { supports, radius, centre: 0.5 * height, height })
}

/// Points evenly on a circle, the first on x.
fn ring(count: u32, radius: f64, z: f64) -> Vec<Vec3> {
    let point = |j: u32| {
        let (sin, cos) = sin_cos(TAU * f64::from(j) / f64::from(count));
        Vec3::new(radius * cos, radius * sin, z)
    };
    (0..count).map(point).collect()
}

/// The solid on its supports.
fn prism(places: &[Vec3], height: f64) -> SpatialDrawing {
    let top = places.iter().map(|r| *r + Vec3::Z * height);
    let corners: Vec<Vec3> = places.iter().copied().chain(top).collect();
    SpatialDrawing { corners, faces: between(0, places.len(), places.len()), lines: vec![] }
}

/// The faces of a prism whose lower ring of n corners starts at `low`, the upper one at `high`.
fn between(low: usize, high: usize, n: usize) -> Vec<Vec<usize>> {
    let side = |j: usize| vec![low + j, low + (j + 1) % n, high + (j + 1) % n, high + j];
    let mut faces: Vec<Vec<usize>> = (0..n).map(side).collect();
    faces.push((low..low + n).rev().collect());
    faces.push((high..high + n).collect());
    faces
}

/// A seat about the mass centre, on legs.
fn legs(form: &Form, places: Vec<Vec3>) -> SpatialDrawing {
    let n = places.len();
    let half = 0.5 * THICKNESS * form.radius;
    let mut corners = places;
    corners.extend(ring(form.supports, SEAT * form.radius, -half.min(0.5 * form.centre)));
    corners.extend(ring(form.supports, SEAT * form.radius, half));
    SpatialDrawing { corners, faces: between(n, 2 * n, n), lines: (0..n).map(|j| [j, n + j]).collect() }
}
