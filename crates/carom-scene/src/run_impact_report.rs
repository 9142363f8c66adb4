//! What an impact of a run says, as JSON.

use crate::angles::{angle_to_normal, incidence};
use crate::run_end_report::AmountUnit;
use crate::word::Word;
use carom_feeder::Feeder;
use carom_impact::Law;
use carom_impact::planar::{Class, ContactState};
use carom_motion::planar::Twist;
use carom_motion::planar::trace::{ContactVelocity, Impact, ImpactContact};
use carom_words::{
    part,
    run::{self, Note},
};
use schemars::JsonSchema;
use serde::Serialize;

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
    /// The plate or wall: its name, or its number, counted from 0, where it has none.
    pub plate: String,
    /// The part's feature, as it lay at the start.
    pub feature: String,
    /// What it does after.
    pub state: Word<ContactState>,
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

/// A kind of note on an impact.
///
/// # Example
/// ```
/// use carom_scene::NoteKind;
/// assert_eq!(serde_json::to_string(&NoteKind::LiftsOff)?, r#""lifts_off""#);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum NoteKind {
    /// No contact approached: friction forces the impact (Painlevé's paradox).
    WithoutApproach,
    /// Several ways on were consistent, and one was chosen; the amount is how many at most.
    WaysOn,
    /// Other shares of the impulse of compression leave other motions.
    OpenShare,
    /// The part lifts off at once; the amount is the normal force that it would need to stay.
    LiftsOff,
    /// The law created energy; the amount is how much.
    GainedEnergy,
    /// Restitution was multiplied by the amount, so that energy does not grow.
    RestitutionScaled,
}

/// What is remarkable about an impact.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct NoteReport {
    /// What it is.
    pub kind: NoteKind,
    /// How much; null where the kind says all.
    pub amount: Option<f64>,
    /// The unit of the amount; null without one.
    pub unit: Option<AmountUnit>,
}

#[expect(clippy::cast_precision_loss, reason = "ways on are few")]
fn note_report(note: Note) -> NoteReport {
    let (kind, amount) = match note {
        Note::WithoutApproach => (NoteKind::WithoutApproach, None),
        Note::WaysOn(ways) => (NoteKind::WaysOn, Some((ways as f64, AmountUnit::One))),
        Note::OpenShare => (NoteKind::OpenShare, None),
        Note::LiftsOff(force) => (NoteKind::LiftsOff, Some((force, AmountUnit::Newton))),
        Note::GainedEnergy(gain) => (NoteKind::GainedEnergy, Some((gain, AmountUnit::Joule))),
        Note::RestitutionScaled(scale) => (NoteKind::RestitutionScaled, Some((scale, AmountUnit::One))),
    };
    NoteReport { kind, amount: amount.map(|(amount, _)| amount), unit: amount.map(|(_, unit)| unit) }
}

/// An impact.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ImpactReport {
    /// Time [s].
    pub t_s: f64,
    /// Restitution law.
    pub law: Word<Law>,
    /// Type 1 to 7, where one contact acts.
    #[serde(rename = "type")]
    pub kind: Option<u8>,
    /// Class of Wang and Mason, where one contact acts.
    pub class: Option<Word<Class>>,
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
    /// What is remarkable about it, in words.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub note: Option<String>,
    /// The same as data; absent where nothing is.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<NoteReport>,
}

fn twist_report(twist: &Twist) -> TwistReport {
    TwistReport { vx_m_s: twist.velocity.x, vy_m_s: twist.velocity.y, spin_rad_s: twist.spin }
}

pub(crate) fn impact_report(feeder: &Feeder, impact: &Impact) -> ImpactReport {
    ImpactReport {
        t_s: impact.time,
        law: Word(impact.law),
        kind: impact.kind.map(|kind| kind.number()),
        class: impact.kind.map(|kind| Word(kind.class())),
        angle_to_normal_rad: angle_to_normal(feeder, impact),
        incidence_rad: incidence(feeder, impact),
        before: twist_report(&impact.before),
        after: twist_report(&impact.after),
        energy_before: impact.energy_before,
        energy_after: impact.energy_after,
        gained_energy: impact.gained_energy,
        contacts: impact.contacts.iter().map(|contact| contact_report(feeder, contact)).collect(),
        note: run::note(impact),
        notes: run::notes(impact).into_iter().map(note_report).collect(),
    }
}

fn contact_report(feeder: &Feeder, contact: &ImpactContact) -> ContactReport {
    let velocity = |velocity: ContactVelocity| ContactVelocityReport {
        slip_m_s: velocity.slip,
        normal_m_s: velocity.normal,
    };
    ContactReport {
        plate: feeder.obstacle_name(contact.obstacle).to_owned(),
        feature: part::feature(feeder, contact.feature),
        state: Word(contact.state),
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
