//! What is given by name or as an array, checked: every fault is told, up to a limit.

use crate::failure::{of_input, of_words};
use crate::watch::pool;
use carom::tasks;
use carom_impact::Law;
use carom_scene::{Drawn, Problem, ProblemKind, Problems};
use carom_words::Words;
use numpy::ndarray::ArrayView1;
use pyo3::prelude::*;
use rayon::prelude::*;

/// Faults that are told one by one.
const MOST_TOLD: usize = 10;

/// The number of the plate that is looked at: by its name or its number, the last one where none is given.
pub(crate) fn plate(py: Python<'_>, scene: &impl Drawn, given: Option<&str>) -> PyResult<usize> {
    tasks::plate(scene, given).map_err(|message| of_words(py, &format!("plate: {message}")))
}

/// Every finite number, and those above 0.
pub(crate) const ANY: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];
pub(crate) const POSITIVE: [f64; 2] = [f64::MIN_POSITIVE, f64::INFINITY];

/// The law of this name.
pub(crate) fn law(py: Python<'_>, given: &str) -> PyResult<Law> {
    let laws = [Law::Poisson, Law::Stronge, Law::Newton];
    laws.into_iter().find(|known| known.word() == given).ok_or_else(|| {
        let words = laws.map(|law| law.word()).join(", ");
        of_words(py, &format!("law: \"{given}\" is none of {words}"))
    })
}

/// The values of a column, where the array has them.
pub(crate) type Values<'a> = ArrayView1<'a, f64>;

/// A column of numbers, and what they must be.
pub(crate) struct Given<'a> {
    pub(crate) name: &'a str,
    pub(crate) values: Values<'a>,
    /// Both ends are allowed.
    pub(crate) allowed: [f64; 2],
}

/// The number of rows: columns of one value say it of every row.
///
/// # Errors
/// Columns of different lengths; values that are not finite or not allowed, by row and column, the first of them.
pub(crate) fn rows(py: Python<'_>, what: &str, columns: &[Given<'_>]) -> PyResult<usize> {
    let rows = columns.iter().map(|column| column.values.len()).find(|length| *length != 1).unwrap_or(1);
    let mut problems: Vec<Problem> = vec![];
    for column in columns.iter().filter(|column| ![1, rows].contains(&column.values.len())) {
        let message = format!("has {} rows, others have {rows}", column.values.len());
        problems.push(Problem::new(ProblemKind::Conflict, column.name, message, None));
    }
    let mut more = 0;
    for column in columns {
        let [low, high] = column.allowed;
        let wrong = |value: &f64| !(value.is_finite() && *value >= low && *value <= high);
        if !pool()?.install(|| (0..column.values.len()).into_par_iter().any(|row| wrong(&column.values[row])))
        {
            continue;
        }
        for (row, value) in column.values.iter().enumerate().filter(|(_, value)| wrong(value)) {
            if problems.len() >= MOST_TOLD {
                more += 1;
                continue;
            }
            let allowed = match (low.is_finite(), high.is_finite()) {
                (true, _) if low == f64::MIN_POSITIVE => "a number above 0".to_owned(),
                (true, true) => format!("a number from {low:?} to {high:?}"),
                (true, false) => format!("a number of at least {low:?}"),
                (false, true) => format!("a number of at most {high:?}"),
                (false, false) => "a finite number".to_owned(),
            };
            let kind = if value.is_finite() { ProblemKind::OutOfRange } else { ProblemKind::WrongValue };
            let mut problem =
                Problem::new(kind, column.name, format!("row {row}: {value:?} is not {allowed}"), None);
            problem.allowed = [allowed].into();
            problems.push(problem);
        }
    }
    if problems.is_empty() {
        return Ok(rows);
    }
    if more > 0 {
        let message = format!("{more} more values that are not allowed");
        problems.push(Problem::new(ProblemKind::OutOfRange, "", message, None));
    }
    Err(of_input(py, &Problems::new(what, "", problems)))
}

/// The value of a row.
pub(crate) fn at(values: &Values<'_>, row: usize) -> f64 {
    values[if values.len() == 1 { 0 } else { row }]
}
