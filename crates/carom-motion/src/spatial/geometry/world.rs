//! A body over a fixed plane, and the world's own units.

use super::body::Body;
use super::friction::{Friction, FrictionProblem};
use carom_num::Vec3;
use thiserror::Error;

/// A body over the plane z = 0 of the world, which lies below it: z is the plane's normal.
///
/// # Example
/// On a plane that rises by 3 in 4, gravity of 10 m/s² has 6 m/s² along the plane.
/// ```
/// use carom_motion::spatial::{World, examples};
/// use carom_num::Vec3;
/// let rod = examples::rod();
/// let world = World::new(rod, Vec3::new(6.0, 0.0, -8.0)).unwrap();
/// assert_eq!(world.gravity().norm(), 10.0);
/// assert!(world.friction().is_none());
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct World {
    body: Body,
    gravity: Vec3,
    friction: Option<Friction>,
}

/// Gravity that no motion can be scaled by.
///
/// # Example
/// ```
/// use carom_motion::spatial::{GravityProblem, World, examples};
/// use carom_num::Vec3;
/// let rod = examples::rod();
/// let problem = World::new(rod, Vec3::ZERO).unwrap_err();
/// assert_eq!(problem, GravityProblem { size: 0.0 });
/// assert_eq!(problem.to_string(), "gravity has the size 0 m/s²: it must be finite and > 0");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("gravity has the size {size} m/s²: it must be finite and > 0")]
pub struct GravityProblem {
    /// Its size [m/s²].
    pub size: f64,
}

/// The world's own units.
///
/// # Example
/// Reach 0.4 m and g = 10 m/s²: `√(g ℓ)` is 2 m/s.
/// ```
/// use carom_motion::spatial::{Body, Scales, World};
/// use carom_num::{Mat3, Vec3};
/// let body = Body::new(3.0, Mat3::IDENTITY, vec![Vec3::Z * -0.4]).unwrap();
/// let scales = World::new(body, Vec3::Z * -10.0).unwrap().scales();
/// assert_eq!(scales, Scales { length: 0.4, time: 0.2, speed: 2.0, energy: 12.0 });
/// ```
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
            Ok(Self::of_checked(body, gravity))
        } else {
            Err(GravityProblem { size })
        }
    }

    /// A body under gravity [m/s²] that [`World::new`] would accept.
    pub(in crate::spatial) fn of_checked(body: Body, gravity: Vec3) -> Self {
        Self { body, gravity, friction: None }
    }

    /// The same world, whose plane has friction: supports may slide. Without it no support that touches slides, whatever that takes.
    ///
    /// # Errors
    /// The first number that no friction of this body has.
    ///
    /// # Example
    /// A rod that stands on one foot has one coefficient, not two.
    /// ```
    /// use carom_motion::spatial::{Friction, FrictionProblem, World, examples};
    /// use carom_num::Vec3;
    /// let rod = examples::rod();
    /// let world = World::new(rod, Vec3::Z * -10.0).unwrap();
    /// assert!(world.clone().with_friction(Friction::of_supports(vec![0.3])).is_ok());
    /// let problem = world.with_friction(Friction::of_supports(vec![0.3, 0.2])).unwrap_err();
    /// assert_eq!(problem, FrictionProblem::Count { given: 2, supports: 1 });
    /// ```
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
