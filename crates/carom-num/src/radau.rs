//! One implicit step of order 9 for equations that are stiff, or that cannot be evaluated at the start of a step: Radau IIA with five stages.
//!
//! The stages satisfy `kᵢ = f(y + h Σⱼ aᵢⱼ kⱼ)`; they are found by Newton's method with derivatives of f by differences, which are kept as long as they bring it nearer fast. Only those
//! with respect to components that make the equations stiff are taken: the others come to rest by themselves. The last stage is the end of the step.
//!
//! Source: Hairer, Wanner, *Solving Ordinary Differential Equations II*, 2nd ed., IV.5 and IV.8.

use crate::solve::Factored;
use crate::tolerance::{RADAU_ARRIVED, RADAU_RANK};
use std::sync::LazyLock;

/// Where the stages are, as fractions of the step: the zeros of `P₄ − P₅` on [0, 1].
///
/// # Example
/// `d⁴/dx⁴ (x⁴ (x − 1)⁵)` vanishes there: the sum of its zeros is 5²/9.
/// ```
/// assert!((carom_num::radau::NODES.iter().sum::<f64>() - 25.0 / 9.0).abs() < 2.0 * f64::EPSILON);
/// ```
pub const NODES: [f64; STAGES] = [
    0.057_104_196_114_517_68,
    0.276_843_013_638_123_8,
    0.583_590_432_368_916_8,
    0.860_240_135_656_219_4,
    1.0,
];
/// How many stages there are.
///
/// # Example
/// With s stages, polynomials up to the degree 2s − 2 are integrated exactly, here x⁸.
/// ```
/// use carom_num::radau::{NODES, STAGES, weights};
/// let degree = 2 * STAGES as i32 - 2;
/// let sum: f64 = weights()[STAGES - 1].iter().zip(NODES).map(|(b, c)| b * c.powi(degree)).sum();
/// assert!((sum - 1.0 / 9.0).abs() < 2.0 * f64::EPSILON);
/// ```
pub const STAGES: usize = 5;
/// Steps of Newton's method.
const MOST_STEPS: u32 = 16;
/// Derivatives are kept for its next step where this one moved the stages by no more than this fraction of the one before.
const KEPT: f64 = 0.1;

/// What a step is made with.
///
/// # Example
/// A step of 3 for y′ = 2 t, t′ = 1: the end is t².
/// ```
/// use carom_num::radau::{STAGES, Setup, step};
/// let rate = |y: &[f64; 2]| [1.0, 2.0 * y[0]];
/// let setup = Setup { rate, difference: |_: &[f64; 2]| [1e-3; 2], stiff: [0, 1] };
/// let stages = step::<2, 2, 10>(&[0.0; 2], &[[1.0, 0.0]; STAGES], 3.0, &[1e-13; 2], &setup).unwrap();
/// assert!((stages[STAGES - 1][1] - 9.0).abs() < 1e-13);
/// ```
pub struct Setup<F, S, const C: usize> {
    /// The right-hand side.
    pub rate: F,
    /// By how much each component may be moved to see how the right-hand side changes with it.
    pub difference: S,
    /// The components that make the equations stiff; all of them where that is not known.
    pub stiff: [usize; C],
}

/// The states at the stages.
///
/// # Example
/// Where the rate is 1 the states are the places of the stages.
/// ```
/// use carom_num::radau::{NODES, STAGES, Setup, Stages, step};
/// let setup = Setup { rate: |_: &[f64; 1]| [1.0], difference: |_: &[f64; 1]| [1e-3], stiff: [0] };
/// let stages: Stages<1> = step::<1, 1, 5>(&[0.0], &[[1.0]; STAGES], 1.0, &[1e-14], &setup).unwrap();
/// assert!(stages.iter().zip(NODES).all(|([y], node)| (y - node).abs() < 4.0 * f64::EPSILON));
/// ```
pub type Stages<const D: usize> = [[f64; D]; STAGES];

/// The weights `aᵢⱼ`: integrals of the Lagrange polynomials of the nodes from 0 to each node, by Gauss's rule with three points, which is exact for them.
///
/// # Example
/// A rate of 1 carries as far as the node: `Σⱼ aᵢⱼ = cᵢ`.
/// ```
/// use carom_num::radau::{NODES, weights};
/// let sums = weights().map(|row| row.iter().sum::<f64>());
/// assert!(sums.iter().zip(NODES).all(|(sum, node)| (sum - node).abs() < 4.0 * f64::EPSILON));
/// ```
pub fn weights() -> [[f64; STAGES]; STAGES] {
    static WEIGHTS: LazyLock<[[f64; STAGES]; STAGES]> = LazyLock::new(|| {
        let lagrange = |j: usize, x: f64| {
            let others = NODES.iter().enumerate().filter(|(k, _)| *k != j);
            others.map(|(_, other)| (x - other) / (NODES[j] - other)).product::<f64>()
        };
        let off = 0.6_f64.sqrt();
        NODES.map(|node| {
            std::array::from_fn(|j| {
                let at = |z: f64| lagrange(j, 0.5 * node * (1.0 + z));
                node * (5.0 * (at(-off) + at(off)) + 8.0 * at(0.0)) / 18.0
            })
        })
    });
    *WEIGHTS
}

/// The rates with which a step of `length` from `start` has these states at its stages: a guess where they are known nearly.
///
/// # Example
/// States on the line 5 + 2 t have the rate 2.
/// ```
/// use carom_num::radau::{NODES, rates_through};
/// let rates = rates_through(&[5.0], &NODES.map(|node| [5.0 + 2.0 * node * 0.1]), 0.1).unwrap();
/// // Differences of about 0.01 between numbers of about 5, divided by weights that are no smaller.
/// assert!(rates.iter().all(|[rate]| (rate - 2.0).abs() < 1e-12));
/// ```
pub fn rates_through<const D: usize>(start: &[f64; D], states: &Stages<D>, length: f64) -> Option<Stages<D>> {
    let weights = Factored::of(weights(), STAGES, RADAU_RANK)?;
    let mut rates = [[0.0; D]; STAGES];
    for d in 0..D {
        let own = weights.solve(std::array::from_fn(|i| (states[i][d] - start[d]) / length));
        (0..STAGES).for_each(|i| rates[i][d] = own[i]);
    }
    Some(rates)
}

/// The rate with which a step starts that has these rates at its stages: where the right-hand side is not known there.
///
/// # Example
/// Rates on the line 5 + 2 x start with 5.
/// ```
/// use carom_num::radau::{NODES, rate_before};
/// let [start] = rate_before(&NODES.map(|node| [5.0 + 2.0 * node]));
/// assert!((start - 5.0).abs() < 1e-13);
/// ```
pub fn rate_before<const D: usize>(rates: &Stages<D>) -> [f64; D] {
    let share = |j: usize| {
        let others = NODES.iter().enumerate().filter(|(k, _)| *k != j);
        others.map(|(_, other)| other / (other - NODES[j])).product::<f64>()
    };
    let shares: [f64; STAGES] = std::array::from_fn(share);
    std::array::from_fn(|d| shares.iter().zip(rates).map(|(share, rate)| share * rate[d]).sum())
}

/// The states at the stages of a step of `length` from `start`, from a guess of the rates there; M must be five times the number C of stiff components. `None` where Newton's method
/// does not find them.
///
/// # Example
/// A step of 1 for y′ = −y is a Padé approximation of 1/e; its error is about 4! 5!/(9! 10!) = 2.2 · 10⁻⁹.
/// ```
/// use carom_num::radau::{STAGES, Setup, step};
/// let setup = Setup { rate: |y: &[f64; 1]| [-y[0]], difference: |_: &[f64; 1]| [1e-3], stiff: [0] };
/// let stages = step::<1, 1, 5>(&[1.0], &[[-1.0]; STAGES], 1.0, &[1e-14], &setup).unwrap();
/// let error = (stages[STAGES - 1][0] - (-1_f64).exp()).abs();
/// assert!(error < 2.2e-9);
/// ```
pub fn step<const D: usize, const C: usize, const M: usize>(
    start: &[f64; D],
    guess: &Stages<D>,
    length: f64,
    tolerance: &[f64; D],
    setup: &Setup<impl Fn(&[f64; D]) -> [f64; D], impl Fn(&[f64; D]) -> [f64; D], C>,
) -> Option<Stages<D>> {
    let (mut rates, mut at) = (*guess, states(start, guess, length));
    let mut slopes: Option<Slopes<D, C, M>> = None;
    let mut before = f64::INFINITY;
    for _ in 0..MOST_STEPS {
        let here = at.map(|y| (setup.rate)(&y));
        let fresh = slopes.is_none();
        let own = match slopes.take() {
            Some(own) => own,
            None => Slopes::at((&at, &here), length, setup)?,
        };
        let change = own.change(&here, &rates, length, setup.stiff);
        for (rate, change) in rates.iter_mut().flatten().zip(change.iter().flatten()) {
            *rate += change;
        }
        let now = states(start, &rates, length);
        if !now.iter().flatten().all(|v| v.is_finite()) {
            return None;
        }
        let moved = (0..STAGES).flat_map(|i| (0..D).map(move |d| (i, d)));
        let size = moved.fold(0.0, |m: f64, (i, d)| m.max((now[i][d] - at[i][d]).abs() / tolerance[d]));
        // Below the tolerance rounding may keep it from coming closer.
        if size <= RADAU_ARRIVED || (fresh && size <= 1.0 && size >= 0.5 * before) {
            return Some(now);
        }
        slopes = (size <= KEPT * before).then_some(own);
        (before, at) = (size, now);
    }
    None
}

/// The states of a step that has these rates at its stages.
fn states<const D: usize>(start: &[f64; D], rates: &Stages<D>, length: f64) -> Stages<D> {
    weights().map(|weights| {
        std::array::from_fn(|d| {
            let moved: f64 = weights.iter().zip(rates).map(|(a, k)| a * k[d]).sum();
            start[d] + length * moved
        })
    })
}

/// How the right-hand side changes with the stiff components, at every stage.
struct Slopes<const D: usize, const C: usize, const M: usize> {
    of: [[[f64; D]; C]; STAGES],
    /// The matrix of Newton's method for those components.
    matrix: Factored<M>,
}

impl<const D: usize, const C: usize, const M: usize> Slopes<D, C, M> {
    /// By differences from these states and the rates there; `None` where the matrix is singular.
    fn at(
        (states, rates): (&Stages<D>, &Stages<D>),
        length: f64,
        setup: &Setup<impl Fn(&[f64; D]) -> [f64; D], impl Fn(&[f64; D]) -> [f64; D], C>,
    ) -> Option<Self> {
        let (mut of, mut matrix) = ([[[0.0; D]; C]; STAGES], [[0.0; M]; M]);
        for (i, (y, here)) in states.iter().zip(rates).enumerate() {
            let increments = (setup.difference)(y);
            for (by, slope) in setup.stiff.iter().zip(&mut of[i]) {
                let mut moved = *y;
                moved[*by] += increments[*by];
                let (there, increment) = ((setup.rate)(&moved), moved[*by] - y[*by]);
                *slope = std::array::from_fn(|d| (there[d] - here[d]) / increment);
            }
        }
        for (i, weights) in weights().iter().enumerate() {
            for (k, d) in setup.stiff.iter().enumerate() {
                let row = &mut matrix[i * C + k];
                for (entry, (j, by)) in
                    row.iter_mut().zip((0..STAGES).flat_map(|j| (0..C).map(move |by| (j, by))))
                {
                    *entry = -length * weights[j] * of[i][by][*d];
                }
                row[i * C + k] += 1.0;
            }
        }
        Some(Self { of, matrix: Factored::of(matrix, M, RADAU_RANK)? })
    }

    /// What Newton's method adds to rates, where the right-hand side has others at the states that they lead to.
    fn change(&self, there: &Stages<D>, rates: &Stages<D>, length: f64, stiff: [usize; C]) -> Stages<D> {
        let mut change: Stages<D> =
            std::array::from_fn(|i| std::array::from_fn(|d| there[i][d] - rates[i][d]));
        let right = std::array::from_fn(|k| change[k / C][stiff[k % C]]);
        let own = self.matrix.solve(right);
        for (i, weights) in weights().iter().enumerate() {
            for (by, slope) in self.of[i].iter().enumerate() {
                let moved: f64 = (0..STAGES).map(|j| weights[j] * own[j * C + by]).sum();
                change[i].iter_mut().zip(slope).for_each(|(change, slope)| *change += length * moved * slope);
            }
        }
        change
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::elementary::{cos, sin};

    #[test]
    fn the_last_weights_integrate_polynomials_of_degree_8() {
        let last = weights()[STAGES - 1];
        for k in 0..9_i32 {
            let sum: f64 = last.iter().zip(NODES).map(|(b, c)| b * c.powi(k)).sum();
            assert!((sum - 1.0 / f64::from(k + 1)).abs() < 1e-15, "{k}: {sum}");
        }
    }

    #[test]
    fn a_stiff_equation_keeps_to_its_smooth_solution() {
        // y' = −10⁸ (y − cos x) − sin x has the solution cos x; x' = 1.
        let rate = |y: &[f64; 2]| [1.0, -1e8 * (y[1] - cos(y[0])) - sin(y[0])];
        let setup = Setup { rate, difference: |_: &[f64; 2]| [1e-7; 2], stiff: [1] };
        let found = step::<2, 1, 5>(&[0.0, 1.0], &[[1.0, 0.0]; STAGES], 0.2, &[1e-14; 2], &setup).unwrap();
        let [x, y] = found[STAGES - 1];
        assert!((x - 0.2).abs() < 1e-15 && (y - cos(0.2)).abs() < 1e-13, "{x} {y}");
    }
}
