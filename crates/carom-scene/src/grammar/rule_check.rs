//! Holds the keys of a table to a rule: one of several ways to say something.

use super::check::{joined, listed};
use super::{Holds, Inherited, Rule, Table, Way, When};
use crate::node::{Entry, Node, Value};
use crate::problem::{Problem, ProblemKind};

/// True where a condition holds for the keys of a table.
pub(super) fn holds(when: When, entries: &[Entry]) -> bool {
    let value = |key: &str| entries.iter().find(|entry| entry.key == key).map(|entry| &entry.node.value);
    match when {
        When::Always => true,
        When::NoOther => false,
        When::Has(key) => value(key).is_some(),
        When::Any(keys) => keys.iter().any(|key| value(key).is_some()),
        When::Is(key, word) => matches!(value(key), Some(Value::Text(text)) if text == word),
        When::IsOneOf(key, words) => {
            matches!(value(key), Some(Value::Text(text)) if words.contains(&text.as_str()))
        }
        When::IsList(key) => matches!(value(key), Some(Value::List(_))),
        When::InSpace(tables) => {
            let counts: Vec<[usize; 2]> = tables
                .iter()
                .filter_map(|(key, keys)| Some((value(key)?, keys)))
                .flat_map(|(value, keys)| tables_in(value).map(|entries| in_space_and_plane(entries, keys)))
                .collect();
            let sum = |k: usize| counts.iter().map(|count| count[k]).sum::<usize>();
            sum(0) > 0 && sum(0) >= sum(1)
        }
        When::ListsOfThree(table, key) => match value(table) {
            Some(Value::Table(entries)) => {
                let lists = entries.iter().filter(|entry| entry.key == key).map(|entry| &entry.node.value);
                lists.flat_map(items).any(|item| is_triple(&item.value))
            }
            _ => false,
        },
        When::Solid(table) => matches!(value(table), Some(Value::Table(entries)) if is_solid(entries)),
        When::All(conditions) => conditions.iter().all(|when| holds(*when, entries)),
    }
}

/// True of a scene whose part is a solid.
pub(crate) fn shows_a_solid(entries: &[Entry]) -> bool {
    holds(super::scene::IN_SPACE, entries)
}

/// The keys of a part that is a solid.
fn is_solid(entries: &[Entry]) -> bool {
    let value = |key: &str| entries.iter().find(|entry| entry.key == key).map(|entry| &entry.node.value);
    let mesh = |name: &str| name.to_ascii_lowercase().ends_with(".stl");
    match value("shape") {
        Some(shape) => matches!(shape, Value::Text(word) if word == "solid"),
        None => {
            value("box").is_some()
                || value("vertices").is_some_and(|all| items(all).iter().any(|one| is_triple(&one.value)))
                || matches!(value("file"), Some(Value::Text(name)) if mesh(name))
        }
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

/// A table, or each of a list of tables.
fn tables_in(value: &Value) -> impl Iterator<Item = &[Entry]> {
    let own = match value {
        Value::Table(entries) => Some(entries.as_slice()),
        _ => None,
    };
    own.into_iter().chain(items(value).iter().filter_map(|item| match &item.value {
        Value::Table(entries) => Some(entries.as_slice()),
        _ => None,
    }))
}

/// How many of the keys hold a list of three, as in space, and how many a list of two or one quantity, as in the plane.
fn in_space_and_plane(entries: &[Entry], keys: &[&str]) -> [usize; 2] {
    let asked = entries.iter().filter(|entry| keys.contains(&entry.key.as_str()));
    asked.fold([0, 0], |[space, plane], entry| match &entry.node.value {
        value if is_triple(value) => [space + 1, plane],
        Value::Number(_) | Value::Text(_) => [space, plane + 1],
        value if items(value).len() == 2 => [space, plane + 1],
        _ => [space, plane],
    })
}

impl When {
    /// The keys that it looks at.
    pub(super) fn keys(self) -> Vec<&'static str> {
        match self {
            Self::Always | Self::NoOther => vec![],
            Self::Any(keys) => keys.to_vec(),
            Self::Has(key)
            | Self::Is(key, _)
            | Self::IsOneOf(key, _)
            | Self::IsList(key)
            | Self::ListsOfThree(key, _)
            | Self::Solid(key) => vec![key],
            Self::InSpace(tables) => tables.iter().map(|(key, _)| *key).collect(),
            Self::All(conditions) => conditions.iter().flat_map(|when| when.keys()).collect(),
        }
    }

    pub(super) fn in_words(self) -> String {
        match self {
            Self::Is(key, word) => format!("{key} = \"{word}\""),
            Self::IsOneOf(key, words) => {
                let words: Vec<String> = words.iter().map(|word| format!("\"{word}\"")).collect();
                format!("{key} = {}", listed(&words))
            }
            Self::All(conditions) => {
                conditions.iter().map(|when| when.in_words()).collect::<Vec<_>>().join(" and ")
            }
            other => listed(&other.keys()),
        }
    }
}

impl Way {
    pub(super) fn has(&self, key: &str) -> bool {
        self.shown.keys().contains(&key) || self.needs.contains(&key) || self.takes.contains(&key)
    }
}

impl Rule {
    /// Every key that belongs to one of its ways, each once.
    pub(super) fn keys(&self) -> Vec<&'static str> {
        let mut keys = vec![];
        for way in self.ways {
            for key in
                way.shown.keys().into_iter().chain(way.needs.iter().copied()).chain(way.takes.iter().copied())
            {
                if !keys.contains(&key) {
                    keys.push(key);
                }
            }
        }
        keys
    }

    /// The way that is taken where no other is.
    pub(super) fn last_resort(&self) -> Option<&'static Way> {
        self.ways.iter().find(|way| matches!(way.shown, When::NoOther))
    }
}

/// What is wrong with the keys of a table under a rule.
pub(super) fn check(table: &Table, rule: &Rule, path: &str, entries: &[Entry], node: &Node) -> Vec<Problem> {
    if !holds(rule.when, entries) {
        return vec![];
    }
    let taken: Vec<&Way> = rule.ways.iter().filter(|way| holds(way.shown, entries)).collect();
    let (lacking, odd) = match (&taken[..], rule.last_resort()) {
        ([], None) => (vec![], none_taken(rule, path, entries, node)),
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
    rule.ways.iter().any(|way| match way.shown {
        When::Is(key, _) => entries.iter().any(|entry| {
            entry.key == key && !matches!(&entry.node.value, Value::Text(text) if known(key, text))
        }),
        _ => false,
    })
}

/// The keys of a rule that do not belong to the way that is taken; none where no way or several are.
pub(super) fn stray(rule: &Rule, entries: &[Entry]) -> Vec<&'static str> {
    let taken: Vec<&Way> = rule.ways.iter().filter(|way| holds(way.shown, entries)).collect();
    match taken[..] {
        [way] if holds(rule.when, entries) => rule.keys().into_iter().filter(|key| !way.has(key)).collect(),
        _ => vec![],
    }
}

fn none_taken(rule: &Rule, path: &str, entries: &[Entry], node: &Node) -> Vec<Problem> {
    if rule.missing.is_empty() {
        return vec![];
    }
    // One key is missing, or of several ways any.
    let first = rule.ways.first().and_then(|way| way.shown.keys().first().copied()).unwrap_or_default();
    let at = if rule.ways.len() > 2 && !path.is_empty() { path.to_owned() } else { joined(path, first) };
    let span = place_of_missing(rule.when, path, entries, node);
    let message = format!("missing: {}", rule.missing);
    vec![Problem::new(ProblemKind::MissingKey, at, message, span)]
}

fn two_taken(one: &Way, other: &Way, path: &str, entries: &[Entry]) -> Problem {
    let key = other.shown.keys().into_iter().find(|key| entries.iter().any(|entry| entry.key == *key));
    let key = key.unwrap_or_default();
    let message = format!("does not go together with {}: keep one of the two", one.shown.in_words());
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
        let span = place_of_missing(way.shown, path, entries, node);
        lacking.push(Problem::new(ProblemKind::MissingKey, joined(path, key), what, span));
    }
    for key in rule.keys().into_iter().filter(|key| has(key) && !way.has(key)) {
        let (kind, message) = match way.shown {
            When::NoOther => {
                let owners = rule.ways.iter().filter(|other| other.has(key));
                let owners: Vec<String> = owners.map(|other| other.shown.in_words()).collect();
                (ProblemKind::MissingKey, format!("goes with {}, which is missing", listed(&owners)))
            }
            When::Is(..) => (ProblemKind::UnknownKey, format!("does not belong to {}", way.shown.in_words())),
            _ => (ProblemKind::Conflict, format!("does not go together with {}", way.shown.in_words())),
        };
        odd.push(Problem::new(kind, joined(path, key), message, place_of(entries, key)));
    }
    (lacking, odd)
}

/// What is missing where a table neither has a key nor inherits it.
pub(super) fn not_inherited(inherited: &Inherited, entries: &[Entry]) -> Option<Problem> {
    let Inherited { key, or, from, heirs, missing } = *inherited;
    let has = |node: &Node| match &node.value {
        Value::Table(entries) => entries.iter().any(|entry| entry.key == key || entry.key == or),
        // Whatever else it is has a problem of its own.
        _ => true,
    };
    let given = entries.iter().any(|entry| entry.key == from && has(&entry.node));
    let lacks = |entry: &Entry| match &entry.node.value {
        Value::List(items) => !items.iter().all(has),
        _ => !has(&entry.node),
    };
    let takes = |entry: &&Entry| heirs.contains(&entry.key.as_str());
    let lacking = entries.iter().any(|entry| takes(&entry) && lacks(entry));
    (!given && lacking).then(|| {
        let first = entries.iter().find(|entry| entry.key == from);
        let first = first.or_else(|| entries.iter().find(|entry| takes(entry) && lacks(entry)));
        let place = first.map(|entry| match &entry.node.value {
            Value::List(items) => items.iter().find(|item| !has(item)).map_or(&entry.node, |item| item),
            _ => &entry.node,
        });
        let (path, message) = (joined(from, key), format!("missing: {missing}"));
        Problem::new(ProblemKind::MissingKey, path, message, place.map(|node| node.span.clone()))
    })
}

/// The place of a table from which something is missing; at the top of a file that of the key that asks for it.
fn place_of_missing(
    when: When,
    path: &str,
    entries: &[Entry],
    node: &Node,
) -> Option<std::ops::Range<usize>> {
    match path {
        "" => when.keys().into_iter().find_map(|key| place_of(entries, key)),
        _ => Some(node.span.clone()),
    }
}

fn place_of(entries: &[Entry], key: &str) -> Option<std::ops::Range<usize>> {
    entries.iter().find(|entry| entry.key == key).map(|entry| entry.key_span.clone())
}
