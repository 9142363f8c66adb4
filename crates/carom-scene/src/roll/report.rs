//! What a roll says, as JSON: SI, the unit in the key.

use super::strike::Strike;
use super::{RollEnd, RollKind, RollPoseReport, RollProblem, RollRun, poses};
use crate::impact_end_report::EndContactReport;
use crate::impact_report::{EndStateReport, RejectedReport, end_state_report, rejected_report};
use crate::impact_verdict::{Certainty, ImpactOutcome};
use crate::run_report::AccumulationReport;
use crate::word::Word;
use carom_impact::Law;
use carom_motion::planar::trace::Impact;
use schemars::JsonSchema;
use serde::Serialize;

/// One strike.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RollStrikeReport {
    /// When [s].
    pub t_s: f64,
    /// Of the end states that the laws allow: unique, several or none.
    pub outcome: ImpactOutcome,
    /// What happens: "1: separates at A, sticks at K", with the literature's number where it has one.
    pub state: String,
    /// The literature's number: 1–7 cylinder, 1–8 prism, 1–4 rod.
    pub number: Option<u8>,
    /// What the literature says of that number.
    pub words: Option<String>,
    /// The contacts, those touched before the strike first.
    pub contacts: Vec<EndContactReport>,
    /// Every end state that the laws allow.
    pub end_states: Vec<EndStateReport>,
    /// The other hypotheses, each with the inequality that rejects it.
    pub rejected: Vec<RejectedReport>,
    /// True where what happens is none of the end states: the end depends on the way there.
    pub path_dependent: bool,
    /// Largest number of ways on that the impact met; above 1 it chose.
    pub branches: usize,
    /// True where another share of compression leaves another motion.
    pub open_share: bool,
    /// Velocity of the mass centre before [m/s].
    pub velocity_before_m_s: [f64; 2],
    /// Velocity of the mass centre after [m/s].
    pub velocity_m_s: [f64; 2],
    /// Roll rate before, > 0 forward (clockwise) [rad/s].
    pub roll_rate_before_rad_s: f64,
    /// Roll rate after, > 0 forward (clockwise) [rad/s].
    pub roll_rate_rad_s: f64,
    /// Angle of the body from its start on the level, counter-clockwise [rad].
    pub tilt_rad: f64,
    /// Kinetic energy before [J].
    #[serde(rename = "energy_before_J")]
    pub energy_before: f64,
    /// Kinetic energy after [J].
    #[serde(rename = "energy_after_J")]
    pub energy_after: f64,
    /// Common factor on the coefficients of restitution that kept energy from growing; 1 where none was needed.
    pub restitution_scaled: f64,
}

/// How it ends.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RollEndReport {
    /// In which way.
    pub state: Word<RollEnd>,
    /// When that is so [s]: for "strikes reached" the last strike, for a motion that goes on the end of the time it was followed.
    pub t_s: f64,
}

/// A body followed through its strikes.
///
/// # Example
/// A square without friction written obeys the non-sliding law.
/// ```
/// use carom_scene::*;
/// let square = RollProblem::parse(RollKind::Prism, "square.toml", "sides = 4\nstrikes = 1", &[])?;
/// let run = square.follow()?;
/// let report = RollReport::new(&square, &run);
/// assert_eq!((report.kind.as_str(), report.friction, report.strikes.len()), ("prism", None, 1));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "carom roll")]
pub struct RollReport {
    /// What rolls.
    pub kind: Word<RollKind>,
    /// The law of its strikes.
    pub law: Word<Law>,
    /// Friction coefficient; null for the non-sliding law.
    pub friction: Option<f64>,
    /// Coefficient of restitution.
    pub restitution: f64,
    /// Mass [kg].
    pub mass_kg: f64,
    /// Moment of inertia about the mass centre [kg m²].
    pub inertia_kg_m2: f64,
    /// The strikes, in order.
    pub strikes: Vec<RollStrikeReport>,
    /// Infinitely many strikes within a finite time, closed at their limit.
    pub accumulations: Vec<AccumulationReport>,
    /// How it ends.
    pub end: RollEndReport,
    /// With `--poses`: where it is at every multiple of the interval, and just before and after each strike; in order of time. Absent without.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub poses: Option<Vec<RollPoseReport>>,
}

impl RollReport {
    /// The report of a run.
    pub fn new(problem: &RollProblem, run: &RollRun) -> Self {
        let accumulations = run.trace.accumulations.iter();
        Self {
            kind: Word(problem.kind),
            law: Word(problem.world.law),
            friction: problem.friction,
            restitution: problem.restitution,
            mass_kg: problem.world.bodies[0].mass,
            inertia_kg_m2: problem.world.bodies[0].inertia,
            strikes: run.trace.impacts.iter().filter_map(|impact| strike_report(problem, impact)).collect(),
            accumulations: accumulations
                .map(|(from, to)| AccumulationReport { from_s: *from, to_s: *to })
                .collect(),
            end: RollEndReport { state: Word(run.end), t_s: run.end_time },
            poses: poses::report(run),
        }
    }
}

impl RollStrikeReport {
    /// Whether this is the only answer, and if not, why not.
    pub fn certainty(&self) -> Certainty {
        let Self { path_dependent, branches, open_share, .. } = *self;
        Certainty { path_dependent, branches, open_share, ..Certainty::of_ends(self.end_states.len()) }
    }
}

fn strike_report(problem: &RollProblem, impact: &Impact) -> Option<RollStrikeReport> {
    let strike = Strike::new(problem, impact)?;
    let contacts = strike.names.iter().zip(&strike.contacts).map(|(name, c)| EndContactReport {
        name: name.clone(),
        state: Word(c.state),
        normal_impulse: c.normal_impulse,
        tangential_impulse: c.tangential_impulse,
        normal_velocity_m_s: c.after.normal,
        slip_m_s: c.after.slip,
    });
    let found = &strike.ends.found;
    // −0 is no roll rate.
    let forward = |spin: f64| if spin == 0.0 { 0.0 } else { -spin };
    Some(RollStrikeReport {
        t_s: impact.time,
        outcome: strike.certainty.outcome(),
        state: strike.state(),
        number: strike.number,
        words: strike.paper(problem.kind),
        contacts: contacts.collect(),
        end_states: found.iter().map(|end| end_state_report(&strike.problem, end)).collect(),
        rejected: strike.ends.rejected.iter().map(|r| rejected_report(&strike.problem, r)).collect(),
        path_dependent: strike.certainty.path_dependent,
        branches: strike.certainty.branches,
        open_share: strike.certainty.open_share,
        velocity_before_m_s: [impact.before.velocity.x, impact.before.velocity.y],
        velocity_m_s: [impact.after.velocity.x, impact.after.velocity.y],
        roll_rate_before_rad_s: forward(impact.before.spin),
        roll_rate_rad_s: forward(impact.after.spin),
        tilt_rad: impact.pose.angle,
        energy_before: impact.energy_before,
        energy_after: impact.energy_after,
        restitution_scaled: impact.restitution_scaled,
    })
}
