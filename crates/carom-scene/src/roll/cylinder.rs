//! A cylinder on level ground at A that strikes a step's corner or a second surface at K.

use super::bodies::{ANGLE, ANY_SPEED, Heft, ROLL_RATE, Setup, exclusive, unfit};
use crate::drawing::{LENGTH, LENGTH_OR_NONE};
use crate::section::Section;
use carom_motion::planar::{Body, Pose, Shape, State, Twist};
use carom_num::{Vec2, elementary::sin_cos};
use std::f64::consts::PI;

/// A hoop of a hand's width that rolls at a walking pace against a kerb.
const DEFAULT_RADIUS: f64 = 0.1;
const DEFAULT_ROLL_RATE: f64 = 10.0;
/// b of a solid cylinder.
const SOLID: f64 = 0.5;
/// Half the central angle where neither it nor a step is written.
const DEFAULT_GAMMA: f64 = PI / 6.0;
/// Length of ground and of the second surface, in radii.
const LONG: f64 = 60.0;

pub(super) fn read(root: &Section<'_>) -> Option<Setup> {
    let radius = root.quantity("radius", LENGTH).map_or(DEFAULT_RADIUS, |r| r.value);
    let heft = Heft::read(root);
    let gamma = root.quantity("gamma", ANGLE);
    let step = root.quantity("step_height", LENGTH);
    exclusive(root, "gamma", &["step_height"]);
    let roll_rate = root.quantity("roll_rate", ROLL_RATE).map_or(DEFAULT_ROLL_RATE, |w| w.value);
    let speed = root.quantity("speed", ANY_SPEED).map(|v| v.value);
    let forward = speed.unwrap_or(roll_rate * radius);
    if forward <= 0.0 {
        let key = if root.has("speed") { "speed" } else { "roll_rate" };
        unfit(root, key, "must be above 0: the cylinder moves forward, to what it strikes");
    }
    if gamma.as_ref().is_some_and(|gamma| gamma.value <= 0.0) {
        unfit(root, "gamma", "must be above 0: with 0 the second surface is the ground");
    }
    if step.as_ref().is_some_and(|step| step.value >= radius) {
        unfit(
            root,
            "step_height",
            "must be less than the radius: a higher step is a wall, gamma = \"45 deg\"",
        );
    }
    let distance = root.quantity("distance", LENGTH_OR_NONE).map_or(0.0, |d| d.value);
    if distance > 0.5 * LONG * radius {
        unfit(root, "distance", format!("must be at most {} radii", 0.5 * LONG));
    }
    let segments = match step {
        Some(step) => beside_step(radius, step.value),
        None => beside_surface(radius, gamma.map_or(DEFAULT_GAMMA, |gamma| gamma.value)),
    };
    let shape = Shape::new(vec![Vec2::ZERO], radius).ok()?;
    let inertia = heft.inertia(radius, SOLID * radius * radius);
    Some(Setup {
        body: Body { shape, mass: heft.mass, inertia },
        unreached: riser(&segments),
        segments,
        start: State {
            pose: Pose { centre: Vec2::new(-distance, radius), angle: 0.0 },
            twist: Twist { velocity: Vec2::new(forward, 0.0), spin: -roll_rate },
        },
    })
}

/// Ground up to the step, and the step's tread: the cylinder never reaches the riser below its corner.
fn beside_step(radius: f64, height: f64) -> Vec<(String, [Vec2; 2])> {
    let below = radius - height;
    let corner = Vec2::new((radius * radius - below * below).sqrt(), height);
    vec![
        ("A".to_owned(), [Vec2::new(-LONG * radius, 0.0), Vec2::new(corner.x, 0.0)]),
        ("K".to_owned(), [corner, corner + Vec2::new(LONG * radius, 0.0)]),
    ]
}

/// From the end of the ground up to the step's corner.
fn riser(segments: &[(String, [Vec2; 2])]) -> Vec<[Vec2; 2]> {
    let joint = |pair: &[(String, [Vec2; 2])]| [pair[0].1[1], pair[1].1[0]];
    segments.windows(2).map(joint).filter(|[low, high]| low.x == high.x).collect()
}

/// Ground, and a plane that is tangent to the cylinder at the central angle 2γ from A: they meet a tan γ ahead of A.
fn beside_surface(radius: f64, gamma: f64) -> Vec<(String, [Vec2; 2])> {
    let (s, c) = sin_cos(gamma);
    let along = Vec2::at_angle(2.0 * gamma);
    let joint = Vec2::new(radius * s / c, 0.0);
    // The point of contact is set out from K itself: the joint may be far.
    let touch = Vec2::new(0.0, radius) + along.turned_right() * radius;
    vec![
        ("A".to_owned(), [Vec2::new(-LONG * radius, 0.0), joint]),
        ("K".to_owned(), [touch - along * (radius * s / c), touch + along * (LONG * radius)]),
    ]
}
