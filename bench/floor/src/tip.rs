//! Over the edge: the rod slides on it and turns, until it lifts off or its end runs off.
//!
//! With r from the edge to the centre, s = ṙ, w the turning rate and θ the tilt below the horizontal, n = N/m:
//!
//! ```text
//! n = (cos θ − 2 s w)/(1 + κ r²),   ẇ = κ r n,   ṡ = r w² + sin θ − μ n
//! ```

use crate::answer::{KAPPA, Prepared, Uncovered};
use crate::series::{first_root, quotient, reach};
use carom_num::every_order;
use carom_num::taylor::{INVERSE, product, square, value};

/// Steps after which the rod should have lifted off.
const MOST_STEPS: usize = 60;

/// The rod at the edge.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tip {
    pub(crate) time: f64,
    pub(crate) reach: f64,
    pub(crate) slip: f64,
    pub(crate) turning: f64,
    /// Cosine and sine of the tilt.
    pub(crate) cos: f64,
    pub(crate) sin: f64,
}

/// The series of one step.
struct Expansion<const P: usize> {
    friction: f64,
    /// Of 1 + κ r² at the start.
    over: f64,
    r: [f64; P],
    s: [f64; P],
    w: [f64; P],
    cos: [f64; P],
    sin: [f64; P],
    /// Numerator of the normal force.
    pressing: [f64; P],
    n: [f64; P],
    rr: [f64; P],
    ww: [f64; P],
}

impl<const P: usize> Expansion<P> {
    #[inline(always)]
    fn about(at: &Tip, friction: f64) -> Self {
        let (z, over) = ([0.0; P], 1.0 / (1.0 + KAPPA * at.reach * at.reach));
        let mut it =
            Self { friction, over, r: z, s: z, w: z, cos: z, sin: z, pressing: z, n: z, rr: z, ww: z };
        (it.r[0], it.s[0], it.w[0], it.cos[0], it.sin[0]) = (at.reach, at.slip, at.turning, at.cos, at.sin);
        every_order!(it, order, P - 1);
        it
    }

    /// From the coefficients up to `I` those of the next order.
    #[inline(always)]
    fn order<const I: usize>(&mut self) {
        self.rr[I] = square::<I, P>(&self.r);
        self.ww[I] = square::<I, P>(&self.w);
        self.pressing[I] = self.cos[I] - 2.0 * product::<I, P>(&self.s, &self.w);
        self.n[I] = quotient::<I, P>(self.pressing[I], (KAPPA, &self.rr, self.over), &self.n);
        let d = INVERSE[I];
        self.r[I + 1] = self.s[I] * d;
        self.s[I + 1] = (product::<I, P>(&self.r, &self.ww) + self.sin[I] - self.friction * self.n[I]) * d;
        self.w[I + 1] = KAPPA * product::<I, P>(&self.r, &self.n) * d;
        self.cos[I + 1] = -product::<I, P>(&self.sin, &self.w) * d;
        self.sin[I + 1] = product::<I, P>(&self.cos, &self.w) * d;
    }

    fn at(&self, start: f64, t: f64) -> Tip {
        Tip {
            time: start + t,
            reach: value(&self.r, t),
            slip: value(&self.s, t),
            turning: value(&self.w, t),
            cos: value(&self.cos, t),
            sin: value(&self.sin, t),
        }
    }
}

/// From the moment the centre is over the edge to where the rod leaves it; true where its end runs off.
pub(crate) fn tip<const P: usize>(
    drop: &Prepared,
    start: Tip,
    tolerance: f64,
) -> Result<(Tip, bool), Uncovered> {
    let mut now = start;
    for _ in 0..MOST_STEPS {
        let series = Expansion::<P>::about(&now, drop.friction);
        let last = series.w[P - 1].abs().max(series.s[P - 1].abs());
        let h = reach::<P>(last.max(series.w[P - 2].abs()).max(series.s[P - 2].abs()), tolerance);
        let lifts = first_root(&series.pressing, h)?;
        let until = lifts.unwrap_or(h);
        let mut left = series.r.map(|a| -a);
        left[0] += 1.0;
        let runs = first_root(&left, until)?;
        now = series.at(now.time, runs.unwrap_or(until));
        if lifts.is_some() || runs.is_some() {
            return Ok((now, runs.is_some()));
        }
    }
    Err(Uncovered::TooLong)
}
