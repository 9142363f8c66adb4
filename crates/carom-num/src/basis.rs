//! Orthonormal vectors, made one after the other.

use crate::solve::dot;

/// Orthonormal vectors of M numbers: what others span.
///
/// # Example
/// A plane is spanned by any two of three vectors in it.
/// ```
/// use carom_num::Basis;
/// let mut plane = Basis::NONE;
/// let new = [[3.0, 4.0, 0.0], [1.0, 0.0, 0.0], [0.0, 5.0, 0.0]].map(|v| plane.take(v, 1e-12));
/// assert_eq!(new, [true, true, false]);
/// assert_eq!(plane.axes()[0], [0.6, 0.8, 0.0]);
/// let [x, y, z] = plane.left([1.0, 2.0, 3.0]);
/// assert!(x.abs() < 1e-15 && y.abs() < 1e-15 && z == 3.0);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Basis<const M: usize> {
    axes: [[f64; M]; M],
    rank: usize,
}

impl<const M: usize> Basis<M> {
    /// That of nothing.
    pub const NONE: Self = Self { axes: [[0.0; M]; M], rank: 0 };

    /// The vectors.
    pub fn axes(&self) -> &[[f64; M]] {
        &self.axes[..self.rank]
    }

    /// What of a vector is across all of them.
    pub fn left(&self, mut v: [f64; M]) -> [f64; M] {
        // Twice is enough for rounding.
        for _ in 0..2 {
            for axis in self.axes() {
                let along = dot(&v, axis);
                v.iter_mut().zip(axis).for_each(|(v, a)| *v -= along * a);
            }
        }
        v
    }

    /// Takes in what of a vector is across all of them, if it is longer than `floor`. True if it is.
    pub fn take(&mut self, v: [f64; M], floor: f64) -> bool {
        let left = self.left(v);
        let length = dot(&left, &left).sqrt();
        let Some(place) = self.axes.get_mut(self.rank).filter(|_| length > floor) else { return false };
        *place = left.map(|l| l / length);
        self.rank += 1;
        true
    }
}
