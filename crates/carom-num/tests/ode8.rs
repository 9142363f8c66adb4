//! The method of order 8 over whole orbits and swings, against closed forms and the method of order 5.

use carom_num::elementary::{cos, sin};
use carom_num::{ode, ode8};

/// What a period adds up to: some hundred steps with errors of 1e-12 each.
const DRIFT: f64 = 1e-10;
/// Error of one step where the two orders are compared.
const TIGHT: f64 = 1e-10;

/// What an integration with adapted steps comes to.
#[derive(Debug)]
struct Outcome<const D: usize> {
    end: [f64; D],
    evaluations: u64,
    steps: u64,
    /// The largest of what was measured inside the steps.
    worst: f64,
}

/// Integrates to `time` by order 8, with `tolerance` for every component, and measures states within the steps.
fn by_order_eight<const D: usize>(
    start: [f64; D],
    time: f64,
    tolerance: f64,
    f: impl Fn(&[f64; D]) -> [f64; D],
    measure: impl Fn(&[f64; D]) -> f64,
) -> Outcome<D> {
    let (mut y, mut rate, mut now, mut length) = (start, f(&start), 0.0, 0.01);
    let mut out = Outcome { end: start, evaluations: 1, steps: 0, worst: 0.0 };
    while now < time {
        let trial = ode8::step_plain(y, rate, f64::min(length, time - now), &f);
        out.evaluations += ode8::EVALUATIONS_PLAIN;
        let error = trial.scaled_error(&[tolerance; D]);
        if error <= 1.0 {
            let step = trial.with_dense(f(&trial.end), &f);
            out.evaluations += ode8::EVALUATIONS_DENSE;
            out.steps += 1;
            out.worst =
                [0.25, 0.5, 0.75, 1.0].iter().map(|x| measure(&step.at(*x))).fold(out.worst, f64::max);
            // The last step ends at `time` itself: a rounded sum may fall short of it.
            now = if trial.length < length { time } else { now + trial.length };
            (y, rate) = (step.end, step.end_rate);
        }
        length = trial.length * ode8::length_factor(error);
    }
    out.end = y;
    out
}

/// The same by order 5.
fn by_order_five<const D: usize>(
    start: [f64; D],
    time: f64,
    tolerance: f64,
    f: impl Fn(&[f64; D]) -> [f64; D],
    measure: impl Fn(&[f64; D]) -> f64,
) -> Outcome<D> {
    let (mut y, mut rate, mut now, mut length) = (start, f(&start), 0.0, 0.01);
    let mut out = Outcome { end: start, evaluations: 1, steps: 0, worst: 0.0 };
    while now < time {
        let step = ode::step(y, rate, f64::min(length, time - now), &f);
        out.evaluations += ode::EVALUATIONS;
        let error = step.scaled_error(&[tolerance; D]);
        if error <= 1.0 {
            out.steps += 1;
            out.worst =
                [0.25, 0.5, 0.75, 1.0].iter().map(|x| measure(&step.at(*x))).fold(out.worst, f64::max);
            now = if step.length < length { time } else { now + step.length };
            (y, rate) = (step.end, step.end_rate);
        }
        length = step.length * ode::length_factor(error);
    }
    out.end = y;
    out
}

fn swing(y: &[f64; 2]) -> [f64; 2] {
    [y[1], -sin(y[0])]
}

fn energy(y: &[f64; 2]) -> f64 {
    0.5 * y[1] * y[1] - cos(y[0])
}

/// Period of a pendulum of unit frequency that swings to `amplitude` [rad]: 2π over the arithmetic-geometric mean of 1 and cos(amplitude/2) (Gauss).
fn period(amplitude: f64) -> f64 {
    let (mut a, mut g) = (1.0, cos(0.5 * amplitude));
    for _ in 0..8 {
        (a, g) = (0.5 * (a + g), f64::sqrt(a * g));
    }
    2.0 * std::f64::consts::PI / a
}

fn kepler(y: &[f64; 4]) -> [f64; 4] {
    let r2 = y[0] * y[0] + y[1] * y[1];
    let pull = 1.0 / (r2 * r2.sqrt());
    [y[2], y[3], -y[0] * pull, -y[1] * pull]
}

#[test]
fn a_pendulum_comes_back_after_its_period_and_keeps_its_energy() {
    for amplitude in [0.5, 2.0, 3.0] {
        let start = [amplitude, 0.0];
        let drift = |y: &[f64; 2]| (energy(y) - energy(&start)).abs();
        let out = by_order_eight(start, period(amplitude), 1e-12, swing, drift);
        // Some tens of steps, each within the tolerance; near the top errors grow by the time spent there.
        assert!((out.end[0] - amplitude).abs() < DRIFT && out.end[1].abs() < DRIFT, "{amplitude}: {out:?}");
        assert!(out.worst < DRIFT, "{amplitude}: {out:?}");
    }
}

#[test]
fn a_planet_keeps_energy_and_momentum_and_closes_its_ellipse() {
    let e = 0.6;
    let start = [1.0 - e, 0.0, 0.0, f64::sqrt((1.0 + e) / (1.0 - e))];
    let drift = |y: &[f64; 4]| {
        let energy = 0.5 * (y[2] * y[2] + y[3] * y[3]) - 1.0 / (y[0] * y[0] + y[1] * y[1]).sqrt();
        let momentum = y[0] * y[3] - y[1] * y[2];
        // Unit semi-major axis: energy −1/2, momentum √(1 − e²).
        (energy + 0.5).abs().max((momentum - f64::sqrt(1.0 - e * e)).abs())
    };
    let out = by_order_eight(start, 2.0 * std::f64::consts::PI, 1e-12, kepler, drift);
    for d in 0..4 {
        assert!((out.end[d] - start[d]).abs() < 1e-9, "{out:?}");
    }
    assert!(out.worst < DRIFT, "{out:?}");
}

#[test]
fn at_tight_tolerance_a_swing_costs_less_than_by_order_five_and_ends_nearer() {
    for amplitude in [0.5, 2.0, 3.0] {
        let start = [amplitude, 0.0];
        let drift = |y: &[f64; 2]| (energy(y) - energy(&start)).abs();
        let miss = |out: &Outcome<2>| (out.end[0] - amplitude).abs().max(out.end[1].abs());
        let five = by_order_five(start, period(amplitude), TIGHT, swing, drift);
        let eight = by_order_eight(start, period(amplitude), TIGHT, swing, drift);
        // Dense output and refused trials included on both sides.
        assert!(3 * eight.evaluations < 2 * five.evaluations, "{amplitude}: {five:?} {eight:?}");
        assert!(4 * eight.steps < five.steps, "{amplitude}: {five:?} {eight:?}");
        assert!(miss(&eight) < miss(&five), "{amplitude}: {five:?} {eight:?}");
        assert!(eight.worst < 1e-9, "inside the steps too: {amplitude}: {eight:?}");
    }
}
