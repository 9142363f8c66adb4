//! Infinitely many impacts in finite time: seen as a geometric series of periods, closed at its limit.

use crate::periods::left;
use crate::spatial::geometry::supports::Supports;

/// Impacts remembered: four periods of the longest pattern, and one more.
const REMEMBERED: usize = 4 * MOST_PERIOD + 1;
/// Impacts in the longest pattern that is looked for.
const MOST_PERIOD: usize = 16;
/// So many impacts within this fraction of the time that may be left for a closing are the end of a series, whatever their pattern.
const CROWDED: (usize, f64) = (24, 0.1);
/// So many impacts in a row that are faint end a series as well.
const MOST_FAINT: usize = 12;

/// An impact, or the limit of a series of them, which may be one of a series itself.
#[derive(Clone, Copy, Debug)]
pub(super) struct Beat {
    /// When [s].
    pub(in crate::spatial) time: f64,
    /// The supports that touch the plane.
    pub(in crate::spatial) touching: Supports,
    /// What tells one impact of a period from the others.
    pub(super) pattern: Supports,
    /// Those that rest where a series of such impacts is over.
    pub(in crate::spatial) rests: Supports,
    /// The body moves too little to rise by what rounding leaves of heights.
    pub(super) faint: bool,
}

/// The latest impacts, the newest last.
#[derive(Clone, Debug, Default)]
pub(super) struct Recent {
    beats: Vec<Beat>,
}

/// A series of impacts about to accumulate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Series {
    pub(in crate::spatial) period: usize,
    pub(in crate::spatial) ratio: f64,
    /// What is left until the limit \[s\].
    pub(in crate::spatial) left: f64,
    /// The supports that rest after it: all that rest after any of its impacts.
    pub(in crate::spatial) kept: Supports,
}

impl Recent {
    pub(in crate::spatial) fn push(&mut self, beat: Beat) {
        if self.beats.len() == REMEMBERED {
            self.beats.remove(0);
        }
        self.beats.push(beat);
    }

    /// The pattern of the latest impact.
    pub(super) fn latest(&self) -> Option<Supports> {
        self.beats.last().map(|beat| beat.pattern)
    }

    pub(in crate::spatial) fn clear(&mut self) {
        self.beats.clear();
    }

    /// The series that these impacts belong to, once at most `short` \[s\] is left of it: the shortest pattern of supports that has been seen four
    /// times, with a limit that the last impact has not moved by more than `error` \[s\]. Rounding leaves no pattern of a series that is almost over: such a series
    /// is over once its impacts crowd, or are faint.
    pub(in crate::spatial) fn series(&self, short: f64, error: f64) -> Option<Series> {
        let patterned = (1..=MOST_PERIOD).find_map(|p| {
            let (series, moved) = self.of_period(p)?;
            (self.repeats(p) && moved <= error && series.left <= short).then_some(series)
        });
        patterned.or_else(|| self.crowded(short)).or_else(|| self.faint())
    }

    /// The series of the latest impacts, with nothing left of it: what has touched rests.
    fn over(&self, count: usize) -> Option<Series> {
        let latest = &self.beats[self.beats.len().checked_sub(count)?..];
        let touched = latest.iter().fold(Supports::NONE, |all, beat| all.union(beat.touching));
        Some(Series { period: 1, ratio: 0.0, left: 0.0, kept: touched })
    }

    fn crowded(&self, short: f64) -> Option<Series> {
        let (count, times) = CROWDED;
        let first = self.beats.get(self.beats.len().checked_sub(count)?)?;
        let lasted = self.beats.last()?.time - first.time;
        self.over(count).filter(|_| lasted <= times * short)
    }

    fn faint(&self) -> Option<Series> {
        let latest = self.beats.iter().rev().take(MOST_FAINT);
        self.over(MOST_FAINT).filter(|_| latest.into_iter().all(|beat| beat.faint))
    }

    /// True where the last four periods have the same impacts in the same order.
    fn repeats(&self, p: usize) -> bool {
        let n = self.beats.len();
        n >= 4 * p && (n - 3 * p..n).all(|i| self.beats[i].pattern == self.beats[i - p].pattern)
    }

    /// The series of this period, and how far its limit is from where the impact before had it [s].
    fn of_period(&self, p: usize) -> Option<(Series, f64)> {
        let last = self.beats.len().checked_sub(1)?;
        let (left, ratio) = self.left(p, last)?;
        let (before, _) = self.left(p, last.checked_sub(1)?)?;
        let lasted = self.beats[last].time - self.beats[last - 1].time;
        let period = &self.beats[last + 1 - p..];
        let kept = period.iter().fold(Supports::NONE, |all, beat| all.union(beat.rests));
        Some((Series { period: p, ratio, left, kept }, (lasted + left - before).abs()))
    }

    /// What is left after an impact of a series of this period, and its ratio.
    fn left(&self, p: usize, at: usize) -> Option<(f64, f64)> {
        let first = at.checked_sub(3 * p)?;
        left([0, 1, 2, 3].map(|k| self.beats[first + k * p].time))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn beat(time: f64, support: usize) -> Beat {
        let kept = Supports::one(support);
        Beat { time, touching: kept, pattern: kept, rests: kept, faint: false }
    }

    #[test]
    fn a_geometric_series_is_closed_at_its_limit() {
        // Two supports in turn, with intervals that shrink to a half and to a fifth.
        let mut recent = Recent::default();
        let (mut t, mut interval) = (0.0, 1.0);
        let limit = 1.5 / (1.0 - 0.1);
        for i in 0..40 {
            recent.push(beat(t, i % 2));
            if let Some(series) = recent.series(1e-6, 1e-9) {
                assert!((t + series.left - limit).abs() < 1e-14, "{t} {series:?} {limit}");
                assert_eq!((series.period, series.kept.len()), (2, 2));
                return;
            }
            t += interval;
            interval *= if i % 2 == 0 { 0.5 } else { 0.2 };
        }
        panic!("never closed");
    }

    /// Intervals whose ratio changes with their square, as those of bounces on a turning body do.
    #[test]
    fn a_ratio_that_still_changes_is_followed_to_its_limit() {
        for (ratio, bent) in [(0.5, 0.3), (0.2, -0.3), (0.9, 0.1)] {
            let mut recent = Recent::default();
            let (mut t, mut interval, mut last, mut closed) = (0.0, 0.1, 0.0, None);
            for _ in 0..400 {
                recent.push(beat(t, 0));
                closed = closed.or_else(|| recent.series(0.1, 1e-4).map(|series| (t, last, series)));
                t += interval;
                last = interval;
                interval *= ratio * (1.0 + bent * interval * interval);
            }
            let (at, last, series) = closed.unwrap();
            let plain = at + last * series.ratio / (1.0 - series.ratio) - t;
            let own = at + series.left - t;
            assert!(own.abs() < 0.1 * plain.abs(), "{ratio}: {own:e}, by the last ratio alone {plain:e}");
        }
    }

    #[test]
    fn ratios_that_disagree_are_no_series() {
        // One support, with intervals that shrink to a half and to a fifth in turn: what two of them would leave differs by as much as is left.
        let mut recent = Recent::default();
        let (mut t, mut interval) = (0.0, 1e-3);
        for i in 0..60 {
            recent.push(beat(t, 0));
            let closed = recent.series(1e-6, 1e-9);
            if let Some(series) = closed {
                assert_eq!(series.period, 2, "after {i}: {series:?}");
                return;
            }
            t += interval;
            interval *= if i % 2 == 0 { 0.5 } else { 0.2 };
        }
        panic!("never closed");
    }

    #[test]
    fn times_that_go_back_are_no_series() {
        let mut recent = Recent::default();
        for (i, t) in [0.0, 1.0, 1.5, 1.4, 1.42, 1.416].into_iter().enumerate() {
            recent.push(beat(t, 0));
            assert_eq!(
                recent.series(10.0, 1e-2).filter(|s| s.ratio <= 0.0 || s.left < 0.0),
                None,
                "after {i}"
            );
        }
    }

    /// Whether impacts with these intervals between them are a series of which at most 2 ms are left.
    fn closes(intervals: [f64; 4]) -> bool {
        let (mut recent, mut t) = (Recent::default(), 0.0);
        recent.push(beat(t, 0));
        for interval in intervals {
            t += interval;
            recent.push(beat(t, 0));
        }
        recent.series(2e-3, 2e-6).is_some()
    }

    /// Of 0.9, 0.09, 0.009 and 0.0009 s there is 0.0001 s left. One short interval after three long ones says nothing of what follows, though with its own ratio
    /// even less were left.
    #[test]
    fn intervals_whose_ratios_differ_are_no_series() {
        assert!(closes([0.9, 0.09, 0.009, 0.0009]), "each a tenth of the one before");
        assert!(!closes([1.1, 1.0, 0.9, 0.01]), "nine tenths, then a ninetieth");
    }

    #[test]
    fn equal_intervals_are_no_series() {
        let mut recent = Recent::default();
        for i in 0..100 {
            recent.push(beat(f64::from(i) * 1e-3, 0));
            assert_eq!(recent.series(1e-6, 1e-9), None, "what loses nothing goes on for ever");
        }
    }
}
