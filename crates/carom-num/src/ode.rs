//! An explicit Runge–Kutta step with dense output: order 5(4) of Dormand and Prince (1980), dense output of order 4 by Shampine.
//!
//! Source: Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations I*, 2nd ed., II.5 and II.6.

/// One accepted or tried step of an autonomous system of D equations.
///
/// # Example
/// Free fall from 20 m at 10 m/s²: after 2 s the height is 0 and the speed 20 m/s.
/// ```
/// use carom_num::ode::{Step, step};
/// let fall: Step<2> = step([20.0, 0.0], [0.0, -10.0], 2.0, |y| [y[1], -10.0]);
/// // The stages have weights of about ten: rounding is that much larger.
/// assert!(fall.end[0].abs() < 1e-13 && (fall.end[1] + 20.0).abs() < 1e-13);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Step<const D: usize> {
    /// Length of the step.
    pub length: f64,
    /// State at its start.
    pub start: [f64; D],
    /// State at its end.
    pub end: [f64; D],
    /// Derivative at its end: the first stage of the next step.
    pub end_rate: [f64; D],
    /// Difference of the two embedded solutions.
    pub error: [f64; D],
    dense: [[f64; D]; 3],
}

const A: [&[f64]; 6] = [
    &[1.0 / 5.0],
    &[3.0 / 40.0, 9.0 / 40.0],
    &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
    &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
    &[9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0],
    &[35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];
const E: [f64; 7] =
    [71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339_200.0, 22.0 / 525.0, -1.0 / 40.0];
const DENSE: [f64; 7] = [
    -12_715_105_075.0 / 11_282_082_432.0,
    0.0,
    87_487_479_700.0 / 32_700_410_799.0,
    -10_690_763_975.0 / 1_880_347_072.0,
    701_980_252_875.0 / 199_316_789_632.0,
    -1_453_857_185.0 / 822_651_844.0,
    69_997_945.0 / 29_380_423.0,
];

/// Evaluations of the right-hand side that one step costs, its first stage given.
///
/// # Example
/// ```
/// use carom_num::ode::{EVALUATIONS, step};
/// let mut count = 0;
/// step([1.0], [-1.0], 0.1, |y| {
///     count += 1;
///     [-y[0]]
/// });
/// assert_eq!(count, EVALUATIONS);
/// ```
pub const EVALUATIONS: u64 = 6;

/// Tries one step of `length` from `start`, whose derivative is `rate`.
///
/// # Example
/// A step of 0.1 for y′ = −y: the error of order 5 is about 0.1⁶/720.
/// ```
/// let step = carom_num::ode::step([1.0], [-1.0], 0.1, |y| [-y[0]]);
/// assert!((step.end[0] - (-0.1_f64).exp()).abs() < 0.1_f64.powi(6) / 720.0);
/// ```
pub fn step<const D: usize>(
    start: [f64; D],
    rate: [f64; D],
    length: f64,
    mut f: impl FnMut(&[f64; D]) -> [f64; D],
) -> Step<D> {
    let mut k = [[0.0; D]; 7];
    k[0] = rate;
    let mut y = start;
    for (stage, row) in A.iter().enumerate() {
        for d in 0..D {
            let mut sum = 0.0;
            for (a, k) in row.iter().zip(&k) {
                sum += a * k[d];
            }
            y[d] = start[d] + length * sum;
        }
        k[stage + 1] = f(&y);
    }
    let combine = |weights: &[f64; 7], d: usize| weights.iter().zip(&k).map(|(w, k)| w * k[d]).sum::<f64>();
    // The last stage is the end itself: its rate serves the dense output, and the next step as its first.
    let mut out = Step { length, start, end: y, end_rate: k[6], error: [0.0; D], dense: [[0.0; D]; 3] };
    for d in 0..D {
        out.error[d] = length * combine(&E, d);
        let rise = y[d] - start[d];
        let bend = length * k[0][d] - rise;
        out.dense[0][d] = bend;
        out.dense[1][d] = rise - length * k[6][d] - bend;
        out.dense[2][d] = length * combine(&DENSE, d);
    }
    out
}

impl<const D: usize> Step<D> {
    /// State at the fraction `x` in [0, 1] of the step, to order 4.
    ///
    /// # Example
    /// Free fall from 20 m at 10 m/s²: at half of 2 s it has fallen 5 m.
    /// ```
    /// let fall = carom_num::ode::step([20.0, 0.0], [0.0, -10.0], 2.0, |y| [y[1], -10.0]);
    /// let [height, speed] = fall.at(0.5);
    /// assert!((height - 15.0).abs() < 1e-13 && (speed + 10.0).abs() < 1e-13);
    /// ```
    pub fn at(&self, x: f64) -> [f64; D] {
        let z = 1.0 - x;
        std::array::from_fn(|d| {
            let [bend, twist, last] = [self.dense[0][d], self.dense[1][d], self.dense[2][d]];
            self.start[d] + x * (self.end[d] - self.start[d] + z * (bend + x * (twist + z * last)))
        })
    }

    /// Root mean square of the error, each component divided by its tolerance.
    ///
    /// # Example
    /// Errors of 3 and 4 tolerances: √((9 + 16)/2).
    /// ```
    /// let mut step = carom_num::ode::step([0.0; 2], [1.0; 2], 1.0, |_| [1.0; 2]);
    /// step.error = [0.75, 2.0];
    /// assert_eq!(step.scaled_error(&[0.25, 0.5]), 12.5_f64.sqrt());
    /// ```
    pub fn scaled_error(&self, tolerance: &[f64; D]) -> f64 {
        let sum: f64 = self.error.iter().zip(tolerance).map(|(e, t)| (e / t) * (e / t)).sum();
        #[expect(clippy::cast_precision_loss, reason = "D is a handful")]
        let count = D as f64;
        (sum / count).sqrt()
    }
}

/// Factor on the step length after a step with this scaled error: order 5, kept within [0.2, 5].
///
/// # Example
/// An error of 2⁵ tolerances asks for half the length, times 0.9 for safety.
/// ```
/// use carom_num::ode::length_factor;
/// assert_eq!((length_factor(0.0), length_factor(1.0), length_factor(1e30)), (5.0, 0.9, 0.2));
/// assert!((length_factor(32.0) - 0.45).abs() <= f64::EPSILON);
/// ```
pub fn length_factor(scaled_error: f64) -> f64 {
    if scaled_error <= 0.0 { 5.0 } else { (0.9 * crate::elementary::pow(scaled_error, -0.2)).clamp(0.2, 5.0) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::elementary::{cos, sin};

    fn oscillate(length: f64) -> Step<2> {
        step([0.0, 1.0], [1.0, 0.0], length, |y| [y[1], -y[0]])
    }

    #[test]
    fn the_step_is_of_order_five_and_its_dense_output_of_order_four() {
        let end_error = |h: f64| (oscillate(h).end[0] - sin(h)).abs();
        let dense_error = |h: f64| (oscillate(h).at(0.3)[0] - sin(0.3 * h)).abs();
        // Local errors: halving the step divides them by 2⁶ and 2⁵ at least.
        assert!(end_error(0.2) / end_error(0.1) > 55.0, "{} {}", end_error(0.2), end_error(0.1));
        assert!(dense_error(0.2) / dense_error(0.1) > 29.0, "{} {}", dense_error(0.2), dense_error(0.1));
    }

    #[test]
    fn the_last_stage_is_the_next_step_s_first() {
        let s = oscillate(0.1);
        assert_eq!(s.end_rate, [s.end[1], -s.end[0]]);
        assert!((s.end[1] - cos(0.1)).abs() < 1e-9, "{:?}", s.end);
    }
}
