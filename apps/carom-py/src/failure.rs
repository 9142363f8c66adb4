//! What is wrong, as the one exception of the package.

use carom_scene::{LineError, Problems};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

/// The package's exception with a message and its problems, as JSON.
fn raised(py: Python<'_>, message: &str, problems: &str) -> PyErr {
    let made = py
        .import("carom.errors")
        .and_then(|module| module.getattr("CaromError"))
        .and_then(|class| class.call_method1("_of_json", (message, problems)));
    made.map_or_else(|error| error, PyErr::from_value)
}

fn json(error: &LineError) -> String {
    serde_json::to_string(&error.error.problems).unwrap_or_else(|_| "[]".to_owned())
}

/// Input that has problems: all of them.
pub(crate) fn of_input(py: Python<'_>, problems: &Problems) -> PyErr {
    raised(py, &problems.to_string(), &json(&LineError::of_input(1, std::slice::from_ref(problems))))
}

/// Input that is several files or tables.
pub(crate) fn of_inputs(py: Python<'_>, problems: &[Problems]) -> PyErr {
    let message = problems.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n");
    raised(py, &message, &json(&LineError::of_input(1, problems)))
}

/// What could not be computed, or was not asked rightly.
pub(crate) fn of_words(py: Python<'_>, message: &str) -> PyErr {
    raised(py, message, &json(&LineError::of_failure(1, message.to_owned())))
}

/// A fault of the program itself.
pub(crate) fn of_fault(message: impl std::fmt::Display) -> PyErr {
    PyRuntimeError::new_err(format!("a fault of Carom: {message}"))
}
