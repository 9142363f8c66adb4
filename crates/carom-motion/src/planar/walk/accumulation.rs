//! Infinitely many impacts in finite time: seen as a geometric series of intervals, closed at its limit.

use crate::tolerance::{LATE_SERIES, MOST_SERIES_RATIO, SERIES_LEFT};

/// Impacts remembered.
const REMEMBERED: usize = 9;

/// Times of the latest impacts, the newest last [s].
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::planar) struct Recent {
    times: [f64; REMEMBERED],
    len: usize,
}

/// A series of impacts about to accumulate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Series {
    /// Time of the first impact looked at [s].
    pub(super) from: f64,
    /// What is left until the limit [s].
    pub(super) left: f64,
}

impl Recent {
    pub(super) fn push(&mut self, time: f64) {
        if self.len == REMEMBERED {
            self.times.rotate_left(1);
            self.len -= 1;
        }
        self.times[self.len] = time;
        self.len += 1;
    }

    /// The latest impacts of two that meet; an impact of both counts once.
    pub(in crate::planar) fn of_both(a: &Self, b: &Self) -> Self {
        let mut times: Vec<f64> = a.times[..a.len].iter().chain(&b.times[..b.len]).copied().collect();
        times.sort_by(f64::total_cmp);
        times.dedup();
        let mut out = Self::default();
        for time in times {
            out.push(time);
        }
        out
    }

    /// The oldest impact remembered.
    pub(super) fn first(&self) -> Option<f64> {
        self.times[..self.len].first().copied()
    }

    pub(super) fn clear(&mut self) {
        self.len = 0;
    }

    /// The series these impacts belong to, once little is left of it. Four intervals are compared with the four before, so that a part that
    /// strikes with two corners in turn shows its ratio as well.
    pub(super) fn series(&self, time_scale: f64) -> Option<Series> {
        if self.len < REMEMBERED {
            return None;
        }
        let t = &self.times;
        let (late, early) = (t[8] - t[4], t[4] - t[0]);
        let ratio = late / early;
        if late == 0.0 {
            // Impacts at one instant: nothing is left.
            return Some(Series { from: t[0], left: 0.0 });
        }
        let left = late * ratio / (1.0 - ratio);
        (ratio < MOST_SERIES_RATIO && left < SERIES_LEFT * time_scale && late < LATE_SERIES * time_scale)
            .then_some(Series { from: t[0], left })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_geometric_series_is_closed_at_its_limit() {
        let mut recent = Recent::default();
        let (mut t, mut interval, e) = (0.0, 1e-4, 0.4);
        let limit = interval / (1.0 - e);
        for _ in 0..60 {
            recent.push(t);
            if let Some(series) = recent.series(1.0) {
                assert!((t + series.left - limit).abs() < 1e-12, "{t} {series:?} {limit}");
                return;
            }
            t += interval;
            interval *= e;
        }
        panic!("never closed");
    }

    #[test]
    fn equal_intervals_are_no_series() {
        let mut recent = Recent::default();
        for i in 0..30 {
            recent.push(f64::from(i) * 1e-9);
            assert!(recent.series(1.0).is_none(), "a ball that loses nothing bounces for ever");
        }
    }
}
