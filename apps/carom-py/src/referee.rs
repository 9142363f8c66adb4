//! The referee of engines: cases out, answers in.

use crate::answers::pretty;
use crate::failure::{of_fault, of_inputs, of_words};
use carom_referee::{Case, cases, judge, of_group, read_answers, read_cases, twice};
use pyo3::prelude::*;

/// The cases, one JSON object a line, as `carom cases --format json` prints them.
#[pyfunction]
#[pyo3(signature = (group=None))]
pub(crate) fn referee_cases(py: Python<'_>, group: Option<&str>) -> PyResult<String> {
    let lines = py
        .detach(|| of_group(cases(), group).iter().map(serde_json::to_string).collect::<Result<Vec<_>, _>>());
    lines.map(|lines| lines.join("\n") + "\n").map_err(of_fault)
}

/// What `carom judge` says of answers, as JSON and for a person. Answers are texts with their names; cases are one, where they are not
/// ours.
#[pyfunction]
#[pyo3(signature = (answers, cases=None, within=None))]
pub(crate) fn referee_judge(
    py: Python<'_>,
    answers: Vec<(String, String)>,
    cases: Option<(String, String)>,
    within: Option<f64>,
) -> PyResult<(String, String)> {
    let known: Result<Vec<Case>, _> = py.detach(|| match &cases {
        None => Ok(carom_referee::cases()),
        Some((name, text)) => read_cases(name, text),
    });
    let known = known.map_err(|problems| of_inputs(py, &[problems]))?;
    let read = answers.iter().map(|(name, text)| read_answers(name, text, &known));
    let (read, wrong): (Vec<_>, Vec<_>) = read.partition(Result::is_ok);
    let wrong: Vec<_> = wrong.into_iter().filter_map(Result::err).collect();
    if !wrong.is_empty() {
        return Err(of_inputs(py, &wrong));
    }
    let all: Vec<_> = read.into_iter().flatten().flatten().collect();
    if let Some(problem) = twice(&all) {
        return Err(of_words(py, &problem));
    }
    if all.is_empty() {
        return Err(of_words(py, "there is no answer to judge"));
    }
    let report = py.detach(|| judge(&known, &all, within));
    Ok((pretty(&report)?, report.text()))
}
