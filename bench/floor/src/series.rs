//! Taylor series as this program needs them: a quotient, how far one reaches, and its first root. The rest is `carom_num::taylor`'s.

use crate::answer::Uncovered;
use crate::tolerance::{LEAST_COEFFICIENT, NEWTON_DONE};
use carom_num::poly;
use carom_num::taylor::{spread, value_and_rate};

/// Steps of a march after which a quantity counts as grazing zero.
const MOST_STEPS: usize = 60;

/// Coefficient `I` of `a/(1 + κ b)`, with `over = 1/(1 + κ b₀)` and the quotient's lower orders.
#[inline(always)]
pub(crate) fn quotient<const I: usize, const P: usize>(
    a: f64,
    (kappa, b, over): (f64, &[f64; P], f64),
    lower: &[f64; P],
) -> f64 {
    let mut sum = 0.0;
    for j in 1..=I {
        sum += lower[I - j] * b[j];
    }
    (a - kappa * sum) * over
}

/// How long a step of a series of `P` coefficients may be for the last of them to add less than `tolerance`. Within a few per cent: the root is
/// taken in the exponent.
pub(crate) fn reach<const P: usize>(last: f64, tolerance: f64) -> f64 {
    const ONE: i64 = 1023 << 52;
    let ratio = tolerance / last.max(LEAST_COEFFICIENT * tolerance);
    #[expect(clippy::cast_possible_wrap, clippy::cast_sign_loss, reason = "bits of a positive number")]
    let root = |bits: u64| ((bits as i64 - ONE) / (P as i64 - 1) + ONE) as u64;
    f64::from_bits(root(ratio.to_bits()))
}

/// The first root in (0, h] of a series that is positive at 0.
pub(crate) fn first_root<const P: usize>(a: &[f64; P], h: f64) -> Result<Option<f64>, Uncovered> {
    if a[0] > spread(a, h) {
        return Ok(None);
    }
    if a[0] <= 0.0 {
        return Err(Uncovered::Tie);
    }
    let mut bend = 0.0;
    for i in (2..P).rev() {
        #[expect(clippy::cast_precision_loss, reason = "a small order")]
        let factor = (i * (i - 1)) as f64;
        bend = bend * h + factor * a[i].abs();
    }
    march(|t| value_and_rate(a, t), bend, 0.0, h)
}

/// The first root in (t, end] of a function that is positive at t, whose second rate is within ±`bend`: steps that cannot pass over it, then
/// Newton's once it is the only one near.
#[inline(always)]
fn march(f: impl Fn(f64) -> (f64, f64), bend: f64, mut t: f64, end: f64) -> Result<Option<f64>, Uncovered> {
    for _ in 0..MOST_STEPS {
        let (value, rate) = f(t);
        if rate < 0.0 && 4.0 * bend * value < rate * rate {
            return Ok(Some(newton(f, t - value / rate)).filter(|root| *root <= end));
        }
        t += poly::first_root(value, rate, bend);
        if t >= end {
            return Ok(None);
        }
    }
    Err(Uncovered::Grazes)
}

/// Newton's steps to a root that is known to be near.
#[inline(always)]
pub(crate) fn newton(f: impl Fn(f64) -> (f64, f64), mut t: f64) -> f64 {
    for _ in 0..8 {
        let (value, rate) = f(t);
        let step = value / rate;
        t -= step;
        // The next step would be of the square of this one.
        if step.abs() < NEWTON_DONE {
            break;
        }
    }
    t
}
