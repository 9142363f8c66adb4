//! A rolling, rocking or pivoting body that strikes with a second point while the first still touches.
//!
//! The body turns about contact A with the roll rate ω₀ > 0, forward (towards +x) and clockwise; y points up; the new contact is K
//! (B for the rod on two supports). `v = v_C + ω (r_y, −r_x)` for a point at r from the mass centre C. Impulses are of one strike;
//! gravity is neglected in it.
//!
//! The law is the staged one: N_K is the clock, friction opposes the present slip, A stays while its normal impulse is needed and
//! leaves otherwise; without restitution the strike ends when K no longer approaches. Every form here is the answer that an engine
//! for two contacts must give at e = 0. Where all impulses of the first phase are repeated R times in the second,
//! [`Strike::with_restitution`] continues it.
//!
//! Source of the states: Polukoshko, Viba and others, on simultaneous collisions of rolling bodies; the conditions and the impulses
//! were derived again, since some of the printed ones do not satisfy Coulomb's law.

mod borders;
mod classic;
mod cylinder;
mod cylinder_elastic;
mod cylinder_regions;
mod cylinder_rest;
mod cylinder_sliding;
mod pivoting;
mod prism;
mod rod;

pub use borders::Border;
pub use classic::{
    cylinder_ratio, cylinder_sticking_friction, housner_ratio, housner_sliding_friction,
    housner_sticking_friction, rimless_wheel_ratio, rimless_wheel_sticking_friction,
    solid_polygon_inertia_ratio, thin_walled_polygon_inertia_ratio,
};
pub use cylinder::{Cylinder, CylinderState};
pub use cylinder_elastic::CylinderEnd;
pub use cylinder_regions::CylinderRegions;
pub use cylinder_rest::RestImpulses;
pub use cylinder_sliding::SlidingState;
pub use pivoting::{Pivoting, rimless_wheel_speed};
pub use prism::{Prism, PrismState};
pub use rod::{RodState, SupportedRod};

/// Tangential impulses at the contacts A and K, along their forward tangents [N s].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tangential {
    /// At A and at K.
    Each([f64; 2]),
    /// Both stick on one plane: only the sum is determined.
    Sum(f64),
}

/// A strike with two contacts: motion before and after, and the impulses between.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strike {
    /// Velocity of the mass centre before [m/s].
    pub velocity_before: [f64; 2],
    /// Roll rate before [rad/s], clockwise.
    pub roll_rate_before: f64,
    /// Velocity of the mass centre after [m/s].
    pub velocity: [f64; 2],
    /// Roll rate after [rad/s], clockwise.
    pub roll_rate: f64,
    /// Normal impulses at A and K [N s].
    pub normal: [f64; 2],
    /// Tangential impulses.
    pub tangential: Tangential,
}

impl Strike {
    /// The strike with every impulse multiplied by 1 + R: `q⁺ = (1 + R) q₁ − R q₀`, where q₁ is the motion of this plastic strike.
    ///
    /// # Limits
    ///
    /// Poisson's law repeats every impulse in proportion only where nothing changes in the second phase: the rod on smooth supports
    /// (its variants 3 and 4) and the prism (its states 5 to 8), with the same R at both contacts, which follow from the states
    /// 3, 4, 2 and 1 of the plastic strike. For the cylinder this holds only as long as neither slip stops and A does not close again:
    /// [`Cylinder::elastic_strike`] says what happens then.
    ///
    /// # Example
    ///
    /// A rod with both supports at its quarter points bounces about the other support: ω⁺ = ω₀(k − R(1 − k)), k = 1/7, R = 1.
    ///
    /// ```
    /// use carom_theory::rocking::SupportedRod;
    /// let rod = SupportedRod::uniform(1.0, 2.0, [0.5, 0.5]);
    /// let (_, plastic) = rod.strike(1.0)?;
    /// let elastic = plastic.with_restitution(1.0);
    /// assert!((elastic.roll_rate + 5.0 / 7.0).abs() < 1e-15);
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    #[must_use]
    pub fn with_restitution(&self, restitution: f64) -> Self {
        let whole = 1.0 + restitution;
        let repeat = |after: f64, before: f64| whole * after - restitution * before;
        let [x, y] = self.velocity;
        let [x0, y0] = self.velocity_before;
        Self {
            velocity: [repeat(x, x0), repeat(y, y0)],
            roll_rate: repeat(self.roll_rate, self.roll_rate_before),
            normal: self.normal.map(|n| whole * n),
            tangential: match self.tangential {
                Tangential::Each(each) => Tangential::Each(each.map(|t| whole * t)),
                Tangential::Sum(sum) => Tangential::Sum(whole * sum),
            },
            ..*self
        }
    }

    /// Kinetic energy after over kinetic energy before, for a body with this `J/m` in m².
    ///
    /// # Example
    /// ```
    /// use carom_theory::rocking::SupportedRod;
    /// let rod = SupportedRod::uniform(1.0, 2.0, [0.5, 0.5]); // J/m = 1/3; A leaves, k = 1/7
    /// let (_, strike) = rod.strike(1.0)?;
    /// assert!((strike.energy_ratio(1.0 / 3.0) - 1.0 / 49.0).abs() < 1e-15);
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn energy_ratio(&self, inertia_per_mass: f64) -> f64 {
        let energy = |v: [f64; 2], rate: f64| v[0] * v[0] + v[1] * v[1] + inertia_per_mass * rate * rate;
        energy(self.velocity, self.roll_rate) / energy(self.velocity_before, self.roll_rate_before)
    }
}
