//! Which of the quantities that vary decides.
//!
//! Source: I. M. Sobol', Mathematics and Computers in Simulation 55 (2001) 271, for the indices; M. J. W. Jansen, Computer Physics
//! Communications 117 (1999) 35, for the estimators.

use super::{Plan, Points};
use carom_num::sobol::{MOST_DIMENSIONS, Sobol, random};
use rayon::prelude::*;
use thiserror::Error;

/// Scrambles of their own that the indices are estimated from.
const SCRAMBLES: u64 = 8;
/// Two-sided 95 % point of Student's distribution with 7 degrees of freedom.
const STUDENT: f64 = 2.364_624_251_592_785;

/// How much one quantity has to do with whether a drop ends as wanted.
///
/// # Example
/// Where the first quantity decides alone, it explains all of the variance, and the second one nothing.
/// ```
/// use carom_study::yields::{Plan, Points, sensitivity};
/// let plan = Plan { dimensions: 2, samples: 4, seed: 1, points: Points::Sobol, plates: 1, plate: 0 };
/// let found = sensitivity(&plan, 64, |u| u[0] < 0.5).unwrap();
/// assert_eq!((found[0].first, found[0].total), (1.0, 1.0));
/// assert_eq!(found[1].total, 0.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensitivity {
    /// Share of the variance that this quantity explains by itself, 0 to 1 but for the error of sampling: it may come out below zero.
    pub first: f64,
    /// Half of its 95 % interval.
    pub first_error: f64,
    /// Share of the variance that is left when all others are known: its own part and what it does together with others.
    pub total: f64,
    /// Half of its 95 % interval.
    pub total_error: f64,
}

/// Why there are no indices.
///
/// # Example
/// Where every drop ends as wanted, nothing decides.
/// ```
/// use carom_study::yields::{NoIndices, Plan, Points, sensitivity};
/// let plan = Plan { dimensions: 2, samples: 4, seed: 1, points: Points::Sobol, plates: 1, plate: 0 };
/// assert_eq!(sensitivity(&plan, 64, |_| true), Err(NoIndices::Alike));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum NoIndices {
    /// Twice the quantities are more than there are dimensions for, or nothing varies.
    #[error("{found} quantities vary: 1 to {} can be told apart", MOST_DIMENSIONS / 2)]
    Dimensions {
        /// How many.
        found: usize,
    },
    /// Without one of the scrambles nothing varies that could be explained.
    #[error("all drops that were sampled for it end alike")]
    Alike,
}

/// Does a drop end as wanted at two points, and at the first with one coordinate of the second?
struct Asked {
    a: bool,
    b: bool,
    mixed: Vec<bool>,
}

/// How many drops of a scramble differ by what.
#[derive(Clone, Debug)]
struct Counts {
    /// Good ones, of both points.
    good: u64,
    /// For each quantity: how many differ from the second point, and from the first.
    differ: Vec<[u64; 2]>,
}

/// Sobol's indices of whether a drop ends as wanted, a pair for each quantity, with Student's intervals by leaving out one scramble after
/// the other (the jackknife: R. G. Miller, Biometrika 61 (1974) 1).
///
/// Takes `samples` × (dimensions + 2) drops, `samples` rounded up to 8 times a power of two; `good` says whether the drop at a point of the
/// unit cube ends as wanted.
///
/// # Errors
/// [`NoIndices`].
///
/// # Example
/// Whether both of two quantities are in the upper half, or neither, is decided by none of them alone and by
/// both together.
/// ```
/// use carom_study::yields::{Plan, Points, sensitivity};
/// let plan = Plan { dimensions: 2, samples: 4, seed: 1, points: Points::Sobol, plates: 1, plate: 0 };
/// let found = sensitivity(&plan, 1024, |u| (u[0] < 0.5) == (u[1] < 0.5)).unwrap();
/// for quantity in found {
///     assert!(quantity.first.abs() < 0.1 && (quantity.total - 1.0).abs() < 0.1);
/// }
/// ```
pub fn sensitivity(
    plan: &Plan,
    samples: u64,
    good: impl Fn(&[f64]) -> bool + Sync,
) -> Result<Vec<Sensitivity>, NoIndices> {
    sensitivities(plan, samples, &good)
}

fn sensitivities(
    plan: &Plan,
    samples: u64,
    good: &(dyn Fn(&[f64]) -> bool + Sync),
) -> Result<Vec<Sensitivity>, NoIndices> {
    let dimensions = plan.dimensions;
    let unknown = NoIndices::Dimensions { found: dimensions };
    if 2 * dimensions > MOST_DIMENSIONS || dimensions == 0 {
        return Err(unknown);
    }
    let samples = samples.div_ceil(SCRAMBLES).next_power_of_two();
    let mut all = vec![];
    for scramble in 0..SCRAMBLES {
        let seed = (plan.seed ^ 0x5e75_1717).wrapping_mul(SCRAMBLES).wrapping_add(scramble);
        let sobol = Sobol::new(2 * dimensions, seed).ok_or(unknown)?;
        let both = |number: u64| match plan.points {
            Points::Sobol => sobol.point(number),
            Points::Random => (0..2 * dimensions).map(|d| random(seed, number, d)).collect(),
        };
        let asked: Vec<Asked> =
            (0..samples).into_par_iter().map(|number| Asked::of(&both(number), good)).collect();
        all.push(Counts::of(&asked, dimensions));
    }
    let drops = (samples * SCRAMBLES) as f64;
    let whole = indices(&all, None, drops).ok_or(NoIndices::Alike)?;
    let without: Option<Vec<_>> =
        (0..all.len()).map(|left_out| indices(&all, Some(left_out), drops - samples as f64)).collect();
    let without = without.ok_or(NoIndices::Alike)?;
    let error =
        |i: usize, which: usize| half_width(&without.iter().map(|one| one[i][which]).collect::<Vec<_>>());
    // No difference among all drops does not say that there is none: up to three in as many are likely.
    let good = all.iter().map(|one| one.good).sum::<u64>() as f64 / (2.0 * drops);
    let none_seen = 3.0 / (2.0 * drops * good * (1.0 - good));
    let of = |(i, [first, total]): (usize, &[f64; 2])| Sensitivity {
        first: *first,
        first_error: error(i, 0),
        total: *total,
        total_error: if *total == 0.0 { none_seen } else { error(i, 1) },
    };
    Ok(whole.iter().enumerate().map(of).collect())
}

impl Asked {
    fn of(both: &[f64], good: &dyn Fn(&[f64]) -> bool) -> Self {
        let (a, b) = both.split_at(both.len() / 2);
        let mixed = |i: usize| {
            let mut point = a.to_vec();
            point[i] = b[i];
            good(&point)
        };
        Self { a: good(a), b: good(b), mixed: (0..a.len()).map(mixed).collect() }
    }
}

impl Counts {
    fn of(asked: &[Asked], dimensions: usize) -> Self {
        let count = |which: &dyn Fn(&Asked) -> bool| asked.iter().filter(|one| which(one)).count() as u64;
        let differ = |i: usize| [count(&|one| one.b != one.mixed[i]), count(&|one| one.a != one.mixed[i])];
        Self {
            good: count(&|one| one.a) + count(&|one| one.b),
            differ: (0..dimensions).map(differ).collect(),
        }
    }
}

/// First and total index of every quantity, of so many drops in all scrambles but one; `None` where nothing varies.
fn indices(all: &[Counts], left_out: Option<usize>, drops: f64) -> Option<Vec<[f64; 2]>> {
    let counts = || all.iter().enumerate().filter(|(k, _)| Some(*k) != left_out).map(|(_, counts)| counts);
    let share = counts().map(|one| one.good).sum::<u64>() as f64 / (2.0 * drops);
    let variance = share * (1.0 - share);
    let differ = |i: usize, which: usize| {
        counts().map(|one| one.differ[i][which]).sum::<u64>() as f64 / (2.0 * drops * variance)
    };
    let dimensions = all.first()?.differ.len();
    (variance > 0.0).then(|| (0..dimensions).map(|i| [1.0 - differ(i, 0), differ(i, 1)]).collect())
}

/// Half of the 95 % interval, from the estimates that leave out one scramble each.
fn half_width(without: &[f64]) -> f64 {
    let n = without.len() as f64;
    let mean = without.iter().sum::<f64>() / n;
    let squares: f64 = without.iter().map(|one| (one - mean) * (one - mean)).sum();
    STUDENT * (squares * (n - 1.0) / n).sqrt()
}
