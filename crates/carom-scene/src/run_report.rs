//! What a run says, as JSON: SI, the unit in the key, angles and spins counter-clockwise, x right, y up.

use crate::approximation::Approximation;
use crate::feed_report::FeedReport;
use crate::run_end_report::{
    DecidedReport, JamReport, StageEndReport, decided_report, jam_report, stage_end_report,
};
use crate::run_impact_report::{ImpactReport, impact_report};
use crate::scene::Scene;
use crate::wanted::Wanted;
use crate::word::Word;
use carom_feeder::{Exit, Feeder, Landing, Outcome, PartKind, Run, Stage, StageName, Verdict};
use carom_motion::planar::State;
use carom_words::part::Names;
use carom_words::run as run_words;
use schemars::JsonSchema;
use serde::Serialize;

/// How far one quantity may move alone before the verdict flips, SI.
///
/// # Example
/// With more friction than 0.1 the verdict stays as far as was searched: there is no highest value.
/// ```
/// use carom_scene::{Limit, LimitEnd};
/// let ends = [(0.1, LimitEnd::Flips), (25.6, LimitEnd::EndOfSearch)];
/// let limit = Limit::new("contact.friction", ends);
/// assert_eq!((limit.low, limit.high, limit.high_kept), (Some(0.1), None, 25.6));
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Limit {
    /// Its path.
    pub quantity: String,
    /// Lowest value with the same verdict; null where the verdict does not flip below.
    pub low: Option<f64>,
    /// Highest value with the same verdict; null where the verdict does not flip above.
    pub high: Option<f64>,
    /// What ended the search downwards.
    pub low_end: LimitEnd,
    /// The lowest value that was found to keep the verdict.
    pub low_kept: f64,
    /// What ended the search upwards.
    pub high_end: LimitEnd,
    /// The highest value that was found to keep the verdict.
    pub high_kept: f64,
}

/// What ended the search for a limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum LimitEnd {
    /// Beyond the last value the verdict flips.
    Flips,
    /// Beyond the last value there is no such feeder: what would be drawn cannot be.
    NoSuchFeeder,
    /// The verdict stays as far as was searched.
    EndOfSearch,
}

impl Limit {
    /// A quantity's limits, from the last value that keeps the verdict and what comes beyond it: downwards, then upwards.
    pub fn new(quantity: &str, [low, high]: [(f64, LimitEnd); 2]) -> Self {
        let flips = |(kept, end): (f64, LimitEnd)| (end == LimitEnd::Flips).then_some(kept);
        Self {
            quantity: quantity.to_owned(),
            low: flips(low),
            high: flips(high),
            low_end: low.1,
            low_kept: low.0,
            high_end: high.1,
            high_kept: high.0,
        }
    }
}

/// A run of a feeder.
///
/// # Example
/// The part of the second published feeder turns over.
/// ```
/// use carom_scene::*;
/// # let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
/// # let run = scene.feeder().run().unwrap();
/// let report = RunReport::new(&scene, &run, None);
/// assert_eq!((report.scene.as_str(), report.outcome.as_str()), ("case_2", "landed"));
/// assert_eq!(report.plates[0].verdict, Some(VerdictReport::Word(SideReport::Turned)));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "carom run")]
pub struct RunReport {
    /// Name of the scene.
    pub scene: String,
    /// How the computed part differs from the drawn one; absent where it does not.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub approximations: Vec<Approximation>,
    /// What was read from the part's file, taken from tables, or assumed; absent where there is nothing to say.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
    /// How it ended; blocked and unresolved only in a feed.
    pub outcome: Word<Outcome>,
    /// When the run ended [s].
    pub end_s: f64,
    /// The plates the part landed on, in order of landing.
    pub plates: Vec<PlateReport>,
    /// Whether it ended as wanted, plate by plate; empty where the scene wants nothing.
    pub wanted: Vec<Wanted>,
    /// How it left over the last plate's edge; null unless delivered.
    pub exit: Option<ExitReport>,
    /// The smallest decided inequality divided by the sum of its terms' magnitudes; null where none was decided.
    pub margin: Option<f64>,
    /// What that decided, in words.
    pub margin_of: String,
    /// The same as data.
    pub decided: DecidedReport,
    /// Between what the part jammed; absent unless jammed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub jam: Option<JamReport>,
    /// How near the part came to the last plate in the flight in which it missed it [m]; absent unless missed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub missed_by_m: Option<f64>,
    /// The face on whose arc the part swings to and fro for ever; absent of every other end.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub swings_on_face: Option<usize>,
    /// How far each quantity may move before the verdict flips; only where it was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limits: Option<Vec<Limit>>,
    /// How many runs that took.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit_runs: Option<u64>,
    /// The stages, in order of time.
    pub stages: Vec<StageReport>,
    /// The impacts, in order of time.
    pub impacts: Vec<ImpactReport>,
    /// Infinitely many impacts in finite time, closed at their limits.
    pub accumulations: Vec<AccumulationReport>,
    /// Counts of the work done.
    pub work: WorkReport,
    /// What several parts did, one after the other; only where the scene has a `[feed]`. All else is about one part alone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub feed: Option<FeedReport>,
}

/// Which side of a part is down.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SideReport {
    /// The one that was down at the start.
    Same,
    /// The opposite one.
    Turned,
}

/// `same` or `turned`, or the number of the face that is down.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum VerdictReport {
    /// Against the start.
    Word(SideReport),
    /// The face that is down.
    Face(usize),
}

/// A landing.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PlateReport {
    /// Name of the plate; its number, counted from 0, where it has none.
    pub plate: String,
    /// Against the start; null for a disc.
    pub verdict: Option<VerdictReport>,
    /// Against the plate before; null for a disc.
    pub turned_here: Option<bool>,
    /// The face that is down; null for a disc.
    pub face: Option<usize>,
    /// First touch of this plate [s].
    pub first_touch_s: f64,
    /// Flat on it [s]; null for a disc.
    pub flat_s: Option<f64>,
    /// Largest approach speed of its impacts [m/s].
    pub impact_speed_m_s: f64,
    /// Largest slip on it [m/s].
    pub max_sliding_speed_m_s: f64,
}

/// Pose and velocity.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct StateReport {
    /// Mass centre [m].
    pub x_m: f64,
    /// Mass centre [m].
    pub y_m: f64,
    /// Angle of the part from its drawing [rad].
    pub angle_rad: f64,
    /// Velocity of the mass centre [m/s].
    pub vx_m_s: f64,
    /// Velocity of the mass centre [m/s].
    pub vy_m_s: f64,
    /// Spin [rad/s].
    pub spin_rad_s: f64,
}

/// How the part left.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ExitReport {
    /// Time [s].
    pub t_s: f64,
    /// Pose and velocity.
    #[serde(flatten)]
    pub state: StateReport,
}

/// A stage.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct StageReport {
    /// Its name.
    pub name: Word<StageName>,
    /// The plate or wall it happens on, by its name; by its number, counted from 0, where it has none; null in flight.
    pub plate: Option<String>,
    /// Start [s].
    pub start_s: f64,
    /// End [s].
    pub end_s: f64,
    /// Why it ended, in words.
    pub ended_by: String,
    /// The same as data.
    pub event: StageEndReport,
    /// Pose and velocity at the start.
    pub start: StateReport,
    /// Pose and velocity at the end.
    pub end: StateReport,
}

/// Infinitely many impacts in finite time.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct AccumulationReport {
    /// The first impact counted [s].
    pub from_s: f64,
    /// Their limit [s].
    pub to_s: f64,
}

/// Counts of the work done.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WorkReport {
    /// Evaluations of a mode's forces and accelerations.
    pub rhs_evaluations: u64,
    /// Events.
    pub events: u64,
    /// Impacts.
    pub impacts: u64,
}

impl RunReport {
    /// The report of a run of a scene.
    pub fn new(scene: &Scene, run: &Run, limits: Option<Vec<Limit>>) -> Self {
        let feeder = scene.feeder();
        Self {
            scene: scene.name().to_owned(),
            approximations: scene.approximations().to_vec(),
            notes: scene.notes().to_vec(),
            wanted: scene.wanted(run),
            outcome: Word(run.outcome),
            end_s: run.end_time,
            plates: run.landings.iter().map(|landing| plate_report(feeder, landing)).collect(),
            exit: run.exit.as_ref().map(exit_report),
            margin: run.margin.is_finite().then_some(run.margin),
            margin_of: run_words::decided(run.margin_of),
            decided: decided_report(run.margin_of),
            jam: run.jam.as_ref().map(|jam| jam_report(feeder, jam)),
            missed_by_m: run.missed_by,
            swings_on_face: run.swings_on(feeder),
            limits,
            limit_runs: None,
            stages: run.stages.iter().map(|stage| stage_report(feeder, stage)).collect(),
            impacts: run.trace.impacts.iter().map(|impact| impact_report(feeder, impact)).collect(),
            accumulations: run
                .trace
                .accumulations
                .iter()
                .map(|(from, to)| AccumulationReport { from_s: *from, to_s: *to })
                .collect(),
            work: WorkReport {
                rhs_evaluations: run.effort.rhs_evaluations,
                events: run.effort.events,
                impacts: run.effort.impacts,
            },
            feed: None,
        }
    }
}

/// How a part left, for a report.
///
/// # Example
/// ```
/// use carom_feeder::Exit;
/// use carom_motion::planar::{State, Twist};
/// use carom_num::Vec2;
/// let twist = Twist { velocity: Vec2::new(3.0, -4.0), spin: 0.0 };
/// let exit = carom_scene::exit_report(&Exit { time: 1.5, state: State { twist, ..State::default() } });
/// assert_eq!((exit.t_s, exit.state.vx_m_s.hypot(exit.state.vy_m_s)), (1.5, 5.0));
/// ```
pub fn exit_report(exit: &Exit) -> ExitReport {
    ExitReport { t_s: exit.time, state: state_report(&exit.state) }
}

pub(crate) fn plate_report(feeder: &Feeder, landing: &Landing) -> PlateReport {
    let by_number = matches!(feeder.part.kind, PartKind::Polygon | PartKind::Disc);
    let told = landing_report(feeder, landing);
    let verdict = match landing.verdict {
        Some(_) if by_number => landing.face.map(VerdictReport::Face),
        _ => told.verdict,
    };
    PlateReport { verdict, ..told }
}

/// A landing of a part whose faces are told as the same, turned, or by their numbers.
pub(crate) fn landing_report(feeder: &impl Names, landing: &Landing) -> PlateReport {
    let verdict = landing.verdict.map(|verdict| match verdict {
        Verdict::Same => VerdictReport::Word(SideReport::Same),
        Verdict::Turned => VerdictReport::Word(SideReport::Turned),
        Verdict::Face(face) => VerdictReport::Face(face),
    });
    PlateReport {
        plate: feeder.given(landing.plate).to_owned(),
        verdict,
        turned_here: landing.turned_here,
        face: landing.face,
        first_touch_s: landing.first_touch,
        flat_s: landing.flat,
        impact_speed_m_s: landing.impact_speed,
        max_sliding_speed_m_s: landing.max_sliding_speed,
    }
}

fn state_report(state: &State) -> StateReport {
    StateReport {
        x_m: state.pose.centre.x,
        y_m: state.pose.centre.y,
        angle_rad: state.pose.angle,
        vx_m_s: state.twist.velocity.x,
        vy_m_s: state.twist.velocity.y,
        spin_rad_s: state.twist.spin,
    }
}

pub(crate) fn stage_report(feeder: &Feeder, stage: &Stage) -> StageReport {
    StageReport {
        name: Word(stage.name),
        plate: stage.obstacle.map(|obstacle| feeder.obstacle_name(obstacle).to_owned()),
        start_s: stage.start_time,
        end_s: stage.end_time,
        ended_by: run_words::stage_end(feeder, &stage.ended_by),
        event: stage_end_report(feeder, &stage.ended_by),
        start: state_report(&stage.start),
        end: state_report(&stage.end),
    }
}
