//! A disc that rolls or slides down a fixed disc until it lifts off.
//!
//! b is the radius of the fixed disc about O, a that of the other, L = a + b, κ = J/(ma²). The centre of the other is at
//! `O + L (sin φ, cos φ)`: φ is counted from the top, clockwise. t points along growing φ and n out of the fixed disc; the force on the
//! other is N n + F t, its spin ω counter-clockwise.
//!
//! ```text
//! mLφ̈ = mg sin φ + F,   mLφ̇² = mg cos φ − N,   Jω̇ = aF
//! slip of the disc's rim on the fixed disc   u = Lφ̇ + aω;   rolling: ω = −Lφ̇/a
//! ```
//!
//! A plate that is rounded off at its end is the same with b as the radius of the rounding: φ then starts at the plate's slope. A
//! motion starts from an angle and its rate, `[φ₀, φ̇₀]`, with 0 ≤ φ₀ < π/2 and φ̇₀ ≥ 0: downwards.
//!
//! Source: the laws of Newton and Euler; that a hoop (κ = 1) leaves at 60° and a point (κ = 0) at cos φ = 2/3 are exercises of
//! Goldstein, Poole and Safko, Classical Mechanics (3rd ed., 2002), chapter 2. Sliding with friction is derived here.

mod lift_off;

use crate::OutsideDomain;
use crate::circular_chute::DiscMotion;
use crate::domain::{require_not_negative, require_positive};

pub use lift_off::LiftOff;

/// The disc and what it rolls down.
///
/// # Example
/// A solid disc has κ = 1/2.
/// ```
/// use carom_theory::disc_on_disc::DiscOnDisc;
/// let discs = DiscOnDisc { mass: 2.0, inertia: 1.0, radius: 1.0, fixed_radius: 3.0, gravity: 6.0 };
/// assert_eq!((discs.inertia_ratio(), discs.way_radius()), (0.5, 4.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiscOnDisc {
    /// m > 0 \[kg\].
    pub mass: f64,
    /// J > 0 about the disc's centre, which is its mass centre [kg m²].
    pub inertia: f64,
    /// a > 0 of the disc that moves \[m\].
    pub radius: f64,
    /// b ≥ 0 of the fixed disc \[m\].
    pub fixed_radius: f64,
    /// g > 0 [m/s²].
    pub gravity: f64,
}

impl DiscOnDisc {
    /// Checks that every quantity lies in its domain.
    ///
    /// # Errors
    ///
    /// The first quantity outside its domain.
    ///
    /// # Example
    /// ```
    /// use carom_theory::disc_on_disc::DiscOnDisc;
    /// let hollow = DiscOnDisc { mass: 2.0, inertia: 1.0, radius: 1.0, fixed_radius: -3.0, gravity: 6.0 };
    /// assert_eq!(hollow.check().map_err(|error| error.quantity), Err("fixed radius"));
    /// assert_eq!(DiscOnDisc { fixed_radius: 3.0, ..hollow }.check(), Ok(()));
    /// ```
    pub fn check(&self) -> Result<(), OutsideDomain> {
        require_positive("mass", self.mass)?;
        require_positive("inertia", self.inertia)?;
        require_positive("radius", self.radius)?;
        require_not_negative("fixed radius", self.fixed_radius)?;
        require_positive("gravity", self.gravity)
    }

    /// κ = J/(ma²).
    ///
    /// # Example
    /// ```
    /// use carom_theory::disc_on_disc::DiscOnDisc;
    /// let hoop = DiscOnDisc { mass: 2.0, inertia: 0.5, radius: 0.5, fixed_radius: 3.0, gravity: 6.0 };
    /// assert_eq!(hoop.inertia_ratio(), 1.0);
    /// ```
    pub fn inertia_ratio(&self) -> f64 {
        self.inertia / (self.mass * self.radius * self.radius)
    }

    /// L = a + b, of the way of the disc's centre \[m\].
    ///
    /// # Example
    /// ```
    /// use carom_theory::disc_on_disc::DiscOnDisc;
    /// let hoop = DiscOnDisc { mass: 2.0, inertia: 0.5, radius: 0.5, fixed_radius: 3.0, gravity: 6.0 };
    /// assert_eq!(hoop.way_radius(), 3.5);
    /// ```
    pub fn way_radius(&self) -> f64 {
        self.radius + self.fixed_radius
    }

    /// Slip u = Lφ̇ + aω of the disc's rim on the fixed disc, along growing φ [m/s].
    ///
    /// # Example
    /// ```
    /// use carom_theory::disc_on_disc::DiscOnDisc;
    /// let discs = DiscOnDisc { mass: 2.0, inertia: 1.0, radius: 1.0, fixed_radius: 3.0, gravity: 6.0 };
    /// assert_eq!(discs.slip(0.5, 0.0), 2.0);
    /// assert_eq!(discs.slip(0.5, discs.rolling_spin(0.5)), 0.0);
    /// ```
    pub fn slip(&self, rate: f64, spin: f64) -> f64 {
        self.way_radius() * rate + self.radius * spin
    }

    /// Spin ω = −Lφ̇/a of a disc that rolls, counter-clockwise [rad/s]: clockwise on the way down to the right.
    ///
    /// # Example
    /// ```
    /// use carom_theory::disc_on_disc::DiscOnDisc;
    /// let discs = DiscOnDisc { mass: 2.0, inertia: 1.0, radius: 1.0, fixed_radius: 3.0, gravity: 6.0 };
    /// assert_eq!(discs.rolling_spin(0.5), -2.0);
    /// ```
    pub fn rolling_spin(&self, rate: f64) -> f64 {
        -self.way_radius() * rate / self.radius
    }

    /// Kinetic and potential energy, `m L²φ̇²/2 + Jω²/2 + mgL cos φ` \[J\]; friction takes μN|u| of it per second.
    ///
    /// # Example
    /// ```
    /// use carom_theory::disc_on_disc::DiscOnDisc;
    /// let discs = DiscOnDisc { mass: 2.0, inertia: 1.0, radius: 1.0, fixed_radius: 3.0, gravity: 6.0 };
    /// assert_eq!(discs.energy(0.0, 0.5, -2.0), 4.0 + 2.0 + 48.0);
    /// ```
    pub fn energy(&self, angle: f64, rate: f64, spin: f64) -> f64 {
        let along = self.way_radius() * rate;
        0.5 * self.mass * along * along
            + 0.5 * self.inertia * spin * spin
            + self.mass * self.gravity * self.way_radius() * libm::cos(angle)
    }

    /// Forces and accelerations at an angle φ and a rate φ̇ while the disc rolls.
    ///
    /// ```text
    /// Lφ̈ = g sin φ/(1+κ),   ω̇ = −Lφ̈/a,   F = −mg sin φ κ/(1+κ),   N = m(g cos φ − Lφ̇²)
    /// ```
    ///
    /// # Example
    /// ```
    /// use carom_theory::disc_on_disc::DiscOnDisc;
    /// let discs = DiscOnDisc { mass: 2.0, inertia: 1.0, radius: 1.0, fixed_radius: 3.0, gravity: 6.0 };
    /// let motion = discs.rolling(30f64.to_radians(), 0.5); // mg sin φ = 6, a third of it
    /// assert!((motion.friction_force + 2.0).abs() < 1e-15 && (motion.angle_acceleration - 0.5).abs() < 1e-15);
    /// assert!((motion.normal_force - (12.0 * 0.75f64.sqrt() - 2.0)).abs() < 1e-14);
    /// ```
    pub fn rolling(&self, angle: f64, rate: f64) -> DiscMotion {
        let (kappa, length) = (self.inertia_ratio(), self.way_radius());
        let (sin, cos) = libm::sincos(angle);
        let along = self.gravity * sin / (1.0 + kappa);
        DiscMotion {
            normal_force: self.mass * (self.gravity * cos - length * rate * rate),
            friction_force: -self.mass * kappa * along,
            angle_acceleration: along / length,
            spin_acceleration: -along / self.radius,
        }
    }

    /// Forces and accelerations at an angle φ and a rate φ̇ while the rim slips, with `F = −drag N`: drag is μ for a slip along growing φ,
    /// −μ for one against it, and 0 without friction.
    ///
    /// # Example
    /// ```
    /// use carom_theory::disc_on_disc::DiscOnDisc;
    /// let discs = DiscOnDisc { mass: 2.0, inertia: 1.0, radius: 1.0, fixed_radius: 3.0, gravity: 6.0 };
    /// let motion = discs.sliding(0.0, 1.0, 0.5); // N = 12 − 8
    /// assert_eq!((motion.friction_force, motion.angle_acceleration, motion.spin_acceleration), (-2.0, -0.25, -2.0));
    /// ```
    pub fn sliding(&self, angle: f64, rate: f64, drag: f64) -> DiscMotion {
        let length = self.way_radius();
        let (sin, cos) = libm::sincos(angle);
        let normal = self.mass * (self.gravity * cos - length * rate * rate);
        let friction = -drag * normal;
        DiscMotion {
            normal_force: normal,
            friction_force: friction,
            angle_acceleration: (friction / self.mass + self.gravity * sin) / length,
            spin_acceleration: self.radius * friction / self.inertia,
        }
    }

    /// Square of the rate φ̇ at an angle of a disc that rolls from `[φ₀, φ̇₀]` [rad²/s²].
    ///
    /// ```text
    /// φ̇² = φ̇₀² + 2g(cos φ₀ − cos φ)/(L(1+κ))
    /// ```
    ///
    /// # Example
    /// ```
    /// use carom_theory::disc_on_disc::DiscOnDisc;
    /// let discs = DiscOnDisc { mass: 2.0, inertia: 1.0, radius: 1.0, fixed_radius: 3.0, gravity: 6.0 };
    /// let square = discs.rolling_rate_squared([0.0, 0.0], 0.8f64.acos());
    /// assert!((square - 0.4).abs() < 1e-15); // 12 · 0.2/(4 · 1.5)
    /// ```
    pub fn rolling_rate_squared(&self, [from, rate]: [f64; 2], angle: f64) -> f64 {
        let fall = 2.0 * libm::sin(0.5 * (angle - from)) * libm::sin(0.5 * (angle + from));
        rate * rate + 2.0 * self.gravity * fall / (self.way_radius() * (1.0 + self.inertia_ratio()))
    }

    /// Square of the rate φ̇ at an angle of a disc that slips all the way from `[φ₀, φ̇₀]`, its drag q as in [`DiscOnDisc::sliding`]
    /// [rad²/s²]; negative at angles that it does not reach.
    ///
    /// ```text
    /// d(φ̇²)/dφ − 2q φ̇² = (2g/L)(sin φ − q cos φ)
    /// φ̇² = (φ̇₀² + w(φ₀)) e^(2q(φ−φ₀)) − w(φ),   w(φ) = (2g/L)((1 − 2q²) cos φ + 3q sin φ)/(1 + 4q²)
    /// ```
    ///
    /// # Limits
    /// The slip keeps its direction, and N = m(g cos φ − Lφ̇²) stays positive.
    ///
    /// # Source
    /// Derived here.
    ///
    /// # Example
    ///
    /// With q = 1/√2 it is w = (2g/L) q sin φ: from the top, down to 30°.
    ///
    /// ```
    /// use carom_theory::disc_on_disc::DiscOnDisc;
    /// let discs = DiscOnDisc { mass: 2.0, inertia: 1.0, radius: 1.0, fixed_radius: 3.0, gravity: 6.0 };
    /// let (q, angle) = (0.5f64.sqrt(), 30f64.to_radians());
    /// let square = discs.sliding_rate_squared([0.0, 1.0], angle, q);
    /// assert!((square - ((2.0 * q * angle).exp() - 1.5 * q)).abs() < 1e-14);
    /// ```
    pub fn sliding_rate_squared(&self, [from, rate]: [f64; 2], angle: f64, drag: f64) -> f64 {
        let scale = 2.0 * self.gravity / (self.way_radius() * (1.0 + 4.0 * drag * drag));
        let steady = |at: f64| {
            let (sin, cos) = libm::sincos(at);
            scale * ((1.0 - 2.0 * drag * drag) * cos + 3.0 * drag * sin)
        };
        let growing = libm::exp(2.0 * drag * (angle - from));
        (rate * rate + steady(from)) * growing - steady(angle)
    }
}
