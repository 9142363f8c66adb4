//! Where a body is and how it moves.

use crate::evaluated::{Quantity, evaluated};
use carom_num::Vec2;

/// Position of the mass centre [m] and angle of the body [rad, counter-clockwise], in the world frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pose {
    /// Mass centre [m].
    pub centre: Vec2,
    /// Angle from the body's own drawing [rad].
    pub angle: f64,
}

/// Velocity of the mass centre [m/s] and spin [rad/s, counter-clockwise], in the world frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Twist {
    /// Velocity of the mass centre [m/s].
    pub velocity: Vec2,
    /// Spin [rad/s].
    pub spin: f64,
}

/// Pose and velocity.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct State {
    /// Where it is.
    pub pose: Pose,
    /// How it moves.
    pub twist: Twist,
}

impl State {
    /// True where every number is finite.
    pub fn is_finite(&self) -> bool {
        self.pose.centre.is_finite()
            && self.pose.angle.is_finite()
            && self.twist.velocity.is_finite()
            && self.twist.spin.is_finite()
    }

    /// The state after a free flight of `t` [s] under `gravity` [m/s²].
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
