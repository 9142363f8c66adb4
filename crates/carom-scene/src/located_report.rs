//! What a located yield says, as JSON.

use crate::approximation::Approximation;
use crate::map_report::StudyRunReport;
use schemars::JsonSchema;
use serde::Serialize;

/// A probability by the boundary of what is wanted.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct LocatedShareReport {
    /// The probability.
    pub share: f64,
    /// Lower end of its 95 % interval, in which what no line and no check met is not.
    pub low: f64,
    /// Upper end of its 95 % interval.
    pub high: f64,
    /// Along how many lines it was located.
    pub lines: u64,
    /// What of all drops may end otherwise than their line says, at most (Wilson, 95 %): one more drop on each line checked it.
    pub unseen_share: f64,
    /// Path of the quantity along which the boundary was located.
    pub along: String,
}

/// The summary of a yield that was located: lines along one quantity say where drops stop to end as wanted.
///
/// # Example
/// ```
/// use carom_scene::*;
/// let (share, low, high, lines) = (0.5, 0.499, 0.501, 128);
/// let report = LocatedReport {
///     scene: "mine".into(), approximations: vec![], notes: vec![], plate: "lower".into(), wanted: "turned".into(),
///     located: LocatedShareReport { share, low, high, lines, unseen_share: 0.03, along: "start.to_edge".into() },
///     yield_within_limits: None, seed: 1, run: StudyRunReport { drops: 1600, seconds: 0.05, threads: 1 },
/// };
/// let json = serde_json::to_value(report)?;
/// assert!(json["yield"]["share"] == 0.5 && json["yield"]["along"] == "start.to_edge");
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "carom yield --locate")]
pub struct LocatedReport {
    /// Name of the scene.
    pub scene: String,
    /// How the computed part differs from the drawn one; absent where it does not.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub approximations: Vec<Approximation>,
    /// What was read from the part's file, taken from tables, or assumed; absent where there is nothing to say.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
    /// The plate that is looked at.
    pub plate: String,
    /// What is wanted: as the scene says, or as the drop of the middle of all tolerances ends.
    pub wanted: String,
    /// With what probability it comes out so.
    #[serde(rename = "yield")]
    pub located: LocatedShareReport,
    /// With what probability it does and keeps the limits of `[design]` on speed and time; null where it has none.
    pub yield_within_limits: Option<LocatedShareReport>,
    /// What every random number comes from.
    pub seed: u64,
    /// What it took.
    pub run: StudyRunReport,
}
