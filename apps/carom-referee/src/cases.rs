//! The cases: the same ones each time.

mod bodies;
mod contacts;
mod drops;
mod engine;
mod one_contact;
mod space;

use crate::case::Case;
use carom_num::sobol::Sobol;

/// Every case, in groups: single impacts in the plane under three laws, balls, several contacts, several bodies, impacts in space, drops.
///
/// Numbers come from a fixed sequence and are written with four places, so that the files are the same on every machine. Expected answers
/// come from the closed forms of `carom-theory` where there are some, else from the engine, and each case says which.
///
/// # Example
/// ```
/// let cases = carom_referee::cases();
/// assert!(cases.len() >= 500);
/// assert!(cases.iter().any(|case| case.expected.answers.len() > 1), "some have several answers");
/// ```
pub fn cases() -> Vec<Case> {
    let mut all = one_contact::cases();
    all.extend(contacts::cases());
    all.extend(bodies::cases());
    all.extend(space::cases());
    all.extend(drops::cases());
    all
}

/// The cases of the group of this name, or where there is none, those whose group has it in its name.
///
/// # Example
/// ```
/// use carom_referee::{cases, of_group};
/// assert!(of_group(cases(), Some("ball")).iter().all(|case| case.group == "ball"));
/// assert!(of_group(cases(), Some("balls")).iter().any(|case| case.group == "row of balls"));
/// ```
pub fn of_group(cases: Vec<Case>, group: Option<&str>) -> Vec<Case> {
    let Some(asked) = group else { return cases };
    let exact = cases.iter().any(|case| case.group == asked);
    let is = |case: &Case| if exact { case.group == asked } else { case.group.contains(asked) };
    cases.into_iter().filter(is).collect()
}

/// Numbers of one group of cases.
struct Draw {
    points: Sobol,
    number: u64,
    next: std::cell::Cell<usize>,
}

/// How many numbers a case may draw.
const DRAWN: usize = 24;

impl Draw {
    /// Of one case of a group; the group's `seed` keeps it apart from the others.
    fn new(seed: u64, number: usize) -> Option<Self> {
        let points = Sobol::new(DRAWN, seed)?;
        Some(Self { points, number: number as u64, next: std::cell::Cell::new(0) })
    }

    /// The next number between two others, with four places.
    fn between(&self, low: f64, high: f64) -> f64 {
        let drawn = self.points.at(self.number, self.next.replace(self.next.get() + 1));
        rounded(low + (high - low) * drawn, 4)
    }

    /// The next number between two others that are far apart: so many times the lower one, three digits.
    fn times(&self, low: f64, high: f64) -> f64 {
        let drawn = self.points.at(self.number, self.next.replace(self.next.get() + 1));
        let value = low * carom_num::elementary::exp(drawn * carom_num::elementary::ln(high / low));
        // The digits that a number of this size has before its first one.
        let places = (2.0 - carom_num::elementary::ln(value) / std::f64::consts::LN_10).ceil();
        rounded(value, places as i32)
    }
}

/// A number as it is written with so many places.
fn rounded(value: f64, places: i32) -> f64 {
    let places = usize::try_from(places).unwrap_or_default();
    // What is written is what is read.
    format!("{value:.places$}").parse().unwrap_or(value)
}

/// The name of a case.
fn named(group: &str, number: usize) -> String {
    format!("{}/{:03}", group.replace([' ', ','], "-").replace("--", "-"), number + 1)
}
