//! Between the strikes: a body that turns about a corner under gravity.

use super::rimless_wheel_ratio;
use crate::OutsideDomain;
use crate::domain::{require, require_not_negative, require_positive};
use core::f64::consts::{FRAC_PI_2, PI};

/// A body that turns about a corner that neither slides nor lifts.
///
/// # Example
/// A ring on a point of its rim, J = mR²: p² = g/(2R).
/// ```
/// let ring = carom_theory::rocking::Pivoting { mass: 4.0, inertia: 1.0, reach: 0.5, gravity: 10.0 };
/// assert_eq!(ring.stiffness(), 10.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pivoting {
    /// m > 0 \[kg\].
    pub mass: f64,
    /// J > 0 about the mass centre [kg m²].
    pub inertia: f64,
    /// R > 0, from the corner to the mass centre \[m\].
    pub reach: f64,
    /// g > 0 [m/s²].
    pub gravity: f64,
}

/// Panels of Simpson's rule: the integrands here are smooth, and this many leave rounding only.
const PANELS: u32 = 4096;

impl Pivoting {
    /// Checks that every quantity lies in its domain.
    ///
    /// # Errors
    ///
    /// The first quantity outside its domain.
    ///
    /// # Example
    /// ```
    /// use carom_theory::rocking::Pivoting;
    /// let flat = Pivoting { mass: 4.0, inertia: 1.0, reach: 0.0, gravity: 10.0 };
    /// assert_eq!(flat.check().map_err(|error| error.quantity), Err("reach"));
    /// assert_eq!(Pivoting { reach: 0.5, ..flat }.check(), Ok(()));
    /// ```
    pub fn check(&self) -> Result<(), OutsideDomain> {
        require_positive("mass", self.mass)?;
        require_positive("inertia", self.inertia)?;
        require_positive("reach", self.reach)?;
        require_positive("gravity", self.gravity)
    }

    /// `p² = mgR/(J + mR²)` [1/s²]: φ̈ = p² sin φ, φ from the upright over the corner.
    ///
    /// # Example
    /// ```
    /// // Housner's block, J = mR²/3: p² = 3g/(4R)
    /// let block = carom_theory::rocking::Pivoting { mass: 3.0, inertia: 1.0, reach: 1.0, gravity: 8.0 };
    /// assert_eq!(block.stiffness(), 6.0);
    /// ```
    pub fn stiffness(&self) -> f64 {
        let Self { mass: m, inertia: j, reach: r, gravity: g } = *self;
        m * g * r / (j + m * r * r)
    }

    /// Time in which a block that leaves its flat pose with the rate ω > 0, rising over its corner, is back there \[s\].
    ///
    /// ```text
    /// T = (2/p) ∫₀ᵁ du/√(1 − k² cosh² u),   k² = sin²(α/2) − ω²/(4p²),   sinh U = ω/(2pk)
    /// ```
    ///
    /// α is the angle from the upright to R in the flat pose, tan α = width/height.
    ///
    /// # Errors
    /// A quantity outside its domain; `roll rate` where the block would overturn, `ω² ≥ 4p² sin²(α/2)`.
    ///
    /// # Source
    /// The energy integral of Housner, Bull. Seismol. Soc. Am. 53 (1963) 403, in a form without singularity; derived here.
    ///
    /// # Example
    ///
    /// A slow block rises against the constant torque mgR sin α: T = 2ω/(p² sin α).
    ///
    /// ```
    /// let block = carom_theory::rocking::Pivoting { mass: 3.0, inertia: 1.0, reach: 1.0, gravity: 8.0 };
    /// let time = block.swing_time(0.5, 1e-6)?;
    /// assert!((time * 6.0 * 0.5f64.sin() / 2e-6 - 1.0).abs() < 1e-9);
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn swing_time(&self, alpha: f64, roll_rate: f64) -> Result<f64, OutsideDomain> {
        self.check()?;
        require(alpha > 0.0 && alpha < FRAC_PI_2, "alpha", alpha, "0 < alpha < pi/2")?;
        require_not_negative("roll rate", roll_rate)?;
        let p = self.stiffness().sqrt();
        let (half, rise) = (libm::sin(0.5 * alpha), roll_rate / (2.0 * p));
        require(rise < half, "roll rate", roll_rate, "too slow to overturn")?;
        let modulus = (half - rise) * (half + rise);
        let end = libm::asinh(rise / modulus.sqrt());
        let integrand = |u: f64| {
            let sinh = libm::sinh(u);
            1.0 / (1.0 - modulus * (1.0 + sinh * sinh)).sqrt()
        };
        Ok(2.0 / p * simpson(integrand, end))
    }

    /// Rate with which a block that starts from rest, tilted by θ < α over its corner, comes down flat: `√(2p²(cos(α−θ) − cos α))`
    /// [rad/s].
    ///
    /// # Example
    /// ```
    /// let block = carom_theory::rocking::Pivoting { mass: 3.0, inertia: 1.0, reach: 1.0, gravity: 8.0 };
    /// let alpha = 60f64.to_radians(); // from upright: 12 (1 − 1/2)
    /// assert!((block.falling_rate(alpha, alpha) - 6f64.sqrt()).abs() < 1e-15);
    /// ```
    pub fn falling_rate(&self, alpha: f64, tilt: f64) -> f64 {
        // cos(α−θ) − cos α = 2 sin(α − θ/2) sin(θ/2)
        2.0 * (self.stiffness() * libm::sin(alpha - 0.5 * tilt) * libm::sin(0.5 * tilt)).sqrt()
    }
}

/// ∫₀ᵉ f by Simpson's rule.
fn simpson(f: impl Fn(f64) -> f64, end: f64) -> f64 {
    let h = end / f64::from(PANELS);
    let inner: f64 = (1..PANELS).map(|i| if i % 2 == 1 { 4.0 } else { 2.0 } * f(h * f64::from(i))).sum();
    (f(0.0) + inner + f(end)) * h / 3.0
}

/// Rate [rad/s] with which a rimless wheel of n spokes of length R strikes, step after step, when it rolls down a slope for long.
///
/// ```text
/// ω*² = 4p² sin θ sin γ/(1 − η²),   θ = π/n,   η = ω⁺/ω⁻ = (j + cos 2θ)/(1 + j),   p² = g/(R(1 + j))
/// ```
///
/// Each step ω² goes to η²ω² + 4p² sin θ sin γ: the distance of ω² from its fixed point shrinks by η².
///
/// # Errors
/// A quantity outside its domain; `slope` where the wheel does not get over the next spoke, `η²ω*² ≤ 2p²(1 − cos(θ−γ))` with γ < θ.
///
/// # Limits
/// The spokes neither slip nor lift.
///
/// # Source
/// McGeer, Int. J. Robotics Res. 9 (1990) 62.
///
/// # Example
///
/// A ring with four spokes (j = 1, η = 1/2) on a slope of 30°: ω*² = 4 (g/2R) (1/√2)(1/2)/(3/4).
///
/// ```
/// let rate = carom_theory::rocking::rimless_wheel_speed(4, 1.0, [2.0, 9.0], 30f64.to_radians())?;
/// assert!((rate * rate - 4.0 * 2.25 * 0.5f64.sqrt() * 0.5 / 0.75).abs() < 1e-14);
/// # Ok::<(), carom_theory::OutsideDomain>(())
/// ```
pub fn rimless_wheel_speed(
    spokes: u32,
    inertia_ratio: f64,
    [radius, gravity]: [f64; 2],
    slope: f64,
) -> Result<f64, OutsideDomain> {
    require(spokes >= 3, "spokes", f64::from(spokes), ">= 3")?;
    require_not_negative("inertia ratio", inertia_ratio)?;
    require_positive("radius", radius)?;
    require_positive("gravity", gravity)?;
    require(slope > 0.0 && slope < FRAC_PI_2, "slope", slope, "0 < slope < pi/2")?;
    let half = PI / f64::from(spokes);
    let ratio = rimless_wheel_ratio(spokes, inertia_ratio);
    let stiffness = gravity / (radius * (1.0 + inertia_ratio));
    let kept = ratio * ratio;
    let square = 4.0 * stiffness * libm::sin(half) * libm::sin(slope) / (1.0 - kept);
    let over = libm::sin(0.5 * (half - slope).max(0.0));
    require(ratio > 0.0 && kept * square > 4.0 * stiffness * over * over, "slope", slope, "steep enough")?;
    Ok(square.sqrt())
}
