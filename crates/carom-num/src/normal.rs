//! The normal distribution.

use crate::tolerance::QUANTILE_ARRIVED;
use std::f64::consts::SQRT_2;

/// Probability that a standard normal number is below `z`.
///
/// # Example
/// ```
/// use carom_num::normal::probability;
/// assert_eq!(probability(0.0), 0.5);
/// assert!((probability(1.5) + probability(-1.5) - 1.0).abs() <= f64::EPSILON);
/// ```
pub fn probability(z: f64) -> f64 {
    0.5 * libm::erfc(-z / SQRT_2)
}

/// The number that a standard normal one is below with probability `p` in (0, 1); infinite at its ends.
///
/// # Source
/// Newton's method with Halley's correction on [`probability`], from the bound of the tail: own.
///
/// # Example
/// ```
/// let z = carom_num::normal::quantile(0.975);
/// assert!((z - 1.959963984540054).abs() < 1e-14);
/// ```
pub fn quantile(p: f64) -> f64 {
    if p <= 0.0 || p >= 1.0 || p.is_nan() {
        return if p <= 0.0 {
            f64::NEG_INFINITY
        } else if p >= 1.0 {
            f64::INFINITY
        } else {
            f64::NAN
        };
    }
    if p > 0.5 {
        // 1 − p is exact there; the tail keeps its digits below.
        return -quantile(1.0 - p);
    }
    // Where the tail's leading term, e^(−z²/2)/(z√(2π)), has the probability; near the middle the straight line.
    let t = (-2.0 * libm::log(p)).sqrt();
    let mut z =
        if p > 0.2 { (p - 0.5) * 2.506_628_274_631_000_7 } else { -(t - (libm::log(t * 2.506_6)) / t) };
    for _ in 0..20 {
        let density = libm::exp(-0.5 * z * z) / 2.506_628_274_631_000_7;
        let step = (probability(z) - p) / density;
        let next = z - step / (1.0 + 0.5 * z * step);
        if (next - z).abs() <= QUANTILE_ARRIVED * z.abs() {
            return next;
        }
        z = next;
    }
    z
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_give_back_their_probability() {
        for k in 1..2000 {
            let p = f64::from(k) / 2000.0;
            assert!((probability(quantile(p)) - p).abs() < 4e-16, "{p}");
            assert!((quantile(p) + quantile(1.0 - p)).abs() < 1e-12, "{p}");
        }
        for p in [1e-300, 1e-100, 1e-20, 1e-10, 1e-5] {
            let back = probability(quantile(p));
            assert!((back / p - 1.0).abs() < 1e-12, "{p:e} {back:e}");
        }
        assert_eq!(quantile(0.5), 0.0);
        // Φ(3) = 0.998650101968370, Φ(1) = 0.841344746068543 (tables).
        assert!((quantile(0.841_344_746_068_543) - 1.0).abs() < 1e-14);
        assert_eq!((quantile(0.0), quantile(1.0)), (f64::NEG_INFINITY, f64::INFINITY));
    }
}
