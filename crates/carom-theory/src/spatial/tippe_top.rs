//! A ball whose mass centre is beside its middle, on a plane.

use crate::OutsideDomain;
use crate::domain::{require_finite, require_positive};

/// A ball of the radius ρ with its middle on its axis of symmetry, at a from the mass centre; the moments are C about that axis and A across. With θ the angle of the axis
/// from the normal of the plane, the place where it touches is at `r = a ẑ − ρ e` from the mass centre, e the normal.
///
/// Whatever friction does at that place, its moment has no part along r, and r turns with the axis: *Jellett's* quantity stays,
///
/// ```text
/// L · r = const
/// ```
///
/// Where the ball rolls, so do its energy and *Routh's* quantity,
///
/// ```text
/// ω_z² (A C + m C (a − ρ cos θ)² + m A ρ² sin² θ) = const
/// ```
///
/// Source: J. H. Jellett, A Treatise on the Theory of Friction (1872); E. J. Routh, The Advanced Part of a Treatise on the Dynamics of a System of Rigid Bodies (1884).
///
/// # Example
/// A top that stands upright and spins.
/// ```
/// use carom_theory::spatial::TippeTop;
/// let top = TippeTop { mass: 2.0, radius: 0.5, offset: 0.25, axial: 0.125, across: 0.0625 };
/// assert_eq!(top.jellett([0.0, 0.0, 8.0], [0.0, 0.0, 1.0])?, 0.125 * 8.0 * (0.25 - 0.5));
/// # Ok::<(), carom_theory::OutsideDomain>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TippeTop {
    /// m > 0 \[kg\].
    pub mass: f64,
    /// ρ > 0 \[m\].
    pub radius: f64,
    /// a, of the ball's middle from the mass centre along z of the body \[m\].
    pub offset: f64,
    /// C > 0 [kg m²].
    pub axial: f64,
    /// A > 0 [kg m²].
    pub across: f64,
}

impl TippeTop {
    fn check(&self, spin: [f64; 3], up: [f64; 3]) -> Result<(), OutsideDomain> {
        require_positive("mass", self.mass)?;
        require_positive("radius", self.radius)?;
        require_finite("offset", self.offset)?;
        require_positive("axial", self.axial)?;
        require_positive("across", self.across)?;
        spin.into_iter().try_for_each(|v| require_finite("spin", v))?;
        up.into_iter().try_for_each(|v| require_finite("up", v))
    }

    /// Jellett's quantity, of a spin \[rad/s\] and the plane's normal, both in body axes [kg m³/s].
    ///
    /// # Errors
    /// The first quantity outside its domain.
    pub fn jellett(&self, spin: [f64; 3], up: [f64; 3]) -> Result<f64, OutsideDomain> {
        self.check(spin, up)?;
        let momentum = [self.across * spin[0], self.across * spin[1], self.axial * spin[2]];
        let arm = [-self.radius * up[0], -self.radius * up[1], self.offset - self.radius * up[2]];
        Ok((0..3).map(|k| momentum[k] * arm[k]).sum())
    }

    /// Routh's quantity, of a spin \[rad/s\] and the plane's normal, both in body axes [kg² m⁴/s²].
    ///
    /// # Errors
    /// The first quantity outside its domain.
    pub fn routh(&self, spin: [f64; 3], up: [f64; 3]) -> Result<f64, OutsideDomain> {
        self.check(spin, up)?;
        let Self { mass, radius, offset, axial, across } = *self;
        let along = offset - radius * up[2];
        let aside = radius * radius * (up[0] * up[0] + up[1] * up[1]);
        Ok(spin[2] * spin[2] * (across * axial + mass * axial * along * along + mass * across * aside))
    }
}
