//! The period of a pendulum of any amplitude, and its time between two angles.

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

/// Time of `φ̈ = −ω₀² sin φ` from the lowest point to an angle within ±π, negative for a negative one \[s\]: `(2/Ω) F(φ/2, 2ω₀/Ω)`, Ω > 0 the
/// rate at the lowest point. It must reach the angle, up to rounding.
///
/// Source: with `sin(φ/2) = x` and `(dx/dt)² = (Ω/2)²(1 − x²)(1 − (2ω₀x/Ω)²)`; `F(φ, k) = x R_F(1 − x², 1 − k²x², 1)` is Carlson's (DLMF 19.25.5).
pub(crate) fn time_from_bottom(rate_squared: f64, bottom_rate: f64, angle: f64) -> f64 {
    let (x, cos) = libm::sincos(0.5 * angle);
    let of_bottom = 4.0 * rate_squared * x * x / (bottom_rate * bottom_rate);
    2.0 / bottom_rate * x * symmetric_integral([cos * cos, (1.0 - of_bottom).max(0.0), 1.0])
}

/// Duplications. Each brings the three arguments four times closer, after a few that bring the smallest near the others.
const DUPLICATIONS: u32 = 32;

/// Carlson's symmetric integral R_F of three numbers that are not negative, one of them 0 at most.
///
/// Source: Carlson, Numer. Math. 33 (1979) 1: `R_F(x, y, z) = R_F((x+λ)/4, (y+λ)/4, (z+λ)/4)`, `λ = √x√y + √y√z + √z√x`, and `R_F(x, x, x) = 1/√x`.
fn symmetric_integral(mut of: [f64; 3]) -> f64 {
    for _ in 0..DUPLICATIONS {
        let [x, y, z] = of.map(f64::sqrt);
        let lambda = x * y + y * z + z * x;
        of = of.map(|v| 0.25 * (v + lambda));
    }
    1.0 / of[0].sqrt()
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
    fn the_symmetric_integral_has_its_published_values() {
        // Carlson, Numer. Algorithms 10 (1995) 13, section 3.
        for (of, published) in
            [([1.0, 2.0, 0.0], 1.311_028_777_146_06), ([2.0, 3.0, 4.0], 0.584_082_841_677_15)]
        {
            let ours = symmetric_integral(of);
            assert!((ours - published).abs() < 1e-14, "{of:?}: {ours} not {published}");
        }
    }

    #[test]
    fn the_time_to_the_turn_is_a_quarter_of_the_period() {
        for amplitude in [1e-3f64, 1.0, 3.0] {
            let bottom = 2.0 * 2.5f64.sqrt() * libm::sin(0.5 * amplitude);
            let ours = time_from_bottom(2.5, bottom, amplitude);
            let quarter = 0.25 * period(2.5, amplitude).expect("below the top");
            // The turn is where a root is zero: a rounding before it is its root after it.
            assert!(
                (ours / quarter - 1.0).abs() < 4.0 * f64::EPSILON.sqrt(),
                "{amplitude}: {ours} {quarter}"
            );
        }
    }

    #[test]
    fn small_swings_are_harmonic_and_fast_ones_uniform() {
        // A relative error of A²/16 each way is left of φ = A sin ω₀t, and of (2ω₀/Ω)²/4 of φ = Ωt.
        let small = time_from_bottom(4.0, 2.0 * 1e-6, 0.5e-6);
        assert!((small - 0.5 * libm::asin(0.5)).abs() < 1e-12, "{small}");
        let fast = time_from_bottom(4.0, 1e6, -2.0);
        assert!((fast * 1e6 + 2.0).abs() < 2e-11, "{fast}");
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
