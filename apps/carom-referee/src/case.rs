//! What a case is.

use crate::motion::Bodies;
use crate::tolerance::AGREES;
use carom_scene::{AnyImpact, Problem, ProblemKind, Problems, Scene, toml_of_json};
use schemars::JsonSchema;
use serde::de::DeserializeOwned;
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

impl Case {
    /// An impact, with what is known of it.
    pub(crate) fn of_impact(
        (group, case): (&str, String),
        impact: Value,
        expected: Expected,
        source: &str,
    ) -> Self {
        Self {
            case,
            group: group.to_owned(),
            impact: Some(impact),
            scene: None,
            world: None,
            expected,
            tolerance: AGREES,
            source: source.to_owned(),
        }
    }
}

impl Known {
    /// Motions after an impact, and who says so.
    pub(crate) fn after(by: &str, bodies: Vec<Body>) -> Self {
        Self { by: by.to_owned(), bodies, verdict: None }
    }
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

/// A spin [rad/s]: a number in the plane, three in space.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged, expecting = "a number, or a list of three")]
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
/// Every line that is no case, each with what is wrong; a name that is given twice.
///
/// # Example
/// ```
/// let found = carom_referee::read_cases("cases.jsonl", "{\"case\": 1}\n").unwrap_err();
/// assert!(found.to_string().contains("line 1"), "{found}");
/// ```
pub fn read_cases(file: &str, text: &str) -> Result<Vec<Case>, Problems> {
    let (mut cases, mut wrong, mut known) = (vec![], vec![], BTreeSet::new());
    for (number, line) in lines(text) {
        match of_line::<Case>(line) {
            Ok(case) => {
                let twice = !known.insert(case.case.clone());
                wrong.extend(
                    twice.then(|| at_line(number, format!("the case {:?} stands there twice", case.case))),
                );
                wrong.extend(
                    faults(&case).into_iter().map(|why| at_line(number, format!("{:?}: {why}", case.case))),
                );
                cases.push(case);
            }
            Err(why) => wrong.push(at_line(number, format!("no case: {why}"))),
        }
    }
    told(file, wrong).map_or(Ok(cases), Err)
}

/// What is wrong with a case as such.
fn faults(case: &Case) -> Vec<String> {
    let mut found = vec![];
    if case.case.trim().is_empty() {
        found.push("a case has a name".to_owned());
    }
    if !(0.0..=1.0).contains(&case.tolerance) {
        found.push(format!("tolerance {}: a share from 0 to 1 is asked", case.tolerance));
    }
    if case.expected.answers.is_empty() {
        found.push("expected.answers: at least one answer is known".to_owned());
    }
    let known = case.expected.answers.iter().chain(&case.expected.others);
    match (&case.impact, &case.scene) {
        (Some(impact), None) => match AnyImpact::parse_json("impact", &impact.to_string()) {
            Err(problems) => {
                found.extend(
                    problems.list.into_iter().map(|one| format!("impact.{}: {}", one.path, one.message)),
                );
            }
            Ok(read) => match Bodies::of_any(&read) {
                None => found.push("impact: an impact of bodies is asked, not of an operator".to_owned()),
                Some(bodies) if !bodies.moves() => found.push("impact: nothing moves before it".to_owned()),
                Some(bodies) => found.extend(known.filter_map(|known| {
                    let why = match &known.verdict {
                        Some(_) => Some("an impact has no verdict".to_owned()),
                        None => bodies.wrong(&known.bodies),
                    };
                    why.map(|why| format!("expected, by {:?}: {why}", known.by))
                })),
            },
        },
        (None, Some(scene)) => {
            if let Err(problems) =
                toml_of_json("scene", &scene.to_string()).and_then(|text| Scene::parse("scene", &text))
            {
                found.extend(
                    problems.list.into_iter().map(|one| format!("scene.{}: {}", one.path, one.message)),
                );
            }
            let asked =
                |known: &&Known| known.verdict.as_deref().is_none_or(|said| !VERDICTS.contains(&said));
            found.extend(known.filter(asked).map(|known| {
                format!("expected, by {:?}: a verdict is asked: same, turned or none", known.by)
            }));
        }
        _ => found.push("one of impact and scene is asked".to_owned()),
    }
    found
}

/// Verdicts that a drop can have.
pub(crate) const VERDICTS: [&str; 3] = ["same", "turned", "none"];

/// Problems of a file that are listed one by one.
const MOST_LISTED: usize = 20;

/// All that is wrong with a file, listed up to a limit; `None` of nothing.
pub(crate) fn told(file: &str, mut wrong: Vec<Problem>) -> Option<Problems> {
    let more = wrong.len().saturating_sub(MOST_LISTED);
    wrong.truncate(MOST_LISTED);
    (!wrong.is_empty()).then(|| Problems::new(file, "", wrong).and_more(more))
}

/// One JSON object, and what is wrong with it where it is none.
pub(crate) fn of_line<T: DeserializeOwned>(line: &str) -> Result<T, String> {
    if !line.trim_start().starts_with('{') {
        return Err("one JSON object a line is asked".to_owned());
    }
    // The line has its own number.
    serde_json::from_str(line).map_err(|error| error.to_string().replace(" at line 1 column ", " at column "))
}

/// The lines that hold something, with their numbers, from 1.
pub(crate) fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let text = text.strip_prefix('\u{FEFF}').unwrap_or(text);
    text.lines().enumerate().map(|(i, line)| (i + 1, line)).filter(|(_, line)| !line.trim().is_empty())
}

/// A problem of a line.
pub(crate) fn at_line(number: usize, message: String) -> Problem {
    Problem::new(ProblemKind::WrongValue, format!("line {number}"), message, None)
}
