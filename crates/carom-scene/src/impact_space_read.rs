//! Reading an impact in space. Keys are those of the plane; what is a pair there, or a moment or a spin, is three numbers here.

use crate::drawing::{FRICTION, INERTIA, MASS, RESTITUTION};
use crate::impact_bodies::Between;
use crate::impact_file::{ANY_LENGTH, ANY_NUMBER, ANY_SPEED, ANY_SPIN, letter, read_between};
use crate::impact_operator::{Rows, numbers, read_matrix, read_surfaces};
use crate::impact_space::SpatialImpactProblem;
use crate::impact_space_bodies::read_group;
use crate::node::{Node, Value};
use crate::problem::{Problem, ProblemKind};
use crate::quantity::Quantity;
use crate::read_part::read_law;
use crate::section::{Section, Sink, expected};
use carom_impact::planar::{ImpactError, Law};
use carom_impact::spatial::{ContactSet, MOST_EXAMINED, RigidBody, Touch};
use carom_num::{Mat3, Vec3};
use std::ops::Range;

/// Keys whose lists have two numbers in the plane and three in space; moments and spins are lists in space alone.
const OF_BODY: [&str; 4] = ["inertia", "velocity", "spin", "centre"];
const OF_CONTACT: [&str; 2] = ["point", "normal"];
const ROWS: Rows = Rows {
    per: 3,
    words: "three rows for each contact, tangent 1, tangent 2 and normal",
    most: MOST_EXAMINED,
};

/// The lists of numbers by which a file is in the plane or in space: path, length and place.
fn vectors(tree: &Node) -> Vec<(String, usize, Range<usize>)> {
    let mut out = vec![];
    let entry = |node: &Node, key: &str| match &node.value {
        Value::Table(entries) => entries.iter().find(|e| e.key == key).map(|e| e.node.clone()),
        _ => None,
    };
    let mut note = |path: String, node: &Node| {
        if let Value::List(items) = &node.value {
            out.push((path, items.len(), node.span.clone()));
        }
    };
    for (table, keys) in [("body", &OF_BODY[..]), ("contact", &OF_CONTACT)] {
        let Some(found) = entry(tree, table) else { continue };
        let tables = match &found.value {
            Value::List(items) => {
                items.iter().enumerate().map(|(i, item)| (format!("{table}.{i}"), item)).collect()
            }
            _ => vec![(table.to_owned(), &found)],
        };
        for (path, table) in tables {
            for key in keys {
                entry(table, key).iter().for_each(|node| note(format!("{path}.{key}"), node));
            }
        }
    }
    let velocity = entry(tree, "operator").and_then(|operator| entry(&operator, "velocity"));
    if let Some(Value::List(items)) = velocity.map(|node| node.value) {
        items.iter().enumerate().for_each(|(i, item)| note(format!("operator.velocity.{i}"), item));
    }
    out
}

/// True where a vector has three numbers.
pub(crate) fn is_in_space(tree: &Node) -> bool {
    vectors(tree).iter().any(|(_, length, _)| *length == 3)
}

pub(crate) fn read_space(tree: &Node) -> Result<SpatialImpactProblem, Vec<Problem>> {
    let sink = Sink::default();
    let Some(root) = Section::new("", tree, &sink) else { return Err(sink.into_list()) };
    let lists = vectors(tree);
    let of = |n: usize| lists.iter().find(|(_, length, _)| *length == n);
    if let (Some((flat, _, span)), Some((deep, ..))) = (of(2), of(3)) {
        let message = format!("mixes plane and space: it has two numbers, {deep} has three");
        sink.push(Problem::new(ProblemKind::Conflict, flat.clone(), message, Some(span.clone())));
    }
    let found = read_problem(&root);
    root.get("operator");
    root.finish();
    let problems = sink.into_list();
    match found {
        Some(found) if problems.is_empty() => Ok(found),
        _ => Err(problems),
    }
}

pub(crate) fn vector([x, y, z]: [Quantity; 3]) -> Vec3 {
    Vec3::new(x.value, y.value, z.value)
}

fn read_problem(root: &Section<'_>) -> Option<SpatialImpactProblem> {
    let law = read_law(root);
    if root.has("operator") {
        for key in ["body", "contact"].into_iter().filter(|key| root.has(key)) {
            root.get(key);
            let message = "does not go together with [operator], which says it all";
            let span = Some(root.key_span(key));
            root.sink().push(Problem::new(ProblemKind::Conflict, key, message, span));
        }
        return read_operator(law, root);
    }
    if !root.has("body") {
        root.missing("body", "a table [body], or several tables [[body]], of what is struck; or [operator]");
    }
    let several = matches!(root.get("body").map(|node| &node.value), Some(Value::List(_)));
    let list = read_contacts(root);
    if several { read_group(law, root, &list) } else { read_body(law, root, &list) }
}

fn read_body(law: Law, root: &Section<'_>, list: &[ReadContact]) -> Option<SpatialImpactProblem> {
    let section = root.section("body")?;
    if !section.has("velocity") {
        section.missing("velocity", "a list [vx, vy, vz]");
    }
    let body = read_rigid(&section);
    let (path, span) = (section.path().to_owned(), section.span());
    section.finish();
    for (_, place) in list.iter().filter_map(|contact| contact.between.as_ref()) {
        let message = "needs several bodies: [[body]] with a name each";
        root.sink().push(Problem::new(ProblemKind::Conflict, "contact", message, Some(place.clone())));
    }
    let touches: Vec<Touch> = list.iter().map(|contact| contact.touch).collect::<Option<_>>()?;
    let (body, names) = (body?, list.iter().map(|contact| contact.name.clone()).collect());
    if touches.is_empty() {
        return None;
    }
    match ContactSet::of_free_body(&body, &touches) {
        Ok(contacts) => {
            Some(SpatialImpactProblem { law, names, body: Some(body), touches, group: None, contacts })
        }
        Err(error) => {
            let (path, span) = match error {
                ImpactError::TooMany { .. } => ("contact".to_owned(), root.key_span("contact")),
                _ => (path, span),
            };
            root.sink().push(Problem::new(ProblemKind::Conflict, path, error.to_string(), Some(span)));
            None
        }
    }
}

/// Mass, moments and motion of a body that is free.
pub(crate) fn read_rigid(section: &Section<'_>) -> Option<RigidBody> {
    let mass = section.required("mass", MASS);
    if !section.has("inertia") {
        section.missing("inertia", "a list [about x, about y, about z]");
    }
    let moments = section.triple("inertia", INERTIA).map(vector);
    let (velocity, spin) = read_motion(section);
    let Vec3 { x, y, z } = moments?;
    Some(RigidBody { mass: mass?.value, inertia: Mat3::diagonal(x, y, z), velocity: velocity?, spin: spin? })
}

/// Velocity and spin: zero where they are not written.
pub(crate) fn read_motion(section: &Section<'_>) -> (Option<Vec3>, Option<Vec3>) {
    let still = |key| (!section.has(key)).then_some(Vec3::ZERO);
    (
        section.triple("velocity", ANY_SPEED).map(vector).or(still("velocity")),
        section.triple("spin", ANY_SPIN).map(vector).or(still("spin")),
    )
}

/// A contact as it is written: its arm is the point.
pub(crate) struct ReadContact {
    pub(crate) name: String,
    pub(crate) touch: Option<Touch>,
    pub(crate) between: Option<Between>,
    pub(crate) path: String,
    pub(crate) span: Range<usize>,
}

fn read_contacts(root: &Section<'_>) -> Vec<ReadContact> {
    if !root.has("contact") {
        root.missing("contact", "[[contact]] with point, normal and friction, one for each contact");
    }
    let list: Vec<ReadContact> = root.sections("contact").into_iter().enumerate().map(read_contact).collect();
    for (i, contact) in list.iter().enumerate() {
        if list[..i].iter().any(|other| other.name == contact.name) {
            let message = format!("two contacts are called {:?}", contact.name);
            let path = format!("{}.name", contact.path);
            root.sink().push(Problem::new(ProblemKind::Conflict, path, message, Some(contact.span.clone())));
        }
    }
    list
}

fn read_contact((number, section): (usize, Section<'_>)) -> ReadContact {
    let name = section.text("name").map_or_else(|| letter(number), |(name, _)| name.to_owned());
    for key in OF_CONTACT {
        if !section.has(key) {
            section.missing(key, "a list [x, y, z]");
        }
    }
    let point = section.triple("point", ANY_LENGTH).map(vector);
    let normal = section.triple("normal", ANY_NUMBER).and_then(|normal| {
        let unit = vector(normal).unit();
        if unit.is_none() {
            let (path, span) = (section.path_of("normal"), Some(section.key_span("normal")));
            let message = "has no direction: it must not be zero";
            section.sink().push(Problem::new(ProblemKind::Geometry, path, message, span));
        }
        unit
    });
    let friction = section.required("friction", FRICTION);
    let restitution = section.quantity("restitution", RESTITUTION).map_or(0.0, |e| e.value);
    let between = section.get("between").and_then(|node| read_between(&section, node));
    let (path, span) = (section.path().to_owned(), section.span());
    section.finish();
    let touch = point.zip(normal).zip(friction).map(|((arm, normal), friction)| Touch {
        arm,
        normal,
        friction: friction.value,
        restitution,
    });
    ReadContact { name, touch, between, path, span }
}

/// `matrix` (3n × 3n), `velocity` (n lists of three), `friction` and `restitution` (n, or one for all).
fn read_operator(law: Law, root: &Section<'_>) -> Option<SpatialImpactProblem> {
    let section = root.section("operator")?;
    if !section.has("matrix") {
        section.missing("matrix", format!("a list of rows [[..], ..]: {}", ROWS.words));
    }
    let (matrix, count) = (read_matrix(&section, &ROWS), ROWS.count(&section));
    let velocity = read_velocities(&section, count);
    let [friction, restitution] = read_surfaces(&section, count);
    let (span, path) = (section.key_span("matrix"), section.path_of("matrix"));
    section.finish();
    let (matrix, count, velocity) = (matrix?, count?, velocity?);
    let (friction, restitution) = (friction?, restitution?);
    let mut contacts = ContactSet {
        count,
        frame: [Mat3::IDENTITY; MOST_EXAMINED],
        velocity: [Vec3::ZERO; MOST_EXAMINED],
        operator: [[Mat3::ZERO; MOST_EXAMINED]; MOST_EXAMINED],
        friction: [0.0; MOST_EXAMINED],
        restitution: [0.0; MOST_EXAMINED],
    };
    for i in 0..count {
        (contacts.velocity[i], contacts.friction[i]) = (velocity[i], friction[i]);
        contacts.restitution[i] = restitution[i];
        for j in 0..count {
            let row = |a: usize| {
                let at = |b: usize| matrix[3 * i + a][3 * j + b];
                Vec3::new(at(0), at(1), at(2))
            };
            contacts.operator[i][j] = Mat3 { rows: [row(0), row(1), row(2)] };
        }
    }
    if let Err(error) = contacts.check() {
        root.sink().push(Problem::new(ProblemKind::OutOfRange, path, error.to_string(), Some(span)));
        return None;
    }
    let names = (0..count).map(letter).collect();
    Some(SpatialImpactProblem { law, names, body: None, touches: vec![], group: None, contacts })
}

/// A list [tangent 1, tangent 2, normal] for each contact.
fn read_velocities(section: &Section<'_>, count: Option<usize>) -> Option<Vec<Vec3>> {
    let (node, path) = (section.get("velocity")?, section.path_of("velocity"));
    let Value::List(items) = &node.value else {
        let what = "a list [tangent 1, tangent 2, normal] for each contact";
        section.sink().push(expected(what, &path, node));
        return None;
    };
    let wanted = count.filter(|count| *count != items.len());
    if let Some(count) = wanted {
        let message = format!("expected {count} lists of three, one for each contact, found {}", items.len());
        section.sink().push(Problem::new(ProblemKind::WrongValue, &*path, message, Some(node.span.clone())));
    }
    let of = |(i, item): (usize, &Node)| {
        let read = numbers(&format!("{path}.{i}"), item, Some(3), ANY_SPEED, section.sink())?;
        <[f64; 3]>::try_from(read).ok().map(Vec3::from_array)
    };
    let all: Vec<Option<Vec3>> = items.iter().enumerate().map(of).collect();
    all.into_iter().collect::<Option<_>>().filter(|_| wanted.is_none())
}
