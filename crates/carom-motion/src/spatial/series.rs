//! Infinitely many impacts in finite time: seen as a geometric series of periods, closed at its limit.

use super::Supports;

/// Impacts remembered: three periods of the longest pattern, and one more.
const REMEMBERED: usize = 3 * MOST_PERIOD + 1;
/// Impacts in the longest pattern that is looked for.
const MOST_PERIOD: usize = 16;
/// A closing may be wrong by this fraction of the time that may be left for it: two successive ratios tell how much it is.
const WRONG: f64 = 1e-3;
/// So many impacts within so many times the time that may be left for a closing are the end of a series, whatever their pattern: even where a tenth of the
/// interval is lost at each, what is left of it is short enough.
const CROWDED: (usize, f64) = (24, 10.0);

/// The latest impacts, the newest last.
#[derive(Clone, Debug, Default)]
pub(super) struct Recent {
    impacts: Vec<(f64, Supports)>,
}

/// A series of impacts about to accumulate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Series {
    pub(super) period: usize,
    pub(super) ratio: f64,
    /// What is left until the limit \[s\].
    pub(super) left: f64,
    /// All supports that its impacts kept.
    pub(super) kept: Supports,
}

impl Recent {
    pub(super) fn push(&mut self, time: f64, kept: Supports) {
        if self.impacts.len() == REMEMBERED {
            self.impacts.remove(0);
        }
        self.impacts.push((time, kept));
    }

    pub(super) fn clear(&mut self) {
        self.impacts.clear();
    }

    /// The series these impacts belong to, once at most `short` \[s\] is left of it: the shortest pattern of supports that has been seen three times
    /// with ratios that agree well enough. What rounding leaves of a series that is almost over has no pattern: it is over once it crowds.
    pub(super) fn series(&self, short: f64) -> Option<Series> {
        let settled = |s: &Series, before: f64| {
            // The change of left = late r/(1 − r) with r, in units of it.
            let change = (s.ratio - before).abs() / (s.ratio * (1.0 - s.ratio));
            s.left * change <= WRONG * short
        };
        let patterned = (1..=MOST_PERIOD).find_map(|p| {
            let (series, before) = self.of_period(p)?;
            (self.repeats(p) && settled(&series, before) && series.left <= short).then_some(series)
        });
        patterned.or_else(|| self.crowded(short))
    }

    fn crowded(&self, short: f64) -> Option<Series> {
        let first = self.impacts.len().checked_sub(CROWDED.0)?;
        let latest = &self.impacts[first..];
        let lasted = latest.last()?.0 - latest.first()?.0;
        let kept = latest.iter().fold(Supports::NONE, |all, (_, kept)| all.and(*kept));
        (lasted <= CROWDED.1 * short).then_some(Series { period: 1, ratio: 0.0, left: 0.0, kept })
    }

    /// True where the last three periods keep the same supports in the same order.
    fn repeats(&self, p: usize) -> bool {
        let n = self.impacts.len();
        (n - 2 * p..n).all(|i| self.impacts[i].1 == self.impacts[i - p].1)
    }

    /// The series of this period, and the ratio one period before.
    fn of_period(&self, p: usize) -> Option<(Series, f64)> {
        let last = self.impacts.len().checked_sub(1)?;
        let first = last.checked_sub(3 * p)?;
        let time = |back: usize| self.impacts[last - back * p].0;
        let [late, middle, early] = [0, 1, 2].map(|k| time(k) - time(k + 1));
        let (ratio, before) = (late / middle, middle / early);
        let kept = self.impacts[first..].iter().fold(Supports::NONE, |all, (_, kept)| all.and(*kept));
        let left = late * ratio / (1.0 - ratio);
        (ratio < 0.999 && before.is_finite()).then_some((Series { period: p, ratio, left, kept }, before))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_geometric_series_is_closed_at_its_limit() {
        // Two supports in turn, with intervals that shrink to a half and to a fifth.
        let mut recent = Recent::default();
        let (mut t, mut interval) = (0.0, 1.0);
        let limit = 1.5 / (1.0 - 0.1);
        for i in 0..40 {
            recent.push(t, Supports::one(i % 2));
            if let Some(series) = recent.series(1e-6) {
                assert!((t + series.left - limit).abs() < 1e-14, "{t} {series:?} {limit}");
                assert_eq!((series.period, series.kept.len()), (2, 2));
                return;
            }
            t += interval;
            interval *= if i % 2 == 0 { 0.5 } else { 0.2 };
        }
        panic!("never closed");
    }

    #[test]
    fn equal_intervals_are_no_series() {
        let mut recent = Recent::default();
        for i in 0..100 {
            recent.push(f64::from(i) * 1e-12, Supports::one(0));
            assert_eq!(recent.series(1e-6), None, "what loses nothing goes on for ever");
        }
    }
}
