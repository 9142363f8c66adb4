//! Three feet in a row that slide along it.

use crate::domain::{OutsideDomain, require, require_finite, require_not_negative, require_positive};

/// A rigid body on three equal springs in a row, all of which slide along it, each against a friction of its own.
///
/// A spring carries in proportion to how far the body sinks in there, `nᵢ = α + β sᵢ` with places s = −a, 0, a. The sum of all is the weight, and their
/// moment with the friction below the mass centre is zero, `Σ nᵢ (sᵢ − x − h μᵢ) = 0`:
///
/// `α = 1/3` and `β = α (3 x + h Σμ) / (2 a² − h a (μ₃ − μ₁))` of the weight.
///
/// Where an outer one would pull it is lifted, and the other two are a lever.
///
/// Source: the statics of a rigid bar on equal springs, with Coulomb's friction; derived here. The shares do not depend on the stiffness, however large.
///
/// # Example
/// Without friction a weight above the middle is shared evenly, and from 2/3 of the way on the far foot is lifted.
/// ```
/// use carom_theory::spatial::ThreeFeet;
/// let at = |ahead: f64| ThreeFeet { apart: 1.0, ahead, height: 0.5, friction: [0.0; 3] }.carried();
/// assert_eq!(at(0.0)?, [1.0 / 3.0; 3]);
/// assert_eq!(at(0.75)?, [0.0, 0.25, 0.75]);
/// # Ok::<(), carom_theory::OutsideDomain>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThreeFeet {
    /// a > 0, from each foot to the next \[m\].
    pub apart: f64,
    /// x, from the middle foot to below the mass centre, in the direction of the slip \[m\].
    pub ahead: f64,
    /// h ≥ 0, of the mass centre above the feet \[m\].
    pub height: f64,
    /// μ ≥ 0 of the rear, the middle and the front foot.
    pub friction: [f64; 3],
}

impl ThreeFeet {
    /// The shares of the weight that the rear, the middle and the front foot carry.
    ///
    /// # Errors
    /// [`OutsideDomain`] names the quantity; `ahead` where the body tips over a foot, `height` where friction jams it.
    ///
    /// # Example
    /// Only the rear foot is rough, h μ = a/2: it presses the body forward, which the middle foot does not feel.
    /// ```
    /// use carom_theory::spatial::ThreeFeet;
    /// let feet = ThreeFeet { apart: 1.0, ahead: 0.0, height: 1.0, friction: [0.5, 0.0, 0.0] };
    /// let [rear, middle, front] = feet.carried()?;
    /// assert!((rear - 4.0 / 15.0).abs() < 1e-15 && middle == 1.0 / 3.0 && (front - 0.4).abs() < 1e-15);
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn carried(&self) -> Result<[f64; 3], OutsideDomain> {
        let Self { apart: a, ahead: x, height: h, friction: [rear, middle, front] } = *self;
        require_positive("apart", a)?;
        require_finite("ahead", x)?;
        require_not_negative("height", h)?;
        self.friction.iter().try_for_each(|mu| require_not_negative("friction", *mu))?;
        let tilts = 2.0 * a * a - h * a * (front - rear);
        require(tilts > 0.0, "height", h, "h (mu of the front - mu of the rear) < 2 a")?;
        let even = 1.0 / 3.0;
        let grows = even * (3.0 * x + h * (rear + middle + front)) / tilts;
        let springs = [even - grows * a, even, even + grows * a];
        if springs.iter().all(|n| *n >= 0.0) {
            return Ok(springs);
        }
        // Arms of the two that are left about the mass centre, friction included: loads are inverse to them.
        let (outer, mu, at) = if grows > 0.0 { (2, front, a) } else { (0, rear, -a) };
        let (near, far) = (-x - h * middle, at - x - h * mu);
        require(near * far < 0.0, "ahead", x, "between the feet, with what friction adds")?;
        let mut lever = [0.0, far / (far - near), 0.0];
        lever[outer] = near / (near - far);
        Ok(lever)
    }
}
