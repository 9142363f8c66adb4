//! The walk in time through modes: solve the rate problem, move until an event, resolve what it brings, ask again.

use super::accumulation::Recent;
use super::events::Look;
use super::kinematics::{Pairing, Turn};
use super::mode::Held;
use super::observer::{Observer, PieceFacts};
use super::question::Asked;
use super::touching::{Few, Search};
use super::trace::{HeldContact, PieceEnd};
use super::world::Scales;
use super::{Feature, State, Twist, World};
use carom_impact::planar::{ImpactError, Slip};
use carom_num::Vec2;
use thiserror::Error;

/// How exactly and how long to walk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Relative tolerance of the integration.
    pub tolerance: f64,
    /// Simulated time after which the walk stops [s].
    pub most_time: f64,
    /// Events after which the walk stops.
    pub most_events: u64,
}

impl Default for Options {
    fn default() -> Self {
        Self { tolerance: 1e-11, most_time: 600.0, most_events: 20_000 }
    }
}

/// Counts of the work done: the same for the same input, on any machine.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effort {
    /// Evaluations of a mode's forces and accelerations.
    pub evaluations: u64,
    /// Steps of the integration.
    pub steps: u64,
    /// Events.
    pub events: u64,
    /// Impacts.
    pub impacts: u64,
}

/// How certain the walk is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Margin {
    /// Smallest decided inequality divided by the sum of its terms' magnitudes.
    pub value: f64,
    /// What it was about.
    pub of: MarginOf,
    /// When [s].
    pub time: f64,
}

/// What a margin is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MarginOf {
    /// Nothing was decided yet.
    Nothing,
    /// Which contacts hold, stick or slip in motion.
    Rate,
    /// The course of an impact.
    Impact,
}

/// What one advance of the walk brought.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Happening {
    /// It goes on.
    Moves,
    /// Nothing moves any more and nothing will.
    Rests,
    /// It flies and can meet nothing any more.
    FliesAway,
    /// No impact resolves its contacts.
    Jams,
    /// The budget of time or events is used up.
    BudgetSpent,
}

/// Why a walk cannot go on: a fault of the numbers, not of the physics.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum MotionError {
    /// A number that is not finite appeared.
    #[error("the motion is not finite at t = {time} s")]
    NotFinite {
        /// When [s].
        time: f64,
    },
    /// The integration needs steps below rounding.
    #[error("the integration needs a step of {step} s at t = {time} s")]
    StepTooSmall {
        /// When [s].
        time: f64,
        /// The step [s].
        step: f64,
    },
    /// The impact kernel refused: more contacts at once than fit, or no end of its stages.
    #[error("at t = {time} s: {error}")]
    Impact {
        /// When [s].
        time: f64,
        /// What the impact said.
        error: ImpactError,
    },
}

/// A body on its way.
#[derive(Clone, Debug)]
pub struct Walker<'w> {
    pub(super) world: &'w World,
    pub(super) scales: Scales,
    pub(super) options: Options,
    pub(super) time: f64,
    pub(super) state: State,
    pub(super) held: Few<Held>,
    /// Pairs that have just opened.
    pub(super) departing: Few<Pairing>,
    pub(super) sides: Vec<bool>,
    pub(super) recent: Recent,
    pub(super) effort: Effort,
    pub(super) margin: Margin,
    /// The event functions at the end of the last step, while the mode lasts.
    pub(super) last_look: Option<Look>,
    /// Impacts without approach in a row at this instant.
    pub(super) forced: u32,
    pub(super) ended: Option<Happening>,
    /// The contacts of the start have been asked what they do.
    begun: bool,
}

/// Velocities below this fraction of the world's speed are rounding.
pub(super) const STILL: f64 = 1e-9;
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
        let mut walker = Self {
            world,
            scales: world.scales(),
            options,
            time: 0.0,
            state,
            held: Few::default(),
            departing: Few::default(),
            sides,
            recent: Recent::default(),
            effort: Effort::default(),
            margin: Margin { value: f64::INFINITY, of: MarginOf::Nothing, time: 0.0 },
            last_look: None,
            forced: 0,
            ended: None,
            begun: false,
        };
        walker.sides.resize(world.obstacles.len(), true);
        if !state.is_finite() {
            return Err(MotionError::NotFinite { time: 0.0 });
        }
        walker.note_sides();
        Ok(walker)
    }

    /// Time [s].
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Pose and velocity.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Counts of the work done so far.
    pub fn effort(&self) -> Effort {
        self.effort
    }

    /// How certain the walk is so far.
    pub fn margin(&self) -> Margin {
        self.margin
    }

    /// The contacts held at present.
    pub fn held(&self) -> impl Iterator<Item = HeldContact> + '_ {
        self.held.iter().map(|h| HeldContact {
            obstacle: h.pair.obstacle,
            feature: h.pair.feature,
            slip: h.slip,
        })
    }

    /// The face of the body that lies on an obstacle, held there by two contacts.
    pub fn flat_on(&self, obstacle: usize) -> Option<usize> {
        let turn = Turn::of(&self.state);
        let mut here = self.held.iter().filter(|h| h.pair.obstacle == obstacle);
        let first = here.next()?;
        here.next()?;
        let normal = self.world.kinematics_turned(&self.state, turn, first.pair).normal;
        let shape = &self.world.body.shape;
        (0..shape.faces()).find(|&f| turn.apply(shape.face_normal(f)).dot(normal) < -1.0 + 1e-12)
    }

    /// Moves through one smooth piece and resolves the event that ends it.
    ///
    /// # Errors
    /// [`MotionError`]: a fault of the numbers.
    pub fn advance<O: Observer>(&mut self, observer: &mut O) -> Result<Happening, MotionError> {
        if let Some(ended) = self.ended {
            return Ok(ended);
        }
        if self.effort.events >= self.options.most_events || self.time >= self.options.most_time {
            return Ok(Happening::BudgetSpent);
        }
        if !self.begun {
            self.begun = true;
            let pairs = self.touching(0.0);
            let happening = self.collide(&pairs, observer)?;
            if happening != Happening::Moves {
                self.ended = Some(happening);
                return Ok(happening);
            }
        }
        self.effort.events += 1;
        self.note_sides();
        if self.rests() {
            self.state.twist = Twist::default();
            observer.starts(self.time, &self.state, &mut self.held());
            self.report_piece(self.time, self.state, PieceEnd::Rests, observer);
            self.ended = Some(Happening::Rests);
            return Ok(Happening::Rests);
        }
        let happening = if self.held.is_empty() { self.fly(observer)? } else { self.glide(observer)? };
        if !self.state.is_finite() {
            return Err(MotionError::NotFinite { time: self.time });
        }
        if happening != Happening::Moves {
            self.ended = Some(happening);
        }
        Ok(happening)
    }

    pub(super) fn report_piece<O: Observer>(
        &self,
        start_time: f64,
        start: State,
        ended_by: PieceEnd,
        observer: &mut O,
    ) {
        observer.piece(&PieceFacts { start_time, end_time: self.time, start, end: self.state, ended_by });
    }

    /// The pairs in touch; where a face is parallel to an obstacle up to `sine`, those it touches with.
    pub(super) fn touching(&self, sine: f64) -> Few<Pairing> {
        let reach = TOUCHES.max(4.0 * sine) * self.scales.length;
        self.world.touching(
            &self.state,
            &Search { reach, sides: &self.sides, still: STILL * self.scales.speed, except: None },
        )
    }

    /// Remembers on which side of each obstacle the body is, where that can be told.
    pub(super) fn note_sides(&mut self) {
        for (side, o) in self.sides.iter_mut().zip(&self.world.obstacles) {
            let off = o.direction().turned_left().dot(self.state.pose.centre - o.from);
            if off.abs() > 1e-9 * self.scales.length {
                *side = off > 0.0;
            }
        }
        for h in self.held.iter() {
            if let Feature::VertexOnFace { left, .. } = h.pair.feature {
                self.sides[h.pair.obstacle] = left;
            }
        }
    }

    /// True where every velocity and acceleration of the present mode is rounding.
    fn rests(&mut self) -> bool {
        if self.held.is_empty() {
            return false;
        }
        let (v, w) = (self.state.twist.velocity.norm(), self.state.twist.spin.abs() * self.scales.length);
        let still = STILL * self.scales.speed;
        if v > still || w > still {
            return false;
        }
        self.effort.evaluations += 1;
        let a = self.world.forces(&self.held, &self.state).acceleration;
        let g = 1e-9 * self.world.gravity.norm();
        self.is_fixed() || (a.linear.norm() <= g && a.angular.abs() * self.scales.length <= g)
    }

    /// Asks the rate problem for these touching contacts and enters the mode it answers with.
    pub(super) fn settle<O: Observer>(
        &mut self,
        asked: &Few<Asked>,
        observer: &mut O,
    ) -> Result<Happening, MotionError> {
        let Some(settled) = self.world.ask(&self.state, asked) else {
            return self.force(asked, observer);
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
        let held = self.held;
        self.departing.retain(|pair| !held.iter().any(|h| h.pair == *pair));
        // The forces of a contact must do no work on what velocity rounding has left along it.
        self.state = self.projected(&self.state);
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
        if self.is_fixed() {
            self.state.twist = Twist { velocity: Vec2::ZERO, spin: 0.0 };
        }
    }

    /// True where two contacts stick at two different points.
    fn is_fixed(&self) -> bool {
        let turn = Turn::of(&self.state);
        let arm = |h: &Held| self.world.kinematics_turned(&self.state, turn, h.pair).arm;
        let mut sticking = self.held.iter().filter(|h| h.slip == Slip::Sticks);
        let Some(first) = sticking.next() else { return false };
        sticking.any(|h| (arm(h) - arm(first)).norm() > 1e-9 * self.scales.length)
    }

    /// The contacts of the present mode, as the rate problem is asked about them.
    pub(super) fn asked(&self) -> Few<Asked> {
        let turn = Turn::of(&self.state);
        let mut out = Few::default();
        for h in self.held.iter() {
            let k = self.world.kinematics_turned(&self.state, turn, h.pair);
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
