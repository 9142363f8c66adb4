//! The bodies of a crowd, each by itself.

use super::State;
use super::crowd::Crowd;
use super::flight::MET;
use super::island::Island;
use super::meeting::Approach;
use super::outlook::Outlook;
use super::terms::{Effort, Happening, Margin, MotionError};
use super::trace::HeldContact;

impl<'w> Crowd<'w> {
    /// The bodies on their way.
    ///
    /// # Example
    /// ```
    /// # use {carom_impact::planar::Law, carom_motion::planar::*, carom_num::Vec2};
    /// # let shape = Shape::new(vec![Vec2::ZERO], 0.1).unwrap();
    /// # let ball = |mass: f64| Body { shape: shape.clone(), mass, inertia: 0.005 * mass };
    /// # let between = Surface { friction: 0.2, restitution: 0.5 };
    /// # let bodies = vec![ball(1.0), ball(3.0)];
    /// # let world = World { gravity: Vec2::ZERO, bodies, obstacles: vec![], between, law: Law::Poisson };
    /// # let twist = |speed: f64| Twist { velocity: Vec2::new(speed, 0.0), spin: 0.0 };
    /// # let at = |x, v| State { pose: Pose { centre: Vec2::new(x, 0.0), angle: 0.0 }, twist: twist(v) };
    /// let mut crowd = Crowd::new(&world, Options::default());
    /// crowd.enter(1, at(1.2, 0.0), vec![])?;
    /// crowd.enter(0, at(0.0, 2.0), vec![])?;
    /// let mut bodies: Vec<usize> = crowd.bodies().collect();
    /// bodies.sort_unstable();
    /// assert_eq!(bodies, [0, 1]);
    /// # Ok::<(), carom_motion::planar::MotionError>(())
    /// ```
    pub fn bodies(&self) -> impl Iterator<Item = usize> + '_ {
        self.islands.iter().flat_map(|i| i.members.iter().copied())
    }

    pub(super) fn island_of(&self, body: usize) -> Option<(&Island<'w>, usize)> {
        self.islands.iter().find_map(|i| Some((i, i.place_of(body)?)))
    }

    /// What is known of a body on its way.
    ///
    /// # Example
    /// Balls of 1 kg and 3 kg meet: `m₁ v₁ + m₂ v₂` stays 2 kg m/s.
    /// ```
    /// # use {carom_impact::planar::Law, carom_motion::planar::*, carom_num::Vec2};
    /// # let shape = Shape::new(vec![Vec2::ZERO], 0.1).unwrap();
    /// # let ball = |mass: f64| Body { shape: shape.clone(), mass, inertia: 0.005 * mass };
    /// # let between = Surface { friction: 0.2, restitution: 0.5 };
    /// # let bodies = vec![ball(1.0), ball(3.0)];
    /// # let world = World { gravity: Vec2::ZERO, bodies, obstacles: vec![], between, law: Law::Poisson };
    /// # let twist = |speed: f64| Twist { velocity: Vec2::new(speed, 0.0), spin: 0.0 };
    /// # let at = |x, v| State { pose: Pose { centre: Vec2::new(x, 0.0), angle: 0.0 }, twist: twist(v) };
    /// let mut crowd = Crowd::new(&world, Options::default());
    /// crowd.enter(0, at(0.0, 2.0), vec![])?;
    /// crowd.enter(1, at(1.2, 0.0), vec![])?;
    /// crowd.advance(9.0, &mut [(), ()])?;
    /// let speed = |body| crowd.member(body).map(|m| m.state().twist.velocity.x);
    /// assert_eq!(speed(0).zip(speed(1)).map(|(v, w)| v + 3.0 * w), Some(2.0));
    /// assert!(crowd.member(2).is_none());
    /// # Ok::<(), carom_motion::planar::MotionError>(())
    /// ```
    pub fn member(&self, body: usize) -> Option<Member<'_>> {
        self.island_of(body).map(|(island, place)| Member { island, place })
    }

    /// True where a body in this state would overlap none that is on its way.
    ///
    /// # Errors
    /// [`MotionError`]: a fault of the numbers, in looking ahead.
    ///
    /// # Example
    /// Balls of radius 0.1 m overlap where their centres are less than 0.2 m apart.
    /// ```
    /// # use {carom_impact::planar::Law, carom_motion::planar::*, carom_num::Vec2};
    /// # let shape = Shape::new(vec![Vec2::ZERO], 0.1).unwrap();
    /// # let ball = |mass: f64| Body { shape: shape.clone(), mass, inertia: 0.005 * mass };
    /// # let between = Surface { friction: 0.2, restitution: 0.5 };
    /// # let bodies = vec![ball(1.0), ball(3.0)];
    /// # let world = World { gravity: Vec2::ZERO, bodies, obstacles: vec![], between, law: Law::Poisson };
    /// # let twist = |speed: f64| Twist { velocity: Vec2::new(speed, 0.0), spin: 0.0 };
    /// # let at = |x, v| State { pose: Pose { centre: Vec2::new(x, 0.0), angle: 0.0 }, twist: twist(v) };
    /// let mut crowd = Crowd::new(&world, Options::default());
    /// crowd.enter(1, at(1.2, 0.0), vec![])?;
    /// assert!(crowd.has_room(0, &at(0.9, 0.0))?);
    /// assert!(!crowd.has_room(0, &at(1.1, 0.0))?);
    /// # Ok::<(), carom_motion::planar::MotionError>(())
    /// ```
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

    /// Where a body is at a time that is known and not before the last event, to the accuracy of the dense output; rest at the origin for a
    /// body that is not on its way.
    ///
    /// # Example
    /// ```
    /// # use {carom_impact::planar::Law, carom_motion::planar::*, carom_num::Vec2};
    /// # let shape = Shape::new(vec![Vec2::ZERO], 0.1).unwrap();
    /// # let ball = |mass: f64| Body { shape: shape.clone(), mass, inertia: 0.005 * mass };
    /// # let between = Surface { friction: 0.2, restitution: 0.5 };
    /// # let bodies = vec![ball(1.0), ball(3.0)];
    /// # let world = World { gravity: Vec2::ZERO, bodies, obstacles: vec![], between, law: Law::Poisson };
    /// # let twist = |speed: f64| Twist { velocity: Vec2::new(speed, 0.0), spin: 0.0 };
    /// # let at = |x, v| State { pose: Pose { centre: Vec2::new(x, 0.0), angle: 0.0 }, twist: twist(v) };
    /// let mut crowd = Crowd::new(&world, Options::default());
    /// crowd.enter(0, at(0.0, 2.0), vec![])?;
    /// crowd.enter(1, at(1.2, 0.0), vec![])?;
    /// crowd.advance(0.25, &mut [(), ()])?;
    /// assert!((crowd.state_at(0, 0.125).pose.centre.x - 0.25).abs() < 1e-15);
    /// assert_eq!(crowd.state_at(7, 0.125), State::default());
    /// # Ok::<(), carom_motion::planar::MotionError>(())
    /// ```
    pub fn state_at(&self, body: usize, time: f64) -> State {
        let found = self.islands.iter().zip(&self.ahead).find_map(|(island, ahead)| {
            let place = island.place_of(body)?;
            Some(ahead.as_ref().map_or_else(|| *island.state(place), |a| a.state(place, time)))
        });
        found.unwrap_or_default()
    }
}

/// What is known of a body on its way.
///
/// # Example
/// A ball on its way, before it meets any other.
/// ```
/// # use {carom_impact::planar::Law, carom_motion::planar::*, carom_num::Vec2};
/// # let shape = Shape::new(vec![Vec2::ZERO], 0.1).unwrap();
/// # let ball = |mass: f64| Body { shape: shape.clone(), mass, inertia: 0.005 * mass };
/// # let between = Surface { friction: 0.2, restitution: 0.5 };
/// # let bodies = vec![ball(1.0), ball(3.0)];
/// # let world = World { gravity: Vec2::ZERO, bodies, obstacles: vec![], between, law: Law::Poisson };
/// # let twist = |speed: f64| Twist { velocity: Vec2::new(speed, 0.0), spin: 0.0 };
/// # let at = |x, v| State { pose: Pose { centre: Vec2::new(x, 0.0), angle: 0.0 }, twist: twist(v) };
/// let mut crowd = Crowd::new(&world, Options::default());
/// crowd.enter(0, at(0.0, 2.0), vec![])?;
/// let ball = crowd.member(0).unwrap();
/// assert_eq!((ball.time(), ball.state().twist.velocity.x, ball.ended()), (0.0, 2.0, None));
/// assert!(ball.held().is_empty());
/// # Ok::<(), carom_motion::planar::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Member<'c> {
    pub(super) island: &'c Island<'c>,
    pub(super) place: usize,
}

impl Member<'_> {
    /// Time up to which the body was moved [s].
    ///
    /// # Example
    /// A body is moved from event to event, however far the crowd's time is.
    /// ```
    /// # use {carom_impact::planar::Law, carom_motion::planar::*, carom_num::Vec2};
    /// # let shape = Shape::new(vec![Vec2::ZERO], 0.1).unwrap();
    /// # let ball = |mass: f64| Body { shape: shape.clone(), mass, inertia: 0.005 * mass };
    /// # let between = Surface { friction: 0.2, restitution: 0.5 };
    /// # let bodies = vec![ball(1.0), ball(3.0)];
    /// # let world = World { gravity: Vec2::ZERO, bodies, obstacles: vec![], between, law: Law::Poisson };
    /// # let twist = |speed: f64| Twist { velocity: Vec2::new(speed, 0.0), spin: 0.0 };
    /// # let at = |x, v| State { pose: Pose { centre: Vec2::new(x, 0.0), angle: 0.0 }, twist: twist(v) };
    /// let mut crowd = Crowd::new(&world, Options::default());
    /// crowd.enter(0, at(0.0, 2.0), vec![])?;
    /// crowd.enter(1, at(1.2, 0.0), vec![])?;
    /// crowd.advance(0.25, &mut [(), ()])?;
    /// assert_eq!((crowd.time(), crowd.member(0).unwrap().time()), (0.25, 0.0));
    /// crowd.advance(9.0, &mut [(), ()])?;
    /// assert_eq!((crowd.time(), crowd.member(0).unwrap().time()), (0.5, 0.5));
    /// # Ok::<(), carom_motion::planar::MotionError>(())
    /// ```
    pub fn time(&self) -> f64 {
        self.island.time()
    }

    /// Pose and velocity.
    ///
    /// # Example
    /// ```
    /// # use {carom_impact::planar::Law, carom_motion::planar::*, carom_num::Vec2};
    /// # let shape = Shape::new(vec![Vec2::ZERO], 0.1).unwrap();
    /// # let ball = |mass: f64| Body { shape: shape.clone(), mass, inertia: 0.005 * mass };
    /// # let between = Surface { friction: 0.2, restitution: 0.5 };
    /// # let bodies = vec![ball(1.0), ball(3.0)];
    /// # let world = World { gravity: Vec2::ZERO, bodies, obstacles: vec![], between, law: Law::Poisson };
    /// # let twist = |speed: f64| Twist { velocity: Vec2::new(speed, 0.0), spin: 0.0 };
    /// # let at = |x, v| State { pose: Pose { centre: Vec2::new(x, 0.0), angle: 0.0 }, twist: twist(v) };
    /// let mut crowd = Crowd::new(&world, Options::default());
    /// crowd.enter(1, at(1.2, 0.0), vec![])?;
    /// assert_eq!(crowd.member(1).unwrap().state(), &at(1.2, 0.0));
    /// # Ok::<(), carom_motion::planar::MotionError>(())
    /// ```
    pub fn state(&self) -> &State {
        self.island.state(self.place)
    }

    /// The contacts held at present.
    ///
    /// # Example
    /// A block that lies on a floor is held at the two corners below, and sticks.
    /// ```
    /// # use {carom_impact::planar::{Law, Slip}, carom_motion::planar::*, carom_num::Vec2};
    /// # let corners = [(-0.2, -0.1), (0.2, -0.1), (0.2, 0.1), (-0.2, 0.1)].map(|(x, y)| Vec2::new(x, y));
    /// # let shape = Shape::new(corners.to_vec(), 0.0).unwrap();
    /// # let block = Body { shape, mass: 1.0, inertia: 0.2 / 12.0 };
    /// # let floor = |friction: f64| Obstacle::new(Vec2::new(-9.0, 0.0), Vec2::new(9.0, 0.0), friction, 0.0);
    /// # let pose = Pose { centre: Vec2::new(0.0, 0.1), angle: 0.0 };
    /// # let start = State { pose, twist: Twist::default() };
    /// let world = World::of_one(Vec2::new(0.0, -10.0), block, vec![floor(0.3)], Law::Poisson);
    /// let mut crowd = Crowd::new(&world, Options::default());
    /// crowd.enter(0, start, vec![])?;
    /// crowd.advance(1.0, &mut [()])?;
    /// let held = crowd.member(0).unwrap().held();
    /// assert_eq!(held.iter().map(|h| h.slip).collect::<Vec<_>>(), [Slip::Sticks, Slip::Sticks]);
    /// # Ok::<(), carom_motion::planar::MotionError>(())
    /// ```
    pub fn held(&self) -> Vec<HeldContact> {
        self.island.held(self.place)
    }

    /// The face that lies on an obstacle, as [`Walker::flat_on`](super::Walker::flat_on).
    ///
    /// # Example
    /// Face 0 of a block, from its first corner to its second, lies on the floor.
    /// ```
    /// # use {carom_impact::planar::{Law, Slip}, carom_motion::planar::*, carom_num::Vec2};
    /// # let corners = [(-0.2, -0.1), (0.2, -0.1), (0.2, 0.1), (-0.2, 0.1)].map(|(x, y)| Vec2::new(x, y));
    /// # let shape = Shape::new(corners.to_vec(), 0.0).unwrap();
    /// # let block = Body { shape, mass: 1.0, inertia: 0.2 / 12.0 };
    /// # let floor = |friction: f64| Obstacle::new(Vec2::new(-9.0, 0.0), Vec2::new(9.0, 0.0), friction, 0.0);
    /// # let pose = Pose { centre: Vec2::new(0.0, 0.1), angle: 0.0 };
    /// # let start = State { pose, twist: Twist::default() };
    /// let world = World::of_one(Vec2::new(0.0, -10.0), block, vec![floor(0.3)], Law::Poisson);
    /// let mut crowd = Crowd::new(&world, Options::default());
    /// crowd.enter(0, start, vec![])?;
    /// crowd.advance(1.0, &mut [()])?;
    /// assert_eq!(crowd.member(0).unwrap().flat_on(0), Some(0));
    /// # Ok::<(), carom_motion::planar::MotionError>(())
    /// ```
    pub fn flat_on(&self, obstacle: usize) -> Option<usize> {
        self.island.flat_on(self.place, obstacle)
    }

    /// Which obstacle it meets next, as [`Walker::outlook`](super::Walker::outlook); other bodies are not looked at.
    pub fn outlook(&self) -> Outlook {
        self.island.outlook()
    }

    /// Counts of the work done for it and for those it met.
    ///
    /// # Example
    /// Two balls meet once.
    /// ```
    /// # use {carom_impact::planar::Law, carom_motion::planar::*, carom_num::Vec2};
    /// # let shape = Shape::new(vec![Vec2::ZERO], 0.1).unwrap();
    /// # let ball = |mass: f64| Body { shape: shape.clone(), mass, inertia: 0.005 * mass };
    /// # let between = Surface { friction: 0.2, restitution: 0.5 };
    /// # let bodies = vec![ball(1.0), ball(3.0)];
    /// # let world = World { gravity: Vec2::ZERO, bodies, obstacles: vec![], between, law: Law::Poisson };
    /// # let twist = |speed: f64| Twist { velocity: Vec2::new(speed, 0.0), spin: 0.0 };
    /// # let at = |x, v| State { pose: Pose { centre: Vec2::new(x, 0.0), angle: 0.0 }, twist: twist(v) };
    /// let mut crowd = Crowd::new(&world, Options::default());
    /// crowd.enter(0, at(0.0, 2.0), vec![])?;
    /// crowd.enter(1, at(1.2, 0.0), vec![])?;
    /// crowd.advance(9.0, &mut [(), ()])?;
    /// assert_eq!(crowd.member(0).unwrap().effort().impacts, 1);
    /// # Ok::<(), carom_motion::planar::MotionError>(())
    /// ```
    pub fn effort(&self) -> Effort {
        self.island.effort()
    }

    /// How certain its way is so far.
    ///
    /// # Example
    /// Nothing is decided before a body meets anything: no inequality came close to turning out the other
    /// way.
    /// ```
    /// # use {carom_impact::planar::Law, carom_motion::planar::*, carom_num::Vec2};
    /// # let shape = Shape::new(vec![Vec2::ZERO], 0.1).unwrap();
    /// # let ball = |mass: f64| Body { shape: shape.clone(), mass, inertia: 0.005 * mass };
    /// # let between = Surface { friction: 0.2, restitution: 0.5 };
    /// # let bodies = vec![ball(1.0), ball(3.0)];
    /// # let world = World { gravity: Vec2::ZERO, bodies, obstacles: vec![], between, law: Law::Poisson };
    /// # let twist = |speed: f64| Twist { velocity: Vec2::new(speed, 0.0), spin: 0.0 };
    /// # let at = |x, v| State { pose: Pose { centre: Vec2::new(x, 0.0), angle: 0.0 }, twist: twist(v) };
    /// let mut crowd = Crowd::new(&world, Options::default());
    /// crowd.enter(0, at(0.0, 2.0), vec![])?;
    /// assert_eq!(crowd.member(0).unwrap().margin().value, f64::INFINITY);
    /// # Ok::<(), carom_motion::planar::MotionError>(())
    /// ```
    pub fn margin(&self) -> Margin {
        self.island.margin()
    }

    /// How its way has ended, where it has.
    ///
    /// # Example
    /// A block that lies on a floor rests, and its way is at an end.
    /// ```
    /// # use {carom_impact::planar::{Law, Slip}, carom_motion::planar::*, carom_num::Vec2};
    /// # let corners = [(-0.2, -0.1), (0.2, -0.1), (0.2, 0.1), (-0.2, 0.1)].map(|(x, y)| Vec2::new(x, y));
    /// # let shape = Shape::new(corners.to_vec(), 0.0).unwrap();
    /// # let block = Body { shape, mass: 1.0, inertia: 0.2 / 12.0 };
    /// # let floor = |friction: f64| Obstacle::new(Vec2::new(-9.0, 0.0), Vec2::new(9.0, 0.0), friction, 0.0);
    /// # let pose = Pose { centre: Vec2::new(0.0, 0.1), angle: 0.0 };
    /// # let start = State { pose, twist: Twist::default() };
    /// let world = World::of_one(Vec2::new(0.0, -10.0), block, vec![floor(0.3)], Law::Poisson);
    /// let mut crowd = Crowd::new(&world, Options::default());
    /// crowd.enter(0, start, vec![])?;
    /// assert_eq!(crowd.member(0).unwrap().ended(), None);
    /// crowd.advance(1.0, &mut [()])?;
    /// assert_eq!(crowd.member(0).unwrap().ended(), Some(Happening::Rests));
    /// # Ok::<(), carom_motion::planar::MotionError>(())
    /// ```
    pub fn ended(&self) -> Option<Happening> {
        self.island.ended()
    }
}
