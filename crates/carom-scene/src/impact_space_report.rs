//! What an impact in space says, as JSON: SI, the unit in the key, vectors in the file's axes.

use crate::impact_event_report::{ForcedReport, ImpactEventReport, ImpactFailure};
use crate::impact_report::MOST_REJECTED;
use crate::impact_space::{SpatialImpactAnswer, SpatialImpactProblem};
use crate::impact_space_stage_report::{
    SpatialContactState, SpatialHypothesisReport, SpatialImpactContactReport, SpatialWalkStageReport,
};
use crate::inequality_report::{InequalityKind, InequalityReport};
use crate::tolerance::STILL_IN_SPACE;
use crate::word::Word;
use carom_impact::planar::ContactState;
use carom_impact::spatial::{
    Conclusion, Condition, Freedom, Guess, MOST_EXAMINED, Mode, Refusal, StagedOutcome, StatesOfKeeping,
    staged,
};
use carom_impact::{Law, Phase};
use carom_num::Vec3;
use carom_num::cones::narrowest;
use carom_words::{impact, impact_space};
use schemars::JsonSchema;
use serde::Serialize;

/// Rejected hypotheses that are told of one stage of many.
const MOST_REJECTED_OF_A_STAGE: usize = 64;

/// Where an impact in space ends.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpatialImpactEndReport {
    /// The contacts.
    pub contacts: Vec<SpatialImpactContactReport>,
    /// Velocity of the mass centre of the one body [m/s]; null where there are several, or none is known.
    pub velocity_m_s: Option<[f64; 3]>,
    /// Spin of the one body [rad/s]; null where there are several, or none is known.
    pub spin_rad_s: Option<[f64; 3]>,
    /// Kinetic energy before of all that can be moved [J]; null without a body.
    #[serde(rename = "energy_before_J")]
    pub energy_before: Option<f64>,
    /// Kinetic energy after [J]; null without a body.
    #[serde(rename = "energy_after_J")]
    pub energy_after: Option<f64>,
    /// Where several bodies meet: each of them; else empty.
    pub bodies: Vec<SpatialBodyReport>,
    /// Largest quotient of a tangential and a normal impulse.
    pub friction_demand: Option<f64>,
    /// What sharing among the contacts leaves open.
    pub open: Word<Freedom>,
    /// Restitution created energy (possible under Newton's law).
    pub gained_energy: bool,
    /// Common factor on all restitutions that keeps energy from growing; 1 where none is needed.
    pub restitution_scaled: f64,
}

/// One of several bodies after an impact in space.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpatialBodyReport {
    /// Its name.
    pub name: String,
    /// Velocity of its mass centre after [m/s].
    pub velocity_m_s: [f64; 3],
    /// Spin after [rad/s].
    pub spin_rad_s: [f64; 3],
}

/// In which axes impulses and velocities of contacts are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ImpactAxes {
    /// The file's.
    File,
    /// Each contact's own, where only the operator is known: tangent 1, tangent 2, normal.
    Contact,
}

/// A consistent state of the law under which nothing slides.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpatialKeptReport {
    /// Which contacts keep.
    pub hypothesis: String,
    /// Normal impulses of all contacts [N s].
    #[serde(rename = "normal_impulses_N_s")]
    pub normal_impulses: Vec<f64>,
    /// Normal velocities of all contacts after [m/s].
    pub normal_velocities_m_s: Vec<f64>,
    /// The least friction with which no contact slides; null where none is enough.
    pub friction_demand: Option<f64>,
}

/// The answer to an impact in space.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "carom impact, in space")]
pub struct SpatialImpactReport {
    /// Whether there is one answer: several where the walk chose, forced where at some stage no way on is consistent and one contact is loaded alone.
    pub outcome: Word<Conclusion>,
    /// False where there may be other ways on than those that were found.
    pub examined: bool,
    /// The law that was used.
    pub law: Word<Law>,
    /// In which axes impulses and velocities of contacts are.
    pub axes: ImpactAxes,
    /// Where it ends; null where there is no walk.
    pub end: Option<SpatialImpactEndReport>,
    /// Why there is no walk, in words; null where there is one.
    pub not_staged: Option<String>,
    /// The same as data.
    pub failure: Option<ImpactFailure>,
    /// The walk.
    pub stages: Vec<SpatialWalkStageReport>,
    /// Every consistent state of the law under which nothing slides, without restitution.
    pub non_sliding: Vec<SpatialKeptReport>,
    /// Its other states, each with what rejects it, 4096 at most.
    pub non_sliding_rejected: Vec<SpatialHypothesisReport>,
    /// Rejected states beyond those that are told.
    pub non_sliding_rejected_left_out: usize,
}

impl SpatialImpactReport {
    /// The answer in words and numbers.
    pub fn new(problem: &SpatialImpactProblem, answer: &SpatialImpactAnswer) -> Self {
        let states = problem.contacts.states_of_keeping();
        let end = answer.outcome.as_ref().ok();
        Self {
            outcome: Word(end.map_or(Conclusion::None, StagedOutcome::conclusion)),
            examined: end.is_some_and(|end| end.examined),
            law: Word(end.map_or(problem.law, |end| end.law)),
            axes: match (&problem.body, &problem.group) {
                (None, None) => ImpactAxes::Contact,
                _ => ImpactAxes::File,
            },
            end: end.map(|end| end_report(problem, end)),
            not_staged: answer.outcome.as_ref().err().map(|error| impact::failure(&problem.names, error)),
            failure: answer.outcome.as_ref().err().map(ImpactFailure::of),
            stages: answer.stages.iter().map(|stage| stage_report(problem, stage)).collect(),
            non_sliding: non_sliding(problem, &states),
            non_sliding_rejected: non_sliding_rejected(problem, &states),
            non_sliding_rejected_left_out: states.refused.len().saturating_sub(MOST_REJECTED),
        }
    }
}

fn contact(
    problem: &SpatialImpactProblem,
    i: usize,
    state: SpatialContactState,
    [impulse, velocity]: [Vec3; 2],
) -> SpatialImpactContactReport {
    let turned = problem.group.as_ref().map_or(1.0, |group| group.turned[i]);
    let back = |v: Vec3| (problem.contacts.frame[i].transposed() * v * turned).to_array();
    SpatialImpactContactReport {
        name: problem.names[i].clone(),
        state,
        impulse: back(impulse),
        normal_impulse: impulse.z,
        velocity_m_s: back(velocity),
        normal_velocity_m_s: velocity.z,
    }
}

fn end_report(problem: &SpatialImpactProblem, end: &StagedOutcome<MOST_EXAMINED>) -> SpatialImpactEndReport {
    let fastest = problem.contacts.velocity.iter().map(|v| v.norm()).fold(0.0, f64::max);
    let state = |v: Vec3| match () {
        () if v.z > STILL_IN_SPACE * fastest => ContactState::Separates,
        () if v.norm() <= STILL_IN_SPACE * fastest => ContactState::Sticks,
        () => ContactState::Slips,
    };
    let state = |v: Vec3| SpatialContactState::After(Word(state(v)));
    let contacts = (0..problem.names.len())
        .map(|i| contact(problem, i, state(end.velocity[i]), [end.impulse[i], end.velocity[i]]));
    let after = problem.after(end);
    let group = problem.group.as_ref().and_then(|group| Some((group, group.after(&end.impulse).ok()?)));
    let before = problem.body.map(|body| body.energy()).or(group.as_ref().map(|(g, _)| g.energy(&g.bodies)));
    let bodies = group.iter().flat_map(|(group, after)| group.names.iter().zip(after)).map(|(name, body)| {
        let (velocity_m_s, spin_rad_s) = (body.velocity.to_array(), body.spin.to_array());
        SpatialBodyReport { name: name.clone(), velocity_m_s, spin_rad_s }
    });
    let demand = end.friction_demand();
    SpatialImpactEndReport {
        contacts: contacts.collect(),
        velocity_m_s: after.map(|body| body.velocity.to_array()),
        spin_rad_s: after.map(|body| body.spin.to_array()),
        energy_before: before,
        energy_after: after.map(|body| body.energy()).or(group.as_ref().map(|(g, after)| g.energy(after))),
        bodies: bodies.collect(),
        friction_demand: demand.is_finite().then_some(demand),
        open: Word(end.freedom),
        gained_energy: end.gained_energy,
        restitution_scaled: end.restitution_scaled,
    }
}

fn stage_report(
    problem: &SpatialImpactProblem,
    stage: &staged::Stage<MOST_EXAMINED>,
) -> SpatialWalkStageReport {
    let (set, names) = (&problem.contacts, &problem.names);
    let modes = |guess: &[Guess]| guess[..names.len()].iter().map(|guess| Word(guess.mode)).collect();
    let mut rejected = vec![];
    let answer = stage.question(set).solve_observed(&mut |guess, condition, slack| {
        rejected.push(SpatialHypothesisReport {
            hypothesis: impact_space::hypothesis(names, guess),
            states: modes(guess),
            because: impact_space::because(names, condition, -slack),
            inequality: inequality(problem, condition, -slack, stage.phase),
        });
    });
    let left_out = rejected.len().saturating_sub(MOST_REJECTED_OF_A_STAGE);
    rejected.truncate(MOST_REJECTED_OF_A_STAGE);
    let forced = impact_space::ground(names, stage.ground, &stage.clocks);
    let contacts = (0..set.count).map(|i| {
        contact(
            problem,
            i,
            SpatialContactState::In(Word(stage.mode[i])),
            [stage.end.impulse[i], stage.end.velocity[i]],
        )
    });
    SpatialWalkStageReport {
        phase: Word(stage.phase),
        ended_by: impact_space::stage_end(names, stage.ended_by),
        event: ImpactEventReport::in_space(stage.ended_by, names),
        straight: stage.straight,
        contacts: contacts.collect(),
        ways_on: answer
            .iter()
            .filter(|_| forced.is_none())
            .map(|solution| impact_space::hypothesis(names, &solution.guess))
            .collect(),
        ways: answer.iter().filter(|_| forced.is_none()).map(|solution| modes(&solution.guess)).collect(),
        forced,
        forced_at: ForcedReport::new(stage.ground, names),
        examined: answer.examined,
        rejected,
        rejected_left_out: left_out,
    }
}

/// The inequality that rejects a hypothesis of a stage, as data: a rate problem in space knows by which share it is broken.
fn inequality(
    problem: &SpatialImpactProblem,
    condition: Condition,
    share: f64,
    phase: Phase,
) -> InequalityReport {
    let (kind, contact, unit) = match condition {
        Condition::Pushes(i) => (InequalityKind::NormalImpulse, Some(i), "N s"),
        Condition::Opens(i) => (InequalityKind::NormalVelocity, Some(i), "m/s"),
        Condition::WithinCone(i) => (InequalityKind::FrictionCone, Some(i), "N s"),
        Condition::Starts(i) => (InequalityKind::SlipDirection, Some(i), "m/s"),
        Condition::Solvable => (InequalityKind::Equations, None, ""),
    };
    InequalityReport {
        kind,
        contact: contact.and_then(|i| problem.names.get(i).cloned()),
        amount: None,
        unit,
        share: Some(share).filter(|share| share.is_finite()),
        phase: Some(Word(phase)),
    }
}

/// The inequality that refuses a state of the law under which nothing slides, as data: its amount.
fn refusal(problem: &SpatialImpactProblem, refusal: Refusal, amount: f64) -> InequalityReport {
    let (kind, contact, unit) = match refusal {
        Refusal::Pulls(i) => (InequalityKind::NormalImpulse, Some(i), "N s"),
        Refusal::Approaches(i) => (InequalityKind::NormalVelocity, Some(i), "m/s"),
        Refusal::Unsolvable => (InequalityKind::Equations, None, ""),
    };
    InequalityReport {
        kind,
        contact: contact.and_then(|i| problem.names.get(i).cloned()),
        amount: contact.map(|_| -amount).filter(|amount| amount.is_finite()),
        unit,
        share: None,
        phase: None,
    }
}

/// Every state that the law under which nothing slides allows.
fn non_sliding(
    problem: &SpatialImpactProblem,
    states: &StatesOfKeeping<MOST_EXAMINED>,
) -> Vec<SpatialKeptReport> {
    let n = problem.names.len();
    let consistent = states.consistent.iter().map(|state| {
        let demand = narrowest(&state.impulse, &state.free);
        SpatialKeptReport {
            hypothesis: impact_space::keeping(&problem.names, &state.kept),
            normal_impulses: state.impulse[..n].iter().map(|p| p.z).collect(),
            normal_velocities_m_s: state.velocity[..n].iter().map(|v| v.z).collect(),
            friction_demand: demand.is_finite().then_some(demand),
        }
    });
    consistent.collect()
}

/// What rejects its other states.
fn non_sliding_rejected(
    problem: &SpatialImpactProblem,
    states: &StatesOfKeeping<MOST_EXAMINED>,
) -> Vec<SpatialHypothesisReport> {
    let names = &problem.names;
    let does = |kept: &bool| Word(if *kept { Mode::Sticks } else { Mode::Open });
    let rejected = states.refused.iter().take(MOST_REJECTED).map(|refused| SpatialHypothesisReport {
        hypothesis: impact_space::keeping(names, &refused.kept),
        states: refused.kept[..names.len()].iter().map(does).collect(),
        because: impact_space::refused(names, refused.refusal, refused.amount),
        inequality: refusal(problem, refused.refusal, refused.amount),
    });
    rejected.collect()
}
