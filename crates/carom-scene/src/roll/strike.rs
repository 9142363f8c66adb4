//! One strike: its contacts by name, and every end state that the laws allow.

use super::{RollKind, RollProblem, paper};
use crate::impact_file::{ContactPlaces, ImpactBody, ImpactProblem};
use crate::impact_verdict::Certainty;
use carom_impact::Law;
use carom_impact::planar::end_states::{self, EndStates};
use carom_impact::planar::sharing::Sharing;
use carom_impact::planar::{ContactSet6, ContactState, MOST_CONTACTS, Touch, staged};
use carom_motion::planar::trace::{Impact, ImpactContact};

/// A strike with its contacts in order: those touched before, then those that close.
pub(super) struct Strike {
    pub(super) names: Vec<String>,
    pub(super) contacts: Vec<ImpactContact>,
    /// The same impact as a problem of its own.
    pub(super) problem: ImpactProblem,
    pub(super) ends: EndStates<MOST_CONTACTS>,
    /// Number by which the literature knows it.
    pub(super) number: Option<u8>,
    /// True where the walk ends in none of the end states.
    pub(super) certainty: Certainty,
}

impl Strike {
    /// `None` where the contacts are none that an impact can have: the walk would not have resolved them.
    pub(super) fn new(roll: &RollProblem, impact: &Impact) -> Option<Self> {
        let mut contacts = impact.contacts.clone();
        // On level ground the contact that is further back stands first.
        contacts.sort_by(|a, b| {
            (closes(a), a.obstacle).cmp(&(closes(b), b.obstacle)).then(a.point.x.total_cmp(&b.point.x))
        });
        let names = names(roll, &contacts);
        let touch = |c: &ImpactContact| Touch {
            arm: c.point - impact.pose.centre,
            normal: c.normal,
            friction: c.friction,
            restitution: c.restitution,
        };
        let touches: Vec<Touch> = contacts.iter().map(touch).collect();
        let (velocity, spin) = (impact.before.velocity, impact.before.spin);
        let (mass, inertia) = (roll.world.bodies[0].mass, roll.world.bodies[0].inertia);
        let mut set = ContactSet6::of_free_body(mass, inertia, velocity, spin, &touches).ok()?;
        for (i, c) in contacts.iter().enumerate() {
            // The walk knows which velocities are rounding.
            (set.slip[i], set.normal[i]) = (c.before.slip, c.before.normal);
        }
        let ends = every_end(&set, roll, impact);
        let after = |i: usize| contacts.get(i).map_or([0.0; 2], |c| [c.after.slip, c.after.normal]);
        let certainty = Certainty {
            path_dependent: !ends.reach(&set, &std::array::from_fn(after)),
            branches: impact.branches,
            open_share: impact.open_share,
            ..Certainty::of_ends(ends.found.len())
        };
        let number = number(roll.kind, &set, &contacts);
        let body = ImpactBody { mass, inertia, velocity, spin, touches };
        let problem = ImpactProblem {
            law: impact.law,
            names: names.clone(),
            contacts: set.into(),
            body: Some(body),
            group: None,
            applied: vec![],
            sharing: Sharing::Together,
            by_stiffness: Sharing::ByStiffness { stiffness: [1.0; MOST_CONTACTS], exponent: 1.0 },
            places: ContactPlaces::default(),
        };
        Some(Self { names, contacts, problem, ends, number, certainty })
    }

    /// "1: separates at A, sticks at K", the number where there is one.
    pub(super) fn state(&self) -> String {
        let pairs = self.names.iter().map(String::as_str).zip(self.contacts.iter().map(|c| c.state));
        let words = paper::in_contacts(pairs);
        self.number.map_or(words.clone(), |number| format!("{number}: {words}"))
    }

    /// The literature's words for it.
    pub(super) fn paper(&self, kind: RollKind) -> Option<String> {
        let [a, k] = self.names.as_slice() else { return None };
        Some(paper::words(kind, self.number?, a, k))
    }
}

fn closes(contact: &ImpactContact) -> bool {
    contact.before.normal < 0.0
}

/// Every end state that the laws allow; without a coefficient of friction those of the non-sliding law, which is friction without bound.
fn every_end(set: &ContactSet6, roll: &RollProblem, impact: &Impact) -> EndStates<MOST_CONTACTS> {
    let friction = match roll.friction {
        Some(_) => set.friction,
        None => [f64::INFINITY; MOST_CONTACTS],
    };
    end_states::enumerate(&ContactSet6 { friction, ..*set }, impact.law)
}

/// Supports and surfaces have names of their own; on a plane A is what the body turned about and K what closes.
fn names(roll: &RollProblem, contacts: &[ImpactContact]) -> Vec<String> {
    let on_one_plane = roll.obstacles.len() == 1;
    let mut names: Vec<String> = vec![];
    for contact in contacts {
        let plain = match (on_one_plane, closes(contact)) {
            (true, true) => "K",
            (true, false) => "A",
            (false, _) => roll.obstacle_name(contact.obstacle),
        };
        let before = names.iter().filter(|name| name.trim_end_matches('\'') == plain).count();
        names.push(format!("{plain}{}", "'".repeat(before)));
    }
    names
}

fn number(kind: RollKind, set: &ContactSet6, contacts: &[ImpactContact]) -> Option<u8> {
    let [touched, struck] = contacts else { return None };
    if closes(touched) || !closes(struck) {
        return None;
    }
    let after = [touched.state, struck.state];
    let mut plastic = *set;
    plastic.restitution = [0.0; MOST_CONTACTS];
    let compressed: [ContactState; 2] = match staged::resolve(&plastic, Law::Poisson) {
        Ok(out) => [out.state[0], out.state[1]],
        Err(_) => return None,
    };
    paper::number(kind, compressed, after)
}
