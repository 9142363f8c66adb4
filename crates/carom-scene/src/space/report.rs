//! What a run in space says, as JSON: SI, the unit in the key. World axes are x right, y up, z out of the drawing; spins are in the part's axes.

use super::SpaceScene;
use crate::approximation::Approximation;
use crate::face_report::SolidFaceReport;
use crate::run_end_report::{JamReport, StageEndReport, jam_report, stage_end_report};
use crate::run_report::{AccumulationReport, Limit, PlateReport, WorkReport, landing_report};
use crate::wanted::Wanted;
use crate::word::Word;
use carom_feeder::spatial::{Exit, Feeder, Run};
use carom_feeder::{Outcome, Stage, StageName};
use carom_motion::spatial::{Impact, State, Touch};
use carom_num::Vec3;
use carom_words::part::Names;
use carom_words::run as run_words;
use schemars::JsonSchema;
use serde::Serialize;

/// The result of a run in space.
///
/// # Example
/// ```
/// use carom_scene::{SpaceRunReport, SpaceScene};
/// let text = "part = { box = [0.04, 0.01, 0.02], mass = 0.06 }\ncontact = { friction = 0.5 }\nstart = { to_edge = 0.1 }\n[[plate]]\nslope = \"15 deg\"";
/// let scene = SpaceScene::parse("stays.toml", text)?;
/// let report = SpaceRunReport::new(&scene, &scene.feeder().run().unwrap());
/// assert_eq!((serde_json::to_value(report.outcome).unwrap(), report.end.spin_rad_s), ("stuck".into(), [0.0; 3]));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "carom run: in space")]
pub struct SpaceRunReport {
    /// Name of the scene.
    pub scene: String,
    /// How the computed part differs from the drawn one; absent where it does not.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub approximations: Vec<Approximation>,
    /// What was done to the drawing that its author should know; absent where there is nothing to say.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
    /// How the run ended.
    pub outcome: Word<Outcome>,
    /// When [s].
    pub end_s: f64,
    /// Place, attitude and motion then.
    pub end: SpaceStateReport,
    /// The plates on which the part came to lie flat, in the order of landing.
    pub plates: Vec<PlateReport>,
    /// What the scene wants, and whether the run has it.
    pub wanted: Vec<Wanted>,
    /// How it left the last plate, when delivered.
    pub exit: Option<SpaceExitReport>,
    /// Between what it jammed; absent of other outcomes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub jam: Option<JamReport>,
    /// The faces of the part, by their numbers.
    pub faces: Vec<SolidFaceReport>,
    /// Stages, in order of time.
    pub stages: Vec<SpaceStageReport>,
    /// Impacts, in order of time.
    pub impacts: Vec<SpaceImpactReport>,
    /// Series of infinitely many impacts that were closed at their limit.
    pub accumulations: Vec<AccumulationReport>,
    /// How far each quantity may move before the verdict flips; only where it was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limits: Option<Vec<Limit>>,
    /// How many runs that took.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit_runs: Option<u64>,
    /// Impacts that had several consistent outcomes, of which the one that keeps the most contacts was followed.
    pub forks: u64,
    /// Deterministic counts of the work done.
    pub work: WorkReport,
}

/// Place, attitude and motion.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpaceStateReport {
    /// Mass centre, world axes [m].
    pub position_m: [f64; 3],
    /// The rotation of the part's axes into the world's, as a unit quaternion: w, x, y, z.
    pub attitude: [f64; 4],
    /// Velocity of the mass centre, world axes [m/s].
    pub velocity_m_s: [f64; 3],
    /// Angular velocity, in the part's axes [rad/s].
    pub spin_rad_s: [f64; 3],
}

/// How the part left the last plate.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpaceExitReport {
    /// When [s].
    pub t_s: f64,
    /// Place, attitude and motion then.
    #[serde(flatten)]
    pub state: SpaceStateReport,
}

impl From<&Exit> for SpaceExitReport {
    fn from(exit: &Exit) -> Self {
        Self { t_s: exit.time, state: state_report(&exit.state) }
    }
}

/// A stage.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpaceStageReport {
    /// Its name.
    pub name: Word<StageName>,
    /// The plate or wall on which it happens; null in flight.
    pub plate: Option<String>,
    /// Start [s].
    pub start_s: f64,
    /// End [s].
    pub end_s: f64,
    /// Why it ended, in words.
    pub ended_by: String,
    /// The same in parts.
    pub event: StageEndReport,
    /// State at its start.
    pub start: SpaceStateReport,
    /// State at its end.
    pub end: SpaceStateReport,
}

/// An impact.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpaceImpactReport {
    /// When [s].
    pub t_s: f64,
    /// The plate or wall that is struck first.
    pub plate: String,
    /// Speed of the striking point just before [m/s].
    pub speed_m_s: f64,
    /// Spin before, in the part's axes [rad/s].
    pub spin_before_rad_s: [f64; 3],
    /// Spin after, in the part's axes [rad/s].
    pub spin_after_rad_s: [f64; 3],
    /// Kinetic energy before.
    #[serde(rename = "energy_before_J")]
    pub energy_before: f64,
    /// Kinetic energy after.
    #[serde(rename = "energy_after_J")]
    pub energy_after: f64,
    /// True where several outcomes are consistent.
    pub several: bool,
    /// The contacts that touch, those that strike first.
    pub contacts: Vec<SpaceContactReport>,
}

/// A contact of an impact.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpaceContactReport {
    /// The plate or wall.
    pub plate: String,
    /// What of the part touches: a corner, a face, an edge.
    pub feature: String,
    /// True where it comes down in this impact.
    pub strikes: bool,
    /// What it does after: slips, sticks or separates.
    #[schemars(extend("enum" = ["slips", "sticks", "separates"]))]
    pub state: &'static str,
    /// The impulse on the part, world axes.
    #[serde(rename = "impulse_N_s")]
    pub impulse: [f64; 3],
}

impl SpaceRunReport {
    /// Of a run of a scene's feeder.
    pub fn new(scene: &SpaceScene, run: &Run) -> Self {
        let feeder = scene.feeder();
        let strikes = run.impacts.iter().zip(&run.struck_at).zip(&run.struck);
        let world = feeder.prepare(Default::default()).ok();
        let impact = |((impact, speed), owner): ((&Impact, &f64), &usize)| SpaceImpactReport {
            t_s: impact.time,
            plate: feeder.given(*owner).to_owned(),
            speed_m_s: *speed,
            spin_before_rad_s: impact.spin_before.to_array(),
            spin_after_rad_s: impact.spin_after.to_array(),
            energy_before: impact.kinetic_before,
            energy_after: impact.kinetic_after,
            several: impact.conclusion == carom_impact::spatial::Conclusion::Several,
            contacts: world.as_ref().map(|prepared| contacts(feeder, prepared, impact)).unwrap_or_default(),
        };
        Self {
            scene: scene.name().to_owned(),
            approximations: scene.approximations().to_vec(),
            notes: scene.notes().to_vec(),
            outcome: Word(run.outcome),
            end_s: run.end_time,
            end: state_report(&run.end),
            plates: run.landings.iter().map(|landing| landing_report(feeder, landing)).collect(),
            wanted: scene.wanted(run),
            exit: run.exit.as_ref().map(SpaceExitReport::from),
            jam: run.jam.as_ref().map(|jam| jam_report(feeder, jam)),
            faces: SolidFaceReport::of(scene),
            stages: run.stages.iter().map(|stage| stage_report(feeder, stage)).collect(),
            impacts: strikes.map(impact).collect(),
            accumulations: run
                .closings
                .iter()
                .map(|closing| AccumulationReport { from_s: closing.time, to_s: closing.limit })
                .collect(),
            limits: None,
            limit_runs: None,
            forks: run.forks,
            work: WorkReport {
                rhs_evaluations: run.effort.rhs_evaluations,
                events: run.effort.events,
                impacts: run.effort.impacts,
            },
        }
    }
}

fn contacts(
    feeder: &Feeder,
    prepared: &carom_feeder::spatial::Prepared<'_>,
    impact: &Impact,
) -> Vec<SpaceContactReport> {
    let one = |(support, impulse): &(usize, Vec3)| SpaceContactReport {
        plate: feeder.given(prepared.owner(*support)).to_owned(),
        feature: feeder.part_of(&prepared.touch(*support)),
        strikes: impact.striking.contains(*support),
        state: match () {
            () if !impact.kept.contains(*support) => "separates",
            () if impact.sliding.contains(*support) => "slips",
            () => "sticks",
        },
        impulse: impulse.to_array(),
    };
    let mut all: Vec<SpaceContactReport> = impact.impulses.iter().map(one).collect();
    all.sort_by_key(|contact| !contact.strikes);
    all
}

fn state_report(state: &State) -> SpaceStateReport {
    SpaceStateReport {
        position_m: state.centre.to_array(),
        attitude: state.attitude.to_array(),
        velocity_m_s: state.velocity.to_array(),
        spin_rad_s: state.spin.to_array(),
    }
}

fn stage_report(feeder: &Feeder, stage: &Stage<State, Touch>) -> SpaceStageReport {
    SpaceStageReport {
        name: Word(stage.name),
        plate: stage.obstacle.map(|obstacle| feeder.given(obstacle).to_owned()),
        start_s: stage.start_time,
        end_s: stage.end_time,
        ended_by: run_words::stage_end(feeder, &stage.ended_by),
        event: stage_end_report(feeder, &stage.ended_by),
        start: state_report(&stage.start),
        end: state_report(&stage.end),
    }
}
