//! Why a command did not do what it was asked to.

use carom::tasks::StudyError;
use carom_scene::Problems;
use carom_sweep::disk;
use std::fmt;
use std::path::Path;

/// Why, and with which exit code.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The input is bad: exit code 2.
    Input(Vec<Problems>),
    /// The options do not fit the input: exit code 2.
    Usage(String),
    /// It could not be done: exit code 1.
    Undone(String),
    /// Stdout could not be written: exit code 1.
    Output(std::io::Error),
}

impl Failure {
    pub(crate) fn code(&self) -> u8 {
        match self {
            Self::Input(_) | Self::Usage(_) => 2,
            Self::Undone(_) | Self::Output(_) => 1,
        }
    }

    /// A file or folder that could not be written or read.
    pub(crate) fn file(doing: &str, path: &Path, error: &std::io::Error) -> Self {
        disk::undone(doing, path, error).into()
    }

    /// An input file that cannot be read.
    pub(crate) fn unread(path: &Path, error: &std::io::Error) -> Self {
        disk::unread(path, error).into()
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input(problems) => {
                for (i, problems) in problems.iter().enumerate() {
                    if i > 0 {
                        writeln!(f)?;
                    }
                    write!(f, "{problems}")?;
                }
                Ok(())
            }
            Self::Usage(message) | Self::Undone(message) => f.write_str(message),
            Self::Output(error) => write!(f, "cannot write the output: {error}"),
        }
    }
}

impl From<std::io::Error> for Failure {
    fn from(error: std::io::Error) -> Self {
        Self::Output(error)
    }
}

impl From<Problems> for Failure {
    fn from(problems: Problems) -> Self {
        Self::Input(vec![problems])
    }
}

impl From<StudyError> for Failure {
    fn from(error: StudyError) -> Self {
        match error {
            StudyError::Input(problems) => Self::Input(problems),
            StudyError::Asked(message) => Self::Usage(message),
            StudyError::Undone(message) => Self::Undone(message),
        }
    }
}

impl From<serde_json::Error> for Failure {
    fn from(error: serde_json::Error) -> Self {
        Self::Undone(format!("cannot write the result as JSON: {error}"))
    }
}
