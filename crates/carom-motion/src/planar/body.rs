//! A free rigid body.

use super::{Shape, Twist};

/// A rigid body: shape about its mass centre, mass [kg], moment of inertia about the mass centre [kg m²].
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Shape, drawn about the mass centre.
    pub shape: Shape,
    /// Mass [kg], > 0.
    pub mass: f64,
    /// Moment of inertia about the mass centre [kg m²], > 0.
    pub inertia: f64,
}

impl Body {
    /// Kinetic energy [J].
    pub fn kinetic_energy(&self, twist: &Twist) -> f64 {
        0.5 * self.mass * twist.velocity.dot(twist.velocity) + 0.5 * self.inertia * twist.spin * twist.spin
    }
}
