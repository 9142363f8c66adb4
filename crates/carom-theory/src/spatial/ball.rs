//! A ball that slides and rolls: on a plane, and in a groove.

use super::Groove;
use crate::OutsideDomain;
use crate::domain::{require, require_not_negative, require_positive};

/// A ball whose mass centre is its middle, with the moment `J = k m ρ²` about every axis: k is 2/5 of a solid ball, 2/3 of a thin shell.
///
/// *In a groove* whose flanks rise by φ from its bottom line it touches at two places, `ρ cos φ` below its middle: it rolls about the line through them. A plane is
/// the groove with φ = 0. Down a slope α
///
/// ```text
/// a = g sin α / (1 + k/cos² φ),      tan α ≤ h (cos² φ + k)/k
/// ```
///
/// as long as friction can turn it: h is what holds a part that does not roll ([`Groove::holding`]).
///
/// *On a level plane* a ball that slips with the speed u is braked by μ g, and what touches is turned after by μ g/k: the slip keeps its direction, and it rolls after
/// the time `u / (μ g (1 + 1/k))`.
///
/// Source: as in any textbook of rigid body dynamics for a plane; the groove is derived here in the same way.
///
/// # Example
/// A solid ball rolls down a plane with 5/7 of what it would slide with, up to a slope of 7/2 μ.
/// ```
/// use carom_theory::spatial::Ball;
/// let ball = Ball { radius: 0.1, share: 0.4, friction: 0.2, gravity: 10.0 };
/// let slope = 30f64.to_radians();
/// assert!((ball.rolls_down(0.0, slope)? - 5.0 / 1.4).abs() < 1e-14);
/// assert!((ball.steepest(0.0)? - 0.7).abs() < 1e-15);
/// // Thrown without spin at 7 m/s it rolls after one second, with 5/7 of that.
/// assert!((ball.grips_after(7.0)? - 1.0).abs() < 1e-15);
/// # Ok::<(), carom_theory::OutsideDomain>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// ρ > 0 \[m\].
    pub radius: f64,
    /// k in (0, 2/3].
    pub share: f64,
    /// μ ≥ 0.
    pub friction: f64,
    /// g > 0 [m/s²].
    pub gravity: f64,
}

impl Ball {
    fn check(&self) -> Result<(), OutsideDomain> {
        require_positive("radius", self.radius)?;
        require_positive("share", self.share)?;
        require(self.share <= 2.0 / 3.0, "share", self.share, "<= 2/3")?;
        require_not_negative("friction", self.friction)?;
        require_positive("gravity", self.gravity)
    }

    /// `cos² φ` of flanks.
    fn square(flank: f64) -> Result<f64, OutsideDomain> {
        require_not_negative("flank", flank)?;
        require(flank < std::f64::consts::FRAC_PI_2, "flank", flank, "< pi/2")?;
        Ok(libm::cos(flank) * libm::cos(flank))
    }

    /// What it is accelerated with while it rolls in a groove with flanks φ down a slope α \[rad\]; its middle [m/s²].
    ///
    /// # Errors
    /// The first quantity outside its domain.
    pub fn rolls_down(&self, flank: f64, slope: f64) -> Result<f64, OutsideDomain> {
        self.check()?;
        Ok(self.gravity * libm::sin(slope) / (1.0 + self.share / Self::square(flank)?))
    }

    /// How far its middle goes for a turn by one radian in a groove with flanks φ \[m\].
    ///
    /// # Errors
    /// The first quantity outside its domain.
    pub fn lever(&self, flank: f64) -> Result<f64, OutsideDomain> {
        self.check()?;
        Ok(self.radius * Self::square(flank)?.sqrt())
    }

    /// The tangent of the steepest slope of a groove with flanks φ down which it can roll from rest; infinite where it is wedged.
    ///
    /// # Errors
    /// The first quantity outside its domain.
    pub fn steepest(&self, flank: f64) -> Result<f64, OutsideDomain> {
        self.check()?;
        let square = Self::square(flank)?;
        let holds =
            if flank == 0.0 { self.friction } else { Groove { flank, friction: self.friction }.holding()? };
        Ok(holds * (square + self.share) / self.share)
    }

    /// How long it slips on a level plane where its lowest point starts to slip with a speed \[s\].
    ///
    /// # Errors
    /// The first quantity outside its domain.
    pub fn grips_after(&self, slip: f64) -> Result<f64, OutsideDomain> {
        self.check()?;
        require_not_negative("slip", slip)?;
        Ok(slip / (self.friction * self.gravity * (1.0 + 1.0 / self.share)))
    }
}
