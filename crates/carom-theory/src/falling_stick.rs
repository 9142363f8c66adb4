//! A uniform thin stick that falls over: hinged or sticking at its foot, or with its foot on a frictionless floor.
//!
//! θ is the angle from the upright, L the length. Source: the problem is classical; see Cross, "The fall and bounce of pencils and other
//! elongated objects", Am. J. Phys. 74 (2006) 26.

/// Square of the spin of a stick that fell from rest at `start` to `tilt`, its foot fixed [rad²/s²].
///
/// ```text
/// θ̇² = (3g/L)(cos θ₀ − cos θ) = (6g/L) sin((θ−θ₀)/2) sin((θ+θ₀)/2)
/// ```
///
/// The product form keeps its digits just after the release.
///
/// # Example
/// ```
/// use carom_theory::falling_stick::spin_squared_foot_fixed;
/// let ninety = std::f64::consts::FRAC_PI_2;
/// assert!((spin_squared_foot_fixed(9.8, 1.0, 0.0, ninety) - 3.0 * 9.8).abs() < 1e-13);
/// ```
pub fn spin_squared_foot_fixed(gravity: f64, length: f64, start: f64, tilt: f64) -> f64 {
    6.0 * gravity / length * libm::sin(0.5 * (tilt - start)) * libm::sin(0.5 * (tilt + start))
}

/// Force of the floor on a stick that fell from the upright with its foot fixed, per weight: `(forward, upward)`.
///
/// ```text
/// N/(mg) = (3 cos θ − 1)²/4,   F/(mg) = (3/4) sin θ (3 cos θ − 2)
/// ```
///
/// F is positive in the direction in which the stick falls. The forward force changes sign at cos θ = 2/3 and the foot carries nothing at cos θ = 1/3.
///
/// # Limits
/// Without a hinge the foot stays only while |F| ≤ μN; then it slips backward (small μ, before cos θ = 2/3) or forward.
///
/// # Example
/// ```
/// use carom_theory::falling_stick::floor_force_foot_fixed;
/// let (forward, upward) = floor_force_foot_fixed((2.0f64 / 3.0).acos());
/// assert!(forward.abs() < 1e-15 && (upward - 0.25).abs() < 1e-15);
/// ```
pub fn floor_force_foot_fixed(tilt: f64) -> (f64, f64) {
    let (sin, cos) = libm::sincos(tilt);
    let root = 3.0 * cos - 1.0;
    (0.75 * sin * (3.0 * cos - 2.0), 0.25 * root * root)
}

/// The largest friction that a stick asks for behind its foot as it falls from the upright, and the tilt at which it does: `(tilt, F/N)`.
///
/// ```text
/// d(F/N)/dθ = 0:   11 cos θ = 9,   F/N = 15 √10/128
/// ```
///
/// With less friction than this the foot slips backward; with more it sticks until it slips forward, beyond cos θ = 2/3.
///
/// # Example
/// ```
/// use carom_theory::falling_stick::{floor_force_foot_fixed, most_friction_behind};
/// let (tilt, most) = most_friction_behind();
/// let (forward, upward) = floor_force_foot_fixed(tilt);
/// assert!((forward / upward - most).abs() < 1e-15 && (most - 0.370_579).abs() < 1e-6);
/// ```
pub fn most_friction_behind() -> (f64, f64) {
    (libm::acos(9.0 / 11.0), 15.0 * libm::sqrt(10.0) / 128.0)
}

/// Square of the spin of a stick that fell from rest at `start` to `tilt`, its foot on a frictionless floor [rad²/s²].
///
/// ```text
/// θ̇² = (12g/L)(cos θ₀ − cos θ)/(1 + 3 sin²θ)
/// ```
///
/// # Example
/// ```
/// use carom_theory::falling_stick::spin_squared_smooth_floor;
/// let ninety = std::f64::consts::FRAC_PI_2;
/// assert!((spin_squared_smooth_floor(9.8, 1.0, 0.0, ninety) - 3.0 * 9.8).abs() < 1e-13);
/// ```
pub fn spin_squared_smooth_floor(gravity: f64, length: f64, start: f64, tilt: f64) -> f64 {
    let sin = libm::sin(tilt);
    4.0 * spin_squared_foot_fixed(gravity, length, start, tilt) / (1.0 + 3.0 * sin * sin)
}

/// Normal force on a stick with its foot on a frictionless floor, per weight.
///
/// ```text
/// N/(mg) = (1 − (L/2g) cos θ θ̇²)/(1 + 3 sin²θ)
/// ```
///
/// # Example
///
/// Released upright, it reaches the floor with a quarter of its weight on the foot.
///
/// ```
/// use carom_theory::falling_stick::floor_force_smooth;
/// let ninety = std::f64::consts::FRAC_PI_2;
/// assert!((floor_force_smooth(9.8, 1.0, ninety, 3.0 * 9.8) - 0.25).abs() < 1e-15);
/// ```
pub fn floor_force_smooth(gravity: f64, length: f64, tilt: f64, spin_squared: f64) -> f64 {
    let (sin, cos) = libm::sincos(tilt);
    (1.0 - 0.5 * length / gravity * cos * spin_squared) / (1.0 + 3.0 * sin * sin)
}
