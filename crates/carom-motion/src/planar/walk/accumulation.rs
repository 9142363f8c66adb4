//! Infinitely many impacts in finite time: seen as a geometric series of intervals, closed at its limit.

use super::terms::Happening;
use super::walker::Walker;
use crate::MotionError;
use crate::planar::contact::{
    kinematics::Pairing,
    touching::{Few, Search},
};
use crate::planar::geometry::State;
use crate::planar::modes::mode::{Acceleration, Held};
use crate::planar::record::observer::Observers;
use crate::tolerance::{
    DEEPEST_TOUCH, LATE_SERIES, MOST_SERIES_RATIO, SERIES_LEFT, SLOW_APPROACH, STILL_SPEED, TOUCHING_GAP,
};

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

impl<const B: usize> Walker<'_, B> {
    /// True where a rebound, and all that follow it, are over within a negligible time: the series of rebounds is at its limit.
    pub(super) fn falls_back_at_once(&self, pair: Pairing, rebound: f64) -> bool {
        let k = self.kinematics(pair);
        let falls = [Acceleration { linear: self.world.gravity, angular: 0.0 }; B];
        self.is_over_at_once(rebound, self.world.gap_bend(&k, pair, &falls))
    }

    /// True where a gap that opens at this rate and bends so is closed again within a negligible time.
    pub(super) fn is_over_at_once(&self, rate: f64, bend: f64) -> bool {
        bend < 0.0 && 2.0 * rate < -bend * SERIES_LEFT * self.scales.time
    }

    pub(super) fn report_accumulation(&self, from: f64, observers: &mut Observers<'_, B>) {
        for observer in observers.iter_mut().flatten() {
            observer.accumulation(from, self.time);
        }
    }

    /// The pairs that a series of impacts is about to bring to rest, if it brings all that are near to rest.
    pub(super) fn at_the_limit(&self, series: &Series) -> Option<Few<Held>> {
        let way = |s: &State| s.twist.velocity.norm() + s.twist.spin.abs() * self.scales.length;
        let way = series.left * self.states.iter().map(way).fold(0.0, f64::max);
        let reach = (10.0 * TOUCHING_GAP * self.scales.length).max(4.0 * way);
        let (deepest, still) = (DEEPEST_TOUCH * self.scales.length, STILL_SPEED * self.scales.speed);
        let near = self.world.touching(
            (&self.states, &self.turns()),
            &Search { reach, deepest, sides: &self.sides, still, except: None },
        );
        let turns = self.turns();
        let mut held: Few<Held> = Few::default();
        for pair in near.iter().copied() {
            let k = self.world.kinematics_turned(&self.states, &turns, pair);
            if k.approach.abs() > SLOW_APPROACH * self.scales.speed {
                return None;
            }
            held.push(Held::slipping(pair, k.slip, still));
        }
        Some(held)
    }

    /// Infinitely many impacts end here: what bounces is at rest on what it bounced on.
    pub(super) fn close_series(
        &mut self,
        series: &Series,
        held: &Few<Held>,
        observers: &mut Observers<'_, B>,
    ) -> Result<Happening, MotionError> {
        self.recent.clear();
        // A lone body moves in the time that is left as it does from then on: that is what its rebounds come to. Of several, what is not struck may
        // hang on others: they go on as they are.
        let alone = B == 1;
        if !alone {
            for state in &mut self.states {
                state.pose.centre += state.twist.velocity * series.left;
                state.pose.angle += state.twist.spin * series.left;
            }
        }
        self.time += series.left;
        self.report_accumulation(series.from, observers);
        self.states = self.projected_onto(&self.states, held);
        self.departing.clear();
        self.held.clear();
        let mut pairs = Few::default();
        for h in held.iter() {
            pairs.push(h.pair);
        }
        let happening = self.collide(&pairs, observers)?;
        if alone && happening == Happening::Moves {
            let rates = self.world.accelerate(&self.held, &self.states);
            for (state, rate) in self.states.iter_mut().zip(rates) {
                *state = rate.over(state, series.left);
            }
        }
        Ok(happening)
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
