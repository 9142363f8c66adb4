//! A free rigid body.

use super::{Shape, Twist};

/// A rigid body: shape about its mass centre, mass [kg], moment of inertia about the mass centre [kg m²].
///
/// # Example
/// A disc has `J = m r²/2`.
/// ```
/// use carom_motion::planar::{Body, MassProperties, Shape};
/// use carom_num::Vec2;
/// let (mass, radius) = (2.0, 0.5);
/// let shape = Shape::new(vec![Vec2::ZERO], radius).unwrap();
/// let inertia = mass * MassProperties::of(&shape).gyration_squared;
/// let disc = Body { shape, mass, inertia };
/// assert!((disc.inertia - 0.25).abs() < 1e-15);
/// ```
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
    ///
    /// # Example
    /// A disc that rolls has `¾ m v²`: half as much again as if it slid.
    /// ```
    /// use carom_motion::planar::{Body, Shape, Twist};
    /// use carom_num::Vec2;
    /// let shape = Shape::new(vec![Vec2::ZERO], 0.5).unwrap();
    /// let disc = Body { shape, mass: 2.0, inertia: 0.25 };
    /// let rolling = Twist { velocity: Vec2::new(3.0, 0.0), spin: -6.0 };
    /// assert_eq!(disc.kinetic_energy(&rolling), 13.5);
    /// ```
    pub fn kinetic_energy(&self, twist: &Twist) -> f64 {
        0.5 * self.mass * twist.velocity.dot(twist.velocity) + 0.5 * self.inertia * twist.spin * twist.spin
    }
}
