//! A disc whose mass centre is not its middle, a cam, that rolls on level ground.
//!
//! e is the distance of the mass centre from the middle, φ the angle of the mass centre from its lowest place, ω = φ̇. The mass centre is R − e cos φ
//! above the ground, and the contact is the centre of rotation.
//!
//! ```text
//! I(φ) = J + m (R² + e² − 2Re cos φ),   I ω²/2 − m g e cos φ is constant,   I ω̇ = −m e sin φ (g + R ω²)
//! N = m (g + e (ω̇ sin φ + ω² cos φ)),   F = m (R ω̇ − e (ω̇ cos φ − ω² sin φ))
//! ```
//!
//! Source: the laws of Newton and Euler, the moment about the contact. A loaded hoop that hops is in Tokieda, "The hopping hoop", Amer. Math.
//! Monthly 104 (1997) 152.

use crate::OutsideDomain;
use crate::domain::{require, require_not_negative, require_positive};

/// The disc and its mass.
///
/// # Example
/// A hoop of 1 kg and 1 m with its mass centre halfway out: while the mass centre is beside the middle, I = 1 + 1 + 1/4.
/// ```
/// use carom_theory::eccentric_disc::EccentricDisc;
/// let cam = EccentricDisc { mass: 1.0, inertia: 1.0, radius: 1.0, eccentricity: 0.5, gravity: 10.0 };
/// assert_eq!(cam.inertia_about_contact(std::f64::consts::FRAC_PI_2), 2.25);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EccentricDisc {
    /// m > 0 \[kg\].
    pub mass: f64,
    /// J > 0 about the mass centre [kg m²].
    pub inertia: f64,
    /// R > 0 \[m\].
    pub radius: f64,
    /// e, 0 ≤ e ≤ R \[m\].
    pub eccentricity: f64,
    /// g ≥ 0 [m/s²].
    pub gravity: f64,
}

impl EccentricDisc {
    fn check(&self) -> Result<(), OutsideDomain> {
        require_positive("mass", self.mass)?;
        require_positive("inertia", self.inertia)?;
        require_positive("radius", self.radius)?;
        let within = self.eccentricity >= 0.0 && self.eccentricity <= self.radius;
        require(within, "eccentricity", self.eccentricity, "0 <= eccentricity <= radius")?;
        require_not_negative("gravity", self.gravity)
    }

    /// I about the point in touch, at φ [kg m²].
    pub fn inertia_about_contact(&self, angle: f64) -> f64 {
        let (r, e) = (self.radius, self.eccentricity);
        self.inertia + self.mass * (r * r + e * e - 2.0 * r * e * libm::cos(angle))
    }

    /// |ω| at an angle, of a disc that rolls through another angle with a spin [1/s]; none where it does not come so high.
    ///
    /// # Errors
    /// [`OutsideDomain`] for a disc that is none.
    ///
    /// # Example
    /// Let go with the mass centre beside the middle: at the lowest place `ω² = 2 m g e / I(0)`, `I(0) = 1 + 1/4`.
    /// ```
    /// use {carom_theory::eccentric_disc::EccentricDisc, std::f64::consts::FRAC_PI_2};
    /// let cam = EccentricDisc { mass: 1.0, inertia: 1.0, radius: 1.0, eccentricity: 0.5, gravity: 10.0 };
    /// assert!((cam.spin(0.0, (FRAC_PI_2, 0.0))?.unwrap().powi(2) - 8.0).abs() < 1e-14);
    /// assert_eq!(cam.spin(2.0, (FRAC_PI_2, 0.0))?, None, "it comes no higher than it was");
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn spin(&self, angle: f64, (from, spin): (f64, f64)) -> Result<Option<f64>, OutsideDomain> {
        self.check()?;
        let fall = self.mass * self.gravity * self.eccentricity * (libm::cos(angle) - libm::cos(from));
        let twice = self.inertia_about_contact(from) * spin * spin + 2.0 * fall;
        Ok((twice >= 0.0).then(|| (twice / self.inertia_about_contact(angle)).sqrt()))
    }

    /// N and F at an angle and a spin \[N\]: N below zero where the ground would have to pull, F along the way of the middle for ω > 0.
    ///
    /// # Errors
    /// [`OutsideDomain`] for a disc that is none.
    ///
    /// # Example
    /// At the lowest place N carries the weight and turns the mass centre's way: `m (g + e ω²)`.
    /// ```
    /// use carom_theory::eccentric_disc::EccentricDisc;
    /// let cam = EccentricDisc { mass: 2.0, inertia: 1.0, radius: 1.0, eccentricity: 0.5, gravity: 10.0 };
    /// assert_eq!(cam.forces(0.0, 4.0)?, [36.0, 0.0]);
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn forces(&self, angle: f64, spin: f64) -> Result<[f64; 2], OutsideDomain> {
        self.check()?;
        let (sin, cos) = libm::sincos(angle);
        let (m, e, g) = (self.mass, self.eccentricity, self.gravity);
        let moment = -m * e * sin * (g + self.radius * spin * spin);
        let angular = moment / self.inertia_about_contact(angle);
        let normal = m * (g + e * (angular * sin + spin * spin * cos));
        Ok([normal, m * (self.radius * angular - e * (angular * cos - spin * spin * sin))])
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use super::*;

    #[test]
    fn a_disc_with_its_mass_in_its_middle_rolls_on() {
        let disc = EccentricDisc { mass: 3.0, inertia: 0.5, radius: 0.4, eccentricity: 0.0, gravity: 9.81 };
        assert_eq!(disc.spin(1.3, (0.2, 7.0)).unwrap(), Some(7.0), "its spin stays");
        assert_eq!(disc.forces(1.3, 7.0).unwrap(), [3.0 * 9.81, 0.0], "it carries its weight");
    }

    #[test]
    fn the_angular_acceleration_is_the_rate_of_the_spin_of_the_energy() {
        let cam = EccentricDisc { mass: 1.2, inertia: 0.02, radius: 0.2, eccentricity: 0.12, gravity: 9.81 };
        let (angle, spin, step) = (1.1, 9.0, 1e-5);
        let at = |angle: f64| cam.spin(angle, (1.1, spin)).unwrap().unwrap();
        let rate = spin * (at(angle + step) - at(angle - step)) / (2.0 * step);
        let (sin, cos) = libm::sincos(angle);
        let expected = 1.2 * (9.81 + 0.12 * (rate * sin + spin * spin * cos));
        let [found, _] = cam.forces(angle, spin).unwrap();
        assert!((found - expected).abs() < 1e-7 * expected.abs(), "{found} {expected}");
    }

    #[test]
    fn what_is_no_disc_is_refused() {
        let cam = EccentricDisc { mass: 1.0, inertia: 1.0, radius: 1.0, eccentricity: 1.5, gravity: 10.0 };
        assert!(cam.spin(0.0, (0.0, 1.0)).is_err(), "its mass centre is outside");
        assert!(EccentricDisc { mass: 0.0, eccentricity: 0.5, ..cam }.forces(0.0, 1.0).is_err(), "no mass");
    }
}
