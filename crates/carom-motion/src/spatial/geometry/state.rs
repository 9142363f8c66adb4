//! Where a body is and how it moves.

use super::body::Body;
use super::world::World;
use carom_impact::spatial::RigidBody;
use carom_num::elementary::atan2;
use carom_num::{Rotation, Vec3};

/// Place and motion of a body.
///
/// # Example
/// Thrown along x with 3 m/s, 2 m above the plane.
/// ```
/// use carom_motion::spatial::State;
/// use carom_num::{Rotation, Vec3};
/// let (centre, velocity) = (Vec3::Z * 2.0, Vec3::X * 3.0);
/// let state = State { centre, attitude: Rotation::NONE, velocity, spin: Vec3::Z };
/// assert_eq!(state.place(Vec3::X), Vec3::new(1.0, 0.0, 2.0));
/// assert_eq!(state.velocity_of(Vec3::X), Vec3::new(3.0, 1.0, 0.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// Mass centre, world axes \[m\].
    pub centre: Vec3,
    /// The rotation of the body's axes into the world's.
    pub attitude: Rotation,
    /// Velocity of the mass centre, world axes [m/s].
    pub velocity: Vec3,
    /// Angular velocity, body axes [rad/s].
    pub spin: Vec3,
}

/// Where a body is.
#[derive(Clone, Copy, Debug)]
pub(in crate::spatial) struct Pose {
    /// Mass centre, world axes \[m\].
    pub(in crate::spatial) centre: Vec3,
    pub(in crate::spatial) attitude: Rotation,
}

impl Pose {
    /// That of a body whose axes are the world's.
    pub(in crate::spatial) const NONE: Self = Self { centre: Vec3::ZERO, attitude: Rotation::NONE };
}

impl State {
    pub(in crate::spatial) fn pose(&self) -> Pose {
        Pose { centre: self.centre, attitude: self.attitude }
    }

    /// A body that turns about one of its supports, which stands at the world's origin.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::{Body, State};
    /// use carom_num::{Mat3, Rotation, Vec3};
    /// let body = Body::new(1.0, Mat3::IDENTITY, vec![Vec3::new(0.0, 0.0, -2.0)]).unwrap();
    /// let state = State::standing(&body, 0, Rotation::NONE, Vec3::X);
    /// assert_eq!((state.centre, state.velocity), (Vec3::Z * 2.0, Vec3::Y * -2.0));
    /// ```
    pub fn standing(body: &Body, support: usize, attitude: Rotation, spin: Vec3) -> Self {
        let arm = body.features().get(support).map_or(Vec3::ZERO, |f| f.arm(attitude.undo(Vec3::Z)));
        Self { centre: -attitude.apply(arm), attitude, velocity: attitude.apply(arm.cross(spin)), spin }
    }

    /// The world's z, body axes: the normal of the plane z = 0.
    ///
    /// # Example
    /// A body that lies on its back, turned about x by a right angle, has the world's z along its y.
    /// ```
    /// use carom_motion::spatial::{State, examples};
    /// use carom_num::{Rotation, Vec3};
    /// let rod = examples::rod();
    /// let lying = Rotation::by(Vec3::X * std::f64::consts::FRAC_PI_2);
    /// assert!((State::standing(&rod, 0, lying, Vec3::ZERO).up() - Vec3::Y).norm() < 1e-15);
    /// ```
    pub fn up(&self) -> Vec3 {
        self.attitude.undo(Vec3::Z)
    }

    /// The angle between an axis of the body and the world's z, in [0, π] \[rad\].
    pub fn tilt(&self, axis: Vec3) -> f64 {
        let up = self.up();
        atan2(up.cross(axis).norm(), up.dot(axis))
    }

    /// Kinetic energy \[J\].
    ///
    /// # Example
    /// A rod of 2 m and 1 kg that turns about its foot with 3 rad/s has `½ (m ℓ²/3) ω²`, 6 J.
    /// ```
    /// use carom_motion::spatial::{State, examples};
    /// use carom_num::{Rotation, Vec3};
    /// let rod = examples::rod();
    /// let turning = State::standing(&rod, 0, Rotation::NONE, Vec3::X * 3.0);
    /// assert!((turning.kinetic(&rod) - 6.0).abs() < 1e-14);
    /// ```
    pub fn kinetic(&self, body: &Body) -> f64 {
        0.5 * body.mass() * self.velocity.dot(self.velocity) + 0.5 * self.spin.dot(body.inertia() * self.spin)
    }

    /// Potential energy, zero with the mass centre at the world's origin \[J\].
    pub fn potential(&self, world: &World) -> f64 {
        -world.body().mass() * world.gravity().dot(self.centre)
    }

    /// A support's place, world axes \[m\].
    pub fn place(&self, arm: Vec3) -> Vec3 {
        self.centre + self.attitude.apply(arm)
    }

    /// A support's velocity, world axes [m/s].
    ///
    /// # Example
    /// The head of a rod of 2 m that turns about its foot with 3 rad/s moves with 6 m/s, the foot not at all.
    /// ```
    /// use carom_motion::spatial::{State, examples};
    /// use carom_num::{Rotation, Vec3};
    /// let rod = examples::rod();
    /// let turning = State::standing(&rod, 0, Rotation::NONE, Vec3::Y * 3.0);
    /// assert_eq!(turning.velocity_of(Vec3::Z), Vec3::X * 6.0);
    /// assert_eq!(turning.velocity_of(-Vec3::Z), Vec3::ZERO);
    /// ```
    pub fn velocity_of(&self, arm: Vec3) -> Vec3 {
        self.velocity + self.attitude.apply(self.spin.cross(arm))
    }

    /// True where all its numbers are finite.
    pub fn is_finite(&self) -> bool {
        let finite = [self.centre, self.attitude.v, self.velocity, self.spin].iter().all(|v| v.is_finite());
        finite && self.attitude.w.is_finite()
    }

    /// The body as an impact takes it.
    pub(in crate::spatial) fn rigid(&self, body: &Body) -> RigidBody {
        RigidBody {
            mass: body.mass(),
            inertia: self.attitude.turn(body.inertia()),
            velocity: self.velocity,
            spin: self.attitude.apply(self.spin),
        }
    }
}

/// The height of a support over its plane, from a foot that stands on the same plane if there is one: then a body that is almost flat keeps its digits.
pub(in crate::spatial) fn measured(world: &World, state: &State, foot: Option<usize>, support: usize) -> f64 {
    if let Some(pair) = world.pair(support) {
        return pair.meeting(state.pose()).gap;
    }
    let arm = world.arm(support, state.pose());
    let plane = world.support(support).plane;
    match foot.filter(|foot| world.plane_of(*foot) == world.plane_of(support)) {
        Some(foot) => state.attitude.undo(plane.normal()).dot(arm - world.arm(foot, state.pose())),
        None => plane.height(state.place(arm)),
    }
}
