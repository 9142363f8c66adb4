//! Where a body is and how it moves.

use crate::evaluated::{Quantity, evaluated};
use carom_num::Vec2;

/// Position of the mass centre [m] and angle of the body [rad, counter-clockwise], in the world frame.
///
/// # Example
/// Turned by a right angle, what points along the body's x points up.
/// ```
/// use carom_motion::planar::Pose;
/// use carom_num::Vec2;
/// let pose = Pose { centre: Vec2::new(1.0, 2.0), angle: std::f64::consts::FRAC_PI_2 };
/// let nose = pose.centre + Vec2::at_angle(pose.angle) * 0.5;
/// assert!((nose - Vec2::new(1.0, 2.5)).norm() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pose {
    /// Mass centre [m].
    pub centre: Vec2,
    /// Angle from the body's own drawing [rad].
    pub angle: f64,
}

impl Pose {
    /// What of the body points down (along −y of the world), as a unit vector in the axes of its own drawing.
    ///
    /// # Example
    /// A quarter turn counter-clockwise brings the body's left side down.
    /// ```
    /// use carom_motion::planar::Pose;
    /// let down = Pose { angle: std::f64::consts::FRAC_PI_2, ..Pose::default() }.down();
    /// assert!((down.x + 1.0).abs() < 1e-15 && down.y.abs() < 1e-15);
    /// ```
    pub fn down(&self) -> Vec2 {
        let turn = Vec2::at_angle(self.angle);
        Vec2::new(0.0, -1.0).rotated(turn.x, -turn.y)
    }
}

/// Velocity of the mass centre [m/s] and spin [rad/s, counter-clockwise], in the world frame.
///
/// # Example
/// A point at `r` from the mass centre moves with `v + ω × r`: the lowest point of a wheel that rolls stands
/// still.
/// ```
/// use carom_motion::planar::Twist;
/// use carom_num::Vec2;
/// let rolling = Twist { velocity: Vec2::new(3.0, 0.0), spin: -6.0 };
/// let lowest = Vec2::new(0.0, -0.5);
/// assert_eq!(rolling.velocity + lowest.turned_left() * rolling.spin, Vec2::ZERO);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Twist {
    /// Velocity of the mass centre [m/s].
    pub velocity: Vec2,
    /// Spin [rad/s].
    pub spin: f64,
}

/// Pose and velocity.
///
/// # Example
/// ```
/// use carom_motion::planar::{Pose, State, Twist};
/// use carom_num::Vec2;
/// let start = State { pose: Pose { centre: Vec2::new(0.0, 5.0), angle: 0.0 }, twist: Twist::default() };
/// let end = start.flown(Vec2::new(0.0, -10.0), 1.0);
/// assert_eq!((end.pose.centre, end.twist.velocity), (Vec2::ZERO, Vec2::new(0.0, -10.0)));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct State {
    /// Where it is.
    pub pose: Pose,
    /// How it moves.
    pub twist: Twist,
}

impl State {
    /// True where every number is finite.
    ///
    /// # Example
    /// ```
    /// use carom_motion::planar::{State, Twist};
    /// assert!(State::default().is_finite());
    /// let lost = Twist { spin: f64::INFINITY, ..Twist::default() };
    /// assert!(!State { twist: lost, ..State::default() }.is_finite());
    /// ```
    pub fn is_finite(&self) -> bool {
        self.pose.centre.is_finite()
            && self.pose.angle.is_finite()
            && self.twist.velocity.is_finite()
            && self.twist.spin.is_finite()
    }

    /// The state after a free flight of `t` [s] under `gravity` [m/s²].
    ///
    /// # Example
    /// What is thrown up with 10 m/s is back after 2 s, with the same speed downwards.
    /// ```
    /// use carom_motion::planar::{State, Twist};
    /// use carom_num::Vec2;
    /// let up = Vec2::new(0.0, 10.0);
    /// let thrown = State { twist: Twist { velocity: up, spin: 3.0 }, ..State::default() };
    /// let back = thrown.flown(Vec2::new(0.0, -10.0), 2.0);
    /// assert_eq!((back.pose.centre, back.twist.velocity, back.pose.angle), (Vec2::ZERO, -up, 6.0));
    /// ```
    pub fn flown(&self, gravity: Vec2, t: f64) -> State {
        let v = self.twist.velocity;
        State {
            pose: Pose {
                centre: self.pose.centre + v * t + gravity * (0.5 * t * t),
                angle: evaluated(Quantity::Flight, self.pose.angle + self.twist.spin * t),
            },
            twist: Twist { velocity: v + gravity * t, spin: self.twist.spin },
        }
    }
}
