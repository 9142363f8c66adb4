//! Contacts of an impact as they are written: in space as in the plane, but for the numbers of a vector.

use crate::grammar::Section;
use crate::impact_bodies::Between;
use crate::node::{Node, Value};
use crate::problem::{Problem, ProblemKind};
use carom_num::{Vec2, Vec3};
use std::collections::BTreeSet;
use std::ops::Range;

/// A vector of the plane or of space.
pub(crate) trait Vector: Copy {
    /// The good vector of a key.
    fn of(section: &Section<'_>, key: &str) -> Option<Self>;

    /// The same of length 1; `None` where it has no direction.
    fn direction(self) -> Option<Self>;
}

impl Vector for Vec2 {
    fn of(section: &Section<'_>, key: &str) -> Option<Self> {
        section.vector(key).map(|[x, y]| Self::new(x.value, y.value))
    }

    fn direction(self) -> Option<Self> {
        self.unit()
    }
}

impl Vector for Vec3 {
    fn of(section: &Section<'_>, key: &str) -> Option<Self> {
        section.vector(key).map(|[x, y, z]| Self::new(x.value, y.value, z.value))
    }

    fn direction(self) -> Option<Self> {
        self.unit()
    }
}

/// Where a body is touched, and how: the point is as it is written.
#[derive(Clone, Copy)]
pub(crate) struct ReadTouch<V> {
    pub(crate) point: V,
    pub(crate) normal: V,
    pub(crate) friction: f64,
    pub(crate) restitution: f64,
}

/// A contact as it is written: also one with problems keeps its name and what it is between.
pub(crate) struct ReadContact<V> {
    pub(crate) name: Named,
    /// `None` where a part of it cannot be read.
    pub(crate) touch: Option<ReadTouch<V>>,
    /// `between = [into, out_of]`, where it is said, and its place.
    pub(crate) between: Option<Between>,
    /// Path and place of the contact.
    pub(crate) path: String,
    pub(crate) span: Range<usize>,
}

/// Every contact of a file.
pub(crate) fn read_contacts<V: Vector>(root: &Section<'_>) -> Vec<ReadContact<V>> {
    let sections = root.sections("contact").into_iter().flatten().enumerate();
    let list: Vec<ReadContact<V>> = sections.map(|(number, section)| read(number, &section)).collect();
    tell_twins(root, "contacts", list.iter().map(|contact| &contact.name));
    list
}

fn read<V: Vector>(number: usize, section: &Section<'_>) -> ReadContact<V> {
    let normal = V::of(section, "normal").and_then(|normal| {
        let unit = normal.direction();
        if unit.is_none() {
            section.blame_value(ProblemKind::Geometry, "normal", "has no direction: it must not be zero");
        }
        unit
    });
    let touch = V::of(section, "point").zip(normal).zip(section.value("friction"));
    let touch = touch.map(|((point, normal), friction)| ReadTouch {
        point,
        normal,
        friction,
        restitution: section.number("restitution"),
    });
    ReadContact {
        name: Named::of(section, || letter(number)),
        touch,
        between: read_between(section),
        path: section.path().to_owned(),
        span: section.span(),
    }
}

/// The two bodies that a contact is between.
fn read_between(section: &Section<'_>) -> Option<Between> {
    let node = section.get("between")?;
    let Value::List(items) = &node.value else { return None };
    let name = |item: &Node| match &item.value {
        Value::Text(text) => Some(text.clone()),
        _ => None,
    };
    let names: [String; 2] = items.iter().map(name).collect::<Option<Vec<String>>>()?.try_into().ok()?;
    Some((names, node.span.clone()))
}

/// A, B, C …
pub(crate) fn letter(number: usize) -> String {
    char::from(b'A' + (number % 26) as u8).to_string()
}

/// A name, its path, and the place where it is written, or that of what has none.
pub(crate) struct Named {
    pub(crate) name: String,
    path: String,
    span: Range<usize>,
}

impl Named {
    /// The name that a table writes, or the one that it has without it.
    pub(crate) fn of(section: &Section<'_>, unnamed: impl FnOnce() -> String) -> Self {
        let path = section.path_of("name");
        match section.text("name") {
            Some((name, span)) => Self { name: name.to_owned(), path, span },
            None => Self { name: unnamed(), path, span: section.span() },
        }
    }
}

/// Says which of several contacts, or bodies, have one name.
pub(crate) fn tell_twins<'n>(root: &Section<'_>, what: &str, all: impl Iterator<Item = &'n Named>) {
    let mut known = BTreeSet::new();
    for Named { name, path, span } in all {
        if !known.insert(name) {
            let message = format!("two {what} are called {name:?}");
            root.push(Problem::new(ProblemKind::Name, path.as_str(), message, Some(span.clone())));
        }
    }
}
