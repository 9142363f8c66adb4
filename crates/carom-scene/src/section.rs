//! Reading a table of a file: every key is asked for by name, and what nobody asked for is a problem.

use crate::node::{Entry, Node, Value};
use crate::problem::{Problem, ProblemKind};
use crate::quantity::{self, Kind, Quantity, Tolerance};
use crate::suggest::nearest;
use crate::unit::Dimension;
use std::cell::RefCell;
use std::ops::Range;

/// Where the readers of a file lay down what is wrong.
#[derive(Debug, Default)]
pub(crate) struct Sink {
    list: RefCell<Vec<Problem>>,
    /// The longest length [m] that a plain number may be; `None` where there is no such rule.
    longest_plain: Option<f64>,
}

impl Sink {
    /// For a file whose lengths are those of a device: a plain number of more than this [m] is one whose unit was forgotten.
    pub(crate) fn with_longest_plain(length: f64) -> Self {
        Self { list: RefCell::default(), longest_plain: Some(length) }
    }

    /// What is wrong with a plain number as a length: read in metres it is longer than anything there is.
    fn forgotten_unit(&self, path: &str, kind: Kind, node: &Node) -> Option<Problem> {
        let (Value::Number(number), Dimension::Length) = (&node.value, kind.dimension) else { return None };
        let longest = self.longest_plain.filter(|longest| number.abs() > *longest)?;
        let (shown, longest) = (kind.dimension.show(*number), kind.dimension.show(longest));
        let message = format!("{number} without a unit is {shown}: more than {longest} needs its unit");
        let problem = Problem::new(ProblemKind::Quantity, path, message, Some(node.span.clone()));
        let help = format!(
            "a plain number is in m: write millimetres as \"{number} mm\", or \"{number} m\" where it is so long"
        );
        Some(problem.with_help(help))
    }

    pub(crate) fn push(&self, problem: Problem) {
        self.list.borrow_mut().push(problem);
    }

    pub(crate) fn into_list(self) -> Vec<Problem> {
        self.list.into_inner()
    }
}

/// A table that is being read.
pub(crate) struct Section<'t> {
    path: String,
    entries: &'t [Entry],
    /// Its header or its braces.
    span: Range<usize>,
    sink: &'t Sink,
    asked: RefCell<Vec<&'static str>>,
}

impl<'t> Section<'t> {
    /// A table at a path; `None`, and a problem, where the node is no table.
    pub(crate) fn new(path: &str, node: &'t Node, sink: &'t Sink) -> Option<Self> {
        let Value::Table(entries) = &node.value else {
            sink.push(expected("a table", path, node));
            return None;
        };
        let asked = RefCell::default();
        Some(Self { path: path.to_owned(), entries, span: node.span.clone(), sink, asked })
    }

    pub(crate) fn path(&self) -> &str {
        &self.path
    }

    pub(crate) fn span(&self) -> Range<usize> {
        self.span.clone()
    }

    /// Its place; none where it is the whole file.
    fn place(&self) -> Option<Range<usize>> {
        (!self.path.is_empty()).then(|| self.span())
    }

    pub(crate) fn sink(&self) -> &'t Sink {
        self.sink
    }

    /// The path of a key of this table.
    pub(crate) fn path_of(&self, key: &str) -> String {
        if self.path.is_empty() { key.to_owned() } else { format!("{}.{key}", self.path) }
    }

    /// Calls the table by another name, once its name is known.
    pub(crate) fn rename(&mut self, path: String) {
        self.path = path;
    }

    pub(crate) fn get(&self, key: &'static str) -> Option<&'t Node> {
        self.asked.borrow_mut().push(key);
        self.entries.iter().find(|entry| entry.key == key).map(|entry| &entry.node)
    }

    pub(crate) fn has(&self, key: &str) -> bool {
        self.entries.iter().any(|entry| entry.key == key)
    }

    /// Place of a key, or of the table where the key is missing.
    pub(crate) fn key_span(&self, key: &str) -> Range<usize> {
        let entry = self.entries.iter().find(|entry| entry.key == key);
        entry.map_or_else(|| self.span(), |entry| entry.key_span.clone())
    }

    pub(crate) fn section(&self, key: &'static str) -> Option<Section<'t>> {
        let node = self.get(key)?;
        Section::new(&self.path_of(key), node, self.sink)
    }

    /// The tables of `[[key]]`.
    pub(crate) fn sections(&self, key: &'static str) -> Vec<Section<'t>> {
        let Some(node) = self.get(key) else { return vec![] };
        let Value::List(items) = &node.value else {
            let help = format!("write [[{key}]] with two brackets: there may be several");
            self.sink.push(expected("a list of tables", &self.path_of(key), node).with_help(help));
            return vec![];
        };
        let tables = items.iter().enumerate();
        tables.filter_map(|(i, item)| Section::new(&format!("{key}.{i}"), item, self.sink)).collect()
    }

    pub(crate) fn quantity(&self, key: &'static str, kind: Kind) -> Option<Quantity> {
        let node = self.get(key)?;
        read_quantity(&self.path_of(key), node, kind, self.sink)
    }

    /// A quantity that must be there.
    pub(crate) fn required(&self, key: &'static str, kind: Kind) -> Option<Quantity> {
        if !self.has(key) {
            let unit = kind.dimension.usual();
            let example = if unit.is_empty() { String::new() } else { format!(", for example in {unit}") };
            self.missing(key, format!("{}{example}", kind.dimension));
        }
        self.quantity(key, kind)
    }

    /// Says that a key is missing and what it should hold.
    pub(crate) fn missing(&self, key: &'static str, holds: impl std::fmt::Display) {
        self.asked.borrow_mut().push(key);
        let message = format!("missing: {holds}");
        self.sink.push(Problem::new(ProblemKind::MissingKey, self.path_of(key), message, self.place()));
    }

    pub(crate) fn text(&self, key: &'static str) -> Option<(&'t str, Range<usize>)> {
        let node = self.get(key)?;
        match &node.value {
            Value::Text(text) => Some((text, node.span.clone())),
            _ => {
                self.sink.push(expected("a text", &self.path_of(key), node));
                None
            }
        }
    }

    /// True or false.
    pub(crate) fn flag(&self, key: &'static str) -> Option<bool> {
        let node = self.get(key)?;
        let Value::Bool(flag) = node.value else {
            self.sink.push(expected("true or false", &self.path_of(key), node));
            return None;
        };
        Some(flag)
    }

    /// One of a few words.
    pub(crate) fn word<T: Copy>(&self, key: &'static str, allowed: &[(&str, T)]) -> Option<T> {
        let (text, span) = self.text(key)?;
        let found = allowed.iter().find(|(word, _)| *word == text);
        if found.is_none() {
            let words: Vec<&str> = allowed.iter().map(|(word, _)| *word).collect();
            let message = format!("\"{text}\" is none of {}", words.join(", "));
            let problem = Problem::new(ProblemKind::WrongValue, self.path_of(key), message, Some(span));
            self.sink.push(meant(problem, text, &words));
        }
        found.map(|(_, value)| *value)
    }

    /// Two lengths: a point.
    pub(crate) fn pair(&self, key: &'static str, kind: Kind) -> Option<[Quantity; 2]> {
        let node = self.get(key)?;
        read_pair(&self.path_of(key), node, kind, self.sink)
    }

    /// Three quantities: a vector in space.
    pub(crate) fn triple(&self, key: &'static str, kind: Kind) -> Option<[Quantity; 3]> {
        let node = self.get(key)?;
        read_triple(&self.path_of(key), node, kind, self.sink)
    }

    /// Says which keys nobody asked for.
    pub(crate) fn finish(self) {
        let asked = self.asked.borrow();
        let mut allowed = asked.clone();
        allowed.sort_unstable();
        allowed.dedup();
        for entry in self.entries.iter().filter(|entry| !allowed.contains(&entry.key.as_str())) {
            let place = if self.path.is_empty() { "the file".to_owned() } else { format!("[{}]", self.path) };
            let message = format!("unknown key; {place} has {}", allowed.join(", "));
            let span = Some(entry.key_span.clone());
            let problem = Problem::new(ProblemKind::UnknownKey, self.path_of(&entry.key), message, span);
            self.sink.push(meant(problem, &entry.key, &allowed));
        }
    }
}

fn meant(problem: Problem, word: &str, allowed: &[&str]) -> Problem {
    match nearest(word, allowed) {
        Some(near) => problem.with_help(format!("did you mean \"{near}\"?")),
        None => problem,
    }
}

pub(crate) fn expected(what: &str, path: &str, node: &Node) -> Problem {
    let message = format!("expected {what}, found {}", node.value.type_in_words());
    Problem::new(ProblemKind::WrongValue, path, message, Some(node.span.clone()))
}

pub(crate) fn read_pair(path: &str, node: &Node, kind: Kind, sink: &Sink) -> Option<[Quantity; 2]> {
    match &node.value {
        Value::List(items) if items.len() == 2 => {
            let x = read_quantity(&format!("{path}.x"), &items[0], kind, sink);
            let y = read_quantity(&format!("{path}.y"), &items[1], kind, sink);
            Some([x?, y?])
        }
        Value::List(items) => {
            let message = format!("expected two numbers [x, y], found {}", items.len());
            sink.push(Problem::new(ProblemKind::WrongValue, path, message, Some(node.span.clone())));
            None
        }
        _ => {
            sink.push(expected("two numbers [x, y]", path, node));
            None
        }
    }
}

pub(crate) fn read_triple(path: &str, node: &Node, kind: Kind, sink: &Sink) -> Option<[Quantity; 3]> {
    let Value::List(items) = &node.value else {
        sink.push(expected("three numbers [x, y, z]", path, node));
        return None;
    };
    let [x, y, z] = &items[..] else {
        let message = format!("expected three numbers [x, y, z], found {}", items.len());
        sink.push(Problem::new(ProblemKind::WrongValue, path, message, Some(node.span.clone())));
        return None;
    };
    let [x, y, z] = [("x", x), ("y", y), ("z", z)]
        .map(|(axis, item)| read_quantity(&format!("{path}.{axis}"), item, kind, sink));
    Some([x?, y?, z?])
}

/// A quantity from a plain number, a text with a unit, `{ value, sigma }` or `{ low, high }`.
pub(crate) fn read_quantity(path: &str, node: &Node, kind: Kind, sink: &Sink) -> Option<Quantity> {
    let (value, tolerance) = match &node.value {
        Value::Number(number) => (*number, None),
        Value::Text(text) => match quantity::parse(text, kind.dimension) {
            Ok(written) => (written.value, written.tolerance),
            Err(problem) => {
                let message = format!("\"{text}\": {}", problem.in_words(kind.dimension));
                sink.push(Problem::new(ProblemKind::Quantity, path, message, Some(node.span.clone())));
                return None;
            }
        },
        Value::Table(_) => read_distribution(path, node, kind, sink)?,
        _ => {
            sink.push(expected(&kind.dimension.to_string(), path, node));
            return None;
        }
    };
    let quantity = Quantity { value, kind, tolerance, span: Some(node.span.clone()) };
    match out_of_range(path, &quantity) {
        Some(problem) => {
            let plain = matches!(node.value, Value::Number(_)) && kind.dimension == Dimension::Angle;
            let help = "a plain number is in rad: write degrees as \"15 deg\"";
            sink.push(if plain { problem.with_help(help) } else { problem });
            None
        }
        None => match sink.forgotten_unit(path, kind, node) {
            Some(problem) => {
                sink.push(problem);
                None
            }
            None => Some(quantity),
        },
    }
}

fn read_distribution(path: &str, node: &Node, kind: Kind, sink: &Sink) -> Option<(f64, Option<Tolerance>)> {
    let section = Section::new(path, node, sink)?;
    let any = Kind::new(kind.dimension, quantity::Allowed::Any);
    if section.has("low") || section.has("high") {
        let (low, high) = (section.required("low", any), section.required("high", any));
        section.finish();
        let (low, high) = (low?.value, high?.value);
        if low < high {
            return Some((0.5 * (low + high), Some(Tolerance::Uniform { low, high })));
        }
        let message = quantity::QuantityProblem::Order.in_words(kind.dimension);
        sink.push(Problem::new(ProblemKind::OutOfRange, path, message, Some(node.span.clone())));
        return None;
    }
    let value = section.required("value", kind);
    let sigma = section.required("sigma", Kind::new(kind.dimension, quantity::Allowed::Positive));
    section.finish();
    Some((value?.value, Some(Tolerance::Sigma { sigma: sigma?.value })))
}

/// What is wrong with the value of a quantity, or with the ends of its tolerance.
pub(crate) fn out_of_range(path: &str, quantity: &Quantity) -> Option<Problem> {
    let Quantity { value, kind, tolerance, span } = quantity;
    let ends = match tolerance {
        Some(Tolerance::Limits { half_width }) => [value - half_width, value + half_width],
        Some(Tolerance::Uniform { low, high }) => [*low, *high],
        Some(Tolerance::Sigma { .. }) | None => [*value, *value],
    };
    let bad = |value: f64| !kind.holds(value);
    let message = if !value.is_finite() {
        quantity::Allowed::Any.to_string()
    } else if bad(*value) {
        format!("{} {}", kind.dimension.show(*value), kind.rule_for(*value))
    } else if kind.dimension == Dimension::Count && tolerance.is_some() {
        "a whole number has no tolerance".to_owned()
    } else {
        let end = ends.into_iter().find(|end| bad(*end))?;
        format!("its tolerance reaches {}, and it {}", kind.dimension.show(end), kind.rule_for(end))
    };
    Some(Problem::new(ProblemKind::OutOfRange, path, message, span.clone()))
}
