//! What an impact says, as JSON: SI, the unit in the key.

use crate::impact_answer::{Examined, ImpactAnswer, Shared, Walk};
use crate::impact_bodies::energy_of;
use crate::impact_end_report::{
    BodyReport, EndContactReport, EndReport, OpenShareReport, ShareTaken, SharingReport, StageContactReport,
    WalkStageReport,
};
use crate::impact_event_report::{ImpactEventReport, ImpactFailure};
use crate::impact_file::ImpactProblem;
use crate::impact_verdict::{ImpactOutcome, Uniqueness};
use crate::inequality_report::InequalityReport;
use crate::tolerance::WORK_ROUNDING;
use crate::word::Word;
use carom_impact::Law;
use carom_impact::planar::{
    Class, ContactState, MOST_CONTACTS, Slip,
    end_states::{EndState, Rejected},
    share::Share,
    staged::{self, StagedOutcome},
};
use carom_words::impact::{self, Clock};
use schemars::JsonSchema;
use serde::Serialize;

/// Rejected hypotheses that are told: all of four contacts; six have some fifty thousand.
pub(crate) const MOST_REJECTED: usize = 4096;

/// The staged walk.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct StagedReport {
    /// Where it ends.
    #[serde(flatten)]
    pub end: EndReport,
    /// Type 1 to 7, where one contact acts.
    #[serde(rename = "type")]
    pub kind: Option<u8>,
    /// Class of Wang and Mason, where one contact acts.
    pub class: Option<Word<Class>>,
    /// Its straight stages.
    pub stages: Vec<WalkStageReport>,
    /// Largest number of consistent continuations met at a stage.
    pub branches: usize,
    /// True where it ends in none of the end states: the end depends on the way there.
    pub path_dependent: bool,
    /// False where the walk obeys another law than the end states, Stronge's or that of springs: the two are not compared then.
    pub end_states_compared: bool,
    /// What the ends of the shares of compression leave, where these are open and another share leaves another motion; else empty.
    pub open_shares: Vec<OpenShareReport>,
    /// True where the law created energy.
    pub gained_energy: bool,
    /// Common factor on the coefficients of restitution that kept energy from growing; 1 where none was needed.
    pub restitution_scaled: f64,
    /// True where friction, not approach, forced the impact.
    pub without_approach: bool,
}

/// A consistent end state.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EndStateReport {
    /// What each contact does: "A slips+, B sticks".
    pub hypothesis: String,
    /// Where it ends.
    #[serde(flatten)]
    pub end: EndReport,
    /// Smallest slack divided by the sum of its terms' magnitudes.
    pub margin: Option<f64>,
    /// The impulses are not determined, the motion is; but where uniqueness is not examined and there is restitution by Poisson's law,
    /// which multiplies the impulses that were taken, the motion may be open too.
    pub indeterminate: bool,
    /// True where the impulses do positive work: restitution created energy.
    pub gained_energy: bool,
}

/// A hypothesis that is not consistent.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RejectedReport {
    /// What each contact was supposed to do.
    pub hypothesis: String,
    /// The same as data, in the order of the contacts: while the impulse grows, or from now on under forces.
    pub slips: Vec<Word<Slip>>,
    /// The inequality that fails, in words.
    pub because: String,
    /// The same as data.
    pub inequality: InequalityReport,
}

/// The numbers that decide the class at one contact.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DecidersReport {
    /// `P_d` of Wang and Mason.
    pub p_d: f64,
    /// `P_q` of Wang and Mason.
    pub p_q: f64,
    /// Friction that holds the contact without slip.
    pub mu_s: f64,
    /// The inequality that decided.
    pub because: String,
}

/// The answer to an impact.
///
/// # Example
/// ```
/// use carom_scene::*;
/// # let ball = ImpactProblem::parse("ball.toml", r#"
/// #     body = { mass = 2, inertia = 0.4, velocity = [0, -3] }
/// #     contact = [{ point = [0, -1], normal = [0, 1], friction = 0.3, restitution = 0.5 }]
/// # "#)?;
/// let report = ImpactAnswerReport::new(&ball, &ball.solve());
/// assert_eq!((report.outcome, report.uniqueness), (ImpactOutcome::Unique, Uniqueness::Examined));
/// assert_eq!(report.law.as_str(), "poisson");
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "carom impact")]
pub struct ImpactAnswerReport {
    /// Whether this is the only answer.
    pub outcome: ImpactOutcome,
    /// Whether every end state was examined.
    pub uniqueness: Uniqueness,
    /// The law that the answer obeys: Poisson's where several contacts close, Stronge's where they share as springs.
    pub law: Word<Law>,
    /// The staged walk; null where there is none.
    pub staged: Option<StagedReport>,
    /// Why there is no staged walk, in words.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub not_staged: Option<String>,
    /// The same as data.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub failure: Option<ImpactFailure>,
    /// What decided the class, at one contact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub decided_by: Option<DecidersReport>,
    /// What the conventions on sharing say, where several contacts act; else empty.
    pub sharing: Vec<SharingReport>,
    /// Every consistent end state; the one that was found where uniqueness is not examined.
    pub end_states: Vec<EndStateReport>,
    /// The other hypotheses, 4096 at most; empty where uniqueness is not examined.
    pub rejected: Vec<RejectedReport>,
    /// Rejected hypotheses beyond those that are told.
    pub rejected_left_out: usize,
}

impl ImpactAnswerReport {
    /// The report of an answer.
    pub fn new(problem: &ImpactProblem, answer: &ImpactAnswer) -> Self {
        let law = Word(answer.law(problem));
        match answer {
            ImpactAnswer::Examined(examined) => {
                examined_report(problem, examined, answer.certainty().outcome(), law)
            }
            ImpactAnswer::Pivoted(found) => {
                let certainty = answer.certainty();
                let found = found.as_ref();
                let limit = format!("more than {MOST_CONTACTS} contacts are not walked in stages");
                Self {
                    outcome: certainty.outcome(),
                    uniqueness: Uniqueness::NotExamined,
                    law,
                    staged: None,
                    failure: Some(found.err().map_or(ImpactFailure::TooMany, ImpactFailure::of)),
                    not_staged: Some(
                        found.err().map_or(limit, |error| impact::failure(&problem.names, error)),
                    ),
                    decided_by: None,
                    sharing: vec![],
                    end_states: found.ok().map(|end| end_state_report(problem, end)).into_iter().collect(),
                    rejected: vec![],
                    rejected_left_out: 0,
                }
            }
        }
    }
}

fn examined_report(
    problem: &ImpactProblem,
    answer: &Examined,
    outcome: ImpactOutcome,
    law: Word<Law>,
) -> ImpactAnswerReport {
    let Examined { walk, ends, deciders, shared } = answer;
    ImpactAnswerReport {
        outcome,
        uniqueness: Uniqueness::Examined,
        law,
        staged: walk.as_ref().ok().map(|walk| staged_report(problem, walk)),
        not_staged: walk.as_ref().err().map(|error| impact::failure(&problem.names, error)),
        failure: walk.as_ref().err().map(ImpactFailure::of),
        decided_by: deciders.as_ref().map(|deciders| DecidersReport {
            p_d: deciders.slip_demand,
            p_q: deciders.friction_supply,
            mu_s: deciders.sticking_friction,
            because: deciders.because.clone(),
        }),
        sharing: shared.iter().map(|shared| sharing_report(problem, shared)).collect(),
        end_states: ends.found.iter().map(|end| end_state_report(problem, end)).collect(),
        rejected: ends.rejected.iter().take(MOST_REJECTED).map(|r| rejected_report(problem, r)).collect(),
        rejected_left_out: ends.rejected.len().saturating_sub(MOST_REJECTED),
    }
}

fn staged_report(problem: &ImpactProblem, walk: &Walk) -> StagedReport {
    let outcome = &walk.outcome;
    StagedReport {
        end: end_report(problem, &outcome.impulse, &outcome.velocity, |i| outcome.state[i]),
        kind: walk.kind.map(|kind| kind.number()),
        class: walk.kind.map(|kind| Word(kind.class())),
        stages: walk.stages.iter().map(|stage| stage_report(problem, stage)).collect(),
        branches: outcome.branches,
        path_dependent: walk.path_dependent,
        end_states_compared: walk.compared,
        open_shares: walk.shares.iter().map(|(share, out)| open_share_report(problem, *share, out)).collect(),
        gained_energy: outcome.gained_energy,
        restitution_scaled: outcome.restitution_scaled,
        without_approach: outcome.without_approach,
    }
}

fn open_share_report(
    problem: &ImpactProblem,
    share: Share,
    out: &StagedOutcome<MOST_CONTACTS>,
) -> OpenShareReport {
    let (takes, i) = match share {
        Share::Least(i) => (ShareTaken::Least, i),
        Share::Most(i) => (ShareTaken::Most, i),
        Share::Middle => (ShareTaken::Middle, 0),
    };
    let contact = problem.names.get(i).cloned().unwrap_or_default();
    let end = end_report(problem, &out.impulse, &out.velocity, |i| out.state[i]);
    OpenShareReport { contact, takes, end }
}

fn sharing_report(problem: &ImpactProblem, shared: &Shared) -> SharingReport {
    let end = shared
        .outcome
        .as_ref()
        .ok()
        .map(|out| end_report(problem, &out.impulse, &out.velocity, |i| out.state[i]));
    let because = shared.outcome.as_ref().err().map(|error| impact::failure(&problem.names, error));
    let failure = shared.outcome.as_ref().err().map(ImpactFailure::of);
    SharingReport { sharing: Word(shared.convention), verdict: shared.verdict, end, because, failure }
}

fn end_report(
    problem: &ImpactProblem,
    impulse: &[[f64; 2]],
    velocity: &[[f64; 2]],
    state: impl Fn(usize) -> ContactState,
) -> EndReport {
    let contacts = problem.names.iter().enumerate().map(|(i, name)| EndContactReport {
        name: name.clone(),
        state: Word(state(i)),
        normal_impulse: impulse[i][1],
        tangential_impulse: impulse[i][0],
        normal_velocity_m_s: velocity[i][1],
        slip_m_s: velocity[i][0],
    });
    let after = problem.body_after(impulse);
    let energy = |v, w| problem.energy(v, w);
    let before = problem.body.as_ref().and_then(|body| energy(body.velocity, body.spin));
    let group = problem.group.as_ref();
    let bodies = group.map_or(vec![], |group| group.after(impulse).unwrap_or_default());
    let named = group.map_or(&[][..], |group| &group.names).iter().zip(&bodies);
    EndReport {
        contacts: contacts.collect(),
        velocity_m_s: after.map(|(velocity, _)| [velocity.x, velocity.y]),
        spin_rad_s: after.map(|(_, spin)| spin),
        energy_before: group.map(|group| energy_of(&group.bodies)).or(before),
        energy_after: group.map(|_| energy_of(&bodies)).or(after.and_then(|(v, w)| energy(v, w))),
        bodies: named
            .map(|(name, body)| BodyReport {
                name: name.clone(),
                velocity_m_s: [body.velocity.x, body.velocity.y],
                spin_rad_s: body.spin,
            })
            .collect(),
    }
}

fn stage_report(problem: &ImpactProblem, stage: &staged::Stage<MOST_CONTACTS>) -> WalkStageReport {
    let contacts = (0..problem.names.len()).map(|i| {
        let (start, end) = (&stage.start, &stage.end);
        StageContactReport {
            slip: Word(stage.slip[i]),
            normal_impulse: [start.impulse[i][1], end.impulse[i][1]],
            tangential_impulse: [start.impulse[i][0], end.impulse[i][0]],
            normal_velocity_m_s: [start.velocity[i][1], end.velocity[i][1]],
            slip_m_s: [start.velocity[i][0], end.velocity[i][0]],
        }
    });
    WalkStageReport {
        phase: Word(stage.phase),
        ended_by: impact::stage_end(&problem.names, stage.ended_by),
        event: ImpactEventReport::in_plane(stage.ended_by, &problem.names),
        contacts: contacts.collect(),
    }
}

pub(crate) fn end_state_report<const N: usize>(problem: &ImpactProblem, end: &EndState<N>) -> EndStateReport {
    let state = |i: usize| match (end.guess[i].holds, end.guess[i].slip) {
        _ if end.velocity[i][1] > 0.0 && !end.guess[i].holds => ContactState::Separates,
        (false, Slip::Open) => ContactState::Separates,
        (_, Slip::Sticks) => ContactState::Sticks,
        _ => ContactState::Slips,
    };
    EndStateReport {
        hypothesis: impact::hypothesis(&problem.names, &end.guess),
        end: end_report(problem, &end.impulse, &end.velocity, state),
        margin: end.margin.is_finite().then_some(end.margin),
        indeterminate: end.indeterminate,
        gained_energy: gains(&problem.contacts.before(), &end.velocity, &end.impulse),
    }
}

/// True where the work of impulses, `½ Σ p·(u⁻ + u⁺)`, is positive beyond rounding.
fn gains(before: &[[f64; 2]], after: &[[f64; 2]], impulse: &[[f64; 2]]) -> bool {
    let works = before.iter().flatten().zip(after.iter().flatten()).zip(impulse.iter().flatten());
    let (sum, terms) = works.fold((0.0, 0.0), |(sum, terms), ((u, v), p)| {
        (sum + 0.5 * p * (u + v), terms + 0.5 * (p * u).abs() + 0.5 * (p * v).abs())
    });
    sum > WORK_ROUNDING * terms
}

pub(crate) fn rejected_report(problem: &ImpactProblem, rejected: &Rejected<MOST_CONTACTS>) -> RejectedReport {
    let (names, clock) = (&problem.names, Clock::Impulse(rejected.phase));
    RejectedReport {
        hypothesis: impact::hypothesis(names, &rejected.guess),
        because: impact::because(names, &rejected.broken, clock),
        slips: rejected.guess[..names.len()].iter().map(|guess| Word(guess.slip)).collect(),
        inequality: InequalityReport::new(&rejected.broken, names, clock),
    }
}
