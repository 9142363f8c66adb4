//! Several bodies that meet in space, free, fixed or moved: `[[body]]` with a name each, and contacts `between` two of them.

use crate::grammar::Section;
use crate::impact_bodies::{BodyKind, read_meeting, tell_twins};
use crate::impact_space::SpatialImpactProblem;
use crate::impact_space_read::{ReadContact, read_motion, read_rigid, vector};
use crate::problem::{Problem, ProblemKind};
use carom_impact::planar::{ImpactError, Law};
use carom_impact::spatial::{ContactSet, Meeting, RigidBody, Touch, struck};
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
    name: String,
    fixed: bool,
    body: Option<RigidBody>,
    centre: Vec3,
}

/// The bodies, and the contacts between them.
pub(crate) fn read_group(law: Law, root: &Section<'_>, list: &[ReadContact]) -> Option<SpatialImpactProblem> {
    let read: Vec<ReadBody> = root.sections("body").into_iter().flatten().enumerate().map(read_one).collect();
    let names: Vec<String> = read.iter().map(|body| body.name.clone()).collect();
    tell_twins(root, &names);
    let meetings: Vec<_> = list.iter().map(|contact| meeting(root, &names, &read, contact)).collect();
    let (meetings, turned): (Vec<Meeting>, Vec<f64>) =
        meetings.into_iter().collect::<Option<Vec<_>>>()?.into_iter().unzip();
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
    for (i, (contact, met)) in list.iter().zip(&meetings).enumerate() {
        if met.other.is_none() {
            // What does not yield may move all the same.
            let [into, out_of] = read_meeting(root, &names, &contact.path, contact.between.as_ref())?;
            let fixed = if into == met.body { out_of } else { into };
            let moved = bodies[fixed].velocity_at(contact.touch?.arm - read[fixed].centre);
            contacts.velocity[i] -= contacts.frame[i] * moved;
        }
    }
    let fixed = read.iter().map(|body| body.fixed).collect();
    let group = SpatialGroup { names, bodies, fixed, meetings, turned };
    let names = list.iter().map(|contact| contact.name.clone()).collect();
    Some(SpatialImpactProblem { law, names, body: None, touches: vec![], group: Some(group), contacts })
}

fn read_one((number, section): (usize, Section<'_>)) -> ReadBody {
    let name =
        section.text("name").map_or_else(|| format!("body {}", number + 1), |(name, _)| name.to_owned());
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

/// A meeting whose first body is free, and −1 where that turns the file's normal round.
fn meeting(
    root: &Section<'_>,
    names: &[String],
    read: &[ReadBody],
    contact: &ReadContact,
) -> Option<(Meeting, f64)> {
    let [into, out_of] = read_meeting(root, names, &contact.path, contact.between.as_ref())?;
    let (body, other, sign) = match (read[into].fixed, read[out_of].fixed) {
        (false, false) => (into, Some(out_of), 1.0),
        (false, true) => (into, None, 1.0),
        (true, false) => (out_of, None, -1.0),
        (true, true) => {
            let message = "names two bodies that nothing moves: one of them must be free";
            let (path, span) = (format!("{}.between", contact.path), Some(contact.span.clone()));
            root.push(Problem::new(ProblemKind::Conflict, path, message, span));
            return None;
        }
    };
    let Touch { arm: point, normal, .. } = contact.touch?;
    let touch = Touch { arm: point - read[body].centre, normal: normal * sign, ..contact.touch? };
    let other = other.map(|other| (other, point - read[other].centre));
    Some((Meeting { body, touch, other }, sign))
}
