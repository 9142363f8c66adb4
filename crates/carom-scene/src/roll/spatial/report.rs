//! What a body in space says, as JSON: SI, the unit in the key. Spins in body axes, velocities and impulses in world axes.

use super::strike_report::{last_strike, strike_report};
use super::words::{end_words, mode_words, names};
use super::{RestingReport, SpatialRollProblem, SpatialRollRun, ThrownBodyReport};
use carom_motion::spatial::{Closing, Piece};
use schemars::JsonSchema;
use serde::Serialize;

/// Points of the course of the tilt.
const MOST_TILTS: usize = 600;

/// One contact at a strike.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpatialContactReport {
    /// Its name: O, A, K of a pyramid; the number of a stool's support.
    pub name: String,
    /// True where it comes down in this strike; the others stood on the plane.
    pub strikes: bool,
    /// keeps or opens; with friction, slides where it stays on the plane and slips.
    pub state: &'static str,
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
    /// True where less friction may do: the impulses are open in more than one direction, and the shortest ones are taken.
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
    /// compression or restitution.
    pub phase: &'static str,
    /// What each contact does on the way that is followed; null where it is a limit of the others.
    pub followed: Option<String>,
    /// The other ways, four ways in all at most.
    pub others: Vec<String>,
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
    /// Of the states that the non-sliding law allows, or of the ways through a strike with friction: unique, several or none.
    pub outcome: &'static str,
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
    /// With friction: where the walk through the strike had several ways on.
    pub forks: Vec<SpatialForkReport>,
    /// The least friction coefficient with which no contact slides; null where none suffices, where there is no way on, or where contacts may slide.
    pub friction_demand: Option<f64>,
    /// True where less friction may do: the impulses are open in more than one direction, and the shortest ones are taken.
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

/// Infinitely many strikes within a finite time, closed at their limit.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpatialSeriesReport {
    /// The last strike that was resolved [s].
    pub from_s: f64,
    /// The limit [s].
    pub to_s: f64,
    /// How many strikes make a period.
    pub period: usize,
    /// The ratio of the lengths of successive periods.
    pub ratio: f64,
    /// The contacts that stay on the plane after it.
    pub kept: Vec<String>,
}

/// A stretch of motion between two events.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpatialStageReport {
    /// flight, pivot (about one contact), edge (about two) or rest.
    pub name: &'static str,
    /// The contacts that are held.
    pub held: Vec<String>,
    /// Start [s].
    pub start_s: f64,
    /// End [s].
    pub end_s: f64,
}

/// The course of the tilt, thinned for a plot.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct TiltReport {
    /// Times [s].
    pub t_s: Vec<f64>,
    /// Angle from flat of the face that is nearest to the plane [rad].
    pub tilt_rad: Vec<f64>,
}

/// How it ends.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpatialEndReport {
    /// at rest, balanced, overturned, strikes reached, no consistent outcome, several ways on or budget spent.
    pub state: &'static str,
    /// The same in a sentence.
    pub words: String,
    /// When that is so [s].
    pub t_s: f64,
}

/// A body in space followed through its strikes.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "carom roll, in space")]
pub struct SpatialRollReport {
    /// pyramid, stool or body.
    pub kind: &'static str,
    /// Mass [kg].
    pub mass_kg: f64,
    /// Moment of inertia about the mass centre, across the body's axis; null of a polyhedron [kg m²].
    pub inertia_transverse_kg_m2: Option<f64>,
    /// Moment of inertia about the body's axis; null of a polyhedron [kg m²].
    pub inertia_axial_kg_m2: Option<f64>,
    /// Friction coefficient; null under the non-sliding law.
    pub friction: Option<f64>,
    /// Restitution: 0 under the non-sliding law.
    pub restitution: f64,
    /// The polyhedron that is thrown; null of the others.
    pub body: Option<ThrownBodyReport>,
    /// On what it rests; null of the others.
    pub resting: Option<RestingReport>,
    /// The strikes, in order; one that has no way on is the last.
    pub strikes: Vec<SpatialStrikeReport>,
    /// Infinitely many strikes within a finite time, closed at their limit.
    pub accumulations: Vec<SpatialSeriesReport>,
    /// What it does between its strikes.
    pub stages: Vec<SpatialStageReport>,
    /// The course of its tilt.
    pub tilt: TiltReport,
    /// The largest of the strikes' friction demands; null without strikes, where no friction suffices, or where contacts may slide.
    pub friction_demand: Option<f64>,
    /// True where less may do, in the strike that demands most.
    pub friction_is_bound: bool,
    /// The largest change of the energy between two events, in units of m g × size plus the kinetic energy: the integration's error.
    pub energy_drift: f64,
    /// How it ends.
    pub end: SpatialEndReport,
}

/// A number that JSON has.
pub(super) fn finite(x: f64) -> Option<f64> {
    x.is_finite().then_some(x)
}

impl SpatialRollReport {
    /// The report of a run. Closed forms are not asked here: whoever draws both fills them in.
    pub fn new(problem: &SpatialRollProblem, run: &SpatialRollRun) -> Self {
        let friction = problem.world.friction();
        let (inertia, has_axis) = (problem.world.body().inertia(), problem.thrown.is_none());
        let (state, words) = end_words(problem, run);
        let mut strikes: Vec<SpatialStrikeReport> =
            run.strikes.iter().filter_map(|strike| strike_report(problem, strike)).collect();
        let demand = |s: &SpatialStrikeReport| s.friction_demand.unwrap_or(f64::INFINITY);
        let most = strikes.iter().max_by(|a, b| demand(a).total_cmp(&demand(b)));
        let (friction_demand, friction_is_bound) =
            most.map_or((None, false), |s| (s.friction_demand, s.friction_is_bound));
        strikes.extend(last_strike(problem, run));
        Self {
            kind: problem.kind.word(),
            mass_kg: problem.world.body().mass(),
            inertia_transverse_kg_m2: has_axis.then_some(inertia.rows[0].x),
            inertia_axial_kg_m2: has_axis.then_some(inertia.rows[2].z),
            friction: friction.map(|f| f.coefficient(0)),
            restitution: friction.map_or(0.0, |f| f.restitution()),
            body: ThrownBodyReport::new(problem),
            resting: RestingReport::new(problem, run),
            strikes,
            accumulations: series(problem, run),
            stages: stages(problem, run),
            tilt: tilts(problem, run),
            friction_demand,
            friction_is_bound,
            energy_drift: run.drift,
            end: SpatialEndReport { state, words, t_s: run.end_time },
        }
    }
}

fn series(problem: &SpatialRollProblem, run: &SpatialRollRun) -> Vec<SpatialSeriesReport> {
    let of = |c: &Closing| SpatialSeriesReport {
        from_s: c.time,
        to_s: c.limit,
        period: c.period,
        ratio: c.ratio,
        kept: names(problem, c.kept),
    };
    run.closings.iter().map(of).collect()
}

fn stages(problem: &SpatialRollProblem, run: &SpatialRollRun) -> Vec<SpatialStageReport> {
    let of = |piece: &Piece| SpatialStageReport {
        name: mode_words(&piece.mode),
        held: names(problem, piece.mode.held(problem.world.body())),
        start_s: piece.start_time,
        end_s: piece.end_time,
    };
    run.pieces.iter().map(of).collect()
}

fn tilts(problem: &SpatialRollProblem, run: &SpatialRollRun) -> TiltReport {
    let every = run.instants.len().div_ceil(MOST_TILTS).max(1);
    let last = run.instants.len().saturating_sub(1);
    let mut report = TiltReport { t_s: vec![], tilt_rad: vec![] };
    for (i, (time, _, state)) in run.instants.iter().enumerate() {
        if i % every == 0 || i == last {
            report.t_s.push(*time);
            report.tilt_rad.push(problem.tilt(state));
        }
    }
    report
}
