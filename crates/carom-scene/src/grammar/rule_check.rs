//! Holds the keys of a table to a rule: one of several ways to say something.

use super::check::{joined, listed};
use super::{By, Holds, Inherited, Rule, Table, Way};
use crate::node::{Entry, Node, Value};
use crate::problem::{Problem, ProblemKind};

/// True where a condition holds for the keys of a table.
pub(super) fn holds(by: By, entries: &[Entry]) -> bool {
    let value = |key: &str| entries.iter().find(|entry| entry.key == key).map(|entry| &entry.node.value);
    match by {
        By::Always => true,
        By::Otherwise => false,
        By::Has(key) => value(key).is_some(),
        By::Any(keys) => keys.iter().any(|key| value(key).is_some()),
        By::Is(key, word) => matches!(value(key), Some(Value::Text(text)) if text == word),
        By::IsList(key) => matches!(value(key), Some(Value::List(_))),
        By::InSpace(tables) => tables.iter().any(|(key, keys)| match value(key) {
            Some(Value::Table(entries)) => has_triple(entries, keys),
            Some(Value::List(items)) => items.iter().any(|item| match &item.value {
                Value::Table(entries) => has_triple(entries, keys),
                _ => false,
            }),
            _ => false,
        }),
        By::ListsOfThree(table, key) => match value(table) {
            Some(Value::Table(entries)) => {
                let lists = entries.iter().filter(|entry| entry.key == key).map(|entry| &entry.node.value);
                lists.flat_map(items).any(|item| is_triple(&item.value))
            }
            _ => false,
        },
        By::All(conditions) => conditions.iter().all(|by| holds(*by, entries)),
    }
}

fn items(value: &Value) -> &[Node] {
    match value {
        Value::List(items) => items,
        _ => &[],
    }
}

fn is_triple(value: &Value) -> bool {
    items(value).len() == 3
}

/// True where one of the keys holds a list of three.
fn has_triple(entries: &[Entry], keys: &[&str]) -> bool {
    entries.iter().any(|entry| keys.contains(&entry.key.as_str()) && is_triple(&entry.node.value))
}

impl By {
    /// The keys that it looks at.
    pub(super) fn keys(self) -> Vec<&'static str> {
        match self {
            Self::Always | Self::Otherwise => vec![],
            Self::Any(keys) => keys.to_vec(),
            Self::Has(key) | Self::Is(key, _) | Self::IsList(key) | Self::ListsOfThree(key, _) => vec![key],
            Self::InSpace(tables) => tables.iter().map(|(key, _)| *key).collect(),
            Self::All(conditions) => conditions.iter().flat_map(|by| by.keys()).collect(),
        }
    }

    pub(super) fn in_words(self) -> String {
        match self {
            Self::Is(key, word) => format!("{key} = \"{word}\""),
            other => listed(&other.keys()),
        }
    }
}

impl Way {
    pub(super) fn has(&self, key: &str) -> bool {
        self.by.keys().contains(&key) || self.needs.contains(&key) || self.takes.contains(&key)
    }
}

impl Rule {
    /// Every key that belongs to one of its ways, each once.
    pub(super) fn keys(&self) -> Vec<&'static str> {
        let mut keys = vec![];
        for way in self.ways {
            for key in
                way.by.keys().into_iter().chain(way.needs.iter().copied()).chain(way.takes.iter().copied())
            {
                if !keys.contains(&key) {
                    keys.push(key);
                }
            }
        }
        keys
    }

    /// The way that is taken where no other is.
    pub(super) fn otherwise(&self) -> Option<&'static Way> {
        self.ways.iter().find(|way| matches!(way.by, By::Otherwise))
    }
}

/// What is wrong with the keys of a table under a rule.
pub(super) fn check(table: &Table, rule: &Rule, path: &str, entries: &[Entry], node: &Node) -> Vec<Problem> {
    if !holds(rule.when, entries) {
        return vec![];
    }
    let taken: Vec<&Way> = rule.ways.iter().filter(|way| holds(way.by, entries)).collect();
    let (lacking, odd) = match (&taken[..], rule.otherwise()) {
        ([], None) => (vec![], none_taken(rule, path, node)),
        ([], Some(_)) if has_unknown_word(table, rule, entries) => return vec![],
        ([], Some(way)) => one_taken(table, rule, way, path, (entries, node)),
        ([way], _) => one_taken(table, rule, way, path, (entries, node)),
        ([one, others @ ..], _) => {
            (vec![], others.iter().map(|other| two_taken(one, other, path, entries)).collect())
        }
    };
    let helped = |problem: Problem| match rule.help {
        "" => problem,
        help => problem.with_help(help),
    };
    lacking.into_iter().chain(odd.into_iter().map(helped)).collect()
}

/// True where a key that would show a way holds no word that it may hold: which way is meant is then unknown.
fn has_unknown_word(table: &Table, rule: &Rule, entries: &[Entry]) -> bool {
    let known = |key: &str, text: &str| match table.key(key).map(|key| &key.holds) {
        Some(Holds::Words(words)) => words().contains(&text),
        _ => true,
    };
    rule.ways.iter().any(|way| match way.by {
        By::Is(key, _) => entries.iter().any(|entry| {
            entry.key == key && !matches!(&entry.node.value, Value::Text(text) if known(key, text))
        }),
        _ => false,
    })
}

/// The keys of a rule that do not belong to the way that is taken; none where no way or several are.
pub(super) fn stray(rule: &Rule, entries: &[Entry]) -> Vec<&'static str> {
    let taken: Vec<&Way> = rule.ways.iter().filter(|way| holds(way.by, entries)).collect();
    match taken[..] {
        [way] if holds(rule.when, entries) => rule.keys().into_iter().filter(|key| !way.has(key)).collect(),
        _ => vec![],
    }
}

fn none_taken(rule: &Rule, path: &str, node: &Node) -> Vec<Problem> {
    if rule.missing.is_empty() {
        return vec![];
    }
    // One key is missing, or of several ways any.
    let first = rule.ways.first().and_then(|way| way.by.keys().first().copied()).unwrap_or_default();
    let at = if rule.ways.len() > 2 && !path.is_empty() { path.to_owned() } else { joined(path, first) };
    let span = (!path.is_empty()).then(|| node.span.clone());
    let message = format!("missing: {}", rule.missing);
    vec![Problem::new(ProblemKind::MissingKey, at, message, span)]
}

fn two_taken(one: &Way, other: &Way, path: &str, entries: &[Entry]) -> Problem {
    let key = other.by.keys().into_iter().find(|key| entries.iter().any(|entry| entry.key == *key));
    let key = key.unwrap_or_default();
    let message = format!("does not go together with {}: keep one of the two", one.by.in_words());
    Problem::new(ProblemKind::Conflict, joined(path, key), message, place_of(entries, key))
}

/// What a way lacks, and what does not belong to it.
fn one_taken(
    table: &Table,
    rule: &Rule,
    way: &Way,
    path: &str,
    (entries, node): (&[Entry], &Node),
) -> (Vec<Problem>, Vec<Problem>) {
    let has = |key: &str| entries.iter().any(|entry| entry.key == key);
    let (mut lacking, mut odd) = (vec![], vec![]);
    for key in way.needs.iter().filter(|key| !has(key)) {
        let what = table.key(key).map_or(String::new(), super::check::missing_key);
        let span = (!path.is_empty()).then(|| node.span.clone());
        lacking.push(Problem::new(ProblemKind::MissingKey, joined(path, key), what, span));
    }
    for key in rule.keys().into_iter().filter(|key| has(key) && !way.has(key)) {
        let (kind, message) = match way.by {
            By::Otherwise => {
                let owners = rule.ways.iter().filter(|other| other.has(key));
                let owners: Vec<String> = owners.map(|other| other.by.in_words()).collect();
                (ProblemKind::MissingKey, format!("goes with {}, which is missing", listed(&owners)))
            }
            By::Is(..) => (ProblemKind::UnknownKey, format!("does not belong to {}", way.by.in_words())),
            _ => (ProblemKind::Conflict, format!("does not go together with {}", way.by.in_words())),
        };
        odd.push(Problem::new(kind, joined(path, key), message, place_of(entries, key)));
    }
    (lacking, odd)
}

/// What is missing where a table neither has a key nor inherits it.
pub(super) fn not_inherited(inherited: &Inherited, entries: &[Entry]) -> Option<Problem> {
    let Inherited { key, from, by, missing } = *inherited;
    let has = |node: &Node| match &node.value {
        Value::Table(entries) => entries.iter().any(|entry| entry.key == key),
        // Whatever else it is has a problem of its own.
        _ => true,
    };
    let given = entries.iter().any(|entry| entry.key == from && has(&entry.node));
    let lacks = |entry: &Entry| match &entry.node.value {
        Value::List(items) => !items.iter().all(has),
        _ => !has(&entry.node),
    };
    let lacking = entries.iter().any(|entry| by.contains(&entry.key.as_str()) && lacks(entry));
    (!given && lacking).then(|| {
        Problem::new(ProblemKind::MissingKey, joined(from, key), format!("missing: {missing}"), None)
    })
}

fn place_of(entries: &[Entry], key: &str) -> Option<std::ops::Range<usize>> {
    entries.iter().find(|entry| entry.key == key).map(|entry| entry.key_span.clone())
}
