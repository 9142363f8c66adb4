//! Where one outcome of a strike in space gives way to another.

use super::Stool;
use super::stool::Approach;
use crate::rocking::Border;
use crate::vectors::{cross, dot, minus, solved, times};

/// A body that turns about its edge OA, O its apex on the axis of its inertia, until the corner K strikes the plane.
///
/// It is a pyramid as far as the strike knows it: three points and two moments. The half angle between A and K as seen along the axis is π/n for a
/// regular base on n sides, and any other angle between.
///
/// # Example
/// A homogeneous square pyramid as high as its circumradius, q = 2/3: `J_a = 0.3 q`, and the mass centre at
/// 3/4.
/// ```
/// let square = carom_theory::spatial::LateralRoll::homogeneous(4.0, 1.0);
/// assert!((square.inertia_axial - 0.2).abs() < 1e-16);
/// assert_eq!(square.apex_to_centre, 0.75);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LateralRoll {
    /// In (0, π/2) \[rad\].
    pub half_angle: f64,
    /// h > 0, from the apex to the plane of A and K, along the axis \[m\].
    pub height: f64,
    /// a > 0, distance of A and K from the axis \[m\].
    pub circumradius: f64,
    /// d, from the apex to the mass centre, along the axis \[m\].
    pub apex_to_centre: f64,
    /// m > 0 \[kg\].
    pub mass: f64,
    /// J_t > 0, about the mass centre, across the axis [kg m²].
    pub inertia_transverse: f64,
    /// J_a > 0, about the axis [kg m²].
    pub inertia_axial: f64,
}

impl LateralRoll {
    /// A homogeneous pyramid of 1 kg and circumradius 1 m on n sides, as its moments go on between whole n:
    /// `J_t = 3 q/20 + 3 h²/80`, `J_a = 3 q/10`, `q = 1 − (2/3) sin²(π/n)`.
    ///
    /// # Example
    /// On a square the height √(2/3) is critical: the first border.
    /// ```
    /// use carom_theory::spatial::LateralRoll;
    /// let square = LateralRoll::homogeneous(4.0, (2.0f64 / 3.0).sqrt());
    /// assert!(square.borders()[0].residual.abs() < 1e-16);
    /// ```
    pub fn homogeneous(sides: f64, height: f64) -> Self {
        let half_angle = core::f64::consts::PI / sides;
        let sin = libm::sin(half_angle);
        let q = 1.0 - 2.0 / 3.0 * sin * sin;
        Self {
            half_angle,
            height,
            circumradius: 1.0,
            apex_to_centre: 0.75 * height,
            mass: 1.0,
            inertia_transverse: 0.15 * q + 0.0375 * height * height,
            inertia_axial: 0.3 * q,
        }
    }

    /// The ratio of height to circumradius at which T = 0 ([`LateralRoll::borders`]): `h² = 0.15 i q a²/(c (1 − c) − 0.0375 i)`. The mass centre
    /// lies at the fraction c = `centre` of the height from the apex; moments are i = `inertia` times those of [`LateralRoll::homogeneous`].
    /// `None` where no height has T = 0.
    ///
    /// # Example
    /// ```
    /// use carom_theory::spatial::{LateralRoll, Pyramid};
    /// let printed = Pyramid { sides: 5, height: 1.0, circumradius: 1.0, mass: 1.0 }.critical_height();
    /// assert!((LateralRoll::critical_ratio(5.0, 0.75, 1.0).unwrap() - printed).abs() < 1e-15);
    /// assert_eq!(LateralRoll::critical_ratio(5.0, 0.99, 1.0), None);
    /// ```
    pub fn critical_ratio(sides: f64, centre: f64, inertia: f64) -> Option<f64> {
        let sin = libm::sin(core::f64::consts::PI / sides);
        let polygon = 1.0 - 2.0 / 3.0 * sin * sin;
        let reach = centre * (1.0 - centre) - 0.0375 * inertia;
        (reach > 0.0).then(|| (0.15 * inertia * polygon / reach).sqrt())
    }

    /// The five curves between its outcomes under the non-sliding law: 1 O and K stay, 2 K alone, 3 all three (it stops), 4 A and K, 5 no state.
    ///
    /// ```text
    /// 1|2, 3|4   T = 0             T = J_t − m d (h − d): the apex's normal impulse vanishes
    /// 1|3        E = 0, T ≤ 0      E = J_a h² + (J_t + m d²) a² cos 2φ: A neither separates nor approaches
    /// 4|5        F = 0, T ≥ 0      A's normal impulse beside K's:
    ///                              F = T a² C² + J_a h² + m a² d h cos 2φ − m a² S² T (a² C² + h (h − d))/I_y,
    ///                              I_y = J_t + m ((h − d)² + a² C²), C = cos φ, S = sin φ
    /// 2|5        G = 0, T ≥ 0      A's normal velocity where K stays alone: G = v_A·N, ω₁ = ω₀ − m v J_K⁻¹ (s × N)
    /// ```
    ///
    /// All but the last two meet where T = E = 0. The last two do not: where A's normal impulse vanishes friction still acts on A, so that this
    /// state is not the one without A. For a homogeneous pyramid T = 0 is the printed criterion, and E > 0 for n ≥ 4, E < 0 for n = 3.
    ///
    /// # Source
    /// T: Polukoshko, Viba and others, on simultaneous collisions of rolling bodies, section 5.1; E and F are ours, from the angular momenta about
    /// OK, and about the line through K across AK.
    ///
    /// # Limits
    /// The normal impulse at K is taken to be positive, as it is for homogeneous pyramids.
    ///
    /// # Example
    /// A square pyramid as high as its circumradius: T = 0.1375 − 0.75 · 0.25, and E = J_a h², since cos 2φ =
    /// 0.
    /// ```
    /// let [apex, _, long, ..] = carom_theory::spatial::LateralRoll::homogeneous(4.0, 1.0).borders();
    /// assert!(apex.states == [1, 2] && (apex.residual + 0.05).abs() < 1e-16);
    /// assert!(long.states == [1, 3] && (long.residual - 0.2).abs() < 1e-15);
    /// ```
    pub fn borders(&self) -> [Border; 5] {
        let Self { height: h, circumradius: a, apex_to_centre: d, mass: m, .. } = *self;
        let (j_t, j_a) = (self.inertia_transverse, self.inertia_axial);
        let (sin, cos) = libm::sincos(self.half_angle);
        let (a2, double) = (a * a, (cos - sin) * (cos + sin));
        let apex = j_t - m * d * (h - d);
        let long = j_a * h * h + (j_t + m * d * d) * a2 * double;
        let about_base = j_t + m * ((h - d) * (h - d) + a2 * cos * cos);
        let lever = m * a2 * sin * sin * (a2 * cos * cos + h * (h - d)) / about_base;
        let base = apex * (a2 * cos * cos - lever) + j_a * h * h + m * a2 * d * h * double;
        let border = |states, residual, applies| Border { states, residual, applies };
        [
            border([1, 2], apex, long > 0.0),
            border([3, 4], apex, long < 0.0),
            border([1, 3], long, apex <= 0.0),
            border([4, 5], base, apex >= 0.0),
            border([2, 5], self.separation_beside_k(sin, cos), apex >= 0.0),
        ]
    }

    /// A's normal velocity where K stays alone, times the lateral edge, at a roll rate of 1 rad/s [m²/s].
    fn separation_beside_k(&self, sin: f64, cos: f64) -> f64 {
        let Self { height: h, circumradius: a, apex_to_centre: d, mass: m, .. } = *self;
        let slant = (h * h + a * a * cos * cos).sqrt();
        let normal = [-h / slant, 0.0, a * cos / slant];
        let s = [-a * cos, -a * sin, d - h];
        let central = [self.inertia_transverse, self.inertia_transverse, self.inertia_axial];
        let about_k = |i: usize, j: usize| {
            let own = if i == j { central[i] + m * dot(s, s) } else { 0.0 };
            own - m * s[i] * s[j]
        };
        let about_k = [0, 1, 2].map(|i| [0, 1, 2].map(|j| about_k(i, j)));
        let pulled = times(2.0 * m * a * sin * slant, cross(s, normal));
        let spin = minus(times(-1.0, [a * cos, -a * sin, h]), solved(about_k, pulled));
        dot(cross(spin, [0.0, -2.0 * a * sin, 0.0]), normal)
    }
}

impl Stool {
    /// The state of its strike on the neighbour K of its support O under the non-sliding law: 1 both stay, 2 K alone, 3 either of these, 4 neither.
    ///
    /// # Example
    /// A cube that comes down almost flat leaves O, and K stays alone.
    /// ```
    /// use carom_theory::spatial::{Approach, Stool};
    /// let cube = Stool { supports: 4, circle_radius: 0.5f64.sqrt(), centre_height: 0.5, mass: 1.0,
    ///     inertia_transverse: 1.0 / 6.0, inertia_axial: 1.0 / 6.0 };
    /// assert_eq!(cube.outcome(&Approach { tilting: 0.0, closing: 1.0, swinging: 0.0, tilt: 0.0 }), 2);
    /// ```
    pub fn outcome(&self, approach: &Approach) -> u8 {
        let [both, next] = self.consistent(approach);
        match (both, next) {
            (true, false) => 1,
            (false, true) => 2,
            (true, true) => 3,
            (false, false) => 4,
        }
    }

    /// The curves between the four outcomes of [`Stool::outcome`], by the smaller of the two numbers that a state must not have negative.
    ///
    /// ```text
    /// 1|4, 2|3   min(N_O, N_K) = 0     where both are kept
    /// 2|4, 1|3   min(N_K, m v_O·N) = 0 where K is kept alone
    /// 1|2        κ² = −a² cos 2π/n     with J_z = J_t: there one state gives way to the other
    /// 3|4        γ p c = β κ²          flat, δ = 0: all normal impulses vanish
    /// ```
    ///
    /// # Example
    /// ```
    /// use carom_theory::spatial::{Approach, Stool};
    /// let tripod = Stool { supports: 3, circle_radius: 1.0, centre_height: 0.5, mass: 1.0, inertia_transverse: 0.25, inertia_axial: 0.3 };
    /// let flat = Approach { tilting: 0.0, closing: 1.0, swinging: 0.4, tilt: 0.0 };
    /// assert!(tripod.borders(&flat)[4].residual.abs() < 1e-15);
    /// assert!(tripod.borders(&flat)[0].residual.abs() < 1e-15);
    /// ```
    pub fn borders(&self, approach: &Approach) -> [Border; 6] {
        let ([at_o, at_k], next) = (self.on_both(approach).normal, self.on_next(approach));
        let [both_hold, next_holds] = self.consistent(approach);
        let (both, alone) = (at_o.min(at_k), next.normal.min(self.mass * next.separation));
        let (cos, sin) = self.half_angle();
        let edges = self.circle_radius * self.circle_radius * (cos - sin) * (cos + sin);
        let turns = at_k > 0.0 && next.normal > 0.0 && self.inertia_axial == self.inertia_transverse;
        let vanish = approach.tilt == 0.0 && next.separation > 0.0 && (next.normal > 0.0) == (at_k > 0.0);
        let border = |states, residual, applies| Border { states, residual, applies };
        [
            border([1, 4], both, !next_holds),
            border([2, 3], both, next_holds),
            border([2, 4], alone, !both_hold),
            border([1, 3], alone, both_hold),
            border([1, 2], self.gyration_squared() + edges, turns),
            border([3, 4], both, vanish),
        ]
    }

    fn consistent(&self, approach: &Approach) -> [bool; 2] {
        let both = self.on_both(approach).normal;
        let next = self.on_next(approach);
        [both.iter().all(|n| *n >= 0.0), next.normal >= 0.0 && next.separation >= 0.0]
    }
}
