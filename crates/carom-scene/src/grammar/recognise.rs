//! Which kind of file stands before a reader: one that belongs to another command is told so in one line.

use super::check::listed;
use super::roll::{CYLINDER_FILE, PRISM_FILE, ROD_FILE};
use super::roll_space::{BODY_FILE, PYRAMID_FILE, STOOL_FILE};
use super::value::{NORMAL, UNIFORM};
use super::{File, FileKind};
use crate::node::{Entry, Value};
use crate::problem::{Problem, ProblemKind};

/// Tables at the top of a scene that no other file has.
const OF_SCENES: &[&str] = &["part", "plate", "zigzag", "start", "channel"];
/// Tables at the top of an impact that no other file has.
const OF_IMPACTS: &[&str] = &["body", "operator"];
/// What rolls, with its file: keys at the top are all that it has.
const ROLLS: [(&str, &File); 6] = [
    ("cylinder", &CYLINDER_FILE),
    ("prism", &PRISM_FILE),
    ("rod", &ROD_FILE),
    ("pyramid", &PYRAMID_FILE),
    ("stool", &STOOL_FILE),
    ("body", &BODY_FILE),
];

/// That a file is of another kind than the one that is read, and which command takes it.
pub(super) fn other_kind(file: &File, entries: &[Entry]) -> Option<Problem> {
    let first = |keys: &[&str]| entries.iter().find(|entry| keys.contains(&entry.key.as_str()));
    let (scene, impact) = (first(OF_SCENES), first(OF_IMPACTS));
    // What has tables of its own kind is of that kind, whatever else stands in it.
    let (shows, is, takes) = match file.kind {
        FileKind::Scene if scene.is_some() => return None,
        FileKind::Impact if impact.is_some() => return None,
        _ => match (scene, impact) {
            (Some(shows), _) => (shows, "a scene", "`carom run` runs it".to_owned()),
            (None, Some(shows)) => (shows, "an impact", "`carom impact` resolves it".to_owned()),
            (None, None) => {
                let (shows, kinds) = roll(file, entries)?;
                let commands: Vec<String> = kinds.iter().map(|kind| format!("`carom roll {kind}`")).collect();
                (shows, "a roll file", format!("{} follows it", listed(&commands)))
            }
        },
    };
    let message = format!("this is {is}, not {}", file.kind.in_words());
    let problem = Problem::new(ProblemKind::File, shows.key.as_str(), message, Some(shows.key_span.clone()));
    Some(problem.with_help(takes))
}

/// True where the top of a file has a table of an impact, and none of a scene.
pub(crate) fn shows_an_impact(entries: &[Entry]) -> bool {
    let has = |keys: &[&str]| entries.iter().any(|entry| keys.contains(&entry.key.as_str()));
    has(OF_IMPACTS) && !has(OF_SCENES)
}

/// The first key that shows a roll file, and what may roll by it: what knows most of its keys, and more than half of them.
fn roll<'e>(file: &File, entries: &'e [Entry]) -> Option<(&'e Entry, Vec<&'static str>)> {
    if file.kind == FileKind::Roll {
        return None;
    }
    let kinds = kinds_of_roll(entries);
    if kinds.is_empty() {
        return None;
    }
    let strange =
        |entry: &&Entry| !knows(file, &entry.key) && ROLLS.iter().any(|(_, roll)| knows(roll, &entry.key));
    Some((entries.iter().find(strange)?, kinds))
}

/// What may roll by a file of such keys: what knows most of them, and more than half of them.
pub(crate) fn kinds_of_roll(entries: &[Entry]) -> Vec<&'static str> {
    // A roll file has no tables but distributions.
    let distribution = |inner: &[Entry]| {
        inner
            .iter()
            .all(|entry| UNIFORM.contains(&entry.key.as_str()) || NORMAL.contains(&entry.key.as_str()))
    };
    let table = |entry: &Entry| matches!(&entry.node.value, Value::Table(inner) if !distribution(inner));
    if entries.iter().any(table) {
        return vec![];
    }
    let known = |roll: &File| entries.iter().filter(|entry| knows(roll, &entry.key)).count();
    let most = ROLLS.iter().map(|(_, roll)| known(roll)).max().unwrap_or(0);
    if 2 * most <= entries.len() {
        return vec![];
    }
    ROLLS.iter().filter(|(_, roll)| known(roll) == most).map(|(kind, _)| *kind).collect()
}

fn knows(file: &File, key: &str) -> bool {
    file.variants.iter().any(|(_, table)| table.key(key).is_some())
}

impl FileKind {
    fn in_words(self) -> &'static str {
        match self {
            Self::Scene => "a scene",
            Self::Impact => "an impact",
            Self::Roll => "a roll file",
        }
    }
}
