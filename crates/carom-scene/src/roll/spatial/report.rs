//! What a body in space says, as JSON: SI, the unit in the key. Spins in body axes, velocities and impulses in world axes.

use super::strike_report::{SpatialStrikeReport, last_strike, strike_report};
use super::{RestingReport, SpatialRollKind, SpatialRollProblem, SpatialRollRun, ThrownBodyReport};
use crate::roll::poses::{PoseAt, PoseMark, RollPose};
use crate::word::Word;
use carom_motion::spatial::{Closing, Mode, Piece, State};
use carom_words::roll_space::{self, EndName, StageName};
use schemars::JsonSchema;
use serde::Serialize;

/// Points of the course of the tilt.
const MOST_TILTS: usize = 600;

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
    /// What it does: pivot about one contact, turn about an edge, which is two.
    pub name: Word<StageName>,
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
    /// In which way.
    pub state: Word<EndName>,
    /// The same in a sentence.
    pub words: String,
    /// When that is so [s].
    pub t_s: f64,
}

/// A body in space followed through its strikes.
///
/// # Example
/// The energy is kept between strikes, but for the error of the integration.
/// ```
/// use carom_scene::*;
/// let cube = SpatialRollProblem::parse(SpatialRollKind::Stool, "cube.toml", "axis = [1, 1, 0]", &[])?;
/// let report = SpatialRollReport::new(&cube, &cube.follow()?);
/// assert_eq!((report.kind.as_str(), report.restitution), ("stool", 0.0));
/// assert!(report.energy_drift < 1e-10);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "carom roll, in space")]
pub struct SpatialRollReport {
    /// What it is.
    pub kind: Word<SpatialRollKind>,
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
    /// False: the least is found over all impulses of which the law leaves the choice.
    pub friction_is_bound: bool,
    /// The largest change of the energy between two events, in units of m g × size plus the kinetic energy: the integration's error.
    pub energy_drift: f64,
    /// How it ends.
    pub end: SpatialEndReport,
    /// With `--poses`: where it is at every multiple of the interval, and just before and after each strike; in order of time. Absent without.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub poses: Option<Vec<SpatialRollPoseReport>>,
}

/// A pose in space.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpatialRollPoseReport {
    /// When [s].
    pub t_s: f64,
    /// Where it stands beside a strike, or at the end; absent at a multiple of the interval.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at: Option<PoseAt>,
    /// The strike's place in `strikes`, from 0; absent where the pose is at none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub strike: Option<usize>,
    /// The mass centre, world axes [m].
    pub position_m: [f64; 3],
    /// The rotation of the body's axes into the world's, as a unit quaternion w, x, y, z.
    pub attitude: [f64; 4],
    /// Velocity of the mass centre, world axes [m/s].
    pub velocity_m_s: [f64; 3],
    /// Spin, in the body's axes [rad/s].
    pub spin_rad_s: [f64; 3],
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
        let slid = run.pieces.last().is_some_and(|piece| matches!(piece.mode, Mode::Slides { .. }));
        let words = roll_space::end(&problem.points, run.end, [friction.is_some(), slid]);
        let mut strikes: Vec<SpatialStrikeReport> =
            run.strikes.iter().filter_map(|strike| strike_report(problem, strike)).collect();
        let demand = |s: &SpatialStrikeReport| s.friction_demand.unwrap_or(f64::INFINITY);
        let most = strikes.iter().max_by(|a, b| demand(a).total_cmp(&demand(b)));
        let (friction_demand, friction_is_bound) =
            most.map_or((None, false), |s| (s.friction_demand, s.friction_is_bound));
        let resolved = strikes.len();
        strikes.extend(last_strike(problem, run));
        let poses = run.poses.as_ref().map(|poses| reported(poses, (resolved..strikes.len()).next()));
        Self {
            kind: Word(problem.kind),
            mass_kg: problem.world.body().mass(),
            inertia_transverse_kg_m2: has_axis.then_some(inertia.rows[0].x),
            inertia_axial_kg_m2: has_axis.then_some(inertia.rows[2].z),
            friction: friction.map(|f| f.coefficient(0)),
            restitution: friction.map_or(0.0, |f| f.restitution(0)),
            body: ThrownBodyReport::new(problem),
            resting: RestingReport::new(problem, run),
            strikes,
            accumulations: series(problem, run),
            stages: stages(problem, run),
            tilt: tilts(problem, run),
            friction_demand,
            friction_is_bound,
            energy_drift: run.drift,
            end: SpatialEndReport { state: Word(roll_space::end_name(run.end)), words, t_s: run.end_time },
            poses,
        }
    }
}

/// The poses; a strike without a way on, which is the end, has one before it and none after.
fn reported(poses: &[RollPose<State>], unresolved: Option<usize>) -> Vec<SpatialRollPoseReport> {
    let (last, others) = poses.split_last().map_or((None, poses), |(last, others)| (Some(last), others));
    let before = last.zip(unresolved).map(|(last, i)| RollPose { mark: PoseMark::BeforeStrike(i), ..*last });
    others.iter().chain(&before).chain(last).map(pose).collect()
}

fn pose(pose: &RollPose<State>) -> SpatialRollPoseReport {
    let ((at, strike), state) = (pose.mark.words(), &pose.state);
    SpatialRollPoseReport {
        t_s: pose.time,
        at,
        strike,
        position_m: state.centre.to_array(),
        attitude: state.attitude.to_array(),
        velocity_m_s: state.velocity.to_array(),
        spin_rad_s: state.spin.to_array(),
    }
}

fn series(problem: &SpatialRollProblem, run: &SpatialRollRun) -> Vec<SpatialSeriesReport> {
    let of = |c: &Closing| SpatialSeriesReport {
        from_s: c.time,
        to_s: c.limit,
        period: c.period,
        ratio: c.ratio,
        kept: problem.names_of(c.kept),
    };
    run.closings.iter().map(of).collect()
}

fn stages(problem: &SpatialRollProblem, run: &SpatialRollRun) -> Vec<SpatialStageReport> {
    let of = |piece: &Piece| SpatialStageReport {
        name: Word(roll_space::mode(&piece.mode)),
        held: problem.names_of(piece.mode.held(&problem.world)),
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
