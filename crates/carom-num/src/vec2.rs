//! A plane vector.

use crate::elementary::sin_cos;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A vector in the plane: x right, y up.
///
/// # Example
/// ```
/// use carom_num::Vec2;
/// let (a, b) = (Vec2::new(3.0, 4.0), Vec2 { x: 1.0, y: -1.0 });
/// assert_eq!(2.0 * a - b / 2.0, Vec2::new(5.5, 8.5));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vec2 {
    /// Component along x.
    pub x: f64,
    /// Component along y.
    pub y: f64,
}

impl Vec2 {
    /// The zero vector.
    ///
    /// # Example
    /// ```
    /// use carom_num::Vec2;
    /// let v = Vec2::new(3.0, 4.0);
    /// assert_eq!((v + Vec2::ZERO, v - v), (v, Vec2::ZERO));
    /// ```
    pub const ZERO: Vec2 = Vec2 { x: 0.0, y: 0.0 };

    /// A vector from its components.
    #[inline]
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// The unit vector at `angle` [rad], counter-clockwise from x.
    ///
    /// # Example
    /// At 30° the sine is ½.
    /// ```
    /// let v = carom_num::Vec2::at_angle(30_f64.to_radians());
    /// assert!((v.y - 0.5).abs() <= f64::EPSILON && (v.norm() - 1.0).abs() <= f64::EPSILON);
    /// ```
    #[inline]
    pub fn at_angle(angle: f64) -> Self {
        let (s, c) = sin_cos(angle);
        Self { x: c, y: s }
    }

    /// Scalar product.
    #[inline]
    pub fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y
    }

    /// The out-of-plane component of the vector product, `x₁y₂ − y₁x₂`.
    ///
    /// # Example
    /// The area of the parallelogram of two vectors, positive where the second one lies to the left.
    /// ```
    /// use carom_num::Vec2;
    /// let (a, b) = (Vec2::new(3.0, 1.0), Vec2::new(1.0, 2.0));
    /// assert_eq!((a.cross(b), b.cross(a)), (5.0, -5.0));
    /// ```
    #[inline]
    pub fn cross(self, other: Self) -> f64 {
        self.x * other.y - self.y * other.x
    }

    /// Turned by +90° (counter-clockwise).
    ///
    /// # Example
    /// ```
    /// use carom_num::Vec2;
    /// assert_eq!(Vec2::new(3.0, 1.0).turned_left(), Vec2::new(-1.0, 3.0));
    /// ```
    #[inline]
    pub fn turned_left(self) -> Self {
        Self { x: -self.y, y: self.x }
    }

    /// Turned by −90° (clockwise): the tangent of a contact is its normal turned so.
    ///
    /// # Example
    /// The normal of a level floor points up, its tangent to the right.
    /// ```
    /// use carom_num::Vec2;
    /// assert_eq!(Vec2::new(0.0, 1.0).turned_right(), Vec2::new(1.0, 0.0));
    /// ```
    #[inline]
    pub fn turned_right(self) -> Self {
        Self { x: self.y, y: -self.x }
    }

    /// Turned by the angle whose cosine and sine are given.
    ///
    /// # Example
    /// ```
    /// use carom_num::Vec2;
    /// // The angle of the triangle with sides 3, 4 and 5.
    /// assert_eq!(Vec2::new(5.0, 0.0).rotated(0.6, 0.8), Vec2::new(3.0, 4.0));
    /// ```
    #[inline]
    pub fn rotated(self, cos: f64, sin: f64) -> Self {
        Self { x: cos * self.x - sin * self.y, y: sin * self.x + cos * self.y }
    }

    /// Length, in the unit of the components.
    #[inline]
    pub fn norm(self) -> f64 {
        self.dot(self).sqrt()
    }

    /// This vector scaled to length 1, or `None` where it has no direction.
    ///
    /// # Example
    /// ```
    /// use carom_num::Vec2;
    /// assert_eq!(Vec2::new(3.0, 4.0).unit(), Some(Vec2::new(0.6, 0.8)));
    /// assert_eq!(Vec2::ZERO.unit(), None);
    /// ```
    #[inline]
    pub fn unit(self) -> Option<Self> {
        let length = self.norm();
        (length > 0.0 && length.is_finite()).then(|| self / length)
    }

    /// True where both components are finite.
    #[inline]
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite()
    }
}

impl Add for Vec2 {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        Self::new(self.x + o.x, self.y + o.y)
    }
}

impl Sub for Vec2 {
    type Output = Self;
    #[inline]
    fn sub(self, o: Self) -> Self {
        Self::new(self.x - o.x, self.y - o.y)
    }
}

impl AddAssign for Vec2 {
    #[inline]
    fn add_assign(&mut self, o: Self) {
        *self = *self + o;
    }
}

impl SubAssign for Vec2 {
    #[inline]
    fn sub_assign(&mut self, o: Self) {
        *self = *self - o;
    }
}

impl Neg for Vec2 {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y)
    }
}

impl Mul<f64> for Vec2 {
    type Output = Self;
    #[inline]
    fn mul(self, k: f64) -> Self {
        Self::new(self.x * k, self.y * k)
    }
}

impl Mul<Vec2> for f64 {
    type Output = Vec2;
    #[inline]
    fn mul(self, v: Vec2) -> Vec2 {
        v * self
    }
}

impl Div<f64> for Vec2 {
    type Output = Self;
    #[inline]
    fn div(self, k: f64) -> Self {
        Self::new(self.x / k, self.y / k)
    }
}
