//! Principal values and axes of a symmetric matrix.

use crate::{Mat3, Vec3};

/// Rounds of rotations: each squares what is left beside the diagonal, so that six reach rounding.
const MOST_ROUNDS: u32 = 12;

/// The principal values of a symmetric matrix, ascending, and their unit axes; the axes are right-handed.
///
/// # Source
/// C. G. J. Jacobi, Journal für die reine und angewandte Mathematik 30 (1846) 51, one plane after the other.
///
/// # Example
/// ```
/// use carom_num::{Mat3, Vec3, principal::principal};
/// let m = Mat3 { rows: [Vec3::new(2.0, 1.0, 0.0), Vec3::new(1.0, 2.0, 0.0), Vec3::Z * 5.0] };
/// let (values, axes) = principal(m);
/// assert!((values[0] - 1.0).abs() < 1e-15 && (values[1] - 3.0).abs() < 1e-15 && values[2] == 5.0);
/// assert!((axes[1].x - axes[1].y).abs() < 1e-15);
/// ```
pub fn principal(m: Mat3) -> ([f64; 3], [Vec3; 3]) {
    let mut a = m.rows.map(Vec3::to_array);
    let mut axes = [Vec3::X, Vec3::Y, Vec3::Z];
    for _ in 0..MOST_ROUNDS {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            turn(&mut a, &mut axes, p, q);
        }
        if a[0][1] == 0.0 && a[0][2] == 0.0 && a[1][2] == 0.0 {
            break;
        }
    }
    let mut order = [0, 1, 2];
    order.sort_by(|i, j| a[*i][*i].total_cmp(&a[*j][*j]));
    let mut sorted = order.map(|i| axes[i]);
    // The sign that shows the largest component as positive.
    for axis in &mut sorted[..2] {
        let largest = axis.to_array().into_iter().max_by(|x, y| x.abs().total_cmp(&y.abs()));
        if largest.is_some_and(|x| x < 0.0) {
            *axis = -*axis;
        }
    }
    sorted[2] = sorted[0].cross(sorted[1]);
    (order.map(|i| a[i][i]), sorted)
}

/// Turns about the third axis until the entry (p, q) is zero.
fn turn(a: &mut [[f64; 3]; 3], axes: &mut [Vec3; 3], p: usize, q: usize) {
    let off = a[p][q];
    // What does not change the diagonal is rounding.
    if off.abs() <= f64::EPSILON * f64::EPSILON * (a[p][p].abs() + a[q][q].abs()) {
        (a[p][q], a[q][p]) = (0.0, 0.0);
        return;
    }
    let half = 0.5 * (a[q][q] - a[p][p]) / off;
    let t = 1.0_f64.copysign(half) / (half.abs() + (half * half + 1.0).sqrt());
    let c = 1.0 / (t * t + 1.0).sqrt();
    let s = t * c;
    a[p][p] -= t * off;
    a[q][q] += t * off;
    (a[p][q], a[q][p]) = (0.0, 0.0);
    let r = 3 - p - q;
    let (x, y) = (a[r][p], a[r][q]);
    (a[r][p], a[r][q]) = (c * x - s * y, s * x + c * y);
    (a[p][r], a[q][r]) = (a[r][p], a[r][q]);
    (axes[p], axes[q]) = (axes[p] * c - axes[q] * s, axes[p] * s + axes[q] * c);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Rotation;

    #[test]
    fn a_turned_matrix_has_the_same_values_and_turned_axes() {
        for values in [[1.0, 2.0, 2.5], [1.0, 1.0, 1.5], [0.001, 1.0, 1.0], [2.0, 2.0, 2.0]] {
            for vector in [Vec3::new(0.3, -1.1, 0.4), Vec3::new(2.0, 0.1, -0.7), Vec3::ZERO] {
                let turned = Rotation::by(vector).turn(Mat3::diagonal(values[0], values[1], values[2]));
                let (found, axes) = principal(turned);
                for k in 0..3 {
                    assert!((found[k] - values[k]).abs() < 4e-15, "{values:?}: {found:?}");
                    let image = turned * axes[k] - axes[k] * found[k];
                    assert!(image.norm() < 4e-15, "{values:?}, axis {k}: {image:?}");
                }
                assert!((axes[0].cross(axes[1]).dot(axes[2]) - 1.0).abs() < 4e-15, "right-handed");
            }
        }
    }
}
