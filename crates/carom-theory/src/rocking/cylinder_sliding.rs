//! A cylinder that slides on A with v_C = V and spins with ω₀ when it strikes K.

use super::{Cylinder, Strike, Tangential};
use crate::OutsideDomain;
use crate::domain::{require_finite, require_positive};

/// What the plastic strike of a sliding cylinder leaves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SlidingState {
    /// 1: A separates, K sticks.
    RollsOver,
    /// 2: A separates, K slips.
    LeavesAndSlips,
    /// 3: A stays, both slip: it spins in the corner.
    SpinsInCorner,
}

impl SlidingState {
    /// The number of the rolling cylinder's state.
    ///
    /// # Example
    /// ```
    /// use carom_theory::rocking::SlidingState;
    /// assert_eq!([SlidingState::RollsOver, SlidingState::SpinsInCorner].map(|s| s.number()), [1, 3]);
    /// ```
    pub fn number(self) -> u8 {
        match self {
            Self::RollsOver => 1,
            Self::LeavesAndSlips => 2,
            Self::SpinsInCorner => 3,
        }
    }
}

impl Cylinder {
    /// The plastic strike of a cylinder that moves along the plane of A with V > 0 and turns with any ω₀.
    ///
    /// ```text
    /// a = 1; T = mb(ω₀ − Vc)/(1+b) would make K stick; S = T where |T| ≤ f N_K, else f N_K sign T
    /// 1 2  N_K = mVs,  T_K = S,  v_t = Vc + S/m ≥ 0,  v = v_t(c, s),  ω = ω₀ − S/(mb)
    /// 3    N_K = mV/(s(1+f²)),  N_A = −(c ± fs)N_K ≥ 0,  T = ±fN,  ω = ω₀ − (±f)V(τ ∓ f)/(b(1+f²)),  ±ω > 0;  v = 0
    /// ```
    ///
    /// The upper sign where both contacts slip backward (ω > 0), the lower where both slip forward.
    ///
    /// # Limits
    /// States in which it stops, with sticking at both contacts, are not determined by these balances and are refused. The forms are
    /// end states; the stages reach the same ones where [`Cylinder::slides_directly`].
    ///
    /// # Errors
    /// A quantity outside its domain; `friction` where neither state 1, 2 nor 3 is consistent: then it stops.
    ///
    /// # Source
    /// Derived here.
    ///
    /// # Example
    ///
    /// With V = ω₀a it rolls, and this is [`Cylinder::strike`].
    ///
    /// ```
    /// let disc = carom_theory::rocking::Cylinder {
    ///     mass: 2.0, radius: 0.5, inertia_ratio: 0.5, friction: 0.3, half_angle: 0.4,
    /// };
    /// let (_, sliding) = disc.sliding_strike(1.5, 3.0)?;
    /// let (_, rolling) = disc.strike(3.0)?;
    /// assert!((sliding.roll_rate - rolling.roll_rate).abs() < 1e-15);
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn sliding_strike(
        &self,
        speed: f64,
        roll_rate: f64,
    ) -> Result<(SlidingState, Strike), OutsideDomain> {
        self.check()?;
        require_positive("speed", speed)?;
        require_finite("roll rate", roll_rate)?;
        // In units of m, a and V.
        let spin = roll_rate * self.radius / speed;
        let found = self.leaves_sliding(spin).or_else(|| self.spins_sliding(spin));
        let stops = OutsideDomain {
            quantity: "friction",
            value: self.friction,
            allowed: "so little that it does not stop",
        };
        let (state, unit) = found.ok_or(stops)?;
        let strike = unit.in_units(self.mass, self.radius, speed / self.radius);
        Ok((state, Strike { roll_rate_before: roll_rate, ..strike }))
    }

    /// True where the stages reach the end state of [`Cylinder::sliding_strike`]: in state 3, if both contacts slip from the beginning as
    /// they do in the end, `ω₀ ≥ V/a` or `ω₀ < cos 2γ V/a`; in states 1 and 2, if the first slip at K does not press A down, `c ± fs ≥ 0`.
    /// Else A takes an impulse on the way that the end state does not know of.
    ///
    /// # Errors
    /// As [`Cylinder::sliding_strike`].
    ///
    /// # Source
    /// Derived here.
    ///
    /// # Example
    /// ```
    /// let ring = carom_theory::rocking::Cylinder {
    ///     mass: 1.0, radius: 1.0, inertia_ratio: 1.0, friction: 1.9, half_angle: 30f64.to_radians(),
    /// };
    /// assert!(ring.slides_directly(1.0, 1.0)?); // rolling: K slips backward and lifts it
    /// assert!(!ring.slides_directly(1.0, 0.3)?); // K slips forward at first: 0.5 − 1.9 · 0.866 < 0
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn slides_directly(&self, speed: f64, roll_rate: f64) -> Result<bool, OutsideDomain> {
        let (state, strike) = self.sliding_strike(speed, roll_rate)?;
        let (l, spin) = (self.letters(), roll_rate * self.radius / speed);
        Ok(match state {
            SlidingState::SpinsInCorner if strike.roll_rate > 0.0 => spin >= 1.0,
            SlidingState::SpinsInCorner => spin < l.c,
            _ => l.c + l.f.copysign(spin - l.c) * l.s >= 0.0,
        })
    }

    fn leaves_sliding(&self, spin: f64) -> Option<(SlidingState, Strike)> {
        let l = self.letters();
        let grip = l.b * (spin - l.c) / (1.0 + l.b);
        let limit = l.f * l.s;
        let sticks = grip.abs() <= limit;
        let pulled = if sticks { grip } else { limit.copysign(grip) };
        let along = l.c + pulled;
        let state = if sticks { SlidingState::RollsOver } else { SlidingState::LeavesAndSlips };
        let unit = Strike {
            velocity_before: [1.0, 0.0],
            roll_rate_before: spin,
            velocity: [along * l.c, along * l.s],
            roll_rate: spin - pulled / l.b,
            normal: [0.0, l.s],
            tangential: Tangential::Each([0.0, pulled]),
        };
        (along >= 0.0).then_some((state, unit))
    }

    fn spins_sliding(&self, spin: f64) -> Option<(SlidingState, Strike)> {
        let l = self.letters();
        let cone = 1.0 + l.f * l.f;
        [l.f, -l.f].into_iter().find_map(|pull| {
            let struck = 1.0 / (l.s * cone);
            let held = -(l.c + pull * l.s) * struck;
            let rate = spin - pull * (l.tau - pull) / (l.b * cone);
            let unit = Strike {
                velocity_before: [1.0, 0.0],
                roll_rate_before: spin,
                velocity: [0.0, 0.0],
                roll_rate: rate,
                normal: [held, struck],
                tangential: Tangential::Each([pull * held, pull * struck]),
            };
            (held >= 0.0 && rate * pull >= 0.0 && (pull != 0.0 || l.f == 0.0))
                .then_some((SlidingState::SpinsInCorner, unit))
        })
    }
}
