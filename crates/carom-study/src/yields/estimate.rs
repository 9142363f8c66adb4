//! A probability, with how sure it is.

/// A probability estimated from several scrambled point sets.
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
/// What each tail of the interval holds.
const TAIL: f64 = 0.025;

impl Estimate {
    /// From the counts of the repetitions, each of `samples` drops: Student's interval of their mean. Where all samples agree, or none, the
    /// repetitions show no spread: the exact binomial bound takes its place, which holds for these points all the more.
    pub(super) fn of(counts: &[u64; REPETITIONS], samples: u64) -> Self {
        let (n, count) = (samples as f64, counts.iter().sum::<u64>());
        let all = n * REPETITIONS as f64;
        let share = count as f64 / all;
        let variance =
            counts.iter().map(|c| (*c as f64 / n - share).powi(2)).sum::<f64>() / (REPETITIONS - 1) as f64;
        let half = STUDENT * (variance / REPETITIONS as f64).sqrt();
        let tail = carom_num::elementary::pow(TAIL, 1.0 / all);
        let low = if count as f64 == all { tail } else { (share - half).max(0.0) };
        let high = if count == 0 { 1.0 - tail } else { (share + half).min(1.0) };
        Self { share, low, high, count }
    }
}

/// What a measure spreads over.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// Samples that have the measure.
    pub count: usize,
    /// Lowest.
    pub low: f64,
    /// One in twenty is below this.
    pub p05: f64,
    /// Half are below this.
    pub median: f64,
    /// One in twenty is above this.
    pub p95: f64,
    /// Highest.
    pub high: f64,
    /// Arithmetic mean.
    pub mean: f64,
}

impl Spread {
    /// Of these values, in any order; `None` of none.
    pub(super) fn of(mut values: Vec<f64>) -> Option<Self> {
        values.sort_by(f64::total_cmp);
        let (low, high) = (*values.first()?, *values.last()?);
        let at = |share: f64| values[((values.len() - 1) as f64 * share).round() as usize];
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        Some(Self { count: values.len(), low, p05: at(0.05), median: at(0.5), p95: at(0.95), high, mean })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_failure_among_many_is_no_certainty() {
        let none = Estimate::of(&[0; REPETITIONS], 64);
        assert_eq!((none.share, none.low, none.count), (0.0, 0.0, 0));
        // The rule of three, with 3.689 for two sides: 3.689/1024.
        assert!((none.high - 3.689 / 1024.0).abs() < 1e-5, "{none:?}");
        let all = Estimate::of(&[64; REPETITIONS], 64);
        assert!((all.low + none.high - 1.0).abs() < 1e-15 && all.high == 1.0, "{all:?}");
    }

    #[test]
    fn a_spread_names_its_quantiles() {
        let spread = Spread::of((0..=100).rev().map(f64::from).collect()).unwrap();
        assert_eq!(
            (spread.low, spread.p05, spread.median, spread.p95, spread.high),
            (0.0, 5.0, 50.0, 95.0, 100.0)
        );
        assert_eq!(Spread::of(vec![]), None);
    }
}
