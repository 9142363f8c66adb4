//! Reading a table that has been checked: values without a word, since everything wrong with them is told already.

use super::value::quantity;
use super::{Fallback, File, Holds, Key, Table, Tables, check, name_of};
use crate::node::{Entry, Node, Value};
use crate::problem::{Problem, ProblemKind};
use crate::quantity::{Kind, Quantity};
use carom_words::Words;
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

    pub(crate) fn longest_plain(&self) -> Option<f64> {
        self.longest_plain
    }

    pub(crate) fn push(&self, problem: Problem) {
        self.list.borrow_mut().push(problem);
    }

    pub(crate) fn into_list(self) -> Vec<Problem> {
        self.list.into_inner()
    }
}

/// What a reader makes of a file that is held to its grammar; everything that is wrong with it, where anything is.
pub(crate) fn read_checked<T>(
    file: &File,
    tree: &Node,
    read: impl FnOnce(&Section<'_>) -> Option<T>,
) -> Result<T, Vec<Problem>> {
    let sink = Sink::default();
    let table = check(file, tree, &sink);
    let root = table.and_then(|table| Section::new(table, String::new(), tree, &sink));
    let found = root.and_then(|root| read(&root));
    let problems = sink.into_list();
    found.filter(|_| problems.is_empty()).ok_or(problems)
}

/// A table that is read.
pub(crate) struct Section<'t> {
    table: &'static Table,
    path: String,
    entries: &'t [Entry],
    /// Its header or its braces.
    span: Range<usize>,
    sink: &'t Sink,
}

impl<'t> Section<'t> {
    /// A table at a path; `None` where the node is none.
    pub(crate) fn new(table: &'static Table, path: String, node: &'t Node, sink: &'t Sink) -> Option<Self> {
        let Value::Table(entries) = &node.value else { return None };
        Some(Self { table, path, entries, span: node.span.clone(), sink })
    }

    pub(crate) fn path(&self) -> &str {
        &self.path
    }

    pub(crate) fn span(&self) -> Range<usize> {
        self.span.clone()
    }

    /// The path of a key of this table.
    pub(crate) fn path_of(&self, key: &str) -> String {
        super::check::joined(&self.path, key)
    }

    /// True where the grammar of this table has the key.
    pub(crate) fn knows(&self, key: &str) -> bool {
        self.table.key(key).is_some()
    }

    /// As [`Section::section`], of a key that only some tables of its kind have.
    pub(crate) fn section_if_known(&self, key: &str) -> Option<Section<'t>> {
        self.knows(key).then(|| self.section(key)).flatten()
    }

    /// As [`Section::quantity_or_default`], of a key that only some tables of its kind have.
    pub(crate) fn quantity_if_known(&self, key: &str) -> Option<Quantity> {
        self.knows(key).then(|| self.quantity_or_default(key)).flatten()
    }

    pub(crate) fn has(&self, key: &str) -> bool {
        self.entries.iter().any(|entry| entry.key == key)
    }

    pub(crate) fn get(&self, key: &str) -> Option<&'t Node> {
        self.entries.iter().find(|entry| entry.key == key).map(|entry| &entry.node)
    }

    /// Place of a key, or of the table where the key is missing.
    pub(crate) fn key_span(&self, key: &str) -> Range<usize> {
        let entry = self.entries.iter().find(|entry| entry.key == key);
        entry.map_or_else(|| self.span(), |entry| entry.key_span.clone())
    }

    /// Says what is wrong with a key; its place is the table where it is not written, and none where that is the whole file.
    pub(crate) fn blame(&self, kind: ProblemKind, key: &str, message: impl Into<String>) {
        let placed = self.has(key) || !self.path.is_empty();
        let span = placed.then(|| self.key_span(key));
        self.push(Problem::new(kind, self.path_of(key), message, span));
    }

    /// Says what is wrong with the value of a key.
    pub(crate) fn blame_value(&self, kind: ProblemKind, key: &str, message: impl Into<String>) {
        let span = self.get(key).map(|node| node.span.clone());
        self.push(Problem::new(kind, self.path_of(key), message, span));
    }

    pub(crate) fn push(&self, problem: Problem) {
        self.sink.push(problem);
    }

    /// What the grammar says of a key.
    fn known(&self, key: &str) -> Option<&'static Key> {
        let known = self.table.key(key);
        debug_assert!(known.is_some(), "the grammar of {} knows no {key}", self.table.name);
        known
    }

    /// The kind of the quantities that a key holds.
    fn kind(&self, key: &str) -> Option<Kind> {
        self.known(key).and_then(|known| kind_of(&known.holds))
    }

    pub(crate) fn section(&self, key: &str) -> Option<Section<'t>> {
        let node = self.get(key)?;
        let table = match (&self.known(key)?.holds, &node.value) {
            (Holds::Table(table), _) => table,
            (Holds::Either(choices), _) => choices.iter().find_map(|choice| match choice {
                Holds::Table(table) => Some(*table),
                _ => None,
            })?,
            (Holds::Variant(variants), Value::Table(entries)) => super::check::variant(variants, entries),
            _ => return None,
        };
        Section::new(table, self.path_of(key), node, self.sink)
    }

    /// The tables of `[[key]]`; `None` in place of what is none.
    pub(crate) fn sections(&self, key: &str) -> Vec<Option<Section<'t>>> {
        let Some(Holds::Tables(tables)) = self.known(key).map(|known| &known.holds) else { return vec![] };
        let Some(Value::List(items)) = self.get(key).map(|node| &node.value) else { return vec![] };
        let Tables { of, named, .. } = tables;
        let name = |node, i: usize| if *named { name_of(node, i) } else { i.to_string() };
        let section =
            |(i, node)| Section::new(of, format!("{}.{}", self.path_of(key), name(node, i)), node, self.sink);
        items.iter().enumerate().map(section).collect()
    }

    /// A good quantity.
    pub(crate) fn quantity(&self, key: &str) -> Option<Quantity> {
        let (node, kind) = (self.get(key)?, self.kind(key)?);
        self.read(node, kind)
    }

    /// A quantity, or what counts where there is no good one.
    pub(crate) fn quantity_or_default(&self, key: &str) -> Option<Quantity> {
        let default = || match self.known(key)?.fallback? {
            Fallback::Number(number) => Some(Quantity::default_of(number, self.kind(key)?)),
            Fallback::Word(_) => None,
        };
        self.quantity(key).or_else(default)
    }

    /// The value of a good quantity, SI.
    pub(crate) fn value(&self, key: &str) -> Option<f64> {
        self.quantity(key).map(|quantity| quantity.value)
    }

    /// The value of a key that has a default: its own or that, SI.
    pub(crate) fn number(&self, key: &str) -> f64 {
        let found = self.quantity_or_default(key);
        debug_assert!(found.is_some(), "{key} of {} has no default", self.table.name);
        found.map_or(0.0, |quantity| quantity.value)
    }

    /// True where a key is written and what it holds is bad.
    pub(crate) fn is_bad(&self, key: &str) -> bool {
        let Some(node) = self.get(key) else { return false };
        let unreadable = |kind: Kind| match &node.value {
            Value::List(items) => items.iter().any(|item| self.read(item, kind).is_none()),
            _ => self.read(node, kind).is_none(),
        };
        self.kind(key).is_some_and(unreadable)
    }

    fn read(&self, node: &Node, kind: Kind) -> Option<Quantity> {
        quantity("", node, kind, self.sink.longest_plain).ok()
    }

    pub(crate) fn text(&self, key: &str) -> Option<(&'t str, Range<usize>)> {
        let node = self.get(key)?;
        match &node.value {
            Value::Text(text) => Some((text, node.span.clone())),
            _ => None,
        }
    }

    /// True where it is written so.
    pub(crate) fn flag(&self, key: &str) -> bool {
        matches!(self.get(key).map(|node| &node.value), Some(Value::Bool(true)))
    }

    /// What a word stands for.
    pub(crate) fn word<T: Words>(&self, key: &str) -> Option<T> {
        let (text, _) = self.text(key)?;
        T::of_word(text)
    }

    /// What a word stands for, or the word that counts where there is no good one.
    pub(crate) fn word_or_default<T: Words>(&self, key: &str) -> T {
        let default = || {
            let word = match self.known(key).and_then(|known| known.fallback) {
                Some(Fallback::Word(word)) => word,
                _ => "",
            };
            T::of_word(word)
        };
        self.word(key).or_else(default).unwrap_or(T::ALL[0])
    }

    /// The quantities of a vector of `N`, or of a point.
    pub(crate) fn vector<const N: usize>(&self, key: &str) -> Option<[Quantity; N]> {
        self.vector_of(self.get(key)?, self.kind(key)?)
    }

    fn vector_of<const N: usize>(&self, node: &Node, kind: Kind) -> Option<[Quantity; N]> {
        let items: Vec<&Node> = match &node.value {
            Value::List(items) => items.iter().collect(),
            Value::Table(entries) => {
                let of = |axis: &str| entries.iter().find(|entry| entry.key == axis).map(|entry| &entry.node);
                vec![of("x")?, of("y")?]
            }
            _ => return None,
        };
        let read: Vec<Quantity> =
            items.into_iter().map(|item| self.read(item, kind)).collect::<Option<_>>()?;
        read.try_into().ok()
    }

    /// The values of a list, SI.
    pub(crate) fn values(&self, key: &str) -> Option<Vec<f64>> {
        self.values_of(self.get(key)?, self.kind(key)?)
    }

    fn values_of(&self, node: &Node, kind: Kind) -> Option<Vec<f64>> {
        let Value::List(items) = &node.value else { return None };
        items.iter().map(|item| self.read(item, kind).map(|quantity| quantity.value)).collect()
    }

    /// The values of a list of lists, SI.
    pub(crate) fn rows(&self, key: &str) -> Option<Vec<Vec<f64>>> {
        let kind = self.kind(key)?;
        let Value::List(rows) = &self.get(key)?.value else { return None };
        rows.iter().map(|row| self.values_of(row, kind)).collect()
    }

    /// The vectors and tables of a list that may hold both.
    pub(crate) fn mixed<const N: usize>(&self, key: &str) -> Option<Vec<Mixed<'t, N>>> {
        let table = table_within(&self.known(key)?.holds)?;
        let (kind, path) = (self.kind(key)?, self.path_of(key));
        let Value::List(items) = &self.get(key)?.value else { return None };
        let item = |(i, node): (usize, &'t Node)| match &node.value {
            Value::Table(_) => Section::new(table, format!("{path}.{i}"), node, self.sink).map(Mixed::Table),
            _ => self.vector_of(node, kind).map(Mixed::Vector),
        };
        items.iter().enumerate().map(item).collect()
    }

    /// The vectors of a list.
    pub(crate) fn vectors<const N: usize>(&self, key: &str) -> Option<Vec<[Quantity; N]>> {
        let kind = self.kind(key)?;
        let Value::List(items) = &self.get(key)?.value else { return None };
        items.iter().map(|item| self.vector_of(item, kind)).collect()
    }
}

/// The table that a list or a choice may hold.
fn table_within(holds: &Holds) -> Option<&'static Table> {
    match holds {
        Holds::Table(table) => Some(table),
        Holds::List { of, .. } => table_within(of),
        Holds::Either(choices) => choices.iter().find_map(table_within),
        _ => None,
    }
}

/// One of a list that may hold vectors and tables.
pub(crate) enum Mixed<'t, const N: usize> {
    Vector([Quantity; N]),
    Table(Section<'t>),
}

/// The kind of the quantities in what a key holds.
fn kind_of(holds: &Holds) -> Option<Kind> {
    match holds {
        Holds::Quantity(kind) | Holds::Number(kind) | Holds::Vector(kind, _) | Holds::Point(kind) => {
            Some(*kind)
        }
        Holds::List { of, .. } => kind_of(of),
        Holds::Either(choices) => choices.iter().find_map(kind_of),
        Holds::Text
        | Holds::Flag
        | Holds::Words(_)
        | Holds::Named(..)
        | Holds::Table(_)
        | Holds::Variant(_)
        | Holds::Tables(_)
        | Holds::Ranges => None,
    }
}
