//! One end of the rod on the lower plate: it slides or stays, until the rod lies flat, lifts off, or its slip stops or begins.
//!
//! In the plate's frame (t uphill, n out of it) the centre stands at (c, s) from the end K, w is the spin (counter-clockwise) and
//! u the slip of K. With q the sign of the slip, n = N/m, gravity (−γ_t, −γ_n):
//!
//! ```text
//! sliding:  n = (γ_n − s w²)/(1 + κ c (c + qμ s)),   ẇ = −κ (c + qμ s) n,   d(u − s w)/dt = −γ_t − qμ n
//! staying:  ẇ = K (γ_t s − γ_n c),   K = κ/(1 + κ),   w² = E − 2K (γ_n s + γ_t c)
//! ```

use crate::answer::{KAPPA, Prepared, Uncovered};
use crate::series::{first_root, quotient, reach};
use crate::tolerance::ZERO;
use crate::upper::clear_on_plate;
use carom_num::every_order;
use carom_num::taylor::{INVERSE, product, square, value};

/// What turns while an end stays, over what it resists.
const K: f64 = KAPPA / (1.0 + KAPPA);

/// The rod with an end on the lower plate.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OnEnd {
    pub(crate) time: f64,
    /// Which end: 1 the tail, −1 the front. The rod's axis from tail to front is this times (c, s).
    pub(crate) end: f64,
    pub(crate) c: f64,
    pub(crate) s: f64,
    pub(crate) w: f64,
    pub(crate) u: f64,
    /// Where K is along the plate, from the foot of the upper plate's edge.
    pub(crate) x: f64,
}

/// What an end on the plate does next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Mode {
    /// Slides, in this direction.
    Slides(f64),
    /// Stays where it is.
    Stays,
    /// Lifts off.
    LiftsOff,
}

/// What has ended a mode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum End {
    LiesFlat,
    LiftsOff,
    SlipStops,
    /// Friction no longer holds it: it begins to slide in this direction.
    Slips(f64),
}

/// What an end does whose slip is known; `Err` where a sign is not.
pub(crate) fn mode(drop: &Prepared, at: &OnEnd) -> Result<Mode, Uncovered> {
    let pressing = drop.lower.1 - at.s * at.w * at.w;
    if pressing.abs() < ZERO {
        return Err(Uncovered::Tie);
    }
    if pressing < 0.0 {
        return Ok(Mode::LiftsOff);
    }
    if at.u != 0.0 {
        return Ok(Mode::Slides(at.u.signum()));
    }
    let (n, t) = holding(drop.lower, at);
    let left = drop.friction * n - t.abs();
    if left.abs() < ZERO {
        return Err(Uncovered::Tie);
    }
    // It gives way against the friction it would have needed.
    Ok(if left > 0.0 { Mode::Stays } else { Mode::Slides(-t.signum()) })
}

/// Normal and tangential force, over the mass, that hold an end in its place.
fn holding((gt, gn): (f64, f64), at: &OnEnd) -> (f64, f64) {
    let turning = K * (gt * at.s - gn * at.c);
    let ww = at.w * at.w;
    (gn + at.c * turning - at.s * ww, gt - at.s * turning - at.c * ww)
}

/// The series of one step of an end that slides.
struct Sliding<const P: usize> {
    lower: (f64, f64),
    /// q μ.
    drag: f64,
    /// Of 1 + κ c (c + qμ s) at the start.
    over: f64,
    c: [f64; P],
    s: [f64; P],
    w: [f64; P],
    /// The centre's velocity along the plate, and the end's.
    v: [f64; P],
    u: [f64; P],
    /// Numerator of the normal force.
    pressing: [f64; P],
    n: [f64; P],
    b: [f64; P],
    cb: [f64; P],
    ww: [f64; P],
}

impl<const P: usize> Sliding<P> {
    #[inline(always)]
    fn about(drop: &Prepared, at: &OnEnd, direction: f64) -> Self {
        let (z, drag) = ([0.0; P], direction * drop.friction);
        let over = 1.0 / (1.0 + KAPPA * at.c * (at.c + drag * at.s));
        let (c, s, w, v, u) = (z, z, z, z, z);
        let mut it =
            Self { lower: drop.lower, drag, over, c, s, w, v, u, pressing: z, n: z, b: z, cb: z, ww: z };
        (it.c[0], it.s[0], it.w[0], it.v[0]) = (at.c, at.s, at.w, at.u - at.s * at.w);
        every_order!(it, order, P - 1);
        it.u[P - 1] = it.v[P - 1];
        it
    }

    /// From the coefficients up to `I` those of the next order.
    #[inline(always)]
    fn order<const I: usize>(&mut self) {
        let (gt, gn) = if I == 0 { self.lower } else { (0.0, 0.0) };
        self.ww[I] = square::<I, P>(&self.w);
        self.b[I] = self.c[I] + self.drag * self.s[I];
        self.cb[I] = product::<I, P>(&self.c, &self.b);
        self.pressing[I] = gn - product::<I, P>(&self.s, &self.ww);
        self.n[I] = quotient::<I, P>(self.pressing[I], (KAPPA, &self.cb, self.over), &self.n);
        let (d, sw) = (INVERSE[I], product::<I, P>(&self.s, &self.w));
        self.u[I] = self.v[I] + sw;
        self.w[I + 1] = -KAPPA * product::<I, P>(&self.b, &self.n) * d;
        self.s[I + 1] = product::<I, P>(&self.c, &self.w) * d;
        self.c[I + 1] = -sw * d;
        self.v[I + 1] = -(gt + self.drag * self.n[I]) * d;
    }
}

/// Follows an end that slides to what ends it. `orders` of its slip vanish at the start: 0, 1, or 2 where friction has just given way.
pub(crate) fn slide<const P: usize>(
    drop: &Prepared,
    at: &mut OnEnd,
    (direction, orders): (f64, usize),
    tolerance: f64,
) -> Result<Option<End>, Uncovered> {
    let it = Sliding::<P>::about(drop, at, direction);
    let h = reach::<P>(it.w[P - 1].abs().max(it.w[P - 2].abs()), tolerance);
    let mut slip = [0.0; P];
    for i in orders..P {
        slip[i - orders] = direction * it.u[i];
    }
    let mut first = (h, None);
    earlier(&mut first, &it.s, End::LiesFlat)?;
    earlier(&mut first, &it.pressing, End::LiftsOff)?;
    earlier(&mut first, &slip, End::SlipStops)?;
    let (t, end) = first;
    clear_on_plate(drop, at, (&it.c, &it.s, &it.u), t)?;
    let x = at.x + moved(&it.u, t);
    let u = if end == Some(End::SlipStops) { 0.0 } else { value(&it.u, t) };
    *at = OnEnd { u, x, ..at.later((&it.c, &it.s, &it.w), t) };
    Ok(end)
}

/// The series of one step of an end that stays.
struct Staying<const P: usize> {
    lower: (f64, f64),
    friction: f64,
    energy: f64,
    c: [f64; P],
    s: [f64; P],
    w: [f64; P],
    n: [f64; P],
    /// What is left of friction on both sides.
    left: [f64; P],
    right: [f64; P],
}

impl<const P: usize> Staying<P> {
    #[inline(always)]
    fn about(drop: &Prepared, at: &OnEnd) -> Self {
        let ((gt, gn), z) = (drop.lower, [0.0; P]);
        let energy = at.w * at.w + 2.0 * K * (gn * at.s + gt * at.c);
        let (lower, friction) = (drop.lower, drop.friction);
        let mut it = Self { lower, friction, energy, c: z, s: z, w: z, n: z, left: z, right: z };
        (it.c[0], it.s[0], it.w[0]) = (at.c, at.s, at.w);
        every_order!(it, order, P - 1);
        it
    }

    /// From the coefficients up to `I` those of the next order.
    #[inline(always)]
    fn order<const I: usize>(&mut self) {
        let (gt, gn) = self.lower;
        let one = if I == 0 { 1.0 } else { 0.0 };
        let (cc, cs) = (square::<I, P>(&self.c), product::<I, P>(&self.c, &self.s));
        let n = gn * (one * (1.0 + 2.0 * K) - 3.0 * K * cc) + 3.0 * K * gt * cs - self.energy * self.s[I];
        let t = gt * (one * (1.0 - K) + 3.0 * K * cc) + 3.0 * K * gn * cs - self.energy * self.c[I];
        self.n[I] = n;
        self.left[I] = self.friction * n - t;
        self.right[I] = self.friction * n + t;
        let d = INVERSE[I];
        self.w[I + 1] = K * (gt * self.s[I] - gn * self.c[I]) * d;
        self.s[I + 1] = product::<I, P>(&self.c, &self.w) * d;
        self.c[I + 1] = -product::<I, P>(&self.s, &self.w) * d;
    }
}

/// Follows an end that stays in its place.
pub(crate) fn stay<const P: usize>(
    drop: &Prepared,
    at: &mut OnEnd,
    tolerance: f64,
) -> Result<Option<End>, Uncovered> {
    let it = Staying::<P>::about(drop, at);
    let h = reach::<P>(it.w[P - 1].abs().max(it.w[P - 2].abs()), tolerance);
    let mut first = (h, None);
    earlier(&mut first, &it.s, End::LiesFlat)?;
    earlier(&mut first, &it.n, End::LiftsOff)?;
    earlier(&mut first, &it.left, End::Slips(-1.0))?;
    earlier(&mut first, &it.right, End::Slips(1.0))?;
    let (t, end) = first;
    clear_on_plate(drop, at, (&it.c, &it.s, &[0.0; P]), t)?;
    *at = at.later((&it.c, &it.s, &it.w), t);
    Ok(end)
}

impl OnEnd {
    /// The rod `t` later, its slip and place unchanged.
    fn later<const P: usize>(&self, (c, s, w): (&[f64; P], &[f64; P], &[f64; P]), t: f64) -> Self {
        Self { time: self.time + t, c: value(c, t), s: value(s, t), w: value(w, t), ..*self }
    }
}

/// Takes the root of an event's quantity where it comes before what was found.
fn earlier<const P: usize>(
    first: &mut (f64, Option<End>),
    quantity: &[f64; P],
    end: End,
) -> Result<(), Uncovered> {
    if let Some(t) = first_root(quantity, first.0)? {
        *first = (t, Some(end));
    }
    Ok(())
}

/// How far K has moved.
fn moved<const P: usize>(u: &[f64; P], t: f64) -> f64 {
    let mut sum = 0.0;
    for i in (0..P).rev() {
        sum = sum * t + u[i] * INVERSE[i];
    }
    sum * t
}
