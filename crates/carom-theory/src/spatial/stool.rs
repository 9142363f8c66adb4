//! A body on n supports on a circle, which rocks and wobbles on a plane until it rests.

use crate::OutsideDomain;
use crate::domain::{require, require_finite, require_positive};
use crate::vectors::{V, solved};

/// A body with n point supports, evenly on a circle, whose inertia is that of a body of revolution about the circle's axis.
///
/// # Example
/// With κ² = 2 and a = d = 1 it goes on with (2 − 1)/(2 + 1) of its angular velocity.
/// ```
/// let stool = carom_theory::spatial::Stool {
///     supports: 4, circle_radius: 1.0, centre_height: 0.5, mass: 1.0,
///     inertia_transverse: 1.75, inertia_axial: 1.0,
/// };
/// assert!((stool.flat_from_support() - 1.0 / 3.0).abs() < 1e-16);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stool {
    /// n ≥ 3.
    pub supports: u32,
    /// a > 0, radius of the circle of supports \[m\].
    pub circle_radius: f64,
    /// c > 0, of the mass centre above the supports \[m\].
    pub centre_height: f64,
    /// m > 0 \[kg\].
    pub mass: f64,
    /// J_t > 0, about the mass centre, across the axis [kg m²].
    pub inertia_transverse: f64,
    /// J_z > 0, about the axis [kg m²].
    pub inertia_axial: f64,
}

/// How a body that turns about its support O comes down on the neighbouring support K.
///
/// In axes (u, e, N): u from O to K, N the plane's normal, e = N × u towards the body's middle. The angular velocity is (α, β, γ).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Approach {
    /// α, the rate of the tilt about OK [rad/s].
    pub tilting: f64,
    /// β > 0, K's approach by its distance from O [rad/s].
    pub closing: f64,
    /// γ, K's inward speed by its distance from O [rad/s].
    pub swinging: f64,
    /// δ, the tilt about OK \[rad\].
    pub tilt: f64,
}

/// Both O and K stay.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnBoth {
    /// α₁, the rate of the tilt about OK after [rad/s]; it is the whole angular velocity.
    pub tilting: f64,
    /// Normal impulses at O and K [N s]: the state is consistent where neither is negative.
    pub normal: [f64; 2],
}

/// K stays alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnNext {
    /// Angular velocity after, in the axes (u, e, N) [rad/s].
    pub spin: [f64; 3],
    /// Normal impulse at K [N s].
    pub normal: f64,
    /// Normal velocity of O [m/s]: the state is consistent where neither this nor the impulse is negative.
    pub separation: f64,
}

/// Where the mass centre is, and the moments of inertia about the axes (u, e, N).
struct Tilted {
    /// l, half the distance of neighbouring supports; s_e, s_N [m].
    half: f64,
    across: f64,
    above: f64,
    /// I = J_t + m (p² + c²), about OK.
    about_line: f64,
    ee: f64,
    nn: f64,
    en: f64,
}

impl Stool {
    /// Checks that every quantity lies in its domain.
    ///
    /// # Errors
    ///
    /// The first quantity outside its domain.
    ///
    /// # Example
    /// ```
    /// use carom_theory::spatial::Stool;
    /// let low = Stool { supports: 4, circle_radius: 0.7, centre_height: 0.0, mass: 1.0,
    ///     inertia_transverse: 0.2, inertia_axial: 0.2 };
    /// assert_eq!(low.check().map_err(|error| error.quantity), Err("centre height"));
    /// assert_eq!(Stool { centre_height: 0.5, ..low }.check(), Ok(()));
    /// ```
    pub fn check(&self) -> Result<(), OutsideDomain> {
        require(self.supports >= 3, "supports", f64::from(self.supports), ">= 3")?;
        require_positive("circle radius", self.circle_radius)?;
        require_positive("centre height", self.centre_height)?;
        require_positive("mass", self.mass)?;
        require_positive("transverse inertia", self.inertia_transverse)?;
        require_positive("axial inertia", self.inertia_axial)
    }

    /// (cos, sin) of π/n.
    pub(super) fn half_angle(&self) -> (f64, f64) {
        let (sin, cos) = libm::sincos(core::f64::consts::PI / f64::from(self.supports));
        (cos, sin)
    }

    /// κ² = J_t/m + c² [m²].
    ///
    /// # Example
    /// A cube of edge 1 on its corners: `1/6 + 1/4 = 5/12`.
    /// ```
    /// use carom_theory::spatial::Stool;
    /// let cube = Stool { supports: 4, circle_radius: 0.5f64.sqrt(), centre_height: 0.5, mass: 1.0,
    ///     inertia_transverse: 1.0 / 6.0, inertia_axial: 1.0 / 6.0 };
    /// assert!((cube.gyration_squared() - 5.0 / 12.0).abs() < 1e-15);
    /// ```
    pub fn gyration_squared(&self) -> f64 {
        self.inertia_transverse / self.mass + self.centre_height * self.centre_height
    }

    /// The angular velocity about OK where both stay, from that before, in the body's axes at O: ξ along the circle away from K, η to the foot of the
    /// axis, ζ along it.
    ///
    /// ```text
    /// ω₁ = (−C J_ξ ω_ξ + S (J_η ω_η − J_ηζ ω_ζ)) / (J_η S² + J_ξ C²),   J_ξ = J_t + m (a² + c²), J_η = J_t + m c², J_ηζ = m a c
    /// ```
    ///
    /// The printed formula, which holds with moments about the support O, not about the mass centre, and `J_ηζ = +∫ η ζ dm`.
    ///
    /// # Example
    /// A turn about the line itself goes on: its direction is (−C, S, 0).
    /// ```
    /// use carom_theory::spatial::Stool;
    /// let cube = Stool { supports: 4, circle_radius: 0.5f64.sqrt(), centre_height: 0.5, mass: 1.0,
    ///     inertia_transverse: 1.0 / 6.0, inertia_axial: 1.0 / 6.0 };
    /// let along = 0.5f64.sqrt();
    /// assert!((cube.spin_about_line([-3.0 * along, 3.0 * along, 0.0]) - 3.0).abs() < 1e-14);
    /// ```
    pub fn spin_about_line(&self, spin: [f64; 3]) -> f64 {
        let (cos, sin) = self.half_angle();
        let (m, a, c) = (self.mass, self.circle_radius, self.centre_height);
        let (xi, eta) = (self.inertia_transverse + m * (a * a + c * c), self.inertia_transverse + m * c * c);
        let deviation = m * a * c;
        (-cos * xi * spin[0] + sin * (eta * spin[1] - deviation * spin[2]))
            / (eta * sin * sin + xi * cos * cos)
    }

    fn tilted(&self, tilt: f64) -> Tilted {
        let (cos, sin) = self.half_angle();
        let (sd, cd) = libm::sincos(tilt);
        let (p, c, m) = (self.circle_radius * cos, self.centre_height, self.mass);
        let (j, excess) = (self.inertia_transverse, self.inertia_axial - self.inertia_transverse);
        Tilted {
            half: self.circle_radius * sin,
            across: p * cd - c * sd,
            above: p * sd + c * cd,
            about_line: j + m * (p * p + c * c),
            ee: j + excess * sd * sd,
            nn: j + excess * cd * cd,
            en: -excess * sd * cd,
        }
    }

    /// Both stay: the angular momentum about OK keeps.
    ///
    /// ```text
    /// α₁ = α − m l (s_e β + s_N γ)/I
    /// 2 l N_O = β (m l² − J_ee − m s_N² − m² l² s_e²/I) + γ (m s_e s_N − J_eN − m² l² s_e s_N/I)
    /// 2 l N_K = β (m l² + J_ee + m s_N² − m² l² s_e²/I) − γ (m s_e s_N − J_eN + m² l² s_e s_N/I)
    /// ```
    ///
    /// α does not enter the conditions. `N_K < 0 ≤ N_O`, the paper's "separation only of K", is no solution: nothing else could stop K.
    ///
    /// # Example
    /// A cube that comes down almost flat without spin about the normal cannot keep both: `κ² > −a² cos 2π/n`.
    /// ```
    /// use carom_theory::spatial::{Approach, Stool};
    /// let cube = Stool { supports: 4, circle_radius: 0.5f64.sqrt(), centre_height: 0.5, mass: 1.0,
    ///     inertia_transverse: 1.0 / 6.0, inertia_axial: 1.0 / 6.0 };
    /// let flat = Approach { tilting: 0.0, closing: 1.0, swinging: 0.0, tilt: 0.0 };
    /// let [at_o, at_k] = cube.on_both(&flat).normal;
    /// assert!(at_o < 0.0 && at_k > 0.0);
    /// ```
    pub fn on_both(&self, approach: &Approach) -> OnBoth {
        let t = self.tilted(approach.tilt);
        let (m, l, beta, gamma) = (self.mass, t.half, approach.closing, approach.swinging);
        let (se, sn) = (t.across, t.above);
        let coupling = m * m * l * l / t.about_line;
        let (ml2, inner) = (m * l * l, m * se * sn - t.en);
        let own = t.ee + m * sn * sn;
        let at_o = beta * (ml2 - own - coupling * se * se) + gamma * (inner - coupling * se * sn);
        let at_k = beta * (ml2 + own - coupling * se * se) - gamma * (inner + coupling * se * sn);
        OnBoth {
            tilting: approach.tilting - m * l * (se * beta + sn * gamma) / t.about_line,
            normal: [at_o / (2.0 * l), at_k / (2.0 * l)],
        }
    }

    /// K stays alone: the angular momentum about K keeps.
    ///
    /// ```text
    /// J_K (ω₁ − ω₀) = −2 m l (s_e β + s_N γ, l β, l γ)
    /// J_K = [[I, m l s_e, m l s_N], [·, J_ee + m (l² + s_N²), J_eN − m s_e s_N], [·, ·, J_NN + m (l² + s_e²)]]
    /// N_K = m ((ω₁ᵤ − ω₀ᵤ) s_e + l ω₁ₑ + l β),   v_O·N = 2 l ω₁ₑ
    /// ```
    ///
    /// # Example
    /// ```
    /// use carom_theory::spatial::{Approach, Stool};
    /// let cube = Stool { supports: 4, circle_radius: 0.5f64.sqrt(), centre_height: 0.5, mass: 1.0,
    ///     inertia_transverse: 1.0 / 6.0, inertia_axial: 1.0 / 6.0 };
    /// let flat = Approach { tilting: 0.0, closing: 1.0, swinging: 0.0, tilt: 0.0 };
    /// let next = cube.on_next(&flat);
    /// assert!(next.normal > 0.0 && next.separation > 0.0);
    /// ```
    pub fn on_next(&self, approach: &Approach) -> OnNext {
        let t = self.tilted(approach.tilt);
        let (m, l, beta, gamma) = (self.mass, t.half, approach.closing, approach.swinging);
        let (se, sn) = (t.across, t.above);
        let (ue, un, en) = (m * l * se, m * l * sn, t.en - m * se * sn);
        let matrix: [V; 3] = [
            [t.about_line, ue, un],
            [ue, t.ee + m * (l * l + sn * sn), en],
            [un, en, t.nn + m * (l * l + se * se)],
        ];
        let moment = [se * beta + sn * gamma, l * beta, l * gamma].map(|x| -2.0 * m * l * x);
        let change = solved(matrix, moment);
        let spin = [approach.tilting + change[0], beta + change[1], gamma + change[2]];
        OnNext { spin, normal: m * (change[0] * se + l * spin[1] + l * beta), separation: 2.0 * l * spin[1] }
    }

    /// The ratio of successive hops of a stool that chatters on O and K, almost on its edge OK at a tilt δ; its times and speeds shrink by it.
    ///
    /// What leaves with ω₁ comes back as `β = ω₁ₑ`, `γ = −ω₁_N`: a hop is a throw, and seen from the other support swinging is outward. So an impact maps
    /// (β, γ) linearly, and the ratio is the larger eigenvalue of that map. `None` where its eigenvalues are not real: the hops do not settle to a ratio.
    ///
    /// # Example
    /// A cube's is 5/11.
    /// ```
    /// use carom_theory::spatial::Stool;
    /// let cube = Stool { supports: 4, circle_radius: 0.5f64.sqrt(), centre_height: 0.5, mass: 1.0,
    ///     inertia_transverse: 1.0 / 6.0, inertia_axial: 1.0 / 6.0 };
    /// assert!((cube.chatter_ratio(0.0).unwrap() - 5.0 / 11.0).abs() < 1e-15);
    /// ```
    pub fn chatter_ratio(&self, tilt: f64) -> Option<f64> {
        let after = |closing: f64, swinging: f64| {
            let [_, e, n] = self.on_next(&Approach { tilting: 0.0, closing, swinging, tilt }).spin;
            [e, -n]
        };
        let ([a, c], [b, d]) = (after(1.0, 0.0), after(0.0, 1.0));
        let (half, skew) = (0.5 * (a + d), 0.5 * (a - d));
        let square = skew * skew + b * c;
        (square >= 0.0).then(|| half + square.sqrt())
    }

    /// Where a stool that turns about one support comes down flat: it stops if `κ² ≤ a d`, d the distance of what lies opposite (a support: a,
    /// n even; an edge: a C, n odd). Otherwise it turns about that, with this part of its angular velocity:
    ///
    /// ```text
    /// (κ² − a d)/(κ² + d²)
    /// ```
    ///
    /// # Example
    /// A cube dropped on a corner stops: 5/12 < 1/2.
    /// ```
    /// use carom_theory::spatial::Stool;
    /// let cube = Stool { supports: 4, circle_radius: 0.5f64.sqrt(), centre_height: 0.5, mass: 1.0,
    ///     inertia_transverse: 1.0 / 6.0, inertia_axial: 1.0 / 6.0 };
    /// assert_eq!(cube.flat_from_support(), 0.0);
    /// ```
    pub fn flat_from_support(&self) -> f64 {
        let (a, inner) = (self.circle_radius, self.inner_radius());
        self.flat(a, if self.supports.is_multiple_of(2) { a } else { inner })
    }

    /// The same for a stool that turns about the edge between two supports, p = a C from the middle; opposite lies an edge (n even) or a support.
    ///
    /// # Example
    /// A cube dropped on an edge rocks, with a quarter of its angular velocity: `(5/12 − 1/4)/(5/12 + 1/4)`.
    /// ```
    /// use carom_theory::spatial::Stool;
    /// let cube = Stool { supports: 4, circle_radius: 0.5f64.sqrt(), centre_height: 0.5, mass: 1.0,
    ///     inertia_transverse: 1.0 / 6.0, inertia_axial: 1.0 / 6.0 };
    /// assert!((cube.flat_from_edge() - 0.25).abs() < 1e-14);
    /// ```
    pub fn flat_from_edge(&self) -> f64 {
        let (a, inner) = (self.circle_radius, self.inner_radius());
        self.flat(inner, if self.supports.is_multiple_of(2) { inner } else { a })
    }

    /// p = a cos(π/n), from the middle to an edge \[m\].
    fn inner_radius(&self) -> f64 {
        self.circle_radius * self.half_angle().0
    }

    fn flat(&self, here: f64, opposite: f64) -> f64 {
        let gyration = self.gyration_squared();
        ((gyration - here * opposite) / (gyration + opposite * opposite)).max(0.0)
    }
}

impl Approach {
    /// Checks that every quantity lies in its domain.
    ///
    /// # Errors
    ///
    /// The first quantity outside its domain.
    ///
    /// # Example
    /// ```
    /// use carom_theory::spatial::Approach;
    /// let leaving = Approach { tilting: 0.0, closing: -1.0, swinging: 0.0, tilt: 0.0 };
    /// assert_eq!(leaving.check().map_err(|error| error.quantity), Err("closing"));
    /// assert_eq!(Approach { closing: 1.0, ..leaving }.check(), Ok(()));
    /// ```
    pub fn check(&self) -> Result<(), OutsideDomain> {
        require_finite("tilting", self.tilting)?;
        require_positive("closing", self.closing)?;
        require_finite("swinging", self.swinging)?;
        require_finite("tilt", self.tilt)
    }
}
