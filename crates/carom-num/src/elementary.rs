//! The elementary functions, from one place: the same input gives the same bytes on every platform.
//!
//! They come from the `libm` crate, not from the platform (`docs/decisions/0001-elementary-functions.md`).
//! `sqrt`, `abs`, `floor` and the four operations are exact by IEEE 754 and are used as they are.

/// Sine and cosine of `x` [rad].
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
#[inline]
pub fn pow(x: f64, y: f64) -> f64 {
    libm::pow(x, y)
}

/// Exponential.
#[inline]
pub fn exp(x: f64) -> f64 {
    libm::exp(x)
}

/// Natural logarithm.
#[inline]
pub fn ln(x: f64) -> f64 {
    libm::log(x)
}
