//! What a run says, as JSON: SI, the unit in the key, angles and spins counter-clockwise, x right, y up.

use crate::angles::{angle_to_normal, incidence};
use crate::feed_report::FeedReport;
use crate::scene::Scene;
use crate::wanted::Wanted;
use carom_feeder::{Exit, Feeder, Landing, PartKind, Run, Stage, Verdict};
use carom_motion::planar::{
    State, Twist,
    trace::{Impact, ImpactContact},
};
use schemars::JsonSchema;
use serde::Serialize;

/// How far one quantity may move alone before the verdict flips, SI.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Limit {
    /// Its path.
    pub quantity: String,
    /// Lowest value with the same verdict; null where none was found.
    pub low: Option<f64>,
    /// Highest value with the same verdict; null where none was found.
    pub high: Option<f64>,
}

/// A run of a feeder.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "carom run")]
pub struct RunReport {
    /// Name of the scene.
    pub scene: String,
    /// landed, delivered, stuck, on_end, jammed, missed, escaped or never_flat; in a feed also blocked or unresolved.
    pub outcome: &'static str,
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
    /// Its name.
    pub margin_of: String,
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

/// `same` or `turned`, or the number of the face that is down.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum VerdictReport {
    /// same | turned, against the start.
    Word(&'static str),
    /// The face that is down.
    Face(usize),
}

/// A landing.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PlateReport {
    /// Name of the plate.
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
    /// slide, tip, flight, swing, stick, roll, wedge, push, rest or clatter.
    pub name: &'static str,
    /// The plate or wall it happens on; null in flight.
    pub plate: Option<String>,
    /// Start [s].
    pub start_s: f64,
    /// End [s].
    pub end_s: f64,
    /// Why it ended.
    pub ended_by: String,
    /// Pose and velocity at the start.
    pub start: StateReport,
    /// Pose and velocity at the end.
    pub end: StateReport,
}

/// Velocity of a body.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct TwistReport {
    /// Velocity of the mass centre [m/s].
    pub vx_m_s: f64,
    /// Velocity of the mass centre [m/s].
    pub vy_m_s: f64,
    /// Spin [rad/s].
    pub spin_rad_s: f64,
}

/// Velocity of a contact point of the body; the tangent is the normal turned 90° clockwise.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ContactVelocityReport {
    /// Along the tangent [m/s].
    pub slip_m_s: f64,
    /// Along the normal [m/s]; an approach is negative.
    pub normal_m_s: f64,
}

/// One contact's part in an impact.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ContactReport {
    /// The plate or wall.
    pub plate: String,
    /// The part's feature, as it lay at the start.
    pub feature: String,
    /// slips, sticks or separates.
    pub state: String,
    /// Where they touch [m].
    pub point_m: [f64; 2],
    /// Unit normal out of the obstacle.
    pub normal: [f64; 2],
    /// Normal impulse on the part [N s].
    #[serde(rename = "normal_impulse_N_s")]
    pub normal_impulse: f64,
    /// Tangential impulse on the part [N s].
    #[serde(rename = "tangential_impulse_N_s")]
    pub tangential_impulse: f64,
    /// Work of the normal impulse [J].
    #[serde(rename = "normal_work_J")]
    pub normal_work: f64,
    /// Work of the tangential impulse [J].
    #[serde(rename = "tangential_work_J")]
    pub tangential_work: f64,
    /// Velocity of the contact point before.
    pub before: ContactVelocityReport,
    /// Velocity of the contact point after.
    pub after: ContactVelocityReport,
}

/// An impact.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ImpactReport {
    /// Time [s].
    pub t_s: f64,
    /// Restitution law.
    pub law: String,
    /// Type 1 to 7, where one contact acts.
    #[serde(rename = "type")]
    pub kind: Option<u8>,
    /// Class of Wang and Mason, where one contact acts.
    pub class: Option<String>,
    /// From the struck plate's normal to the part's axis, positive where the mass centre is uphill of the striking corner [rad].
    pub angle_to_normal_rad: Option<f64>,
    /// From the struck plate's inward normal to the striking corner's velocity, positive where it moves downhill [rad].
    pub incidence_rad: Option<f64>,
    /// Velocity before.
    pub before: TwistReport,
    /// Velocity after.
    pub after: TwistReport,
    /// Kinetic energy before [J].
    #[serde(rename = "energy_before_J")]
    pub energy_before: f64,
    /// Kinetic energy after [J].
    #[serde(rename = "energy_after_J")]
    pub energy_after: f64,
    /// True where the law created energy.
    pub gained_energy: bool,
    /// The contacts, the striking one first.
    pub contacts: Vec<ContactReport>,
    /// What is remarkable about it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub note: Option<String>,
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
            wanted: scene.wanted(run),
            outcome: run.outcome.word(),
            end_s: run.end_time,
            plates: run.landings.iter().map(|landing| plate_report(feeder, landing)).collect(),
            exit: run.exit.as_ref().map(exit_report),
            margin: run.margin.is_finite().then_some(run.margin),
            margin_of: run.margin_of.clone(),
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
                rhs_evaluations: run.work.rhs_evaluations,
                events: run.work.events,
                impacts: run.work.impacts,
            },
            feed: None,
        }
    }
}

/// How a part left, for a report.
pub fn exit_report(exit: &Exit) -> ExitReport {
    ExitReport { t_s: exit.time, state: state_report(&exit.state) }
}

pub(crate) fn plate_report(feeder: &Feeder, landing: &Landing) -> PlateReport {
    let by_number = matches!(feeder.part.kind, PartKind::Polygon | PartKind::Disc);
    let verdict = match landing.verdict {
        Some(_) if by_number => landing.face.map(VerdictReport::Face),
        Some(Verdict::Same) => Some(VerdictReport::Word("same")),
        Some(Verdict::Turned) => Some(VerdictReport::Word("turned")),
        Some(Verdict::Face(face)) => Some(VerdictReport::Face(face)),
        None => None,
    };
    PlateReport {
        plate: feeder.obstacle_name(landing.plate).to_owned(),
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

fn twist_report(twist: &Twist) -> TwistReport {
    TwistReport { vx_m_s: twist.velocity.x, vy_m_s: twist.velocity.y, spin_rad_s: twist.spin }
}

pub(crate) fn stage_report(feeder: &Feeder, stage: &Stage) -> StageReport {
    StageReport {
        name: stage.name.word(),
        plate: stage.obstacle.map(|obstacle| feeder.obstacle_name(obstacle).to_owned()),
        start_s: stage.start_time,
        end_s: stage.end_time,
        ended_by: stage.ended_by.clone(),
        start: state_report(&stage.start),
        end: state_report(&stage.end),
    }
}

pub(crate) fn impact_report(feeder: &Feeder, impact: &Impact) -> ImpactReport {
    ImpactReport {
        t_s: impact.time,
        law: impact.law.to_string(),
        kind: impact.kind.map(|kind| kind.number()),
        class: impact.kind.map(|kind| kind.class().to_string()),
        angle_to_normal_rad: angle_to_normal(feeder, impact),
        incidence_rad: incidence(feeder, impact),
        before: twist_report(&impact.before),
        after: twist_report(&impact.after),
        energy_before: impact.energy_before,
        energy_after: impact.energy_after,
        gained_energy: impact.gained_energy,
        contacts: impact.contacts.iter().map(|contact| contact_report(feeder, contact)).collect(),
        note: impact_note(impact),
    }
}

fn contact_report(feeder: &Feeder, contact: &ImpactContact) -> ContactReport {
    let velocity = |velocity: carom_motion::planar::trace::ContactVelocity| ContactVelocityReport {
        slip_m_s: velocity.slip,
        normal_m_s: velocity.normal,
    };
    ContactReport {
        plate: feeder.obstacle_name(contact.obstacle).to_owned(),
        feature: feeder.feature_name(contact.feature),
        state: contact.state.to_string(),
        point_m: [contact.point.x, contact.point.y],
        normal: [contact.normal.x, contact.normal.y],
        normal_impulse: contact.normal_impulse,
        tangential_impulse: contact.tangential_impulse,
        normal_work: contact.normal_work,
        tangential_work: contact.tangential_work,
        before: velocity(contact.before),
        after: velocity(contact.after),
    }
}

/// What is remarkable about an impact, for a person.
pub fn impact_note(impact: &Impact) -> Option<String> {
    let mut notes = vec![];
    if impact.without_approach {
        notes.push("no contact approached: friction forces the impact (Painlevé's paradox)".to_owned());
    }
    if let Some(force) = impact.holding_would_need {
        notes.push(format!("lifts off at once: holding would need N = {force:.2} N"));
    }
    if impact.gained_energy {
        let gain = impact.energy_after - impact.energy_before;
        notes.push(format!("{} law created {gain:.3e} J", impact.law));
    }
    if impact.restitution_scaled < 1.0 {
        let scale = impact.restitution_scaled;
        notes.push(format!("restitution scaled by {scale:.4} so that energy does not grow"));
    }
    (!notes.is_empty()).then(|| notes.join("; "))
}
