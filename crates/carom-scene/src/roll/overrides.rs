//! Overrides `key=value` on top of a file.

use crate::node::{Entry, Node, Value, from_toml};
use crate::problem::{Problem, ProblemKind, Problems};
use std::ops::Range;

/// The name under which problems of overrides are reported.
const SET: &str = "--set";
/// What keeps an override that is none from being read.
const COMMENT: &str = "# ";

/// A file's tree with the overrides on top.
pub(crate) struct Overridden {
    pub(crate) tree: Node,
    /// The overrides as TOML, one a line.
    pub(crate) text: String,
    /// Where the overrides' places begin: places before belong to the file.
    boundary: usize,
    /// Overrides that are no `key=value`: the others can be read all the same.
    pub(crate) malformed: Vec<Problem>,
}

/// Reads the file and puts the overrides on top; with them, where either is no TOML.
pub(crate) fn overridden(source: &str, overrides: &[String]) -> (Overridden, Vec<Problem>) {
    let boundary = source.len() + 1;
    let mut text = String::new();
    let mut malformed = vec![];
    for one in overrides {
        let (key, value) = parts(one);
        let bare = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-');
        if !key.is_empty() && !value.is_empty() && key.chars().all(bare) {
            text.push_str(&format!("{key} = {}\n", written(value)));
        } else {
            let message = "expected key=value, for example --set \"mass=2 kg\"";
            let shown = one.replace('\n', " ");
            // What is no key=value becomes a comment, so that the others keep their lines and this one its place.
            let start = boundary + text.len() + COMMENT.len();
            let span = Some(start..start + shown.len());
            malformed.push(Problem::new(ProblemKind::Syntax, "", message, span));
            text.push_str(&format!("{COMMENT}{shown}\n"));
        }
    }
    let (mut tree, mut syntax) = from_toml(source);
    let (on_top, wrong) = from_toml(&text);
    syntax.extend(wrong.into_iter().map(|mut problem| {
        problem.span = problem.span.map(|span| shifted(&span, boundary));
        problem
    }));
    if let (Value::Table(entries), Value::Table(others)) = (&mut tree.value, on_top.value) {
        for entry in others {
            let entry = moved(entry, boundary);
            match entries.iter_mut().find(|known| known.key == entry.key) {
                Some(known) => *known = entry,
                None => entries.push(entry),
            }
        }
    }
    (Overridden { tree, text, boundary, malformed }, syntax)
}

impl Overridden {
    /// The problems of the file under its name, and those of the overrides under theirs.
    pub(crate) fn apart(&self, file: &str, source: &str, list: Vec<Problem>) -> Vec<Problems> {
        let ours = |problem: &Problem| problem.span.as_ref().is_some_and(|span| span.start >= self.boundary);
        let (mut of_set, of_file): (Vec<Problem>, Vec<Problem>) = list.into_iter().partition(ours);
        for problem in &mut of_set {
            problem.span =
                problem.span.clone().map(|span| span.start - self.boundary..span.end - self.boundary);
        }
        let lists = [(file, source, of_file), (SET, self.text.as_str(), of_set)];
        let some = lists.into_iter().filter(|(_, _, list)| !list.is_empty());
        some.map(|(name, source, list)| Problems::new(name, source, list)).collect()
    }
}

fn parts(text: &str) -> (&str, &str) {
    text.split_once('=').map_or((text.trim(), ""), |(key, value)| (key.trim(), value.trim()))
}

/// A value as TOML: a number stays one, whatever else is not quoted yet becomes a text.
fn written(value: &str) -> String {
    match value.parse::<f64>() {
        Ok(number) if number.is_finite() => format!("{number:?}"),
        _ if value.starts_with(['"', '\'', '[', '{']) || matches!(value, "true" | "false") => {
            value.to_owned()
        }
        _ => format!("\"{}\"", value.replace('\\', "\\\\").replace('"', "\\\"")),
    }
}

fn shifted(span: &Range<usize>, by: usize) -> Range<usize> {
    span.start + by..span.end + by
}

fn moved(mut entry: Entry, by: usize) -> Entry {
    entry.key_span = shifted(&entry.key_span, by);
    move_node(&mut entry.node, by);
    entry
}

fn move_node(node: &mut Node, by: usize) {
    node.span = shifted(&node.span, by);
    match &mut node.value {
        Value::List(items) => items.iter_mut().for_each(|item| move_node(item, by)),
        Value::Table(entries) => {
            for entry in entries {
                entry.key_span = shifted(&entry.key_span, by);
                move_node(&mut entry.node, by);
            }
        }
        Value::Text(_) | Value::Number(_) | Value::Bool(_) | Value::Other(_) => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grammar::{Section, Sink, check, roll::CYLINDER_FILE};

    fn number(value: &str) -> Option<f64> {
        let (both, problems) = overridden("mass = 1\n", &[format!("mass={value}")]);
        assert!(problems.is_empty(), "{value}: {problems:?}");
        let Value::Table(entries) = &both.tree.value else { panic!("a table") };
        assert_eq!(entries.len(), 1, "it takes the place of the file's");
        let sink = Sink::default();
        let table = check(&CYLINDER_FILE, &both.tree, &sink)?;
        Section::new(table, String::new(), &both.tree, &sink)?.value("mass")
    }

    #[test]
    fn values_need_no_quotes() {
        for value in ["2", "2.", "2kg", "2 kg", "\"2 kg\"", "2000 g", "+2"] {
            assert_eq!(number(value), Some(2.0), "{value}");
        }
        assert_eq!(number("inf"), None, "not finite");
    }

    #[test]
    fn places_of_overrides_are_their_own() {
        let (both, syntax) = overridden("mass = 1\n", &["gamma".into(), "mass=3".into()]);
        assert!(syntax.is_empty(), "{syntax:?}");
        let apart = both.apart("a.toml", "mass = 1\n", both.malformed.clone());
        assert_eq!((apart.len(), apart[0].file.as_str()), (1, SET), "{apart:?}");
        assert_eq!(apart[0].value(&apart[0].list[0]), Some("gamma"), "its own text");
    }
}
