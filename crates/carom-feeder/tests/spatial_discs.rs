//! Discs drawn with many sides go through a feeder as round ones would.

use carom_feeder::Outcome;
use carom_feeder::spatial::{Feeder, Part, Run, examples};
use carom_motion::spatial::Polyhedron;
use carom_num::Vec3;
use carom_num::elementary::sin_cos;
use std::f64::consts::TAU;

const RADIUS: f64 = 0.015;

/// A disc of 10 mm that lies on its face 0, one of its corners foremost.
fn disc(sides: u32) -> Part {
    let corner = |y: f64| {
        move |k: u32| {
            let (sine, cosine) = sin_cos(TAU * f64::from(k) / f64::from(sides));
            Vec3::new(RADIUS * cosine, y, RADIUS * sine)
        }
    };
    let corners: Vec<Vec3> = (0..sides).map(corner(-5e-3)).chain((0..sides).map(corner(5e-3))).collect();
    let hull = Polyhedron::of_points(&corners, 1e-12).unwrap();
    let mut part = Part::of(&hull, &hull.solid().unwrap(), 2700.0).unwrap();
    let lowest = part.faces.iter().position(|face| face.normal.y < -0.5).unwrap();
    part.faces.swap(0, lowest);
    part
}

fn dropped(sides: u32) -> (Feeder, Run) {
    let feeder = Feeder { part: disc(sides), ..examples::two_plates() };
    let run = feeder.run_untraced().unwrap();
    (feeder, run)
}

/// However many corners its face has, it slides to the end of the plate and tips over it, strikes the lower one and comes to lie as any other.
#[test]
fn discs_of_many_sides_end_alike() {
    let faces = [20, 30, 40].map(|sides| {
        let (feeder, run) = dropped(sides);
        assert_eq!(run.outcome, Outcome::Landed, "{sides} sides");
        let face = run.landings.last().and_then(|landing| landing.face).unwrap();
        feeder.part.faces[face].normal.y
    });
    // On a side of its rim, all of them.
    assert!(faces.iter().all(|up| up.abs() < 1e-9), "{faces:?}");
}

/// A polygon misses its circle by a part of the radius that falls as the square of the number of its sides, and so does the time at which it strikes.
#[test]
fn with_more_sides_they_come_nearer_to_a_round_one() {
    let [coarse, middle, fine] = [20, 40, 80].map(|sides| dropped(sides).1.impacts[0].time);
    let ratio = (coarse - middle) / (middle - fine);
    assert!((ratio - 4.0).abs() < 0.4, "{coarse} {middle} {fine}: {ratio}");
}
