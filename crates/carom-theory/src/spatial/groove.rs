//! A part in a straight groove of two like flanks: sliding along it, resting in it, and wedged.

use crate::OutsideDomain;
use crate::domain::{require, require_not_negative, require_positive};

/// A groove whose flanks rise by φ from its bottom line, which descends by α. The part touches both flanks evenly and does not tip.
///
/// *Sliding along it* each flank carries `N = m g cos α / (2 cos φ)`, so that friction brakes as with the coefficient μ/cos φ.
///
/// *At rest* friction may also act across the groove, down each flank by T: then the flanks carry more, `N cos φ = m g cos α / 2 + T sin φ`, as they do
/// under a part that has been pressed in. The most that two cones `F² + T² ≤ μ² N²` can hold along the groove is found at `T = μ N · μ tan φ`:
///
/// ```text
/// F ≤ μ m g cos α / (2 cos φ √(1 − μ² tan² φ))
/// ```
///
/// Between the slope of the first and that of the second both are consistent: a part that rests stays, and one that slides goes on. From `μ tan φ = 1` on a part
/// is wedged whatever the slope: the half angle between the flanks, 90° − φ, is the angle of friction.
///
/// Source: the statics of the wedge under Coulomb's friction, as in any textbook of engineering mechanics for T = 0 (the V belt) and for the wedging angle;
/// the bound between them is derived here.
///
/// # Example
/// Flanks of 45° and μ = 3/5: sliding starts to slow down below a slope of 0.6 √2, and a part that is pressed in rests up to 0.75 √2.
/// ```
/// use carom_theory::spatial::Groove;
/// let groove = Groove { flank: 45f64.to_radians(), friction: 0.6 };
/// assert!((groove.braking()? - 0.6 * 2f64.sqrt()).abs() < 1e-15);
/// assert!((groove.holding()? - 0.75 * 2f64.sqrt()).abs() < 1e-14);
/// # Ok::<(), carom_theory::OutsideDomain>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Groove {
    /// φ in (0, π/2), of each flank from the bottom \[rad\].
    pub flank: f64,
    /// μ ≥ 0.
    pub friction: f64,
}

impl Groove {
    fn check(&self) -> Result<(), OutsideDomain> {
        require_positive("flank", self.flank)?;
        require(self.flank < std::f64::consts::FRAC_PI_2, "flank", self.flank, "< pi/2")?;
        require_not_negative("friction", self.friction)
    }

    /// What friction brakes a sliding part with, in units of `g cos α`: it is accelerated by `g (sin α − this cos α)`.
    ///
    /// # Errors
    /// The first quantity outside its domain.
    pub fn braking(&self) -> Result<f64, OutsideDomain> {
        self.check()?;
        Ok(self.friction / libm::cos(self.flank))
    }

    /// The tangent of the largest slope on which a part can rest; infinite where it is wedged.
    ///
    /// # Errors
    /// The first quantity outside its domain.
    ///
    /// # Example
    /// ```
    /// use carom_theory::spatial::Groove;
    /// let steep = Groove { flank: 60f64.to_radians(), friction: 0.6 };
    /// assert_eq!(steep.holding()?, f64::INFINITY);
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn holding(&self) -> Result<f64, OutsideDomain> {
        let across = self.friction * libm::tan(self.flank);
        let braking = self.braking()?;
        Ok(if across < 1.0 { braking / (1.0 - across * across).sqrt() } else { f64::INFINITY })
    }
}
