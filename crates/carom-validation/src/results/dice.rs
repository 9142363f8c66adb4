//! Cuboids that are thrown: how often they come to rest on their square faces.

use super::rolling::keys;
use crate::failure::ValidationError;
use crate::value::Values;
use carom_scene::{SpatialRollKind, SpatialRollProblem, THROW_DIMENSIONS};
use carom_study::poses::{Plan, Pose};
use carom_study::yields::REPETITIONS;

/// Length of the measured dice by the side of their square faces, in the order of the table.
const LENGTHS: [&str; 15] = [
    "0.47", "0.63", "0.75", "0.81", "0.93", "0.97", "1.16", "1.23", "1.44", "1.55", "1.60", "1.71", "1.87",
    "2.12", "2.65",
];
/// Side of the square faces [mm].
const SIDE: f64 = 12.0;
/// Throws of each die.
const THROWS: u64 = 64;

/// How a hand throws, on what: none of it is published.
const THROW: [(&str, &str); 6] = [
    ("density", "7800 kg/m^3"),
    ("friction", "0.3"),
    ("restitution", "0.3"),
    ("height", "{ low = \"50 mm\", high = \"150 mm\" }"),
    ("speed", "{ low = \"0.2 m/s\", high = \"1 m/s\" }"),
    ("spin_rate", "{ low = \"5 rad/s\", high = \"60 rad/s\" }"),
];

/// Square bars cut off at different lengths.
pub(crate) fn cuboids() -> Result<Values, ValidationError> {
    let mut values = Values::default();
    let mut sum = 0.0;
    for length in LENGTHS {
        let share = on_squares(length)?;
        sum += share;
        values.put(format!("square.{length}"), share);
    }
    values.put("mean", sum / LENGTHS.len() as f64);
    Ok(values)
}

/// The share of throws at rest that lie on one of the two square faces.
fn on_squares(length: &str) -> Result<f64, ValidationError> {
    let what = format!("body of length {length}");
    let ratio: f64 = length.parse().map_err(|e| ValidationError::input(&what, e))?;
    let sides = format!("[\"{SIDE} mm\", \"{SIDE} mm\", \"{} mm\"]", ratio * SIDE);
    let keys = keys(&[&[("box", sides)], &THROW.map(|(key, value)| (key, value.to_owned()))[..]].concat());
    let problem = SpatialRollProblem::parse(SpatialRollKind::Body, &what, "", &keys)
        .map_err(|e| ValidationError::input(&what, e))?;
    let body =
        problem.thrown.as_ref().ok_or_else(|| ValidationError::missing(format!("a throw of the {what}")))?;

    let plan = Plan { dimensions: THROW_DIMENSIONS, throws: THROWS / REPETITIONS as u64, seed: 1 };
    let found = problem.throws(&plan, || ()).map_err(|e| ValidationError::engine(&what, e))?;
    let faces = body.shape.hull.faces();
    let squares = found.ends.iter().filter(|end| match end.pose {
        Pose::Face(face) => faces.get(face).is_some_and(|face| face.normal.z.abs() > 0.5),
        _ => false,
    });
    let on_squares: u64 = squares.map(|end| end.probability.count).sum();
    Ok(on_squares as f64 / found.resting.count as f64)
}
