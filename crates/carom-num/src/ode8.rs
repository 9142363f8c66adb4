//! An explicit Runge–Kutta step with dense output: order 8(5,3) of Dormand and Prince, dense output of order 7 (DOP853).
//!
//! [`step`] makes the whole step, dense output included, as [`crate::ode::step`] does with order 5.
//! A step that may be refused, or of which only the end counts, is a [`Trial`] from [`step_plain`]: it costs 11 evaluations, and
//! [`Trial::with_dense`] makes a [`Step`] of it for 4 more.
//!
//! Source: Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations I*, 2nd ed., II.5 and II.6; error estimate and coefficients as in
//! their code DOP853.

mod coefficients;
#[cfg(test)]
mod tests;
mod through;

use coefficients::{DENSE, DENSE_STAGES, END, FIFTH, STAGES, THIRD, Weights};

/// Evaluations of the right-hand side in a [`step_plain`], its first stage given.
///
/// # Example
/// ```
/// use carom_num::ode8::{EVALUATIONS_PLAIN, step_plain};
/// let mut count = 0;
/// step_plain([1.0], [-1.0], 0.1, |y| {
///     count += 1;
///     [-y[0]]
/// });
/// assert_eq!(count, EVALUATIONS_PLAIN);
/// ```
pub const EVALUATIONS_PLAIN: u64 = 11;
/// Evaluations that [`Trial::with_dense`] adds: the derivative at the end and the three stages of the dense output.
///
/// # Example
/// ```
/// use carom_num::ode8::{EVALUATIONS_DENSE, step_plain};
/// let trial = step_plain([1.0], [-1.0], 0.1, |y| [-y[0]]);
/// // The derivative at the end is the first of them.
/// let mut count = 1;
/// trial.with_dense([-trial.end[0]], |y| {
///     count += 1;
///     [-y[0]]
/// });
/// assert_eq!(count, EVALUATIONS_DENSE);
/// ```
pub const EVALUATIONS_DENSE: u64 = 4;
/// Evaluations in a whole [`step`].
///
/// # Example
/// ```
/// use carom_num::ode8::{EVALUATIONS, step};
/// let mut count = 0;
/// step([1.0], [-1.0], 0.1, |y| {
///     count += 1;
///     [-y[0]]
/// });
/// assert_eq!(count, EVALUATIONS);
/// ```
pub const EVALUATIONS: u64 = EVALUATIONS_PLAIN + EVALUATIONS_DENSE;

/// The state of a system of equations: an array of numbers, or an array of such arrays (one for each body, say).
///
/// # Example
/// Three bodies with two numbers each are a vector of six.
/// ```
/// use carom_num::ode8::Vector;
/// let bodies = <[[f64; 2]; 3]>::from_fn(|i| [0.0, 0.1, 1.0, 1.1, 2.0, 2.1][i]);
/// assert_eq!((bodies[2], bodies.at(5)), ([2.0, 2.1], 2.1));
/// ```
pub trait Vector: Copy {
    /// How many numbers it holds.
    ///
    /// # Example
    /// ```
    /// use carom_num::ode8::Vector;
    /// assert_eq!((<[f64; 6]>::COUNT, <[[f64; 2]; 3]>::COUNT), (6, 2 * 3));
    /// ```
    const COUNT: usize;
    /// A vector of its numbers, counted from 0.
    ///
    /// # Example
    /// ```
    /// use carom_num::ode8::Vector;
    /// assert_eq!(<[f64; 3]>::from_fn(|i| [2.0, 3.0, 5.0][i]), [2.0, 3.0, 5.0]);
    /// ```
    fn from_fn(number: impl FnMut(usize) -> f64) -> Self;
    /// Its number `i`, counted from 0.
    ///
    /// # Example
    /// ```
    /// use carom_num::ode8::Vector;
    /// assert_eq!([[2.0, 3.0], [5.0, 7.0]].at(2), 5.0);
    /// ```
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
///
/// # Example
/// Without an estimate of order 3, that of order 5 counts alone: 3 in tolerances of 2.
/// ```
/// use carom_num::ode8::Estimates;
/// assert_eq!(Estimates { fifth: [3.0], third: [0.0] }.scaled(&[2.0]), 1.5);
/// ```
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
    ///
    /// # Example
    /// 9/√(9 + 0.01 · 1600) = 9/5.
    /// ```
    /// use carom_num::ode8::Estimates;
    /// assert_eq!(Estimates { fifth: [3.0], third: [40.0] }.scaled(&[1.0]), 1.8);
    /// ```
    pub fn scaled(&self, tolerance: &V) -> f64 {
        let squares = |estimate: &V| -> f64 {
            let scaled = |i: usize| estimate.at(i) / tolerance.at(i);
            (0..V::COUNT).map(|i| scaled(i) * scaled(i)).sum()
        };
        let fifth = squares(&self.fifth);
        let both = fifth + 0.01 * squares(&self.third);
        #[expect(clippy::cast_precision_loss, reason = "a handful")]
        let all = V::COUNT as f64 * both;
        // A NaN must come out as it is, and a sum that overflows must not divide a finite one to zero: such steps are refused.
        if both == 0.0 {
            0.0
        } else if all == f64::INFINITY {
            all
        } else {
            fifth / all.sqrt()
        }
    }
}

/// A step of an autonomous system without its dense output and the derivative at its end.
///
/// # Example
/// Free fall from 20 m at 10 m/s²: after 2 s the height is 0 and the speed 20 m/s.
/// ```
/// use carom_num::ode8::{Trial, step_plain};
/// let fall: Trial<[f64; 2]> = step_plain([20.0, 0.0], [0.0, -10.0], 2.0, |y| [y[1], -10.0]);
/// // The stages have weights of about 50: rounding is that much larger.
/// assert!(fall.end[0].abs() < 1e-12 && (fall.end[1] + 20.0).abs() < 1e-12);
/// ```
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
///
/// # Example
/// Free fall from 20 m at 10 m/s²: after 1 s of 2 s the height is 15 m, and the speed 10 m/s.
/// ```
/// use carom_num::ode8::{Step, step};
/// let fall: Step<[f64; 2]> = step([20.0, 0.0], [0.0, -10.0], 2.0, |y| [y[1], -10.0]);
/// let [height, speed] = fall.at(0.5);
/// // The dense output has weights of about 500: rounding is that much larger.
/// assert!((height - 15.0).abs() < 1e-11 && (speed + 10.0).abs() < 1e-11);
/// ```
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
///
/// # Example
/// A quarter of an oscillation, in four steps, takes (0, 1) to (1, 0).
/// ```
/// use carom_num::ode8::step;
/// let f = |y: &[f64; 2]| [y[1], -y[0]];
/// let h = std::f64::consts::FRAC_PI_8;
/// let [x, v] = (0..4).fold([0.0, 1.0], |y, _| step(y, f(&y), h, f).end);
/// // An error of order 8 leaves about h⁹/9! in each step.
/// assert!((x - 1.0).abs() < 4.0 * h.powi(9) / 362_880.0 && v.abs() < 4.0 * h.powi(9) / 362_880.0);
/// ```
pub fn step<V: Vector>(start: V, rate: V, length: f64, mut f: impl FnMut(&V) -> V) -> Step<V> {
    let trial = step_plain(start, rate, length, &mut f);
    trial.with_dense(f(&trial.end), f)
}

/// Tries a step of `length` from `start`, whose derivative is `rate`, as far as its end and the error there.
///
/// # Example
/// A step of 1 for y′ = −y: the error of order 8 is about 1/9!.
/// ```
/// let trial = carom_num::ode8::step_plain([1.0], [-1.0], 1.0, |y| [-y[0]]);
/// assert!((trial.end[0] - (-1_f64).exp()).abs() < 1.0 / 362_880.0);
/// ```
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
    ///
    /// # Example
    /// ```
    /// use carom_num::ode8::step_plain;
    /// let f = |y: &[f64; 2]| [1.0, 2.0 * y[0]];
    /// let trial = step_plain([0.0, 0.0], [1.0, 0.0], 1.0, f);
    /// let [t, square] = trial.with_dense(f(&trial.end), f).at(0.5);
    /// // The dense output has weights of about 500: rounding is that much larger.
    /// assert!((t - 0.5).abs() < 1e-12 && (square - 0.25).abs() < 1e-12);
    /// ```
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
    ///
    /// # Example
    /// ```
    /// use carom_num::ode8::{Estimates, step_plain};
    /// let mut trial = step_plain([0.0], [1.0], 1.0, |_| [1.0]);
    /// trial.error = Estimates { fifth: [3.0], third: [40.0] };
    /// assert_eq!(trial.scaled_error(&[1.0]), 9.0 / 5.0);
    /// ```
    pub fn scaled_error(&self, tolerance: &V) -> f64 {
        self.error.scaled(tolerance)
    }
}

impl<V: Vector> Step<V> {
    /// A step whose two ends are known: the cubic with these states and derivatives there, exact where every component is a cubic.
    ///
    /// # Example
    /// t³ from 0 to 2, whose rate is 3 t²: at the middle it is 1.
    /// ```
    /// let cube = carom_num::ode8::Step::between(([0.0], [0.0]), ([8.0], [12.0]), 2.0);
    /// assert_eq!(cube.at(0.5), [1.0]);
    /// ```
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
    ///
    /// # Example
    /// y′ = 7 t⁶ from zero is t⁷, the highest power that is met exactly.
    /// ```
    /// use carom_num::ode8::step;
    /// let [t, seventh] = step([0.0, 0.0], [1.0, 0.0], 1.0, |y| [1.0, 7.0 * y[0].powi(6)]).at(0.5);
    /// // The dense output has weights of about 500: rounding is that much larger.
    /// assert!((t - 0.5).abs() < 1e-12 && (seventh - 1.0 / 128.0).abs() < 1e-12);
    /// ```
    pub fn at(&self, x: f64) -> V {
        let z = 1.0 - x;
        V::from_fn(|i| {
            let [a, b, c, e, g, h] = std::array::from_fn(|term| self.dense[term].at(i));
            let (start, rise) = (self.start.at(i), self.end.at(i) - self.start.at(i));
            start + x * (rise + z * (a + x * (b + z * (c + x * (e + z * (g + x * h))))))
        })
    }

    /// [`Estimates::scaled`] of this step.
    ///
    /// # Example
    /// A cubic that is known has no error.
    /// ```
    /// let mut step = carom_num::ode8::Step::between(([0.0], [0.0]), ([8.0], [12.0]), 2.0);
    /// assert_eq!(step.scaled_error(&[1.0]), 0.0);
    /// step.error.fifth = [3.0];
    /// assert_eq!(step.scaled_error(&[1.0]), 3.0);
    /// ```
    pub fn scaled_error(&self, tolerance: &V) -> f64 {
        self.error.scaled(tolerance)
    }
}

/// Factor on the step length after a step with this scaled error: order 8, kept within [0.2, 5].
///
/// The bounds are met where the error is no longer its leading term, and its eighth root no longer a forecast: above 4.35⁸ ≈ 1.3·10⁵ the step is
/// beyond the reach of its series, and below (0.87/5)⁸ ≈ 10⁻⁶ what is seen at this length says little of one five times as long.
///
/// # Example
/// An error of 2⁸ tolerances asks for half the length, times 0.87 for safety.
/// ```
/// use carom_num::ode8::length_factor;
/// assert_eq!((length_factor(0.0), length_factor(1.0), length_factor(1e30)), (5.0, 0.87, 0.2));
/// assert!((length_factor(256.0) - 0.435).abs() <= f64::EPSILON);
/// ```
pub fn length_factor(scaled_error: f64) -> f64 {
    if scaled_error <= 0.0 {
        5.0
    } else {
        (0.87 * crate::elementary::pow(scaled_error, -0.125)).clamp(0.2, 5.0)
    }
}
