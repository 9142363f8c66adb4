//! What a fit says, as JSON.

use crate::approximation::Approximation;
use crate::map_report::StudyRunReport;
use schemars::JsonSchema;
use serde::Serialize;

/// A quantity that was fitted.
///
/// # Example
/// ```
/// use carom_scene::FitParameterReport;
/// let name = "contact.friction".to_owned();
/// let friction = FitParameterReport {
///     name, unit: String::new(), best: 0.2, low: 0.15, high: 0.27, level: 0.95, median: 0.21, mean: 0.21,
///     standard_deviation: 0.03, range: [0.0, 1.0],
/// };
/// assert!(friction.low <= friction.best && friction.best <= friction.high);
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FitParameterReport {
    /// Its path in the scene.
    pub name: String,
    /// SI unit of its values; empty for plain numbers.
    pub unit: String,
    /// Where the likelihood is highest, of all points that are in the intervals of all quantities.
    pub best: f64,
    /// Lower end of its interval.
    pub low: f64,
    /// Upper end of its interval.
    pub high: f64,
    /// Probability that the interval holds it.
    pub level: f64,
    /// It is as probably above as below this.
    pub median: f64,
    /// Mean of the posterior.
    pub mean: f64,
    /// Standard deviation of the posterior.
    pub standard_deviation: f64,
    /// The range that was looked at, in which all values are equally likely before.
    pub range: [f64; 2],
}

/// What the runs do not tell.
///
/// # Example
/// ```
/// use carom_scene::NotToldReport;
/// let why = "the runs say nothing of it".to_owned();
/// let report = NotToldReport { parameters: vec!["contact.restitution".into()], kind: "range", correlation: None, why };
/// assert_eq!(serde_json::to_value(report)?["kind"], "range");
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct NotToldReport {
    /// Paths of one quantity, or of two.
    pub parameters: Vec<String>,
    /// range: the interval of one is about as wide as without any run; ridge: the runs tell a combination of two, and neither alone.
    #[schemars(extend("enum" = ["range", "ridge"]))]
    pub kind: &'static str,
    /// Correlation of two; null for one.
    pub correlation: Option<f64>,
    /// The same in words.
    pub why: String,
}

/// The standard deviation of measured times, where it was fitted.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FitScatterReport {
    /// Most probable [s].
    pub best: f64,
    /// Lower end of its interval [s].
    pub low: f64,
    /// Upper end of its interval [s].
    pub high: f64,
}

/// The summary of a fit.
///
/// # Example
/// ```
/// use carom_scene::*;
/// let report = FitReport {
///     scene: "mine".into(), approximations: vec![], plate: "lower".into(), runs: "mine.csv".into(), observed_drops: 40,
///     parameters: vec![], time_scatter_s: None, likelihood: -12.5, not_told_apart: vec![], resolved: true, few_samples: false, misfit: Some(0.97), samples: 256,
///     nodes: 120, seed: 1, run: StudyRunReport { drops: 30_720, seconds: 0.5, threads: 2 },
/// };
/// assert_eq!(serde_json::to_value(report)?["likelihood"], -12.5);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "carom fit")]
pub struct FitReport {
    /// Name of the scene.
    pub scene: String,
    /// How the computed part differs from the drawn one; absent where it does not.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub approximations: Vec<Approximation>,
    /// The plate that is looked at.
    pub plate: String,
    /// The file of the runs.
    pub runs: String,
    /// Drops that it tells of.
    pub observed_drops: u64,
    /// What was fitted.
    pub parameters: Vec<FitParameterReport>,
    /// Standard deviation of the times; null where it was given, or nothing was timed.
    pub time_scatter_s: Option<FitScatterReport>,
    /// Natural logarithm of the highest likelihood: densities of times per second, counts without multinomial coefficients.
    pub likelihood: f64,
    /// What the runs do not tell; empty where they tell all.
    pub not_told_apart: Vec<NotToldReport>,
    /// False where the budget of nodes ended first: intervals are then coarse.
    pub resolved: bool,
    /// True where the engine's drops at a node are fewer than ten times those observed under one setting: intervals are then wider than the observed drops
    /// allow, and may miss by several of their widths where an outcome is rare.
    pub few_samples: bool,
    /// How far times of a known scatter are off the engine's at the best values, as a root mean square in standard deviations: about 1 where the scatter and
    /// the scene are right. Null without such times.
    pub misfit: Option<f64>,
    /// Drops of the engine at each node, under each condition.
    pub samples: u64,
    /// Nodes of the range that the engine was asked at.
    pub nodes: usize,
    /// What every random number comes from.
    pub seed: u64,
    /// What it took.
    pub run: StudyRunReport,
}
