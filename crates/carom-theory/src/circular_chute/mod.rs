//! A disc in a circular chute that is hollow up: it rolls to and fro, or slides.
//!
//! R is the radius of the chute about O, a that of the disc, L = R − a, κ = J/(ma²). The disc's centre is at
//! `O + L (sin φ, −cos φ)`: φ is counted from the lowest point, counter-clockwise about O. t points along growing φ and n from the chute
//! into the disc, to O; the force on the disc is N n + F t, its spin ω counter-clockwise.
//!
//! ```text
//! mLφ̈ = F − mg sin φ,   mLφ̇² = N − mg cos φ,   Jω̇ = aF
//! slip of the disc's rim on the chute   u = Lφ̇ + aω;   rolling: ω = −Lφ̇/a
//! ```
//!
//! A motion starts from an angle and its rate, `[φ₀, φ̇₀]`, and what is asked at another angle does not depend on the direction.
//!
//! Source: the laws of Newton and Euler; the problem is classical, see Routh, Dynamics of a System of Rigid Bodies, Elementary Part
//! (1905). Sliding with friction is derived here.

mod swings;

use crate::OutsideDomain;
use crate::domain::{require, require_positive};

/// The disc and its chute.
///
/// # Example
/// A solid disc has κ = 1/2.
/// ```
/// use carom_theory::circular_chute::CircularChute;
/// let chute = CircularChute { mass: 2.0, inertia: 1.0, radius: 1.0, chute_radius: 5.0, gravity: 6.0 };
/// assert_eq!((chute.inertia_ratio(), chute.way_radius()), (0.5, 4.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CircularChute {
    /// m > 0 \[kg\].
    pub mass: f64,
    /// J > 0 about the disc's centre, which is its mass centre [kg m²].
    pub inertia: f64,
    /// a > 0 of the disc \[m\].
    pub radius: f64,
    /// R > a of the chute \[m\].
    pub chute_radius: f64,
    /// g > 0 [m/s²].
    pub gravity: f64,
}

/// Forces on a disc on a circular way, and its accelerations.
///
/// # Example
/// On its way through the lowest point a disc presses with mg + mLφ̇² = 12 + 8, whether it rolls or not.
/// ```
/// use carom_theory::circular_chute::CircularChute;
/// let chute = CircularChute { mass: 2.0, inertia: 1.0, radius: 1.0, chute_radius: 5.0, gravity: 6.0 };
/// assert_eq!(chute.rolling(0.0, 1.0).normal_force, 20.0);
/// assert_eq!(chute.sliding(0.0, 1.0, 0.5).normal_force, 20.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiscMotion {
    /// N on the disc, away from the obstacle \[N\]; the disc leaves it where it would become negative.
    pub normal_force: f64,
    /// F on the disc, along growing φ \[N\].
    pub friction_force: f64,
    /// φ̈ [rad/s²].
    pub angle_acceleration: f64,
    /// ω̇, counter-clockwise [rad/s²].
    pub spin_acceleration: f64,
}

impl CircularChute {
    /// Checks that every quantity lies in its domain.
    ///
    /// # Errors
    ///
    /// The first quantity outside its domain.
    ///
    /// # Example
    /// ```
    /// use carom_theory::circular_chute::CircularChute;
    /// let tight = CircularChute { mass: 2.0, inertia: 1.0, radius: 1.0, chute_radius: 1.0, gravity: 6.0 };
    /// assert_eq!(tight.check().map_err(|error| error.quantity), Err("chute radius"));
    /// assert_eq!(CircularChute { chute_radius: 5.0, ..tight }.check(), Ok(()));
    /// ```
    pub fn check(&self) -> Result<(), OutsideDomain> {
        require_positive("mass", self.mass)?;
        require_positive("inertia", self.inertia)?;
        require_positive("radius", self.radius)?;
        let wide = self.chute_radius > self.radius && self.chute_radius.is_finite();
        require(wide, "chute radius", self.chute_radius, "finite and > radius")?;
        require_positive("gravity", self.gravity)
    }

    /// κ = J/(ma²).
    ///
    /// # Example
    /// ```
    /// use carom_theory::circular_chute::CircularChute;
    /// let ring = CircularChute { mass: 2.0, inertia: 0.5, radius: 0.5, chute_radius: 5.0, gravity: 6.0 };
    /// assert_eq!(ring.inertia_ratio(), 1.0);
    /// ```
    pub fn inertia_ratio(&self) -> f64 {
        self.inertia / (self.mass * self.radius * self.radius)
    }

    /// L = R − a, of the way of the disc's centre \[m\].
    ///
    /// # Example
    /// ```
    /// use carom_theory::circular_chute::CircularChute;
    /// let ring = CircularChute { mass: 2.0, inertia: 0.5, radius: 0.5, chute_radius: 5.0, gravity: 6.0 };
    /// assert_eq!(ring.way_radius(), 4.5);
    /// ```
    pub fn way_radius(&self) -> f64 {
        self.chute_radius - self.radius
    }

    /// Slip u = Lφ̇ + aω of the disc's rim on the chute, along growing φ [m/s].
    ///
    /// # Example
    /// ```
    /// use carom_theory::circular_chute::CircularChute;
    /// let chute = CircularChute { mass: 2.0, inertia: 1.0, radius: 1.0, chute_radius: 5.0, gravity: 6.0 };
    /// assert_eq!(chute.slip(0.5, 0.0), 2.0);
    /// assert_eq!(chute.slip(0.5, chute.rolling_spin(0.5)), 0.0);
    /// ```
    pub fn slip(&self, rate: f64, spin: f64) -> f64 {
        self.way_radius() * rate + self.radius * spin
    }

    /// Spin ω = −Lφ̇/a of a disc that rolls, counter-clockwise [rad/s]: against the way of its centre about O.
    ///
    /// # Example
    /// ```
    /// use carom_theory::circular_chute::CircularChute;
    /// let chute = CircularChute { mass: 2.0, inertia: 1.0, radius: 1.0, chute_radius: 5.0, gravity: 6.0 };
    /// assert_eq!(chute.rolling_spin(0.5), -2.0);
    /// ```
    pub fn rolling_spin(&self, rate: f64) -> f64 {
        -self.way_radius() * rate / self.radius
    }

    /// Kinetic and potential energy, `m L²φ̇²/2 + Jω²/2 − mgL cos φ` \[J\]; friction takes μN|u| of it per second.
    ///
    /// # Example
    /// ```
    /// use carom_theory::circular_chute::CircularChute;
    /// let chute = CircularChute { mass: 2.0, inertia: 1.0, radius: 1.0, chute_radius: 5.0, gravity: 6.0 };
    /// assert_eq!(chute.energy(0.0, 0.5, -2.0), 4.0 + 2.0 - 48.0);
    /// ```
    pub fn energy(&self, angle: f64, rate: f64, spin: f64) -> f64 {
        let along = self.way_radius() * rate;
        0.5 * self.mass * along * along + 0.5 * self.inertia * spin * spin
            - self.mass * self.gravity * self.way_radius() * libm::cos(angle)
    }

    /// Forces and accelerations at an angle φ and a rate φ̇ while the disc rolls.
    ///
    /// ```text
    /// Lφ̈ = −g sin φ/(1+κ),   ω̇ = −Lφ̈/a,   F = mg sin φ κ/(1+κ),   N = m(g cos φ + Lφ̇²)
    /// ```
    ///
    /// # Example
    /// ```
    /// use carom_theory::circular_chute::CircularChute;
    /// let chute = CircularChute { mass: 2.0, inertia: 1.0, radius: 1.0, chute_radius: 5.0, gravity: 6.0 };
    /// let motion = chute.rolling(30f64.to_radians(), 0.0); // mg sin φ = 6, a third of it
    /// assert!((motion.friction_force - 2.0).abs() < 1e-15 && (motion.angle_acceleration + 0.5).abs() < 1e-15);
    /// ```
    pub fn rolling(&self, angle: f64, rate: f64) -> DiscMotion {
        let (kappa, length) = (self.inertia_ratio(), self.way_radius());
        let (sin, cos) = libm::sincos(angle);
        let along = -self.gravity * sin / (1.0 + kappa);
        DiscMotion {
            normal_force: self.mass * (self.gravity * cos + length * rate * rate),
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
    /// use carom_theory::circular_chute::CircularChute;
    /// let chute = CircularChute { mass: 2.0, inertia: 1.0, radius: 1.0, chute_radius: 5.0, gravity: 6.0 };
    /// let motion = chute.sliding(0.0, 1.0, 0.5); // N = 12 + 8
    /// assert_eq!((motion.friction_force, motion.angle_acceleration, motion.spin_acceleration), (-10.0, -1.25, -10.0));
    /// ```
    pub fn sliding(&self, angle: f64, rate: f64, drag: f64) -> DiscMotion {
        let length = self.way_radius();
        let (sin, cos) = libm::sincos(angle);
        let normal = self.mass * (self.gravity * cos + length * rate * rate);
        let friction = -drag * normal;
        DiscMotion {
            normal_force: normal,
            friction_force: friction,
            angle_acceleration: (friction / self.mass - self.gravity * sin) / length,
            spin_acceleration: self.radius * friction / self.inertia,
        }
    }

    /// Square of the rate φ̇ at an angle of a disc that rolls from `[φ₀, φ̇₀]` [rad²/s²]; negative at angles that it does not reach.
    ///
    /// ```text
    /// φ̇² = φ̇₀² + 2g(cos φ − cos φ₀)/(L(1+κ))
    /// ```
    ///
    /// # Example
    /// ```
    /// use carom_theory::circular_chute::CircularChute;
    /// let chute = CircularChute { mass: 2.0, inertia: 1.0, radius: 1.0, chute_radius: 5.0, gravity: 6.0 };
    /// let square = chute.rolling_rate_squared([60f64.to_radians(), 0.0], 0.0);
    /// assert!((square - 1.0).abs() < 1e-15); // 12 (1 − 1/2)/(4 · 1.5)
    /// ```
    pub fn rolling_rate_squared(&self, [from, rate]: [f64; 2], angle: f64) -> f64 {
        let fall = 2.0 * libm::sin(0.5 * (from - angle)) * libm::sin(0.5 * (from + angle));
        rate * rate + 2.0 * self.gravity * fall / (self.way_radius() * (1.0 + self.inertia_ratio()))
    }

    /// Square of the rate φ̇ at an angle of a disc that slips all the way from `[φ₀, φ̇₀]`, its drag q as in [`CircularChute::sliding`]
    /// [rad²/s²]; negative at angles that it does not reach.
    ///
    /// ```text
    /// d(φ̇²)/dφ + 2q φ̇² = −(2g/L)(sin φ + q cos φ)
    /// φ̇² = w(φ) + (φ̇₀² − w(φ₀)) e^(−2q(φ−φ₀)),   w(φ) = (2g/L)((1 − 2q²) cos φ − 3q sin φ)/(1 + 4q²)
    /// ```
    ///
    /// # Limits
    /// The slip keeps its direction, and N = m(g cos φ + Lφ̇²) stays positive.
    ///
    /// # Source
    /// Derived here.
    ///
    /// # Example
    ///
    /// With q = 1/√2 it is w = −(2g/L) q sin φ: from the lowest point, up to 30°.
    ///
    /// ```
    /// use carom_theory::circular_chute::CircularChute;
    /// let chute = CircularChute { mass: 2.0, inertia: 1.0, radius: 1.0, chute_radius: 5.0, gravity: 6.0 };
    /// let (q, angle) = (0.5f64.sqrt(), 30f64.to_radians());
    /// let square = chute.sliding_rate_squared([0.0, 3.0], angle, q);
    /// assert!((square - (9.0 * (-2.0 * q * angle).exp() - 1.5 * q)).abs() < 1e-14);
    /// ```
    pub fn sliding_rate_squared(&self, [from, rate]: [f64; 2], angle: f64, drag: f64) -> f64 {
        let scale = 2.0 * self.gravity / (self.way_radius() * (1.0 + 4.0 * drag * drag));
        let steady = |at: f64| {
            let (sin, cos) = libm::sincos(at);
            scale * ((1.0 - 2.0 * drag * drag) * cos - 3.0 * drag * sin)
        };
        let fading = libm::exp(-2.0 * drag * (angle - from));
        steady(angle) + (rate * rate - steady(from)) * fading
    }
}
