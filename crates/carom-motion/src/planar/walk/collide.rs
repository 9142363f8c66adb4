//! What happens where features meet: the impact, and the question asked again after it.

use super::accumulation::Series;
use super::terms::{Happening, MarginOf};
use super::walker::Walker;
use crate::MotionError;
use crate::planar::contact::{
    kinematics::{Kinematics, Pairing},
    touching::{Few, MOST_TOUCHING},
};
use crate::planar::geometry::State;
use crate::planar::modes::{
    mode::Held,
    question::Asked,
    strike::{Strike, Struck, Witness},
};
use crate::planar::record::observer::{ImpactFacts, Observers, is_dense};
use crate::tolerance::{SAME_POINT, SLOW_APPROACH, STILL_SPEED};
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

    /// What an impact does.
    fn resolved(&self, struck: &Few<Struck>, forced: bool, dense: bool) -> Result<Strike<B>, ImpactError> {
        let posed = (&self.states, &self.turns());
        match struck.len() {
            1 => Strike::at_one(&self.world, posed, struck, forced, dense),
            2 => Strike::at_several::<2, 4>(&self.world, posed, struck, dense),
            3..=6 => Strike::at_several::<6, 12>(&self.world, posed, struck, dense),
            _ => Strike::at_several::<12, 24>(&self.world, posed, struck, dense),
        }
    }

    /// What an impact does, and the contacts that take part in it: what opens where something else strikes does so where it would be thrown back at once.
    fn met(
        &self,
        struck: &Few<Struck>,
        forced: bool,
        dense: bool,
    ) -> (Few<Struck>, Result<Strike<B>, ImpactError>) {
        let mut closing = *struck;
        closing.retain(|s| s.normal <= 0.0);
        let resolved = self.resolved(&closing, forced, dense);
        if closing.len() < struck.len()
            && let Ok(strike) = &resolved
            && self.throws_back(struck, strike)
            && let Ok(all) = self.resolved(struck, forced, dense)
        {
            return (*struck, Ok(all));
        }
        (closing, resolved)
    }

    /// True where a contact that opens approaches after an impact in which it took no part.
    fn throws_back(&self, struck: &Few<Struck>, strike: &Strike<B>) -> bool {
        let (mut after, still) = (self.states, STILL_SPEED * self.scales.speed);
        after.iter_mut().zip(&strike.twists).for_each(|(state, twist)| state.twist = *twist);
        let mut opening = struck.iter().filter(|s| s.normal > 0.0);
        opening.any(|s| self.world.kinematics(&after, s.pair).approach < -still)
    }

    /// Resolves an impact and enters what follows it.
    fn strike(
        &mut self,
        struck: &Few<Struck>,
        forced: bool,
        observers: &mut Observers<'_, B>,
    ) -> Result<Happening, MotionError> {
        let before = self.states;
        let (taken, resolved) = self.met(struck, forced, is_dense(observers));
        let left_out = |s: &&Struck| !taken.iter().any(|t| t.pair == s.pair);
        struck.iter().filter(left_out).for_each(|s| self.depart(s.pair));
        let struck = &taken;
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
        self.rocking.note(struck, forced, self.time);
        if let Some((series, held)) = self.rocked() {
            return self.close_series(&series, &held, observers);
        }
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
        let (mut kept, mut closed, mut asked) = (Few::default(), Few::default(), Few::default());
        self.held.clear();
        for (s, [slip, normal]) in struck.iter().zip(strike.after.iter()) {
            if *normal <= still {
                kept.push(Held::slipping(s.pair, *slip, still));
            }
        }
        let (mut left, mut rates) = (0.0_f64, None);
        for (s, [slip, normal]) in struck.iter().zip(strike.after.iter()) {
            if *normal > still {
                let rates = rates.get_or_insert_with(|| self.world.accelerate(&kept, &self.states));
                let Some(rest) = self.left_at_the_limit(s.pair, *normal, rates) else {
                    self.depart(s.pair);
                    continue;
                };
                left = left.max(rest);
                closed.push(Held::slipping(s.pair, *slip, still));
            }
            let slip = if slip.abs() <= still { 0.0 } else { *slip };
            asked.push(Asked { pair: s.pair, slip, known: None, present: Slip::Open });
        }
        let from = self.recent.first().unwrap_or(self.time);
        let known = (!closed.is_empty()).then_some(Series { from, left });
        if let Some(series) = known.or_else(|| self.recent.series(self.scales.time))
            && let Some(held) = self.at_the_limit(&series)
            && (closed.is_empty() || held.iter().all(|h| asked.iter().any(|a| a.pair == h.pair)))
        {
            return self.close_series(&series, &held, observers);
        }
        // Others are on the move beside what falls back at once: what speed is left to it is taken away before the contacts are asked.
        if !closed.is_empty() {
            self.report_accumulation(from, observers);
            self.states = self.projected_onto(&self.stopped(&closed), &closed);
        }
        let happening = self.settle(&asked, observers)?;
        if is_dense(observers) {
            self.report_lift_off(&asked, observers);
        }
        Ok(happening)
    }

    /// Says which force a struck contact that opens at once would need to be held.
    fn report_lift_off(&self, asked: &Few<Asked>, observers: &mut Observers<'_, B>) {
        if asked.is_empty() || !self.held.is_empty() {
            return;
        }
        let mut all: Few<Held> = Few::default();
        for a in asked.iter() {
            all.push(Held::slipping(a.pair, a.slip, 0.0));
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
}

/// What it means that no outcome of so many contacts was found.
fn unresolved(contacts: usize) -> Happening {
    if contacts > MOST_EXAMINED { Happening::GivenUp } else { Happening::Jams }
}
