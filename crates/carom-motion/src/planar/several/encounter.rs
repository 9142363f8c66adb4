//! Which bodies of a crowd meet next, which touch, and what comes of it.

use super::crowd::{Advance, Crowd};
use super::island::Island;
use super::meeting::Approach;
use crate::MotionError;
use crate::planar::contact::kinematics::{Pairing, turns};
use crate::planar::record::observer::Observer;
use crate::tolerance::TOUCHING_GAP;

/// Two bodies that meet, with which features, and when.
#[derive(Clone, Copy, Debug)]
pub(super) struct Encounter {
    pub(super) time: f64,
    pub(super) bodies: (usize, usize),
    /// Numbered as in a world of these two.
    pub(super) pair: Pairing,
}

/// Events in a row at one instant after which encounters there are passed over.
const MOST_STALLS: u32 = 40;
/// Corrections of the time at which two bodies meet.
const MOST_CORRECTIONS: u32 = 4;

impl<'w> Crowd<'w> {
    /// The first meeting of two bodies that do not hold each other, before a time.
    pub(super) fn first_encounter(&self, until: f64) -> Option<Encounter> {
        let bodies: Vec<usize> = self.bodies().collect();
        let mut first: Option<Encounter> = None;
        for (i, &a) in bodies.iter().enumerate() {
            for &b in &bodies[i + 1..] {
                if !self.know_each_other(a, b) {
                    let until = first.map_or(until, |f| f.time);
                    first = self.encounter(a, b, until).or(first);
                }
            }
        }
        first
    }

    /// True where two bodies hold each other, or are watched by the walk of both.
    fn know_each_other(&self, a: usize, b: usize) -> bool {
        let obstacles = self.world.obstacles.len();
        self.island_of(a).is_some_and(|(island, place)| {
            island.place_of(b).is_some()
                && (island.held(place).iter().any(|h| h.obstacle == obstacles + b) || island.watches(a, b))
        })
    }

    fn encounter(&self, a: usize, b: usize, until: f64) -> Option<Encounter> {
        if self.never_near(a, b, until) {
            return None;
        }
        let world = self.world.of_some(&[a, b]);
        let at = |t: f64| [self.state_at(a, t), self.state_at(b, t)];
        let mut approach = Approach {
            world: &world,
            scales: self.scales,
            at,
            // Where time does not go on, what rounding says of an encounter is passed over.
            parting: self.stalls > MOST_STALLS || self.parting.iter().any(|p| *p == (a, b) || *p == (b, a)),
        };
        let mut from = self.time;
        for joint in self.joints(a, b, until) {
            if let Some((time, pair)) = approach.first_meeting((from, joint)) {
                return Some(Encounter { time, bodies: (a, b), pair });
            }
            (from, approach.parting) = (joint, false);
        }
        None
    }

    /// True where two bodies stand.
    fn never_near(&self, a: usize, b: usize, until: f64) -> bool {
        let stands = |body: usize| self.island_of(body).is_some_and(|(island, _)| island.stands());
        until <= self.time || (stands(a) && stands(b))
    }

    /// The ends of the stretches up to a time in which the motions of two bodies are smooth.
    fn joints(&self, a: usize, b: usize, until: f64) -> Vec<f64> {
        let mut out = vec![until];
        for (island, ahead) in self.islands.iter().zip(&self.ahead) {
            if let Some(ahead) = ahead
                && (island.place_of(a).is_some() || island.place_of(b).is_some())
            {
                out.extend(ahead.joints((self.time, until)));
            }
        }
        out.sort_by(f64::total_cmp);
        out
    }

    /// Adds the islands that touch those concerned: an impact goes through all bodies that touch.
    pub(super) fn add_touching(&self, time: f64, concerned: &mut Vec<usize>) {
        let reach = TOUCHING_GAP * self.scales.length;
        let mut next = 0;
        while next < concerned.len() {
            for other in 0..self.islands.len() {
                let touches = |a: usize, b: usize| self.distance(a, b, time) <= reach;
                let any = |a: &usize| self.islands[other].members.iter().any(|b| touches(*a, *b));
                if !concerned.contains(&other) && self.islands[concerned[next]].members.iter().any(any) {
                    concerned.push(other);
                }
            }
            next += 1;
        }
    }

    /// How far two bodies are apart at a time [m].
    fn distance(&self, a: usize, b: usize, time: f64) -> f64 {
        let world = self.world.of_some(&[a, b]);
        let states = [self.state_at(a, time), self.state_at(b, time)];
        Approach { world: &world, scales: self.scales, at: |_| states, parting: false }.distance(time)
    }

    /// The time of a meeting on the motions themselves: the paths that it was found on are their interpolants.
    pub(super) fn corrected(&self, encounter: &Encounter, i: usize, j: usize) -> Result<f64, MotionError> {
        let (a, b) = encounter.bodies;
        let world = self.world.of_some(&[a, b]);
        let end = |island: usize| self.ahead[island].as_ref().map_or(f64::INFINITY, |ahead| ahead.end);
        let (first, last) = (self.time, end(i).min(end(j)));
        let mut time = encounter.time;
        for _ in 0..MOST_CORRECTIONS {
            let mut both = [self.islands[i].clone(), self.islands[j].clone()];
            for island in &mut both {
                island.advance_to(time, &mut [])?;
            }
            let of = |island: &Island<'_>, body: usize| {
                island.place_of(body).map(|place| *island.state(place)).unwrap_or_default()
            };
            let states = [of(&both[0], a), of(&both[1], b)];
            let k = world.kinematics_turned(&states, &turns(&states), encounter.pair);
            let next = time - k.gap / k.approach;
            // Of the two roots of a short hop the one at which they open is not meant.
            let useless = k.approach >= 0.0 || k.gap.abs() <= TOUCHING_GAP * self.scales.length;
            if useless || !(next > first && next < last) {
                break;
            }
            time = next;
        }
        Ok(time)
    }

    /// Asks what a body that has just entered does with those it touches, where it touches any.
    pub(super) fn arrive(
        &mut self,
        body: usize,
        observers: &mut [&mut dyn Observer],
    ) -> Result<Option<Advance>, MotionError> {
        let Some(island) = self.islands.iter().position(|i| i.place_of(body).is_some()) else {
            return Ok(None);
        };
        let mut concerned = vec![island];
        self.add_touching(self.time, &mut concerned);
        if concerned.len() == 1 {
            return Ok(None);
        }
        self.resolve(self.time, &concerned, None, observers).map(Some)
    }

    /// Takes the islands of two bodies to where they meet, and resolves what happens there.
    pub(super) fn meet(
        &mut self,
        encounter: &Encounter,
        observers: &mut [&mut dyn Observer],
    ) -> Result<Advance, MotionError> {
        let (a, b) = encounter.bodies;
        let index = |body: usize| self.islands.iter().position(|i| i.place_of(body).is_some());
        let (Some(i), Some(j)) = (index(a), index(b)) else {
            return self.nothing();
        };
        let time = self.corrected(encounter, i, j)?;
        let mut concerned = vec![i];
        concerned.extend(Some(j).filter(|j| *j != i));
        self.add_touching(time, &mut concerned);
        let obstacles = self.world.obstacles.len();
        let pair = Pairing { body: a, obstacle: obstacles + b, feature: encounter.pair.feature };
        self.resolve(time, &concerned, Some(pair), observers)
    }

    /// Takes islands to a time, makes one island of them, and resolves what happens where they touch and with this pair.
    fn resolve(
        &mut self,
        time: f64,
        concerned: &[usize],
        pair: Option<Pairing>,
        observers: &mut [&mut dyn Observer],
    ) -> Result<Advance, MotionError> {
        let mut merged: Option<Island<'w>> = None;
        for &island in concerned {
            self.islands[island].advance_to(time, observers)?;
            let next = &self.islands[island];
            merged = Some(match merged {
                Some(whole) => whole.merged(next, self.world)?,
                None => next.clone(),
            });
        }
        let Some(mut merged) = merged else { return self.nothing() };
        let happening = merged.collide(pair, observers)?;
        let mut gone = concerned.to_vec();
        gone.sort_unstable();
        for island in gone.into_iter().rev() {
            self.islands.remove(island);
            self.ahead.remove(island);
        }
        self.move_on(time);
        self.part(merged, happening)
    }
}
