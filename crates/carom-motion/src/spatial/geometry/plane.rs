//! A plane that a body may touch.

use crate::tolerance::UNIT_LENGTH;
use carom_num::Vec3;
use thiserror::Error;

/// A fixed plane; the body is on the side that its normal points to.
///
/// # Example
/// A wall that faces along x and stands half a metre behind the origin.
/// ```
/// use carom_motion::spatial::Plane;
/// use carom_num::Vec3;
/// let wall = Plane::new(Vec3::X, -0.5)?;
/// assert_eq!(wall.height(Vec3::new(1.0, 7.0, 7.0)), 1.5);
/// # Ok::<(), carom_motion::spatial::PlaneProblem>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    normal: Vec3,
    tangents: [Vec3; 2],
    offset: f64,
}

/// Numbers that no plane has.
///
/// # Example
/// ```
/// use carom_motion::spatial::{Plane, PlaneProblem};
/// use carom_num::Vec3;
/// assert_eq!(Plane::new(Vec3::X * 2.0, 0.0), Err(PlaneProblem::Normal { length: 2.0 }));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PlaneProblem {
    /// A normal that is no unit vector.
    #[error("the normal of a plane has the length {length}: it must be 1")]
    Normal {
        /// Its length.
        length: f64,
    },
    /// A place that is not finite.
    #[error("the offset of a plane is {offset} m: it must be finite")]
    Offset {
        /// What it is \[m\].
        offset: f64,
    },
}

impl Plane {
    /// The plane z = 0 of the world, under the body.
    pub const FLOOR: Self = Self { normal: Vec3::Z, tangents: [Vec3::X, Vec3::Y], offset: 0.0 };

    /// The plane of all points r with `normal · r = offset` \[m\], world axes.
    ///
    /// # Errors
    /// The first number that is not allowed.
    pub fn new(normal: Vec3, offset: f64) -> Result<Self, PlaneProblem> {
        let length = normal.norm();
        if (length - 1.0).abs() > UNIT_LENGTH || length.is_nan() {
            return Err(PlaneProblem::Normal { length });
        }
        if !offset.is_finite() {
            return Err(PlaneProblem::Offset { offset });
        }
        Ok(Self::of_unit(normal / length, offset))
    }

    /// That of a unit normal.
    pub(in crate::spatial) fn of_unit(normal: Vec3, offset: f64) -> Self {
        Self { normal, tangents: normal.tangents(), offset }
    }

    /// Its unit normal, world axes.
    pub fn normal(&self) -> Vec3 {
        self.normal
    }

    /// Two unit vectors along it, world axes; with the normal they are a right-handed frame.
    pub fn tangents(&self) -> [Vec3; 2] {
        self.tangents
    }

    /// Distance of a point from it, negative behind it \[m\].
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Plane;
    /// use carom_num::Vec3;
    /// assert_eq!(Plane::FLOOR.height(Vec3::new(3.0, 4.0, -2.0)), -2.0);
    /// ```
    pub fn height(&self, place: Vec3) -> f64 {
        self.normal.dot(place) - self.offset
    }

    /// The tangents and the normal.
    pub(in crate::spatial) fn axes(&self) -> [Vec3; 3] {
        let [first, second] = self.tangents;
        [first, second, self.normal]
    }

    /// The same plane, farther along its normal.
    pub(in crate::spatial) fn raised(&self, by: f64) -> Self {
        Self { offset: self.offset + by, ..*self }
    }

    /// The part of a vector along the plane.
    pub(in crate::spatial) fn along(&self, v: Vec3) -> Vec3 {
        v - self.normal * self.normal.dot(v)
    }

    /// The nearest point of the plane.
    pub(in crate::spatial) fn onto(&self, place: Vec3) -> Vec3 {
        place - self.normal * self.height(place)
    }

    /// The same places, seen from the other side.
    pub(in crate::spatial) fn flipped(&self) -> Self {
        Self::of_unit(-self.normal, -self.offset)
    }

    /// What of a convex polygon is behind it, or on it.
    pub(in crate::spatial) fn behind(&self, polygon: &[Vec3]) -> Vec<Vec3> {
        let mut kept = vec![];
        for (k, &to) in polygon.iter().enumerate() {
            let from = polygon[(k + polygon.len() - 1) % polygon.len()];
            let (a, b) = (self.height(from), self.height(to));
            if a * b < 0.0 {
                kept.push(from + (to - from) * (a / (a - b)));
            }
            if b <= 0.0 {
                kept.push(to);
            }
        }
        kept
    }
}
