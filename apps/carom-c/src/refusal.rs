//! Why a call has no answer: its status, and what is told.

use crate::plain::Status;
use carom_scene::{LineError, Problem, ProblemKind, Problems};

/// A status that is not [`Status::Ok`], with the JSON object that says why.
#[derive(Debug)]
pub(crate) struct Refusal {
    pub(crate) status: Status,
    pub(crate) json: String,
}

impl Refusal {
    fn of(status: Status, error: &LineError) -> Self {
        // It is made of texts alone, and texts are always written.
        Self { status, json: serde_json::to_string(error).unwrap_or_default() }
    }

    /// Bad input, with all of its problems.
    pub(crate) fn of_input(problems: Problems) -> Self {
        Self::of(Status::BadInput, &LineError::of_input(1, &[problems]))
    }

    /// One thing that is wrong with an argument of this name.
    pub(crate) fn of_argument(name: &str, kind: ProblemKind, message: impl Into<String>) -> Self {
        Self::of_input(Problems::new("", "", vec![Problem::new(kind, name, message, None)]))
    }

    /// What could not be computed.
    pub(crate) fn of_failure(why: String) -> Self {
        Self::of(Status::Undone, &LineError::of_failure(1, why))
    }

    /// A fault of ours.
    pub(crate) fn of_fault(why: impl std::fmt::Display) -> Self {
        Self::of(Status::Fault, &LineError::of_failure(1, format!("a fault of Carom: {why}")))
    }
}

impl From<Problems> for Refusal {
    fn from(problems: Problems) -> Self {
        Self::of_input(problems)
    }
}

impl From<serde_json::Error> for Refusal {
    fn from(error: serde_json::Error) -> Self {
        Self::of_fault(error)
    }
}
