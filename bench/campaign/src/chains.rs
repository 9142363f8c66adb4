//! Outlines of segments and arcs: parts with hollows, bent plates, sheets with rounded edges.

use crate::draw;
use carom_feeder::{Feeder, Form, Part, PartKind};
use carom_motion::planar::{Body, ChainPoint, MassProperties, Shape};
use carom_num::Vec2;
use rand::RngExt;
use rand_pcg::Pcg64;
use std::f64::consts::TAU;

/// How often an outline is drawn again because it crossed itself.
const TRIES: usize = 20;

/// The feeder with a part of any outline, bent plates and rounded edges. `None` where no outline was found.
pub(crate) fn bent(rng: &mut Pcg64, mut feeder: Feeder) -> Option<Feeder> {
    let size = feeder.part.body.shape.size();
    if rng.random_bool(0.7) {
        let mass = feeder.part.body.mass;
        feeder.part = (0..TRIES).find_map(|_| part(rng, size, mass))?;
        feeder.start.face = rng.random_range(0..feeder.part.body.shape.faces().max(1));
    }
    for plate in &mut feeder.plates {
        plate.form = form(rng, plate.uphill, plate.edge, size);
    }
    for wall in &mut feeder.walls {
        wall.form = form(rng, wall.from, wall.to, size);
    }
    Some(feeder)
}

/// By how much a stretch turns [rad]: half of them are straight.
fn sweep(rng: &mut Pcg64) -> f64 {
    if rng.random_bool(0.5) { draw::between(rng, -2.0, 2.0) } else { 0.0 }
}

fn part(rng: &mut Pcg64, size: f64, mass: f64) -> Option<Part> {
    let count = rng.random_range(3..9);
    let mut angles: Vec<f64> = (0..count).map(|_| draw::between(rng, 0.0, TAU)).collect();
    angles.sort_by(f64::total_cmp);
    let point = |angle| ChainPoint {
        at: Vec2::at_angle(angle) * (size * draw::between(rng, 0.2, 1.0)),
        sweep: sweep(rng),
    };
    let drawn = Shape::of_chain(&angles.into_iter().map(point).collect::<Vec<_>>()).ok()?;
    let moments = MassProperties::of(&drawn);
    let inertia = mass * moments.gyration_squared;
    let body = Body { shape: drawn.shifted(-moments.centroid), mass, inertia };
    Some(Part { kind: PartKind::Polygon, body })
}

/// Straight and sharp, bent, rounded, or bent with smooth joints and rounded (an arc between the ends).
fn form(rng: &mut Pcg64, from: Vec2, to: Vec2, size: f64) -> Form {
    let edge_radius = size * draw::across(rng, 1e-5, 0.3);
    let arc = |sweep| vec![ChainPoint { at: from, sweep }, ChainPoint::straight(to)];
    let kink = from + (to - from) * draw::between(rng, 0.2, 0.8);
    let kink = kink + (to - from).turned_left() * draw::between(rng, -0.3, 0.3);
    match rng.random_range(0..5) {
        0 => Form { course: vec![], edge_radius },
        1 => Form { course: arc(draw::between(rng, -1.5, 1.5)), edge_radius },
        2 => Form { course: arc(draw::between(rng, -1.5, 1.5)), edge_radius: 0.0 },
        3 => {
            let course = [(from, sweep(rng)), (kink, sweep(rng)), (to, 0.0)];
            Form { course: course.map(|(at, sweep)| ChainPoint { at, sweep }).into(), edge_radius: 0.0 }
        }
        _ => Form::default(),
    }
}
