//! Several bodies that meet in space, free, fixed or moved: `[[body]]` with a name each, and contacts `between` two of them.

use crate::grammar::Section;
use crate::impact_bodies::{BodyKind, read_meeting};
use crate::impact_space::SpatialImpactProblem;
use crate::impact_space_read::{read_motion, read_rigid, vector};
use crate::impact_touch::{Named, ReadContact, ReadTouch, tell_twins};
use crate::problem::{Problem, ProblemKind};
use carom_impact::spatial::{ContactSet, Meeting, RigidBody, Touch, struck};
use carom_impact::{ImpactError, Law};
use carom_num::{Mat3, Vec3};

/// Several bodies and where they meet.
#[derive(Clone, Debug, PartialEq)]
pub struct SpatialGroup {
    /// Names of the bodies.
    pub names: Vec<String>,
    /// The bodies before. The mass of one that nothing moves does not count.
    pub bodies: Vec<RigidBody>,
    /// True of each that nothing moves.
    pub fixed: Vec<bool>,
    /// Where they meet; the first body of each is free.
    pub meetings: Vec<Meeting>,
    /// Of each meeting: −1 where its normal is the file's turned round, because the file's points into a body that nothing moves.
    pub turned: Vec<f64>,
}

impl SpatialGroup {
    /// The bodies after impulses at their meetings, each in the frame of its contact.
    ///
    /// # Errors
    /// An impulse that is no number.
    pub fn after(&self, impulses: &[Vec3]) -> Result<Vec<RigidBody>, ImpactError> {
        struck(&self.bodies, &self.meetings, impulses)
    }

    /// Kinetic energy of those that can be moved [J].
    pub(crate) fn energy(&self, bodies: &[RigidBody]) -> f64 {
        bodies.iter().zip(&self.fixed).filter(|(_, fixed)| !**fixed).map(|(body, _)| body.energy()).sum()
    }
}

/// A body as it is written.
struct ReadBody {
    name: Named,
    fixed: bool,
    body: Option<RigidBody>,
    centre: Vec3,
}

/// The bodies, and the contacts between them.
pub(crate) fn read_group(
    law: Law,
    root: &Section<'_>,
    list: &[ReadContact<Vec3>],
) -> Option<SpatialImpactProblem> {
    let read: Vec<ReadBody> = root.sections("body").into_iter().flatten().enumerate().map(read_one).collect();
    tell_twins(root, "bodies", read.iter().map(|body| &body.name));
    let names: Vec<String> = read.iter().map(|body| body.name.name.clone()).collect();
    // Every contact is read before any is given up, so that all of their problems are told.
    let met: Vec<Option<Met>> = list.iter().map(|contact| meet(root, &names, &read, contact)).collect();
    let met: Vec<Met> = met.into_iter().collect::<Option<_>>()?;
    let meetings: Vec<Meeting> = met.iter().map(|met| met.meeting).collect();
    let bodies: Vec<RigidBody> = read.iter().map(|body| body.body).collect::<Option<_>>()?;
    if meetings.is_empty() {
        return None;
    }
    let mut contacts = match ContactSet::of_bodies(&bodies, &meetings) {
        Ok(contacts) => contacts,
        Err(error) => {
            let span = Some(root.key_span("contact"));
            root.push(Problem::new(ProblemKind::Conflict, "contact", error.to_string(), span));
            return None;
        }
    };
    for (i, met) in met.iter().enumerate() {
        if let Some((fixed, at)) = met.fixed {
            // What does not yield may move all the same.
            contacts.velocity[i] -= contacts.frame[i] * bodies[fixed].velocity_at(at);
        }
    }
    let turned = met.iter().map(|met| met.turned).collect();
    let fixed = read.iter().map(|body| body.fixed).collect();
    let group = SpatialGroup { names, bodies, fixed, meetings, turned };
    let names = list.iter().map(|contact| contact.name.name.clone()).collect();
    Some(SpatialImpactProblem { law, names, body: None, touches: vec![], group: Some(group), contacts })
}

fn read_one((number, section): (usize, Section<'_>)) -> ReadBody {
    let name = Named::of(&section, || format!("body {}", number + 1));
    let fixed = matches!(section.word_or_default("kind"), BodyKind::Fixed);
    let body = if fixed {
        let (mass, inertia) = (1.0, Mat3::IDENTITY);
        read_motion(&section).map(|(velocity, spin)| RigidBody { mass, inertia, velocity, spin })
    } else {
        read_rigid(&section)
    };
    let body = body.filter(|body| match body.check() {
        Ok(()) => true,
        Err(error) => {
            let (path, span) = (section.path().to_owned(), Some(section.span()));
            section.push(Problem::new(ProblemKind::Conflict, path, error.to_string(), span));
            false
        }
    });
    let centre = section.vector("centre").map_or(Vec3::ZERO, vector);
    ReadBody { name, fixed, body, centre }
}

/// A contact between two bodies.
struct Met {
    /// Its first body is free.
    meeting: Meeting,
    /// −1 where that turns the file's normal round.
    turned: f64,
    /// The body that nothing moves, and where the contact is from its centre.
    fixed: Option<(usize, Vec3)>,
}

fn meet(root: &Section<'_>, names: &[String], read: &[ReadBody], contact: &ReadContact<Vec3>) -> Option<Met> {
    let [into, out_of] = read_meeting(root, names, &contact.path, contact.between.as_ref())?;
    let (body, other, turned) = match (read[into].fixed, read[out_of].fixed) {
        (false, _) => (into, out_of, 1.0),
        (true, false) => (out_of, into, -1.0),
        (true, true) => {
            let message = "names two bodies that nothing moves: one of them must be free";
            let (path, span) = (format!("{}.between", contact.path), Some(contact.span.clone()));
            root.push(Problem::new(ProblemKind::Conflict, path, message, span));
            return None;
        }
    };
    let touch = contact.touch?;
    let from = |body: usize| touch.point - read[body].centre;
    let moved = (other, from(other));
    let is_fixed = read[other].fixed;
    let touch = Touch::from(ReadTouch { point: from(body), normal: touch.normal * turned, ..touch });
    let meeting = Meeting { body, touch, other: (!is_fixed).then_some(moved) };
    Some(Met { meeting, turned, fixed: is_fixed.then_some(moved) })
}
