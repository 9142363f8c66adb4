//! The order, the cost and the error estimates of the step of order 8.

use super::*;
use crate::elementary::{cos, sin};

/// Some ten roundings: coefficients are up to ten.
const ROUNDING: f64 = 1e-14;

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
        assert!(distance(&step.at(x), &at(2.0 * x)) < ROUNDING, "{x}: {:?}", step.at(x));
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
        assert!((moment(END, power) - exact).abs() < ROUNDING, "order 8, power {power}");
        // The estimates are differences from solutions of order 5 and 3, and must see more than those do.
        let [fifth, third] = [moment(FIFTH, power), moment(THIRD, power) - exact];
        assert_eq!(fifth.abs() < ROUNDING, power < 5, "order 5, power {power}: {fifth}");
        assert_eq!(third.abs() < ROUNDING, power < 3, "order 3, power {power}: {third}");
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

/// A step whose error has left the range of numbers is refused, also where only the mean of its squares has: the sum below is a number, six times it is none.
#[test]
fn an_error_beyond_all_numbers_is_never_small() {
    for size in [1e150, 1e153, 5e153, 1e154, 1e160, 1e308] {
        let huge = Estimates { fifth: [size; 6], third: [0.0; 6] };
        let error = huge.scaled(&[1.0; 6]);
        assert!(error >= 1e150, "{size:e}: {error:e}");
    }
}
