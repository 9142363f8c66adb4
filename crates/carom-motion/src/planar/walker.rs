//! The walk in time through modes: solve the rate problem, move until an event, resolve what it brings, ask again.

use super::accumulation::Recent;
use super::events::Look;
use super::kinematics::{Kinematics, Pairing, Turn};
use super::mode::{Forces, Held};
use super::observer::{Observer, PieceFacts};
use super::question::Asked;
use super::terms::{Effort, Happening, Margin, MarginOf, MotionError, Options};
use super::touching::{Few, Search};
use super::trace::{HeldContact, PieceEnd};
use super::world::Scales;
use super::{Feature, State, Twist, World};
use carom_impact::planar::Slip;
use carom_num::Vec2;

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
    /// The forces at the end of the step that is being examined.
    pub(super) end_forces: Option<Forces>,
    /// Impacts without approach in a row at this instant.
    pub(super) forced: u32,
    /// Events in a row that time does not part.
    pub(super) stalls: u32,
    pub(super) ended: Option<Happening>,
    /// The contacts of the start have been asked what they do.
    begun: bool,
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
            end_forces: None,
            forced: 0,
            stalls: 0,
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

    /// The face of the body that lies on an obstacle, kept there by a second contact on it or on one in line with it.
    pub fn flat_on(&self, obstacle: usize) -> Option<usize> {
        let turn = Turn::of(&self.state);
        let of = |h: &Held| self.world.kinematics_turned(&self.state, turn, h.pair);
        let first = of(self.held.iter().find(|h| h.pair.obstacle == obstacle)?);
        let beside = |k: Kinematics| {
            let apart = (k.arm - first.arm).dot(first.tangent()).abs();
            k.normal.dot(first.normal) > SAME && apart > 1e-9 * self.scales.length
        };
        let along = self.world.obstacles[obstacle].direction();
        if !self.held.iter().any(|h| beside(of(h))) || along.cross(first.normal).abs() < SAME {
            return None;
        }
        let shape = &self.world.body.shape;
        (0..shape.faces()).find(|&f| turn.apply(shape.face_normal(f)).dot(first.normal) < -SAME)
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
        let before = self.time;
        let happening = if self.held.is_empty() { self.fly(observer)? } else { self.glide(observer)? };
        let stalls = self.time - before <= 1e-13 * self.scales.time;
        self.stalls = if stalls { self.stalls + 1 } else { 0 };
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
            let off = o.direction().turned_left().dot(self.state.pose.centre - o.from());
            if off.abs() > 1e-9 * self.scales.length {
                *side = off > 0.0;
            }
        }
        let turn = Turn::of(&self.state);
        for h in self.held.iter() {
            let along = self.world.obstacles[h.pair.obstacle].direction();
            match h.pair.feature {
                Feature::VertexOnFace { left, .. } => self.sides[h.pair.obstacle] = left,
                // The part of a rod that turns towards the obstacle counts, not its centre beyond the end.
                Feature::FaceOnEnd { face, .. } => {
                    let outward = turn.apply(self.world.body.shape.face_normal(face));
                    self.sides[h.pair.obstacle] = along.turned_left().dot(outward) < 0.0;
                }
                Feature::VertexOnEnd { .. } => {}
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
