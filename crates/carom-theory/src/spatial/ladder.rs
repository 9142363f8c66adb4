//! A ladder that slides down a smooth wall on a smooth floor.

use crate::OutsideDomain;
use crate::domain::{require, require_positive};

/// A uniform rod of the length ℓ, let go at the angle θ₀ from the floor. Its middle moves on a circle about the foot of the wall, so that
///
/// ```text
/// ω² = (3 g/ℓ) (sin θ₀ − sin θ),      N_wall ∝ 3 sin θ − 2 sin θ₀
/// ```
///
/// It leaves the wall where `sin θ = ⅔ sin θ₀`, and goes on with the speed along the floor that it has there.
///
/// Source: a problem of most textbooks of rigid body dynamics. Derived here: the motion from the energy, the force at the wall from the acceleration of the middle.
///
/// # Example
/// ```
/// use carom_theory::spatial::Ladder;
/// let ladder = Ladder { length: 3.0, start: 90f64.to_radians(), gravity: 9.0 };
/// let leaves = ladder.leaves_the_wall()?;
/// assert!((leaves.sine - 2.0 / 3.0).abs() < 1e-15 && (leaves.spin - 3f64.sqrt()).abs() < 1e-15);
/// # Ok::<(), carom_theory::OutsideDomain>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ladder {
    /// ℓ > 0 \[m\].
    pub length: f64,
    /// θ₀ in (0, π/2] \[rad\].
    pub start: f64,
    /// g > 0 [m/s²].
    pub gravity: f64,
}

/// Where a ladder leaves the wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeavesWall {
    /// sin θ.
    pub sine: f64,
    /// ω \[rad/s\].
    pub spin: f64,
    /// Of the middle, along the floor [m/s].
    pub speed: f64,
}

impl Ladder {
    /// Where it leaves the wall, and how it moves there.
    ///
    /// # Errors
    /// The first quantity outside its domain.
    pub fn leaves_the_wall(&self) -> Result<LeavesWall, OutsideDomain> {
        require_positive("length", self.length)?;
        require_positive("start", self.start)?;
        require(self.start <= std::f64::consts::FRAC_PI_2, "start", self.start, "<= pi/2")?;
        require_positive("gravity", self.gravity)?;
        let first = libm::sin(self.start);
        let sine = 2.0 / 3.0 * first;
        let spin = (3.0 * self.gravity / self.length * (first - sine)).sqrt();
        Ok(LeavesWall { sine, spin, speed: 0.5 * self.length * spin * sine })
    }
}
