//! The strike of a part's corner on a plate, by the two angles that decide its type.
//!
//! The plate's normal n points into the part, its tangent t is n turned a quarter clockwise. The *angle to the normal* leads from n to
//! the part's axis, from the striking corner towards the middle, positive where the middle lies on the side of −t; the *incidence* leads
//! from the inward normal −n to the corner's velocity, positive where the corner moves along +t. With t downhill these are the φ_K and
//! the incidence of a feeder's strike.

use carom_impact::planar::{ImpactType, single};
use carom_impact::{ImpactError, Law};
use carom_num::{Vec2, elementary::sin_cos};

/// A part with a corner: a rod, or a box with its length along the axis.
///
/// # Example
/// A rod that falls flat on one end: `W_nn = 4/m`, so that the end takes `m v/4` and the rod turns with `3
/// v/(2 ℓ)`.
/// ```
/// use carom_study::corner::Striker;
/// let (length, mass, inertia) = (0.1, 0.3, 2.5e-4);
/// let rod = Striker { length, height: 0.0, mass, inertia, friction: 0.15, restitution: 0.0 };
/// let strike = rod.strike([std::f64::consts::FRAC_PI_2, 0.0], 1.0, 0.0)?;
/// assert!((strike.spin - 15.0).abs() < 1e-12);
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Striker {
    /// Length along the axis [m].
    pub length: f64,
    /// Height across it [m]; 0 for a thin rod.
    pub height: f64,
    /// Mass [kg].
    pub mass: f64,
    /// Moment of inertia about the mass centre [kg m²].
    pub inertia: f64,
    /// Coulomb friction.
    pub friction: f64,
    /// Restitution by Poisson's law.
    pub restitution: f64,
}

/// What a strike leaves.
///
/// # Example
/// A mirror image turns the other way; a corner that moves away is not struck.
/// ```
/// use carom_study::corner::Striker;
/// let (length, mass, inertia) = (0.1, 0.3, 2.5e-4);
/// let rod = Striker { length, height: 0.0, mass, inertia, friction: 0.15, restitution: 0.0 };
/// let (left, right) = (rod.strike([0.7, -0.2], 1.5, 0.0)?, rod.strike([-0.7, 0.2], 1.5, 0.0)?);
/// assert_eq!((left.kind, left.spin), (right.kind, -right.spin));
/// assert_eq!(rod.strike([0.7, 3.0], 1.5, 0.0)?.kind, None);
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CornerStrike {
    /// The type of the impact; `None` where the corner does not approach.
    pub kind: Option<ImpactType>,
    /// Spin after, counter-clockwise where n points up [rad/s].
    pub spin: f64,
}

impl Striker {
    /// The strike at an angle to the normal and an incidence [rad], with a speed of the corner [m/s] and a spin before [rad/s],
    /// counter-clockwise where n points up.
    ///
    /// A box strikes with the corner that is lowest for its angle. Of the two corners at that end, this is the one on the side to which the middle of
    /// the axis leans.
    ///
    /// # Errors
    /// As [`single::resolve`].
    ///
    /// # Example
    /// An upright rod that falls straight on its end neither slips nor turns.
    /// ```
    /// use carom_impact::planar::ImpactType::SticksFromRest;
    /// use carom_study::corner::Striker;
    /// let rod = Striker { length: 0.1, height: 0.0, mass: 0.3, inertia: 2.5e-4, friction: 0.15, restitution: 0.0 };
    /// let strike = rod.strike([0.0, 0.0], 1.5, 0.0)?;
    /// assert_eq!((strike.kind, strike.spin), (Some(SticksFromRest), 0.0));
    /// # Ok::<(), carom_impact::ImpactError>(())
    /// ```
    pub fn strike(
        &self,
        [angle, incidence]: [f64; 2],
        speed: f64,
        spin: f64,
    ) -> Result<CornerStrike, ImpactError> {
        let (tangential, normal) = self.arm(angle);
        let (across, along) = sin_cos(incidence);
        let Self { mass: m, inertia: j, friction, restitution, .. } = *self;
        let contact = single::Contact {
            w_tt: 1.0 / m + normal * normal / j,
            w_tn: -tangential * normal / j,
            w_nn: 1.0 / m + tangential * tangential / j,
            slip: speed * across,
            normal: -speed * along,
            friction,
            restitution,
        };
        let out = single::resolve(&contact, Law::Poisson)?;
        // n is up and t to the right: the moment of (p_t, p_n) at the arm.
        let turned = (tangential * out.normal_impulse - normal * out.tangential_impulse) / j;
        Ok(CornerStrike { kind: out.kind, spin: spin + turned })
    }

    /// The corner from the mass centre, along t and n [m].
    fn arm(&self, angle: f64) -> (f64, f64) {
        let (sin, cos) = sin_cos(angle);
        let axis = Vec2::new(-sin, cos);
        // The lower of the two corners of the striking end.
        let side = if sin > 0.0 { 1.0 } else { -1.0 };
        let corner = axis * (-0.5 * self.length) + axis.turned_left() * (0.5 * self.height * side);
        (corner.x, corner.y)
    }
}
