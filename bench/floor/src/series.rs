//! Taylor series: products by order, how far one reaches, its value, and its first root.

use crate::answer::Uncovered;

/// The reciprocals of the orders, up to the longest series used.
pub(crate) const INVERSE: [f64; 32] = {
    let mut inverse = [0.0; 32];
    let mut i = 0;
    while i < 32 {
        inverse[i] = 1.0 / (i as f64 + 1.0);
        i += 1;
    }
    inverse
};
/// Steps of a march after which a quantity counts as grazing zero.
const MOST_STEPS: usize = 60;

/// Coefficient `I` of the product of two series. The newest coefficients come last, so that the rest is summed before they are known.
#[inline(always)]
pub(crate) fn product<const I: usize, const P: usize>(a: &[f64; P], b: &[f64; P]) -> f64 {
    let mut sum = if I.is_multiple_of(2) { a[I / 2] * b[I / 2] } else { 0.0 };
    for j in (0..I.div_ceil(2)).rev() {
        sum += a[j] * b[I - j] + a[I - j] * b[j];
    }
    sum
}

/// Coefficient `I` of the square of a series.
#[inline(always)]
pub(crate) fn square<const I: usize, const P: usize>(a: &[f64; P]) -> f64 {
    let mut sum = 0.0;
    for j in (0..I.div_ceil(2)).rev() {
        sum += a[j] * a[I - j];
    }
    2.0 * sum + if I.is_multiple_of(2) { a[I / 2] * a[I / 2] } else { 0.0 }
}

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

/// Calls `$work.order::<I>()` for every order below `$last`, written out, so that every sum has its length when compiled.
macro_rules! every_order {
    ($work:expr, $last:expr) => {
        every_order!($work, $last, 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19)
    };
    ($work:expr, $last:expr, $($i:literal)*) => {
        $(if $i < $last { $work.order::<$i>(); })*
    };
}
pub(crate) use every_order;

/// How long a step of a series of `P` coefficients may be for the last of them to add less than `tolerance`. Within a few per cent: the root is
/// taken in the exponent.
pub(crate) fn reach<const P: usize>(last: f64, tolerance: f64) -> f64 {
    const ONE: i64 = 1023 << 52;
    let ratio = tolerance / last.max(1e-3 * tolerance);
    #[expect(clippy::cast_possible_wrap, clippy::cast_sign_loss, reason = "bits of a positive number")]
    let root = |bits: u64| ((bits as i64 - ONE) / (P as i64 - 1) + ONE) as u64;
    f64::from_bits(root(ratio.to_bits()))
}

/// Value of a series.
#[inline(always)]
pub(crate) fn value<const P: usize>(a: &[f64; P], t: f64) -> f64 {
    let mut sum = a[P - 1];
    for i in (0..P - 1).rev() {
        sum = sum * t + a[i];
    }
    sum
}

/// Value and rate of a series.
fn value_and_rate<const P: usize>(a: &[f64; P], t: f64) -> (f64, f64) {
    let (mut sum, mut rate) = (a[P - 1], 0.0);
    for i in (0..P - 1).rev() {
        rate = rate * t + sum;
        sum = sum * t + a[i];
    }
    (sum, rate)
}

/// A bound on `|a(t) − a₀|` for t ≤ h.
pub(crate) fn spread<const P: usize>(a: &[f64; P], h: f64) -> f64 {
    let mut sum = a[P - 1].abs();
    for i in (1..P - 1).rev() {
        sum = sum * h + a[i].abs();
    }
    sum * h
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

/// How far a quantity of this value and rate stays positive where its second rate is at least `-bend`.
#[inline(always)]
pub(crate) fn safe(value: f64, rate: f64, bend: f64) -> f64 {
    // The greater root of value + rate t − bend t²/2, without cancellation.
    let root = (rate * rate + 2.0 * bend * value).sqrt();
    if rate < 0.0 { 2.0 * value / (root - rate) } else { (rate + root) / bend.max(f64::MIN_POSITIVE) }
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
        t += safe(value, rate, bend);
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
        if step.abs() < 1e-8 {
            break;
        }
    }
    t
}
