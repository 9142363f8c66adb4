//! A vector in space.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A vector in space, right-handed: x × y = z.
///
/// # Example
/// ```
/// use carom_num::Vec3;
/// let (a, b) = (Vec3::new(1.0, 2.0, 3.0), Vec3 { x: 2.0, y: 0.0, z: -2.0 });
/// assert_eq!(2.0 * a - b / 2.0, Vec3::new(1.0, 4.0, 7.0));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vec3 {
    /// Component along x.
    pub x: f64,
    /// Component along y.
    pub y: f64,
    /// Component along z.
    pub z: f64,
}

impl Vec3 {
    /// The zero vector.
    ///
    /// # Example
    /// ```
    /// use carom_num::Vec3;
    /// let v = Vec3::new(1.0, 2.0, 3.0);
    /// assert_eq!((v + Vec3::ZERO, v - v), (v, Vec3::ZERO));
    /// ```
    pub const ZERO: Self = Self::new(0.0, 0.0, 0.0);
    /// The unit vector along x.
    ///
    /// # Example
    /// ```
    /// use carom_num::Vec3;
    /// assert_eq!((Vec3::X, Vec3::new(7.0, 8.0, 9.0).dot(Vec3::X)), (Vec3::Y.cross(Vec3::Z), 7.0));
    /// ```
    pub const X: Self = Self::new(1.0, 0.0, 0.0);
    /// The unit vector along y.
    ///
    /// # Example
    /// ```
    /// use carom_num::Vec3;
    /// assert_eq!((Vec3::Y, Vec3::new(7.0, 8.0, 9.0).dot(Vec3::Y)), (Vec3::Z.cross(Vec3::X), 8.0));
    /// ```
    pub const Y: Self = Self::new(0.0, 1.0, 0.0);
    /// The unit vector along z.
    ///
    /// # Example
    /// ```
    /// use carom_num::Vec3;
    /// assert_eq!((Vec3::Z, Vec3::new(7.0, 8.0, 9.0).dot(Vec3::Z)), (Vec3::X.cross(Vec3::Y), 9.0));
    /// ```
    pub const Z: Self = Self::new(0.0, 0.0, 1.0);

    /// A vector from its components.
    #[inline]
    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Self { x, y, z }
    }

    /// A vector from its components.
    #[inline]
    pub const fn from_array([x, y, z]: [f64; 3]) -> Self {
        Self::new(x, y, z)
    }

    /// Its components.
    #[inline]
    pub const fn to_array(self) -> [f64; 3] {
        [self.x, self.y, self.z]
    }

    /// Scalar product.
    #[inline]
    pub fn dot(self, o: Self) -> f64 {
        self.x * o.x + self.y * o.y + self.z * o.z
    }

    /// Vector product.
    ///
    /// # Example
    /// The velocity of a point at 2 m on the x-axis where a body turns with 3 rad/s about the z-axis.
    /// ```
    /// use carom_num::Vec3;
    /// assert_eq!((Vec3::Z * 3.0).cross(Vec3::X * 2.0), Vec3::Y * 6.0);
    /// ```
    #[inline]
    pub fn cross(self, o: Self) -> Self {
        Self::new(self.y * o.z - self.z * o.y, self.z * o.x - self.x * o.z, self.x * o.y - self.y * o.x)
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
    /// use carom_num::Vec3;
    /// assert_eq!((Vec3::Y * -4.0).unit(), Some(-Vec3::Y));
    /// assert_eq!(Vec3::ZERO.unit(), None);
    /// ```
    #[inline]
    pub fn unit(self) -> Option<Self> {
        let length = self.norm();
        (length > 0.0 && length.is_finite()).then(|| self / length)
    }

    /// Two unit vectors that are perpendicular to this unit vector and to each other; with it, in this order (first, second, this), they are
    /// right-handed. They change continuously with the vector but at `−z`.
    ///
    /// # Source
    /// Duff, Burgess, Christensen, Hery, Kensler, Liani and Villemin, J. Computer Graphics Techniques 6 (2017) 1.
    ///
    /// # Example
    /// ```
    /// use carom_num::Vec3;
    /// assert_eq!(Vec3::Z.tangents(), [Vec3::X, Vec3::Y]);
    /// let n = Vec3::new(2.0, 3.0, 6.0) / 7.0;
    /// let [a, b] = n.tangents();
    /// assert!((a.cross(b) - n).norm() < 4.0 * f64::EPSILON && a.dot(b).abs() < 4.0 * f64::EPSILON);
    /// ```
    pub fn tangents(self) -> [Self; 2] {
        let sign = 1.0_f64.copysign(self.z);
        let a = -1.0 / (sign + self.z);
        let b = self.x * self.y * a;
        [
            Self::new(1.0 + sign * self.x * self.x * a, sign * b, -sign * self.x),
            Self::new(b, sign + self.y * self.y * a, -self.y),
        ]
    }

    /// True where all components are finite.
    #[inline]
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.z.is_finite()
    }
}

impl Add for Vec3 {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        Self::new(self.x + o.x, self.y + o.y, self.z + o.z)
    }
}

impl Sub for Vec3 {
    type Output = Self;
    #[inline]
    fn sub(self, o: Self) -> Self {
        Self::new(self.x - o.x, self.y - o.y, self.z - o.z)
    }
}

impl AddAssign for Vec3 {
    #[inline]
    fn add_assign(&mut self, o: Self) {
        *self = *self + o;
    }
}

impl SubAssign for Vec3 {
    #[inline]
    fn sub_assign(&mut self, o: Self) {
        *self = *self - o;
    }
}

impl Neg for Vec3 {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}

impl Mul<f64> for Vec3 {
    type Output = Self;
    #[inline]
    fn mul(self, k: f64) -> Self {
        Self::new(self.x * k, self.y * k, self.z * k)
    }
}

impl Mul<Vec3> for f64 {
    type Output = Vec3;
    #[inline]
    fn mul(self, v: Vec3) -> Vec3 {
        v * self
    }
}

impl Div<f64> for Vec3 {
    type Output = Self;
    #[inline]
    fn div(self, k: f64) -> Self {
        Self::new(self.x / k, self.y / k, self.z / k)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_axes_are_right_handed() {
        assert_eq!(Vec3::X.cross(Vec3::Y), Vec3::Z);
        assert_eq!(Vec3::Y.cross(Vec3::Z), Vec3::X);
    }

    #[test]
    fn tangents_complete_a_right_handed_frame() {
        for (x, y, z) in
            [(0.0, 0.0, 1.0), (0.0, 0.0, -1.0), (0.3, -0.7, 0.2), (-1.0, 1e-9, -1e-12), (0.1, 0.2, -5.0)]
        {
            let n = Vec3::new(x, y, z).unit().expect("it has a direction");
            let [a, b] = n.tangents();
            for (value, wanted) in
                [(a.norm(), 1.0), (b.norm(), 1.0), (a.dot(b), 0.0), (a.dot(n), 0.0), (b.dot(n), 0.0)]
            {
                assert!((value - wanted).abs() < 4e-16, "{n:?}: {a:?} {b:?}");
            }
            assert!((a.cross(b) - n).norm() < 4e-16, "{n:?}: {a:?} {b:?}");
        }
    }
}
