//! Bodies among fixed obstacles under gravity.

use super::kinematics::Pairing;
use crate::planar::geometry::{Body, Obstacle, Shape, State, Surface};
use carom_impact::Law;
use carom_num::Vec2;

/// Free bodies among fixed obstacles under uniform gravity.
///
/// What a body meets has a number: the obstacles come first, then the bodies.
///
/// # Example
/// Two balls of 1 kg, half a metre and a metre up at g = 10 m/s², have 5 J and 10 J.
/// ```
/// use carom_impact::Law;
/// use carom_motion::planar::{Body, Obstacle, Pose, Shape, State, Surface, World};
/// use carom_num::Vec2;
/// let ball = Body { shape: Shape::new(vec![Vec2::ZERO], 0.1).unwrap(), mass: 1.0, inertia: 0.005 };
/// let world = World {
///     gravity: Vec2::new(0.0, -10.0),
///     bodies: vec![ball.clone(), ball],
///     obstacles: vec![Obstacle::new(Vec2::ZERO, Vec2::new(1.0, 0.0), 0.3, 0.5)],
///     between: Surface { friction: 0.2, restitution: 0.5 },
///     law: Law::Poisson,
/// };
/// let up = |y: f64| State { pose: Pose { centre: Vec2::new(0.0, y), angle: 0.0 }, ..State::default() };
/// assert_eq!(world.energy(&[up(0.5), up(1.0)]), 15.0);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct World {
    /// Gravity [m/s²].
    pub gravity: Vec2,
    /// The bodies, at least one.
    pub bodies: Vec<Body>,
    /// The obstacles.
    pub obstacles: Vec<Obstacle>,
    /// How bodies that touch each other rub and rebound.
    pub between: Surface,
    /// How restitution is measured.
    pub law: Law,
}

/// The world's own units: nothing is decided by an absolute tolerance.
///
/// # Example
/// A ball of 0.1 m at g = 10 m/s² falls through its size at √(g r) = 1 m/s.
/// ```
/// use carom_motion::planar::examples;
/// let (world, _) = examples::falling_ball();
/// let scales = world.scales();
/// assert_eq!((scales.length, scales.speed, scales.time), (0.1, 1.0, 0.1));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scales {
    /// The largest body's size [m].
    pub length: f64,
    /// Speed of a fall through that size [m/s], or 1 where there is no gravity.
    pub speed: f64,
    /// Length / speed [s].
    pub time: f64,
}

impl World {
    /// A world of one body.
    ///
    /// # Example
    /// ```
    /// use carom_impact::Law;
    /// use carom_motion::planar::{Body, Shape, World};
    /// use carom_num::Vec2;
    /// let ball = Body { shape: Shape::new(vec![Vec2::ZERO], 0.1).unwrap(), mass: 1.0, inertia: 0.005 };
    /// let world = World::of_one(Vec2::new(0.0, -10.0), ball, vec![], Law::Poisson);
    /// assert_eq!((world.bodies.len(), world.obstacles.len()), (1, 0));
    /// ```
    pub fn of_one(gravity: Vec2, body: Body, obstacles: Vec<Obstacle>, law: Law) -> Self {
        let between = Surface { friction: 0.0, restitution: 0.0 };
        Self { gravity, bodies: vec![body], obstacles, between, law }
    }

    /// The world's own units.
    pub fn scales(&self) -> Scales {
        let length = self.bodies.iter().map(|b| b.shape.size()).fold(0.0, f64::max);
        let fall = self.gravity.norm() * length;
        let speed = if fall > 0.0 { fall.sqrt() } else { 1.0 };
        Scales { length, speed, time: length / speed }
    }

    /// A rod without thickness and a bent obstacle without one, by their numbers, if there are such.
    pub(in crate::planar) fn both_thin(&self) -> Option<(usize, usize)> {
        let obstacle = self.obstacles.iter().position(Obstacle::is_bent_thin)?;
        let body = self.bodies.iter().position(|b| b.shape.is_thin_rod())?;
        Some((body, obstacle))
    }

    /// Kinetic and potential energy of the bodies in these states [J].
    ///
    /// # Example
    /// A flight keeps it: 1 kg at 0.3 m has 3 J, and so it has after a fall of 0.2 s.
    /// ```
    /// use carom_motion::planar::examples;
    /// let (world, start) = examples::falling_ball();
    /// let fallen = start.flown(world.gravity, 0.2);
    /// assert!((world.energy(&[start]) - 3.0).abs() < 1e-15);
    /// assert!((world.energy(&[fallen]) - 3.0).abs() < 1e-15);
    /// ```
    pub fn energy(&self, states: &[State]) -> f64 {
        let each = |(body, state): (&Body, &State)| {
            body.kinetic_energy(&state.twist) - body.mass * self.gravity.dot(state.pose.centre)
        };
        self.bodies.iter().zip(states).map(each).sum()
    }

    /// The number, among the bodies, of the body that a pair meets; `None` where it meets an obstacle.
    pub fn other_body(&self, pair: Pairing) -> Option<usize> {
        pair.obstacle.checked_sub(self.obstacles.len())
    }

    /// How the two sides of a pair rub and rebound.
    pub(in crate::planar) fn surface(&self, pair: Pairing) -> Surface {
        self.obstacles
            .get(pair.obstacle)
            .map_or(self.between, |o| Surface { friction: o.friction, restitution: o.restitution })
    }

    /// How many things a body can meet, itself counted.
    pub(in crate::planar) fn things(&self) -> usize {
        self.obstacles.len() + self.bodies.len()
    }

    /// The shape of what a body can meet, by its number.
    pub(super) fn shape_of(&self, thing: usize) -> &Shape {
        match thing.checked_sub(self.obstacles.len()) {
            None => self.obstacles[thing].shape(),
            Some(body) => &self.bodies[body].shape,
        }
    }

    /// The shape of what a pair's body meets.
    pub(in crate::planar) fn met(&self, pair: Pairing) -> &Shape {
        self.shape_of(pair.obstacle)
    }

    /// The body of a pair.
    pub(in crate::planar) fn body_of(&self, pair: Pairing) -> &Body {
        &self.bodies[pair.body]
    }

    /// The world of some of these bodies.
    pub(in crate::planar) fn of_some(&self, bodies: &[usize]) -> Self {
        let bodies = bodies.iter().map(|&b| self.bodies[b].clone()).collect();
        Self {
            gravity: self.gravity,
            bodies,
            obstacles: self.obstacles.clone(),
            between: self.between,
            law: self.law,
        }
    }
}
