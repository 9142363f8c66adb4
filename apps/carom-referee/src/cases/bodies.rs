//! Several bodies in the plane that meet: two discs, and rows of balls.

use super::{Draw, engine, named};
use crate::case::Case;
use carom_num::elementary::{cos, sin};
use serde_json::{Value, json};

const DISCS: usize = 30;
const ROWS: usize = 24;

pub(super) fn cases() -> Vec<Case> {
    let discs = (0..DISCS).filter_map(|i| engine::case("two discs", named("two discs", i), discs(i)?));
    let rows = (0..ROWS).filter_map(|i| engine::case("row of balls", named("row of balls", i), row(i)?));
    discs.chain(rows).collect()
}

fn disc(
    name: &str,
    (mass, radius): (f64, f64),
    centre: [f64; 2],
    (velocity, spin): ([f64; 2], f64),
) -> Value {
    let inertia = super::rounded(0.5 * mass * radius * radius, 9);
    json!({ "name": name, "mass": mass, "inertia": inertia, "centre": centre, "velocity": velocity, "spin": spin })
}

/// Two discs that meet at any angle, both turning.
fn discs(number: usize) -> Option<Value> {
    let draw = Draw::new(29, number)?;
    let (a, b) = (draw.between(0.01, 0.1), draw.between(0.01, 0.1));
    let (masses, angle) = ([draw.times(0.05, 5.0), draw.times(0.05, 5.0)], draw.between(-3.1, 3.1));
    let along = [cos(angle), sin(angle)].map(|x| super::rounded(x, 4));
    let at = |r: f64| along.map(|x| super::rounded(r * x, 6));
    // The second is at rest but for its spin, and the first comes against it.
    let (approach, slip) = (draw.between(0.5, 3.0), draw.between(-2.0, 2.0));
    let velocity = [approach * along[0] - slip * along[1], approach * along[1] + slip * along[0]]
        .map(|x| super::rounded(x, 4));
    Some(json!({ "law": "poisson",
        "body": [
            disc("first", (masses[0], a), [0.0, 0.0], (velocity, draw.between(-20.0, 20.0))),
            disc("second", (masses[1], b), at(a + b), ([0.0, 0.0], draw.between(-20.0, 20.0)))],
        "contact": [{ "between": ["second", "first"], "point": at(a), "normal": along,
            "friction": draw.between(0.0, 0.6), "restitution": draw.between(0.0, 1.0) }] }))
}

/// Three to five balls in a row that touch; the first swings in. How they share it is a matter of convention.
fn row(number: usize) -> Option<Value> {
    let draw = Draw::new(31, number)?;
    let (count, radius) = (3 + number % 3, 0.02);
    let restitution = [0.0, 0.5, 0.9, 1.0][number / 3 % 4];
    let speed = draw.between(0.5, 3.0);
    let equal = number < ROWS / 2;
    let mass = |draw: &Draw| if equal { 0.1 } else { draw.times(0.05, 0.5) };
    let body = |i: usize| {
        let velocity = [if i == 0 { speed } else { 0.0 }, 0.0];
        disc(
            &format!("ball {}", i + 1),
            (mass(&draw), radius),
            [0.04 * i as f64, 0.0].map(|x| super::rounded(x, 4)),
            (velocity, 0.0),
        )
    };
    let contact = |i: usize| {
        json!({ "between": [format!("ball {}", i + 2), format!("ball {}", i + 1)],
            "point": [super::rounded(0.04 * i as f64 + radius, 4), 0.0], "normal": [1, 0],
            "friction": 0.0, "restitution": restitution })
    };
    let bodies: Vec<Value> = (0..count).map(body).collect();
    let contacts: Vec<Value> = (0..count - 1).map(contact).collect();
    Some(json!({ "law": "poisson", "body": bodies, "contact": contacts }))
}
