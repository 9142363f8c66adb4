//! Several bodies on their way: each for itself until it meets another, together while they touch.
//!
//! Every island of bodies that hold each other is looked at one smooth piece ahead. The piece that ends first counts, unless two islands meet
//! before: then both are taken to that time, resolve what happens as one island, and fall apart again where nothing holds them together.
//! So a body that meets no other moves, to the last bit, as if it were alone.

use super::encounter::Encounter;
use super::flight::MET;
use super::island::{Ahead, Island};
use super::kinematics::Pairing;
use super::meeting::Approach;
use super::observer::Observer;
use super::terms::{Effort, Happening, Margin, MotionError, Options};
use super::trace::HeldContact;
use super::world::Scales;
use super::{State, World};
use crate::evaluated::unless_lost;

/// Bodies of a world on their way.
///
/// # Limits
/// Four bodies and twelve contacts may be together at once.
///
/// # Example
/// A ball of 1 kg meets one of 3 kg at rest, head on and with e = 1/2.
/// ```
/// use carom_impact::planar::Law;
/// use carom_motion::planar::{Body, Crowd, Options, Pose, Shape, State, Surface, Twist, World};
/// use carom_num::Vec2;
/// let ball = |mass: f64| -> Body {
///     Body { shape: Shape::new(vec![Vec2::ZERO], 0.1).unwrap(), mass, inertia: 0.005 * mass }
/// };
/// let world = World {
///     gravity: Vec2::ZERO,
///     bodies: vec![ball(1.0), ball(3.0)],
///     obstacles: vec![],
///     between: Surface { friction: 0.2, restitution: 0.5 },
///     law: Law::Poisson,
/// };
/// let at = |x: f64, speed: f64| State {
///     pose: Pose { centre: Vec2::new(x, 0.0), angle: 0.0 },
///     twist: Twist { velocity: Vec2::new(speed, 0.0), spin: 0.0 },
/// };
/// let mut crowd = Crowd::new(&world, Options::default());
/// crowd.enter(0, at(0.0, 2.0), vec![])?;
/// crowd.enter(1, at(1.2, 0.0), vec![])?;
/// let mut nobody = [(), ()];
/// let met = crowd.advance(10.0, &mut nobody)?;
/// assert_eq!((met.bodies, crowd.time()), (vec![0, 1], 0.5));
/// let speed = |body| crowd.member(body).map(|m| m.state().twist.velocity.x);
/// assert_eq!((speed(0), speed(1)), (Some(-0.25), Some(0.75)));
/// # Ok::<(), carom_motion::planar::MotionError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Crowd<'w> {
    pub(super) world: &'w World,
    pub(super) scales: Scales,
    options: Options,
    pub(super) time: f64,
    events: u64,
    pub(super) islands: Vec<Island<'w>>,
    pub(super) ahead: Vec<Option<Ahead>>,
    /// Bodies that have parted at the present time.
    pub(super) parting: Vec<(usize, usize)>,
    /// Events in a row that time does not part.
    pub(super) stalls: u32,
    /// Bodies that have just entered.
    arriving: Vec<usize>,
    /// A number was lost on the way.
    lost: bool,
}

/// What an advance of a crowd brought.
#[derive(Clone, Debug, PartialEq)]
pub struct Advance {
    /// The bodies that it concerns; none where the time asked for came first.
    pub bodies: Vec<usize>,
    /// What it brought for them.
    pub happening: Happening,
}

/// Events in a row at one instant after which a crowd is given up.
const MOST_AT_ONCE: u32 = 400;

impl<'w> Crowd<'w> {
    /// A crowd without bodies.
    pub fn new(world: &'w World, options: Options) -> Self {
        let scales = world.scales();
        Self {
            world,
            scales,
            options,
            time: 0.0,
            events: 0,
            islands: vec![],
            ahead: vec![],
            parting: vec![],
            stalls: 0,
            arriving: vec![],
            lost: false,
        }
    }

    /// Time up to which everything is known [s].
    pub fn time(&self) -> f64 {
        self.time
    }

    /// One of the world's bodies starts in `state` now; `sides` as for [`Walker::new`](super::Walker::new).
    ///
    /// # Errors
    /// [`MotionError::NotFinite`] where the state is not finite.
    pub fn enter(&mut self, body: usize, state: State, sides: Vec<bool>) -> Result<(), MotionError> {
        self.islands.push(Island::of_one(self.world, body, state, sides, (self.time, self.options))?);
        self.ahead.push(None);
        self.arriving.push(body);
        Ok(())
    }

    /// Takes a body out, where it touches no other; else it stays.
    pub fn leave(&mut self, body: usize) {
        if let Some(i) = self.islands.iter().position(|i| i.members == [body]) {
            self.islands.remove(i);
            self.ahead.remove(i);
        }
    }

    /// The bodies on their way.
    pub fn bodies(&self) -> impl Iterator<Item = usize> + '_ {
        self.islands.iter().flat_map(|i| i.members.iter().copied())
    }

    pub(super) fn island_of(&self, body: usize) -> Option<(&Island<'w>, usize)> {
        self.islands.iter().find_map(|i| Some((i, i.place_of(body)?)))
    }

    /// What is known of a body on its way.
    pub fn member(&self, body: usize) -> Option<Member<'_>> {
        self.island_of(body).map(|(island, place)| Member { island, place })
    }

    /// True where a body in this state would overlap none that is on its way.
    ///
    /// # Errors
    /// [`MotionError`]: a fault of the numbers, in looking ahead.
    pub fn has_room(&mut self, body: usize, state: &State) -> Result<bool, MotionError> {
        self.watching(|crowd| {
            crowd.look_ahead()?;
            let mut others = crowd.bodies().filter(|b| *b != body);
            Ok(others.all(|other| {
                let pair = crowd.world.of_some(&[body, other]);
                let here = crowd.state_at(other, crowd.time);
                let approach =
                    Approach { world: &pair, scales: crowd.scales, at: |_| [*state, here], parting: false };
                approach.distance(crowd.time) > -MET * crowd.scales.length
            }))
        })
    }

    /// Moves on to the next event of any body, or to `until`.
    ///
    /// # Errors
    /// [`MotionError`]: a fault of the numbers, or more bodies and contacts together than are walked.
    pub fn advance<O: Observer>(&mut self, until: f64, observers: &mut [O]) -> Result<Advance, MotionError> {
        let observers = &mut seen_by(observers);
        self.watching(|crowd| crowd.advance_to(until, observers))
    }

    /// Does something, unless numbers have been lost.
    fn watching<R>(
        &mut self,
        work: impl FnOnce(&mut Self) -> Result<R, MotionError>,
    ) -> Result<R, MotionError> {
        let time = self.time;
        unless_lost(self, |crowd| &mut crowd.lost, time, work)
    }

    fn advance_to(
        &mut self,
        until: f64,
        observers: &mut [&mut dyn Observer],
    ) -> Result<Advance, MotionError> {
        self.look_ahead()?;
        while let Some(body) = self.arriving.pop() {
            if let Some(advance) = self.arrive(body, observers)? {
                return Ok(advance);
            }
        }
        let ends = self.ahead.iter().map(|a| a.as_ref().map_or(f64::INFINITY, |a| a.end));
        let first = ends.enumerate().min_by(|a, b| a.1.total_cmp(&b.1));
        let end = first.map_or(until, |(_, end)| end.min(until));
        let spent = self.events >= self.options.most_events || self.stalls >= MOST_AT_ONCE;
        if spent || end >= self.options.most_time {
            return Ok(Advance { bodies: self.bodies().collect(), happening: Happening::BudgetSpent });
        }
        self.events += 1;
        if end.is_finite()
            && let Some(encounter) = self.first_encounter(end)
        {
            return self.meet(&encounter, observers);
        }
        let Some((island, _)) = first.filter(|(_, e)| *e <= until && e.is_finite()) else {
            self.move_on(until);
            return self.nothing();
        };
        let mut moved = self.islands.remove(island);
        self.ahead.remove(island);
        let happening = moved.advance(observers)?;
        self.move_on(end);
        self.part(moved, happening)
    }

    /// Takes every body to the present time, in the midst of its piece: whoever looks on is told of the part of it that is over.
    ///
    /// # Errors
    /// [`MotionError`]: a fault of the numbers.
    pub fn pause<O: Observer>(&mut self, observers: &mut [O]) -> Result<(), MotionError> {
        let observers = &mut seen_by(observers);
        self.watching(|crowd| {
            for (island, ahead) in crowd.islands.iter_mut().zip(&mut crowd.ahead) {
                island.advance_to(crowd.time, observers)?;
                *ahead = None;
            }
            Ok(())
        })
    }

    /// Asks what a body that has just entered does with those it touches, where it touches any.
    fn arrive(
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

    fn look_ahead(&mut self) -> Result<(), MotionError> {
        for (island, ahead) in self.islands.iter().zip(&mut self.ahead) {
            if ahead.is_none() {
                *ahead = Some(island.ahead()?);
            }
        }
        Ok(())
    }

    /// Where a body is at a time that is known and not before the last event, to the accuracy of the dense output; rest at the origin for a
    /// body that is not on its way.
    pub fn state_at(&self, body: usize, time: f64) -> State {
        let found = self.islands.iter().zip(&self.ahead).find_map(|(island, ahead)| {
            let place = island.place_of(body)?;
            Some(ahead.as_ref().map_or_else(|| *island.state(place), |a| a.state(place, time)))
        });
        found.unwrap_or_default()
    }

    /// Takes the islands of two bodies to where they meet, and resolves what happens there.
    fn meet(
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

    /// Takes islands to a time and resolves, as of one, what happens where they touch and with this pair.
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

    /// Notes that everything is known up to a time.
    fn move_on(&mut self, time: f64) {
        if time - self.time > 1e-13 * self.scales.time {
            self.parting.clear();
            self.stalls = 0;
        } else {
            self.stalls += 1;
        }
        self.time = self.time.max(time);
    }

    fn nothing(&self) -> Result<Advance, MotionError> {
        Ok(Advance { bodies: vec![], happening: Happening::Moves })
    }

    /// Lets an island fall apart where nothing holds it together, and says what has happened.
    fn part(&mut self, whole: Island<'w>, happening: Happening) -> Result<Advance, MotionError> {
        let bodies = whole.members.clone();
        let (islands, parted) = whole.parted(self.world)?;
        let obstacles = self.world.obstacles.len();
        self.parting.extend(parted.iter().map(|p| (p.body, p.obstacle - obstacles)));
        for part in islands {
            self.islands.push(part);
            self.ahead.push(None);
        }
        Ok(Advance { bodies, happening })
    }
}

/// Those who look on, whatever they are.
fn seen_by<O: Observer>(observers: &mut [O]) -> Vec<&mut dyn Observer> {
    observers.iter_mut().map(|observer| observer as &mut dyn Observer).collect()
}

/// What is known of a body on its way.
#[derive(Clone, Copy, Debug)]
pub struct Member<'c> {
    island: &'c Island<'c>,
    place: usize,
}

impl Member<'_> {
    /// Time up to which the body was moved [s].
    pub fn time(&self) -> f64 {
        self.island.time()
    }

    /// Pose and velocity.
    pub fn state(&self) -> &State {
        self.island.state(self.place)
    }

    /// The contacts held at present.
    pub fn held(&self) -> Vec<HeldContact> {
        self.island.held(self.place)
    }

    /// The face that lies on an obstacle, as [`Walker::flat_on`](super::Walker::flat_on).
    pub fn flat_on(&self, obstacle: usize) -> Option<usize> {
        self.island.flat_on(self.place, obstacle)
    }

    /// Counts of the work done for it and for those it met.
    pub fn effort(&self) -> Effort {
        self.island.effort()
    }

    /// How certain its way is so far.
    pub fn margin(&self) -> Margin {
        self.island.margin()
    }

    /// How its way has ended, where it has.
    pub fn ended(&self) -> Option<Happening> {
        self.island.ended()
    }
}
