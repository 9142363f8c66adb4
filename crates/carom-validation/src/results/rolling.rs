//! Strikes of bodies that roll, asked as a roll file asks for them.

use crate::failure::ValidationError;
use carom_scene::{RollKind, RollProblem, RollReport, RollStrikeReport};
use carom_words::Words;

/// A body that rolls, by its keys (`key=value`, with units), followed to its end.
pub(crate) fn follow(kind: RollKind, keys: &[String]) -> Result<RollReport, ValidationError> {
    let what = format!("{} {}", kind.word(), keys.join(" "));
    let problem = RollProblem::parse(kind, &what, "", keys).map_err(|e| ValidationError::input(&what, e))?;
    let run = problem.follow().map_err(|e| ValidationError::engine(&what, e))?;
    Ok(RollReport::new(&problem, &run))
}

/// Its first strike.
pub(crate) fn first_strike(kind: RollKind, keys: &[String]) -> Result<RollStrikeReport, ValidationError> {
    let report = follow(kind, keys)?;
    report.strikes.into_iter().next().ok_or_else(|| {
        ValidationError::missing(format!("a strike of the {} {}", kind.word(), keys.join(" ")))
    })
}

/// Keys as they are written on the command line.
pub(crate) fn keys(pairs: &[(&str, String)]) -> Vec<String> {
    pairs.iter().map(|(key, value)| format!("{key}={value}")).collect()
}

/// Halvings of the interval of a border: more than a double has digits between the ends.
const HALVINGS: u32 = 60;

/// Where a property that holds at the low end stops to hold.
pub(crate) fn border(
    [mut low, mut high]: [f64; 2],
    mut holds: impl FnMut(f64) -> Result<bool, ValidationError>,
) -> Result<f64, ValidationError> {
    if !holds(low)? || holds(high)? {
        return Err(ValidationError::missing(format!("a change between {low} and {high}")));
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if holds(middle)? {
            low = middle;
        } else {
            high = middle;
        }
    }
    Ok(0.5 * (low + high))
}
