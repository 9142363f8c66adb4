//! The period of a pendulum of any amplitude.

use crate::OutsideDomain;
use crate::domain::require;
use core::f64::consts::PI;

/// Steps of the mean. Each doubles the digits that agree, after as many as bring the smallest cos(A/2) near 1.
const STEPS: u32 = 16;

/// Period of `φ̈ = −ω₀² sin φ` with an amplitude A \[s\]: `2π/(ω₀ agm(1, cos(A/2)))`.
///
/// Source: Landau and Lifshitz, Mechanics, §11, problem 1, as a complete elliptic integral; that it is an arithmetic-geometric
/// mean is Gauss's (Abramowitz and Stegun, 17.6.3).
pub(crate) fn period(rate_squared: f64, amplitude: f64) -> Result<f64, OutsideDomain> {
    require(amplitude.abs() < PI, "amplitude", amplitude, "-pi < amplitude < pi")?;
    Ok(2.0 * PI / (rate_squared.sqrt() * mean(1.0, libm::cos(0.5 * amplitude))))
}

/// The arithmetic-geometric mean of two positive numbers.
fn mean(mut a: f64, mut b: f64) -> f64 {
    for _ in 0..STEPS {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    a
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mean_of_one_and_the_root_of_two_is_of_gauss() {
        let ours = mean(1.0, core::f64::consts::SQRT_2);
        assert!((ours - 1.198_140_234_735_592_2).abs() < 4e-16, "1/0.8346268…, his constant: {ours}");
        assert_eq!(mean(3.0, 3.0), 3.0, "of equal numbers");
        assert!((mean(24.0, 6.0) - 13.458_171_481_725_614).abs() < 4e-15, "an example of many books");
    }

    #[test]
    fn long_swings_take_the_logarithm_of_what_is_left_to_the_top() {
        // K(k) → ln(4/k′) as k′ → 0: T = (4/ω₀) ln(4/cos(A/2)).
        // The correction is of the order of k′² ln(1/k′); in PI − rest an absolute rounding is left, which rest magnifies.
        for rest in [1e-3f64, 1e-5, 1e-7] {
            let ours = period(1.0, PI - rest).expect("below the top");
            let limit = 4.0 * libm::log(8.0 / rest);
            let allowed = rest * rest + f64::EPSILON / rest;
            assert!((ours / limit - 1.0).abs() < allowed, "{rest}: {ours} {limit}");
        }
        assert_eq!(period(1.0, PI).map_err(|error| error.quantity), Err("amplitude"), "never");
    }
}
