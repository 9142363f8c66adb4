//! A disc that swings in a chute or rolls through it: periods, the friction it needs, speed after it, force at a joint.

use super::CircularChute;
use crate::{OutsideDomain, pendulum};

impl CircularChute {
    /// Period of a disc that rolls to and fro with an amplitude A \[s\].
    ///
    /// ```text
    /// T = 2π/(ω₀ agm(1, cos(A/2))),   ω₀² = g/(L(1+κ))
    /// ```
    ///
    /// # Errors
    /// `amplitude` where it is not below π in size.
    ///
    /// # Limits
    /// |A| ≤ [`CircularChute::largest_amplitude`], below π/2: beyond it no friction holds the disc.
    ///
    /// # Source
    /// Landau and Lifshitz, Mechanics, §11, problem 1; the arithmetic-geometric mean (agm) is Gauss's.
    ///
    /// # Example
    ///
    /// ω₀ = 1; at 90° the period is 1.1803406 times that of small swings.
    ///
    /// ```
    /// use carom_theory::circular_chute::CircularChute;
    /// let chute = CircularChute { mass: 2.0, inertia: 1.0, radius: 1.0, chute_radius: 5.0, gravity: 6.0 };
    /// let [small, wide] = [0.0f64, 90.0].map(|a| chute.rolling_period(a.to_radians()).expect("below 180°"));
    /// assert!((small - std::f64::consts::TAU).abs() < 1e-15 && (wide / small - 1.180_340_6).abs() < 1e-7);
    /// ```
    pub fn rolling_period(&self, amplitude: f64) -> Result<f64, OutsideDomain> {
        pendulum::period(self.gravity / (self.way_radius() * (1.0 + self.inertia_ratio())), amplitude)
    }

    /// Period of a disc that slides to and fro without friction \[s\]: as [`CircularChute::rolling_period`] with κ = 0.
    ///
    /// # Errors
    /// `amplitude` where it is not below π in size.
    ///
    /// # Limits
    /// |A| ≤ π/2: beyond it the disc falls from the chute.
    ///
    /// # Example
    /// ```
    /// use carom_theory::circular_chute::CircularChute;
    /// let chute = CircularChute { mass: 2.0, inertia: 1.0, radius: 1.0, chute_radius: 5.0, gravity: 4.0 };
    /// let small = chute.smooth_period(0.0).expect("below 180°");
    /// assert_eq!(small, std::f64::consts::TAU); // 2π √(L/g)
    /// ```
    pub fn smooth_period(&self, amplitude: f64) -> Result<f64, OutsideDomain> {
        pendulum::period(self.gravity / self.way_radius(), amplitude)
    }

    /// Friction |F|/N that a disc needs at an angle to roll there from `[φ₀, φ̇₀]`; infinite where N ≤ 0.
    ///
    /// ```text
    /// from rest: κ|sin φ|/((3+κ) cos φ − 2 cos φ₀)
    /// ```
    ///
    /// It grows from the lowest point to the ends of a swing, where it is |tan φ₀| κ/(1+κ): the derivative of the quotient has the sign
    /// of `3 + κ − 2 cos φ₀ cos φ > 0`.
    ///
    /// # Example
    /// ```
    /// use carom_theory::circular_chute::CircularChute;
    /// let chute = CircularChute { mass: 2.0, inertia: 1.0, radius: 1.0, chute_radius: 5.0, gravity: 6.0 };
    /// let angle = 45f64.to_radians();
    /// assert!((chute.friction_needed([angle, 0.0], angle) - 1.0 / 3.0).abs() < 1e-15);
    /// ```
    pub fn friction_needed(&self, start: [f64; 2], angle: f64) -> f64 {
        let rate = self.rolling_rate_squared(start, angle);
        let kappa = self.inertia_ratio();
        let (sin, cos) = libm::sincos(angle);
        let pressed = cos + self.way_radius() * rate / self.gravity;
        if pressed > 0.0 { sin.abs() * kappa / (1.0 + kappa) / pressed } else { f64::INFINITY }
    }

    /// Largest amplitude with which a disc rolls to and fro without slip, `atan(μ(1+κ)/κ) = atan(μ(1 + ma²/J))` \[rad\].
    ///
    /// # Example
    /// A solid disc: tan A = 3μ.
    /// ```
    /// use carom_theory::circular_chute::CircularChute;
    /// let chute = CircularChute { mass: 2.0, inertia: 1.0, radius: 1.0, chute_radius: 5.0, gravity: 6.0 };
    /// assert!((chute.largest_amplitude(0.2) - 0.6f64.atan()).abs() < 1e-15);
    /// ```
    pub fn largest_amplitude(&self, friction: f64) -> f64 {
        libm::atan2(friction * (1.0 + self.inertia_ratio()), self.inertia_ratio())
    }

    /// Speed of the disc's centre after it has rolled down by `descent` (negative: up) from the speed `speed` [m/s]; `None` where it does
    /// not get so high.
    ///
    /// ```text
    /// v² = v₀² + 2g descent/(1+κ)
    /// ```
    ///
    /// The way does not matter: it holds through plates and arcs that join without a corner. `descent` is that of the disc's centre.
    ///
    /// # Example
    /// ```
    /// use carom_theory::circular_chute::CircularChute;
    /// let chute = CircularChute { mass: 2.0, inertia: 1.0, radius: 1.0, chute_radius: 5.0, gravity: 6.0 };
    /// assert_eq!(chute.speed_after(1.0, 1.0), Some(3.0)); // 1 + 12/1.5
    /// assert_eq!(chute.speed_after(1.0, -1.0), None);
    /// ```
    pub fn speed_after(&self, speed: f64, descent: f64) -> Option<f64> {
        let square = speed * speed + 2.0 * self.gravity * descent / (1.0 + self.inertia_ratio());
        (square >= 0.0).then(|| square.sqrt())
    }

    /// By how much the normal force jumps where a disc comes from a plate into the chute, the plate being its tangent, `mv²/L` \[N\];
    /// it falls as much where the disc leaves. F, which only depends on the slope while the disc rolls, does not jump.
    ///
    /// # Example
    /// ```
    /// use carom_theory::circular_chute::CircularChute;
    /// let chute = CircularChute { mass: 2.0, inertia: 1.0, radius: 1.0, chute_radius: 5.0, gravity: 6.0 };
    /// assert_eq!(chute.joint_jump(3.0), 4.5);
    /// ```
    pub fn joint_jump(&self, speed: f64) -> f64 {
        self.mass * speed * speed / self.way_radius()
    }
}
