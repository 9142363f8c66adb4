//! What is wrong with a file: every problem, each with its place, its value and what is allowed.

use std::fmt;
use std::ops::Range;

/// The kinds of problem.
///
/// # Example
/// A misspelt key is unknown, and the one that was meant is missing.
/// ```
/// use carom_scene::{ImpactProblem, ProblemKind};
/// let problems = ImpactProblem::parse("ball.toml", r#"
///     body = { mas = 1, inertia = 1, velocity = [0, -1] }
///     contact = [{ point = [0, -1], normal = [0, 1], friction = 0 }]
/// "#).unwrap_err();
/// let kinds: Vec<_> = problems.list.iter().map(|problem| problem.kind).collect();
/// assert!(kinds.contains(&ProblemKind::UnknownKey) && kinds.contains(&ProblemKind::MissingKey));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum ProblemKind {
    /// The file could not be read, or is empty.
    File,
    /// It is not TOML (or JSON).
    Syntax,
    /// A key that means nothing here.
    UnknownKey,
    /// A key that is needed and missing.
    MissingKey,
    /// A value of the wrong type, or a word that is none of those allowed.
    WrongValue,
    /// A text that is not a quantity: number, unit, dimension.
    Quantity,
    /// A quantity outside what is allowed.
    OutOfRange,
    /// Two things that exclude each other.
    Conflict,
    /// What is drawn cannot be: shapes, places, crossings.
    Geometry,
    /// Something that is not supported yet.
    Unsupported,
}

/// One problem.
///
/// # Example
/// ```
/// use carom_scene::{Problem, ProblemKind};
/// let problem = Problem::new(ProblemKind::OutOfRange, "part.mass", "must be above 0", Some(7..9));
/// assert_eq!((problem.path.as_str(), problem.help), ("part.mass", None));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    /// Its kind.
    pub kind: ProblemKind,
    /// Where in the scene: `plate.lower.slope`; empty for the file as a whole.
    pub path: String,
    /// What is wrong and what is allowed, with the numbers.
    pub message: String,
    /// What to do, where there is something to suggest.
    pub help: Option<String>,
    /// Bytes of the file it is about.
    pub span: Option<Range<usize>>,
}

impl Problem {
    /// A problem without a suggestion.
    ///
    /// # Example
    /// ```
    /// use carom_scene::{Problem, ProblemKind};
    /// let problem = Problem::new(ProblemKind::File, "", "the file is empty", None);
    /// assert_eq!((problem.message.as_str(), problem.span), ("the file is empty", None));
    /// ```
    pub fn new(
        kind: ProblemKind,
        path: impl Into<String>,
        message: impl Into<String>,
        span: Option<Range<usize>>,
    ) -> Self {
        Self { kind, path: path.into(), message: message.into(), help: None, span }
    }

    /// The same with a suggestion.
    ///
    /// # Example
    /// ```
    /// use carom_scene::{Problem, ProblemKind};
    /// let problem = Problem::new(ProblemKind::UnknownKey, "contact.fricton", "is unknown", None);
    /// let helped = problem.clone().with_help("did you mean \"friction\"?");
    /// assert_eq!(helped, Problem { help: Some("did you mean \"friction\"?".into()), ..problem });
    /// ```
    #[must_use]
    pub fn with_help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }
}

/// Every problem of one file, in the order of the file.
///
/// # Example
/// They say file, line and column.
/// ```
/// use carom_scene::{Problem, ProblemKind, Problems};
/// let problem = Problem::new(ProblemKind::OutOfRange, "mass", "must be above 0", Some(13..15));
/// let problems = Problems::new("part.toml", "[part]\nmass = -1\n", vec![problem]);
/// assert!(problems.to_string().contains("part.toml:2:7"));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Problems {
    /// The file's name, as it was given.
    pub file: String,
    /// Its text.
    pub source: String,
    /// The problems: at least one.
    pub list: Vec<Problem>,
}

impl Problems {
    /// Problems in the order of the file; those without a place come last.
    ///
    /// # Example
    /// In the order of the file, each once.
    /// ```
    /// use carom_scene::{Problem, ProblemKind, Problems};
    /// let at = |place: usize| Problem::new(ProblemKind::Syntax, "", "is wrong", Some(place..place + 1));
    /// let problems = Problems::new("a.toml", "abcdef", vec![at(4), at(1), at(4)]);
    /// assert_eq!(problems.list, [at(1), at(4)]);
    /// ```
    pub fn new(file: &str, source: &str, mut list: Vec<Problem>) -> Self {
        list.sort_by_key(|problem| problem.span.as_ref().map_or(usize::MAX, |span| span.start));
        list.dedup();
        Self { file: file.to_owned(), source: source.to_owned(), list }
    }

    /// Line and column, both from 1, of a byte of the file.
    ///
    /// # Example
    /// ```
    /// use carom_scene::Problems;
    /// let problems = Problems::new("a.toml", "a = 1\nb = 2\n", vec![]);
    /// assert_eq!((problems.line_and_column(0), problems.line_and_column(10)), ((1, 1), (2, 5)));
    /// ```
    pub fn line_and_column(&self, byte: usize) -> (usize, usize) {
        line_and_column(&self.source, byte)
    }

    /// The text a problem is about.
    ///
    /// # Example
    /// ```
    /// use carom_scene::{Problem, ProblemKind, Problems};
    /// let problem = Problem::new(ProblemKind::OutOfRange, "b", "is too large", Some(10..11));
    /// let problems = Problems::new("a.toml", "a = 1\nb = 2\n", vec![problem]);
    /// assert_eq!(problems.value(&problems.list[0]), Some("2"));
    /// ```
    pub fn value(&self, problem: &Problem) -> Option<&str> {
        problem.span.clone().and_then(|span| self.source.get(span))
    }

    fn write_place(&self, f: &mut fmt::Formatter<'_>, problem: &Problem) -> fmt::Result {
        let Some(span) = &problem.span else {
            return write!(f, "{}", self.file);
        };
        let (line, column) = self.line_and_column(span.start);
        write!(f, "{}:{line}:{column}", self.file)
    }

    fn write_excerpt(&self, f: &mut fmt::Formatter<'_>, span: &Range<usize>) -> fmt::Result {
        let (line, column) = self.line_and_column(span.start);
        let Some(text) = self.source.lines().nth(line - 1) else {
            return Ok(());
        };
        let text = text.replace('\t', " ");
        let left = text.chars().count().saturating_sub(column - 1).max(1);
        let marked = self.source.get(span.clone()).map_or(1, |marked| {
            marked.lines().next().map_or(1, |first| first.chars().count()).clamp(1, left)
        });
        let number = line.to_string();
        let margin = " ".repeat(number.len());
        writeln!(f, " {margin} |")?;
        writeln!(f, " {number} | {}", text.trim_end())?;
        writeln!(f, " {margin} | {}{}", " ".repeat(column - 1), "^".repeat(marked))
    }
}

fn line_and_column(source: &str, byte: usize) -> (usize, usize) {
    let mut byte = byte.min(source.len());
    while !source.is_char_boundary(byte) {
        byte -= 1;
    }
    let before = &source[..byte];
    let start = before.rfind('\n').map_or(0, |at| at + 1);
    (before.matches('\n').count() + 1, before[start..].chars().count() + 1)
}

impl fmt::Display for Problems {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let count = self.list.len();
        writeln!(f, "{count} problem{} in {}", if count == 1 { "" } else { "s" }, self.file)?;
        for problem in &self.list {
            writeln!(f)?;
            self.write_place(f, problem)?;
            if problem.path.is_empty() {
                writeln!(f, ": {}", problem.message)?;
            } else {
                writeln!(f, ": {}: {}", problem.path, problem.message)?;
            }
            if let Some(span) = &problem.span {
                self.write_excerpt(f, span)?;
            }
            if let Some(help) = &problem.help {
                writeln!(f, "   help: {help}")?;
            }
        }
        Ok(())
    }
}

impl std::error::Error for Problems {}
