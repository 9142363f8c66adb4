//! End states of the cylinder's strike, judged at the end of compression only: besides the staged answer, wedged rest.

use super::Cylinder;

/// All impulses that stop the rolling cylinder within both friction cones: `start + λ·direction` with 0 ≤ λ ≤ `length`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RestImpulses {
    /// (N_A, T_A, N_K, T_K) with the least N_K [N s].
    pub start: [f64; 4],
    /// (1, 1/τ, 1, −1/τ), τ = tan γ: a push along the chord K–A, which does not move the body.
    pub direction: [f64; 4],
    /// How far [N s]; infinite where the chord lies in the cones.
    pub length: f64,
}

impl Cylinder {
    /// The numbers of all states of which the end satisfies Signorini's and Coulomb's laws: {1}, {2}, {3}, {4}, {1,4}, {2,4} or {3,4}.
    ///
    /// The first is the one that the stages reach; a second, 4, is rest by wedging ([`Cylinder::may_wedge`]).
    ///
    /// # Source
    /// Derived here.
    ///
    /// # Example
    /// ```
    /// let ring = |f: f64| carom_theory::rocking::Cylinder {
    ///     mass: 1.0, radius: 1.0, inertia_ratio: 1.0, friction: f, half_angle: 60f64.to_radians(),
    /// };
    /// assert_eq!(ring(0.3).end_states(), [3]);
    /// assert_eq!(ring(0.7).end_states(), [2, 4]); // 0.7 tan 60° > 1
    /// ```
    pub fn end_states(&self) -> Vec<u8> {
        let mut all = vec![self.state().number()];
        if self.may_wedge() {
            all.push(4);
        }
        all
    }

    /// The impulses that bring the cylinder to rest, sticking at both contacts; `None` where no such impulses obey both cones.
    ///
    /// ```text
    /// in units of m, a, ω₀:   T_K = ((1+b) − s N_K)/(1 − c),   T_A = b − T_K,   N_A = N_K − s(1+b)/(1−c)
    /// ```
    ///
    /// Four unknowns, three equations: one of them, N_K, is free within the bounds that N_A ≥ 0, |T_A| ≤ f N_A and |T_K| ≤ f N_K set.
    ///
    /// # Source
    /// Derived here.
    ///
    /// # Example
    ///
    /// A ring, f = 1, γ = 60°: the least impulses stand on the cone of A, T_A = N_A.
    ///
    /// ```
    /// let ring = carom_theory::rocking::Cylinder {
    ///     mass: 1.0, radius: 1.0, inertia_ratio: 1.0, friction: 1.0, half_angle: 60f64.to_radians(),
    /// };
    /// let rest = ring.rest_impulses(1.0).ok_or("no rest")?;
    /// assert!((rest.start[0] - rest.start[1]).abs() < 1e-14);
    /// assert!(rest.length.is_infinite());
    /// # Ok::<(), &str>(())
    /// ```
    pub fn rest_impulses(&self, roll_rate: f64) -> Option<RestImpulses> {
        let l = self.letters();
        let (b, f, s) = (l.b, l.f, l.s);
        let (k, chord) = ((1.0 + b) / l.versine, 1.0 / l.tau);
        // Each condition as (constant, slope) in N_K: constant + slope N_K ≥ 0, for N_A, f N_A ± T_A and f N_K ± T_K.
        let conditions: [(f64, f64); 5] = [
            (-s * k, 1.0),
            (-f * s * k + b - k, f + chord),
            (-f * s * k - b + k, f - chord),
            (k, f - chord),
            (-k, f + chord),
        ];
        let (mut low, mut high) = (0.0f64, f64::INFINITY);
        for (constant, slope) in conditions {
            if slope > 0.0 {
                low = low.max(-constant / slope);
            } else if slope < 0.0 {
                high = high.min(-constant / slope);
            } else if constant < 0.0 {
                return None;
            }
        }
        let unit = self.mass * self.radius * roll_rate;
        let held = k - chord * low;
        let start = [low - s * k, b - held, low, held].map(|p| unit * p);
        let direction = [1.0, chord, 1.0, -chord];
        (low <= high).then_some(RestImpulses { start, direction, length: unit * (high - low) })
    }
}
