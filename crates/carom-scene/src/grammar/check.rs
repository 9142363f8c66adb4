//! Holds a file to its grammar: everything that is wrong with its form and with single values, in one walk.

use super::recognise;
use super::rule_check;
use super::section::Sink;
use super::value::{expected, missing, quantity};
use super::{File, Foreign, Holds, Key, Rule, Table, Tables, Variants, When};
use crate::node::{Entry, Node, Value};
use crate::problem::{Problem, ProblemKind};
use crate::quantity::Kind;
use crate::suggest::{likest, nearest};

/// Checks a file. The table that describes it; `None` where it is a file of another kind, or no table at all.
pub(crate) fn check(file: &File, tree: &Node, sink: &Sink) -> Option<&'static Table> {
    let Value::Table(entries) = &tree.value else {
        sink.push(expected("a table", "", tree));
        return None;
    };
    let table = variant(file.variants, entries);
    if let Some(problem) = recognise::other_kind(file, entries) {
        sink.push(problem);
        return None;
    }
    Walk { sink }.table(table, "", tree, &[]);
    Some(table)
}

/// The table that describes what is written: the last where the condition of none holds.
pub(crate) fn variant(variants: Variants, entries: &[Entry]) -> &'static Table {
    let holds = |(when, _): &&(When, &'static Table)| rule_check::holds(*when, entries);
    let found = variants.iter().find(holds).or(variants.last());
    found.map_or(&EMPTY, |(_, table)| table)
}

/// A file that may hold nothing.
static EMPTY: Table = Table::plain("", "", &[]);

struct Walk<'s> {
    sink: &'s Sink,
}

impl Walk<'_> {
    fn push(&self, kind: ProblemKind, path: impl Into<String>, message: impl Into<String>, node: &Node) {
        self.sink.push(Problem::new(kind, path, message, Some(node.span.clone())));
    }

    /// A table, with rules that hold for it where it stands.
    fn table(&self, table: &'static Table, path: &str, node: &Node, rules: &[Rule]) {
        let Value::Table(entries) = &node.value else {
            self.sink.push(expected("a table", path, node));
            return;
        };
        for entry in entries {
            let place = joined(path, &entry.key);
            match table.key(&entry.key) {
                Some(key) => self.value(&key.holds, &place, &entry.node),
                None => self.sink.push(unknown(table, rules, path, (entries, entry))),
            }
        }
        // What is missing from the whole file has no place in it.
        let place = (!path.is_empty()).then(|| node.span.clone());
        for key in table.all_keys().filter(|key| key.needed) {
            if !entries.iter().any(|entry| entry.key == key.name) {
                let problem = Problem::new(
                    ProblemKind::MissingKey,
                    joined(path, key.name),
                    missing_key(key),
                    place.clone(),
                );
                self.sink.push(problem);
            }
        }
        let broken = table.rules.iter().chain(rules);
        let broken = broken.flat_map(|rule| rule_check::check(table, rule, path, entries, node));
        broken.for_each(|problem| self.sink.push(problem));
        let missing =
            table.inherited.iter().filter_map(|inherited| rule_check::not_inherited(inherited, entries));
        missing.for_each(|problem| self.sink.push(problem));
    }

    fn value(&self, holds: &Holds, path: &str, node: &Node) {
        match holds {
            Holds::Quantity(kind) => self.quantity(path, node, *kind),
            Holds::Number(kind) => match node.value {
                Value::Number(_) => self.quantity(path, node, *kind),
                _ => self.sink.push(expected(&in_words(holds), path, node)),
            },
            Holds::Vector(kind, count) => self.vector(holds, path, node, *kind, *count),
            Holds::Point(kind) => match &node.value {
                Value::Table(_) => self.named_point(path, node, *kind),
                _ => self.vector(holds, path, node, *kind, 2),
            },
            Holds::List { of, least, most, .. } => self.list(holds, path, node, of, (*least, *most)),
            Holds::Text => {
                if !matches!(node.value, Value::Text(_)) {
                    self.sink.push(expected("a text", path, node));
                }
            }
            Holds::Flag => {
                if !matches!(node.value, Value::Bool(_)) {
                    self.sink.push(expected("true or false", path, node));
                }
            }
            Holds::Named(names, called) => self.named(path, node, &names(), called),
            Holds::Words(words) => self.word(path, node, &words()),
            // The type decides which of several is meant, so that the problem told is one of what was meant.
            Holds::Either(choices) => match choices.iter().find(|choice| is_of_type(choice, &node.value)) {
                Some(choice) => self.value(choice, path, node),
                None => self.sink.push(expected(&in_words(holds), path, node)),
            },
            Holds::Table(table) => self.table(table, path, node, &[]),
            Holds::Variant(variants) => match &node.value {
                Value::Table(entries) => self.table(variant(variants, entries), path, node, &[]),
                _ => self.sink.push(expected("a table", path, node)),
            },
            Holds::Tables(tables) => self.tables(tables, path, node),
            Holds::Ranges => self.ranges(path, node),
        }
    }

    fn quantity(&self, path: &str, node: &Node, kind: Kind) {
        if let Err(problems) = quantity(path, node, kind, self.sink.longest_plain()) {
            problems.into_iter().for_each(|problem| self.sink.push(problem));
        }
    }

    fn vector(&self, holds: &Holds, path: &str, node: &Node, kind: Kind, count: usize) {
        match &node.value {
            Value::List(items) if items.len() == count => {
                for (axis, item) in ["x", "y", "z"].iter().zip(items) {
                    self.quantity(&format!("{path}.{axis}"), item, kind);
                }
            }
            Value::List(items) => {
                let message = format!("expected {}, found {}", in_words(holds), items.len());
                let problem = Problem::new(ProblemKind::WrongValue, path, message, Some(node.span.clone()));
                // Whoever writes two numbers here thinks of the plane.
                self.sink.push(match (count, items.len()) {
                    (3, 2) => problem
                        .with_help("the file mixes plane and space: in space a vector has three numbers"),
                    (2, 3) => problem.with_help("this file is in the plane, where a vector has two numbers"),
                    _ => problem,
                });
            }
            _ => self.sink.push(expected(&in_words(holds), path, node)),
        }
    }

    /// `{ x, y }`.
    fn named_point(&self, path: &str, node: &Node, kind: Kind) {
        let Value::Table(entries) = &node.value else { return };
        for entry in entries {
            let place = joined(path, &entry.key);
            if ["x", "y"].contains(&entry.key.as_str()) {
                self.quantity(&place, &entry.node, kind);
            } else {
                let message = format!("unknown key; [{path}] has x, y");
                let span = Some(entry.key_span.clone());
                self.sink.push(Problem::new(ProblemKind::UnknownKey, place, message, span));
            }
        }
        for axis in ["x", "y"].into_iter().filter(|axis| entries.iter().all(|entry| entry.key != *axis)) {
            self.push(ProblemKind::MissingKey, joined(path, axis), missing(kind), node);
        }
    }

    fn list(&self, holds: &Holds, path: &str, node: &Node, of: &Holds, (least, most): (usize, usize)) {
        let Value::List(items) = &node.value else {
            self.sink.push(expected(&in_words(holds), path, node));
            return;
        };
        for (i, item) in items.iter().enumerate() {
            self.value(of, &format!("{path}.{i}"), item);
        }
        let count = items.len();
        if least == most && count != least {
            let message = format!("expected {}, found {count}", in_words(holds));
            self.push(ProblemKind::WrongValue, path, message, node);
        } else if count < least {
            let message = format!("expected {}, at least {least}; found {count}", in_words(holds));
            self.push(ProblemKind::WrongValue, path, message, node);
        } else if count > most {
            let message = format!("expected {}, at most {most}; found {count}", in_words(holds));
            self.push(ProblemKind::WrongValue, path, message, node);
        }
    }

    fn word(&self, path: &str, node: &Node, words: &[&str]) {
        let Value::Text(text) = &node.value else {
            self.sink.push(expected("a text", path, node));
            return;
        };
        if !words.contains(&text.as_str()) {
            let message = format!("\"{text}\" is none of {}", words.join(", "));
            let problem = Problem::new(ProblemKind::WrongValue, path, message, Some(node.span.clone()));
            self.sink.push(meant(problem.with_allowed(words), text, words));
        }
    }

    /// A name of a table: of many names the nearest are told, not all.
    fn named(&self, path: &str, node: &Node, names: &[&str], called: &str) {
        let Value::Text(text) = &node.value else {
            self.sink.push(expected(called, path, node));
            return;
        };
        if !names.contains(&text.as_str()) {
            let near: Vec<String> = likest(text, names).iter().map(|name| format!("\"{name}\"")).collect();
            let message = format!("\"{text}\" is the name of no {called}; the nearest are {}", listed(&near));
            let problem = Problem::new(ProblemKind::WrongValue, path, message, Some(node.span.clone()));
            self.sink.push(problem.with_allowed(names));
        }
    }

    fn tables(&self, tables: &Tables, path: &str, node: &Node) {
        let Value::List(items) = &node.value else {
            let help = format!("write [[{path}]] with two brackets: there may be several");
            self.sink.push(expected("a list of tables", path, node).with_help(help));
            return;
        };
        if items.len() < tables.least {
            self.push(
                ProblemKind::WrongValue,
                path,
                format!("is empty: there must be at least one [[{path}]]"),
                node,
            );
        }
        if items.len() > tables.most {
            let message = format!("there may be at most {}, found {}", tables.most, items.len());
            self.push(ProblemKind::WrongValue, path, message, node);
        }
        for (i, item) in items.iter().enumerate() {
            let place = format!("{path}.{}", if tables.named { name_of(item, i) } else { i.to_string() });
            self.table(tables.of, &place, item, if i == 0 { tables.first } else { tables.later });
        }
    }

    /// Paths with ranges; a path may be written with quotes or as tables in tables.
    fn ranges(&self, path: &str, node: &Node) {
        let Value::Table(entries) = &node.value else {
            self.sink.push(expected(&in_words(&Holds::Ranges), path, node));
            return;
        };
        for entry in entries {
            let place = format!("{path}.{}", entry.key);
            match &entry.node.value {
                Value::Text(_) => {}
                Value::Table(_) => self.ranges(&place, &entry.node),
                _ => self.sink.push(expected("a range like \"10..40 deg\"", &place, &entry.node)),
            }
        }
    }
}

/// A path with one key more.
pub(super) fn joined(path: &str, key: &str) -> String {
    if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") }
}

/// True of names that can stand in paths like `plate.lower.slope`.
pub(crate) fn can_stand_in_paths(name: &str) -> bool {
    !name.contains(['.', '"', '=', '\n'])
}

/// The name by which a table of a list goes in paths: its own, or its number where it has none that can stand in a path.
pub(crate) fn name_of(node: &Node, number: usize) -> String {
    let Value::Table(entries) = &node.value else { return number.to_string() };
    let name = entries.iter().find(|entry| entry.key == "name").map(|entry| &entry.node.value);
    match name {
        Some(Value::Text(name)) if !name.is_empty() && can_stand_in_paths(name) => name.clone(),
        _ => number.to_string(),
    }
}

/// What is said of a key that is missing: what it holds, and what it means.
pub(super) fn missing_key(key: &Key) -> String {
    match (key.missing, &key.holds) {
        ("", Holds::Quantity(kind)) => missing(*kind),
        // A vector alone does not say what it is of.
        ("", holds @ (Holds::Vector(..) | Holds::Point(_))) => {
            format!("missing: {}, {}", in_words(holds), first_sentence(key.about))
        }
        ("", holds) => format!("missing: {}", in_words(holds)),
        (words, _) => format!("missing: {words}"),
    }
}

/// `velocity of the mass centre` of "Velocity of the mass centre. It …": what goes on another sentence.
fn first_sentence(about: &str) -> String {
    let first = about.split(". ").next().unwrap_or_default().trim_end_matches('.');
    let mut letters = first.chars();
    letters.next().map_or(String::new(), |letter| letter.to_lowercase().chain(letters).collect())
}

fn unknown(table: &Table, rules: &[Rule], path: &str, (entries, entry): (&[Entry], &Entry)) -> Problem {
    let foreign = table.foreign.iter().find(|foreign| foreign.keys.contains(&entry.key.as_str()));
    if let Some(foreign) = foreign {
        return foreign_problem(foreign, joined(path, &entry.key), entry);
    }
    // Keys of a way that is not taken would only mislead.
    let rules = table.rules.iter().chain(rules);
    let stray: Vec<&str> = rules.flat_map(|rule| rule_check::stray(rule, entries)).collect();
    let mut allowed: Vec<&str> = table.all_keys().map(|key| key.name).collect();
    allowed.retain(|key| !stray.contains(key));
    allowed.sort_unstable();
    let place = if path.is_empty() { "the file".to_owned() } else { format!("[{path}]") };
    let message = format!("unknown key; {place} has {}", allowed.join(", "));
    let span = Some(entry.key_span.clone());
    let problem = Problem::new(ProblemKind::UnknownKey, joined(path, &entry.key), message, span);
    meant(problem.with_allowed(&allowed), &entry.key, &allowed)
}

fn foreign_problem(foreign: &Foreign, path: String, entry: &Entry) -> Problem {
    let problem = Problem::new(foreign.kind, path, foreign.message, Some(entry.key_span.clone()));
    if foreign.help.is_empty() { problem } else { problem.with_help(foreign.help) }
}

fn meant(problem: Problem, word: &str, allowed: &[&str]) -> Problem {
    match nearest(word, allowed) {
        Some(near) => problem.with_help(format!("did you mean \"{near}\"?")),
        None => problem,
    }
}

/// True where a value is of the type that is held, whatever else may be wrong with it.
pub(crate) fn is_of_type(holds: &Holds, value: &Value) -> bool {
    match holds {
        Holds::Quantity(_) => matches!(value, Value::Number(_) | Value::Text(_) | Value::Table(_)),
        Holds::Number(_) => matches!(value, Value::Number(_)),
        Holds::Vector(..) | Holds::List { .. } | Holds::Tables(_) => matches!(value, Value::List(_)),
        Holds::Point(_) => matches!(value, Value::List(_) | Value::Table(_)),
        Holds::Text | Holds::Words(_) | Holds::Named(..) => matches!(value, Value::Text(_)),
        Holds::Flag => matches!(value, Value::Bool(_)),
        Holds::Either(choices) => choices.iter().any(|choice| is_of_type(choice, value)),
        Holds::Table(_) | Holds::Variant(_) | Holds::Ranges => matches!(value, Value::Table(_)),
    }
}

/// What a key holds, for saying that something else was found.
pub(super) fn in_words(holds: &Holds) -> String {
    match holds {
        Holds::Quantity(kind) | Holds::Number(kind) => kind.dimension.to_string(),
        Holds::Vector(_, 3) => "three numbers [x, y, z]".to_owned(),
        Holds::Vector(..) | Holds::Point(_) => "two numbers [x, y]".to_owned(),
        Holds::List { called, .. } => (*called).to_owned(),
        Holds::Text => "a text".to_owned(),
        Holds::Named(_, called) => format!("the name of a {called}"),
        Holds::Flag => "true or false".to_owned(),
        Holds::Words(words) => listed(&words()),
        Holds::Either(choices) => listed(&choices.iter().map(in_words).collect::<Vec<_>>()),
        Holds::Table(_) | Holds::Variant(_) => "a table".to_owned(),
        Holds::Tables(_) => "a list of tables".to_owned(),
        Holds::Ranges => "a table { \"path\" = \"low..high unit\" }".to_owned(),
    }
}

/// `a, b or c`.
pub(super) fn listed(words: &[impl AsRef<str>]) -> String {
    let words: Vec<&str> = words.iter().map(AsRef::as_ref).collect();
    match words.split_last() {
        None => String::new(),
        Some((last, [])) => (*last).to_owned(),
        Some((last, others)) => format!("{} or {last}", others.join(", ")),
    }
}
