//! What is wrong with a file: every problem, each with its place, its value and what is allowed.

use crate::label::labelled;
use crate::lines::Lines;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeSet;
use std::fmt;
use std::ops::Range;

/// Characters of a long line that are shown before what a problem is about, and from there on.
const MOST_BESIDE: usize = 120;

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
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
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
    /// A name that is taken, cannot stand in a path, or is nobody's.
    Name,
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
    /// What may stand there: each word, key or unit by itself, or one sentence on what a number must be; empty where only the message
    /// says it.
    pub allowed: Box<[String]>,
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
        Self { kind, path: path.into(), message: message.into(), help: None, allowed: Box::default(), span }
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

impl Problem {
    /// The same with what may stand there.
    #[must_use]
    pub(crate) fn with_allowed<T: AsRef<str>>(mut self, allowed: impl IntoIterator<Item = T>) -> Self {
        self.allowed = allowed.into_iter().map(|one| one.as_ref().to_owned()).collect();
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
    /// How many more there are, which are not listed.
    pub more: usize,
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
        // A key that is missing is told once, by whoever knows what to write.
        let missing = |problem: &Problem| problem.kind == ProblemKind::MissingKey;
        let helped: BTreeSet<String> = list
            .iter()
            .filter(|problem| missing(problem) && problem.help.is_some())
            .map(|problem| problem.path.clone())
            .collect();
        list.retain(|problem| !missing(problem) || problem.help.is_some() || !helped.contains(&problem.path));
        Self { file: file.to_owned(), source: source.to_owned(), list, more: 0 }
    }

    /// The same, with so many more that are not listed.
    ///
    /// # Example
    /// ```
    /// use carom_scene::{Problem, ProblemKind, Problems};
    /// let first = Problem::new(ProblemKind::WrongValue, "line 2", "is no number", None);
    /// let problems = Problems::new("list.csv", "", vec![first]).and_more(999);
    /// assert!(problems.to_string().starts_with("1000 problems in list.csv, of which the first 1:"));
    /// ```
    #[must_use]
    pub fn and_more(mut self, more: usize) -> Self {
        self.more = more;
        self
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
        let (line, column, _) = Places::of(&self.source).at(byte);
        (line, column)
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
}

/// Places of a text, told one after the other: in the order of the text each costs what lies between.
struct Places<'t> {
    text: &'t str,
    lines: Lines<'t>,
    /// The place that was told last: byte, line, column.
    last: (usize, usize, usize),
}

impl<'t> Places<'t> {
    fn of(text: &'t str) -> Self {
        Self { text, lines: Lines::of(text), last: (0, 1, 1) }
    }

    /// Line and column, both from 1, of a byte, and the character's own first byte.
    fn at(&mut self, byte: usize) -> (usize, usize, usize) {
        let byte = self.text.floor_char_boundary(byte);
        let line = self.lines.line_of(byte);
        let (known, _, column) = self.last;
        let (from, column) =
            if self.last.1 == line && known <= byte { (known, column) } else { (self.lines.start(line), 1) };
        let column = column + self.text[from..byte].chars().count();
        self.last = (byte, line, column);
        (line, column, byte)
    }

    /// The line of a place with a mark below; of a long one what is near.
    fn write_excerpt(&mut self, f: &mut fmt::Formatter<'_>, span: &Range<usize>) -> fmt::Result {
        let (line, _, byte) = self.at(span.start);
        let text = self.lines.text(line);
        let at = (byte - self.lines.start(line)).min(text.len());
        let before: Vec<char> = text[..at].chars().rev().take(MOST_BESIDE + 1).collect();
        let after: Vec<char> = text[at..].chars().take(MOST_BESIDE + 1).collect();
        let (cut_before, cut_after) = (before.len() > MOST_BESIDE, after.len() > MOST_BESIDE);
        let mut shown = String::from(if cut_before { "… " } else { "" });
        shown.extend(before.iter().take(MOST_BESIDE).rev());
        let indent = shown.chars().count();
        shown.extend(after.iter().take(MOST_BESIDE));
        shown.push_str(if cut_after { " …" } else { "" });
        let left = after.len().clamp(1, MOST_BESIDE);
        let marked = self.text.get(span.clone()).map_or(1, |marked| {
            marked.lines().next().map_or(1, |first| first.chars().take(left).count()).clamp(1, left)
        });
        let number = line.to_string();
        let margin = " ".repeat(number.len());
        writeln!(f, " {margin} |")?;
        writeln!(f, " {number} | {}", shown.replace('\t', " ").trim_end())?;
        writeln!(f, " {margin} | {}{}", " ".repeat(indent), "^".repeat(marked))
    }
}

impl fmt::Display for Problems {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (listed, count) = (self.list.len(), self.list.len() + self.more);
        write!(f, "{count} problem{} in {}", if count == 1 { "" } else { "s" }, self.file)?;
        writeln!(
            f,
            "{}",
            if self.more > 0 { format!(", of which the first {listed}:") } else { String::new() }
        )?;
        // The places of all problems are found in one pass over the file: thousands of problems must not take their square.
        let mut places = Places::of(&self.source);
        for problem in &self.list {
            writeln!(f)?;
            match &problem.span {
                None => write!(f, "{}", self.file)?,
                Some(span) => {
                    let (line, column, _) = places.at(span.start);
                    write!(f, "{}:{line}:{column}", self.file)?;
                }
            }
            if problem.path.is_empty() {
                writeln!(f, ": {}", problem.message)?;
            } else {
                writeln!(f, ": {}: {}", labelled(&problem.path), problem.message)?;
            }
            if let Some(span) = &problem.span {
                places.write_excerpt(f, span)?;
            }
            if let Some(help) = &problem.help {
                writeln!(f, "   help: {help}")?;
            }
        }
        if self.more > 0 {
            writeln!(f, "\nand {} more like these", self.more)?;
        }
        Ok(())
    }
}

impl std::error::Error for Problems {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_a_long_line_what_is_near_is_shown() {
        let text = format!("{}wrong = 1{}\nlast = 2\n", "ä ".repeat(400), " b".repeat(400));
        let at = text.find("wrong").unwrap();
        let problem = |at: usize| Problem::new(ProblemKind::UnknownKey, "", "is unknown", Some(at..at + 5));
        let said =
            Problems::new("a.toml", &text, vec![problem(at), problem(at + 6), problem(text.len() - 9)]);
        let said = said.to_string();
        assert!(
            said.contains("a.toml:1:801:") && said.contains("a.toml:1:807:"),
            "characters are counted: {said}"
        );
        assert!(said.contains("a.toml:2:1:") && said.contains(" 2 | last = 2\n   | ^^^^^"), "{said}");
        let lines: Vec<&str> = said.lines().collect();
        let shown = lines.iter().position(|line| line.contains("wrong")).unwrap();
        assert!(lines[shown].chars().count() < 260, "{}", lines[shown]);
        let mark = lines[shown + 1].chars().position(|c| c == '^').unwrap();
        assert_eq!(lines[shown].chars().skip(mark).take(5).collect::<String>(), "wrong", "the mark is below");
    }

    #[test]
    fn a_place_costs_what_lies_between() {
        // In one line, a thousand times: the characters between places are read once each, so 10^5 places of 10^6 bytes take no time at all.
        let text = "key = 1, ".repeat(100_000);
        let mut places = Places::of(&text);
        for k in 0..100_000 {
            assert_eq!(places.at(9 * k), (1, 9 * k + 1, 9 * k), "place {k}");
        }
        assert_eq!(places.at(3), (1, 4, 3), "and back");
    }
}
