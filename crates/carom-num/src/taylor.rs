//! Taylor series in an array of coefficients: products by order, values, and the first place where a series falls through zero.
//!
//! The coefficients of the solution of a differential equation follow from each other, order by order: those of a product, a square or a
//! quotient of series from the same orders of their factors. [`every_order!`](crate::every_order) writes the orders out, so that every sum
//! has its length when compiled.
//!
//! Source: Jorba, Zou, *A software package for the numerical integration of ODEs by means of high-order Taylor methods*, Exp. Math. 14 (2005).

use crate::poly::first_root;
use crate::tolerance::{TAYLOR_ARRIVED, TAYLOR_SHORTEST};

/// The reciprocals of 1, 2, 3, …: what integration divides the coefficients by.
///
/// # Example
/// ```
/// assert_eq!(carom_num::taylor::INVERSE[..4], [1.0, 1.0 / 2.0, 1.0 / 3.0, 1.0 / 4.0]);
/// ```
pub const INVERSE: [f64; 24] = {
    let mut inverse = [0.0; 24];
    let mut i = 0;
    while i < 24 {
        inverse[i] = 1.0 / (i as f64 + 1.0);
        i += 1;
    }
    inverse
};

/// Calls `$work.$order::<I>()` for I = 0, 1, … below `$end`, at most 20.
///
/// # Example
/// y′ = y gives `yᵢ₊₁ = yᵢ/(i + 1)`, the series of the exponential; what follows the term 1/19! is below
/// rounding.
/// ```
/// use carom_num::taylor::{INVERSE, value};
/// struct Work([f64; 20]);
/// impl Work {
///     fn order<const I: usize>(&mut self) {
///         self.0[I + 1] = self.0[I] * INVERSE[I];
///     }
/// }
/// let mut work = Work([1.0; 20]);
/// carom_num::every_order!(work, order, 19);
/// assert!((value(&work.0, 1.0) - std::f64::consts::E).abs() <= 4.0 * f64::EPSILON);
/// ```
#[macro_export]
macro_rules! every_order {
    ($work:expr, $order:ident, $end:expr) => {
        $crate::every_order!(@ $work, $order, $end, 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19)
    };
    (@ $work:expr, $order:ident, $end:expr, $($i:literal)*) => {
        { $(if $i < $end { $work.$order::<$i>(); })* }
    };
}

/// Coefficient `I` of the product of two series.
///
/// # Example
/// ```
/// // (1 + t)(1 − t) = 1 − t²
/// assert_eq!(carom_num::taylor::product::<2, 3>(&[1.0, 1.0, 0.0], &[1.0, -1.0, 0.0]), -1.0);
/// ```
#[inline(always)]
pub fn product<const I: usize, const P: usize>(a: &[f64; P], b: &[f64; P]) -> f64 {
    // The newest coefficients come last, so that the rest is summed before they are known.
    let mut sum = if I.is_multiple_of(2) { a[I / 2] * b[I / 2] } else { 0.0 };
    for j in (0..I.div_ceil(2)).rev() {
        sum += a[j] * b[I - j] + a[I - j] * b[j];
    }
    sum
}

/// Coefficient `I` of the square of a series.
///
/// # Example
/// ```
/// use carom_num::taylor::square;
/// // (1 + t)² = 1 + 2t + t²
/// let a = [1.0, 1.0, 0.0];
/// assert_eq!([square::<0, 3>(&a), square::<1, 3>(&a), square::<2, 3>(&a)], [1.0, 2.0, 1.0]);
/// ```
#[inline(always)]
pub fn square<const I: usize, const P: usize>(a: &[f64; P]) -> f64 {
    let mut sum = 0.0;
    for j in (0..I.div_ceil(2)).rev() {
        sum += a[j] * a[I - j];
    }
    2.0 * sum + if I.is_multiple_of(2) { a[I / 2] * a[I / 2] } else { 0.0 }
}

/// Coefficient `I` of the product of two series but for its term `a₀ b_I`: what is known of it before `b_I` is.
///
/// # Example
/// ```
/// // (1 + t)(1 − t) = 1 − t²: of the last term 1·0 is left out, and b₂ may be anything.
/// let known = carom_num::taylor::product_but_newest::<2, 3>(&[1.0, 1.0, 0.0], &[1.0, -1.0, f64::NAN]);
/// assert_eq!(known, -1.0);
/// ```
#[inline(always)]
pub fn product_but_newest<const I: usize, const P: usize>(a: &[f64; P], b: &[f64; P]) -> f64 {
    if I == 0 {
        return 0.0;
    }
    let mut sum = if I.is_multiple_of(2) { a[I / 2] * b[I / 2] } else { 0.0 };
    for j in (1..I.div_ceil(2)).rev() {
        sum += a[j] * b[I - j] + a[I - j] * b[j];
    }
    sum + a[I] * b[0]
}

/// Coefficient `I` of the quotient q = a/b from that of `a`, the divisor's up to `I`, `over` = 1/b₀, and the quotient's below `I`.
///
/// # Example
/// ```
/// // 1/(1 − t) = 1 + t + t² + …
/// let b = [1.0, -1.0, 0.0];
/// let mut q = [1.0, 0.0, 0.0];
/// q[1] = carom_num::taylor::quotient::<1, 3>(0.0, (&b, 1.0), &q);
/// assert_eq!(carom_num::taylor::quotient::<2, 3>(0.0, (&b, 1.0), &q), 1.0);
/// ```
#[inline(always)]
pub fn quotient<const I: usize, const P: usize>(a: f64, (b, over): (&[f64; P], f64), q: &[f64; P]) -> f64 {
    (a - product_but_newest::<I, P>(b, q)) * over
}

/// The length of step in which the last coefficients add just what is allowed. In a step of length 1 they would add `excess` times as much,
/// and they grow with the power `order` of the length: `excess^(−1/order)`, to a few per cent, since the root is taken in the exponent.
///
/// # Example
/// ```
/// let reach = carom_num::taylor::reach(1e12, 12);
/// assert!((reach - 0.1).abs() < 0.01, "{reach}");
/// ```
pub fn reach(excess: f64, order: u32) -> f64 {
    const ONE: i64 = 1023 << 52;
    // Between powers of two the bits of a number are linear in it: nearly its logarithm.
    #[expect(clippy::cast_possible_wrap, clippy::cast_sign_loss, reason = "the bits of positive numbers")]
    let root = |bits: u64| ((bits as i64 - ONE) / -i64::from(order) + ONE) as u64;
    f64::from_bits(root(excess.clamp(f64::MIN_POSITIVE, f64::MAX).to_bits()))
}

/// Value of a series.
///
/// # Example
/// ```
/// // 1 + 2t + 3t² at 2
/// assert_eq!(carom_num::taylor::value(&[1.0, 2.0, 3.0], 2.0), 17.0);
/// ```
#[inline(always)]
pub fn value<const P: usize>(a: &[f64; P], t: f64) -> f64 {
    let mut sum = a[P - 1];
    for i in (0..P - 1).rev() {
        sum = sum * t + a[i];
    }
    sum
}

/// Value of the integral of a series from 0.
///
/// # Example
/// ```
/// // t + t² + t³ at 2
/// assert_eq!(carom_num::taylor::integral(&[1.0, 2.0, 3.0], 2.0), 14.0);
/// ```
#[inline(always)]
pub fn integral<const P: usize>(a: &[f64; P], t: f64) -> f64 {
    let mut sum = 0.0;
    for i in (0..P).rev() {
        sum = sum * t + a[i] * INVERSE[i];
    }
    sum * t
}

/// Value and rate of a series.
///
/// # Example
/// ```
/// // 1 + 2t + 3t² and 2 + 6t at 2
/// assert_eq!(carom_num::taylor::value_and_rate(&[1.0, 2.0, 3.0], 2.0), (17.0, 14.0));
/// ```
pub fn value_and_rate<const P: usize>(a: &[f64; P], t: f64) -> (f64, f64) {
    let (mut sum, mut rate) = (a[P - 1], 0.0);
    for i in (0..P - 1).rev() {
        rate = rate * t + sum;
        sum = sum * t + a[i];
    }
    (sum, rate)
}

/// A bound on `|a(t) − a₀|` for 0 ≤ t ≤ h.
///
/// # Example
/// 2t − 3t² is −8 at 2; the bound adds the magnitudes, 4 + 12.
/// ```
/// use carom_num::taylor::{spread, value};
/// let a = [1.0, 2.0, -3.0];
/// assert_eq!((spread(&a, 2.0), value(&a, 2.0) - a[0]), (16.0, -8.0));
/// ```
pub fn spread<const P: usize>(a: &[f64; P], h: f64) -> f64 {
    let mut sum = a[P - 1].abs();
    for i in (1..P - 1).rev() {
        sum = sum * h + a[i].abs();
    }
    sum * h
}

/// A bound on the second rate for 0 ≤ t ≤ h.
fn most_bend<const P: usize>(a: &[f64; P], h: f64) -> f64 {
    let (mut bend, mut factor) = (0.0, (P * (P + 1)) as f64);
    for i in (2..P).rev() {
        // i (i − 1), counted down.
        factor -= 2.0 * (i as f64 + 1.0);
        bend = bend * h + factor * a[i].abs();
    }
    bend
}

/// The first place in [0, h] where a series falls through zero; none is passed over that is deeper than rounding. A start at or below zero
/// counts once the series falls further; one that rises from there does not count.
///
/// # Example
/// ```
/// use carom_num::taylor::first_fall;
/// // (t − 1)(t − 2) falls at 1; t (3 − t) rises from zero and falls at 3.
/// assert!((first_fall(&[2.0, -3.0, 1.0], 5.0).unwrap() - 1.0).abs() < 1e-15);
/// assert!((first_fall(&[0.0, 3.0, -1.0], 5.0).unwrap() - 3.0).abs() < 1e-15);
/// assert_eq!(first_fall(&[1.0, 1.0, 0.0], 5.0), None);
/// ```
pub fn first_fall<const P: usize>(a: &[f64; P], h: f64) -> Option<f64> {
    let spread = spread(a, h);
    if a[0] > spread {
        return None;
    }
    // Every coefficient is in this difference; where it is not finite it may only be too large.
    if !(a[0] - spread).is_finite() && !a.iter().all(|c| c.is_finite()) {
        return None;
    }
    let bend = most_bend(a, h);
    if a[0] > 0.0 {
        return march(a, bend, 0.0, h);
    }
    let first = a.iter().skip(1).find(|c| **c != 0.0);
    if first.is_none_or(|c| *c < 0.0) {
        return first.map(|_| 0.0);
    }
    // It rises from zero, or from below: what it does once it is above.
    let above = if a[0] == 0.0 { 0.0 } else { march(&a.map(|c| -c), bend, 0.0, h)? };
    march(a, bend, above + TAYLOR_SHORTEST * h, h)
}

/// The first root in (t, end] of a series that is positive at t, whose second rate is within ±`bend`: steps that cannot pass over it, then
/// Newton's once it is the only one near.
fn march<const P: usize>(a: &[f64; P], bend: f64, mut t: f64, end: f64) -> Option<f64> {
    while t < end {
        let (value, rate) = value_and_rate(a, t);
        if value <= 0.0 || rate < 0.0 && 4.0 * bend * value < rate * rate {
            let root = newton(a, t, end);
            return (root <= end).then_some(root);
        }
        t += first_root(value, rate, bend).max(TAYLOR_SHORTEST * end);
    }
    // A root in the last step that could be made has not been passed over: there is none.
    None
}

/// Newton's steps to a root that is known to be near.
fn newton<const P: usize>(a: &[f64; P], mut t: f64, end: f64) -> f64 {
    for _ in 0..8 {
        let (value, rate) = value_and_rate(a, t);
        let step = value / rate;
        if !step.is_finite() {
            break;
        }
        t = (t - step).max(0.0);
        // The next step would be of the square of this one.
        if step.abs() <= TAYLOR_ARRIVED * end {
            break;
        }
    }
    t
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_exponential_from_its_equation() {
        struct Work {
            y: [f64; 20],
        }
        impl Work {
            // y′ = y² / y
            fn order<const I: usize>(&mut self) {
                let mut squares = [0.0; 20];
                squares[I] = square::<I, 20>(&self.y);
                let mut q = self.y;
                q[I] = 0.0;
                self.y[I + 1] = quotient::<I, 20>(squares[I], (&self.y, 1.0 / self.y[0]), &q) * INVERSE[I];
            }
        }
        let mut work = Work { y: [0.0; 20] };
        work.y[0] = 1.0;
        every_order!(work, order, 19);
        assert!((value(&work.y, 1.0) - std::f64::consts::E).abs() < 1e-15, "{}", value(&work.y, 1.0));
        assert!((integral(&work.y, 1.0) + 1.0 - std::f64::consts::E).abs() < 1e-15);
        assert_eq!(value_and_rate(&[1.0, 2.0, 3.0], 2.0), (17.0, 14.0));
    }

    /// The coefficients of (t − r₀)(t − r₁)… with a sign.
    fn with_roots(roots: &[f64], sign: f64) -> [f64; 12] {
        let mut a = [0.0; 12];
        a[0] = sign;
        for root in roots {
            for i in (0..12).rev() {
                a[i] = if i > 0 { a[i - 1] } else { 0.0 } - root * a[i];
            }
        }
        a
    }

    #[test]
    fn the_first_fall_is_found_among_many_roots() {
        // Positive at 0: every other root is a fall.
        let a = with_roots(&[0.3, 0.300_001, 0.7, 0.9], 1.0);
        assert!((first_fall(&a, 1.0).unwrap() - 0.3).abs() < 1e-9, "{:?}", first_fall(&a, 1.0));
        // Negative at 0: it rises at 0.3 and falls at the second root.
        let a = with_roots(&[0.3, 0.5, 0.7], 1.0);
        assert!((first_fall(&a, 1.0).unwrap() - 0.5).abs() < 1e-12, "{:?}", first_fall(&a, 1.0));
        assert_eq!(first_fall(&a, 0.4), None, "it ends before");
        // Rises from zero at the start.
        let a = with_roots(&[0.0, 0.6], -1.0);
        assert!((first_fall(&a, 1.0).unwrap() - 0.6).abs() < 1e-12, "{:?}", first_fall(&a, 1.0));
        // Falls from the start.
        let a = with_roots(&[0.0, 0.6], 1.0);
        assert_eq!(first_fall(&a, 1.0), Some(0.0));
        // Touches zero and comes back, to within rounding: either answer will do, but it ends.
        let touches = first_fall(&with_roots(&[0.25, 0.25, 0.75], -1.0), 1.0);
        assert!(touches.is_some_and(|t| (t - 0.25).abs() < 1e-6 || (t - 0.75).abs() < 1e-9), "{touches:?}");
        assert_eq!(first_fall(&[f64::NAN; 5], 1.0), None);
        assert_eq!(first_fall(&[0.0; 5], 1.0), None);
    }
}
