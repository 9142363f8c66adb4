//! One strike of a body in space, told.

use super::SpatialRollProblem;
use super::SpatialRollRun;
use super::follow::SpatialStrike;
use super::report::finite;
use super::rough_strike;
use super::states::{Fails, States, states, touching_at};
use crate::word::Word;
use carom_impact::Phase;
use carom_impact::spatial::{Conclusion, Freedom, Mode};
use carom_motion::spatial::{Clock, End, State, Supports};
use carom_num::Vec3;
use carom_words::roll_space::{self, PointState};
use schemars::JsonSchema;
use serde::Serialize;

/// One contact at a strike.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpatialContactReport {
    /// Its name: O, A, K of a pyramid; the number of a stool's support.
    pub name: String,
    /// True where it comes down in this strike; the others stood on the plane.
    pub strikes: bool,
    /// What it does; without friction it keeps or opens.
    pub state: Word<PointState>,
    /// Normal impulse on the body [N s].
    #[serde(rename = "normal_impulse_N_s")]
    pub normal_impulse: f64,
    /// Size of the tangential impulse [N s]; where impulses along a line are open, that of the shortest ones.
    #[serde(rename = "tangential_impulse_N_s")]
    pub tangential_impulse: f64,
    /// Impulse on the body, world axes [N s].
    #[serde(rename = "impulse_N_s")]
    pub impulse: [f64; 3],
    /// Velocity before, world axes [m/s].
    pub velocity_before_m_s: [f64; 3],
    /// Velocity after, world axes [m/s].
    pub velocity_m_s: [f64; 3],
}

/// A state that the non-sliding law allows.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpatialEndStateReport {
    /// "O and K keep, A opens".
    pub hypothesis: String,
    /// The contacts whose velocity is zero after.
    pub kept: Vec<String>,
    /// Its contacts.
    pub contacts: Vec<SpatialContactReport>,
    /// The least friction coefficient with which no contact slides; null where none suffices.
    pub friction_demand: Option<f64>,
    /// False: the least is found over all impulses of which the law leaves the choice.
    pub friction_is_bound: bool,
    /// The smallest of its inequalities' slacks, as a fraction of all impulses or of all velocities.
    pub margin: f64,
    /// True where the impulses along the contacts' lines are not determined; the motion is.
    pub indeterminate: bool,
    /// True for the one that is followed.
    pub followed: bool,
}

/// A state that is refused.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpatialRejectedReport {
    /// "O, A and K keep".
    pub hypothesis: String,
    /// The contacts that it keeps.
    pub kept: Vec<String>,
    /// The inequality that fails, with its number.
    pub because: String,
    /// The contact whose inequality fails; null where no impulses bring the kept contacts to rest.
    pub at: Option<String>,
    /// Its normal impulse, where that is negative [N s].
    #[serde(rename = "normal_impulse_N_s")]
    pub normal_impulse: Option<f64>,
    /// Its normal velocity after, where that is negative [m/s].
    pub normal_velocity_m_s: Option<f64>,
}

/// A moment of a strike with friction at which several ways on are consistent.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpatialForkReport {
    /// The stage of the walk that starts there, from 1.
    pub stage: usize,
    /// The phase that it is in.
    pub phase: Word<Phase>,
    /// What each contact does on the way that is followed; null where it is a limit of the others.
    pub followed: Option<String>,
    /// The other ways, four ways in all at most.
    pub others: Vec<String>,
    /// The same as data, the one that is followed first, each in the order of the contacts.
    pub ways: Vec<Vec<Word<Mode>>>,
}

/// What a closed form says of a strike, beside the engine's numbers.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ClosedFormReport {
    /// Which case of the literature it is.
    pub case: String,
    /// What the literature says of it, and whether that holds.
    pub words: String,
    /// The contacts that it keeps.
    pub kept: Vec<String>,
    /// Largest difference of spins, as a fraction of the spin before.
    pub spin_difference: f64,
    /// Largest difference of normal impulses, as a fraction of the largest; null where the form does not give them.
    pub impulse_difference: Option<f64>,
    /// True where the same contacts keep, and the numbers differ by rounding.
    pub agrees: bool,
}

/// One strike.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpatialStrikeReport {
    /// When [s].
    pub t_s: f64,
    /// Of the states that the non-sliding law allows, or of the ways through a strike with friction: forced where at some stage none was consistent, and the
    /// contact that friction drives in was loaded alone.
    pub outcome: Word<Conclusion>,
    /// What happens: "O and K keep, A opens"; with friction, "O keeps, K slides, A opens".
    pub state: String,
    /// The contacts that stay on the plane; without friction their velocity is zero after.
    pub kept: Vec<String>,
    /// The contacts that come down.
    pub struck: Vec<String>,
    /// The contacts as it is followed; empty where there is no way on.
    pub contacts: Vec<SpatialContactReport>,
    /// Every state that the law allows.
    pub end_states: Vec<SpatialEndStateReport>,
    /// The other states, each with the inequality that refuses it.
    pub rejected: Vec<SpatialRejectedReport>,
    /// Refused states that are not listed.
    pub rejected_left_out: usize,
    /// What sharing among the contacts leaves open: where that is the motion, one sharing was chosen, and others are as consistent.
    pub open: Word<Freedom>,
    /// With friction: where the walk through the strike had several ways on.
    pub forks: Vec<SpatialForkReport>,
    /// The least friction coefficient with which no contact slides; null where none suffices, where there is no way on, or where contacts may slide.
    pub friction_demand: Option<f64>,
    /// False: the least is found over all impulses of which the law leaves the choice.
    pub friction_is_bound: bool,
    /// Velocity of the mass centre before, world axes [m/s].
    pub velocity_before_m_s: [f64; 3],
    /// Velocity of the mass centre after, world axes [m/s]; null where there is no way on.
    pub velocity_m_s: Option<[f64; 3]>,
    /// Spin before, body axes [rad/s].
    pub spin_before_rad_s: [f64; 3],
    /// Spin after, body axes [rad/s]; null where there is no way on.
    pub spin_rad_s: Option<[f64; 3]>,
    /// Angle from flat of the face that is nearest to the plane [rad].
    pub tilt_rad: f64,
    /// Kinetic energy before [J].
    #[serde(rename = "energy_before_J")]
    pub energy_before: f64,
    /// Kinetic energy after [J]; null where there is no way on.
    #[serde(rename = "energy_after_J")]
    pub energy_after: Option<f64>,
    /// What a closed form says of it, where there is one.
    pub closed_form: Option<ClosedFormReport>,
}

/// A strike, as it is followed.
pub(super) fn strike_report(
    problem: &SpatialRollProblem,
    strike: &SpatialStrike,
) -> Option<SpatialStrikeReport> {
    let impact = &strike.impact;
    let rough = problem.world.friction().is_some();
    let states = if rough {
        rough_strike::states(problem, &strike.before, [impact.touching, impact.held], impact.conclusion)?
    } else {
        states(problem, &strike.before, impact.touching)?
    };
    let followed = Followed { kept: Some(impact.kept), striking: impact.striking };
    let contacts = contacts(problem, &states, &followed, [impact.kept, impact.sliding], &|k| {
        let impulse = impact.impulses.get(k).map_or(Vec3::ZERO, |(_, p)| *p);
        let Some((i, _)) = impact.impulses.get(k) else { return [impulse, Vec3::ZERO] };
        let place = problem.world.touches_at(*i, &strike.before).unwrap_or(Vec3::ZERO);
        let velocity = strike.after.velocity_of(place);
        // What stays on the plane, or rests, is known better than the impulses say it.
        let velocity = match (impact.kept.contains(*i), impact.sliding.contains(*i)) {
            (true, false) => Vec3::ZERO,
            (true, true) => Vec3::new(velocity.x, velocity.y, 0.0),
            _ => velocity,
        };
        [impulse, velocity]
    });
    Some(SpatialStrikeReport {
        contacts,
        state: roll_space::kept(&problem.points, [impact.kept, impact.sliding], impact.touching),
        kept: problem.names_of(impact.kept),
        friction_demand: finite(impact.friction_demand).filter(|_| !rough),
        friction_is_bound: false,
        open: Word(impact.open),
        velocity_m_s: Some(strike.after.velocity.to_array()),
        spin_rad_s: Some(impact.spin_after.to_array()),
        energy_after: Some(impact.kinetic_after),
        ..unresolved(problem, &states, &followed, &strike.before, impact.time)
    })
}

/// Which state of a strike is followed, and which contacts come down.
struct Followed {
    kept: Option<Supports>,
    striking: Supports,
}

/// The strike in which a run has ended, because the law has no way on or several.
pub(super) fn last_strike(problem: &SpatialRollProblem, run: &SpatialRollRun) -> Option<SpatialStrikeReport> {
    let (Some(End::NoConsistentOutcome(Clock::Impact)) | Some(End::Several(Clock::Impact))) = run.end else {
        return None;
    };
    let touching = touching_at(problem, &run.last);
    let held = run.pieces.last().map_or(Supports::NONE, |piece| piece.mode.held(&problem.world));
    let states = if problem.world.friction().is_some() {
        let several = matches!(run.end, Some(End::Several(_)));
        let conclusion = if several { Conclusion::Several } else { Conclusion::None };
        rough_strike::states(problem, &run.last, [touching, held], conclusion)?
    } else {
        states(problem, &run.last, touching)?
    };
    let followed = Followed { kept: None, striking: touching.difference(held) };
    Some(unresolved(problem, &states, &followed, &run.last, run.end_time))
}

/// A strike as far as it is known before a way on is chosen.
fn unresolved(
    problem: &SpatialRollProblem,
    states: &States,
    followed: &Followed,
    before: &State,
    time: f64,
) -> SpatialStrikeReport {
    let ends = states.consistent.iter().map(|s| SpatialEndStateReport {
        hypothesis: s.hypothesis.clone(),
        kept: problem.names_of(s.kept),
        contacts: contacts(problem, states, followed, [s.kept, Supports::NONE], &|k| s.contacts[k]),
        friction_demand: finite(s.friction_demand),
        margin: s.slack,
        indeterminate: s.freedom > 0,
        friction_is_bound: false,
        followed: followed.kept == Some(s.kept),
    });
    let rejected = states.rejected.iter().map(|r| SpatialRejectedReport {
        hypothesis: r.hypothesis.clone(),
        kept: problem.names_of(r.kept),
        because: r.because.clone(),
        at: r.fails.map(|(i, _)| problem.names_of(Supports::one(i)).concat()),
        normal_impulse: r.fails.and_then(|(_, f)| if let Fails::Impulse(p) = f { Some(p) } else { None }),
        normal_velocity_m_s: r
            .fails
            .and_then(|(_, f)| if let Fails::Velocity(v) = f { Some(v) } else { None }),
    });
    SpatialStrikeReport {
        t_s: time,
        outcome: Word(states.conclusion),
        state: match (problem.world.friction().is_some(), states.conclusion) {
            (false, Conclusion::None) => "no state is consistent",
            (false, _) => "several states are consistent",
            (true, Conclusion::None) => "no way through it was found",
            (true, _) => "several ways through it are consistent",
        }
        .to_owned(),
        kept: vec![],
        struck: problem.names_of(followed.striking),
        contacts: vec![],
        end_states: ends.collect(),
        rejected: rejected.collect(),
        rejected_left_out: states.left_out,
        // Several motions without several ways on: those of one load that can be shared otherwise.
        open: Word(match (problem.world.friction().is_some(), states.conclusion) {
            (true, Conclusion::Several) if states.forks.is_empty() => Freedom::Motion,
            _ => Freedom::None,
        }),
        forks: states.forks.clone(),
        friction_demand: None,
        friction_is_bound: false,
        velocity_before_m_s: before.velocity.to_array(),
        velocity_m_s: None,
        spin_before_rad_s: before.spin.to_array(),
        spin_rad_s: None,
        tilt_rad: problem.tilt(before),
        energy_before: before.kinetic(problem.world.body()),
        energy_after: None,
        closed_form: None,
    }
}

fn contacts(
    problem: &SpatialRollProblem,
    states: &States,
    followed: &Followed,
    [kept, sliding]: [Supports; 2],
    of: &dyn Fn(usize) -> [Vec3; 2],
) -> Vec<SpatialContactReport> {
    let report = |(k, i): (usize, usize)| {
        let [impulse, velocity] = of(k);
        SpatialContactReport {
            name: problem.names_of(Supports::one(i)).concat(),
            strikes: followed.striking.contains(i),
            state: match (kept.contains(i), sliding.contains(i)) {
                (true, true) => Word(PointState::Slides),
                (true, false) => Word(PointState::Keeps),
                (false, _) => Word(PointState::Opens),
            },
            normal_impulse: impulse.z,
            tangential_impulse: (impulse.x * impulse.x + impulse.y * impulse.y).sqrt(),
            impulse: impulse.to_array(),
            velocity_before_m_s: states.before.get(k).copied().unwrap_or(Vec3::ZERO).to_array(),
            velocity_m_s: velocity.to_array(),
        }
    };
    states.touching.iter().enumerate().map(report).collect()
}
