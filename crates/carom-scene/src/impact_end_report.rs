//! How an impact goes and where it ends, as JSON.

use crate::impact_event_report::{ImpactEventReport, ImpactFailure};
use crate::impact_file::Convention;
use crate::impact_verdict::SharingVerdict;
use crate::word::Word;
use carom_impact::Phase;
use carom_impact::planar::{ContactState, Slip};
use schemars::JsonSchema;
use serde::Serialize;

/// One contact at the end.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EndContactReport {
    /// Its name.
    pub name: String,
    /// What it does after.
    pub state: Word<ContactState>,
    /// Normal impulse on the body [N s].
    #[serde(rename = "normal_impulse_N_s")]
    pub normal_impulse: f64,
    /// Tangential impulse on the body [N s].
    #[serde(rename = "tangential_impulse_N_s")]
    pub tangential_impulse: f64,
    /// Normal velocity after [m/s].
    pub normal_velocity_m_s: f64,
    /// Slip after [m/s].
    pub slip_m_s: f64,
}

/// One contact during a stage; pairs are the stage's start and end.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct StageContactReport {
    /// What it does: slips+ along the tangent, slips- against it.
    pub slip: Word<Slip>,
    /// Normal impulse so far [N s].
    #[serde(rename = "normal_impulse_N_s")]
    pub normal_impulse: [f64; 2],
    /// Tangential impulse so far [N s].
    #[serde(rename = "tangential_impulse_N_s")]
    pub tangential_impulse: [f64; 2],
    /// Normal velocity [m/s].
    pub normal_velocity_m_s: [f64; 2],
    /// Slip [m/s].
    pub slip_m_s: [f64; 2],
}

/// One straight stage of the walk.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WalkStageReport {
    /// The phase that it is in.
    pub phase: Word<Phase>,
    /// Why it ended, in words.
    pub ended_by: String,
    /// The same as data.
    pub event: ImpactEventReport,
    /// The contacts.
    pub contacts: Vec<StageContactReport>,
}

/// Which share of the impulses of compression a contact takes, of those that give the same motion.
///
/// # Example
/// ```
/// assert_eq!(serde_json::to_string(&carom_scene::ShareTaken::Least).unwrap(), r#""least""#);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ShareTaken {
    /// As little as the laws allow.
    Least,
    /// The share that is farthest from every inequality: the answer's own.
    Middle,
    /// As much as the laws allow; where they allow any, some more than it must.
    Most,
}

/// What another share of compression leaves: restitution multiplies the share that is taken.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct OpenShareReport {
    /// The contact whose share is asked for.
    pub contact: String,
    /// Which share it takes.
    pub takes: ShareTaken,
    /// Where that ends.
    pub end: EndReport,
}

/// One of several bodies after an impact.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct BodyReport {
    /// Its name.
    pub name: String,
    /// Velocity of its mass centre after [m/s].
    pub velocity_m_s: [f64; 2],
    /// Spin after [rad/s].
    pub spin_rad_s: f64,
}

/// What a convention on how closing contacts share an impact says.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SharingReport {
    /// The convention.
    pub sharing: Word<Convention>,
    /// It moves as the answer does.
    pub verdict: SharingVerdict,
    /// Where it ends; null where it has no answer.
    pub end: Option<EndReport>,
    /// Why it has no answer, in words; else null.
    pub because: Option<String>,
    /// The same as data.
    pub failure: Option<ImpactFailure>,
}

/// Where an impact ends.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EndReport {
    /// The contacts, in the order given.
    pub contacts: Vec<EndContactReport>,
    /// Velocity of the body after [m/s]; null without a body.
    pub velocity_m_s: Option<[f64; 2]>,
    /// Spin of the body after [rad/s]; null without a body.
    pub spin_rad_s: Option<f64>,
    /// Kinetic energy before [J]; null without a body.
    #[serde(rename = "energy_before_J")]
    pub energy_before: Option<f64>,
    /// Kinetic energy after [J]; null without a body.
    #[serde(rename = "energy_after_J")]
    pub energy_after: Option<f64>,
    /// Where several bodies meet: each of them; else empty.
    pub bodies: Vec<BodyReport>,
}
