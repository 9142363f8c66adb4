//! A cylinder on level ground at A that strikes a step's corner or a second surface at K.

use super::bodies::{MassSpec, Setup, unfit};
use crate::grammar::Section;
use carom_motion::planar::{Body, Pose, Shape, State, Twist};
use carom_num::{Vec2, elementary::sin_cos};

/// b of a solid cylinder.
const SOLID: f64 = 0.5;
/// Length of ground and of the second surface, in radii.
const LONG: f64 = 60.0;

pub(super) fn read(root: &Section<'_>) -> Option<Setup> {
    let radius = root.number("radius");
    let mass = MassSpec::read(root);
    let (gamma, step) = (root.number("gamma"), root.value("step_height"));
    let roll_rate = root.number("roll_rate");
    let forward = root.value("speed").unwrap_or(roll_rate * radius);
    if forward <= 0.0 {
        let key = if root.has("speed") { "speed" } else { "roll_rate" };
        unfit(root, key, "must be above 0: the cylinder moves forward, to what it strikes");
    }
    if gamma <= 0.0 {
        unfit(root, "gamma", "must be above 0: with 0 the second surface is the ground");
    }
    if step.is_some_and(|step| step >= radius) {
        unfit(
            root,
            "step_height",
            "must be less than the radius: a higher step is a wall, gamma = \"45 deg\"",
        );
    }
    let distance = root.number("distance");
    if distance > 0.5 * LONG * radius {
        unfit(root, "distance", format!("must be at most {} radii", 0.5 * LONG));
    }
    // The angle has a default, so a step decides wherever one is written.
    let segments = match step {
        Some(step) => beside_step(radius, step),
        None => beside_surface(radius, gamma),
    };
    let shape = Shape::new(vec![Vec2::ZERO], radius).ok()?;
    let inertia = mass.inertia(radius, SOLID * radius * radius);
    Some(Setup {
        body: Body { shape, mass: mass.mass, inertia },
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
