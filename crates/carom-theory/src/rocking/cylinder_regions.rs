//! The boundary curves γ(f) between the states of a plastic strike of the rolling cylinder.

use crate::OutsideDomain;
use crate::domain::{require, require_not_negative};
use core::f64::consts::FRAC_PI_4;

/// The map of states over friction f and half angle γ, for one b = J/(m a²) in (0, 1].
///
/// ```text
/// f ≤ f*:  1 | γ₁₂ | 2 | γ₂₃ | 3 | γ₃₄ | 4          f > f*:  1 | γ₁₄ | 4
/// ```
///
/// All four curves meet at `f* = b/√(1 − b²)`, `cos 2γ* = −b`; for b = 1 they never do.
///
/// # Source
/// Polukoshko, Viba and others, for b = 1; γ₁₄ and f* derived here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CylinderRegions {
    b: f64,
}

impl CylinderRegions {
    /// The regions of a cylinder with this ratio of inertia, J/(m r²).
    ///
    /// # Errors
    ///
    /// An inertia ratio outside (0, 1].
    ///
    /// # Example
    /// ```
    /// use carom_theory::rocking::CylinderRegions;
    /// assert_eq!(CylinderRegions::new(1.5).map_err(|error| error.quantity), Err("inertia ratio"));
    /// assert!(CylinderRegions::new(1.0)?.quadruple_friction().is_infinite());
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn new(inertia_ratio: f64) -> Result<Self, OutsideDomain> {
        require(inertia_ratio > 0.0 && inertia_ratio <= 1.0, "inertia ratio", inertia_ratio, "0 < b <= 1")?;
        Ok(Self { b: inertia_ratio })
    }

    /// γ₁₂ = atan(f(1+b)/b) \[rad\]: up to it K sticks, if A separates.
    ///
    /// # Example
    /// A ring, b = 1: tan γ = 2f.
    /// ```
    /// let ring = carom_theory::rocking::CylinderRegions::new(1.0)?;
    /// assert!((ring.gripping(0.5).to_degrees() - 45.0).abs() < 1e-13);
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn gripping(&self, friction: f64) -> f64 {
        libm::atan(friction * (1.0 + self.b) / self.b)
    }

    /// γ₂₃ = 45° + atan(f)/2 \[rad\]: beyond it the slipping K presses A down.
    ///
    /// # Example
    /// ```
    /// let ring = carom_theory::rocking::CylinderRegions::new(1.0)?;
    /// assert!((ring.pressing(1.0).to_degrees() - (45.0 + 22.5)).abs() < 1e-13);
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn pressing(&self, friction: f64) -> f64 {
        FRAC_PI_4 + 0.5 * libm::atan(friction)
    }

    /// γ₃₄ = atan(((1+b)f² + b)/f) \[rad\]: beyond it the spin in the corner stops. Least at `f = √(b/(1+b))`, where its tangent is
    /// `2√(b(1+b))`.
    ///
    /// # Example
    /// b = 1/8: the least tangent is 2 √(9/64) = 3/4, at f = 1/3.
    /// ```
    /// let light = carom_theory::rocking::CylinderRegions::new(0.125)?;
    /// let least = light.stopping(1.0 / 3.0);
    /// assert!((least.tan() - 0.75).abs() < 1e-15);
    /// assert!(light.stopping(0.3) > least && light.stopping(0.4) > least);
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn stopping(&self, friction: f64) -> f64 {
        let f = friction;
        libm::atan2((1.0 + self.b) * f * f + self.b, f)
    }

    /// γ₁₄ = acos(−b)/2 \[rad\]: above f* the cylinder rolls over up to it, and stops beyond.
    ///
    /// # Example
    /// ```
    /// let disc = carom_theory::rocking::CylinderRegions::new(0.5)?;
    /// assert!((disc.rolling_over().to_degrees() - 60.0).abs() < 1e-13);
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn rolling_over(&self) -> f64 {
        0.5 * libm::acos(-self.b)
    }

    /// atan(1/f) \[rad\]: from it on the chord K–A lies in the friction cones, and the cylinder may wedge.
    ///
    /// # Example
    /// ```
    /// let disc = carom_theory::rocking::CylinderRegions::new(0.5)?;
    /// assert!((disc.wedging(1.0).to_degrees() - 45.0).abs() < 1e-13);
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn wedging(&self, friction: f64) -> f64 {
        libm::atan2(1.0, friction)
    }

    /// f* = b/√(1 − b²): above it states 2 and 3 do not occur. Infinite for b = 1.
    ///
    /// # Example
    /// b = 3/5: f* = (3/5)/(4/5).
    /// ```
    /// let body = carom_theory::rocking::CylinderRegions::new(0.6)?;
    /// assert!((body.quadruple_friction() - 0.75).abs() < 1e-15);
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn quadruple_friction(&self) -> f64 {
        self.b / ((1.0 - self.b) * (1.0 + self.b)).sqrt()
    }

    /// The boundaries that count at this friction, in the order of γ: three up to f*, one above.
    ///
    /// # Errors
    /// A friction that is negative or not finite.
    ///
    /// # Example
    /// ```
    /// let disc = carom_theory::rocking::CylinderRegions::new(0.5)?;
    /// assert_eq!((disc.active(0.5)?.len(), disc.active(0.6)?.len()), (3, 1)); // f* = 0.577
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn active(&self, friction: f64) -> Result<Vec<f64>, OutsideDomain> {
        require_not_negative("friction", friction)?;
        Ok(if friction > self.quadruple_friction() {
            vec![self.rolling_over()]
        } else {
            vec![self.gripping(friction), self.pressing(friction), self.stopping(friction)]
        })
    }
}
