//! What a file draws: pieces of outline, each with its place in the file, and what is wrong with them.

use super::edge::Edge;
use crate::problem::ProblemKind;
use crate::unit::Dimension;
use carom_num::Vec2;
use std::collections::BTreeMap;

/// Most problems of one file that are listed.
const MOST_LISTED: usize = 20;
/// Faults of one kind that are looked for: pairs of edges that cross grow as the square of what is drawn.
pub(crate) const MOST_SOUGHT: usize = 1000;

/// Something drawn, by its name and its line in the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Origin {
    pub(crate) name: String,
    pub(crate) line: usize,
}

impl std::fmt::Display for Origin {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "the {} in line {}", self.name, self.line)
    }
}

/// Edges that follow each other.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Piece {
    pub(crate) edges: Vec<Edge>,
    /// The file says that its end meets its start.
    pub(crate) closed: bool,
    pub(crate) origin: Origin,
}

impl Piece {
    pub(crate) fn from(&self) -> Vec2 {
        self.edges.first().map_or(Vec2::ZERO, Edge::from)
    }

    pub(crate) fn to(&self) -> Vec2 {
        self.edges.last().map_or(Vec2::ZERO, Edge::to)
    }

    pub(crate) fn reverse(&mut self) {
        self.edges.reverse();
        self.edges.iter_mut().for_each(|edge| *edge = edge.reversed());
    }
}

/// Why a file is not an outline: one thing.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Fault {
    /// Line of the file, from 1.
    pub(crate) line: Option<usize>,
    pub(crate) text: String,
    pub(crate) help: Option<&'static str>,
    /// The file itself, what it draws, or that it draws it in a way that is not read.
    pub(crate) kind: ProblemKind,
}

impl Fault {
    pub(crate) fn new(line: impl Into<Option<usize>>, text: impl Into<String>) -> Self {
        Self { line: line.into(), text: text.into(), help: None, kind: ProblemKind::Geometry }
    }

    /// The file cannot be read at all.
    pub(crate) fn file(line: impl Into<Option<usize>>, text: impl Into<String>) -> Self {
        Self { kind: ProblemKind::File, ..Self::new(line, text) }
    }

    /// It may be a good outline, drawn in a way that is not read.
    pub(crate) fn unsupported(line: impl Into<Option<usize>>, text: impl Into<String>) -> Self {
        Self { kind: ProblemKind::Unsupported, ..Self::new(line, text) }
    }

    pub(crate) fn with_help(self, help: &'static str) -> Self {
        Self { help: Some(help), ..self }
    }
}

/// The first faults of a list, and how many more there are.
pub(crate) fn shortened(mut faults: Vec<Fault>) -> Vec<Fault> {
    let more = faults.len().saturating_sub(MOST_LISTED);
    if more > 0 {
        let at_least = if faults.len() < MOST_SOUGHT { "" } else { "at least " };
        faults.truncate(MOST_LISTED);
        faults.push(Fault::new(None, format!("and {at_least}{more} more problems like these")));
    }
    faults
}

/// What a file draws [m], y up.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Drawn {
    pub(crate) pieces: Vec<Piece>,
    /// What is no outline, by name: texts, dimensions, points.
    pub(crate) passed_over: BTreeMap<String, usize>,
    /// The file's unit, and how it is known: "unit mm, from the file".
    pub(crate) unit: String,
}

impl Drawn {
    /// Adds edges that follow each other, those of no length left out.
    pub(crate) fn push(&mut self, edges: Vec<Edge>, closed: bool, origin: Origin) -> Result<(), Fault> {
        if !edges.iter().all(Edge::is_finite) {
            let text = format!("{origin} has a number that is not finite");
            return Err(Fault::new(origin.line, text));
        }
        let long = |edge: &Edge| !edge.is_straight() || edge.from() != edge.to();
        let edges: Vec<Edge> = edges.into_iter().filter(long).collect();
        if !edges.is_empty() {
            self.pieces.push(Piece { edges, closed, origin });
        }
        Ok(())
    }

    pub(crate) fn pass_over(&mut self, name: &str) {
        *self.passed_over.entry(name.to_owned()).or_default() += 1;
    }

    /// The longer side of the upright rectangle around everything [m].
    pub(crate) fn size(&self) -> f64 {
        size_of(self.pieces.iter().flat_map(|piece| &piece.edges))
    }
}

/// The longer side of the upright rectangle around edges, curves taken at 64 places.
pub(crate) fn size_of<'e>(edges: impl Iterator<Item = &'e Edge>) -> f64 {
    let (mut low, mut high) =
        (Vec2::new(f64::INFINITY, f64::INFINITY), Vec2::new(f64::NEG_INFINITY, f64::NEG_INFINITY));
    for edge in edges {
        let places = if edge.is_straight() { 1 } else { 64 };
        for i in 0..=places {
            let p = edge.point(f64::from(i) / f64::from(places));
            (low.x, low.y) = (low.x.min(p.x), low.y.min(p.y));
            (high.x, high.y) = (high.x.max(p.x), high.y.max(p.y));
        }
    }
    (high.x - low.x).max(high.y - low.y).max(0.0)
}

/// A length for a reader, 5 digits.
pub(crate) fn length(value: f64) -> String {
    Dimension::Length.show_digits(value, 5)
}

/// A point for a reader.
pub(crate) fn place(point: Vec2) -> String {
    format!("({}, {})", length(point.x), length(point.y))
}
