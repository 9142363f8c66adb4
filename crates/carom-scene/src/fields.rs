//! What a file says and may say, value by value, by its grammar: for forms.

use crate::form::Form;
use crate::grammar::{
    Fallback, Holds, Key, Table, is_of_type, kinds_of_roll, read_quantity, shows_an_impact, variant,
};
use crate::node::{Entry, Node, Value, from_toml};
use crate::quantity::Kind;
use crate::roll::RollKind;
use crate::roll::spatial::SpatialRollKind;
use carom_words::Words;

/// A value that a file holds, or may hold.
///
/// # Example
/// ```
/// let ball = "body = { mass = 2, inertia = 0.4, velocity = [0, -3] }\ncontact = [{ point = [0, -1], normal = [0, 1], friction = 0.3 }]";
/// let fields = carom_scene::Form::Impact.fields(ball);
/// let of = |path: &str| fields.iter().find(|field| field.path() == path).unwrap();
/// assert_eq!((of("contact.0.friction").text.as_str(), of("contact.0.friction").written), ("0.3", true));
/// assert_eq!((of("contact.0.restitution").value, of("contact.0.restitution").written), (Some(0.0), false));
/// assert_eq!(of("law").choices, ["poisson", "stronge", "newton"]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// The table that it belongs to: `body`, `contact.0`; empty at the top.
    pub table: String,
    /// What that table is called: `contact left`.
    pub group: String,
    /// Its key.
    pub key: &'static str,
    /// What it means.
    pub about: &'static str,
    /// As the file has it, or what counts where it is left out; empty where that is not one value.
    pub text: String,
    /// True where the file writes it.
    pub written: bool,
    /// Of a single quantity: its value, SI.
    pub value: Option<f64>,
    /// Of quantities: what they measure.
    pub kind: Option<Kind>,
    /// The words that it may be; empty where it is none of a few.
    pub choices: Vec<&'static str>,
}

impl Field {
    /// Its path: `contact.0.friction`.
    pub fn path(&self) -> String {
        if self.table.is_empty() { self.key.to_owned() } else { format!("{}.{}", self.table, self.key) }
    }
}

impl Form {
    /// The kind of a file by its text: by the tables that only a scene or an impact has, else by most of the keys of what rolls; where several
    /// kinds know as many, by the name.
    ///
    /// # Example
    /// ```
    /// use carom_scene::{Form, RollKind};
    /// assert_eq!(Form::of("a.toml", "[body]\nmass = 1"), Form::Impact);
    /// assert_eq!(Form::of("a.toml", "sides = 6\ncircumradius = \"50 mm\"\nslope = \"12 deg\""), Form::Roll(RollKind::Prism));
    /// assert_eq!(Form::of("roll_prism.toml", "mass = 1\nroll_rate = 2"), Form::Roll(RollKind::Prism));
    /// ```
    pub fn of(name: &str, source: &str) -> Self {
        let (tree, _) = from_toml(source);
        let Value::Table(entries) = &tree.value else { return Self::Scene };
        if shows_an_impact(entries) {
            return Self::Impact;
        }
        let kinds = kinds_of_roll(entries);
        let named = kinds.iter().find(|kind| name.contains(**kind)).or(kinds.first());
        named.map_or(Self::Scene, |kind| Self::of_roll(kind))
    }

    fn of_roll(kind: &str) -> Self {
        let planar = RollKind::ALL.iter().find(|one| one.word() == kind).map(|one| Self::Roll(*one));
        let spatial =
            || SpatialRollKind::ALL.iter().find(|one| one.word() == kind).map(|one| Self::SpatialRoll(*one));
        planar.or_else(spatial).unwrap_or(Self::Scene)
    }

    /// The values that a file of this kind holds, and those that it may hold besides; of a text with problems what can be told.
    pub fn fields(self, source: &str) -> Vec<Field> {
        let (tree, _) = from_toml(source);
        let mut walk = Fields { source, found: vec![] };
        if let Value::Table(entries) = &tree.value {
            walk.table(variant(self.file().variants, entries), "", "", entries);
        }
        walk.found
    }
}

struct Fields<'s> {
    source: &'s str,
    found: Vec<Field>,
}

impl Fields<'_> {
    fn table(&mut self, table: &'static Table, path: &str, group: &str, entries: &[Entry]) {
        for key in table.all_keys() {
            let own = entries.iter().find(|entry| entry.key == key.name).map(|entry| &entry.node);
            let holds = held(key, own);
            match (holds, own.map(|node| &node.value)) {
                (Holds::Table(inner), Some(Value::Table(entries))) => {
                    self.table(inner, &joined(path, key.name), key.name, entries);
                }
                (Holds::Variant(variants), Some(Value::Table(entries))) => {
                    self.table(variant(variants, entries), &joined(path, key.name), key.name, entries);
                }
                (Holds::Tables(inner), Some(Value::List(list))) => self.list(inner.of, path, key.name, list),
                (Holds::Table(_) | Holds::Variant(_) | Holds::Tables(_), _) => {}
                _ => self.leaf((key, holds), path, group, own),
            }
        }
    }

    fn list(&mut self, table: &'static Table, path: &str, name: &str, list: &[Node]) {
        for (number, node) in list.iter().enumerate() {
            let Value::Table(entries) = &node.value else { continue };
            let own = entries.iter().find(|entry| entry.key == "name").map(|entry| &entry.node.value);
            let called = match (own, u8::try_from(number)) {
                (Some(Value::Text(name)), _) => name.clone(),
                // As answers call them.
                (_, Ok(number @ 0..26)) if name == "contact" => char::from(b'A' + number).to_string(),
                _ => (number + 1).to_string(),
            };
            self.table(
                table,
                &joined(path, &format!("{name}.{number}")),
                &format!("{name} {called}"),
                entries,
            );
        }
    }

    /// A value; of one that is not written, what counts in its place.
    fn leaf(
        &mut self,
        (key, holds): (&'static Key, &'static Holds),
        path: &str,
        group: &str,
        own: Option<&Node>,
    ) {
        let (kind, choices) = match holds {
            Holds::Quantity(kind) | Holds::Number(kind) | Holds::Vector(kind, _) => (Some(*kind), vec![]),
            Holds::Words(words) => (None, words()),
            _ => (None, vec![]),
        };
        let written = own.and_then(|node| self.source.get(node.span.clone()));
        let fallback = match key.fallback {
            Some(Fallback::Number(number)) => {
                Some(kind.map_or(number.to_string(), |kind| kind.dimension.show(number)))
            }
            Some(Fallback::Word(word)) => Some(word.to_owned()),
            None => None,
        };
        let as_read = own.map(|node| match &node.value {
            Value::Text(text) => text.clone(),
            _ => written.unwrap_or_default().to_owned(),
        });
        let text = as_read.or(fallback).unwrap_or_default();
        let single = matches!(holds, Holds::Quantity(_) | Holds::Number(_));
        let value = kind.filter(|_| single).and_then(|kind| match (own, key.fallback) {
            (Some(node), _) => read_quantity(key.name, node, kind, None).ok().map(|read| read.value),
            (None, Some(Fallback::Number(number))) => Some(number),
            _ => None,
        });
        self.found.push(Field {
            table: path.to_owned(),
            group: group.to_owned(),
            key: key.name,
            about: key.about,
            text,
            written: written.is_some(),
            value,
            kind,
            choices,
        });
    }
}

/// What a key holds as it is written: of several that it may hold the one that is there, or that a form can ask for.
fn held(key: &'static Key, own: Option<&Node>) -> &'static Holds {
    let Holds::Either(choices) = &key.holds else { return &key.holds };
    let found = choices.iter().find(|choice| match own {
        Some(node) => is_of_type(choice, &node.value),
        None => matches!(choice, Holds::Quantity(_) | Holds::Number(_)),
    });
    found.unwrap_or(&key.holds)
}

fn joined(path: &str, key: &str) -> String {
    if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_example_is_known_by_its_text() {
        let folder = std::fs::read_dir("../../examples").unwrap_or_else(|error| panic!("{error}"));
        let mut seen = 0;
        for path in folder.filter_map(|entry| Some(entry.ok()?.path())) {
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            let Some(stem) = name.strip_suffix(".toml") else { continue };
            let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{error}"));
            let kind = stem.split('_').nth(1).unwrap_or_default();
            let wanted = match stem.split('_').next() {
                Some("impact" | "contact") => Form::Impact,
                Some("roll") => Form::of_roll(kind),
                _ => Form::Scene,
            };
            assert_eq!(Form::of(&name, &text), wanted, "{name}");
            seen += 1;
        }
        assert!(seen >= 36, "{seen} examples");
    }

    #[test]
    fn values_are_told_as_they_are_written_and_as_they_count() {
        let fields = Form::SpatialRoll(SpatialRollKind::Body)
            .fields("speed = { low = \"0 m/s\", high = \"0.2 m/s\" }\nturn = \"30 deg\"");
        let of = |key: &str| fields.iter().find(|field| field.key == key).unwrap_or_else(|| panic!("{key}"));
        assert_eq!(
            (of("speed").value, of("speed").written),
            (Some(0.1), true),
            "the middle of a distribution"
        );
        assert_eq!(of("turn").value, Some(30_f64.to_radians()), "in SI");
        assert_eq!((of("gravity").text.as_str(), of("gravity").written), ("9.81 m/s^2", false), "a default");
        assert_eq!((of("time").text.as_str(), of("time").value), ("", None), "nothing counts in its place");
        let scene = "part = { box = [1, 1, 1], mass = 1 }\ncontact = { friction = \"0.3 ± 0.1\" }\nstart = { to_edge = 1 }";
        let fields = Form::Scene.fields(scene);
        let of = |path: &str| fields.iter().find(|field| field.path() == path).map(|field| field.value);
        assert_eq!(of("contact.friction"), Some(Some(0.3)), "a table where a word might stand too");
        assert_eq!(of("start.face"), Some(Some(0.0)), "a number where a list might stand too");
    }
}
