//! Feeders of any part among plates and walls: every run ends by name, its numbers are finite, and no energy appears.

use crate::chains::{self, sometimes};
use crate::contacts::law;
use crate::draw::{between, coefficient, magnitude, signed};
use crate::texts::{SHORT, check_numbers};
use arbitrary::{Result, Unstructured};
use carom_feeder::{Feeder, Form, Part, PartKind, Plate, Run, Start, Stop, Wall};
use carom_impact::Law;
use carom_motion::planar::{Shape, World};
use carom_num::Vec2;

/// Growth of energy over a piece, in units of what can be lost: the tolerance of [`SHORT`] over its steps.
const GROWTH: f64 = 1e-6;
/// Most corners of a polygon.
const MOST_CORNERS: usize = 8;

/// A feeder drawn from bytes, run and judged.
pub fn planar(bytes: &[u8]) {
    let Ok(Some(feeder)) = feeder(&mut Unstructured::new(bytes)) else { return };
    let Ok(prepared) = feeder.prepare(SHORT) else { return };
    // A fault of the numbers is an answer by name: tests of the feeder count how rare it is.
    let Ok(run) = prepared.run() else { return };
    check_numbers(&run, "");
    check_order(&feeder, &run);
    if feeder.law != Law::Newton {
        check_energy(&feeder, prepared.world(), &run);
    }
}

/// Time does not run back.
fn check_order(feeder: &Feeder, run: &Run) {
    let mut now = 0.0;
    for piece in &run.trace.pieces {
        let goes_on = now <= piece.start_time && piece.start_time <= piece.end_time;
        let samples = piece.samples.iter().map(|sample| sample.time);
        assert!(goes_on && samples.is_sorted(), "time runs back after {now} s: {feeder:?}");
        now = piece.end_time;
    }
}

fn check_energy(feeder: &Feeder, world: &World, run: &Run) {
    let weight = feeder.part.body.mass * feeder.gravity;
    let size = feeder.part.body.shape.size();
    for piece in &run.trace.pieces {
        let (before, after) = (world.energy(&[piece.start]), world.energy(&[piece.end]));
        let lowest = piece.start.pose.centre.y.min(piece.end.pose.centre.y);
        let at_stake = (before - weight * lowest).abs().max(weight * size);
        let growth = (after - before) / at_stake;
        assert!(growth <= GROWTH, "energy grows by {growth:e} from {} s: {feeder:?}", piece.start_time);
    }
    for impact in &run.trace.impacts {
        let at_stake = impact.energy_before.max(weight * size);
        let growth = (impact.energy_after - impact.energy_before) / at_stake;
        assert!(growth <= GROWTH, "an impact at {} s gains {growth:e}: {feeder:?}", impact.time);
    }
}

fn feeder(u: &mut Unstructured<'_>) -> Result<Option<Feeder>> {
    let Some(mut part) = part(u)? else { return Ok(None) };
    let size = part.body.shape.size();
    let gravity = if u.ratio(3, 4)? { 9.81 } else { magnitude(u, 1e-3, 1e5)? };
    let count = u.int_in_range(1..=5)?;
    let (mut plates, mut edge, mut right) = (vec![], Vec2::ZERO, true);
    for i in 0..count {
        let slope = signed(u, 1.5, 9)?.abs();
        let down = Vec2::at_angle(if right { -slope } else { std::f64::consts::PI + slope });
        let length = size * magnitude(u, 0.01, 100.0)?;
        if i > 0 {
            edge += Vec2::new(signed(u, 10.0 * size, 6)?, -size * magnitude(u, 1e-6, 100.0)?);
        }
        let (uphill, name) = (edge - down * length, format!("p{i}"));
        let (friction, restitution) = (coefficient(u, 3.0)?, coefficient(u, 1.0)?);
        plates.push(Plate {
            name,
            uphill,
            edge,
            friction,
            restitution,
            unbounded: false,
            form: Form::default(),
        });
        right ^= u.ratio(7, 8)?;
    }
    let mut walls = vec![];
    for i in 0..u.int_in_range(0..=2)? {
        let at = |u: &mut Unstructured<'_>| -> Result<Vec2> {
            Ok(Vec2::new(signed(u, 30.0 * size, 6)?, signed(u, 60.0 * size, 6)?))
        };
        let (from, to, name) = (at(u)?, at(u)?, format!("w{i}"));
        walls.push(Wall {
            name,
            from,
            to,
            friction: coefficient(u, 3.0)?,
            restitution: coefficient(u, 1.0)?,
            form: Form::default(),
        });
    }
    let length = (plates[0].edge - plates[0].uphill).norm();
    let fall = (gravity * size).sqrt();
    let mut start = Start {
        to_edge: length * between(u, 0.0, 1.0)?,
        speed: signed(u, 10.0 * fall, 9)?,
        face: usize::from(u.arbitrary::<u8>()?) % part.body.shape.faces().max(1),
    };
    let stop = if u.arbitrary()? { Stop::Landed } else { Stop::Delivered };
    let law = law(u)?;
    // What is not straight, thin and convex comes last, so that inputs from before mean what they did.
    forms(u, size, &mut plates, &mut walls)?;
    if sometimes(u)? {
        let Some(other) = chains::part(u, size, part.body.mass)? else { return Ok(None) };
        part = other;
        start.face %= part.body.shape.faces().max(1);
    }
    Ok(Some(Feeder { gravity, stop, law, part, start, plates, walls }))
}

fn forms(u: &mut Unstructured<'_>, size: f64, plates: &mut [Plate], walls: &mut [Wall]) -> Result<()> {
    for plate in plates {
        plate.form = chains::form(u, plate.uphill, plate.edge, size)?;
    }
    for wall in walls {
        wall.form = chains::form(u, wall.from, wall.to, size)?;
    }
    Ok(())
}

fn part(u: &mut Unstructured<'_>) -> Result<Option<Part>> {
    let size = magnitude(u, 1e-4, 10.0)?;
    let mass = magnitude(u, 1e-6, 1e4)?;
    let radius = if u.ratio(1, 3)? { size * magnitude(u, 1e-6, 1.0)? } else { 0.0 };
    let (kind, vertices, radius) = match u.int_in_range(0..=3)? {
        0 => (PartKind::Rod, vec![Vec2::new(-size, 0.0), Vec2::new(size, 0.0)], radius),
        1 => (PartKind::Disc, vec![Vec2::ZERO], size),
        2 => {
            let h = size * magnitude(u, 1e-5, 1.0)?;
            (
                PartKind::Box,
                [(-size, -h), (size, -h), (size, h), (-size, h)].map(|(x, y)| Vec2::new(x, y)).into(),
                radius,
            )
        }
        _ => (PartKind::Polygon, polygon(u, size)?, radius),
    };
    Ok(Shape::new(vertices, radius).ok().map(|drawn| chains::uniform(kind, &drawn, mass)))
}

/// Points on a stretched circle, by angle.
fn polygon(u: &mut Unstructured<'_>, size: f64) -> Result<Vec<Vec2>> {
    let stretch = magnitude(u, 1e-4, 1.0)?;
    let mut angles = vec![];
    for _ in 0..u.int_in_range(3..=MOST_CORNERS)? {
        angles.push(between(u, 0.0, std::f64::consts::TAU)?);
    }
    angles.sort_by(f64::total_cmp);
    Ok(angles.into_iter().map(Vec2::at_angle).map(|p| Vec2::new(p.x * size, p.y * size * stretch)).collect())
}
