//! What an impact in space says, as JSON: SI, the unit in the key, vectors in the file's axes.

use crate::impact_space::{SpatialImpactAnswer, SpatialImpactProblem};
use crate::impact_space_stage_report::{
    SpatialHypothesisReport, SpatialImpactContactReport, SpatialWalkStageReport,
};
use crate::impact_words::phase_word;
use crate::inequality_report::{InequalityKind, InequalityReport};
use crate::tolerance::STILL_IN_SPACE;
use carom_impact::spatial::{
    Condition, Freedom, Ground, Guess, MOST_EXAMINED, Mode, Refusal, StageEvent, StagedOutcome, staged,
};
use carom_num::Vec3;
use carom_num::cones::narrowest;
use schemars::JsonSchema;
use serde::Serialize;

/// Rejected hypotheses that are told of a stage, or of the law under which nothing slides.
const MOST_REJECTED: usize = 64;

type Set<T> = [T; MOST_EXAMINED];

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
    /// nothing, the rates, or the motion: what sharing among the contacts leaves open.
    pub open: String,
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
    /// unique, several (the walk chose), forced (at some stage no way on is consistent, and one contact is loaded alone) or none.
    pub outcome: String,
    /// False where there may be other ways on than those that were found.
    pub examined: bool,
    /// The law that was used.
    pub law: String,
    /// In which axes impulses and velocities of contacts are.
    pub axes: ImpactAxes,
    /// Where it ends; null where there is no walk.
    pub end: Option<SpatialImpactEndReport>,
    /// Why there is no walk; null where there is one.
    pub not_staged: Option<String>,
    /// The walk.
    pub stages: Vec<SpatialWalkStageReport>,
    /// Every consistent state of the law under which nothing slides, without restitution.
    pub non_sliding: Vec<SpatialKeptReport>,
    /// Its other states, each with what rejects it.
    pub non_sliding_rejected: Vec<SpatialHypothesisReport>,
}

impl SpatialImpactReport {
    /// The answer in words and numbers.
    pub fn new(problem: &SpatialImpactProblem, answer: &SpatialImpactAnswer) -> Self {
        let (non_sliding, non_sliding_rejected) = non_sliding(problem);
        let end = answer.outcome.as_ref().ok();
        Self {
            outcome: match end {
                None => "none",
                Some(end) if end.branches > 1 => "several",
                Some(end) if end.forced > 0 => "forced",
                Some(_) => "unique",
            }
            .to_owned(),
            examined: end.is_some_and(|end| end.examined),
            law: end.map_or(problem.law, |end| end.law).to_string(),
            axes: match (&problem.body, &problem.group) {
                (None, None) => ImpactAxes::Contact,
                _ => ImpactAxes::File,
            },
            end: end.map(|end| end_report(problem, end)),
            not_staged: answer.outcome.as_ref().err().map(ToString::to_string),
            stages: answer.stages.iter().map(|stage| stage_report(problem, stage)).collect(),
            non_sliding,
            non_sliding_rejected,
        }
    }
}

fn contact(
    problem: &SpatialImpactProblem,
    i: usize,
    state: &str,
    [impulse, velocity]: [Vec3; 2],
) -> SpatialImpactContactReport {
    let turned = problem.group.as_ref().map_or(1.0, |group| group.turned[i]);
    let back = |v: Vec3| (problem.contacts.frame[i].transposed() * v * turned).to_array();
    SpatialImpactContactReport {
        name: problem.names[i].clone(),
        state: state.to_owned(),
        impulse: back(impulse),
        normal_impulse: impulse.z,
        velocity_m_s: back(velocity),
        normal_velocity_m_s: velocity.z,
    }
}

fn end_report(problem: &SpatialImpactProblem, end: &StagedOutcome<MOST_EXAMINED>) -> SpatialImpactEndReport {
    let fastest = problem.contacts.velocity.iter().map(|v| v.norm()).fold(0.0, f64::max);
    let state = |v: Vec3| match () {
        () if v.z > STILL_IN_SPACE * fastest => "separates",
        () if v.norm() <= STILL_IN_SPACE * fastest => "sticks",
        () => "slips",
    };
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
        open: match end.freedom {
            Freedom::None => "nothing",
            Freedom::Rates => "the rates",
            Freedom::Motion => "the motion",
        }
        .to_owned(),
        gained_energy: end.gained_energy,
        restitution_scaled: end.restitution_scaled,
    }
}

fn mode_word(mode: Mode) -> &'static str {
    match mode {
        Mode::Open => "open",
        Mode::Slips => "slips",
        Mode::Sticks => "sticks",
        Mode::Starts => "starts to slip",
    }
}

fn stage_report(
    problem: &SpatialImpactProblem,
    stage: &staged::Stage<MOST_EXAMINED>,
) -> SpatialWalkStageReport {
    let set = &problem.contacts;
    let mut rejected = vec![];
    let answer = stage.question(set).solve_observed(&mut |guess, condition, slack| {
        rejected.push(SpatialHypothesisReport {
            hypothesis: guess_words(&problem.names, guess),
            because: condition_words(problem, condition, slack),
            inequality: inequality(problem, condition, -slack, phase_word(stage.phase)),
        });
    });
    let left_out = rejected.len().saturating_sub(MOST_REJECTED);
    rejected.truncate(MOST_REJECTED);
    let forced = ground_words(problem, stage.ground);
    let contacts = (0..set.count).map(|i| {
        contact(problem, i, mode_word(stage.mode[i]), [stage.end.impulse[i], stage.end.velocity[i]])
    });
    SpatialWalkStageReport {
        phase: phase_word(stage.phase).to_owned(),
        ended_by: event_words(problem, stage.ended_by),
        straight: stage.straight,
        contacts: contacts.collect(),
        ways_on: answer
            .iter()
            .filter(|_| forced.is_none())
            .map(|solution| guess_words(&problem.names, &solution.guess))
            .collect(),
        forced,
        examined: answer.examined,
        rejected,
        rejected_left_out: left_out,
    }
}

/// What a hypothesis says of each contact.
pub(crate) fn guess_words(names: &[String], guess: &Set<Guess>) -> String {
    let words = names.iter().zip(guess).map(|(name, guess)| match guess {
        Guess { holds: false, mode: Mode::Open } => format!("{name} open"),
        Guess { holds: true, mode } => format!("{name} {}", mode_word(*mode)),
        // In restitution it separates under the impulse that compression left it.
        Guess { mode, .. } => format!("{name} separates, {}", mode_word(*mode)),
    });
    words.collect::<Vec<_>>().join("; ")
}

/// The inequality that rejects a hypothesis of a stage, as data: a rate problem in space knows by which share it is broken.
fn inequality(
    problem: &SpatialImpactProblem,
    condition: Condition,
    share: f64,
    phase: &'static str,
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
        phase: Some(phase),
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

fn condition_words(problem: &SpatialImpactProblem, condition: Condition, slack: f64) -> String {
    let name = |i: usize| problem.names.get(i).map_or("?", String::as_str);
    let by = |of: &str| match -slack {
        share if share.is_finite() => format!(", by {share:.3} of {of}"),
        _ => String::new(),
    };
    match condition {
        Condition::Pushes(i) => format!("normal impulse at {} < 0{}", name(i), by("all impulses")),
        Condition::Opens(i) => format!("{} would still approach{}", name(i), by("its velocities")),
        Condition::WithinCone(i) => {
            format!("tangential impulse at {} beyond friction{}", name(i), by("both"))
        }
        Condition::Starts(i) => format!("no direction in which {} would slip against its friction", name(i)),
        Condition::Solvable => "its equations have no solution".to_owned(),
    }
}

/// Why a stage is walked that no consistent hypothesis says.
fn ground_words(problem: &SpatialImpactProblem, ground: Ground) -> Option<String> {
    let name = |i: usize| problem.names.get(i).map_or("?", String::as_str);
    match ground {
        Ground::Consistent => None,
        Ground::DrivenIn(i) => Some(format!(
            "friction drives {} in (Painlevé's paradox): it is loaded until a slip stops",
            name(i)
        )),
        Ground::FastestFirst(i) => Some(format!("{} approaches fastest and is loaded first", name(i))),
    }
}

fn event_words(problem: &SpatialImpactProblem, event: StageEvent) -> String {
    let name = |i: usize| problem.names.get(i).map_or("?", String::as_str);
    match event {
        StageEvent::SlipStops(i) => format!("slip stops at {}", name(i)),
        StageEvent::Closes(i) => format!("{} closes", name(i)),
        StageEvent::Opens(i) => format!("{} opens", name(i)),
        StageEvent::SlipStarts(i) => format!("slip starts at {}", name(i)),
        StageEvent::Loads(i) => format!("{} takes an impulse", name(i)),
        StageEvent::DrivenIn => "friction drives it in".to_owned(),
        StageEvent::Repaid(i) => format!("{} has returned its work", name(i)),
        StageEvent::CompressionEnds => "compression ends".to_owned(),
        StageEvent::RestitutionEnds => "restitution ends".to_owned(),
    }
}

/// Every state of the law under which nothing slides.
fn non_sliding(problem: &SpatialImpactProblem) -> (Vec<SpatialKeptReport>, Vec<SpatialHypothesisReport>) {
    let (set, n) = (&problem.contacts, problem.names.len());
    let states = set.states_of_keeping();
    let words = |kept: &Set<bool>| {
        let each = problem.names.iter().zip(kept);
        let words: Vec<String> =
            each.map(|(name, kept)| format!("{name} {}", if *kept { "keeps" } else { "open" })).collect();
        words.join("; ")
    };
    let consistent = states.consistent.iter().map(|state| {
        let demand = narrowest(&state.impulse, &state.free);
        SpatialKeptReport {
            hypothesis: words(&state.kept),
            normal_impulses: state.impulse[..n].iter().map(|p| p.z).collect(),
            normal_velocities_m_s: state.velocity[..n].iter().map(|v| v.z).collect(),
            friction_demand: demand.is_finite().then_some(demand),
        }
    });
    let name = |i: usize| problem.names.get(i).map_or("?", String::as_str);
    let rejected = states.refused.iter().take(MOST_REJECTED).map(|refused| {
        let because = match refused.refusal {
            Refusal::Pulls(i) => {
                format!("normal impulse at {} = {:.6} N s < 0: it would pull", name(i), refused.amount)
            }
            Refusal::Approaches(i) => {
                format!("normal velocity of {} = {:.6} m/s < 0: it would go on down", name(i), refused.amount)
            }
            Refusal::Unsolvable => "no impulses bring these contacts to rest".to_owned(),
        };
        let inequality = refusal(problem, refused.refusal, refused.amount);
        SpatialHypothesisReport { hypothesis: words(&refused.kept), because, inequality }
    });
    (consistent.collect(), rejected.collect())
}
