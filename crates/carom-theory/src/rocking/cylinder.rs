//! A cylinder that rolls on a plane (contact A) and strikes a step or a second plane (contact K).

use super::{Strike, Tangential};
use crate::OutsideDomain;
use crate::domain::{require, require_not_negative, require_positive};

/// A cylinder and the place where it strikes.
///
/// # Example
/// A disc that meets a step of half its radius, `1 − cos 60°`, keeps `(1/2 + cos 60°)/(3/2)` of its roll
/// rate.
/// ```
/// let disc = carom_theory::rocking::Cylinder {
///     mass: 1.0, radius: 1.0, inertia_ratio: 0.5, friction: 1.0, half_angle: 30f64.to_radians(),
/// };
/// let (_, strike) = disc.strike(3.0)?;
/// assert!((strike.roll_rate - 2.0).abs() < 1e-14);
/// # Ok::<(), carom_theory::OutsideDomain>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder {
    /// m > 0 \[kg\].
    pub mass: f64,
    /// a > 0 \[m\].
    pub radius: f64,
    /// b = J/(m a²) in (0, 1].
    pub inertia_ratio: f64,
    /// f ≥ 0, at both contacts.
    pub friction: f64,
    /// γ in (0, π/2): half of the central angle A–C–K \[rad\]. A step of height H has `H = a(1 − cos 2γ)`.
    pub half_angle: f64,
}

/// What the plastic strike of a rolling cylinder leaves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CylinderState {
    /// 1: A separates, K sticks: it rolls over K.
    RollsOver,
    /// 2: A separates, K slips backward.
    LeavesAndSlips,
    /// 3: A stays, both slip backward: it spins in the corner.
    SpinsInCorner,
    /// 4: A stays and it stops; K slips to the end.
    Stops,
    /// 4: it stops; A slips forward, and K sticks before the end.
    StopsWithKStuck,
    /// 4: it stops; A separates and closes again, sliding forward, while K sticks.
    StopsAfterReclosing,
}

impl CylinderState {
    /// The number 1…4 of the source; the last three are its state 4.
    ///
    /// # Example
    /// ```
    /// use carom_theory::rocking::CylinderState;
    /// let states = [CylinderState::SpinsInCorner, CylinderState::StopsWithKStuck];
    /// assert_eq!(states.map(|state| state.number()), [3, 4]);
    /// ```
    pub fn number(self) -> u8 {
        match self {
            Self::RollsOver => 1,
            Self::LeavesAndSlips => 2,
            Self::SpinsInCorner => 3,
            Self::Stops | Self::StopsWithKStuck | Self::StopsAfterReclosing => 4,
        }
    }

    /// The name of the tables: the number, with a letter for the two forms of state 4 in which K sticks: 4s, and 4r after re-closing.
    ///
    /// # Example
    /// ```
    /// use carom_theory::rocking::CylinderState;
    /// assert_eq!([CylinderState::Stops, CylinderState::StopsWithKStuck].map(|s| s.label()), ["4", "4s"]);
    /// ```
    pub fn label(self) -> &'static str {
        match self {
            Self::RollsOver => "1",
            Self::LeavesAndSlips => "2",
            Self::SpinsInCorner => "3",
            Self::Stops => "4",
            Self::StopsWithKStuck => "4s",
            Self::StopsAfterReclosing => "4r",
        }
    }
}

/// The letters of the closed forms: m = a = ω₀ = 1.
pub(super) struct Letters {
    pub(super) b: f64,
    pub(super) f: f64,
    /// sin 2γ and cos 2γ.
    pub(super) s: f64,
    pub(super) c: f64,
    /// tan γ.
    pub(super) tau: f64,
    /// 1 − cos 2γ without cancellation.
    pub(super) versine: f64,
}

impl Letters {
    /// c + fs: of the normal response of A to K's slipping impulse. Negative: A is pressed.
    pub(super) fn press(&self) -> f64 {
        self.c + self.f * self.s
    }

    /// u = T_K/N_K and X = dv_Cx/dN_K while K sticks and A, held, slips with `T_A = pull N_A`: pull = f backward, −f forward.
    pub(super) fn stuck_at_k(&self, pull: f64) -> (f64, f64) {
        let Self { b, s, c, .. } = *self;
        let u = c * (b * (pull * c + s) + pull) / (b * c * (c - pull * s) + 1.0 - pull * s);
        (u, u * (c - pull * s) - s - pull * c)
    }
}

impl Cylinder {
    /// Checks that every quantity lies in its domain.
    ///
    /// # Errors
    ///
    /// The first quantity outside its domain.
    ///
    /// # Example
    /// ```
    /// use carom_theory::rocking::Cylinder;
    /// let heavy = Cylinder { mass: 1.0, radius: 1.0, inertia_ratio: 1.5, friction: 0.3, half_angle: 0.5 };
    /// assert_eq!(heavy.check().map_err(|error| error.quantity), Err("inertia ratio"));
    /// assert_eq!(Cylinder { inertia_ratio: 1.0, ..heavy }.check(), Ok(()));
    /// ```
    pub fn check(&self) -> Result<(), OutsideDomain> {
        require_positive("mass", self.mass)?;
        require_positive("radius", self.radius)?;
        let b = self.inertia_ratio;
        require(b > 0.0 && b <= 1.0, "inertia ratio", b, "0 < b <= 1")?;
        require_not_negative("friction", self.friction)?;
        let angle = self.half_angle;
        require(angle > 0.0 && angle < core::f64::consts::FRAC_PI_2, "half angle", angle, "0 < angle < pi/2")
    }

    pub(super) fn letters(&self) -> Letters {
        let (sin, cos) = libm::sincos(self.half_angle);
        let (s, c) = (2.0 * sin * cos, (cos - sin) * (cos + sin));
        Letters { b: self.inertia_ratio, f: self.friction, s, c, tau: sin / cos, versine: 2.0 * sin * sin }
    }

    /// The state of the plastic strike; τ = tan γ.
    ///
    /// ```text
    /// 1  τ ≤ f(1+b)/b  and cos 2γ ≥ −b
    /// 2  τ > f(1+b)/b  and cos 2γ + f sin 2γ ≥ 0
    /// 3  cos 2γ + f sin 2γ < 0  and  fτ < b + (1+b)f²
    /// 4  elsewhere
    /// ```
    ///
    /// The curves meet at `f* = b/√(1 − b²)`, `cos 2γ* = −b`; above f* only the states 1 and 4 are left.
    ///
    /// # Source
    /// Polukoshko, Viba and others, for b = 1; the rest is derived here for the staged law.
    ///
    /// # Example
    /// ```
    /// use carom_theory::rocking::Cylinder;
    /// let thin = |degrees: f64| Cylinder {
    ///     mass: 1.0, radius: 1.0, inertia_ratio: 1.0, friction: 0.3, half_angle: degrees.to_radians(),
    /// };
    /// // The boundaries at f = 0.3: atan 0.6 = 31.0°, 45° + atan(0.3)/2 = 53.3°, atan(1.18/0.3) = 75.7°
    /// assert_eq!([30.0, 32.0, 54.0, 76.0].map(|g| thin(g).state().number()), [1, 2, 3, 4]);
    /// ```
    pub fn state(&self) -> CylinderState {
        let l = self.letters();
        let Letters { b, f, c, tau, .. } = l;
        let sticks = b * tau <= f * (1.0 + b);
        let pressed = l.press() < 0.0;
        if sticks && c >= -b {
            CylinderState::RollsOver
        } else if !sticks && !pressed {
            CylinderState::LeavesAndSlips
        } else if pressed && f * tau < b + (1.0 + b) * f * f {
            CylinderState::SpinsInCorner
        } else if !pressed {
            CylinderState::StopsAfterReclosing
        } else if sticks {
            CylinderState::StopsWithKStuck
        } else {
            CylinderState::Stops
        }
    }

    /// True if rest, wedged between the contacts, is an end state besides the moving one that the stages reach: `f tan γ ≥ 1` and
    /// `cos 2γ ≥ −b`, where the stages do not stop by themselves.
    ///
    /// The chord K–A then lies within both friction cones, so impulses along it can be added without changing the motion, and
    /// with enough of them Coulomb's law allows sticking at both contacts.
    ///
    /// # Source
    /// Ours, after the two-contact theory of wedging; the staged answer is the reference.
    ///
    /// # Example
    /// ```
    /// use carom_theory::rocking::Cylinder;
    /// let ring = |degrees: f64| Cylinder {
    ///     mass: 1.0, radius: 1.0, inertia_ratio: 1.0, friction: 1.0, half_angle: degrees.to_radians(),
    /// };
    /// assert!(!ring(44.0).may_wedge() && ring(46.0).may_wedge()); // tan 45° = 1
    /// ```
    pub fn may_wedge(&self) -> bool {
        let l = self.letters();
        l.f * l.tau >= 1.0 && l.b + l.c >= 0.0 && self.state().number() != 4
    }

    /// The plastic strike of a cylinder that rolls on A with ω₀ > 0 without slip.
    ///
    /// ```text
    /// in units of m, a, ω₀; s = sin 2γ, c = cos 2γ; N_A up, N_K along (−s, c); T_A along (1, 0), T_K along (c, s)
    /// 1  N_K = s,  T_K = b(1−c)/(1+b),     ω = (b+c)/(1+b),          v = ω(c, s)
    /// 2  N_K = s,  T_K = fs,               ω = 1 − fs/b,             v = (c+fs)(c, s)
    /// 3  N_K = 1/(s(1+f²)),  N_A = −(c+fs)N_K,  T = fN,              ω = 1 − f(τ−f)/(b(1+f²)),  v = 0
    /// 4  N_K = (1+b)/(s(1+fτ)),  N_A = −(c+fs)N_K,  T_K = fN_K,  T_A = b − fN_K,                it stops
    /// ```
    ///
    /// The two other forms of state 4 (b < 1, f > f*) are a leg of slip at K up to N₁, or of stick with A open up to N₀, and a leg with K stuck and A
    /// slipping forward.
    ///
    /// # Limits
    /// Where [`Cylinder::may_wedge`] an end state at rest exists besides this staged answer.
    ///
    /// # Errors
    /// A quantity outside its domain.
    ///
    /// # Source
    /// Polukoshko, Viba and others; states 4 derived again.
    ///
    /// # Example
    ///
    /// A thin ring (b = 1) at 2γ = 90°, f = 0.7: N_K = 1, T_K = 1/2, ω = 1/2.
    ///
    /// ```
    /// use carom_theory::rocking::{Cylinder, Tangential};
    /// let ring = Cylinder {
    ///     mass: 1.0, radius: 1.0, inertia_ratio: 1.0, friction: 0.7, half_angle: std::f64::consts::FRAC_PI_4,
    /// };
    /// let (state, strike) = ring.strike(1.0)?;
    /// assert_eq!(state.number(), 1);
    /// assert!((strike.roll_rate - 0.5).abs() < 1e-15 && (strike.normal[1] - 1.0).abs() < 1e-15);
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn strike(&self, roll_rate: f64) -> Result<(CylinderState, Strike), OutsideDomain> {
        self.check()?;
        require_positive("roll rate", roll_rate)?;
        let (state, l) = (self.state(), self.letters());
        let unit = match state {
            CylinderState::RollsOver => rolls_over(&l),
            CylinderState::LeavesAndSlips => leaves_and_slips(&l),
            CylinderState::SpinsInCorner => spins_in_corner(&l),
            CylinderState::Stops => stops(&l),
            CylinderState::StopsWithKStuck => stops_with_k_stuck(&l),
            CylinderState::StopsAfterReclosing => stops_after_reclosing(&l),
        };
        Ok((state, unit.in_units(self.mass, self.radius, roll_rate)))
    }
}

fn unit(velocity: [f64; 2], roll_rate: f64, normal: [f64; 2], tangential: [f64; 2]) -> Strike {
    Strike {
        velocity_before: [1.0, 0.0],
        roll_rate_before: 1.0,
        velocity,
        roll_rate,
        normal,
        tangential: Tangential::Each(tangential),
    }
}

fn rolls_over(l: &Letters) -> Strike {
    let Letters { b, s, c, versine, .. } = *l;
    let rate = (b + c) / (1.0 + b);
    unit([rate * c, rate * s], rate, [0.0, s], [0.0, b * versine / (1.0 + b)])
}

fn leaves_and_slips(l: &Letters) -> Strike {
    let Letters { b, f, s, c, .. } = *l;
    let speed = l.press();
    unit([speed * c, speed * s], 1.0 - f * s / b, [0.0, s], [0.0, f * s])
}

fn spins_in_corner(l: &Letters) -> Strike {
    let Letters { b, f, s, tau, .. } = *l;
    let cone = 1.0 + f * f;
    let struck = 1.0 / (s * cone);
    let normal = [-l.press() * struck, struck];
    unit([0.0, 0.0], 1.0 - f * (tau - f) / (b * cone), normal, normal.map(|n| f * n))
}

fn stops(l: &Letters) -> Strike {
    let Letters { b, f, s, tau, .. } = *l;
    let struck = (1.0 + b) / (s * (1.0 + f * tau));
    unit([0.0, 0.0], 0.0, [-l.press() * struck, struck], [b - f * struck, f * struck])
}

fn stops_with_k_stuck(l: &Letters) -> Strike {
    let Letters { b, f, s, c, versine, .. } = *l;
    let first_x = 2.0 * f * c + (f * f - 1.0) * s;
    let first_spin = -f * (1.0 + c + f * s) / b;
    let slipped = versine / (c * first_x - first_spin);
    let (u, x) = l.stuck_at_k(-f);
    let stuck = -(1.0 + first_x * slipped) / x;
    let held = -l.press() * slipped - (c + u * s) * stuck;
    unit([0.0, 0.0], 0.0, [held, slipped + stuck], [-f * held, f * slipped + u * stuck])
}

fn stops_after_reclosing(l: &Letters) -> Strike {
    let Letters { b, f, s, c, versine, .. } = *l;
    let gripped = b * versine / (1.0 + b);
    let open = -s * gripped / c;
    let (u, x) = l.stuck_at_k(-f);
    let stuck = -(1.0 - s * open + c * gripped) / x;
    let held = -(c + u * s) * stuck;
    unit([0.0, 0.0], 0.0, [held, open + stuck], [-f * held, gripped + u * stuck])
}

impl Strike {
    /// The strike of units m = a = ω₀ = 1 in SI.
    pub(super) fn in_units(&self, mass: f64, radius: f64, roll_rate: f64) -> Self {
        let (speed, momentum) = (radius * roll_rate, mass * radius * roll_rate);
        let by = |pair: [f64; 2], unit: f64| pair.map(|x| unit * x);
        Self {
            velocity_before: by(self.velocity_before, speed),
            roll_rate_before: roll_rate,
            velocity: by(self.velocity, speed),
            roll_rate: roll_rate * self.roll_rate,
            normal: by(self.normal, momentum),
            tangential: match self.tangential {
                Tangential::Each(each) => Tangential::Each(by(each, momentum)),
                Tangential::Sum(sum) => Tangential::Sum(momentum * sum),
            },
        }
    }
}
