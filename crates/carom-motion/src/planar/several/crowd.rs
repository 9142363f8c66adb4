//! Several bodies on their way: each for itself until it meets another, together while they touch.
//!
//! Every island of bodies that hold each other is looked at one smooth piece ahead. The piece that ends first counts, unless two islands meet
//! before: then both are taken to that time, resolve what happens as one island, and fall apart again where nothing holds them together.
//! So a body that meets no other moves, to the last bit, as if it were alone.

use super::ahead::Ahead;
use super::island::Island;
use crate::MotionError;
use crate::evaluated::unless_lost;
use crate::planar::contact::{World, world::Scales};
use crate::planar::geometry::State;
use crate::planar::record::observer::Observer;
use crate::planar::walk::terms::{Happening, Options};
use crate::tolerance::SAME_INSTANT;

/// Bodies of a world on their way.
///
/// # Limits
/// Four bodies and twelve contacts may be together at once.
///
/// # Example
/// A ball of 1 kg meets one of 3 kg at rest, head on and with e = 1/2.
/// ```
/// use carom_impact::Law;
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
/// # Ok::<(), carom_motion::MotionError>(())
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
///
/// # Example
/// Where no body meets anything before the time asked for, the advance concerns none.
/// ```
/// use carom_motion::planar::{Crowd, Happening, Options, examples};
/// let (world, at) = (examples::two_balls(), examples::on_the_axis);
/// let mut crowd = Crowd::new(&world, Options::default());
/// crowd.enter(0, at(0.0, 2.0), vec![])?;
/// crowd.enter(1, at(1.2, 0.0), vec![])?;
/// let before = crowd.advance(0.4, &mut [(), ()])?;
/// assert_eq!((before.bodies, before.happening), (vec![], Happening::Moves));
/// let met = crowd.advance(1.0, &mut [(), ()])?;
/// assert_eq!((met.bodies, met.happening), (vec![0, 1], Happening::Moves));
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
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

    /// One of the world's bodies starts in `state` now; `sides` as for [`Walker::new`](crate::planar::Walker::new).
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

    /// Moves on to the next event of any body, or to `until`.
    ///
    /// # Errors
    /// [`MotionError`]: a fault of the numbers, or more bodies and contacts together than are walked.
    ///
    /// # Example
    /// Each advance ends with an event or with the time asked for. The balls part at `e` times the 2 m/s at
    /// which they met.
    /// ```
    /// use carom_motion::planar::{Crowd, Options, examples};
    /// let (world, at) = (examples::two_balls(), examples::on_the_axis);
    /// let mut crowd = Crowd::new(&world, Options::default());
    /// crowd.enter(0, at(0.0, 2.0), vec![])?;
    /// crowd.enter(1, at(1.2, 0.0), vec![])?;
    /// assert_eq!(crowd.advance(9.0, &mut [(), ()])?.bodies, [0, 1]);
    /// let speed = |body| crowd.member(body).map_or(0.0, |m| m.state().twist.velocity.x);
    /// assert_eq!(speed(1) - speed(0), 1.0);
    /// # Ok::<(), carom_motion::MotionError>(())
    /// ```
    pub fn advance<O: Observer>(&mut self, until: f64, observers: &mut [O]) -> Result<Advance, MotionError> {
        let observers = &mut seen_by(observers);
        self.watching(|crowd| crowd.advance_to(until, observers))
    }

    /// Does something, unless numbers have been lost.
    pub(super) fn watching<R>(
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
        // Who has just entered may touch at once: this comes before time goes on.
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
        // Ends of pieces are known for each island as if it were alone: an encounter before the first of them changes both.
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

    /// Takes every body to the present time, though its piece goes on. The observer is told of the part of the piece that is over.
    ///
    /// # Errors
    /// [`MotionError`]: a fault of the numbers.
    ///
    /// # Example
    /// After a quarter of a second at 2 m/s the ball is half a metre on.
    /// ```
    /// use carom_motion::planar::{Crowd, Options, examples};
    /// let (world, at) = (examples::two_balls(), examples::on_the_axis);
    /// let mut crowd = Crowd::new(&world, Options::default());
    /// crowd.enter(0, at(0.0, 2.0), vec![])?;
    /// crowd.enter(1, at(1.2, 0.0), vec![])?;
    /// crowd.advance(0.25, &mut [(), ()])?;
    /// crowd.pause(&mut [(), ()])?;
    /// assert_eq!(crowd.member(0).map(|m| (m.time(), m.state().pose.centre.x)), Some((0.25, 0.5)));
    /// # Ok::<(), carom_motion::MotionError>(())
    /// ```
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

    pub(super) fn look_ahead(&mut self) -> Result<(), MotionError> {
        for (island, ahead) in self.islands.iter().zip(&mut self.ahead) {
            if ahead.is_none() {
                *ahead = Some(island.ahead()?);
            }
        }
        Ok(())
    }

    /// Notes that everything is known up to a time.
    pub(super) fn move_on(&mut self, time: f64) {
        if time - self.time > SAME_INSTANT * self.scales.time {
            self.parting.clear();
            self.stalls = 0;
        } else {
            self.stalls += 1;
        }
        self.time = self.time.max(time);
    }

    pub(super) fn nothing(&self) -> Result<Advance, MotionError> {
        Ok(Advance { bodies: vec![], happening: Happening::Moves })
    }

    /// Lets an island fall apart where nothing holds it together, and says what has happened.
    pub(super) fn part(
        &mut self,
        mut whole: Island<'w>,
        happening: Happening,
    ) -> Result<Advance, MotionError> {
        whole.stand_unresolved();
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
