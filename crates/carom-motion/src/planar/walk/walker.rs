//! The walk in time through modes: solve the rate problem, move until an event, resolve what it brings, ask again.

use super::accumulation::Recent;
use super::path::Leg;
use super::rocking::Rocking;
use super::terms::{Effort, Happening, Margin, MarginOf, Options};
use crate::MotionError;
use crate::evaluated::{unless_lost, watched};
use crate::planar::contact::{
    World,
    kinematics::{Kinematics, Pairing, Turn, Turned},
    touching::Few,
    world::Scales,
};
use crate::planar::geometry::{State, Twist};
use crate::planar::modes::{mode::Held, question::Asked};
use crate::planar::record::{
    observer::{Observer, Observers},
    trace::{HeldContact, PieceEnd},
};
use crate::tolerance::{MARGIN_TIE, SAME_INSTANT};
use std::borrow::Cow;

/// A body on its way, or `B` that touch each other.
///
/// # Example
/// A ball falls 0.2 m to a floor at g = 10 m/s²: it strikes after 0.2 s with 2 m/s and, with e = 1/2, leaves
/// with 1 m/s.
/// ```
/// use carom_impact::Law;
/// use carom_motion::planar::{Body, Happening, Obstacle, Options, Pose, Shape, State, Twist, Walker, World};
/// use carom_num::Vec2;
/// let ball = Body { shape: Shape::new(vec![Vec2::ZERO], 0.1).unwrap(), mass: 1.0, inertia: 0.005 };
/// let floor = Obstacle::new(Vec2::new(-1.0, 0.0), Vec2::new(9.0, 0.0), 0.3, 0.5);
/// let world = World::of_one(Vec2::new(0.0, -10.0), ball, vec![floor], Law::Poisson);
/// let start = State { pose: Pose { centre: Vec2::new(0.0, 0.3), angle: 0.0 }, twist: Twist::default() };
/// let mut walker = Walker::new(&world, start, vec![], Options::default())?;
/// assert_eq!(walker.advance(&mut ())?, Happening::Moves);
/// assert!((walker.time() - 0.2).abs() < 1e-12);
/// assert!((walker.state().twist.velocity.y - 1.0).abs() < 1e-12);
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Walker<'w, const B: usize = 1> {
    pub(in crate::planar) world: Cow<'w, World>,
    /// The numbers of the bodies for those who look on.
    pub(in crate::planar) names: [usize; B],
    pub(in crate::planar) scales: Scales,
    pub(in crate::planar) options: Options,
    pub(in crate::planar) time: f64,
    /// Of each body; those beyond the world's bodies are not used.
    pub(in crate::planar) states: [State; B],
    pub(in crate::planar) held: Few<Held>,
    /// Pairs that have just opened.
    pub(in crate::planar) departing: Few<Pairing>,
    pub(in crate::planar) sides: Vec<bool>,
    pub(in crate::planar) recent: Recent,
    pub(in crate::planar) rocking: Rocking,
    /// No other body is about.
    pub(super) alone: bool,
    pub(in crate::planar) effort: Effort,
    pub(in crate::planar) margin: Margin,
    /// Impacts without approach in a row at this instant.
    pub(in crate::planar) forced: u32,
    /// Events in a row that time does not part.
    pub(in crate::planar) stalls: u32,
    pub(in crate::planar) ended: Option<Happening>,
    /// Where the present piece leads, for those who want to know.
    pub(in crate::planar) path: Option<Vec<Leg<B>>>,
    /// The contacts of the start have been asked what they do.
    pub(in crate::planar) begun: bool,
    /// A swing that nothing ends is the end of the walk.
    pub(super) ends_at_swings: bool,
    /// How often in a row a body that swings has turned round.
    pub(super) turning_points: u32,
    pub(in crate::planar) turned: Turned<B>,
    /// A number was lost on the way.
    lost: bool,
}

impl<'w> Walker<'w> {
    /// A body that starts in `state`. The first advance asks what its contacts there do. `sides` tells for each obstacle on which side of it a rod
    /// lies that is in line with it: true for the left side of the obstacle's direction.
    ///
    /// # Errors
    /// [`MotionError::NotFinite`] where the state is not finite, [`MotionError::BothThin`] where a rod without thickness could meet a bent obstacle without one.
    pub fn new(
        world: &'w World,
        state: State,
        sides: Vec<bool>,
        options: Options,
    ) -> Result<Self, MotionError> {
        Ok(Self { alone: true, ..Self::of_states(Cow::Borrowed(world), [0], [state], sides, options)? })
    }

    /// The same walk, which [ends](Happening::Swings) once the body swings to and fro without loss and nothing is left that could end it: such
    /// a swing would use up the whole budget of time.
    #[must_use]
    pub fn ending_at_swings(self) -> Self {
        Self { ends_at_swings: true, ..self }
    }

    /// Pose and velocity.
    pub fn state(&self) -> &State {
        &self.states[0]
    }

    /// The contacts held at present.
    ///
    /// # Example
    /// A block that lies on a floor is held at two corners.
    /// ```
    /// use carom_impact::planar::Slip;
    /// use carom_motion::planar::{Options, Walker, examples};
    /// use carom_num::Vec2;
    /// let (world, start) = examples::lying_block(Vec2::new(0.0, -10.0), 0.3);
    /// let mut walker = Walker::new(&world, start, vec![], Options::default())?;
    /// walker.advance(&mut ())?;
    /// assert_eq!(walker.held().map(|h| h.slip).collect::<Vec<_>>(), [Slip::Sticks, Slip::Sticks]);
    /// # Ok::<(), carom_motion::MotionError>(())
    /// ```
    pub fn held(&self) -> impl Iterator<Item = HeldContact> + '_ {
        self.held_of(0)
    }

    /// The face of the body that lies on an obstacle, by its number among [`Shape::rests`](crate::planar::Shape::rests), kept there by a second contact on it
    /// or on one in line with it.
    ///
    /// # Example
    /// Face 0 of a block, from its first corner to its second, lies on the floor.
    /// ```
    /// use carom_motion::planar::{Options, Walker, examples};
    /// use carom_num::Vec2;
    /// let (world, start) = examples::lying_block(Vec2::new(0.0, -10.0), 0.3);
    /// let mut walker = Walker::new(&world, start, vec![], Options::default())?;
    /// walker.advance(&mut ())?;
    /// assert_eq!(walker.flat_on(0), Some(0));
    /// # Ok::<(), carom_motion::MotionError>(())
    /// ```
    pub fn flat_on(&self, obstacle: usize) -> Option<usize> {
        self.lies_flat(0, obstacle)
    }

    /// Moves through one smooth piece and resolves the event that ends it.
    ///
    /// # Errors
    /// [`MotionError`]: a fault of the numbers.
    ///
    /// # Example
    /// A ball with e = 1/2 falls for 0.2 s and is then in the air for 0.2 s, 0.1 s, …
    /// ```
    /// use carom_motion::planar::{Happening, Options, Walker, examples};
    /// let (world, start) = examples::falling_ball();
    /// let mut walker = Walker::new(&world, start, vec![], Options::default())?;
    /// for time in [0.2, 0.4, 0.5] {
    ///     assert_eq!(walker.advance(&mut ())?, Happening::Moves);
    ///     assert!((walker.time() - time).abs() < 1e-12);
    /// }
    /// # Ok::<(), carom_motion::MotionError>(())
    /// ```
    pub fn advance(&mut self, observer: &mut dyn Observer) -> Result<Happening, MotionError> {
        let time = self.time;
        unless_lost(self, |w| &mut w.lost, time, |w| w.advance_all(&mut [Some(observer)]))
    }
}

impl<'w, const B: usize> Walker<'w, B> {
    /// Bodies that start in these states.
    pub(in crate::planar) fn of_states(
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
            rocking: Rocking::default(),
            alone: false,
            effort: Effort::default(),
            margin: Margin { value: f64::INFINITY, of: MarginOf::Nothing, time: 0.0 },
            forced: 0,
            stalls: 0,
            ended: None,
            path: None,
            begun: false,
            ends_at_swings: false,
            turning_points: 0,
            turned: Turned::default(),
            lost: false,
        };
        walker.sides.resize(pairs, true);
        if !states.iter().all(State::is_finite) {
            return Err(MotionError::NotFinite { time: 0.0 });
        }
        if let Some((body, obstacle)) = walker.world.both_thin() {
            return Err(MotionError::BothThin { body: names[body], obstacle });
        }
        // Finite places may still be so far off that a distance between them is not finite.
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

    /// Moves through one smooth piece and resolves the event that ends it.
    ///
    /// # Errors
    /// [`MotionError`]: a fault of the numbers.
    pub(in crate::planar) fn advance_all(
        &mut self,
        observers: &mut Observers<'_, B>,
    ) -> Result<Happening, MotionError> {
        if let Some(ended) = self.ended {
            return Ok(ended);
        }
        if self.effort.events >= self.options.most_events || self.time >= self.options.most_time {
            return Ok(Happening::BudgetSpent);
        }
        if !self.begun {
            self.begun = true;
            // The rate problem supposes that nothing approaches: what touches at the start goes through an impact first.
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
            // What velocity is left is rounding. It is taken away, so that a body at rest does not creep through the time that follows.
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
        let stalls = self.time - before <= SAME_INSTANT * self.scales.time;
        self.stalls = if stalls { self.stalls + 1 } else { 0 };
        if !self.states.iter().all(State::is_finite) {
            return Err(MotionError::NotFinite { time: self.time });
        }
        if happening != Happening::Moves {
            self.ended = Some(happening);
        }
        Ok(happening)
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
        if value < self.margin.value && value.abs() > MARGIN_TIE {
            self.margin = Margin { value, of, time: self.time };
        }
    }
}
