//! An explicit Runge–Kutta step with dense output: order 8(5,3) of Dormand and Prince, dense output of order 7 (DOP853).
//!
//! [`step`] is to this method what [`crate::ode::step`] is to the one of order 5: the whole step, dense output included.
//! A step that may be refused, or of which only the end counts, is a [`Trial`] from [`step_plain`]: it costs 11 evaluations, and
//! [`Trial::with_dense`] makes a [`Step`] of it for 4 more.
//!
//! Source: Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations I*, 2nd ed., II.5 and II.6; error estimate and coefficients as in
//! their code DOP853.

mod coefficients;
mod through;

use coefficients::{DENSE, DENSE_STAGES, END, FIFTH, STAGES, THIRD, Weights};

/// Evaluations of the right-hand side in a [`step_plain`], its first stage given.
pub const EVALUATIONS_PLAIN: u64 = 11;
/// Evaluations that [`Trial::with_dense`] adds: the derivative at the end and the three stages of the dense output.
pub const EVALUATIONS_DENSE: u64 = 4;
/// Evaluations in a whole [`step`].
pub const EVALUATIONS: u64 = EVALUATIONS_PLAIN + EVALUATIONS_DENSE;

/// The state of a system of equations: an array of numbers, or an array of such arrays (one for each body, say).
pub trait Vector: Copy {
    /// How many numbers it holds.
    const COUNT: usize;
    /// A vector of its numbers, counted from 0.
    fn from_fn(number: impl FnMut(usize) -> f64) -> Self;
    /// Its number `i`, counted from 0.
    fn at(&self, i: usize) -> f64;
}

impl<const D: usize> Vector for [f64; D] {
    const COUNT: usize = D;

    #[inline]
    fn from_fn(number: impl FnMut(usize) -> f64) -> Self {
        std::array::from_fn(number)
    }

    #[inline]
    fn at(&self, i: usize) -> f64 {
        self[i]
    }
}

impl<const D: usize, const B: usize> Vector for [[f64; D]; B] {
    const COUNT: usize = B * D;

    #[inline(always)]
    fn from_fn(mut number: impl FnMut(usize) -> f64) -> Self {
        std::array::from_fn(|b| std::array::from_fn(|d| number(b * D + d)))
    }

    #[inline(always)]
    fn at(&self, i: usize) -> f64 {
        self[i / D][i % D]
    }
}

/// The two error estimates of a step, multiplied by its length.
#[derive(Clone, Copy, Debug)]
pub struct Estimates<V> {
    /// Difference from the embedded solution of order 5.
    pub fifth: V,
    /// Difference from the embedded solution of order 3.
    pub third: V,
}

impl<V: Vector> Estimates<V> {
    /// Both estimates in one number, each component divided by its tolerance; a step is good where it is at most 1.
    ///
    /// ```text
    /// e₅² / √(n (e₅² + 0.01 e₃²)),   eᵢ² = Σ (estimateᵢ / tolerance)²
    /// ```
    ///
    /// With e₅ of order 6 in the length and e₃ of order 4 it is of order 8, as fits the solution.
    /// It is not finite where a stage or a square is not, and 0 where both estimates vanish.
    ///
    /// # Source
    /// The code DOP853 of Hairer, Nørsett and Wanner.
    pub fn scaled(&self, tolerance: &V) -> f64 {
        let squares = |estimate: &V| -> f64 {
            let scaled = |i: usize| estimate.at(i) / tolerance.at(i);
            (0..V::COUNT).map(|i| scaled(i) * scaled(i)).sum()
        };
        let fifth = squares(&self.fifth);
        let both = fifth + 0.01 * squares(&self.third);
        #[expect(clippy::cast_precision_loss, reason = "a handful")]
        let count = V::COUNT as f64;
        // A NaN must come out as it is, and a sum that overflows must not divide a finite one to zero: such steps are refused.
        if both == 0.0 {
            0.0
        } else if both == f64::INFINITY {
            both
        } else {
            fifth / (count * both).sqrt()
        }
    }
}

/// A step of an autonomous system without its dense output and the derivative at its end.
#[derive(Clone, Copy, Debug)]
pub struct Trial<V> {
    /// Length of the step.
    pub length: f64,
    /// State at its start.
    pub start: V,
    /// State at its end, to order 8.
    pub end: V,
    /// Error estimates.
    pub error: Estimates<V>,
    stages: [V; 12],
}

/// An accepted step of an autonomous system.
#[derive(Clone, Copy, Debug)]
pub struct Step<V> {
    /// Length of the step.
    pub length: f64,
    /// State at its start.
    pub start: V,
    /// Derivative at its start.
    pub start_rate: V,
    /// State at its end, to order 8.
    pub end: V,
    /// Derivative at its end: the first stage of the next step.
    pub end_rate: V,
    /// Error estimates.
    pub error: Estimates<V>,
    dense: [V; 6],
}

/// The weighted sum of stages, times the length.
fn weighted<V: Vector>(length: f64, weights: Weights, stages: &[V]) -> V {
    let mut sum = V::from_fn(|_| 0.0);
    for &(stage, weight) in weights {
        sum = V::from_fn(|i| sum.at(i) + weight * stages[stage].at(i));
    }
    V::from_fn(|i| length * sum.at(i))
}

fn plus<V: Vector>(a: &V, b: &V) -> V {
    V::from_fn(|i| a.at(i) + b.at(i))
}

/// Makes a step of `length` from `start`, whose derivative is `rate`, with its dense output.
pub fn step<V: Vector>(start: V, rate: V, length: f64, mut f: impl FnMut(&V) -> V) -> Step<V> {
    let trial = step_plain(start, rate, length, &mut f);
    trial.with_dense(f(&trial.end), f)
}

/// Tries a step of `length` from `start`, whose derivative is `rate`, as far as its end and the error there.
pub fn step_plain<V: Vector>(start: V, rate: V, length: f64, mut f: impl FnMut(&V) -> V) -> Trial<V> {
    let mut stages = [rate; 12];
    for (before, weights) in STAGES.iter().enumerate() {
        stages[before + 1] = f(&plus(&start, &weighted(length, weights, &stages)));
    }
    let rise = weighted(length, END, &stages);
    let third = weighted(length, THIRD, &stages);
    let error = Estimates {
        fifth: weighted(length, FIFTH, &stages),
        third: V::from_fn(|i| rise.at(i) - third.at(i)),
    };
    Trial { length, start, end: plus(&start, &rise), error, stages }
}

impl<V: Vector> Trial<V> {
    /// The step with its dense output, given the derivative at its end; `f` must be the right-hand side that it was tried with.
    pub fn with_dense(&self, end_rate: V, mut f: impl FnMut(&V) -> V) -> Step<V> {
        let Trial { length, start, end, error, .. } = *self;
        let mut stages = [end_rate; 16];
        stages[..12].copy_from_slice(&self.stages);
        for (i, weights) in DENSE_STAGES.iter().enumerate() {
            stages[13 + i] = f(&plus(&start, &weighted(length, weights, &stages)));
        }
        let rise = |i: usize| end.at(i) - start.at(i);
        let bend = V::from_fn(|i| length * stages[0].at(i) - rise(i));
        let mut dense = [bend; 6];
        dense[1] = V::from_fn(|i| rise(i) - length * end_rate.at(i) - bend.at(i));
        for (i, weights) in DENSE.iter().enumerate() {
            dense[2 + i] = weighted(length, weights, &stages);
        }
        Step { length, start, start_rate: stages[0], end, end_rate, error, dense }
    }

    /// [`Estimates::scaled`] of this trial.
    pub fn scaled_error(&self, tolerance: &V) -> f64 {
        self.error.scaled(tolerance)
    }
}

impl<V: Vector> Step<V> {
    /// A step whose two ends are known: the cubic with these states and derivatives there, exact where every component is a cubic.
    pub fn between((start, start_rate): (V, V), (end, end_rate): (V, V), length: f64) -> Self {
        let rise = |i: usize| end.at(i) - start.at(i);
        let bend = V::from_fn(|i| length * start_rate.at(i) - rise(i));
        let mut dense = [V::from_fn(|_| 0.0); 6];
        dense[1] = V::from_fn(|i| rise(i) - length * end_rate.at(i) - bend.at(i));
        dense[0] = bend;
        let error = Estimates { fifth: dense[5], third: dense[5] };
        Self { length, start, start_rate, end, end_rate, error, dense }
    }

    /// State at the fraction `x` in [0, 1] of the step, to order 7.
    pub fn at(&self, x: f64) -> V {
        let z = 1.0 - x;
        V::from_fn(|i| {
            let [a, b, c, e, g, h] = std::array::from_fn(|term| self.dense[term].at(i));
            let (start, rise) = (self.start.at(i), self.end.at(i) - self.start.at(i));
            start + x * (rise + z * (a + x * (b + z * (c + x * (e + z * (g + x * h))))))
        })
    }

    /// [`Estimates::scaled`] of this step.
    pub fn scaled_error(&self, tolerance: &V) -> f64 {
        self.error.scaled(tolerance)
    }
}

/// Factor on the step length after a step with this scaled error: order 8, kept within [0.2, 5].
///
/// The bounds are met where the error is no longer its leading term, and its eighth root no longer a forecast: above 4.35⁸ ≈ 1.3·10⁵ the step is
/// beyond the reach of its series, and below (0.87/5)⁸ ≈ 10⁻⁶ what is seen at this length says little of one five times as long.
pub fn length_factor(scaled_error: f64) -> f64 {
    if scaled_error <= 0.0 {
        5.0
    } else {
        (0.87 * crate::elementary::pow(scaled_error, -0.125)).clamp(0.2, 5.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::elementary::{cos, sin};

    /// Places of the stages in the step, as published; the code has no use for them, since the systems are autonomous.
    const PLACES: [f64; 16] = [
        0.0,
        0.052_600_151_958_767_73,
        0.078_900_227_938_151_6,
        0.118_350_341_907_227_4,
        0.281_649_658_092_772_6,
        1.0 / 3.0,
        0.25,
        4.0 / 13.0,
        127.0 / 195.0,
        0.6,
        6.0 / 7.0,
        1.0,
        1.0,
        0.1,
        0.2,
        7.0 / 9.0,
    ];

    fn swing(y: &[f64; 2]) -> [f64; 2] {
        [y[1], -sin(y[0])]
    }

    #[test]
    fn a_cubic_between_two_ends_is_exact() {
        let at = |t: f64| [1.0 - 2.0 * t + 3.0 * t * t - 0.5 * t * t * t, 4.0 * t];
        let rate = |t: f64| [-2.0 + 6.0 * t - 1.5 * t * t, 4.0];
        let step = Step::between((at(0.0), rate(0.0)), (at(2.0), rate(2.0)), 2.0);
        for x in [0.0, 0.1, 0.5, 0.8, 1.0] {
            assert!(distance(&step.at(x), &at(2.0 * x)) < 1e-14, "{x}: {:?}", step.at(x));
        }
    }

    fn distance<const D: usize>(a: &[f64; D], b: &[f64; D]) -> f64 {
        a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
    }

    #[test]
    fn each_stage_stands_at_the_sum_of_its_weights() {
        let rows = STAGES.iter().chain(std::iter::once(&END)).chain(&DENSE_STAGES);
        for (stage, row) in rows.enumerate() {
            let sum: f64 = row.iter().map(|(_, a)| a).sum();
            let size: f64 = row.iter().map(|(_, a)| a.abs()).sum();
            assert!((sum - PLACES[stage + 1]).abs() <= 4.0 * f64::EPSILON * size, "{stage}: {sum}");
            assert!(row.iter().all(|&(before, _)| before <= stage), "stage {stage} is explicit");
        }
    }

    #[test]
    fn the_weights_integrate_the_powers_that_their_order_promises() {
        let moment = |weights: Weights, power: i32| -> f64 {
            weights.iter().map(|&(i, w)| w * PLACES[i].powi(power)).sum()
        };
        for power in 0..8 {
            let exact = 1.0 / f64::from(power + 1);
            assert!((moment(END, power) - exact).abs() < 1e-14, "order 8, power {power}");
            // The estimates are differences from solutions of order 5 and 3, and must see more than those do.
            let [fifth, third] = [moment(FIFTH, power), moment(THIRD, power) - exact];
            assert_eq!(fifth.abs() < 1e-14, power < 5, "order 5, power {power}: {fifth}");
            assert_eq!(third.abs() < 1e-14, power < 3, "order 3, power {power}: {third}");
        }
    }

    #[test]
    fn the_dense_output_is_exact_for_powers_up_to_the_seventh() {
        let s = step([0.0, 0.0], [1.0, 0.0], 1.0, |y| [1.0, 7.0 * y[0].powi(6)]);
        for i in 0..=20 {
            let x = f64::from(i) / 20.0;
            let [t, p] = s.at(x);
            // The weights of the dense output reach 500: rounding is that much larger.
            assert!((t - x).abs() < 1e-13 && (p - x.powi(7)).abs() < 1e-12, "{x}: {t} {p}");
        }
    }

    #[test]
    fn the_step_is_of_order_eight_and_its_dense_output_of_order_seven() {
        let oscillate = |h: f64| step([0.0, 1.0], [1.0, 0.0], h, |y| [y[1], -y[0]]);
        let end_error = |h: f64| distance(&oscillate(h).end, &[sin(h), cos(h)]);
        let dense_error = |h: f64| distance(&oscillate(h).at(0.3), &[sin(0.3 * h), cos(0.3 * h)]);
        // Local errors: halving the step divides them by 2⁹ and 2⁸; half an order is left for the next term.
        let (end, dense) = (end_error(1.0) / end_error(0.5), dense_error(1.0) / dense_error(0.5));
        assert!(end > 362.0, "2^8.5: {end}, {:e} {:e}", end_error(1.0), end_error(0.5));
        assert!(dense > 181.0, "2^7.5: {dense}, {:e} {:e}", dense_error(1.0), dense_error(0.5));
    }

    #[test]
    fn the_orders_hold_for_the_pendulum_which_is_not_linear() {
        let start = [-1.0, 1.5];
        let fine = |length: f64| {
            let part = length / 16.0;
            (0..16).fold(start, |y, _| step_plain(y, swing(&y), part, swing).end)
        };
        let errors = |h: f64| {
            let s = step(start, swing(&start), h, swing);
            [distance(&s.end, &fine(h)), distance(&s.at(0.7), &fine(0.7 * h))]
        };
        // Short enough for the leading term to rule: at twice this length the next ones still hide it.
        let ([end, dense], [half_end, half_dense]) = (errors(0.3), errors(0.15));
        assert!(end / half_end > 362.0, "{end:e} {half_end:e}");
        assert!(dense / half_dense > 181.0, "{dense:e} {half_dense:e}");
    }

    #[test]
    fn the_error_estimate_is_of_order_eight_and_above_the_error() {
        let start = [1.0, 0.5];
        let estimate = |h: f64| step_plain(start, swing(&start), h, swing).scaled_error(&[1.0, 1.0]);
        let ratio = estimate(0.4) / estimate(0.2);
        assert!(ratio > 181.0 && ratio < 724.0, "2^7.5 to 2^9.5: {ratio}");
        let s = step([0.0, 1.0], [1.0, 0.0], 1.0, |y| [y[1], -y[0]]);
        let error = distance(&s.end, &[sin(1.0), cos(1.0)]);
        assert!(s.scaled_error(&[1.0, 1.0]) > error, "{} {error}", s.scaled_error(&[1.0, 1.0]));
    }

    #[test]
    fn a_trial_and_its_dense_output_cost_what_they_say_and_are_the_step() {
        let (start, mut count) = ([1.0, 0.5], 0);
        let trial = step_plain(start, swing(&start), 0.3, |y| {
            count += 1;
            swing(y)
        });
        assert_eq!(count, EVALUATIONS_PLAIN);
        let dense = trial.with_dense(swing(&trial.end), |y| {
            count += 1;
            swing(y)
        });
        assert_eq!(count + 1, EVALUATIONS, "the derivative at the end is one more");
        let whole = step(start, swing(&start), 0.3, swing);
        assert_eq!((dense.end, dense.at(0.37)), (whole.end, whole.at(0.37)));
        assert_eq!(whole.end_rate, swing(&whole.end), "the first stage of the next step");
        assert_eq!(whole.at(0.0), start);
        assert!(distance(&whole.at(1.0), &whole.end) < 4.0 * f64::EPSILON, "{:?}", whole.at(1.0));
    }

    #[test]
    fn a_step_without_error_grows_five_times_and_one_that_is_not_finite_is_no_good() {
        let still = step_plain([1.0], [0.0], 1.0, |_| [0.0]);
        assert_eq!(length_factor(still.scaled_error(&[1e-10])), 5.0);
        assert_eq!(length_factor(f64::INFINITY), 0.2);
        assert!((length_factor(1.0) - 0.87).abs() < 1e-15, "on the tolerance only the safety factor acts");
        let lost = step_plain([1.0], [0.0], 1.0, |_| [f64::NAN]);
        assert!(lost.scaled_error(&[1e-10]).is_nan(), "a lost state must not pass for a good one");
        let wild = Estimates { fifth: [1e100], third: [1e200] };
        assert_eq!(wild.scaled(&[1.0]), f64::INFINITY, "nor one whose squares overflow");
    }
}
