//! What a case is.

use crate::tolerance::AGREES;
use carom_scene::{Problem, ProblemKind, Problems};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::BTreeSet;

/// A question whose answer is known: one line of a case file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "carom cases: one line")]
pub struct Case {
    /// Its name, which answers repeat: `one-contact-poisson/017`.
    pub case: String,
    /// What kind of case it is: answers are counted by it.
    pub group: String,
    /// What is asked: an impact, as `carom impact` reads it, with plain SI numbers.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub impact: Option<Value>,
    /// What is asked: a drop, as `carom run` reads its scene.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scene: Option<Value>,
    /// The scene laid out in the plane for engines that read no scenes; absent for an impact.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub world: Option<World>,
    /// What is known of the answer.
    pub expected: Expected,
    /// How far an answer may be off, as the share of the kinetic energy's root that the difference of the motions has.
    #[serde(default = "agrees")]
    pub tolerance: f64,
    /// Where the answer comes from.
    pub source: String,
}

fn agrees() -> f64 {
    AGREES
}

/// What is known of an answer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Expected {
    /// Every answer that the law of the case allows: one, or several where the law alone does not decide.
    pub answers: Vec<Known>,
    /// What other laws of restitution, or other conventions on how contacts share an impact, say: not wrong, but not what was asked.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub others: Vec<Known>,
}

/// One answer, and who gives it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Known {
    /// The law, the convention or the hypothesis that gives it, in words.
    pub by: String,
    /// The bodies after the impact, in the order of the file; empty for a drop.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub bodies: Vec<Body>,
    /// How the part of a drop comes to lie: `same` or `turned`; absent for an impact.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub verdict: Option<String>,
}

/// A body after an impact, in the axes of the file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Body {
    /// Velocity of its mass centre [m/s]: two numbers in the plane, three in space.
    pub velocity_m_s: Vec<f64>,
    /// Its spin [rad/s]: a number in the plane, three in space.
    pub spin_rad_s: Spin,
}

/// A spin [rad/s].
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Spin {
    /// In the plane, counter-clockwise.
    Plane(f64),
    /// In space, about the file's axes.
    Space([f64; 3]),
}

/// A scene laid out: x to the right, y up, angles counter-clockwise.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct World {
    /// Gravity, downwards [m/s²].
    pub gravity_m_s2: f64,
    /// The part at the start.
    pub part: PartOfDrop,
    /// The plates, in the order in which the part meets them; the part starts on the first one.
    pub plates: Vec<PlateOfDrop>,
}

/// The part of a drop.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PartOfDrop {
    /// Its corners about its mass centre, counter-clockwise [m], before it is turned.
    pub corners_m: Vec<[f64; 2]>,
    /// Mass [kg].
    pub mass_kg: f64,
    /// Moment of inertia about the mass centre [kg m²].
    pub inertia_kg_m2: f64,
    /// Where it starts, at rest.
    pub start: Place,
}

/// A place of a body.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Place {
    /// Its mass centre [m].
    pub position_m: [f64; 2],
    /// Its angle [rad].
    pub angle_rad: f64,
}

/// A plate of a drop: a straight line.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlateOfDrop {
    /// Its name.
    pub name: String,
    /// Its upper end, or far up where it has none [m].
    pub uphill_m: [f64; 2],
    /// Its free edge [m].
    pub edge_m: [f64; 2],
    /// Coulomb's coefficient of friction between it and the part.
    pub friction: f64,
    /// The coefficient of restitution.
    pub restitution: f64,
}

/// Reads case files: one case a line; empty lines are passed over.
///
/// # Errors
/// Every line that is no case, and every name that is given twice.
///
/// # Example
/// ```
/// let found = carom_referee::read_cases("cases.jsonl", "{\"case\": 1}\n").unwrap_err();
/// assert!(found.to_string().contains("line 1"), "{found}");
/// ```
pub fn read_cases(file: &str, text: &str) -> Result<Vec<Case>, Problems> {
    let (mut cases, mut wrong, mut known) = (vec![], vec![], BTreeSet::new());
    for (number, line) in lines(text) {
        match serde_json::from_str::<Case>(line) {
            Ok(case) if !known.insert(case.case.clone()) => {
                wrong.push(at_line(number, format!("the case {:?} stands there twice", case.case)));
            }
            Ok(case) => cases.push(case),
            Err(error) => wrong.push(at_line(number, format!("no case: {error}"))),
        }
    }
    if wrong.is_empty() { Ok(cases) } else { Err(Problems::new(file, "", wrong)) }
}

/// The lines that hold something, with their numbers, from 1.
pub(crate) fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    text.lines().enumerate().map(|(i, line)| (i + 1, line)).filter(|(_, line)| !line.trim().is_empty())
}

/// A problem of a line.
pub(crate) fn at_line(number: usize, message: String) -> Problem {
    Problem::new(ProblemKind::WrongValue, format!("line {number}"), message, None)
}
