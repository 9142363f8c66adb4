//! A body that slides flat on feet which lie evenly on a circle, under Coulomb friction on a level plane.
//!
//! Its n ≥ 3 feet have the distance a from the foot of the mass centre, which is h above the plane; the normal is a principal axis.
//!
//! *Straight on* all frictions are parallel, so how the feet share the weight does not matter to the motion: it is braked by μ g. To the moment μ m g h of the
//! friction belong the loads
//!
//! ```text
//! N_j = (m g/n) (1 + 2 (μ h/a) cos φ_j),   φ_j the angle of foot j from the direction of the slip
//! ```
//!
//! which are the only ones for three feet, and the shortest for more. The feet behind lift off where this is negative.
//!
//! *Turning in place* all feet carry m g/n and slip along the circle: the spin falls by `μ m g a/J` per second.
//!
//! Source: derived here, from the equations of equilibrium.

use crate::OutsideDomain;
use crate::domain::{require, require_finite, require_not_negative, require_positive};

/// A body that slides flat.
///
/// # Example
/// With μh/a = 1/2 the foot behind carries nothing: the body is about to tip.
/// ```
/// use carom_theory::spatial::FlatSlide;
/// let table = FlatSlide {
///     feet: 4, circle_radius: 0.5, centre_height: 1.0, mass: 8.0,
///     inertia: 1.0, friction: 0.25, gravity: 10.0,
/// };
/// assert_eq!((table.load(0.0)?, table.load(180f64.to_radians())?), (0.5, 0.0));
/// # Ok::<(), carom_theory::OutsideDomain>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlatSlide {
    /// n ≥ 3.
    pub feet: u32,
    /// a > 0, of the circle of feet \[m\].
    pub circle_radius: f64,
    /// h ≥ 0, of the mass centre above the plane \[m\].
    pub centre_height: f64,
    /// m > 0 \[kg\].
    pub mass: f64,
    /// J > 0, about the normal through the mass centre [kg m²].
    pub inertia: f64,
    /// μ > 0.
    pub friction: f64,
    /// g > 0 [m/s²].
    pub gravity: f64,
}

/// How a slide comes to rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToRest {
    /// How long it takes \[s\].
    pub time: f64,
    /// How far it goes \[m\], or turns \[rad\].
    pub way: f64,
}

impl FlatSlide {
    fn check(&self) -> Result<(), OutsideDomain> {
        require(self.feet >= 3, "feet", f64::from(self.feet), ">= 3")?;
        require_positive("circle radius", self.circle_radius)?;
        require_not_negative("centre height", self.centre_height)?;
        require_positive("mass", self.mass)?;
        require_positive("inertia", self.inertia)?;
        require_positive("friction", self.friction)?;
        require_positive("gravity", self.gravity)
    }

    /// Sliding straight on from a speed [m/s]: `t = v/(μ g)`, `s = v²/(2 μ g)`.
    ///
    /// # Errors
    /// The first quantity outside its domain.
    ///
    /// # Example
    /// ```
    /// use carom_theory::spatial::FlatSlide;
    /// let table = FlatSlide {
    ///     feet: 4, circle_radius: 0.5, centre_height: 0.4, mass: 8.0,
    ///     inertia: 1.0, friction: 0.25, gravity: 10.0,
    /// };
    /// let rest = table.straight(2.0)?;
    /// assert_eq!((rest.time, rest.way), (0.8, 0.8));
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn straight(&self, speed: f64) -> Result<ToRest, OutsideDomain> {
        self.check()?;
        require_not_negative("speed", speed)?;
        let brake = self.friction * self.gravity;
        Ok(ToRest { time: speed / brake, way: 0.5 * speed * speed / brake })
    }

    /// Turning in place with a spin \[rad/s\].
    ///
    /// # Errors
    /// The first quantity outside its domain.
    ///
    /// # Example
    /// The spin falls by μmga/J = 10 rad/s per second.
    /// ```
    /// use carom_theory::spatial::FlatSlide;
    /// let table = FlatSlide {
    ///     feet: 4, circle_radius: 0.5, centre_height: 0.4, mass: 8.0,
    ///     inertia: 1.0, friction: 0.25, gravity: 10.0,
    /// };
    /// let rest = table.turning(-2.0)?;
    /// assert_eq!((rest.time, rest.way), (0.2, -0.2));
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn turning(&self, spin: f64) -> Result<ToRest, OutsideDomain> {
        self.check()?;
        require_finite("spin", spin)?;
        let brake = self.friction * self.mass * self.gravity * self.circle_radius / self.inertia;
        Ok(ToRest { time: spin.abs() / brake, way: 0.5 * spin * spin.abs() / brake })
    }

    /// What a foot carries of the weight, as a fraction of it, while the body slides straight on; the foot lies at this angle from the direction of the slip
    /// \[rad\].
    ///
    /// # Errors
    /// The first quantity outside its domain.
    ///
    /// # Example
    /// The loads of four feet make up the weight, those ahead carry more.
    /// ```
    /// use carom_theory::spatial::FlatSlide;
    /// let table = FlatSlide {
    ///     feet: 4, circle_radius: 0.5, centre_height: 0.4, mass: 8.0,
    ///     inertia: 1.0, friction: 0.25, gravity: 10.0,
    /// };
    /// let load = |angle: f64| table.load(angle.to_radians());
    /// let [ahead, left, behind, right] = [load(0.0)?, load(90.0)?, load(180.0)?, load(270.0)?];
    /// assert!((ahead - 0.35).abs() < 1e-15 && (behind - 0.15).abs() < 1e-15);
    /// assert!((ahead + left + behind + right - 1.0).abs() < 1e-15);
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn load(&self, angle: f64) -> Result<f64, OutsideDomain> {
        self.check()?;
        require_finite("angle", angle)?;
        let lever = self.friction * self.centre_height / self.circle_radius;
        Ok((1.0 + 2.0 * lever * libm::cos(angle)) / f64::from(self.feet))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_loads_balance_weight_and_friction() {
        for feet in 3..8 {
            let slide = FlatSlide {
                feet,
                circle_radius: 0.3,
                centre_height: 0.2,
                mass: 1.7,
                inertia: 0.1,
                friction: 0.4,
                gravity: 9.81,
            };
            let (mut whole, mut ahead, mut aside) = (0.0, 0.0, 0.0);
            for j in 0..feet {
                let angle = 0.37 + std::f64::consts::TAU * f64::from(j) / f64::from(feet);
                let load = slide.load(angle).unwrap();
                whole += load;
                ahead += load * 0.3 * libm::cos(angle);
                aside += load * 0.3 * libm::sin(angle);
            }
            assert!((whole - 1.0).abs() < 1e-15, "{feet}: {whole}");
            assert!((ahead - 0.4 * 0.2).abs() < 1e-15 && aside.abs() < 1e-15, "{feet}: {ahead} {aside}");
        }
    }

    #[test]
    fn impossible_slides_are_refused() {
        let slide = FlatSlide {
            feet: 2,
            circle_radius: 0.3,
            centre_height: 0.2,
            mass: 1.0,
            inertia: 0.1,
            friction: 0.4,
            gravity: 9.81,
        };
        assert_eq!(slide.straight(1.0).unwrap_err().quantity, "feet");
        assert_eq!(FlatSlide { feet: 3, ..slide }.straight(-1.0).unwrap_err().quantity, "speed");
    }
}
