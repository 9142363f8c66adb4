//! What contacts do in a stage of an impact in space, as JSON.

use crate::impact_event_report::{ForcedReport, ImpactEventReport};
use crate::inequality_report::InequalityReport;
use crate::word::Word;
use carom_impact::Phase;
use carom_impact::planar::ContactState;
use carom_impact::spatial::Mode;
use schemars::JsonSchema;
use serde::Serialize;

/// A hypothesis, and the inequality that rejects it.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpatialHypothesisReport {
    /// What it says of each contact.
    pub hypothesis: String,
    /// The same as data, in the order of the contacts: while the impulse grows. Under the law under which nothing slides, contacts stick or are open.
    pub states: Vec<Word<Mode>>,
    /// What rejects it, in words.
    pub because: String,
    /// The same as data.
    pub inequality: InequalityReport,
}

/// What a contact does: in a stage, or after the impact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum SpatialContactState {
    /// In a stage.
    In(Word<Mode>),
    /// After the impact.
    After(Word<ContactState>),
}

impl SpatialContactState {
    /// The word.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::In(mode) => mode.as_str(),
            Self::After(state) => state.as_str(),
        }
    }
}

/// One contact of an impact in space, at the end of the impact or of a stage.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpatialImpactContactReport {
    /// Its name.
    pub name: String,
    /// At the end separates, sticks or slips; in a stage open, slips, sticks or starts to slip.
    pub state: SpatialContactState,
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
    /// The phase that it is in.
    pub phase: Word<Phase>,
    /// Why it ended, in words.
    pub ended_by: String,
    /// The same as data.
    pub event: ImpactEventReport,
    /// No slip turns in it.
    pub straight: bool,
    /// What each contact does in it, and where it ends.
    pub contacts: Vec<SpatialImpactContactReport>,
    /// Why it is walked though no way on is consistent at its start: the contact that friction drives in (Painlevé's paradox), or the fastest one, is loaded
    /// alone; in words, null where one is.
    pub forced: Option<String>,
    /// The same as data.
    pub forced_at: Option<ForcedReport>,
    /// Every consistent way on at its start.
    pub ways_on: Vec<String>,
    /// The same as data, each in the order of the contacts.
    pub ways: Vec<Vec<Word<Mode>>>,
    /// False where there may be other ways on: directions of several slips that start were looked for.
    pub examined: bool,
    /// The other hypotheses, each with what rejects it.
    pub rejected: Vec<SpatialHypothesisReport>,
    /// Rejected hypotheses beyond those that are told.
    pub rejected_left_out: usize,
}
