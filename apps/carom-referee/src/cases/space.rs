//! Impacts in space: a body at one contact, on feet, two balls.

use super::{Draw, engine, named};
use crate::case::Case;
use serde_json::{Value, json};

const BODIES: usize = 60;
const FEET: usize = 24;
const BALLS: usize = 24;

pub(super) fn cases() -> Vec<Case> {
    let of = |group: &'static str, file: fn(usize) -> Option<Value>| {
        move |i: usize| engine::case(group, named(group, i), file(i)?)
    };
    let bodies = (0..BODIES).filter_map(of("one contact in space", body));
    let feet = (0..FEET).filter_map(of("on feet in space", feet));
    let balls = (0..BALLS).filter_map(of("two balls in space", balls));
    bodies.chain(feet).chain(balls).collect()
}

/// Three principal moments that a body can have.
fn moments(draw: &Draw, mass: f64) -> [f64; 3] {
    // Squares of the half lengths of a box.
    let [a, b, c] = std::array::from_fn(|_| draw.between(0.01, 0.08)).map(|half: f64| half * half);
    [b + c, a + c, a + b].map(|sum| super::rounded(mass * sum / 3.0, 9))
}

/// A body of any form that strikes a level plane with one point.
fn body(number: usize) -> Option<Value> {
    let draw = Draw::new(37, number)?;
    let mass = draw.times(0.05, 5.0);
    let inertia = moments(&draw, mass);
    let point = [draw.between(-0.06, 0.06), draw.between(-0.06, 0.06), draw.between(-0.08, -0.01)];
    let spin: [f64; 3] = std::array::from_fn(|_| draw.between(-10.0, 10.0));
    // The contact approaches: the mass centre's own part makes up for the spin's.
    let turning = spin[0] * point[1] - spin[1] * point[0];
    let down = super::rounded(draw.between(-2.5, -0.3) - turning, 4);
    let velocity = [draw.between(-2.0, 2.0), draw.between(-2.0, 2.0), down];
    // A third of them without friction: the closed form that every engine knows.
    let friction = if number.is_multiple_of(3) { 0.0 } else { draw.between(0.05, 1.0) };
    Some(json!({ "law": "poisson",
        "body": { "mass": mass, "inertia": inertia, "velocity": velocity, "spin": spin },
        "contact": [{ "point": point, "normal": [0, 0, 1], "friction": friction,
            "restitution": draw.between(0.0, 1.0) }] }))
}

/// A table that comes down on three or four feet, level or nearly so.
fn feet(number: usize) -> Option<Value> {
    let draw = Draw::new(41, number)?;
    let mass = draw.times(0.1, 5.0);
    let inertia = moments(&draw, mass);
    let (height, half) = (draw.between(0.01, 0.05), draw.between(0.03, 0.06));
    let friction = [0.0, 0.3, 0.7][number % 3];
    let restitution = if number.is_multiple_of(2) { 0.0 } else { draw.between(0.1, 0.9) };
    let corners: &[[f64; 2]] = if number % 4 < 2 {
        &[[-1.0, -1.0], [1.0, -1.0], [0.0, 1.0]]
    } else {
        &[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
    };
    let contacts: Vec<Value> = corners
        .iter()
        .map(|[x, y]| {
            let point = [x * half, y * half, -height].map(|x| super::rounded(x, 4));
            json!({ "point": point, "normal": [0, 0, 1], "friction": friction, "restitution": restitution })
        })
        .collect();
    let velocity = [draw.between(-1.0, 1.0), draw.between(-1.0, 1.0), draw.between(-2.0, -0.5)];
    let spin = [draw.between(-2.0, 2.0), draw.between(-2.0, 2.0), draw.between(-5.0, 5.0)];
    Some(json!({ "law": "poisson",
        "body": { "mass": mass, "inertia": inertia, "velocity": velocity, "spin": spin },
        "contact": contacts }))
}

/// Two balls that meet, both turning about any axis.
fn balls(number: usize) -> Option<Value> {
    let draw = Draw::new(43, number)?;
    let ball = |name: &str, radius: f64, x: f64, velocity: [f64; 3]| {
        let mass = draw.times(0.05, 2.0);
        let inertia = [super::rounded(0.4 * mass * radius * radius, 9); 3];
        let spin: [f64; 3] = std::array::from_fn(|_| draw.between(-20.0, 20.0));
        json!({ "name": name, "mass": mass, "inertia": inertia, "centre": [x, 0.0, 0.0], "velocity": velocity,
            "spin": spin })
    };
    let (a, b) = (draw.between(0.01, 0.05), draw.between(0.01, 0.05));
    let velocity = [draw.between(0.5, 3.0), draw.between(-1.5, 1.5), draw.between(-1.5, 1.5)];
    let first = ball("first", a, 0.0, velocity);
    let second = ball("second", b, super::rounded(a + b, 4), [0.0; 3]);
    Some(json!({ "law": "poisson", "body": [first, second],
        "contact": [{ "between": ["second", "first"], "point": [a, 0.0, 0.0], "normal": [1, 0, 0],
            "friction": draw.between(0.0, 0.6), "restitution": draw.between(0.0, 1.0) }] }))
}
