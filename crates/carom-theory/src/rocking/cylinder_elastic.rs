//! The cylinder's strike with restitution: what the second phase makes of each plastic state.

use super::cylinder::Letters;
use super::{Cylinder, CylinderState, Strike, Tangential};
use crate::OutsideDomain;
use crate::domain::require;

/// What the strike of a rolling cylinder with restitution R > 0 leaves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CylinderEnd {
    /// 5a: free, from state 1; K does not slip.
    Free,
    /// 5b: free, from state 2; the slip at K stops in restitution.
    FreeAfterGrip,
    /// 5c: free, from state 2; K slips to the end.
    FreeSlipping,
    /// 5r: K leaves; A, which had separated, closes again in restitution.
    Recloses,
    /// 6a: K leaves, A slides back without rising; from state 3, all impulses are repeated R times.
    SlidesBack,
    /// 6b: the same, but the slip at K stops in restitution, and sticks or reverses.
    SlidesBackAfterGrip,
    /// 7: it stays at rest, wedged; from state 4 with f tan γ ≥ 1.
    Wedged,
    /// 7: it slides back from rest; from state 4 with f tan γ < 1.
    SlidesBackFromRest,
}

impl CylinderEnd {
    /// The name of the tables.
    ///
    /// # Example
    /// ```
    /// use carom_theory::rocking::CylinderEnd;
    /// assert_eq!([CylinderEnd::Free, CylinderEnd::Wedged].map(|end| end.label()), ["5a", "7jam"]);
    /// ```
    pub fn label(self) -> &'static str {
        match self {
            Self::Free => "5a",
            Self::FreeAfterGrip => "5b",
            Self::FreeSlipping => "5c",
            Self::Recloses => "5r",
            Self::SlidesBack => "6a",
            Self::SlidesBackAfterGrip => "6b",
            Self::Wedged => "7jam",
            Self::SlidesBackFromRest => "7s",
        }
    }
}

/// Motion and impulses on the way, in units of m, a, ω₀: (v_x, v_y, ω) and (N_A, T_A, N_K, T_K).
#[derive(Clone, Copy)]
struct On {
    q: [f64; 3],
    p: [f64; 4],
}

impl On {
    /// `length` of a stage with these rates per unit of N_K.
    fn go(&mut self, length: f64, q: [f64; 3], p: [f64; 4]) {
        for (sum, rate) in self.q.iter_mut().zip(q) {
            *sum += length * rate;
        }
        for (sum, rate) in self.p.iter_mut().zip(p) {
            *sum += length * rate;
        }
    }
}

impl Cylinder {
    /// The strike of a cylinder that rolls on A with ω₀ > 0 without slip, with restitution R at both contacts.
    ///
    /// ```text
    /// in units of m, a, ω₀; index 1: after compression
    /// 5a 5b  v_t = ω = (b+c)/(1+b),  v = v_t(c, s) + R s(−s, c)           while v_nA ≥ 0: c ≥ 0 or R ≤ R_c = −(b+c)/((1+b)c)
    /// 5c     v_t = c+(1+R)fs,  ω = 1−(1+R)fs/b,  v = v_t(c, s) + R s(−s, c)
    /// 5r     at R_c: v = (−R_c, 0), ω = −c R_c; then the tail with N_K = (R−R_c)s
    /// 6a     v = (−R, 0),  ω = ω₁ − R(1−ω₁)                                while R ≤ ρ* = ω₁/(1−c−ω₁)
    /// 6b     at ρ*; then the tail with N_K = (R−ρ*)N_K1
    /// 7      fτ ≥ 1: rest;  fτ < 1: the tail from rest with N_K = R N_K1
    /// tail   A held, slipping back: T_A = fN_A, N_A = −(c+us)N_K; K sticks (u = u_s) if its cone allows, else slips forward (u = −f);
    ///        if the slip at A stops: rest where K sticks, else rolling about A
    /// ```
    ///
    /// The states 6 and 7 of the source, which turn back about A without sliding, do not obey Coulomb's law and do not occur.
    ///
    /// # Limits
    /// Poisson's law does not say how fast A restitutes; here in proportion to its compression. A contact that closes again with speed
    /// zero counts as closed, not as a second strike. Where the first phase has a second end state at rest
    /// ([`Cylinder::may_wedge`]) this is the staged answer. Where it ends at rest, wedged, the impulses are not determined: those given
    /// press K as little as the law allows.
    ///
    /// # Errors
    /// A quantity outside its domain; R outside (0, 1].
    ///
    /// # Source
    /// Derived here; states 5, 6 and 7 of Polukoshko, Viba and others are the cases 5a, 6a and 7 by name.
    ///
    /// # Example
    ///
    /// A ring (b = 1) at γ = 60° with f = 1, R = 1/2 = R_c: it leaves K, and A just grazes.
    ///
    /// ```
    /// let ring = carom_theory::rocking::Cylinder {
    ///     mass: 1.0, radius: 1.0, inertia_ratio: 1.0, friction: 1.0, half_angle: 60f64.to_radians(),
    /// };
    /// let (_, strike) = ring.elastic_strike(1.0, 0.5)?;
    /// assert!((strike.velocity[0] + 0.5).abs() < 1e-14 && strike.velocity[1].abs() < 1e-14);
    /// assert!((strike.roll_rate - 0.25).abs() < 1e-14);
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn elastic_strike(
        &self,
        roll_rate: f64,
        restitution: f64,
    ) -> Result<(CylinderEnd, Strike), OutsideDomain> {
        let r = restitution;
        require(r > 0.0 && r <= 1.0, "restitution", r, "0 < R <= 1")?;
        let unit = Self { mass: 1.0, radius: 1.0, ..*self };
        let (state, plastic) = unit.strike(1.0)?;
        self.strike(roll_rate)?;
        let l = self.letters();
        let (end, on) = match state {
            CylinderState::RollsOver | CylinderState::LeavesAndSlips => from_free(&l, state, r),
            CylinderState::SpinsInCorner => from_corner(&l, &plastic, r),
            _ => from_rest(&l, &plastic, r),
        };
        let strike = Strike {
            velocity: [on.q[0], on.q[1]],
            roll_rate: on.q[2],
            normal: [on.p[0], on.p[2]],
            tangential: Tangential::Each([on.p[1], on.p[3]]),
            ..plastic
        };
        Ok((end, strike.in_units(self.mass, self.radius, roll_rate)))
    }
}

fn started(plastic: &Strike) -> On {
    let [a, k] = match plastic.tangential {
        Tangential::Each(each) => each,
        Tangential::Sum(sum) => [sum, 0.0],
    };
    let [x, y] = plastic.velocity;
    On { q: [x, y, plastic.roll_rate], p: [plastic.normal[0], a, plastic.normal[1], k] }
}

fn from_free(l: &Letters, state: CylinderState, r: f64) -> (CylinderEnd, On) {
    let Letters { b, f, s, c, tau, versine } = *l;
    let free = |speed: f64, r: f64| [speed * c - r * s * s, (speed + r * c) * s];
    let slips = state == CylinderState::LeavesAndSlips;
    if slips && b * tau > f * (1.0 + b) * (1.0 + r) {
        let whole = 1.0 + r;
        let [x, y] = free(c + whole * f * s, r);
        let on = On { q: [x, y, 1.0 - whole * f * s / b], p: [0.0, 0.0, whole * s, whole * f * s] };
        return (CylinderEnd::FreeSlipping, on);
    }
    let rate = (b + c) / (1.0 + b);
    let grip = b * versine / (1.0 + b);
    if rate + r * c >= 0.0 {
        let [x, y] = free(rate, r);
        let on = On { q: [x, y, rate], p: [0.0, 0.0, (1.0 + r) * s, grip] };
        return (if slips { CylinderEnd::FreeAfterGrip } else { CylinderEnd::Free }, on);
    }
    let closing = -rate / c;
    let mut on = On { q: [-closing, 0.0, rate], p: [0.0, 0.0, (1.0 + closing) * s, grip] };
    tail(l, &mut on, (r - closing) * s);
    (CylinderEnd::Recloses, on)
}

fn from_corner(l: &Letters, plastic: &Strike, r: f64) -> (CylinderEnd, On) {
    // At the boundary to state 4 rounding may leave a rate below zero.
    let rate = plastic.roll_rate.max(0.0);
    // K slips to the end where the slip would stop later, or not at all.
    let left = l.versine - rate;
    let slips = left <= 0.0 || r * left <= rate;
    let grip = if slips { r } else { rate / left };
    let mut on = started(plastic);
    on.q = [-grip, 0.0, rate - grip * (1.0 - rate)];
    on.p = on.p.map(|p| (1.0 + grip) * p);
    if slips {
        return (CylinderEnd::SlidesBack, on);
    }
    tail(l, &mut on, (r - grip) * plastic.normal[1]);
    (CylinderEnd::SlidesBackAfterGrip, on)
}

fn from_rest(l: &Letters, plastic: &Strike, r: f64) -> (CylinderEnd, On) {
    let mut on = started(plastic);
    let returned = r * plastic.normal[1];
    if l.f * l.tau >= 1.0 {
        on.go(returned, [0.0; 3], wedge(l));
        return (CylinderEnd::Wedged, on);
    }
    tail(l, &mut on, returned);
    (CylinderEnd::SlidesBackFromRest, on)
}

/// Impulses per N_K of a push along the chord K–A, which moves nothing.
fn wedge(l: &Letters) -> [f64; 4] {
    [1.0, 1.0 / l.tau, 1.0, -1.0 / l.tau]
}

/// What is left of restitution once A is held and slips back, and K has stopped slipping.
fn tail(l: &Letters, on: &mut On, left: f64) {
    let Letters { b, f, s, c, versine, .. } = *l;
    let (stuck, _) = l.stuck_at_k(f);
    let sticks = stuck.abs() <= f && c + stuck * s <= 0.0;
    let u = if sticks { stuck } else { -f };
    let held = -(c + u * s);
    let x = f * held - s + u * c;
    let spin = -(u + f * held) / b;
    let slip_stops = if x > spin { (on.q[2] - on.q[0]) / (x - spin) } else { f64::INFINITY };
    let slipping = left.min(slip_stops);
    on.go(slipping, [x, 0.0, spin], [held, f * held, 1.0, u]);
    let mut left = left - slipping;
    if left <= 0.0 {
        return;
    }
    if sticks {
        on.q = [0.0; 3];
    } else {
        // It rolls about A while K slips forward, until it rests.
        let slowing = -(s - f * versine) / (1.0 + b);
        let rests = if slowing * on.q[0] < 0.0 { -on.q[0] / slowing } else { f64::INFINITY };
        let rolling = left.min(rests);
        on.go(rolling, [slowing, 0.0, slowing], [-(c - f * s), slowing + s + f * c, 1.0, -f]);
        left -= rolling;
        if left <= 0.0 {
            return;
        }
        on.q = [0.0; 3];
    }
    on.go(left, [0.0; 3], wedge(l));
}
