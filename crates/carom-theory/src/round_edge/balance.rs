//! A part that rests on a round edge: balanced, rocking about its balance, or rolling on until it falls.

use super::RoundEdge;
use crate::roots::border;
use core::f64::consts::FRAC_PI_2;

impl RoundEdge {
    /// Offset at which a part rests at a tilt, s = c tan θ \[m\]: C is straight above the contact. It takes a friction of |tan θ|.
    ///
    /// # Example
    /// ```
    /// use carom_theory::round_edge::RoundEdge;
    /// let part = RoundEdge { mass: 2.0, inertia: 1.5, half_thickness: 0.5, edge_radius: 1.0, gravity: 10.0 };
    /// assert!((part.balance_offset(45f64.to_radians()) - 0.5).abs() < 1e-15);
    /// ```
    pub fn balance_offset(&self, tilt: f64) -> f64 {
        self.half_thickness * libm::tan(tilt)
    }

    /// Moment per tilt that brings a part back to its balance at a tilt, rolling [N m/rad]; the balance is stable where it is positive.
    ///
    /// ```text
    /// mg h″ = mg(ρ cos θ − c/cos θ),   level: mg(ρ − c)
    /// ```
    ///
    /// At ρ = c a level part is unstable still: h = ρ(2 − θ⁴/12 + …).
    ///
    /// # Example
    ///
    /// Level, it takes a radius above half the thickness.
    ///
    /// ```
    /// use carom_theory::round_edge::RoundEdge;
    /// let part = RoundEdge { mass: 2.0, inertia: 1.5, half_thickness: 0.5, edge_radius: 1.0, gravity: 10.0 };
    /// assert_eq!(part.balance_stiffness(0.0), 10.0);
    /// assert_eq!(RoundEdge { edge_radius: 0.25, ..part }.balance_stiffness(0.0), -5.0);
    /// ```
    pub fn balance_stiffness(&self, tilt: f64) -> f64 {
        let cos = libm::cos(tilt);
        self.mass * self.gravity * (self.edge_radius * cos - self.half_thickness / cos)
    }

    /// Square of the rate of small rolling oscillations about the balance at a tilt [1/s²]; negative where it is unstable.
    ///
    /// ```text
    /// mg(ρ cos θ − c/cos θ)/(J + mc²/cos²θ),   level: mg(ρ − c)/(J + mc²)
    /// ```
    ///
    /// # Example
    /// ```
    /// use carom_theory::round_edge::RoundEdge;
    /// let part = RoundEdge { mass: 2.0, inertia: 1.5, half_thickness: 0.5, edge_radius: 1.0, gravity: 10.0 };
    /// assert_eq!(part.rocking_rate_squared(0.0), 5.0); // 10/(1.5 + 0.5)
    /// ```
    pub fn rocking_rate_squared(&self, tilt: f64) -> f64 {
        self.balance_stiffness(tilt) / self.inertia_about_contact(self.balance_offset(tilt))
    }

    /// Tilt up to which a part that was balanced level rolls back when it is let go \[rad\]; `None` where its balance is not stable.
    ///
    /// ```text
    /// tan θ/θ = ρ/c
    /// ```
    ///
    /// There C is straight above the contact again, c tan θ = s = ρθ; beyond it the part rolls on. For c = 0 it is π/2.
    ///
    /// # Example
    /// ```
    /// use carom_theory::round_edge::RoundEdge;
    /// let c = std::f64::consts::FRAC_PI_4; // tan 45° = (ρ/c) π/4
    /// let part = RoundEdge { mass: 2.0, inertia: 1.5, half_thickness: c, edge_radius: 1.0, gravity: 10.0 };
    /// assert!((part.overturning_tilt().expect("stable") - c).abs() < 1e-14);
    /// ```
    pub fn overturning_tilt(&self) -> Option<f64> {
        let (c, rho) = (self.half_thickness, self.edge_radius);
        let comes_back = |tilt: f64| {
            let (sin, cos) = libm::sincos(tilt);
            rho * tilt * cos > c * sin
        };
        // tan θ/θ grows; where cos θ = c/ρ it is sin θ/θ · ρ/c, not yet ρ/c.
        (rho > c).then(|| border(comes_back, libm::acos(c / rho).min(FRAC_PI_2), FRAC_PI_2))
    }

    /// Offset up to which a part that is let go level beyond the end of a plate rolls, turns back and returns \[m\]; with more it goes over.
    /// `None` where ρ ≤ c: it always goes over.
    ///
    /// ```text
    /// s* = ρ arccos(c/ρ) − √(ρ² − c²)
    /// ```
    ///
    /// C is as high as at the release where `s₀ = ρ|θ| − (ρ+c) tan(|θ|/2)`, which is greatest at `cos θ = c/ρ`.
    ///
    /// # Limits
    /// The part rolls and stays on the edge; the plate before the edge holds it from turning the other way.
    ///
    /// # Example
    /// ```
    /// use carom_theory::round_edge::RoundEdge;
    /// let part = RoundEdge { mass: 2.0, inertia: 1.5, half_thickness: 0.5, edge_radius: 1.0, gravity: 10.0 };
    /// let limit = part.largest_returning_offset().expect("thin enough");
    /// assert!((limit - (std::f64::consts::FRAC_PI_3 - 0.75f64.sqrt())).abs() < 1e-15);
    /// ```
    pub fn largest_returning_offset(&self) -> Option<f64> {
        let (c, rho) = (self.half_thickness, self.edge_radius);
        (rho > c).then(|| rho * libm::acos(c / rho) - ((rho - c) * (rho + c)).sqrt())
    }

    /// Tilt at which a part that was let go level at an offset turns back \[rad\], clockwise for a positive offset; `None` where it goes over.
    ///
    /// ```text
    /// ρ|θ| − (ρ+c) tan(|θ|/2) = |s₀|
    /// ```
    ///
    /// # Limits
    /// As [`RoundEdge::largest_returning_offset`].
    ///
    /// # Example
    ///
    /// A thin rod, from s₀ = ρ(π/3 − tan 30°).
    ///
    /// ```
    /// use carom_theory::round_edge::RoundEdge;
    /// let rod = RoundEdge { mass: 2.0, inertia: 1.5, half_thickness: 0.0, edge_radius: 1.0, gravity: 10.0 };
    /// let sixty = std::f64::consts::FRAC_PI_3;
    /// let tilt = rod.returning_tilt(sixty - 3f64.sqrt().recip()).expect("it returns");
    /// assert!((tilt + sixty).abs() < 1e-14);
    /// ```
    pub fn returning_tilt(&self, offset: f64) -> Option<f64> {
        let (c, rho) = (self.half_thickness, self.edge_radius);
        let reached = offset.abs();
        let returns = self.largest_returning_offset().is_some_and(|limit| reached <= limit);
        let still_falls = |tilt: f64| rho * tilt - (rho + c) * libm::tan(0.5 * tilt) < reached;
        returns.then(|| -border(still_falls, 0.0, libm::acos(c / rho)).copysign(offset))
    }
}
