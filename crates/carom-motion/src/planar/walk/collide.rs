//! What happens where features meet: the impact, and the question asked again after it.

use super::accumulation::Series;
use super::terms::{Happening, MarginOf};
use super::walker::Walker;
use crate::MotionError;
use crate::planar::contact::{
    kinematics::{Kinematics, Pairing},
    touching::{Few, MOST_TOUCHING, Search},
};
use crate::planar::geometry::State;
use crate::planar::modes::{
    mode::{Acceleration, Held},
    question::Asked,
    strike::{Strike, Struck, Witness},
};
use crate::planar::record::observer::{ImpactFacts, Observers, is_dense};
use crate::tolerance::{DEEPEST_TOUCH, SAME_POINT, SERIES_LEFT, SLOW_APPROACH, STILL_SPEED, TOUCHING_GAP};
use carom_impact::ImpactError;
use carom_impact::planar::Slip;
use carom_impact::planar::rate::MOST_EXAMINED;

/// What an event has said of the pairs that meet.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::planar) struct Closed {
    /// A pair that meets.
    pub(in crate::planar) named: Option<Pairing>,
    /// Sine of the angle at which a face and an obstacle count as parallel.
    pub(in crate::planar) sine: f64,
}

/// Impacts without approach in a row, at one instant, after which the contacts count as jammed.
const MOST_FORCED: u32 = 4;

impl<const B: usize> Walker<'_, B> {
    /// All contacts that touch here meet: those held, those found, and the one that an event has named.
    pub(in crate::planar) fn collide_here(
        &mut self,
        closed: &Closed,
        observers: &mut Observers<'_, B>,
    ) -> Result<Happening, MotionError> {
        let mut pairs: Few<Pairing> = Few::default();
        for pair in self.held_pairs().map(|h| h.pair) {
            pairs.push(pair);
        }
        let found = self.touching(closed.sine);
        pairs.note_overflow(found.overflows());
        for pair in found.iter().copied().chain(closed.named) {
            let same_point = pairs.iter().any(|p| self.coincide(*p, pair));
            if !same_point {
                pairs.push(pair);
            }
        }
        self.collide(&pairs, observers)
    }

    /// True where two pairs of one body and what it meets touch at one point.
    pub(super) fn coincide(&self, a: Pairing, b: Pairing) -> bool {
        let arm = |p: Pairing| self.kinematics(p).arm;
        a == b
            || (a.meeting() == b.meeting()
                && (arm(a) - arm(b)).norm() <= SAME_POINT * self.scales.length
                && !self.world.are_inner_corner(a, b))
    }

    /// The pairs, but only one of those that touch at one point: contacts of two bodies can slide into one point.
    fn distinct(&self, pairs: &Few<Pairing>) -> Few<Pairing> {
        let mut out: Few<Pairing> = Few::default();
        for pair in pairs.iter() {
            if !out.iter().any(|known| self.coincide(*known, *pair)) {
                out.push(*pair);
            }
        }
        out
    }

    /// As [`Walker::distinct`], of contacts that are asked about.
    pub(super) fn distinct_asked(&self, asked: &Few<Asked>) -> Few<Asked> {
        let mut out: Few<Asked> = Few::default();
        for a in asked.iter() {
            if !out.iter().any(|known| self.coincide(known.pair, a.pair)) {
                out.push(*a);
            }
        }
        out
    }

    pub(super) fn impact_error(&self, error: ImpactError) -> MotionError {
        MotionError::Impact { time: self.time, error }
    }

    /// Resolves the impact of these pairs, if any of them approaches, and asks what holds afterwards.
    pub(super) fn collide(
        &mut self,
        pairs: &Few<Pairing>,
        observers: &mut Observers<'_, B>,
    ) -> Result<Happening, MotionError> {
        if pairs.overflows() {
            let most = MOST_TOUCHING;
            return Err(self.impact_error(ImpactError::TooMany { count: most + 1, most }));
        }
        let distinct;
        let pairs = if B == 1 {
            pairs
        } else {
            distinct = self.distinct(pairs);
            &distinct
        };
        // Contacts of one face must be as parallel as they are known to be: rounding would tell them apart.
        self.states = self.closed_up(&self.states, pairs);
        let turns = self.turns();
        let still = STILL_SPEED * self.scales.speed;
        let mut struck: Few<Struck> = Few::default();
        for pair in pairs.iter().copied() {
            let k = self.world.kinematics_turned(&self.states, &turns, pair);
            let held = self.held.iter().find(|h| h.pair == pair).copied();
            let still_here = k.approach.abs() <= still || self.hops_below_rounding(pair, &k);
            let normal = if held.is_some() || still_here { 0.0 } else { k.approach };
            let sticks = held.is_some_and(|h| h.slip == Slip::Sticks);
            let slip = if sticks || k.slip.abs() <= still { 0.0 } else { k.slip };
            struck.push(Struck { pair, slip, normal, present: held.map_or(Slip::Open, |h| h.slip) });
        }
        // What opens where something else strikes may be thrown back by that at once: it takes part.
        if struck.iter().any(|s| s.normal < 0.0) {
            return self.strike(&struck, false, observers);
        }
        struck.iter().filter(|s| s.normal > 0.0).for_each(|s| self.depart(s.pair));
        struck.retain(|s| s.normal <= 0.0);
        self.settle_struck(&struck, observers)
    }

    /// True where a contact opens so slowly that the present mode brings it back within a negligible time.
    fn hops_below_rounding(&self, pair: Pairing, k: &Kinematics) -> bool {
        if self.held.is_empty() || k.approach <= 0.0 || k.approach > SLOW_APPROACH * self.scales.speed {
            return false;
        }
        if !self.departing.iter().any(|d| *d == pair) {
            return false;
        }
        let a = self.world.accelerate(&self.held, &self.states);
        self.is_over_at_once(k.approach, self.world.gap_bend(k, pair, &a))
    }

    /// True where a gap that opens at this rate and bends so is closed again within a negligible time.
    fn is_over_at_once(&self, rate: f64, bend: f64) -> bool {
        bend < 0.0 && 2.0 * rate < -bend * SERIES_LEFT * self.scales.time
    }

    fn settle_struck(
        &mut self,
        struck: &Few<Struck>,
        observers: &mut Observers<'_, B>,
    ) -> Result<Happening, MotionError> {
        let mut asked = Few::default();
        for s in struck.iter() {
            asked.push(Asked { pair: s.pair, slip: s.slip, known: None, present: s.present });
        }
        self.settle(&asked, observers)
    }

    /// No hypothesis is consistent: an impact without approach.
    pub(super) fn force(
        &mut self,
        asked: &Few<Asked>,
        observers: &mut Observers<'_, B>,
    ) -> Result<Happening, MotionError> {
        self.forced += 1;
        if self.forced > MOST_FORCED {
            return Ok(Happening::Jams);
        }
        let mut struck = Few::default();
        for a in asked.iter() {
            struck.push(Struck { pair: a.pair, slip: a.slip, normal: 0.0, present: a.present });
        }
        self.strike(&struck, true, observers)
    }

    /// Resolves an impact and enters what follows it.
    fn strike(
        &mut self,
        struck: &Few<Struck>,
        forced: bool,
        observers: &mut Observers<'_, B>,
    ) -> Result<Happening, MotionError> {
        let before = self.states;
        let posed = (&before, &self.turns());
        let resolved = match struck.len() {
            1 => Strike::at_one(&self.world, posed, struck, forced, is_dense(observers)),
            2 => Strike::at_several::<2, 4>(&self.world, posed, struck, is_dense(observers)),
            3..=6 => Strike::at_several::<6, 12>(&self.world, posed, struck, is_dense(observers)),
            _ => Strike::at_several::<12, 24>(&self.world, posed, struck, is_dense(observers)),
        };
        let strike = match resolved {
            Ok(strike) => strike,
            Err(ImpactError::Jammed | ImpactError::Circling { .. }) => return Ok(unresolved(struck.len())),
            Err(error) => return Err(self.impact_error(error)),
        };
        if forced && !strike.acts() {
            return Ok(unresolved(struck.len()));
        }
        self.effort.impacts += 1;
        // The last of a series of rebounds decide nothing: they come at rest whatever they do.
        if struck.iter().any(|s| s.normal < -SLOW_APPROACH * self.scales.speed) {
            self.note_margin(strike.margin, MarginOf::Impact);
        }
        for (state, twist) in self.states.iter_mut().zip(&strike.twists) {
            state.twist = *twist;
        }
        self.report_impact(&strike, struck, &before, observers);
        self.recent.push(self.time);
        self.after_strike(struck, &strike, observers)
    }

    /// Tells of an impact, to those who look on each body that takes part.
    fn report_impact(
        &self,
        strike: &Strike<B>,
        struck: &Few<Struck>,
        before: &[State; B],
        observers: &mut Observers<'_, B>,
    ) {
        for (body, observer) in observers.iter_mut().enumerate().take(self.world.bodies.len()) {
            let Some(observer) = observer else { continue };
            let sees = |pair: Pairing| self.seen_by(body, pair);
            let to = Witness { world: &self.world, before, body, sees: &sees };
            let Some((first, obstacle, feature)) = strike.striking(struck, &to) else { continue };
            let facts = ImpactFacts {
                time: self.time,
                obstacle,
                feature,
                speed: (first.slip * first.slip + first.normal * first.normal).sqrt(),
                kind: strike.kind,
                before: before[body],
                after: self.states[body],
            };
            struck.iter().filter_map(|s| sees(s.pair)).for_each(|(obstacle, _)| observer.touches(obstacle));
            let whole = observer.is_dense().then(|| strike.whole(self.time, struck, &to));
            observer.impact(&facts, whole);
        }
    }

    /// Contacts that separate depart; the others are asked whether they hold.
    fn after_strike(
        &mut self,
        struck: &Few<Struck>,
        strike: &Strike<B>,
        observers: &mut Observers<'_, B>,
    ) -> Result<Happening, MotionError> {
        let still = STILL_SPEED * self.scales.speed;
        let mut asked = Few::default();
        let mut closed: Few<Held> = Few::default();
        self.held.clear();
        for (s, [slip, normal]) in struck.iter().zip(strike.after.iter()) {
            let bounces = *normal > still && !self.falls_back_at_once(s.pair, *normal);
            if bounces {
                self.depart(s.pair);
                continue;
            }
            // It rises, and is back at once: the series is at its limit, and what speed is left is taken away before the contacts are asked.
            if *normal > still {
                closed.push(Held { pair: s.pair, slip: Slip::Forward });
            }
            let slip = if slip.abs() <= still { 0.0 } else { *slip };
            asked.push(Asked { pair: s.pair, slip, known: None, present: Slip::Open });
        }
        if !closed.is_empty() {
            self.report_accumulation(self.recent.first().unwrap_or(self.time), observers);
            self.states = self.projected_onto(&self.states, &closed);
        }
        if let Some(series) = self.recent.series(self.scales.time)
            && let Some(held) = self.at_the_limit(&series)
        {
            return self.close_series(&series, &held, observers);
        }
        let happening = self.settle(&asked, observers)?;
        if is_dense(observers) {
            self.report_lift_off(&asked, observers);
        }
        Ok(happening)
    }

    fn report_accumulation(&self, from: f64, observers: &mut Observers<'_, B>) {
        for observer in observers.iter_mut().flatten() {
            observer.accumulation(from, self.time);
        }
    }

    /// True where a rebound, and all that follow it, are over within a negligible time: the series of rebounds is at its limit.
    fn falls_back_at_once(&self, pair: Pairing, rebound: f64) -> bool {
        let k = self.kinematics(pair);
        let falls = [Acceleration { linear: self.world.gravity, angular: 0.0 }; B];
        self.is_over_at_once(rebound, self.world.gap_bend(&k, pair, &falls))
    }

    /// Says which force a struck contact that opens at once would need to be held.
    fn report_lift_off(&self, asked: &Few<Asked>, observers: &mut Observers<'_, B>) {
        if asked.is_empty() || !self.held.is_empty() {
            return;
        }
        let mut all: Few<Held> = Few::default();
        for a in asked.iter() {
            let slip = if a.slip > 0.0 {
                Slip::Forward
            } else if a.slip < 0.0 {
                Slip::Backward
            } else {
                Slip::Sticks
            };
            all.push(Held { pair: a.pair, slip });
        }
        let forces = self.world.forces(&all, &self.states);
        for (body, observer) in observers.iter_mut().enumerate() {
            let Some(observer) = observer else { continue };
            let own = asked
                .iter()
                .zip(forces.contacts.iter())
                .filter(|(a, _)| self.seen_by(body, a.pair).is_some());
            let needed = own.map(|(_, c)| c.normal_force).fold(f64::INFINITY, f64::min);
            if needed < 0.0 {
                observer.lifts_off(needed);
            }
        }
    }

    /// The pairs that a series of impacts is about to bring to rest, if it brings all that are near to rest.
    fn at_the_limit(&self, series: &Series) -> Option<Few<Held>> {
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
            held.push(Held { pair, slip: if k.slip.abs() <= still { Slip::Sticks } else { Slip::Forward } });
        }
        Some(held)
    }

    /// Infinitely many impacts end here: what bounces is at rest on what it bounced on.
    fn close_series(
        &mut self,
        series: &Series,
        held: &Few<Held>,
        observers: &mut Observers<'_, B>,
    ) -> Result<Happening, MotionError> {
        self.recent.clear();
        for state in &mut self.states {
            state.pose.centre += state.twist.velocity * series.left;
            state.pose.angle += state.twist.spin * series.left;
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
        self.collide(&pairs, observers)
    }
}

/// What it means that no outcome of so many contacts was found.
fn unresolved(contacts: usize) -> Happening {
    if contacts > MOST_EXAMINED { Happening::GivenUp } else { Happening::Jams }
}
