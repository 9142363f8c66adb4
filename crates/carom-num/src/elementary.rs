//! The elementary functions, from one place: the same input gives the same bytes on every platform.
//!
//! They come from the `libm` crate, not from the platform (`docs/decisions/0001-elementary-functions.md`).
//! `sqrt`, `abs`, `floor` and the four operations are exact by IEEE 754 and are used as they are.

/// Sine and cosine of `x` [rad].
///
/// # Example
/// ```
/// let (sin, cos) = carom_num::elementary::sin_cos(60_f64.to_radians());
/// assert!((cos - 0.5).abs() <= f64::EPSILON && (sin * sin + cos * cos - 1.0).abs() <= f64::EPSILON);
/// ```
#[inline]
pub fn sin_cos(x: f64) -> (f64, f64) {
    libm::sincos(x)
}

/// Sine of `x` [rad].
#[inline]
pub fn sin(x: f64) -> f64 {
    libm::sin(x)
}

/// Cosine of `x` [rad].
#[inline]
pub fn cos(x: f64) -> f64 {
    libm::cos(x)
}

/// Tangent of `x` [rad].
#[inline]
pub fn tan(x: f64) -> f64 {
    libm::tan(x)
}

/// Angle of the vector (`x`, `y`) from the x-axis, in (−π, π] [rad].
///
/// # Example
/// ```
/// let third_quadrant = carom_num::elementary::atan2(-1.0, -1.0);
/// assert!((third_quadrant.to_degrees() + 135.0).abs() <= 135.0 * f64::EPSILON);
/// ```
#[inline]
pub fn atan2(y: f64, x: f64) -> f64 {
    libm::atan2(y, x)
}

/// Arc tangent [rad].
#[inline]
pub fn atan(x: f64) -> f64 {
    libm::atan(x)
}

/// Arc cosine [rad].
#[inline]
pub fn acos(x: f64) -> f64 {
    libm::acos(x)
}

/// `x` to the power `y`.
///
/// # Example
/// ```
/// use carom_num::elementary::pow;
/// assert_eq!((pow(2.0, 10.0), pow(2.0, -3.0), pow(9.0, 0.5)), (1024.0, 0.125, 3.0));
/// ```
#[inline]
pub fn pow(x: f64, y: f64) -> f64 {
    libm::pow(x, y)
}

/// Exponential.
///
/// # Example
/// ```
/// use carom_num::elementary::exp;
/// assert_eq!(exp(0.0), 1.0);
/// assert!((exp(3.0) * exp(-3.0) - 1.0).abs() <= 2.0 * f64::EPSILON);
/// ```
#[inline]
pub fn exp(x: f64) -> f64 {
    libm::exp(x)
}

/// Natural logarithm.
///
/// # Example
/// ```
/// use carom_num::elementary::ln;
/// assert_eq!(ln(1.0), 0.0);
/// assert!((ln(8.0) / ln(2.0) - 3.0).abs() <= 3.0 * f64::EPSILON);
/// ```
#[inline]
pub fn ln(x: f64) -> f64 {
    libm::log(x)
}
