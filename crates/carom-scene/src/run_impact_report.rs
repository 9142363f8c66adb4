//! What an impact of a run says, as JSON.

use crate::angles::{angle_to_normal, incidence};
use crate::unit::Dimension;
use carom_feeder::Feeder;
use carom_motion::planar::Twist;
use carom_motion::planar::trace::{ContactVelocity, Impact, ImpactContact};
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

fn twist_report(twist: &Twist) -> TwistReport {
    TwistReport { vx_m_s: twist.velocity.x, vy_m_s: twist.velocity.y, spin_rad_s: twist.spin }
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
    let velocity = |velocity: ContactVelocity| ContactVelocityReport {
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
    if impact.branches > 1 {
        let ways = impact.branches;
        notes.push(format!("up to {ways} ways on were consistent, and one was chosen"));
    }
    if impact.open_share {
        notes.push("the share of compression is open: others leave other motions".to_owned());
    }
    if let Some(force) = impact.holding_would_need {
        let force = Dimension::Number.show_digits(force, 3);
        notes.push(format!("lifts off at once: holding would need N = {force} N"));
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
