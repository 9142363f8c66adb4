//! Numbers drawn from bytes: ordinary ones most of the time, extreme but legal ones else.

use arbitrary::{Result, Unstructured};
use carom_num::Vec2;
use carom_num::elementary::{exp, ln};

/// Steps of a number between its ends.
const STEPS: f64 = 65_535.0;

/// A number from `low` to `high`, both of which are met.
pub(crate) fn between(u: &mut Unstructured<'_>, low: f64, high: f64) -> Result<f64> {
    Ok(low + (high - low) * f64::from(u.arbitrary::<u16>()?) / STEPS)
}

/// A positive number from `low` to `high`, its logarithm uniform.
pub(crate) fn magnitude(u: &mut Unstructured<'_>, low: f64, high: f64) -> Result<f64> {
    Ok(exp(between(u, ln(low), ln(high))?).clamp(low, high))
}

/// A number of either sign, or zero; its magnitude goes over `decades` powers of ten up to `largest`.
pub(crate) fn signed(u: &mut Unstructured<'_>, largest: f64, decades: i32) -> Result<f64> {
    Ok(match u.int_in_range(0..=8)? {
        0 => 0.0,
        1 => largest,
        2 => -largest,
        3 | 4 => between(u, -largest, largest)?,
        sign => {
            let size = magnitude(u, largest * 10.0_f64.powi(-decades), largest)?;
            if sign % 2 == 0 { size } else { -size }
        }
    })
}

/// A coefficient from 0 to `largest`, its ends more often than chance.
pub(crate) fn coefficient(u: &mut Unstructured<'_>, largest: f64) -> Result<f64> {
    Ok(match u.int_in_range(0..=5)? {
        0 => 0.0,
        1 => largest,
        2 => magnitude(u, 1e-12 * largest, largest)?,
        _ => between(u, 0.0, largest)?,
    })
}

/// A unit vector: along an axis more often than chance.
pub(crate) fn direction(u: &mut Unstructured<'_>) -> Result<Vec2> {
    Ok(match u.int_in_range(0..=6)? {
        0 => Vec2::new(0.0, 1.0),
        1 => Vec2::new(1.0, 0.0),
        2 => Vec2::new(-1.0, 0.0),
        3 => Vec2::new(0.0, -1.0),
        _ => Vec2::at_angle(between(u, -std::f64::consts::PI, std::f64::consts::PI)?),
    })
}
