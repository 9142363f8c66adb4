//! Several bodies that meet, free, fixed or moved: `[[body]]` with a name each, and contacts `between` two of them.

use crate::grammar::Section;
use crate::impact_contacts::ImpactContacts;
use crate::impact_file::{read_applied, vector};
use crate::impact_touch::{Named, ReadContact, ReadTouch, tell_twins};
use crate::problem::{Problem, ProblemKind};
use carom_impact::ImpactError;
use carom_impact::planar::forces::Applied;
use carom_impact::planar::{Meeting, RigidBody, struck};
use carom_num::Vec2;
use std::ops::Range;

/// Several bodies and where they meet.
///
/// # Example
/// Newton's cradle: three balls of 1 kg that meet in two places; the first has 1/2 J.
/// ```
/// use carom_scene::*;
/// let text = std::fs::read_to_string("../../examples/impact_cradle.toml")?;
/// let group = ImpactProblem::parse("cradle.toml", &text)?.group.unwrap();
/// let energy: f64 = group.bodies.iter().map(|body| body.energy()).sum();
/// assert_eq!((group.bodies.len(), group.meetings.len(), energy), (3, 2, 0.5));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// Names of the bodies.
    pub names: Vec<String>,
    /// The bodies before.
    pub bodies: Vec<RigidBody>,
    /// Where they meet.
    pub meetings: Vec<Meeting>,
}

impl Group {
    /// The bodies after impulses (tangential, normal) at their meetings.
    ///
    /// # Errors
    /// An impulse that is no number.
    pub fn after(&self, impulses: &[[f64; 2]]) -> Result<Vec<RigidBody>, ImpactError> {
        struck(&self.bodies, &self.meetings, impulses)
    }
}

/// Kinetic energy of all bodies that can be moved [J].
pub(crate) fn energy_of(bodies: &[RigidBody]) -> f64 {
    bodies.iter().map(RigidBody::energy).sum()
}

/// Names of the contacts, the group, and its contacts.
pub(crate) fn read_group(
    root: &Section<'_>,
    list: &[ReadContact<Vec2>],
    gravity: Option<Vec2>,
) -> Option<(Vec<String>, Group, ImpactContacts, Vec<Applied>)> {
    let sections = root.sections("body");
    let (mut names, mut bodies, mut applied) = (vec![], vec![], vec![]);
    for numbered in sections.into_iter().flatten().enumerate() {
        let (name, body, pulled) = read_one(numbered, gravity);
        names.push(name);
        bodies.push(body);
        applied.push(pulled);
    }
    tell_twins(root, "bodies", names.iter());
    let names: Vec<String> = names.into_iter().map(|named: Named| named.name).collect();
    // Every contact is read before any is given up, so that all of their problems are told.
    let meetings: Vec<Option<Meeting>> = list.iter().map(|c| meeting(root, &names, c)).collect();
    let meetings: Vec<Meeting> = meetings.into_iter().collect::<Option<_>>()?;
    let bodies: Vec<RigidBody> = bodies.into_iter().collect::<Option<_>>()?;
    if meetings.is_empty() {
        return None;
    }
    match ImpactContacts::of_bodies(&bodies, &meetings) {
        Ok(contacts) => {
            let contact_names = list.iter().map(|c| c.name.name.clone()).collect();
            Some((contact_names, Group { names, bodies, meetings }, contacts, applied))
        }
        Err(error) => {
            let contact = match error {
                ImpactError::Coincide { second, .. } => list.get(second),
                ImpactError::OutsideDomain { contact: Some(i), .. } => list.get(i),
                _ => None,
            };
            let (path, span) = contact.map_or(("contact".to_owned(), root.key_span("contact")), |c| {
                (c.path.clone(), c.span.clone())
            });
            root.push(Problem::new(ProblemKind::Geometry, path, error.to_string(), Some(span)));
            None
        }
    }
}

/// Whether impulses move a body.
#[derive(Clone, Copy)]
pub(crate) enum BodyKind {
    Free,
    Fixed,
}

carom_words::words! {
    BodyKind {
        Free = "free",
        Fixed = "fixed",
    }
}

/// Its name, and the body where it can be read.
fn read_one(
    (number, section): (usize, Section<'_>),
    gravity: Option<Vec2>,
) -> (Named, Option<RigidBody>, Applied) {
    let name = Named::of(&section, || format!("body {}", number + 1));
    let point = |key: &str| section.vector(key).map_or(Vec2::ZERO, vector);
    let (mass, inertia) = match section.word_or_default("kind") {
        BodyKind::Fixed => (Some(f64::INFINITY), Some(f64::INFINITY)),
        BodyKind::Free => (section.value("mass"), section.value("inertia")),
    };
    let body = RigidBody {
        mass: mass.unwrap_or(1.0),
        inertia: inertia.unwrap_or(1.0),
        centre: point("centre"),
        velocity: point("velocity"),
        spin: section.number("spin"),
    };
    let applied = read_applied(&section, gravity, mass);
    (name, mass.and(inertia).map(|_| body), applied)
}

fn meeting(root: &Section<'_>, names: &[String], c: &ReadContact<Vec2>) -> Option<Meeting> {
    let [into, out_of] = read_meeting(root, names, &c.path, c.between.as_ref())?;
    let ReadTouch { point, normal, friction, restitution } = c.touch?;
    Some(Meeting { into, out_of, point, normal, friction, restitution })
}

/// What `between = [into, out_of]` is written as, and where.
pub(crate) type Between = ([String; 2], Range<usize>);

/// The numbers of the bodies that a contact of this path is between.
pub(crate) fn read_meeting(
    root: &Section<'_>,
    names: &[String],
    path: &str,
    between: Option<&Between>,
) -> Option<[usize; 2]> {
    let (pair, span) = between?;
    let wrong = |message: String| {
        root.push(Problem::new(ProblemKind::Name, format!("{path}.between"), message, Some(span.clone())));
    };
    let find = |name: &String| {
        let found = names.iter().position(|n| n == name);
        if found.is_none() {
            let known = names.iter().map(|n| format!("{n:?}")).collect::<Vec<_>>().join(", ");
            wrong(format!("no body is called {name:?}: there are {known}"));
        }
        found
    };
    let (into, out_of) = (find(&pair[0]), find(&pair[1]));
    if into.is_some() && into == out_of {
        wrong(format!("names {:?} twice: two different bodies meet", pair[0]));
        return None;
    }
    Some([into?, out_of?])
}
