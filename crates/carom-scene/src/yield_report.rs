//! What a yield study says, as JSON.

use crate::approximation::Approximation;
use crate::map_report::StudyRunReport;
use crate::word::{EndingWord, Word};
use carom_impact::Law;
use carom_study::yields::{Estimate, Histogram, Spread};
use schemars::JsonSchema;
use serde::Serialize;

/// A probability with its 95 % interval.
///
/// # Example
/// ```
/// use carom_scene::ProbabilityReport;
/// use carom_study::yields::Estimate;
/// let report = ProbabilityReport::from(Estimate { share: 0.5, low: 0.25, high: 0.75, count: 32 });
/// assert_eq!((report.low, report.share, report.high, report.count), (0.25, 0.5, 0.75, 32));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ProbabilityReport {
    /// Share of the samples.
    pub share: f64,
    /// Lower end of the interval.
    pub low: f64,
    /// Upper end of the interval.
    pub high: f64,
    /// How many samples.
    pub count: u64,
}

impl From<Estimate> for ProbabilityReport {
    fn from(e: Estimate) -> Self {
        Self { share: e.share, low: e.low, high: e.high, count: e.count }
    }
}

/// How often a measure takes which values.
///
/// # Example
/// Two values of 7 in one bin, one far below.
/// ```
/// use carom_scene::HistogramReport;
/// use carom_study::yields::Histogram;
/// let histogram = Histogram { edges: vec![6.0, 8.0], counts: vec![2], below: 1, above: 0 };
/// let HistogramReport { edges, counts, below, above } = (&histogram).into();
/// assert_eq!((edges.len() - counts.len(), counts[0] + below + above), (1, 3));
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct HistogramReport {
    /// Edges of the bins, ascending and equally far apart, one more than there are bins; in the measure's unit.
    pub edges: Vec<f64>,
    /// Samples from each edge up to below the next; the last bin holds its upper edge too.
    pub counts: Vec<u64>,
    /// Samples below the first edge: far from the others.
    pub below: u64,
    /// Samples above the last edge.
    pub above: u64,
}

impl From<&Histogram> for HistogramReport {
    fn from(h: &Histogram) -> Self {
        Self { edges: h.edges.clone(), counts: h.counts.clone(), below: h.below, above: h.above }
    }
}

/// What a measure spreads over.
///
/// # Example
/// Two values, 6 and 8, with a mean of 7.
/// ```
/// use carom_scene::SpreadReport;
/// use carom_study::yields::{Histogram, Spread};
/// let histogram = Histogram { edges: vec![6.0, 8.0], counts: vec![2], below: 0, above: 0 };
/// let spread = Spread {
///     count: 2, low: 6.0, p01: 6.0, p05: 6.0, p25: 6.0, median: 8.0, p75: 8.0, p95: 8.0, p99: 8.0,
///     high: 8.0, mean: 7.0, histogram,
/// };
/// let report = SpreadReport::from(&spread);
/// assert_eq!((report.mean, report.histogram.counts), (0.5 * (report.low + report.high), vec![2]));
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpreadReport {
    /// Samples that have it.
    pub count: usize,
    /// Lowest.
    pub low: f64,
    /// One in a hundred is below.
    pub p01: f64,
    /// One in twenty is below.
    pub p05: f64,
    /// A quarter is below.
    pub p25: f64,
    /// Half are below.
    pub median: f64,
    /// A quarter is above.
    pub p75: f64,
    /// One in twenty is above.
    pub p95: f64,
    /// One in a hundred is above.
    pub p99: f64,
    /// Highest.
    pub high: f64,
    /// Arithmetic mean.
    pub mean: f64,
    /// How often which values.
    pub histogram: HistogramReport,
}

impl From<&Spread> for SpreadReport {
    fn from(s: &Spread) -> Self {
        Self {
            count: s.count,
            low: s.low,
            p01: s.p01,
            p05: s.p05,
            p25: s.p25,
            median: s.median,
            p75: s.p75,
            p95: s.p95,
            p99: s.p99,
            high: s.high,
            mean: s.mean,
            histogram: (&s.histogram).into(),
        }
    }
}

/// How a drop may end, and how probable that is.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EndingReport {
    /// same side, turned, face and its number; else how a run ends that never lies on the plate.
    pub ending: EndingWord,
    /// Its probability.
    pub probability: ProbabilityReport,
}

/// With what probability a part that lies on one face comes to lie on another on the next plate.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct TransitionReport {
    /// Name of the plate.
    pub plate: String,
    /// The face on the plate before, by its number; on the plate after the first, that on which it starts. Null of a disc.
    pub from: Option<usize>,
    /// The face on this plate; null where it comes to lie on none.
    pub to: Option<usize>,
    /// How it ends: the face, or how a run ends that never lies on the plate.
    pub ending: EndingWord,
    /// Share of the drops that come from that face.
    pub share: f64,
    /// Lower end of its 95 % interval.
    pub low: f64,
    /// Upper end of its 95 % interval.
    pub high: f64,
    /// How many drops do so.
    pub drops: u64,
}

/// A face and its share.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FaceShareReport {
    /// Number of the face.
    pub face: usize,
    /// Its share; `count` tells from how many repetitions the interval comes.
    pub share: ProbabilityReport,
}

/// A loop that throws the rejected back, when it has run for long: each rejected part comes back on the face on which it lay on the plate that is
/// looked at; for each part that leaves, or lies on no face, a new one comes in.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RecirculationReport {
    /// On which faces parts start, new ones and thrown back ones.
    pub starts: Vec<FaceShareReport>,
    /// With what probability a part in the loop ends as wanted in one pass.
    #[serde(rename = "yield")]
    pub probability: ProbabilityReport,
    /// Passes for each part that ends as wanted.
    pub passes: f64,
}

/// One plate.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct YieldPlateReport {
    /// Its name.
    pub plate: String,
    /// Speed of the striking point at the first strike [m/s].
    pub impact_speed_m_s: Option<SpreadReport>,
    /// Largest slip velocity [m/s].
    pub sliding_speed_m_s: Option<SpreadReport>,
    /// When the part first lies flat [s].
    pub flat_s: Option<SpreadReport>,
}

/// How much a tolerance has to do with whether a drop ends as wanted: Sobol's indices.
///
/// # Example
/// What a quantity explains by itself is no more than what it explains with others, but for the error of
/// both.
/// ```
/// use carom_scene::SensitivityReport;
/// use carom_study::yields::{Plan, Points, sensitivity};
/// let plan = Plan { dimensions: 1, samples: 8, seed: 1, points: Points::Sobol, plates: 1, plate: 0 };
/// let found = sensitivity(&plan, 64, |u| u[0] < 0.5).unwrap()[0];
/// let (first, first_error, total, total_error) =
///     (found.first, found.first_error, found.total, found.total_error);
/// let report = SensitivityReport { quantity: "part.mass".into(), first, first_error, total, total_error };
/// assert_eq!((report.first, report.total), (1.0, 1.0));
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SensitivityReport {
    /// Path of the quantity.
    pub quantity: String,
    /// Share of the variance that it explains by itself.
    pub first: f64,
    /// Half of the 95 % interval of that.
    pub first_error: f64,
    /// That and what it does together with others.
    pub total: f64,
    /// Half of the 95 % interval of that.
    pub total_error: f64,
}

/// How the drop of the middle of all tolerances ends under another law.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct LawReport {
    /// poisson, stronge or newton.
    pub law: Word<Law>,
    /// Restitution on every plate and wall.
    pub restitution: f64,
    /// How it ends.
    pub ending: EndingWord,
}

/// A drop that somebody should look at.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WorstReport {
    /// Its scene, beside the summary: `carom run` follows it again.
    pub file: String,
    /// How it ends.
    pub ending: EndingWord,
    /// nearest: of all drops with its ending the most probable one; hardest: the hardest first strike of all, on plates that the part comes to
    /// lie on.
    #[schemars(extend("enum" = ["nearest", "hardest"]))]
    pub why: &'static str,
    /// Largest speed of a first strike on the plates that the part comes to lie on [m/s]; null where it comes to lie on none but the one it
    /// starts on, whatever it strikes.
    pub impact_speed_m_s: Option<f64>,
}

/// The summary of a yield study.
///
/// # Example
/// A part every 1.5 s is 40 parts a minute; the probability's key is `yield`.
/// ```
/// use carom_scene::*;
/// let certain = ProbabilityReport { share: 1.0, low: 0.99, high: 1.0, count: 64 };
/// let report = YieldReport {
///     scene: "mine".into(), approximations: vec![], notes: vec![], plate: "lower".into(), wanted: "turned".into(), probability: certain,
///     yield_within_limits: None, endings: vec![], transitions: vec![], recirculation: None, plates: vec![], time_s: None,
///     parts_per_minute: Some(60.0 / 1.5), sensitivity: None, laws: vec![], worst: vec![], samples: 64,
///     seed: 1, run: StudyRunReport { drops: 64, seconds: 0.5, threads: 2 },
/// };
/// let json = serde_json::to_value(report)?;
/// assert!(json["yield"]["share"] == 1.0 && json["parts_per_minute"] == 40.0);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "carom yield")]
pub struct YieldReport {
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
    pub probability: ProbabilityReport,
    /// With what probability it does and keeps the limits of `[design]` on speed and time; null where it has none.
    pub yield_within_limits: Option<ProbabilityReport>,
    /// How drops end.
    pub endings: Vec<EndingReport>,
    /// From which face to which, plate by plate.
    pub transitions: Vec<TransitionReport>,
    /// What a loop that throws the rejected back comes to. Null of a disc; where no drop ends as wanted; where a rejected part lies on a face on which
    /// none was dropped.
    pub recirculation: Option<RecirculationReport>,
    /// What happens on each plate.
    pub plates: Vec<YieldPlateReport>,
    /// When runs end that end as wanted [s].
    pub time_s: Option<SpreadReport>,
    /// Parts a minute, one at a time: 60 s over the mean time; null where none ends as wanted.
    pub parts_per_minute: Option<f64>,
    /// Which tolerance decides, the largest first; null where too few samples end otherwise to tell, or there are too many quantities.
    pub sensitivity: Option<Vec<SensitivityReport>>,
    /// The drop of the middle of all tolerances under every law, and with more or less restitution.
    pub laws: Vec<LawReport>,
    /// Drops to look at.
    pub worst: Vec<WorstReport>,
    /// Samples, in 16 repetitions.
    pub samples: u64,
    /// What every random number comes from.
    pub seed: u64,
    /// What it took.
    pub run: StudyRunReport,
}
