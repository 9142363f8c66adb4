//! A disc that rolls on its rim without slip, steadily: on a circle, or about a centre that stays.

use crate::OutsideDomain;
use crate::domain::{require, require_finite, require_positive};

/// A body of revolution that touches a level plane with a circle of the radius ρ about its mass centre. θ is the angle of its axis from the normal: 0 is flat, 90° upright.
///
/// It can roll so that θ stays, while what touches runs round with the rate Ω. The spin about its axis is then
///
/// ```text
/// ω = (A Ω cos θ − m g ρ cos θ/(Ω sin θ)) / (C + m ρ²)
/// ```
///
/// Its mass centre runs round a circle of the radius `ρ ω/Ω`. Where ω is 0 it stays: *Euler's disc*, of a thin disc `Ω² = 4 g/(ρ sin θ)`.
///
/// Source: E. J. Routh, The Advanced Part of a Treatise on the Dynamics of a System of Rigid Bodies (1884), on the hoop and the disc; derived again here.
///
/// # Example
/// A thin disc of 1 m at 30° from flat, at g = 9 m/s²: `Ω = √(4 · 9/½)`.
/// ```
/// use carom_theory::spatial::RollingDisc;
/// let disc = RollingDisc { mass: 2.0, radius: 1.0, axial: 1.0, across: 0.5, gravity: 9.0 };
/// let whirls = disc.whirls(30f64.to_radians())?;
/// assert!((whirls - 72f64.sqrt()).abs() < 1e-14);
/// assert!(disc.axial_spin(30f64.to_radians(), whirls)?.abs() < 1e-14);
/// # Ok::<(), carom_theory::OutsideDomain>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RollingDisc {
    /// m > 0 \[kg\].
    pub mass: f64,
    /// ρ > 0 \[m\].
    pub radius: f64,
    /// C > 0, about its axis [kg m²].
    pub axial: f64,
    /// A > 0, across it [kg m²].
    pub across: f64,
    /// g > 0 [m/s²].
    pub gravity: f64,
}

impl RollingDisc {
    fn check(&self, tilt: f64) -> Result<(), OutsideDomain> {
        require_positive("mass", self.mass)?;
        require_positive("radius", self.radius)?;
        require_positive("axial", self.axial)?;
        require_positive("across", self.across)?;
        require_positive("gravity", self.gravity)?;
        require_positive("tilt", tilt)?;
        require(tilt <= std::f64::consts::FRAC_PI_2, "tilt", tilt, "<= pi/2")
    }

    /// ω, where it rolls steadily at θ with Ω \[rad/s\].
    ///
    /// # Errors
    /// The first quantity outside its domain; Ω may be negative but not zero.
    pub fn axial_spin(&self, tilt: f64, rate: f64) -> Result<f64, OutsideDomain> {
        self.check(tilt)?;
        require_finite("rate", rate)?;
        require(rate != 0.0, "rate", rate, "not 0")?;
        let Self { mass, radius, axial, across, gravity } = *self;
        let (sine, cosine) = (libm::sin(tilt), libm::cos(tilt));
        let topples = mass * gravity * radius * cosine / (rate * sine);
        Ok((across * rate * cosine - topples) / (axial + mass * radius * radius))
    }

    /// Ω of a disc whose centre stays, at θ \[rad/s\].
    ///
    /// # Errors
    /// The first quantity outside its domain.
    pub fn whirls(&self, tilt: f64) -> Result<f64, OutsideDomain> {
        self.check(tilt)?;
        Ok((self.mass * self.gravity * self.radius / (self.across * libm::sin(tilt))).sqrt())
    }
}
