//! How far a point is from a curve that is given by a function which vanishes on it.

use super::Range;
use crate::tolerance::CURVE_DIFFERENCE;

/// The distance of a point from the curve on which `residual` is zero, in shares of the ranges, to first order: `|F|/|∇F|`.
///
/// Infinite where the function does not change.
///
/// # Limits
/// Good for points much nearer to the curve than its radius of curvature.
///
/// # Example
/// A point 0.001 outside of a circle of radius 1, in a plane of size 4.
/// ```
/// use carom_study::regions::{Range, distance};
/// let side = Range { from: -2.0, to: 2.0, count: 1 };
/// let off = distance([side, side], [0.0, 1.001], |x, y| x * x + y * y - 1.0);
/// assert!((off - 0.001 / 4.0).abs() < 2e-7);
/// ```
pub fn distance(ranges: [Range; 2], point: [f64; 2], mut residual: impl FnMut(f64, f64) -> f64) -> f64 {
    let slope = gradient(ranges, point, &mut residual);
    let size = (slope[0] * slope[0] + slope[1] * slope[1]).sqrt();
    if size > 0.0 { residual(point[0], point[1]).abs() / size } else { f64::INFINITY }
}

/// The direction across the curve at a point, of length 1 in shares of the ranges; `None` where the function does not change.
///
/// # Example
/// Across a circle is along its radius.
/// ```
/// use carom_study::regions::{Range, across};
/// let side = Range { from: -2.0, to: 2.0, count: 1 };
/// let way = across([side, side], [0.6, 0.8], |x, y| x * x + y * y - 1.0).unwrap();
/// assert!((way[0] - 0.6).abs() < 1e-9 && (way[1] - 0.8).abs() < 1e-9);
/// assert!(across([side, side], [0.6, 0.8], |_, _| 1.0).is_none());
/// ```
pub fn across(
    ranges: [Range; 2],
    point: [f64; 2],
    mut residual: impl FnMut(f64, f64) -> f64,
) -> Option<[f64; 2]> {
    let slope = gradient(ranges, point, &mut residual);
    let size = (slope[0] * slope[0] + slope[1] * slope[1]).sqrt();
    (size > 0.0).then(|| slope.map(|part| part / size))
}

/// Change per share of each range.
fn gradient(ranges: [Range; 2], point: [f64; 2], residual: &mut impl FnMut(f64, f64) -> f64) -> [f64; 2] {
    [0, 1].map(|axis| {
        let step = CURVE_DIFFERENCE * (ranges[axis].to - ranges[axis].from);
        let mut at = |by: f64| {
            let mut moved = point;
            moved[axis] += by;
            residual(moved[0], moved[1])
        };
        (at(step) - at(-step)) / (2.0 * CURVE_DIFFERENCE)
    })
}
