//! A rod that pivots on one of two smooth level supports and strikes the other.

use super::{Strike, Tangential};
use crate::OutsideDomain;
use crate::domain::{require_not_negative, require_positive};

/// A straight body above two supports A and B on either side of its mass centre.
///
/// # Example
/// With J = mab the blow at B is not felt at A: B is A's centre of percussion.
/// ```
/// use carom_theory::rocking::SupportedRod;
/// let rod = SupportedRod { mass: 1.0, inertia: 2.0, to_a: 1.0, to_b: 2.0 };
/// let (_, strike) = rod.strike(3.0)?;
/// assert_eq!((strike.normal, strike.roll_rate), ([0.0, 3.0], 0.0));
/// # Ok::<(), carom_theory::OutsideDomain>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SupportedRod {
    /// m > 0 \[kg\].
    pub mass: f64,
    /// J > 0 about the mass centre [kg m²].
    pub inertia: f64,
    /// a ≥ 0, from the mass centre back to A \[m\].
    pub to_a: f64,
    /// b ≥ 0, from the mass centre on to B \[m\]; a + b > 0.
    pub to_b: f64,
}

/// What the plastic strike of the rod leaves.
///
/// # Example
/// A rod that is longer than √12 times the half distance of its supports goes on.
/// ```
/// use carom_theory::rocking::{RodState, SupportedRod};
/// let state = |length| SupportedRod::uniform(1.0, length, [1.0, 1.0]).strike(1.0).map(|(state, _)| state);
/// assert_eq!((state(3.4), state(3.5)), (Ok(RodState::Stops), Ok(RodState::TurnsAboutB)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RodState {
    /// Variant 1: both supports stay, the rod stops. `J ≤ mab`, for a uniform rod `12ab ≥ l²`.
    Stops,
    /// Variant 2: A separates, the rod goes on about B with k ω₀.
    TurnsAboutB,
}

impl SupportedRod {
    /// A uniform thin rod of length l, supported at `[a, b]` from its middle: `J = ml²/12`.
    ///
    /// # Example
    /// ```
    /// assert_eq!(carom_theory::rocking::SupportedRod::uniform(3.0, 2.0, [0.5, 0.5]).inertia, 1.0);
    /// ```
    pub fn uniform(mass: f64, length: f64, supports: [f64; 2]) -> Self {
        Self { mass, inertia: mass * length * length / 12.0, to_a: supports[0], to_b: supports[1] }
    }

    /// Checks that every quantity lies in its domain.
    ///
    /// # Errors
    ///
    /// The first quantity outside its domain.
    ///
    /// # Example
    /// ```
    /// use carom_theory::rocking::SupportedRod;
    /// let on_a_point = SupportedRod::uniform(1.0, 2.0, [0.0, 0.0]);
    /// assert_eq!(on_a_point.check().map_err(|error| error.quantity), Err("to_a + to_b"));
    /// assert_eq!(SupportedRod::uniform(1.0, 2.0, [0.5, 0.0]).check(), Ok(()));
    /// ```
    pub fn check(&self) -> Result<(), OutsideDomain> {
        require_positive("mass", self.mass)?;
        require_positive("inertia", self.inertia)?;
        require_not_negative("to_a", self.to_a)?;
        require_not_negative("to_b", self.to_b)?;
        require_positive("to_a + to_b", self.to_a + self.to_b)
    }

    /// `k = (J − mab)/(J + mb²)`; for a uniform rod `(l² − 12ab)/(l² + 12b²)`. Where k > 0 the rod goes on with k ω₀.
    ///
    /// # Example
    /// ```
    /// let rod = carom_theory::rocking::SupportedRod::uniform(1.0, 2.0, [0.5, 0.5]);
    /// assert!((rod.k() - 1.0 / 7.0).abs() < 1e-16); // (4 − 3)/(4 + 3)
    /// ```
    pub fn k(&self) -> f64 {
        let Self { mass: m, inertia: j, to_a: a, to_b: b } = *self;
        (j - m * a * b) / (j + m * b * b)
    }

    /// Roll rate with which the rod, released from rest at the angle α about A, arrives level: `√(2mga sin α/(J + ma²))` [rad/s].
    ///
    /// # Example
    /// ```
    /// let rod = carom_theory::rocking::SupportedRod::uniform(1.0, 2.0, [0.5, 0.5]); // J + ma² = 7/12
    /// let rate = rod.release_rate(9.8, 30f64.to_radians());
    /// assert!((rate * rate - 8.4).abs() < 1e-13); // 4.9 · 12/7
    /// ```
    pub fn release_rate(&self, gravity: f64, angle: f64) -> f64 {
        let Self { mass: m, inertia: j, to_a: a, .. } = *self;
        (2.0 * m * gravity * a * libm::sin(angle) / (j + m * a * a)).sqrt()
    }

    /// The plastic strike of a rod that turns about A with ω₀ > 0 and arrives level on B.
    ///
    /// ```text
    /// J ≤ mab:  N_A = ω₀(mab − J)/(a+b),  N_B = ω₀(J + ma²)/(a+b),       it stops
    /// J > mab:  N_A = 0,  N_B = mJω₀(a+b)/(J + mb²),                      ω⁺ = kω₀, v_y = kbω₀
    /// ```
    ///
    /// # Errors
    /// A quantity outside its domain.
    ///
    /// # Source
    /// Polukoshko, Viba and others, for the uniform rod (12ab against l²).
    ///
    /// # Example
    /// ```
    /// use carom_theory::rocking::{RodState, SupportedRod};
    /// // Supported at its ends the rod stops: N_A = m ω₀ l/6, N_B = m ω₀ l/3.
    /// let (state, strike) = SupportedRod::uniform(1.0, 1.0, [0.5, 0.5]).strike(6.0)?;
    /// assert_eq!(state, RodState::Stops);
    /// assert!((strike.normal[0] - 1.0).abs() < 1e-14 && (strike.normal[1] - 2.0).abs() < 1e-14);
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn strike(&self, roll_rate: f64) -> Result<(RodState, Strike), OutsideDomain> {
        self.check()?;
        require_positive("roll rate", roll_rate)?;
        let Self { mass: m, inertia: j, to_a: a, to_b: b } = *self;
        let stays = m * a * b >= j;
        let k = if stays { 0.0 } else { self.k() };
        let normal = if stays {
            [roll_rate * (m * a * b - j) / (a + b), roll_rate * (j + m * a * a) / (a + b)]
        } else {
            [0.0, m * j * roll_rate * (a + b) / (j + m * b * b)]
        };
        let strike = Strike {
            velocity_before: [0.0, -roll_rate * a],
            roll_rate_before: roll_rate,
            velocity: [0.0, k * b * roll_rate],
            roll_rate: k * roll_rate,
            normal,
            tangential: Tangential::Each([0.0, 0.0]),
        };
        Ok((if stays { RodState::Stops } else { RodState::TurnsAboutB }, strike))
    }
}
