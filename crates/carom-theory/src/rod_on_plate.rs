//! A body that slides with one end on a plate: normal force and equations of motion.
//!
//! In the contact frame the end K is on the plate and the mass centre is at `K + ℓ (cos θ, sin θ)`. With `s` the sign of the slip
//! of K and the gravity `(g_t, −g_n)` (g_n > 0 presses the end on the plate):
//!
//! ```text
//! N = (g_n − ℓ sin θ θ̇²)/A(θ),   A = 1/m + (ℓ²/J) cos θ (cos θ + sμ sin θ) = W_nn − sμW_tn
//! θ̈ = −(ℓ/J) (cos θ + sμ sin θ) N
//! ẍ_K = g_t − sμN/m + ℓ (sin θ θ̈ + cos θ θ̇²)
//! ```
//!
//! `A ≤ 0` is Painlevé's case: no such force, or two.
//!
//! Source: Painlevé (1895); Génot and Brogliato, Eur. J. Mech. A/Solids 18 (1999) 653.

/// A body and the plate one of its ends slides on.
///
/// # Example
/// A level uniform rod that is let go with one end on a smooth floor: N = mg/4.
/// ```
/// use carom_theory::rod_on_plate::{EndState, SlidingEnd};
/// let rod = SlidingEnd { mass: 2.0, inertia: 2.0 / 3.0, arm: 1.0, friction: 0.0, gravity: [0.0, 10.0] };
/// let motion = rod.motion(&EndState { angle: 0.0, spin: 0.0, slip: 0.0 });
/// assert!((motion.normal_force - 5.0).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlidingEnd {
    /// m > 0 \[kg\].
    pub mass: f64,
    /// J > 0 about the mass centre [kg m²].
    pub inertia: f64,
    /// ℓ > 0 from the end to the mass centre \[m\].
    pub arm: f64,
    /// μ ≥ 0.
    pub friction: f64,
    /// Gravity `(g_t, g_n)`: along t, and against n [m/s²]. On a plate that slopes down by α towards +t: `(g sin α, g cos α)`.
    pub gravity: [f64; 2],
}

/// State of a sliding end.
///
/// # Example
/// An upright rod whose end slips: friction brakes it by μg (1 + mℓ²/J) = 4 μg, to either side.
/// ```
/// use carom_theory::rod_on_plate::{EndState, SlidingEnd};
/// let rod = SlidingEnd { mass: 1.0, inertia: 1.0 / 3.0, arm: 1.0, friction: 0.5, gravity: [0.0, 10.0] };
/// let upright = EndState { angle: 90f64.to_radians(), spin: 0.0, slip: 1.0 };
/// assert!((rod.motion(&upright).slip_rate + 20.0).abs() < 1e-13);
/// assert!((rod.motion(&EndState { slip: -1.0, ..upright }).slip_rate - 20.0).abs() < 1e-13);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EndState {
    /// θ, from t to the direction end → mass centre \[rad\].
    pub angle: f64,
    /// θ̇, counter-clockwise [rad/s].
    pub spin: f64,
    /// Slip of the end along t [m/s]; its sign s sets the friction, 0 means none.
    pub slip: f64,
}

/// Force and accelerations of a sliding end.
///
/// # Example
/// A level rod that turns on a smooth floor: the mass centre does not move along it, so that the end does by
/// ℓθ̇².
/// ```
/// use carom_theory::rod_on_plate::{EndState, SlidingEnd};
/// let rod = SlidingEnd { mass: 1.0, inertia: 1.0 / 3.0, arm: 1.0, friction: 0.0, gravity: [0.0, 10.0] };
/// let motion = rod.motion(&EndState { angle: 0.0, spin: 2.0, slip: 0.0 });
/// assert_eq!(motion.slip_rate, 4.0);
/// // J θ̈ = −ℓ N
/// assert!((motion.spin_rate / 3.0 + motion.normal_force).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EndMotion {
    /// N \[N\]; the end lifts off where it would be negative (with A > 0).
    pub normal_force: f64,
    /// Rate of the slip [m/s²].
    pub slip_rate: f64,
    /// θ̈ [rad/s²].
    pub spin_rate: f64,
}

impl SlidingEnd {
    /// `A = W_nn − sμW_tn` at this angle and slip [1/kg]: how strongly pressing the sliding end lifts it.
    ///
    /// # Example
    ///
    /// A uniform rod (J = mℓ²/3) with μ = 4/3 at tan θ = 2, slipping so that friction digs it in: A = 0.
    ///
    /// ```
    /// use carom_theory::rod_on_plate::{EndState, SlidingEnd};
    /// let rod = SlidingEnd { mass: 1.0, inertia: 1.0 / 3.0, arm: 1.0, friction: 4.0 / 3.0, gravity: [0.0, 10.0] };
    /// let a = rod.normal_response(&EndState { angle: 2.0f64.atan(), spin: 0.0, slip: -1.0 });
    /// assert!(a.abs() < 1e-15);
    /// ```
    pub fn normal_response(&self, state: &EndState) -> f64 {
        let (sin, cos) = libm::sincos(state.angle);
        1.0 / self.mass + self.arm * self.arm / self.inertia * cos * (cos + self.drag(state) * sin)
    }

    /// Normal force and accelerations while the end slides on the plate.
    ///
    /// # Limits
    /// N has no meaning for A ≤ 0, and loses digits in proportion to `(W_nn + μ|W_tn|)/A` close to it.
    ///
    /// # Example
    ///
    /// A uniform rod held at 45° on a frictionless floor and let go: N = mg/(1 + 3 cos²θ) = 0.4 mg.
    ///
    /// ```
    /// use carom_theory::rod_on_plate::{EndState, SlidingEnd};
    /// let rod = SlidingEnd { mass: 1.0, inertia: 1.0 / 3.0, arm: 1.0, friction: 0.0, gravity: [0.0, 10.0] };
    /// let motion = rod.motion(&EndState { angle: std::f64::consts::FRAC_PI_4, spin: 0.0, slip: 0.0 });
    /// assert!((motion.normal_force - 4.0).abs() < 1e-14);
    /// ```
    pub fn motion(&self, state: &EndState) -> EndMotion {
        let (sin, cos) = libm::sincos(state.angle);
        let (l, drag, square) = (self.arm, self.drag(state), state.spin * state.spin);
        let normal = (self.gravity[1] - l * sin * square) / self.normal_response(state);
        let spin_rate = -l / self.inertia * (cos + drag * sin) * normal;
        EndMotion {
            normal_force: normal,
            slip_rate: self.gravity[0] - drag * normal / self.mass + l * (sin * spin_rate + cos * square),
            spin_rate,
        }
    }

    /// sμ.
    fn drag(&self, state: &EndState) -> f64 {
        if state.slip == 0.0 { 0.0 } else { state.slip.signum() * self.friction }
    }
}
