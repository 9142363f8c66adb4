//! The answer to a line of input that has problems, as JSON.

use crate::problem::{Problem, ProblemKind, Problems};
use schemars::JsonSchema;
use serde::Serialize;

/// Characters of a value that are shown: a list may be as long as its line.
const MOST_SHOWN: usize = 200;

/// The answer to a line of input that has problems, or that nothing can be computed from.
///
/// # Example
/// ```
/// use carom_scene::{LineError, RollKind, RollProblem};
/// let found = RollProblem::parse(RollKind::Prism, "line 3", "sides = 4\nstrikes = -1", &[]).unwrap_err();
/// let told = serde_json::to_value(LineError::of_input(3, &found.0)).unwrap();
/// let problem = &told["error"]["problems"][0];
/// assert_eq!((&told["line"], &problem["key"], &problem["value"]), (&3.into(), &"strikes".into(), &"-1".into()));
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "carom error")]
pub struct LineError {
    /// The line of the input, counted from 1.
    pub line: usize,
    /// What is wrong.
    pub error: LineProblems,
}

/// What is wrong with a line.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct LineProblems {
    /// Every problem: at least one.
    pub problems: Vec<LineProblem>,
}

/// One problem of a line.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct LineProblem {
    /// Its kind; null where the line is good and no answer could be computed.
    pub kind: Option<ProblemKind>,
    /// Where it is, key by key: `plate.lower.slope`; empty for the line as a whole.
    pub path: String,
    /// The last key of the path; null for the line as a whole.
    pub key: Option<String>,
    /// What is written there, as TOML writes it, of a long value the beginning; null where the problem is not about a value.
    pub value: Option<String>,
    /// What is wrong and what is allowed, in a sentence.
    pub message: String,
    /// What may stand there: each word, key or unit by itself, or one sentence on what a number must be. Empty where only the message
    /// says it.
    pub allowed: Vec<String>,
    /// What to do; null where there is nothing to suggest.
    pub help: Option<String>,
}

impl LineError {
    /// Of a line that is bad input.
    pub fn of_input(line: usize, found: &[Problems]) -> Self {
        let one =
            |of: &Problems| of.list.iter().map(|problem| LineProblem::new(of, problem)).collect::<Vec<_>>();
        Self { line, error: LineProblems { problems: found.iter().flat_map(one).collect() } }
    }

    /// Of a line for which there is no answer, and why.
    pub fn of_failure(line: usize, why: String) -> Self {
        let (path, allowed) = (String::new(), vec![]);
        let problem =
            LineProblem { kind: None, path, key: None, value: None, message: why, allowed, help: None };
        Self { line, error: LineProblems { problems: vec![problem] } }
    }
}

impl LineProblem {
    fn new(of: &Problems, problem: &Problem) -> Self {
        let key = problem.path.rsplit('.').next().filter(|key| !key.is_empty());
        Self {
            kind: Some(problem.kind),
            path: problem.path.clone(),
            key: key.map(str::to_owned),
            value: value(of, problem),
            message: problem.message.clone(),
            allowed: problem.allowed.to_vec(),
            help: problem.help.clone(),
        }
    }
}

/// The value that a problem is about: the others are about a key, about a table, or about what is not there.
fn value(of: &Problems, problem: &Problem) -> Option<String> {
    let about_a_value = matches!(
        problem.kind,
        ProblemKind::WrongValue | ProblemKind::Quantity | ProblemKind::OutOfRange | ProblemKind::Name
    );
    let text = of.value(problem).filter(|_| about_a_value)?;
    let key = problem.path.rsplit('.').next().unwrap_or_default();
    let is_key = text == key || text.trim_matches('"') == key;
    (!is_key).then(|| match text.char_indices().nth(MOST_SHOWN) {
        Some((end, _)) => format!("{} …", &text[..end]),
        None => text.to_owned(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{AnyImpact, toml_of_json};

    fn told(json: &str) -> Vec<LineProblem> {
        let read = toml_of_json("line 1", json).and_then(|text| AnyImpact::parse("line 1", &text));
        LineError::of_input(1, &[read.unwrap_err()]).error.problems
    }

    #[test]
    fn a_problem_of_a_line_has_all_that_one_of_a_file_has() {
        let list = told(
            r#"{"law": "newtn", "body": {"mass": "2 furlong", "inertia": -1, "velocity": [0, -1], "spn": 1},
                "contact": [{"point": [0, 0], "normal": [0, 1], "friction": 0}]}"#,
        );
        let of = |path: &str| list.iter().find(|problem| problem.path == path).unwrap();
        let law = of("law");
        assert_eq!((law.key.as_deref(), law.value.as_deref()), (Some("law"), Some("\"newtn\"")));
        assert_eq!(
            (law.allowed.join(" "), law.kind),
            ("poisson stronge newton".into(), Some(ProblemKind::WrongValue))
        );
        assert_eq!(law.help.as_deref(), Some("did you mean \"newton\"?"));
        let (mass, inertia, spin) = (of("body.mass"), of("body.inertia"), of("body.spn"));
        assert!(mass.allowed.contains(&"kg".to_owned()) && mass.value.is_some(), "{mass:?}");
        assert_eq!(
            (inertia.allowed.join(" "), inertia.value.as_deref()),
            ("must be above 0".into(), Some("-1"))
        );
        assert!(spin.allowed.contains(&"spin".to_owned()) && spin.value.is_none(), "{spin:?}");
    }

    #[test]
    fn a_key_that_is_given_twice_is_refused_by_its_name() {
        let list = told(r#"{"law": "poisson", "law": "stronge"}"#);
        assert!(list[0].path == "law" && list[0].message.contains("twice"), "{list:?}");
    }
}
