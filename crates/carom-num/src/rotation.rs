//! Rotations in space, as unit quaternions.

use crate::elementary::sin_cos;
use crate::tolerance::SMALL_ANGLE;
use crate::{Mat3, Vec3};

/// A rotation of a body's axes into the world's, as a unit quaternion `w + x i + y j + z k`.
///
/// # Example
/// A third of a turn about the diagonal of a cube takes each axis to the next: w = cos 60°, and each part of
/// v is sin 60°/√3.
/// ```
/// use carom_num::{Rotation, Vec3};
/// let third = Rotation { w: 0.5, v: Vec3::new(0.5, 0.5, 0.5) };
/// assert_eq!([Vec3::X, Vec3::Y, Vec3::Z].map(|axis| third.apply(axis)), [Vec3::Y, Vec3::Z, Vec3::X]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotation {
    /// Cosine of half the angle.
    pub w: f64,
    /// The axis, as long as the sine of half the angle.
    pub v: Vec3,
}

impl Default for Rotation {
    fn default() -> Self {
        Self::NONE
    }
}

impl Rotation {
    /// No rotation.
    ///
    /// # Example
    /// ```
    /// use carom_num::{Rotation, Vec3};
    /// let r = Vec3::new(1.0, 2.0, 3.0);
    /// assert_eq!(Rotation::NONE.apply(r), r);
    /// ```
    pub const NONE: Self = Self { w: 1.0, v: Vec3::ZERO };

    /// The rotation by the vector's length [rad] about it, right-handed.
    ///
    /// # Example
    /// ```
    /// use carom_num::{Rotation, Vec3};
    /// let quarter = Rotation::by(Vec3::Z * 90_f64.to_radians());
    /// assert!((quarter.apply(Vec3::X) - Vec3::Y).norm() < 4.0 * f64::EPSILON);
    /// ```
    pub fn by(vector: Vec3) -> Self {
        let half = 0.5 * vector.norm();
        let (sin, cos) = sin_cos(half);
        let quotient = if half < SMALL_ANGLE { 0.5 * (1.0 - half * half / 6.0) } else { 0.5 * sin / half };
        Self { w: cos, v: vector * quotient }
    }

    /// The rotation of these four numbers (w, x, y, z), scaled to length 1; `None` where they are all zero or not finite.
    ///
    /// # Example
    /// ```
    /// use carom_num::{Rotation, Vec3};
    /// let third = Rotation::of([1.0; 4]).unwrap();
    /// assert_eq!((third.w, third.v), (0.5, Vec3::new(0.5, 0.5, 0.5)));
    /// assert_eq!(Rotation::of([0.0; 4]), None);
    /// ```
    pub fn of([w, x, y, z]: [f64; 4]) -> Option<Self> {
        let norm = (w * w + x * x + y * y + z * z).sqrt();
        (norm > 0.0 && norm.is_finite()).then(|| Self { w: w / norm, v: Vec3::new(x, y, z) / norm })
    }

    /// The four numbers (w, x, y, z).
    pub fn to_array(self) -> [f64; 4] {
        [self.w, self.v.x, self.v.y, self.v.z]
    }

    /// This rotation after another one.
    ///
    /// # Example
    /// Half a turn about y, then one about x, is one about z. In the other order it is the opposite
    /// quaternion, which is the same rotation.
    /// ```
    /// use carom_num::{Rotation, Vec3};
    /// let [x, y, z] = [Vec3::X, Vec3::Y, Vec3::Z].map(|v| Rotation { w: 0.0, v });
    /// assert_eq!(x.after(y), z);
    /// assert_eq!((y.after(x).w, y.after(x).v), (0.0, -z.v));
    /// ```
    pub fn after(self, first: Self) -> Self {
        Self {
            w: self.w * first.w - self.v.dot(first.v),
            v: first.v * self.w + self.v * first.w + self.v.cross(first.v),
        }
    }

    /// The rotation back.
    ///
    /// # Example
    /// ```
    /// use carom_num::{Rotation, Vec3};
    /// let third = Rotation { w: 0.5, v: Vec3::new(0.5, 0.5, 0.5) };
    /// assert_eq!(third.inverse().apply(Vec3::Y), Vec3::X);
    /// assert_eq!(third.inverse().after(third), Rotation::NONE);
    /// ```
    pub fn inverse(self) -> Self {
        Self { w: self.w, v: -self.v }
    }

    /// A vector of the body's axes, in the world's.
    ///
    /// # Example
    /// ```
    /// use carom_num::{Rotation, Vec3};
    /// let third = Rotation { w: 0.5, v: Vec3::new(0.5, 0.5, 0.5) };
    /// assert_eq!(third.apply(Vec3::new(1.0, 2.0, 3.0)), Vec3::new(3.0, 1.0, 2.0));
    /// ```
    pub fn apply(self, r: Vec3) -> Vec3 {
        let t = self.v.cross(r) * 2.0;
        r + t * self.w + self.v.cross(t)
    }

    /// A vector of the world's axes, in the body's.
    ///
    /// # Example
    /// ```
    /// use carom_num::{Rotation, Vec3};
    /// let third = Rotation { w: 0.5, v: Vec3::new(0.5, 0.5, 0.5) };
    /// assert_eq!(third.undo(Vec3::new(3.0, 1.0, 2.0)), Vec3::new(1.0, 2.0, 3.0));
    /// ```
    pub fn undo(self, r: Vec3) -> Vec3 {
        self.inverse().apply(r)
    }

    /// Its matrix: the body's axes, in the world's, are the columns.
    ///
    /// # Example
    /// ```
    /// use carom_num::{Mat3, Rotation, Vec3};
    /// let third = Rotation { w: 0.5, v: Vec3::new(0.5, 0.5, 0.5) };
    /// assert_eq!(third.matrix(), Mat3::of_columns(Vec3::Y, Vec3::Z, Vec3::X));
    /// ```
    pub fn matrix(self) -> Mat3 {
        Mat3::of_columns(self.apply(Vec3::X), self.apply(Vec3::Y), self.apply(Vec3::Z))
    }

    /// A symmetric matrix of the body's axes, in the world's: `R a Rᵀ`.
    ///
    /// # Example
    /// The moment of inertia about the body's x-axis is that about the world's y-axis once x has been turned
    /// to y.
    /// ```
    /// use carom_num::{Mat3, Rotation, Vec3};
    /// let third = Rotation { w: 0.5, v: Vec3::new(0.5, 0.5, 0.5) };
    /// assert_eq!(third.turn(Mat3::diagonal(1.0, 2.0, 3.0)), Mat3::diagonal(3.0, 1.0, 2.0));
    /// ```
    pub fn turn(self, a: Mat3) -> Mat3 {
        let r = self.matrix();
        r.product(a).product(r.transposed())
    }

    /// The rates of the four numbers where the body turns with `spin` [rad/s] in its own axes: `q̇ = ½ q ω`.
    ///
    /// # Example
    /// At 2 rad/s about z, half the angle grows by 1 rad/s, and its sine too at the start.
    /// ```
    /// use carom_num::{Rotation, Vec3};
    /// assert_eq!(Rotation::NONE.rate(Vec3::Z * 2.0), [0.0, 0.0, 0.0, 1.0]);
    /// ```
    pub fn rate(self, spin: Vec3) -> [f64; 4] {
        let v = spin * self.w + self.v.cross(spin);
        [-0.5 * self.v.dot(spin), 0.5 * v.x, 0.5 * v.y, 0.5 * v.z]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(a: Vec3, b: Vec3) -> bool {
        (a - b).norm() < 4e-16 * (1.0 + a.norm() + b.norm())
    }

    #[test]
    fn a_quarter_turn_about_z_takes_x_to_y() {
        let quarter = Rotation::by(Vec3::Z * std::f64::consts::FRAC_PI_2);
        assert!(near(quarter.apply(Vec3::X), Vec3::Y));
        assert!(near(quarter.undo(Vec3::Y), Vec3::X));
        assert!(near(quarter.matrix() * Vec3::X, Vec3::Y));
    }

    #[test]
    fn rotations_compose_as_their_matrices() {
        let (a, b) = (Rotation::by(Vec3::new(0.3, -1.2, 0.5)), Rotation::by(Vec3::new(-2.0, 0.1, 1e-5)));
        let r = Vec3::new(0.4, 1.5, -0.2);
        assert!(near(a.after(b).apply(r), a.apply(b.apply(r))));
        assert!(near(a.after(b).apply(r), a.matrix() * (b.matrix() * r)));
        assert!(near(a.inverse().after(a).apply(r), r));
    }

    #[test]
    fn small_rotations_keep_their_digits() {
        for angle in [1e-12, 1.9e-4, 2.1e-4] {
            let r = Rotation::by(Vec3::X * angle);
            assert!((r.v.x - crate::elementary::sin(0.5 * angle)).abs() <= 2e-16 * angle, "{angle}");
        }
    }

    #[test]
    fn the_rate_is_that_of_turning_on() {
        let (q, spin) = (Rotation::by(Vec3::new(0.3, -1.2, 0.5)), Vec3::new(1.0, 2.0, -0.7));
        let h = 1e-6;
        let (ahead, back) = (q.after(Rotation::by(spin * h)), q.after(Rotation::by(-spin * h)));
        for ((rate, a), b) in q.rate(spin).into_iter().zip(ahead.to_array()).zip(back.to_array()) {
            assert!((rate - (a - b) / (2.0 * h)).abs() < 1e-9);
        }
    }
}
