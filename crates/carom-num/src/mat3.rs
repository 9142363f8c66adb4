//! A 3 × 3 matrix.

use crate::Vec3;
use std::ops::{Add, Mul, Sub};

/// A 3 × 3 matrix, by its rows.
///
/// # Example
/// ```
/// use carom_num::{Mat3, Vec3};
/// let m = Mat3 { rows: [Vec3::new(1.0, 2.0, 0.0), Vec3::new(0.0, 1.0, 0.0), Vec3::Z] };
/// assert_eq!(m * Vec3::new(3.0, 4.0, 5.0), Vec3::new(11.0, 4.0, 5.0));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mat3 {
    /// Its rows.
    pub rows: [Vec3; 3],
}

impl Mat3 {
    /// The matrix of zeros.
    ///
    /// # Example
    /// ```
    /// use carom_num::{Mat3, Vec3};
    /// assert_eq!(Mat3::ZERO * Vec3::new(3.0, 4.0, 5.0), Vec3::ZERO);
    /// ```
    pub const ZERO: Self = Self { rows: [Vec3::ZERO; 3] };
    /// The unit matrix.
    ///
    /// # Example
    /// ```
    /// use carom_num::{Mat3, Vec3};
    /// let v = Vec3::new(3.0, 4.0, 5.0);
    /// assert_eq!(Mat3::IDENTITY * v, v);
    /// ```
    pub const IDENTITY: Self = Self { rows: [Vec3::X, Vec3::Y, Vec3::Z] };

    /// The matrix with these entries on its diagonal.
    ///
    /// # Example
    /// ```
    /// use carom_num::{Mat3, Vec3};
    /// let m = Mat3::diagonal(1.0, 2.0, 3.0);
    /// assert_eq!(m * Vec3::new(4.0, 5.0, 6.0), Vec3::new(4.0, 10.0, 18.0));
    /// ```
    pub const fn diagonal(x: f64, y: f64, z: f64) -> Self {
        Self { rows: [Vec3::new(x, 0.0, 0.0), Vec3::new(0.0, y, 0.0), Vec3::new(0.0, 0.0, z)] }
    }

    /// The matrix with these columns.
    ///
    /// # Example
    /// The columns are where the axes go.
    /// ```
    /// use carom_num::{Mat3, Vec3};
    /// let (a, b, c) = (Vec3::new(1.0, 2.0, 3.0), Vec3::new(4.0, 5.0, 6.0), Vec3::new(7.0, 8.0, 9.0));
    /// let m = Mat3::of_columns(a, b, c);
    /// assert_eq!([m * Vec3::X, m * Vec3::Y, m * Vec3::Z], [a, b, c]);
    /// ```
    pub const fn of_columns(a: Vec3, b: Vec3, c: Vec3) -> Self {
        Self { rows: [Vec3::new(a.x, b.x, c.x), Vec3::new(a.y, b.y, c.y), Vec3::new(a.z, b.z, c.z)] }
    }

    /// The matrix that takes v to `a × v`.
    ///
    /// # Example
    /// ```
    /// use carom_num::{Mat3, Vec3};
    /// let (a, v) = (Vec3::new(1.0, 2.0, 3.0), Vec3::new(4.0, 5.0, 6.0));
    /// assert_eq!(Mat3::crossing(a) * v, a.cross(v));
    /// ```
    pub const fn crossing(a: Vec3) -> Self {
        Self { rows: [Vec3::new(0.0, -a.z, a.y), Vec3::new(a.z, 0.0, -a.x), Vec3::new(-a.y, a.x, 0.0)] }
    }

    /// The dyad `a bᵀ`.
    ///
    /// # Example
    /// `a bᵀ v = a (b·v)`.
    /// ```
    /// use carom_num::{Mat3, Vec3};
    /// let (a, b, v) = (Vec3::new(1.0, 2.0, 3.0), Vec3::new(4.0, 5.0, 6.0), Vec3::new(1.0, -1.0, 1.0));
    /// assert_eq!(Mat3::dyad(a, b) * v, a * 5.0);
    /// ```
    pub fn dyad(a: Vec3, b: Vec3) -> Self {
        Self { rows: [b * a.x, b * a.y, b * a.z] }
    }

    /// Its transpose.
    ///
    /// # Example
    /// A vector product turns its sign where its factors are exchanged, and so does its matrix.
    /// ```
    /// use carom_num::{Mat3, Vec3};
    /// let a = Vec3::new(1.0, 2.0, 3.0);
    /// assert_eq!(Mat3::crossing(a).transposed(), Mat3::crossing(-a));
    /// ```
    pub const fn transposed(self) -> Self {
        let [a, b, c] = self.rows;
        Self::of_columns(a, b, c)
    }

    /// Its determinant.
    ///
    /// # Example
    /// ```
    /// use carom_num::{Mat3, Vec3};
    /// assert_eq!(Mat3::diagonal(2.0, 3.0, 4.0).determinant(), 24.0);
    /// assert_eq!(Mat3::of_columns(Vec3::Y, Vec3::X, Vec3::Z).determinant(), -1.0, "a mirror");
    /// ```
    pub fn determinant(self) -> f64 {
        let [a, b, c] = self.rows;
        a.dot(b.cross(c))
    }

    /// Its inverse by cofactors; `None` where the determinant is zero or not finite.
    ///
    /// # Example
    /// ```
    /// use carom_num::{Mat3, Vec3};
    /// assert_eq!(Mat3::diagonal(2.0, 4.0, 8.0).inverse(), Some(Mat3::diagonal(0.5, 0.25, 0.125)));
    /// assert_eq!(Mat3::dyad(Vec3::X, Vec3::Y).inverse(), None, "it is of rank 1");
    /// ```
    pub fn inverse(self) -> Option<Self> {
        let [a, b, c] = self.rows;
        let determinant = self.determinant();
        let inverse = Self::of_columns(b.cross(c), c.cross(a), a.cross(b)) * (1.0 / determinant);
        (determinant != 0.0 && inverse.is_finite()).then_some(inverse)
    }

    /// The product of two matrices: what this one does after the other.
    ///
    /// # Example
    /// `z × (z × v)` takes away what is across z, and turns it round.
    /// ```
    /// use carom_num::{Mat3, Vec3};
    /// let across = Mat3::crossing(Vec3::Z);
    /// assert_eq!(across.product(across), Mat3::diagonal(-1.0, -1.0, 0.0));
    /// ```
    pub fn product(self, o: Self) -> Self {
        let columns = o.transposed().rows.map(|column| self * column);
        Self::of_columns(columns[0], columns[1], columns[2])
    }

    /// True where all entries are finite.
    pub fn is_finite(self) -> bool {
        self.rows.iter().all(|row| row.is_finite())
    }
}

impl Mul<Vec3> for Mat3 {
    type Output = Vec3;
    #[inline]
    fn mul(self, v: Vec3) -> Vec3 {
        let [a, b, c] = self.rows;
        Vec3::new(a.dot(v), b.dot(v), c.dot(v))
    }
}

impl Mul<f64> for Mat3 {
    type Output = Self;
    #[inline]
    fn mul(self, k: f64) -> Self {
        Self { rows: self.rows.map(|row| row * k) }
    }
}

impl Add for Mat3 {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        Self { rows: std::array::from_fn(|i| self.rows[i] + o.rows[i]) }
    }
}

impl Sub for Mat3 {
    type Output = Self;
    #[inline]
    fn sub(self, o: Self) -> Self {
        Self { rows: std::array::from_fn(|i| self.rows[i] - o.rows[i]) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_inverse_undoes() {
        let a =
            Mat3 { rows: [Vec3::new(2.0, -1.0, 0.5), Vec3::new(0.3, 3.0, 1.0), Vec3::new(-1.0, 0.2, 4.0)] };
        let unit = a.product(a.inverse().expect("it is regular"));
        let error = (unit - Mat3::IDENTITY).rows.map(Vec3::norm);
        assert!(error.into_iter().all(|e| e < 1e-15), "{unit:?}");
        assert_eq!(Mat3::dyad(Vec3::X, Vec3::Y).inverse(), None);
    }

    #[test]
    fn crossing_is_the_vector_product() {
        let (a, b) = (Vec3::new(0.3, -2.0, 0.7), Vec3::new(1.1, 0.4, -0.9));
        assert_eq!(Mat3::crossing(a) * b, a.cross(b));
    }
}
