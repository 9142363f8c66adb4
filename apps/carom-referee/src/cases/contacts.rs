//! One body in the plane that is touched at several contacts at once.

use super::{Draw, engine, named};
use crate::case::Case;
use serde_json::{Value, json};

/// Bodies on two contacts, without and with restitution.
const PAIRS: usize = 40;
/// Bodies between two faces that meet at an angle.
const WEDGES: usize = 40;
/// Bodies between two faces whose law allows several answers, and among how many they are looked for.
const SEVERAL: usize = 24;
const LOOKED_AT: usize = 2000;
/// Bodies on three or four contacts.
const MORE: usize = 20;

pub(super) fn cases() -> Vec<Case> {
    let pairs = (0..PAIRS).filter_map(|i| engine::case("two contacts", named("two contacts", i), pair(i)?));
    let wedges = (0..WEDGES).filter_map(|i| engine::case("wedge", named("wedge", i), wedge(i)?));
    let several = (WEDGES..LOOKED_AT)
        .filter_map(|i| engine::case("several answers", String::new(), wedge(i)?))
        .filter(|case| case.expected.answers.len() > 1);
    let several = several.take(SEVERAL).enumerate();
    let several = several.map(|(i, case)| Case { case: named("several answers", i), ..case });
    let more = (0..MORE).filter_map(|i| {
        let group = "three or four contacts";
        engine::case(group, named(group, i), many(i)?)
    });
    pairs.chain(wedges).chain(several).chain(more).collect()
}

/// A box that comes down on both lower corners.
fn pair(number: usize) -> Option<Value> {
    let draw = Draw::new(17, number)?;
    let (mass, half, height) = (draw.times(0.1, 5.0), draw.between(0.02, 0.1), draw.between(0.005, 0.08));
    let inertia = super::rounded(mass * (half * half + height * height) / 3.0, 9);
    let restitution = if number.is_multiple_of(2) { 0.0 } else { draw.between(0.1, 0.9) };
    let friction = draw.between(0.0, 0.8);
    // Both corners come down: the spin is too small to lift one of them.
    let (down, along) = (draw.between(-2.0, -0.3), draw.between(-2.0, 2.0));
    let spin = super::rounded(draw.between(-0.9, 0.9) * down / half, 4);
    let contact = |x: f64| json!({ "point": [x, -height], "normal": [0, 1], "friction": friction, "restitution": restitution });
    Some(json!({ "law": "poisson",
        "body": { "mass": mass, "inertia": inertia, "velocity": [along, down], "spin": spin },
        "contact": [contact(-half), contact(half)] }))
}

/// A body between two faces that meet at an angle, touched at any two points.
fn wedge(number: usize) -> Option<Value> {
    let draw = Draw::new(19, number)?;
    let (mass, gyration) = (draw.times(0.1, 5.0), draw.between(0.02, 0.1));
    let inertia = super::rounded(mass * gyration * gyration, 9);
    let contact = |side: f64| {
        let lean = draw.between(0.2, 1.4) * side;
        let normal = [-carom_num::elementary::sin(lean), carom_num::elementary::cos(lean)]
            .map(|x| super::rounded(x, 4));
        let point =
            [draw.between(0.01, 0.08) * side, draw.between(-0.08, 0.02)].map(|x| super::rounded(x, 4));
        json!({ "point": point, "normal": normal, "friction": draw.between(0.1, 1.2), "restitution": 0.0 })
    };
    let contacts = [contact(-1.0), contact(1.0)];
    let velocity = [draw.between(-0.8, 0.8), draw.between(-2.0, -0.5)];
    Some(json!({ "law": "poisson",
        "body": { "mass": mass, "inertia": inertia, "velocity": velocity, "spin": draw.between(-15.0, 15.0) },
        "contact": contacts }))
}

/// A plate that comes down flat on three or four feet, or in a corner.
fn many(number: usize) -> Option<Value> {
    let draw = Draw::new(47, number)?;
    let (mass, height) = (draw.times(0.1, 5.0), draw.between(0.01, 0.06));
    let inertia = super::rounded(mass * draw.between(0.0004, 0.004), 9);
    let restitution = if number.is_multiple_of(2) { 0.0 } else { draw.between(0.1, 0.8) };
    let friction = draw.between(0.0, 0.6);
    let foot = |x: f64| json!({ "point": [x, -height], "normal": [0, 1], "friction": friction, "restitution": restitution });
    let mut contacts: Vec<Value> = [-0.08, draw.between(-0.05, 0.05), 0.08].into_iter().map(foot).collect();
    if number.is_multiple_of(3) {
        // Its left end meets a wall as well.
        let point = [-0.09, draw.between(-0.01, 0.01)];
        contacts.push(
            json!({ "point": point, "normal": [1, 0], "friction": friction, "restitution": restitution }),
        );
    }
    let velocity = [draw.between(-1.5, -0.1), draw.between(-2.0, -0.5)];
    Some(json!({ "law": "poisson",
        "body": { "mass": mass, "inertia": inertia, "velocity": velocity, "spin": draw.between(-1.0, 1.0) },
        "contact": contacts }))
}
