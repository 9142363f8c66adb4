//! Forces in the inner corner, where the edge slips out of it, and how a part that flies or slides is caught by it.

use super::HookedPart;
use crate::rod_on_edge::{EdgeState, PartOnEdge};
use core::f64::consts::PI;

/// What a part does that an edge has caught in its inner corner.
///
/// # Example
/// Struck straight below the corner nothing turns; all of the momentum is taken, 2 · 3.
/// ```
/// use carom_theory::hooked_part::HookedPart;
/// let part = HookedPart { mass: 2.0, inertia: 2.0, arm: 1.0, normals: [0.8; 2], gravity: 10.0 };
/// let caught = part.caught(0.0, [0.0, -3.0], 0.0);
/// assert_eq!((caught.tilt_rate, caught.impulse), (0.0, [6.0, 0.0]));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Caught {
    /// φ̇ after it [rad/s].
    pub tilt_rate: f64,
    /// Impulse of the edge on the part along u and e [N s].
    pub impulse: [f64; 2],
}

impl HookedPart {
    /// Force of the edge on the part along u, from the mass centre to the corner, and along e, at `[φ, φ̇]` \[N\]:
    /// `m(g cos φ + hφ̇²)` and `mg sin φ J/(J + mh²)`.
    ///
    /// # Example
    /// ```
    /// use carom_theory::hooked_part::HookedPart;
    /// let part = HookedPart { mass: 2.0, inertia: 2.0, arm: 1.0, normals: [0.8; 2], gravity: 10.0 };
    /// assert_eq!(part.edge_force([0.0, 3.0]), [38.0, 0.0]);
    /// ```
    pub fn edge_force(&self, [tilt, rate]: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = libm::sincos(tilt);
        let along = self.mass * (self.gravity * cos + self.arm * rate * rate);
        [along, self.mass * self.gravity * sin * self.inertia / self.inertia_about_edge()]
    }

    /// Normal forces of the left and the right face that make up a force along u and e without friction \[N\], or impulses [N s]; one is
    /// negative where the edge slips out.
    ///
    /// ```text
    /// N_l = (R_u sin ν_r − R_e cos ν_r)/sin(ν_l + ν_r),   N_r = (R_u sin ν_l + R_e cos ν_l)/sin(ν_l + ν_r)
    /// ```
    ///
    /// # Example
    /// ```
    /// use carom_theory::hooked_part::HookedPart;
    /// let eighth = std::f64::consts::FRAC_PI_4;
    /// let part = HookedPart { mass: 2.0, inertia: 2.0, arm: 1.0, normals: [eighth; 2], gravity: 10.0 };
    /// let [left, right] = part.face_forces([16.0, 6.0]);
    /// assert!((left - 10.0 * 0.5f64.sqrt()).abs() < 1e-14 && (right - 22.0 * 0.5f64.sqrt()).abs() < 1e-14);
    /// ```
    pub fn face_forces(&self, [along, across]: [f64; 2]) -> [f64; 2] {
        let [left, right] = self.normals.map(libm::sincos);
        let between = libm::sin(self.normals[0] + self.normals[1]);
        [(along * right.0 - across * right.1) / between, (along * left.0 + across * left.1) / between]
    }

    /// True if a force, or an impulse, along u and e keeps the edge in the corner: it is within the friction cones of the faces or between
    /// them.
    ///
    /// # Limits
    /// From an angle of friction of half of the hollow's, λ = γ/2, on every force can be held, as by a wedge that is driven in; it need not be.
    ///
    /// # Example
    /// Hung evenly, in a hollow of 90°: up to 45° without friction.
    /// ```
    /// use carom_theory::hooked_part::HookedPart;
    /// let eighth = std::f64::consts::FRAC_PI_4;
    /// let part = HookedPart { mass: 2.0, inertia: 2.0, arm: 1.0, normals: [eighth; 2], gravity: 10.0 };
    /// assert!(part.holds([3.0, 2.9], 0.0) && !part.holds([3.0, 3.1], 0.0) && part.holds([3.0, 3.1], 0.1));
    /// ```
    pub fn holds(&self, [along, across]: [f64; 2], friction: f64) -> bool {
        let [left, right] = self.cone(friction).map(libm::sincos);
        self.is_wedged(friction) || across * right.1 <= along * right.0 && -across * left.1 <= along * left.0
    }

    /// θ_l and θ_r, ν and the angle of friction: how far the force may lie to either side of u \[rad\].
    fn cone(&self, friction: f64) -> [f64; 2] {
        self.normals.map(|normal| normal + libm::atan(friction))
    }

    /// True from λ = γ/2 on.
    fn is_wedged(&self, friction: f64) -> bool {
        let [left, right] = self.cone(friction);
        left + right >= PI
    }

    /// Tilts at which the edge slips out of the corner on the swing through `[φ₀, φ̇₀]` \[rad\]: to the left, where the right face opens and the
    /// left one slides, and to the right; `None` where the part turns before, or goes over the top without.
    ///
    /// ```text
    /// (J/J_K) cos θ sin |φ| = sin θ ((1 + 2κ) cos φ − 2κ E),   J_K = J + mh²,  κ = mh²/J_K,  E = cos φ₀ − φ̇₀²/(2ω₀²)
    /// ```
    ///
    /// It says R_e cos θ = R_u sin θ. On the way out the left side grows and the right one falls, so that it does not stay before; E is the
    /// cosine of the amplitude, if there is one.
    ///
    /// # Limits
    /// ν + λ > 0 on both sides: else it does not even hang at rest.
    ///
    /// # Example
    /// At the turn the force is that of a part let go there: tan φ = 2 tan θ with J = J_K/2.
    /// ```
    /// use carom_theory::hooked_part::HookedPart;
    /// let eighth = std::f64::consts::FRAC_PI_4;
    /// let part = HookedPart { mass: 2.0, inertia: 2.0, arm: 1.0, normals: [eighth; 2], gravity: 10.0 };
    /// let turn = 2f64.atan();
    /// let right = part.slipping_tilts([turn + 1e-9, 0.0], 0.0)[1].expect("just before the turn");
    /// assert!((right - turn).abs() < 2e-9);
    /// assert_eq!(part.slipping_tilts([turn - 1e-9, 0.0], 0.0), [None; 2]);
    /// ```
    pub fn slipping_tilts(&self, start: [f64; 2], friction: f64) -> [Option<f64>; 2] {
        let turning = self.inertia / self.inertia_about_edge();
        let carried = 1.0 - turning;
        let energy = libm::cos(start[0]) - start[1] * start[1] / (2.0 * self.stiffness());
        let out = |side: f64| {
            let (sin, cos) = libm::sincos(side);
            let (a, b, c) = (turning * cos, (1.0 + 2.0 * carried) * sin, 2.0 * carried * sin * energy);
            let size = libm::hypot(a, b);
            let tilt = libm::atan2(b, a) - libm::asin(c / size);
            let reached = tilt < PI && libm::cos(tilt) >= energy;
            (reached && !self.is_wedged(friction)).then_some(tilt)
        };
        let [left, right] = self.cone(friction);
        [out(left).map(|tilt| -tilt), out(right)]
    }

    /// Amplitude up to which the part swings without slipping out, `tan A = (1 + mh²/J) tan(ν + λ)` with the smaller ν \[rad\]; `None` where no
    /// force brings it out.
    ///
    /// # Limits
    /// As [`HookedPart::slipping_tilts`]; the plate stays inside of the hollow, [`HookedPart::lying_tilts`].
    ///
    /// # Example
    /// ```
    /// use carom_theory::hooked_part::HookedPart;
    /// let part = HookedPart { mass: 2.0, inertia: 2.0, arm: 1.0, normals: [1.5f64.atan(), 0.5f64.atan()], gravity: 10.0 };
    /// let amplitude = part.largest_amplitude(0.0).expect("smooth");
    /// assert!((amplitude.tan() - 1.0).abs() < 1e-15);
    /// ```
    pub fn largest_amplitude(&self, friction: f64) -> Option<f64> {
        let [left, right] = self.cone(friction);
        let (sin, cos) = libm::sincos(left.min(right));
        let about = self.inertia_about_edge() * sin;
        (!self.is_wedged(friction)).then(|| libm::atan2(about, self.inertia * cos))
    }

    /// What a part does that is caught: its corner strikes the edge at a tilt φ, its mass centre having a velocity (to the right, up) [m/s], and
    /// its spin being ω [rad/s]. Nothing rebounds.
    ///
    /// ```text
    /// (J + mh²) φ̇ = Jω + mh(v_x cos φ + v_y sin φ)
    /// ```
    ///
    /// # Limits
    /// The impulse [holds](HookedPart::holds) the edge in the corner; other contacts that the part has open by it.
    ///
    /// # Source
    /// Routh, Elementary Part, on a point that is suddenly fixed: the moment of momentum about it is kept.
    ///
    /// # Example
    /// ```
    /// use carom_theory::hooked_part::HookedPart;
    /// let part = HookedPart { mass: 2.0, inertia: 2.0, arm: 1.0, normals: [0.8; 2], gravity: 10.0 };
    /// let caught = part.caught(0.0, [-4.0, 0.0], 0.0);
    /// assert_eq!((caught.tilt_rate, caught.impulse), (-2.0, [0.0, 4.0])); // mhv/J_K = 8/4; 2 (4 − 2)
    /// ```
    pub fn caught(&self, tilt: f64, velocity: [f64; 2], spin: f64) -> Caught {
        let (sin, cos) = libm::sincos(tilt);
        let outward = velocity[1] * cos - velocity[0] * sin;
        let around = velocity[0] * cos + velocity[1] * sin;
        let (m, h) = (self.mass, self.arm);
        let tilt_rate = (self.inertia * spin + m * h * around) / self.inertia_about_edge();
        Caught { tilt_rate, impulse: [-m * outward, m * (h * tilt_rate - around)] }
    }

    /// The part as it slips out at `[φ, φ̇]`, its left face (0) or its right face (1) on the edge: on a level plate, with x to the right for the
    /// left face and to the left for the right one. The slip is the smallest there is, so that friction knows its direction.
    ///
    /// # Limits
    /// The mass centre is on the side of the face on which the edge is, so that c < 0.
    ///
    /// # Example
    /// Until it slips it turns like the pendulum: φ̈ = −5 sin 30°, and φ = −φ_edge − ν_l.
    /// ```
    /// use carom_theory::hooked_part::HookedPart;
    /// let part = HookedPart { mass: 2.0, inertia: 2.0, arm: 1.0, normals: [0.2; 2], gravity: 10.0 };
    /// let tilt = part.slipping_tilts([-1.0, 0.0], 0.0)[0].expect("it slips");
    /// let rate = part.rate_squared([-1.0, 0.0], tilt).sqrt();
    /// let (board, state) = part.slipping(0, [tilt, rate], 0.0);
    /// let motion = board.motion(&state);
    /// assert!((motion.tilt_acceleration - 5.0 * tilt.sin()).abs() < 1e-14 && motion.slip_rate.abs() < 1e-14);
    /// ```
    pub fn slipping(&self, face: usize, [tilt, rate]: [f64; 2], friction: f64) -> (PartOnEdge, EdgeState) {
        let normal = self.normals[face];
        let (sin, cos) = libm::sincos(normal);
        let mirror = if face == 0 { -1.0 } else { 1.0 };
        let part = PartOnEdge {
            mass: self.mass,
            inertia: self.inertia,
            half_thickness: -self.arm * cos,
            friction,
            slope: 0.0,
            gravity: self.gravity,
        };
        let state = EdgeState {
            reach: -self.arm * sin,
            tilt: mirror * tilt - normal,
            slip: f64::MIN_POSITIVE,
            tilt_rate: mirror * rate,
        };
        (part, state)
    }
}
