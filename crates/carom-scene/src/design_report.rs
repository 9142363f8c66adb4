//! What an inverse design says, as JSON.

use crate::approximation::Approximation;
use crate::map_report::StudyRunReport;
use crate::run_report::ExitReport;
use crate::yield_report::ProbabilityReport;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// A layout.
///
/// # Example
/// ```
/// # use carom_scene::*;
/// let certain = ProbabilityReport { share: 1.0, low: 0.99, high: 1.0, count: 64 };
/// let layout = DesignLayoutReport {
///     chosen: [("plate.lower.drop".to_owned(), 0.2)].into(), probability: certain, yield_doubled: certain,
///     impact_speed_m_s: 2.0, sliding_speed_m_s: 1.0, height_m: 0.5, width_m: 0.4, time_s: 1.25,
/// };
/// let json = serde_json::to_value(layout)?;
/// assert!(json["chosen"]["plate.lower.drop"] == 0.2 && json["yield"]["low"] == 0.99);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DesignLayoutReport {
    /// The quantities that were chosen, SI.
    pub chosen: BTreeMap<String, f64>,
    /// Share of drops that end as wanted within the limits, under the tolerances.
    #[serde(rename = "yield")]
    pub probability: ProbabilityReport,
    /// The same with every tolerance doubled.
    pub yield_doubled: ProbabilityReport,
    /// The hardest strike on a plate, the first or a later one, where nothing varies [m/s].
    pub impact_speed_m_s: f64,
    /// The largest slip velocity [m/s].
    pub sliding_speed_m_s: f64,
    /// From the highest end of a plate to the lowest [m].
    pub height_m: f64,
    /// From the leftmost end of a plate to the rightmost [m].
    pub width_m: f64,
    /// When the run ends [s].
    pub time_s: f64,
}

/// The worst of the winner's drops within their tolerances.
///
/// # Example
/// ```
/// use carom_scene::DesignWorstReport;
/// let worst = DesignWorstReport { impact_speed_m_s: 1.43, sliding_speed_m_s: 1.0, time_s: 0.75, drops: 4096, limits_hold: false };
/// assert_eq!(serde_json::to_value(worst)?["limits_hold"], false);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DesignWorstReport {
    /// The hardest strike on a plate, the first or a later one [m/s].
    pub impact_speed_m_s: f64,
    /// The largest slip velocity [m/s].
    pub sliding_speed_m_s: f64,
    /// When the longest run ends [s].
    pub time_s: f64,
    /// How many drops were looked at.
    pub drops: u64,
    /// True where none of them exceeds a limit on speed or time.
    pub limits_hold: bool,
}

/// What a demand forbids.
///
/// # Example
/// The nearest layout that fails the limit of 3 m/s alone misses it by 0.5 m/s.
/// ```
/// use carom_scene::ForbiddenReport;
/// let demand = carom_study::design::Demand::ImpactSpeed.to_string();
/// let (nearest, limit) = (Some(3.5), Some(3.0));
/// let json = serde_json::to_value(ForbiddenReport { demand, failed: 12, alone: 4, nearest, limit })?;
/// assert_eq!(json["demand"], "impact speed");
/// let number = |key: &str| json[key].as_f64().unwrap();
/// assert_eq!(number("nearest") - number("limit"), 0.5);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ForbiddenReport {
    /// The demand.
    pub demand: String,
    /// Layouts of the first look that fail it.
    pub failed: u64,
    /// Those that fail it and no other.
    pub alone: u64,
    /// The nearest to the limit of these, SI; null where there is none, or the demand has no measure.
    pub nearest: Option<f64>,
    /// The limit, SI; null where the demand has no measure.
    pub limit: Option<f64>,
}

/// The answer to an inverse design.
///
/// # Example
/// Where nothing meets the demands there is no winner: null.
/// ```
/// use carom_scene::{DesignReport, StudyRunReport};
/// let report = DesignReport {
///     scene: "mine".into(), approximations: vec![], outcome: "not possible", aim: "yield", winner: None, delivered: vec![],
///     worst: None, at_range_ends: [].into(), wall_strikes: [].into(),
///     exit: None, ends: None, front: vec![], forbidden: vec![], scanned: 16, met: 0, seed: 1,
///     run: StudyRunReport { drops: 16, seconds: 0.5, threads: 2 },
/// };
/// let json = serde_json::to_value(report)?;
/// assert!(json["winner"].is_null() && json["met"] == 0);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "carom design")]
pub struct DesignReport {
    /// Name of the scene.
    pub scene: String,
    /// How the computed part differs from the drawn one; absent where it does not.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub approximations: Vec<Approximation>,
    /// found, or not possible.
    pub outcome: &'static str,
    /// What is aimed at: yield, height or time.
    pub aim: &'static str,
    /// The best layout, with values that a workshop can keep.
    pub winner: Option<DesignLayoutReport>,
    /// The worst of its drops within their tolerances; null without a winner.
    pub worst: Option<DesignWorstReport>,
    /// Its quantities that are at an end of their range, with `low` or `high`: a wider range may do better.
    pub at_range_ends: BTreeMap<String, &'static str>,
    /// How often it strikes each wall where nothing varies; walls that it does not touch are absent.
    pub wall_strikes: BTreeMap<String, usize>,
    /// How the part is delivered: the ending on every plate, in order.
    pub delivered: Vec<String>,
    /// How it leaves the last plate, where nothing varies; null where it does not, and without a winner.
    pub exit: Option<ExitReport>,
    /// How the winner's run ends that is followed as far as the part goes: `delivered`, or why it is not.
    pub ends: Option<&'static str>,
    /// Layouts none of which is worse than another in yield, height and impact speed at once.
    pub front: Vec<DesignLayoutReport>,
    /// What the demands forbid, by the first look.
    pub forbidden: Vec<ForbiddenReport>,
    /// Layouts of the first look.
    pub scanned: u64,
    /// Those of them that meet every demand where nothing varies.
    pub met: u64,
    /// What every random number comes from.
    pub seed: u64,
    /// What it took.
    pub run: StudyRunReport,
}
