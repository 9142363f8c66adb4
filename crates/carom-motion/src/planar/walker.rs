//! The walk in time through modes: solve the rate problem, move until an event, resolve what it brings, ask again.

use super::accumulation::Recent;
use super::kinematics::{Kinematics, Pairing, Turn, Turned};
use super::mode::Held;
use super::observer::{Observer, Observers};
use super::path::Leg;
use super::question::Asked;
use super::terms::{Effort, Happening, Margin, MarginOf, MotionError, Options};
use super::touching::{Few, Search};
use super::trace::{HeldContact, PieceEnd};
use super::world::Scales;
use super::{Feature, State, Twist, World};
use crate::evaluated::{unless_lost, watched};
use carom_impact::planar::Slip;
use carom_num::Vec2;
use std::borrow::Cow;

/// A body on its way, or `B` that touch each other.
#[derive(Clone, Debug)]
pub struct Walker<'w, const B: usize = 1> {
    pub(super) world: Cow<'w, World>,
    /// The numbers of the bodies for those who look on.
    pub(super) names: [usize; B],
    pub(super) scales: Scales,
    pub(super) options: Options,
    pub(super) time: f64,
    /// Of each body; those beyond the world's bodies are not used.
    pub(super) states: [State; B],
    pub(super) held: Few<Held>,
    /// Pairs that have just opened.
    pub(super) departing: Few<Pairing>,
    pub(super) sides: Vec<bool>,
    pub(super) recent: Recent,
    pub(super) effort: Effort,
    pub(super) margin: Margin,
    /// Impacts without approach in a row at this instant.
    pub(super) forced: u32,
    /// Events in a row that time does not part.
    pub(super) stalls: u32,
    pub(super) ended: Option<Happening>,
    /// Where the present piece leads, for those who want to know.
    pub(super) path: Option<Vec<Leg<B>>>,
    /// The contacts of the start have been asked what they do.
    pub(super) begun: bool,
    pub(super) turned: Turned<B>,
    /// A number was lost on the way.
    lost: bool,
}

/// Velocities below this fraction of the world's speed are rounding.
pub(super) const STILL: f64 = 1e-9;
/// Cosine of the angle between directions that count as the same.
const SAME: f64 = 1.0 - 1e-12;
/// A scaled slack below this is a tie of rounding.
const TIE: f64 = 1e-12;
/// Gaps below this fraction of the body's size are rounding.
pub(super) const TOUCHES: f64 = 1e-11;

impl<'w> Walker<'w> {
    /// A body that starts in `state`; the first advance asks what the contacts it has there do. `sides` tells for each obstacle on which side of it (left of its
    /// direction: true) a rod lies that is in line with it.
    ///
    /// # Errors
    /// [`MotionError::NotFinite`] where the state is not finite.
    pub fn new(
        world: &'w World,
        state: State,
        sides: Vec<bool>,
        options: Options,
    ) -> Result<Self, MotionError> {
        Self::of_states(Cow::Borrowed(world), [0], [state], sides, options)
    }

    /// Pose and velocity.
    pub fn state(&self) -> &State {
        &self.states[0]
    }

    /// The contacts held at present.
    pub fn held(&self) -> impl Iterator<Item = HeldContact> + '_ {
        self.held_of(0)
    }

    /// The face of the body that lies on an obstacle, kept there by a second contact on it or on one in line with it.
    pub fn flat_on(&self, obstacle: usize) -> Option<usize> {
        self.lies_flat(0, obstacle)
    }

    /// Moves through one smooth piece and resolves the event that ends it.
    ///
    /// # Errors
    /// [`MotionError`]: a fault of the numbers.
    pub fn advance(&mut self, observer: &mut dyn Observer) -> Result<Happening, MotionError> {
        let time = self.time;
        unless_lost(self, |w| &mut w.lost, time, |w| w.advance_all(&mut [Some(observer)]))
    }
}

impl<'w, const B: usize> Walker<'w, B> {
    /// Bodies that start in these states.
    pub(super) fn of_states(
        world: Cow<'w, World>,
        names: [usize; B],
        states: [State; B],
        sides: Vec<bool>,
        options: Options,
    ) -> Result<Self, MotionError> {
        let (scales, pairs) = (world.scales(), world.bodies.len() * world.things());
        let mut walker = Self {
            world,
            names,
            scales,
            options,
            time: 0.0,
            states,
            held: Few::default(),
            departing: Few::default(),
            sides,
            recent: Recent::default(),
            effort: Effort::default(),
            margin: Margin { value: f64::INFINITY, of: MarginOf::Nothing, time: 0.0 },
            forced: 0,
            stalls: 0,
            ended: None,
            path: None,
            begun: false,
            turned: Turned::default(),
            lost: false,
        };
        walker.sides.resize(pairs, true);
        if !states.iter().all(State::is_finite) {
            return Err(MotionError::NotFinite { time: 0.0 });
        }
        let ((), lost) = watched(|| walker.note_sides());
        if lost { Err(MotionError::NotFinite { time: 0.0 }) } else { Ok(walker) }
    }

    /// The turns of the bodies where they are.
    pub(super) fn turns(&self) -> [Turn; B] {
        self.turned.of(&self.states)
    }

    /// Kinematics of a pair where the bodies are.
    pub(super) fn kinematics(&self, pair: Pairing) -> Kinematics {
        self.world.kinematics_turned(&self.states, &self.turns(), pair)
    }

    /// Time [s].
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Counts of the work done so far.
    pub fn effort(&self) -> Effort {
        self.effort
    }

    /// How certain the walk is so far.
    pub fn margin(&self) -> Margin {
        self.margin
    }

    /// What a pair is to one of the bodies: the number of what it touches, and the features; `None` where it does not take part.
    pub(super) fn seen_by(&self, body: usize, pair: Pairing) -> Option<(usize, Feature)> {
        let named = |b: usize| self.world.obstacles.len() + self.names[b];
        let other = self.world.other_body(pair);
        if pair.body == body {
            Some((other.map_or(pair.obstacle, named), pair.feature))
        } else {
            (other == Some(body)).then(|| (named(pair.body), pair.feature.from_the_other_side()))
        }
    }

    /// The contacts that one of the bodies holds at present.
    pub(super) fn held_of(&self, body: usize) -> impl Iterator<Item = HeldContact> + '_ {
        self.held.iter().filter_map(move |h| {
            let (obstacle, feature) = self.seen_by(body, h.pair)?;
            Some(HeldContact { obstacle, feature, slip: h.slip })
        })
    }

    /// The face of a body that lies on an obstacle, kept there by a second contact on it or on one in line with it.
    pub(super) fn lies_flat(&self, body: usize, obstacle: usize) -> Option<usize> {
        let turns = self.turns();
        let of = |h: &Held| self.world.kinematics_turned(&self.states, &turns, h.pair);
        let own = || self.held.iter().filter(|h| h.pair.body == body);
        let first = of(own().find(|h| h.pair.obstacle == obstacle)?);
        let beside = |k: Kinematics| {
            let apart = (k.arm - first.arm).dot(first.tangent()).abs();
            k.normal.dot(first.normal) > SAME && apart > 1e-9 * self.scales.length
        };
        let along = self.world.obstacles[obstacle].direction();
        if !own().any(|h| beside(of(h))) || along.cross(first.normal).abs() < SAME {
            return None;
        }
        let shape = &self.world.bodies[body].shape;
        (0..shape.faces()).find(|&f| turns[body].apply(shape.face_normal(f)).dot(first.normal) < -SAME)
    }

    /// Moves through one smooth piece and resolves the event that ends it.
    ///
    /// # Errors
    /// [`MotionError`]: a fault of the numbers.
    pub(super) fn advance_all(&mut self, observers: &mut Observers<'_, B>) -> Result<Happening, MotionError> {
        if let Some(ended) = self.ended {
            return Ok(ended);
        }
        if self.effort.events >= self.options.most_events || self.time >= self.options.most_time {
            return Ok(Happening::BudgetSpent);
        }
        if !self.begun {
            self.begun = true;
            let pairs = self.touching(0.0);
            let happening = self.collide(&pairs, observers)?;
            if happening != Happening::Moves {
                self.ended = Some(happening);
                return Ok(happening);
            }
        }
        self.effort.events += 1;
        self.note_sides();
        if self.rests() {
            for state in &mut self.states {
                state.twist = Twist::default();
            }
            self.report_start(observers);
            self.report_piece(self.time, &self.states, |_| PieceEnd::Rests, observers);
            self.ended = Some(Happening::Rests);
            return Ok(Happening::Rests);
        }
        let before = self.time;
        let happening = if self.held.is_empty() { self.fly(observers)? } else { self.glide(observers)? };
        let stalls = self.time - before <= 1e-13 * self.scales.time;
        self.stalls = if stalls { self.stalls + 1 } else { 0 };
        if !self.states.iter().all(State::is_finite) {
            return Err(MotionError::NotFinite { time: self.time });
        }
        if happening != Happening::Moves {
            self.ended = Some(happening);
        }
        Ok(happening)
    }

    /// The pairs in touch; where a face is parallel to an obstacle up to `sine`, those it touches with.
    pub(super) fn touching(&self, sine: f64) -> Few<Pairing> {
        let reach = TOUCHES.max(4.0 * sine) * self.scales.length;
        self.world.touching(
            (&self.states, &self.turns()),
            &Search { reach, sides: &self.sides, still: STILL * self.scales.speed, except: None },
        )
    }

    /// True where every velocity and acceleration of the present mode is rounding.
    fn rests(&mut self) -> bool {
        if self.held.is_empty() {
            return false;
        }
        let (still, l) = (STILL * self.scales.speed, self.scales.length);
        if self.states.iter().any(|s| s.twist.velocity.norm() > still || s.twist.spin.abs() * l > still) {
            return false;
        }
        self.effort.evaluations += 1;
        let accelerations = self.world.forces(&self.held, &self.states).acceleration;
        let g = 1e-9 * self.world.gravity.norm();
        let fixed = self.fixed();
        (0..self.world.bodies.len()).all(|b| {
            let a = accelerations[b];
            fixed[b] || (a.linear.norm() <= g && a.angular.abs() * l <= g)
        })
    }

    /// Asks the rate problem for these touching contacts and enters the mode it answers with.
    pub(super) fn settle(
        &mut self,
        asked: &Few<Asked>,
        observers: &mut Observers<'_, B>,
    ) -> Result<Happening, MotionError> {
        let distinct;
        let asked = if B == 1 {
            asked
        } else {
            distinct = self.distinct_asked(asked);
            &distinct
        };
        self.effort.rate_problems += 1;
        let Some(settled) = self.world.ask((&self.states, &self.turns()), asked) else {
            return self.force(asked, observers);
        };
        self.forced = 0;
        // Where an event has just decided what a contact does, its inequality is zero by definition.
        if asked.iter().all(|a| a.known.is_none()) {
            self.note_margin(settled.margin, MarginOf::Rate);
        }
        self.held = settled.held;
        for pair in settled.opening.iter() {
            self.depart(*pair);
        }
        let (held, departing) = (&self.held, &mut self.departing);
        departing.retain(|pair| !held.iter().any(|h| h.pair == *pair));
        // The forces of a contact must do no work on what velocity rounding has left along it.
        self.states = self.projected(&self.states);
        self.hold_still();
        Ok(Happening::Moves)
    }

    /// Notes a pair that opens: it is looked at again once it has left zero.
    pub(super) fn depart(&mut self, pair: Pairing) {
        if !self.departing.iter().any(|d| *d == pair) {
            self.departing.push(pair);
        }
    }

    pub(super) fn note_margin(&mut self, value: f64, of: MarginOf) {
        // Contacts of one face do the same: which of them is said to hold is no decision.
        if value < self.margin.value && value.abs() > TIE {
            self.margin = Margin { value, of, time: self.time };
        }
    }

    /// Two contacts that stick fix a body: what velocity is left is rounding.
    fn hold_still(&mut self) {
        if self.held.iter().filter(|h| h.slip == Slip::Sticks).count() < 2 {
            return;
        }
        let fixed = self.fixed();
        for (state, fixed) in self.states.iter_mut().zip(fixed) {
            if fixed {
                state.twist = Twist { velocity: Vec2::ZERO, spin: 0.0 };
            }
        }
    }

    /// Which bodies two contacts fix that stick at two different points, on obstacles or on bodies that are fixed.
    fn fixed(&self) -> [bool; B] {
        let turns = self.turns();
        let mut fixed = [false; B];
        for _ in 0..B {
            let known = fixed;
            for (body, fixed) in fixed.iter_mut().enumerate() {
                let arms = self.held.iter().filter(|h| h.slip == Slip::Sticks).filter_map(|h| {
                    let k = self.world.kinematics_turned(&self.states, &turns, h.pair);
                    let other = self.world.other_body(h.pair);
                    if h.pair.body == body {
                        other.is_none_or(|b| known[b]).then_some(k.arm)
                    } else {
                        (other == Some(body) && known[h.pair.body]).then_some(k.other_arm)
                    }
                });
                let mut first = None;
                for arm in arms {
                    let one = *first.get_or_insert(arm);
                    *fixed |= (arm - one).norm() > 1e-9 * self.scales.length;
                }
            }
        }
        fixed
    }

    /// The contacts of the present mode, as the rate problem is asked about them.
    pub(super) fn asked(&self) -> Few<Asked> {
        let turns = self.turns();
        let mut out = Few::default();
        for h in self.held.iter() {
            let k = self.world.kinematics_turned(&self.states, &turns, h.pair);
            let slip = if h.slip == Slip::Sticks || k.slip.abs() <= STILL * self.scales.speed {
                0.0
            } else {
                k.slip
            };
            out.push(Asked { pair: h.pair, slip, known: None, present: h.slip });
        }
        out
    }
}
