//! One impact in the plane by plain numbers: checked as an impact file is, and resolved as one.

use crate::plain::{self, Contact, ContactEnd, ContactState, EndState, ImpactResult, Outcome};
use crate::refusal::Refusal;
use carom_impact::Law;
use carom_impact::planar::{self, Touch};
use carom_num::Vec2;
use carom_scene::quantity::{Allowed, Kind};
use carom_scene::unit::Dimension;
use carom_scene::{
    EndReport, EndStateReport, ImpactAnswer, ImpactAnswerReport, ImpactBody, ImpactOutcome, ImpactProblem,
    Word,
};
use carom_words::Words;
use std::ffi::c_int;
use std::fmt::Write as _;

/// The laws, by their numbers.
const LAWS: [Law; 3] = [Law::Poisson, Law::Stronge, Law::Newton];

/// An impact that was resolved.
pub(crate) struct Struck {
    pub(crate) problem: ImpactProblem,
    pub(crate) answer: ImpactAnswer,
}

impl Struck {
    /// Resolves an impact.
    pub(crate) fn of(given: &plain::ImpactProblem, contacts: &[Contact]) -> Result<Self, Refusal> {
        let problem = problem(given, contacts).ok_or_else(|| refusal(given, contacts))?;
        let answer = problem.solve_as_asked();
        Ok(Self { problem, answer })
    }

    /// What it does as a whole.
    pub(crate) fn result(&self) -> ImpactResult {
        let Self { problem, answer } = self;
        let before = problem.body.as_ref().map(|body| (body.velocity, body.spin));
        let after = answer.walk().and_then(|walk| problem.body_after(&walk.outcome.impulse));
        let energy =
            |moves: Option<(Vec2, f64)>| moves.and_then(|(velocity, spin)| problem.energy(velocity, spin));
        let (velocity, spin) = after.unwrap_or((Vec2::new(f64::NAN, f64::NAN), f64::NAN));
        let certainty = answer.certainty();
        ImpactResult {
            outcome: outcome(certainty.outcome()),
            law: law(answer.law(problem)),
            walked: after.is_some(),
            velocity: [velocity.x, velocity.y],
            spin,
            energy_before: energy(before).unwrap_or(f64::NAN),
            energy_after: energy(after).unwrap_or(f64::NAN),
            end_state_count: certainty.ends,
        }
    }

    /// Each contact at the end of the walk; where there is none, contacts of which nothing is known but that they take no impulse.
    pub(crate) fn ends(&self) -> Vec<ContactEnd> {
        let Some(walk) = self.answer.walk() else {
            let unknown = ContactEnd {
                state: ContactState::Separates,
                normal_impulse: f64::NAN,
                tangential_impulse: f64::NAN,
                normal_velocity: f64::NAN,
                slip: f64::NAN,
            };
            return vec![unknown; self.problem.contacts.count()];
        };
        let out = &walk.outcome;
        let all = out.impulse.iter().zip(&out.velocity).zip(&out.state).take(walk.contacts);
        all.map(|(([tangential, normal], [slip, normal_velocity]), end)| ContactEnd {
            state: state(*end),
            normal_impulse: *normal,
            tangential_impulse: *tangential,
            normal_velocity: *normal_velocity,
            slip: *slip,
        })
        .collect()
    }

    /// Every consistent end state, as the command's answer has it.
    pub(crate) fn end_states(&self) -> EndStates {
        EndStates { all: ImpactAnswerReport::new(&self.problem, &self.answer).end_states }
    }

    /// Why there is no answer.
    pub(crate) fn undone(&self) -> Option<Refusal> {
        let why = self.answer.undone()?;
        let why = carom_words::impact::failure(&self.problem.names, &why);
        Some(Refusal::of_failure(format!("no answer: {why}")))
    }
}

/// The end states of an impact.
pub struct EndStates {
    all: Vec<EndStateReport>,
}

impl EndStates {
    /// How many there are.
    pub(crate) fn count(&self) -> usize {
        self.all.len()
    }

    /// One of them, and its contacts.
    pub(crate) fn read(&self, index: usize) -> Option<(EndState, Vec<ContactEnd>)> {
        let report = self.all.get(index)?;
        let EndReport { contacts, velocity_m_s, spin_rad_s, energy_after, .. } = &report.end;
        let ends = contacts.iter().map(|contact| {
            let Word(end) = contact.state;
            ContactEnd {
                state: state(end),
                normal_impulse: contact.normal_impulse,
                tangential_impulse: contact.tangential_impulse,
                normal_velocity: contact.normal_velocity_m_s,
                slip: contact.slip_m_s,
            }
        });
        let whole = EndState {
            velocity: velocity_m_s.unwrap_or([f64::NAN; 2]),
            spin: spin_rad_s.unwrap_or(f64::NAN),
            energy_after: energy_after.unwrap_or(f64::NAN),
            margin: report.margin.unwrap_or(f64::INFINITY),
            indeterminate: report.indeterminate,
            gained_energy: report.gained_energy,
            contact_count: contacts.len(),
        };
        Some((whole, ends.collect()))
    }
}

/// The impact that a file with these numbers would say; `None` where such a file would be refused.
fn problem(given: &plain::ImpactProblem, contacts: &[Contact]) -> Option<ImpactProblem> {
    let law = *LAWS.get(usize::try_from(given.law).ok()?)?;
    let plain::Body { mass, inertia, velocity, spin } = given.body;
    let holds = |dimension, allowed, value| Kind::new(dimension, allowed).holds(value);
    let any = |dimension, values: [f64; 2]| values.iter().all(|v| holds(dimension, Allowed::Any, *v));
    let good = holds(Dimension::Mass, Allowed::Positive, mass)
        && holds(Dimension::Inertia, Allowed::Positive, inertia)
        && any(Dimension::Speed, velocity)
        && holds(Dimension::Spin, Allowed::Any, spin);
    let touch = |contact: &Contact| {
        let Contact { point, normal, friction, restitution } = *contact;
        let good = any(Dimension::Length, point)
            && any(Dimension::Number, normal)
            && holds(Dimension::Number, Allowed::Coefficient, friction)
            && holds(Dimension::Number, Allowed::Fraction, restitution);
        let normal = Vec2::new(normal[0], normal[1]).unit().filter(|_| good)?;
        Some(Touch { arm: Vec2::new(point[0], point[1]), normal, friction, restitution })
    };
    let touches: Vec<Touch> = contacts.iter().map(touch).collect::<Option<_>>()?;
    if !good || touches.is_empty() {
        return None;
    }
    let velocity = Vec2::new(velocity[0], velocity[1]);
    ImpactProblem::of_body(law, ImpactBody { mass, inertia, velocity, spin, touches }).ok()
}

/// Everything that is wrong with the numbers, as the reader of impact files tells it.
fn refusal(given: &plain::ImpactProblem, contacts: &[Contact]) -> Refusal {
    match ImpactProblem::parse("impact", &file(given, contacts)) {
        Err(problems) => problems.into(),
        Ok(_) => Refusal::of_fault("numbers that an impact file may have were refused"),
    }
}

/// The same as an impact file.
fn file(given: &plain::ImpactProblem, contacts: &[Contact]) -> String {
    let plain::Body { mass, inertia, velocity: [x, y], spin } = given.body;
    let mut text = format!(
        "law = {}\nbody = {{ mass = {}, inertia = {}, velocity = [{}, {}], spin = {} }}\ncontact = [\n",
        law_word(given.law),
        number(mass),
        number(inertia),
        number(x),
        number(y),
        number(spin),
    );
    for Contact { point, normal, friction, restitution } in contacts {
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "  {{ point = [{}, {}], normal = [{}, {}], friction = {}, restitution = {} }},",
            number(point[0]),
            number(point[1]),
            number(normal[0]),
            number(normal[1]),
            number(*friction),
            number(*restitution),
        );
    }
    text + "]\n"
}

/// A number as TOML writes it, to the last digit.
fn number(value: f64) -> String {
    if value.is_nan() { "nan".to_owned() } else { format!("{value:?}") }
}

/// The word of a law, in quotes; a number that is none stands there itself, and the reader says which words may.
fn law_word(number: c_int) -> String {
    let law = usize::try_from(number).ok().and_then(|number| LAWS.get(number));
    format!("{:?}", law.map_or_else(|| number.to_string(), |law| law.word().to_owned()))
}

fn law(law: Law) -> plain::Law {
    match law {
        Law::Poisson => plain::Law::Poisson,
        Law::Stronge => plain::Law::Stronge,
        Law::Newton => plain::Law::Newton,
    }
}

fn state(state: planar::ContactState) -> ContactState {
    match state {
        planar::ContactState::Separates => ContactState::Separates,
        planar::ContactState::Sticks => ContactState::Sticks,
        planar::ContactState::Slips => ContactState::Slips,
    }
}

fn outcome(outcome: ImpactOutcome) -> Outcome {
    match outcome {
        ImpactOutcome::Unique => Outcome::Unique,
        ImpactOutcome::Several => Outcome::Several,
        ImpactOutcome::PathDependent => Outcome::PathDependent,
        ImpactOutcome::None => Outcome::None,
        ImpactOutcome::Unresolved => Outcome::Unresolved,
        ImpactOutcome::Found => Outcome::Found,
        ImpactOutcome::NotFound => Outcome::NotFound,
    }
}

#[cfg(test)]
mod tests;
