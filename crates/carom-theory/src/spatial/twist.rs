//! A body that comes down flat on its supports while it spins about the plane's normal.
//!
//! Its n ≥ 2 supports lie evenly on a circle of radius a about the foot of the mass centre, and the normal is a principal axis: a rod on its ends, a
//! box or a cube on its corners. All supports take the same normal impulse, `m v/n` up to the end of compression and e times that after it, and slip
//! with `Ω a` along the circle. Their frictions make a couple:
//!
//! ```text
//! J dΩ = −μ a Σ dN sign Ω,   Σ N = m v (1 + e):   the spin is braked by B = μ m v a/J in compression and by e B in restitution
//! ```
//!
//! A spin that stops stays stopped: nothing drives it. So there are three outcomes, and every one is unique:
//!
//! | outcome | condition |
//! |---|---|
//! | slips throughout | `(1 + e) B < Ω` |
//! | stops in restitution | `B < Ω ≤ (1 + e) B` |
//! | stops in compression | `Ω ≤ B` |
//!
//! Source: derived here, from Routh's walk; the couple does not depend on the height of the mass centre because the frictions add up to nothing.

use crate::OutsideDomain;
use crate::domain::{require, require_finite, require_not_negative, require_positive};

/// A body that comes down flat while it spins.
///
/// # Example
/// Where the plane is smooth the spin stays.
/// ```
/// use carom_theory::spatial::Twist;
/// let rod = Twist {
///     mass: 1.0, inertia: 0.1, circle_radius: 0.5, approach: 1.0,
///     spin: 3.0, friction: 0.0, restitution: 0.5,
/// };
/// let after = rod.after()?;
/// assert_eq!((after.spin, after.rising), (3.0, 0.5));
/// # Ok::<(), carom_theory::OutsideDomain>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Twist {
    /// m > 0 \[kg\].
    pub mass: f64,
    /// J > 0, about the normal through the mass centre [kg m²].
    pub inertia: f64,
    /// a > 0, of the circle of supports \[m\].
    pub circle_radius: f64,
    /// v > 0, the approach [m/s].
    pub approach: f64,
    /// Ω, about the normal [rad/s].
    pub spin: f64,
    /// μ ≥ 0.
    pub friction: f64,
    /// e in [0, 1].
    pub restitution: f64,
}

/// Where the spin stops.
///
/// # Example
/// Compression takes μmva/J = 1 rad/s, restitution half of that.
/// ```
/// use carom_theory::spatial::{SpinStops, Twist};
/// let stops = |spin| {
///     let rod = Twist {
///         mass: 1.0, inertia: 0.125, circle_radius: 0.5, approach: 1.0,
///         spin, friction: 0.25, restitution: 0.5,
///     };
///     rod.after().map(|after| after.stops)
/// };
/// assert_eq!([stops(0.9), stops(1.4)], [Ok(SpinStops::InCompression), Ok(SpinStops::InRestitution)]);
/// assert_eq!(stops(1.6), Ok(SpinStops::Not));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum SpinStops {
    /// Not in this impact.
    Not,
    /// While the body rises.
    InRestitution,
    /// While it comes down.
    InCompression,
}

/// What a twist leaves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AfterTwist {
    /// Where the spin stops.
    pub stops: SpinStops,
    /// Spin after [rad/s].
    pub spin: f64,
    /// Velocity of the mass centre away from the plane after [m/s].
    pub rising: f64,
    /// Normal impulse of all supports together [N s].
    pub normal_impulse: f64,
    /// Friction of all supports together along the circle [N s].
    pub friction_impulse: f64,
}

impl Twist {
    /// The body after it has come down on all its supports at once.
    ///
    /// # Errors
    ///
    /// The first quantity outside its domain.
    ///
    /// # Example
    ///
    /// A rod of 1 kg and 1 m (J = 1/12 kg m²) comes down with 1 m/s and 3 rad/s; with μ = 1/5 and without restitution 6 μ = 1.2 rad/s are lost.
    ///
    /// ```
    /// use carom_theory::spatial::{SpinStops, Twist};
    /// let rod = Twist {
    ///     mass: 1.0, inertia: 1.0 / 12.0, circle_radius: 0.5, approach: 1.0,
    ///     spin: 3.0, friction: 0.2, restitution: 0.0,
    /// };
    /// let after = rod.after()?;
    /// assert!((after.spin - 1.8).abs() < 1e-15 && after.stops == SpinStops::Not);
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn after(&self) -> Result<AfterTwist, OutsideDomain> {
        require_positive("mass", self.mass)?;
        require_positive("inertia", self.inertia)?;
        require_positive("circle radius", self.circle_radius)?;
        require_positive("approach", self.approach)?;
        require_finite("spin", self.spin)?;
        require_not_negative("friction", self.friction)?;
        let e = self.restitution;
        require((0.0..=1.0).contains(&e), "restitution", e, "0 to 1")?;
        let (omega, sign) = (self.spin.abs(), 1.0_f64.copysign(self.spin));
        let normal_impulse = self.mass * self.approach * (1.0 + e);
        let brake = self.friction * self.mass * self.approach * self.circle_radius / self.inertia;
        let left = (omega - (1.0 + e) * brake).max(0.0);
        let stops = if left > 0.0 {
            SpinStops::Not
        } else if omega > brake {
            SpinStops::InRestitution
        } else {
            SpinStops::InCompression
        };
        Ok(AfterTwist {
            stops,
            spin: sign * left,
            rising: e * self.approach,
            normal_impulse,
            friction_impulse: -sign * (omega - left) * self.inertia / self.circle_radius,
        })
    }
}
