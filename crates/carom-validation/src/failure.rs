//! Why a result could not be validated.

use thiserror::Error;

/// Why a result could not be validated.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ValidationError {
    /// There is no result of that name.
    #[error("there is no published result \"{name}\"; there are {known}")]
    Unknown {
        /// As it was asked for.
        name: String,
        /// Those that there are.
        known: String,
    },
    /// A table cannot be read.
    #[error("{name}/result.toml: {why}")]
    Table {
        /// The result's name.
        name: String,
        /// What is wrong with it.
        why: String,
    },
    /// An input of the engine is refused.
    #[error("{what} is refused: {why}")]
    Input {
        /// Which input.
        what: String,
        /// The problems found.
        why: String,
    },
    /// The engine did not come to the event that is asked about.
    #[error("{what} did not happen")]
    Missing {
        /// Which event.
        what: String,
    },
    /// The engine gave up.
    #[error("{what}: {why}")]
    Engine {
        /// Which run or impact.
        what: String,
        /// Its error.
        why: String,
    },
}

impl ValidationError {
    pub(crate) fn missing(what: impl Into<String>) -> Self {
        Self::Missing { what: what.into() }
    }

    pub(crate) fn input(what: &str, why: impl ToString) -> Self {
        Self::Input { what: what.to_owned(), why: why.to_string() }
    }

    pub(crate) fn engine(what: &str, why: impl ToString) -> Self {
        Self::Engine { what: what.to_owned(), why: why.to_string() }
    }
}
