//! A probability, with how sure it is; what a measure spreads over.

use super::histogram::Histogram;

/// A probability estimated from several scrambled point sets.
///
/// # Example
/// A rod on a slope of 3 in 4, whose friction is anything from 1/2 to 1, is held in half of all cases.
/// ```
/// use carom_feeder::{Outcome, Run, examples};
/// use carom_study::yields::{Estimate, Plan, Points, sample};
/// let slope = examples::rod_on_a_slope;
/// let plan = Plan { dimensions: 1, samples: 4, seed: 1, points: Points::Sobol, plates: 1, plate: 0 };
/// let varied = |u: &[f64]| Some(slope(0.5 + 0.5 * u[0]));
/// let held = |run: &Run| run.outcome == Outcome::Stuck;
/// let found = sample(&plan, varied, held, |u| (u[0] - 0.5).abs())?;
/// let Estimate { share, low, high, count } = found.wanted;
/// assert_eq!((share, count), (0.5, 16 * 4 / 2));
/// assert!(0.0 < low && low < share && share < high && high < 1.0);
/// # Ok::<(), carom_study::yields::YieldError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The share of all samples.
    pub share: f64,
    /// Lower end of the 95 % interval.
    pub low: f64,
    /// Upper end of the 95 % interval.
    pub high: f64,
    /// Samples that have it.
    pub count: u64,
}

/// Repetitions with scrambles of their own that a probability is estimated from.
pub const REPETITIONS: usize = 16;
/// Two-sided 95 % point of Student's distribution with 15 degrees of freedom.
const STUDENT: f64 = 2.131_449_545_559_323;
/// Two-sided 95 % point of the normal distribution.
const NORMAL: f64 = 1.959_963_984_540_054;
/// Below this many samples that have it, or that do not have it, the repetitions are too much alike to tell the spread.
pub(crate) const FEW: u64 = 40;

/// Wilson's interval of a share of so many independent samples (Journal of the American Statistical Association 22, 1927, 209): these points
/// spread less.
pub(crate) fn wilson(share: f64, samples: f64) -> [f64; 2] {
    let z = NORMAL * NORMAL / samples;
    let middle = (share + 0.5 * z) / (1.0 + z);
    let half = (z * share * (1.0 - share) + 0.25 * z * z).sqrt() / (1.0 + z);
    [middle - half, middle + half]
}

impl Estimate {
    /// From the counts of the repetitions, each of `samples` drops: Student's interval of their mean. Where few samples have it, or few do not, the
    /// interval is at least as wide as Wilson's of independent samples.
    pub(crate) fn of(counts: &[u64; REPETITIONS], samples: u64) -> Self {
        let (n, count) = (samples as f64, counts.iter().sum::<u64>());
        let all = n * REPETITIONS as f64;
        let share = count as f64 / all;
        let variance =
            counts.iter().map(|c| (*c as f64 / n - share).powi(2)).sum::<f64>() / (REPETITIONS - 1) as f64;
        // Counts are whole: equal ones say no more than that the spread is below half of one.
        let least = (0.5 / n).powi(2);
        let half = STUDENT * (variance.max(least) / REPETITIONS as f64).sqrt();
        let (mut low, mut high) = (share - half, share + half);
        if count.min(all as u64 - count) < FEW {
            let [below, above] = wilson(share, all);
            (low, high) = (low.min(below), high.max(above));
        }
        Self { share, low: low.max(0.0), high: high.min(1.0), count }
    }
}

impl Estimate {
    /// Of a share that each repetition gives once: Student's interval of their mean about the value of all together.
    pub(crate) fn about(share: f64, each: &[f64]) -> Self {
        let (mut low, mut high) = (0.0, 1.0);
        if each.len() == REPETITIONS {
            let variance =
                each.iter().map(|one| (one - share).powi(2)).sum::<f64>() / (REPETITIONS - 1) as f64;
            let half = STUDENT * (variance / REPETITIONS as f64).sqrt();
            (low, high) = (share - half, share + half);
        }
        Self { share, low: low.max(0.0), high: high.min(1.0), count: each.len() as u64 }
    }

    /// A share of some drops among those that they are counted with, which are no fixed number of each repetition.
    pub(crate) fn among(counts: &[u64; REPETITIONS], all: &[u64; REPETITIONS]) -> Self {
        let (count, whole) = (counts.iter().sum::<u64>(), all.iter().sum::<u64>());
        let share = count as f64 / whole.max(1) as f64;
        let [low, high] = wilson(share, whole.max(1) as f64);
        Self { share, low: low.max(0.0), high: high.min(1.0), count }
    }
}

/// What a measure spreads over.
///
/// # Example
/// A disc that always does the same strikes with `√(2·6·2 + 2·10·1.25)`, 7 m/s, every time.
/// ```
/// use carom_feeder::examples;
/// use carom_study::yields::{Plan, Points, Spread, sample};
/// let feeder = examples::disc_above_a_tray();
/// let plan = Plan { dimensions: 1, samples: 2, seed: 1, points: Points::Sobol, plates: 2, plate: 1 };
/// let found = sample(&plan, |_| Some(feeder.clone()), |_| true, |_| 0.0)?;
/// let Spread { count, low, median, high, .. } = found.plates[1].impact_speed.clone().unwrap();
/// assert_eq!((count, low, median), (32, high, high));
/// assert!((high - 7.0).abs() < 1e-12);
/// # Ok::<(), carom_study::yields::YieldError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Spread {
    /// Samples that have the measure.
    pub count: usize,
    /// Lowest.
    pub low: f64,
    /// One in a hundred is below this.
    pub p01: f64,
    /// One in twenty is below this.
    pub p05: f64,
    /// A quarter is below this.
    pub p25: f64,
    /// Half are below this.
    pub median: f64,
    /// A quarter is above this.
    pub p75: f64,
    /// One in twenty is above this.
    pub p95: f64,
    /// One in a hundred is above this.
    pub p99: f64,
    /// Highest.
    pub high: f64,
    /// Arithmetic mean.
    pub mean: f64,
    /// How often which values.
    pub histogram: Histogram,
}

impl Spread {
    /// Of these values, in any order; `None` of none. A quantile is the value whose rank is nearest.
    pub(crate) fn of(mut values: Vec<f64>) -> Option<Self> {
        values.sort_by(f64::total_cmp);
        let (low, high) = (*values.first()?, *values.last()?);
        let at = |share: f64| values[((values.len() - 1) as f64 * share).round() as usize];
        Some(Self {
            count: values.len(),
            low,
            p01: at(0.01),
            p05: at(0.05),
            p25: at(0.25),
            median: at(0.5),
            p75: at(0.75),
            p95: at(0.95),
            p99: at(0.99),
            high,
            mean: values.iter().sum::<f64>() / values.len() as f64,
            histogram: Histogram::of(&values),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_failure_among_many_is_no_certainty() {
        let none = Estimate::of(&[0; REPETITIONS], 64);
        assert_eq!((none.share, none.low, none.count), (0.0, 0.0, 0));
        // Half a count's spread, 2.1314·0.5·16/√16 = 4.263 of all samples, and no less than Wilson's z²/(N + z²).
        assert!((none.high - 4.2629 / 1024.0).abs() < 1e-6 && none.high > 3.8415 / 1027.8415, "{none:?}");
        let mut one = [0; REPETITIONS];
        one[3] = 1;
        let one = Estimate::of(&one, 64);
        assert!(one.high > none.high && one.low < one.share, "more is more: {one:?}");
        let alike = Estimate::of(&[14; REPETITIONS], 16);
        assert!(alike.high - alike.low > 0.01, "equal counts are no certainty: {alike:?}");
        let all = Estimate::of(&[64; REPETITIONS], 64);
        assert!((all.low + none.high - 1.0).abs() < 1e-12 && all.high == 1.0, "{all:?}");
    }

    #[test]
    fn a_spread_names_its_quantiles() {
        let spread = Spread::of((0..=100).rev().map(f64::from).collect()).unwrap();
        assert_eq!(
            (spread.low, spread.p05, spread.median, spread.p95, spread.high),
            (0.0, 5.0, 50.0, 95.0, 100.0)
        );
        let outer = (spread.p01, spread.p25, spread.p75, spread.p99);
        assert_eq!(outer, (1.0, 25.0, 75.0, 99.0));
        assert_eq!(spread.histogram.counts.iter().sum::<u64>(), 101, "{:?}", spread.histogram);
        assert_eq!(Spread::of(vec![]), None);
    }
}
