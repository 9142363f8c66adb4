//! What an engine answers.

use crate::case::{Body, Case, Spin, VERDICTS, at_line, lines, of_line, told};
use crate::motion::Bodies;
use carom_scene::{Problems, nearest};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};

/// The answer of an engine to a case: one line of an answer file. One of `bodies`, `velocity_m_s` with `spin_rad_s`, `verdict` and
/// `refused` is given.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "carom judge: one line of answers")]
pub struct Answer {
    /// The name of the case.
    pub case: String,
    /// The engine that answers, with what tells it from others; the name of the file where it is left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub engine: Option<String>,
    /// The bodies after the impact, in the order of the file.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub bodies: Vec<Body>,
    /// Of one body: its velocity after [m/s].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub velocity_m_s: Option<Vec<f64>>,
    /// Of one body: its spin after [rad/s].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spin_rad_s: Option<Spin>,
    /// Of a drop: `same`, `turned`, or `none` where the part came to no rest.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub verdict: Option<String>,
    /// Why the engine cannot be asked.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub refused: Option<String>,
}

impl Answer {
    /// The bodies, however they were written.
    pub(crate) fn bodies(&self) -> Vec<Body> {
        match (&self.velocity_m_s, self.spin_rad_s) {
            (Some(velocity), Some(spin_rad_s)) => vec![Body { velocity_m_s: velocity.clone(), spin_rad_s }],
            _ => self.bodies.clone(),
        }
    }

    /// What is wrong with it as an answer to its case.
    fn wrong(&self, case: &Case) -> Option<String> {
        let one_body = [self.velocity_m_s.is_some(), self.spin_rad_s.is_some()];
        let given = [
            !self.bodies.is_empty(),
            one_body.contains(&true),
            self.verdict.is_some(),
            self.refused.is_some(),
        ];
        if given.iter().filter(|given| **given).count() != 1 || one_body[0] != one_body[1] {
            return Some(
                "one of bodies, velocity_m_s with spin_rad_s, verdict and refused is asked".to_owned(),
            );
        }
        if self.refused.is_some() {
            return None;
        }
        match (&case.impact, &self.verdict) {
            (None, Some(said)) if VERDICTS.contains(&said.as_str()) => None,
            (None, Some(said)) => Some(format!("verdict {said:?}: same, turned or none is asked")),
            (None, None) => Some("a drop is answered by a verdict: same, turned or none".to_owned()),
            (Some(_), Some(_)) => {
                Some("an impact is answered by velocities and spins, not by a verdict".to_owned())
            }
            (Some(impact), None) => Bodies::of(impact)?.wrong(&self.bodies()),
        }
    }
}

/// Reads an answer file: one answer a line, in any order; empty lines are passed over. `file` is the name that problems are told under,
/// and the engine's where it gives none.
///
/// # Errors
/// Every line that is no answer to one of the cases, or a second one to the same case by the same engine.
///
/// # Example
/// ```
/// let cases = carom_referee::cases();
/// let line = format!(r#"{{"case": "{}", "verdict": "turned"}}"#, cases[0].case);
/// let problems = carom_referee::read_answers("mine.jsonl", &line, &cases).unwrap_err();
/// assert!(problems.to_string().contains("velocities and spins"), "{problems}");
/// ```
pub fn read_answers(file: &str, text: &str, cases: &[Case]) -> Result<Vec<Answer>, Problems> {
    let known: BTreeMap<&str, &Case> = cases.iter().map(|case| (case.case.as_str(), case)).collect();
    let stem = std::path::Path::new(file).file_stem().unwrap_or_default().to_string_lossy();
    let (mut answers, mut wrong, mut seen, mut unknowns) = (vec![], vec![], BTreeSet::new(), 0);
    for (number, line) in lines(text) {
        let said = of_line::<Answer>(line).map_err(|why| format!("no answer: {why}"));
        let read = said.and_then(|said| {
            let case = known.get(said.case.as_str()).ok_or_else(|| {
                // The first ones get a suggestion: to find it takes a look at every name.
                unknowns += 1;
                if unknowns <= MOST_SUGGESTED { unknown(&said.case, &known) } else { no_case(&said.case) }
            })?;
            let told = |why| format!("{}: {why}", said.case);
            said.wrong(case).map_or(Ok(()), |why| Err(told(why)))?;
            let engine = said.engine.clone().unwrap_or_else(|| stem.to_string());
            if engine.trim().is_empty() || engine.chars().any(char::is_control) {
                return Err(told("the name of the engine is empty, or more than a line".to_owned()));
            }
            let first = seen.insert((engine.clone(), said.case.clone()));
            if first { Ok(()) } else { Err(told("a second answer by the same engine".to_owned())) }?;
            Ok(Answer { engine: Some(engine), ..said })
        });
        match read {
            Ok(answer) => answers.push(answer),
            Err(why) => wrong.push(at_line(number, why)),
        }
    }
    told(file, wrong).map_or(Ok(answers), Err)
}

/// What is wrong where an engine answers a case in two files.
pub fn twice(answers: &[Answer]) -> Option<String> {
    let mut seen = BTreeSet::new();
    let second = answers.iter().find(|answer| !seen.insert((&answer.engine, &answer.case)))?;
    let engine = second.engine.as_deref().unwrap_or_default();
    Some(format!(
        "two files answer {:?} by the engine {engine:?}: name the engines, each in its lines",
        second.case
    ))
}

/// Unknown names that are compared with all that are known.
const MOST_SUGGESTED: usize = 20;

fn no_case(name: &str) -> String {
    format!("there is no case {name:?}")
}

fn unknown(name: &str, known: &BTreeMap<&str, &Case>) -> String {
    let names: Vec<&str> = known.keys().copied().collect();
    match nearest(name, &names) {
        Some(near) => format!("there is no case {name:?}; did you mean {near:?}?"),
        None => no_case(name),
    }
}
