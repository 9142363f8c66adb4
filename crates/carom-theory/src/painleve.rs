//! Painlevé's paradox of a body that slides with one end on a rough plate.
//!
//! With θ as in [`crate::rod_on_plate`], the friction digging the end in, and `κ² = J/(mℓ²)`, `τ = tan θ`, the normal response is
//!
//! ```text
//! m A = 1 + (1 − μτ)/(κ²(1 + τ²)) < 0   ⇔   κ²τ² − μτ + 1 + κ² < 0
//! ```
//!
//! Source: Painlevé (1895); Champneys and Várkonyi, "The Painlevé paradox in contact mechanics", IMA J. Appl. Math. 81 (2016) 538
//! (arXiv:1601.03545), for a review.

/// `m A`, the mass times the normal acceleration per normal force of the end that friction digs in; negative in Painlevé's case.
///
/// ```text
/// m A = 1 + (1 − μτ)/(κ²(1 + τ²)) = 1 + cos θ (cos θ − μ sin θ)/κ²
/// ```
///
/// # Example
/// A rod that stands upright is pressed off by no friction, and one at 45° with μ = 1 neither.
/// ```
/// let upright = carom_theory::painleve::response(1.0 / 3.0, std::f64::consts::FRAC_PI_2, 5.0);
/// let leaning = carom_theory::painleve::response(1.0 / 3.0, std::f64::consts::FRAC_PI_4, 1.0);
/// assert!((upright - 1.0).abs() < 1e-14 && (leaning - 1.0).abs() < 1e-14);
/// ```
pub fn response(gyration_squared: f64, angle: f64, friction: f64) -> f64 {
    let (sin, cos) = libm::sincos(angle);
    1.0 + cos * (cos - friction * sin) / gyration_squared
}

/// Normal acceleration of the end without a contact force, in units of gravity; positive where the spin throws it off.
///
/// ```text
/// b = (ℓ ω²/g) sin θ − 1
/// ```
///
/// # Example
/// A rod that does not turn falls.
/// ```
/// assert_eq!(carom_theory::painleve::free_acceleration(1.2, 0.0), -1.0);
/// ```
pub fn free_acceleration(angle: f64, spin_ratio: f64) -> f64 {
    spin_ratio * spin_ratio * libm::sin(angle) - 1.0
}

/// Smallest friction with which Painlevé's case occurs at some angle, for `κ² = J/(mℓ²) > 0`.
///
/// ```text
/// μ = 2κ √(1 + κ²)
/// ```
///
/// # Example
///
/// A uniform slender rod that slides with its end has κ² = 1/3.
///
/// ```
/// assert!((carom_theory::painleve::critical_friction(1.0 / 3.0) - 4.0 / 3.0).abs() < 1e-15);
/// ```
pub fn critical_friction(gyration_squared: f64) -> f64 {
    2.0 * (gyration_squared * (1.0 + gyration_squared)).sqrt()
}

/// Angles θ from the plate between which Painlevé's case occurs, or `None` if the friction does not exceed the critical one.
///
/// ```text
/// tan θ = (μ ∓ √(μ² − 4κ²(1 + κ²)))/(2κ²)          uniform rod: (3μ ∓ √(9μ² − 16))/2
/// ```
///
/// The smaller root is formed from the product of the two, `(1 + κ²)/κ²`, and keeps its digits. Close to the critical friction the
/// width of the window loses half the digits of μ: compare the tangents, not the width.
///
/// # Example
/// ```
/// // μ = 5/3: tan θ = (5 ∓ 3)/2
/// let (low, high) = carom_theory::painleve::window(1.0 / 3.0, 5.0 / 3.0).expect("above 4/3");
/// assert!((low - 1f64.atan()).abs() < 1e-14 && (high - 4f64.atan()).abs() < 1e-14);
/// ```
pub fn window(gyration_squared: f64, friction: f64) -> Option<(f64, f64)> {
    let critical = critical_friction(gyration_squared);
    if friction.is_nan() || friction <= critical {
        return None;
    }
    let root = ((friction - critical) * (friction + critical)).sqrt();
    let high = (friction + root) / (2.0 * gyration_squared);
    let low = (1.0 + gyration_squared) / (gyration_squared * high);
    Some((libm::atan(low), libm::atan(high)))
}

/// The second critical friction of a uniform slender rod, 8/(3√3), where Génot and Brogliato's analysis of the approach to the
/// paradox changes its answer.
///
/// # Source
/// Génot and Brogliato, Eur. J. Mech. A/Solids 18 (1999) 653.
///
/// # Example
/// ```
/// assert!((carom_theory::painleve::genot_brogliato_friction() - 1.539_600_7).abs() < 1e-7);
/// ```
pub fn genot_brogliato_friction() -> f64 {
    8.0 / (3.0 * 3f64.sqrt())
}
