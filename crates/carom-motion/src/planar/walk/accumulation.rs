//! Infinitely many impacts in finite time: seen as a geometric series of intervals, closed at its limit.

use super::rocking::Rocking;
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

use carom_impact::planar::Slip;

/// Impacts remembered.
const REMEMBERED: usize = 9;

/// Times of the latest impacts, the newest last [s].
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::planar) struct Recent {
    times: [f64; REMEMBERED],
    len: usize,
    /// Where the series before them was closed [s], if one was.
    ended: Option<f64>,
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
        let ended = [a.ended, b.ended].into_iter().flatten().reduce(f64::max);
        let mut out = Self { ended, ..Self::default() };
        for time in times {
            out.push(time);
        }
        out
    }

    /// The oldest impact remembered.
    pub(super) fn first(&self) -> Option<f64> {
        self.times[..self.len].first().copied()
    }

    /// A series is over, and its impacts are forgotten. A strike at this instant is no rebound of another one, however little it throws up.
    pub(super) fn end_series(&mut self, time: f64) {
        *self = Self { ended: Some(time), ..Self::default() };
    }

    /// What is left of a series [s] whose next impact follows after this time, if the intervals after it shrink as this one has. `None` where it has not.
    fn left_from(&self, next: f64) -> Option<f64> {
        let last = match self.times[..self.len] {
            [.., before, now] => now - before,
            [now] => self.ended.map_or(f64::INFINITY, |ended| now - ended),
            [] => f64::INFINITY,
        };
        let ratio = next / last;
        (ratio < MOST_SERIES_RATIO).then(|| next / (1.0 - ratio))
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
    /// What is left of the series of rebounds of a struck contact where it is at its limit: this rebound, and all that follow it, are over within a
    /// negligible time [s]. So the bodies accelerate by the contacts that the strike leaves closed: two bodies fall alike, and what brings them together
    /// again is what holds them.
    pub(super) fn left_at_the_limit(
        &self,
        pair: Pairing,
        rebound: f64,
        rates: &[Acceleration; B],
    ) -> Option<f64> {
        let bend = self.world.gap_bend(&self.kinematics(pair), pair, rates);
        let next = -2.0 * rebound / bend;
        if self.is_over_at_once(rebound, bend) { self.recent.left_from(next) } else { None }
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
        let near = self.near_within(series.left, &self.states);
        let (turns, still) = (self.turns(), STILL_SPEED * self.scales.speed);
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

    /// The pairs of bodies in these states that may touch within a short time [s].
    pub(super) fn near_within(&self, time: f64, states: &[State; B]) -> Few<Pairing> {
        let way = |s: &State| s.twist.velocity.norm() + s.twist.spin.abs() * self.scales.length;
        let way = time * self.states.iter().map(way).fold(0.0, f64::max);
        let reach = (10.0 * TOUCHING_GAP * self.scales.length).max(4.0 * way);
        let (deepest, still) = (DEEPEST_TOUCH * self.scales.length, STILL_SPEED * self.scales.speed);
        let search = Search { reach, deepest, sides: &self.sides, still, except: None };
        self.world.touching((states, &self.turned.of(states)), &search)
    }

    /// Infinitely many impacts end here: what bounces is at rest on what it bounced on.
    pub(super) fn close_series(
        &mut self,
        series: &Series,
        held: &Few<Held>,
        observers: &mut Observers<'_, B>,
    ) -> Result<Happening, MotionError> {
        // A lone body moves in the time that is left as it does from then on: that is what its rebounds come to. Of several, what is not struck may
        // hang on others: they go on as they are.
        let alone = B == 1;
        if alone {
            self.states = self.stopped(held);
        } else {
            for state in &mut self.states {
                state.pose.centre += state.twist.velocity * series.left;
                state.pose.angle += state.twist.spin * series.left;
            }
        }
        self.time += series.left;
        self.report_accumulation(series.from, observers);
        self.recent.end_series(self.time);
        self.rocking = Rocking::default();
        self.states = self.projected_onto(&self.states, held);
        self.departing.clear();
        self.held.clear();
        let mut pairs = Few::default();
        for h in held.iter() {
            pairs.push(h.pair);
        }
        let happening = self.collide(&pairs, observers)?;
        if alone && happening == Happening::Moves {
            self.states = self.moved_in(series.left);
        }
        Ok(happening)
    }

    /// Where the present mode moves the bodies within a short time [s], or until a slip stops before that: from then on another mode moves them.
    fn moved_in(&self, time: f64) -> [State; B] {
        let rates = self.world.accelerate(&self.held, &self.states);
        let after = |time: f64| {
            let mut states = self.states;
            states.iter_mut().zip(&rates).for_each(|(state, rate)| *state = rate.over(state, time));
            states
        };
        let moved = after(time);
        let share = |h: &Held| {
            let [from, to] = [&self.states, &moved].map(|states| self.world.kinematics(states, h.pair).slip);
            if from * to < 0.0 { from / (from - to) } else { 1.0 }
        };
        let slips = self.held.iter().filter(|h| h.slip != Slip::Sticks);
        let first = slips.map(share).fold(1.0, f64::min);
        if first < 1.0 { after(first * time) } else { moved }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planar::{examples, walk::terms::Options};

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
    fn what_is_left_is_passed_over_until_a_slip_stops() {
        // A ball of radius R without spin slips to its stop in v/(3 μ g): beyond that friction would turn it round.
        let (world, mut start) = examples::sliding_ball();
        let speed = 1e-7;
        start.twist.velocity.x = speed;
        let mut walker: Walker<1> = Walker::new(&world, start, vec![], Options::default()).unwrap();
        let pair = walker.touching(0.0).get(0).copied().unwrap();
        walker.held.push(Held { pair, slip: Slip::Forward });
        let stops = speed / (3.0 * 0.3 * 10.0);
        for (time, left) in [(0.5 * stops, 0.5 * speed), (stops, 0.0), (100.0 * stops, 0.0)] {
            let slip = world.kinematics(&walker.moved_in(time), pair).slip;
            assert!((slip - left).abs() < 1e-9 * speed, "{time} s: {slip} instead of {left} m/s");
        }
    }

    #[test]
    fn a_strike_where_a_series_ends_is_no_rebound_of_it() {
        let mut recent = Recent::default();
        recent.push(0.9);
        assert_eq!(recent.left_from(1e-9), Some(1e-9), "a single rebound that is over at once");
        recent.end_series(1.0);
        recent.push(1.0);
        assert_eq!(recent.left_from(1e-9), None, "it would be closed, and strike, without end");
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
