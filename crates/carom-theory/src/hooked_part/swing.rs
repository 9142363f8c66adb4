//! The swing of a part about the edge in its inner corner: a physical pendulum.

use super::HookedPart;
use crate::OutsideDomain;
use crate::pendulum;

impl HookedPart {
    /// ω₀² = mgh/(J + mh²) [1/s²]: φ̈ = −ω₀² sin φ.
    ///
    /// # Example
    /// ```
    /// use carom_theory::hooked_part::HookedPart;
    /// let part = HookedPart { mass: 2.0, inertia: 2.0, arm: 1.0, normals: [0.8; 2], gravity: 10.0 };
    /// assert_eq!(part.stiffness(), 5.0);
    /// ```
    pub fn stiffness(&self) -> f64 {
        self.mass * self.gravity * self.arm / self.inertia_about_edge()
    }

    /// Square of the rate φ̇ at a tilt, on the swing through `[φ₀, φ̇₀]`, `φ̇₀² + 2ω₀²(cos φ − cos φ₀)` [rad²/s²]; negative at tilts that it
    /// does not reach.
    ///
    /// # Example
    /// ```
    /// use carom_theory::hooked_part::HookedPart;
    /// let part = HookedPart { mass: 2.0, inertia: 2.0, arm: 1.0, normals: [0.8; 2], gravity: 10.0 };
    /// assert!((part.rate_squared([60f64.to_radians(), 2.0], 0.0) - 9.0).abs() < 1e-14); // 4 + 10/2
    /// ```
    pub fn rate_squared(&self, [from, rate]: [f64; 2], tilt: f64) -> f64 {
        let fall = 2.0 * libm::sin(0.5 * (from - tilt)) * libm::sin(0.5 * (from + tilt));
        rate * rate + 2.0 * self.stiffness() * fall
    }

    /// Largest tilt of the swing through `[φ₀, φ̇₀]`, `sin²(A/2) = sin²(φ₀/2) + φ̇₀²/(4ω₀²)` \[rad\]; `None` where it goes over the top.
    ///
    /// # Example
    /// ```
    /// use carom_theory::hooked_part::HookedPart;
    /// let part = HookedPart { mass: 2.0, inertia: 2.0, arm: 1.0, normals: [0.8; 2], gravity: 10.0 };
    /// let amplitude = part.amplitude([0.0, 5f64.sqrt()]).expect("sin² = 1/4");
    /// assert!((amplitude - 60f64.to_radians()).abs() < 1e-15);
    /// assert_eq!(part.amplitude([0.0, 4.5]), None);
    /// ```
    pub fn amplitude(&self, [tilt, rate]: [f64; 2]) -> Option<f64> {
        let sin = libm::sin(0.5 * tilt);
        let square = sin * sin + rate * rate / (4.0 * self.stiffness());
        (square < 1.0).then(|| 2.0 * libm::asin(square.sqrt()))
    }

    /// Period with an amplitude A, `(4/ω₀) K(sin(A/2)) = 2π/(ω₀ agm(1, cos(A/2)))` \[s\], K the complete elliptic integral of the first kind.
    ///
    /// # Errors
    /// `amplitude` where it is not below π in size.
    ///
    /// # Source
    /// Landau and Lifshitz, Mechanics, §11, problem 1; the arithmetic-geometric mean (agm) is Gauss's.
    ///
    /// # Example
    /// ```
    /// use carom_theory::hooked_part::HookedPart;
    /// let part = HookedPart { mass: 2.0, inertia: 2.0, arm: 1.0, normals: [0.8; 2], gravity: 8.0 };
    /// assert_eq!(part.period(0.0), Ok(std::f64::consts::PI)); // ω₀ = 2
    /// ```
    pub fn period(&self, amplitude: f64) -> Result<f64, OutsideDomain> {
        pendulum::period(self.stiffness(), amplitude)
    }

    /// Time from `[φ₀, φ̇₀]` to a tilt that lies ahead, without a turn between, an incomplete elliptic integral of the first kind \[s\]; `None`
    /// where it turns before, or where the tilt lies behind.
    ///
    /// ```text
    /// t = (2/Ω)(F(φ/2, 2ω₀/Ω) − F(φ₀/2, 2ω₀/Ω)),   Ω the rate at φ = 0
    /// ```
    ///
    /// # Limits
    /// |φ₀|, |φ| ≤ π. Next to a turn it loses half of its digits; the time to the turn itself is that of [`HookedPart::time_to_return`].
    ///
    /// # Source
    /// Landau and Lifshitz, Mechanics, §11, problem 1.
    ///
    /// # Example
    /// Without gravity it would be the tilt by the rate; here it takes a little longer upwards.
    /// ```
    /// use carom_theory::hooked_part::HookedPart;
    /// let part = HookedPart { mass: 2.0, inertia: 2.0, arm: 1.0, normals: [0.8; 2], gravity: 1e-9 };
    /// let time = part.time_between([-0.5, 2.0], 0.5).expect("ahead");
    /// assert!((time - 0.5).abs() < 1e-9 && part.time_between([0.5, 2.0], 0.0).is_none());
    /// ```
    pub fn time_between(&self, [from, rate]: [f64; 2], to: f64) -> Option<f64> {
        let ahead = (to - from) * rate >= 0.0 && self.rate_squared([from, rate], to) >= 0.0;
        let bottom = self.rate_squared([from, rate], 0.0).sqrt();
        let since = |tilt: f64| pendulum::time_from_bottom(self.stiffness(), bottom, tilt);
        ahead.then(|| (since(to) - since(from)).abs())
    }

    /// Time from `[φ₀, φ̇₀]` until it has turned and is back at φ₀, with the rate −φ̇₀ \[s\]; `None` where it goes over the top.
    ///
    /// # Example
    /// From the bottom half a period, which is at least π/ω₀.
    /// ```
    /// use carom_theory::hooked_part::HookedPart;
    /// let part = HookedPart { mass: 2.0, inertia: 2.0, arm: 1.0, normals: [0.8; 2], gravity: 8.0 };
    /// let half = std::f64::consts::FRAC_PI_2;
    /// assert!((part.time_to_return([0.0, 1e-9]).expect("it turns") - half).abs() < 1e-14);
    /// ```
    pub fn time_to_return(&self, [tilt, rate]: [f64; 2]) -> Option<f64> {
        let amplitude = self.amplitude([tilt, rate])?;
        let quarter = 0.25 * self.period(amplitude).ok()?;
        let bottom = self.rate_squared([tilt, rate], 0.0).sqrt();
        let since = pendulum::time_from_bottom(self.stiffness(), bottom, tilt.copysign(tilt * rate));
        Some(2.0 * (quarter - since))
    }
}
