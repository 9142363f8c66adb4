//! What contacts do in a stage of an impact in space, as JSON.

use crate::inequality_report::InequalityReport;
use schemars::JsonSchema;
use serde::Serialize;

/// A hypothesis, and the inequality that rejects it.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpatialHypothesisReport {
    /// What it says of each contact.
    pub hypothesis: String,
    /// What rejects it, in words.
    pub because: String,
    /// The same as data.
    pub inequality: InequalityReport,
}

/// One contact of an impact in space, at the end of the impact or of a stage.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpatialImpactContactReport {
    /// Its name.
    pub name: String,
    /// At the end separates, sticks or slips; in a stage open, slips, sticks or starts to slip.
    pub state: String,
    /// Impulse so far on the body into which the normal points [N s], in the axes that `axes` names.
    #[serde(rename = "impulse_N_s")]
    pub impulse: [f64; 3],
    /// Normal part of it [N s].
    #[serde(rename = "normal_impulse_N_s")]
    pub normal_impulse: f64,
    /// Velocity of the contact point, relative to the other body [m/s].
    pub velocity_m_s: [f64; 3],
    /// Normal part of it [m/s].
    pub normal_velocity_m_s: f64,
}

/// A stage of the walk.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpatialWalkStageReport {
    /// compression or restitution.
    pub phase: String,
    /// Why it ended.
    pub ended_by: String,
    /// No slip turns in it.
    pub straight: bool,
    /// What each contact does in it, and where it ends.
    pub contacts: Vec<SpatialImpactContactReport>,
    /// Why it is walked though no way on is consistent at its start: the contact that friction drives in (Painlevé's paradox), or the fastest one, is loaded
    /// alone; null where one is.
    pub forced: Option<String>,
    /// Every consistent way on at its start.
    pub ways_on: Vec<String>,
    /// False where there may be other ways on: directions of several slips that start were looked for.
    pub examined: bool,
    /// The other hypotheses, each with what rejects it.
    pub rejected: Vec<SpatialHypothesisReport>,
    /// Rejected hypotheses beyond those that are told.
    pub rejected_left_out: usize,
}
