//! Reading an impact in space. Keys are those of the plane; what is a pair there, or a moment or a spin, is three numbers here.

use crate::grammar::{Section, impact::IMPACT, read_checked};
use crate::impact_operator::{Rows, read_matrix, read_surfaces};
use crate::impact_space::SpatialImpactProblem;
use crate::impact_space_bodies::read_group;
use crate::impact_touch::{ReadContact, ReadTouch, letter, read_contacts};
use crate::node::Node;
use crate::problem::{Problem, ProblemKind};
use crate::quantity::Quantity;
use carom_impact::spatial::{ContactSet, MOST_EXAMINED, RigidBody, Touch};
use carom_impact::{ImpactError, Law};
use carom_num::{Mat3, Vec3};

const ROWS: Rows = Rows {
    per: 3,
    words: "three rows for each contact, tangent 1, tangent 2 and normal",
    most: MOST_EXAMINED,
};

pub(crate) fn read_space(tree: &Node) -> Result<SpatialImpactProblem, Vec<Problem>> {
    read_checked(&IMPACT, tree, read_problem)
}

pub(crate) fn vector([x, y, z]: [Quantity; 3]) -> Vec3 {
    Vec3::new(x.value, y.value, z.value)
}

fn read_problem(root: &Section<'_>) -> Option<SpatialImpactProblem> {
    let law = root.word_or_default("law");
    let problem = if root.has("operator") {
        read_operator(law, root)
    } else {
        let list = read_contacts(root);
        match root.section("body") {
            Some(section) => read_body(law, root, &section, &list),
            None => read_group(law, root, &list),
        }
    }?;
    newton_is_alone(root, &problem).then_some(problem)
}

/// Newton's law says what one closing contact does; of several it says nothing in space.
fn newton_is_alone(root: &Section<'_>, problem: &SpatialImpactProblem) -> bool {
    let contacts = &problem.contacts;
    let closing = contacts.velocity[..contacts.count].iter().filter(|u| u.z < 0.0).count();
    if problem.law != Law::Newton || closing < 2 {
        return true;
    }
    let message = format!("\"newton\" is for one contact that closes, and {closing} close in space here");
    let span = root.get("law").map(|node| node.span.clone());
    let problem = Problem::new(ProblemKind::Unsupported, "law", message, span);
    root.push(problem.with_help("\"poisson\" and \"stronge\" are for several"));
    false
}

fn read_body(
    law: Law,
    root: &Section<'_>,
    section: &Section<'_>,
    list: &[ReadContact<Vec3>],
) -> Option<SpatialImpactProblem> {
    let body = read_rigid(section);
    let (path, span) = (section.path().to_owned(), section.span());
    let touches: Vec<Touch> =
        list.iter().map(|contact| contact.touch.map(Touch::from)).collect::<Option<_>>()?;
    let (body, names) = (body?, list.iter().map(|contact| contact.name.name.clone()).collect());
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
            root.push(Problem::new(ProblemKind::Conflict, path, error.to_string(), Some(span)));
            None
        }
    }
}

/// Mass, moments and motion of a body that is free.
pub(crate) fn read_rigid(section: &Section<'_>) -> Option<RigidBody> {
    let Vec3 { x, y, z } = section.vector("inertia").map(vector)?;
    let (velocity, spin) = read_motion(section)?;
    Some(RigidBody { mass: section.value("mass")?, inertia: Mat3::diagonal(x, y, z), velocity, spin })
}

/// Velocity and spin: zero where they are not written.
pub(crate) fn read_motion(section: &Section<'_>) -> Option<(Vec3, Vec3)> {
    let of = |key| match section.has(key) {
        true => section.vector(key).map(vector),
        false => Some(Vec3::ZERO),
    };
    Some((of("velocity")?, of("spin")?))
}

impl From<ReadTouch<Vec3>> for Touch {
    fn from(read: ReadTouch<Vec3>) -> Self {
        let ReadTouch { point, normal, friction, restitution } = read;
        Self { arm: point, normal, friction, restitution }
    }
}

/// `matrix` (3n × 3n), `velocity` (n lists of three), `friction` and `restitution` (n, or one for all).
fn read_operator(law: Law, root: &Section<'_>) -> Option<SpatialImpactProblem> {
    let section = root.section("operator")?;
    let (matrix, count) = (read_matrix(&section, &ROWS), ROWS.count(&section));
    let velocity = read_velocities(&section, count);
    let [friction, restitution] = read_surfaces(&section, count);
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
    // Blocks of three rows and columns belong to one pair of contacts.
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
        section.blame(ProblemKind::OutOfRange, "matrix", error.to_string());
        return None;
    }
    let names = (0..count).map(letter).collect();
    Some(SpatialImpactProblem { law, names, body: None, touches: vec![], group: None, contacts })
}

/// A list [tangent 1, tangent 2, normal] for each contact.
fn read_velocities(section: &Section<'_>, count: Option<usize>) -> Option<Vec<Vec3>> {
    let velocities: Vec<Vec3> = section.vectors("velocity")?.into_iter().map(vector).collect();
    if let Some(count) = count.filter(|count| *count != velocities.len()) {
        let found = velocities.len();
        let message = format!("expected {count} lists of three, one for each contact, found {found}");
        section.blame_value(ProblemKind::Geometry, "velocity", message);
        return None;
    }
    Some(velocities)
}
