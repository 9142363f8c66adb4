//! A free rigid body.

use super::Shape;

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
