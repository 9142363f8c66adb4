//! A body over a fixed plane, and the world's own units.

use super::Body;
use super::friction::{Friction, FrictionProblem};
use carom_num::Vec3;
use thiserror::Error;

/// A body over the plane z = 0 of the world, which lies below it: z is the plane's normal.
#[derive(Clone, Debug, PartialEq)]
pub struct World {
    body: Body,
    gravity: Vec3,
    friction: Option<Friction>,
}

/// Gravity that no motion can be scaled by.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("gravity has the size {size} m/s²: it must be finite and > 0")]
pub struct GravityProblem {
    /// Its size [m/s²].
    pub size: f64,
}

/// The world's own units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scales {
    /// The body's reach \[m\].
    pub length: f64,
    /// √(length/g) \[s\].
    pub time: f64,
    /// √(g length) [m/s].
    pub speed: f64,
    /// m g length \[J\].
    pub energy: f64,
}

impl World {
    /// A body under gravity [m/s²], in world axes; on an inclined plane it is not along −z.
    ///
    /// # Errors
    /// Where there is none, or it is not finite.
    pub fn new(body: Body, gravity: Vec3) -> Result<Self, GravityProblem> {
        let size = gravity.norm();
        if size > 0.0 && size.is_finite() {
            Ok(Self { body, gravity, friction: None })
        } else {
            Err(GravityProblem { size })
        }
    }

    /// The same world, whose plane has friction: supports may slide. Without it no support that touches slides, whatever that takes.
    ///
    /// # Errors
    /// The first number that no friction of this body has.
    pub fn with_friction(self, friction: Friction) -> Result<Self, FrictionProblem> {
        friction.check(self.body.supports().len())?;
        Ok(Self { friction: Some(friction), ..self })
    }

    /// Friction of the plane; `None` where no support may slide.
    pub fn friction(&self) -> Option<&Friction> {
        self.friction.as_ref()
    }

    /// The body.
    pub fn body(&self) -> &Body {
        &self.body
    }

    /// Gravity, world axes [m/s²].
    pub fn gravity(&self) -> Vec3 {
        self.gravity
    }

    /// The world's own units.
    pub fn scales(&self) -> Scales {
        let (length, g) = (self.body.reach(), self.gravity.norm());
        let speed = (g * length).sqrt();
        Scales { length, time: length / speed, speed, energy: self.body.mass() * g * length }
    }
}
