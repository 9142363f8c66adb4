//! Which of the quantities that vary decides.
//!
//! Source: I. M. Sobol', Mathematics and Computers in Simulation 55 (2001) 271, for the indices; M. J. W. Jansen, Computer Physics
//! Communications 117 (1999) 35, for the estimators.

use super::portion::Whose;
use super::{Plan, Points};
use crate::packed::{Packed, packed};
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
    /// A share of the work that there is not.
    #[error("portion {number} of {of}: they are numbered from 0")]
    Portion {
        /// Its number.
        number: u32,
        /// Of how many.
        of: u32,
    },
    /// Numbers that no [`Contrasts`] gave.
    #[error("these numbers are no portion of a study of what decides")]
    Unread,
    /// Portions of different studies, or not all of one.
    #[error("these are not all portions of one study of what decides, each once")]
    Portions,
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
    Sensitivity::of(vec![Contrasts::counted(plan, samples, (0, 1), good)?])
}

/// One portion of the drops that [`sensitivity`] asks for: how many differ by what. As whole numbers they can be sent to where all portions
/// are put together.
///
/// # Example
/// Two machines ask half of the drops each.
/// ```
/// use carom_study::yields::{Contrasts, Plan, Points, Sensitivity, sensitivity};
/// let plan = Plan { dimensions: 2, samples: 4, seed: 1, points: Points::Sobol, plates: 1, plate: 0 };
/// let good = |u: &[f64]| u[0] + 0.5 * u[1] < 0.7;
/// let sent = Contrasts::counted(&plan, 64, (0, 2), good)?.to_words();
/// let own = Contrasts::counted(&plan, 64, (1, 2), good)?;
/// let found = Sensitivity::of(vec![own, Contrasts::of_words(&sent)?])?;
/// assert_eq!(found, sensitivity(&plan, 64, good)?);
/// # Ok::<(), carom_study::yields::NoIndices>(())
/// ```
#[derive(Clone, Debug)]
pub struct Contrasts {
    whose: Whose,
    /// Scramble by scramble.
    all: Vec<Counts>,
}

packed!(Counts { good, differ });
packed!(Contrasts { whose, all });

impl Contrasts {
    /// Asks a portion of the drops: `number` of `of` portions, from 0. All else as in [`sensitivity`].
    ///
    /// # Errors
    /// [`NoIndices`]: too many quantities, a number that is not below `of`.
    pub fn counted(
        plan: &Plan,
        samples: u64,
        (number, of): (u32, u32),
        good: impl Fn(&[f64]) -> bool + Sync,
    ) -> Result<Self, NoIndices> {
        Self::check(plan)?;
        if number >= of {
            return Err(NoIndices::Portion { number, of });
        }
        let whose = Whose { plan: *plan, samples: rounded(samples), number, of };
        let all = (0..SCRAMBLES).map(|scramble| Counts::counted(&whose, scramble, &good)).collect();
        Ok(Self { whose, all })
    }

    /// Whether the quantities of a plan can be told apart.
    ///
    /// # Errors
    /// [`NoIndices::Dimensions`]: none varies, or too many.
    pub fn check(plan: &Plan) -> Result<(), NoIndices> {
        let found = plan.dimensions;
        let few = (1..=MOST_DIMENSIONS / 2).contains(&found);
        if few { Ok(()) } else { Err(NoIndices::Dimensions { found }) }
    }

    /// How many drops of all portions together are asked for.
    pub fn drops(plan: &Plan, samples: u64) -> u64 {
        rounded(samples) * SCRAMBLES * (plan.dimensions as u64 + 2)
    }

    /// The counts as whole numbers.
    pub fn to_words(&self) -> Vec<u64> {
        self.sealed()
    }

    /// The counts that [`Contrasts::to_words`] gave.
    ///
    /// # Errors
    /// [`NoIndices::Unread`]: numbers that are no portion.
    pub fn of_words(words: &[u64]) -> Result<Self, NoIndices> {
        let read = Self::unsealed(words).filter(|portion| {
            let Whose { plan, number, of, .. } = portion.whose;
            let dimensions = |counts: &Counts| counts.differ.len() == plan.dimensions;
            portion.all.len() as u64 == SCRAMBLES && portion.all.iter().all(dimensions) && number < of
        });
        read.ok_or(NoIndices::Unread)
    }
}

/// Samples of a scramble, as they are taken.
fn rounded(samples: u64) -> u64 {
    samples.div_ceil(SCRAMBLES).next_power_of_two()
}

impl Sensitivity {
    /// What all portions of a study say together: a pair of indices for each quantity.
    ///
    /// # Errors
    /// [`NoIndices`]: nothing to explain; portions of different studies, one twice, or not all of them.
    pub fn of(mut portions: Vec<Contrasts>) -> Result<Vec<Self>, NoIndices> {
        if !Whose::order(&mut portions, |portion| &portion.whose) {
            return Err(NoIndices::Portions);
        }
        let Whose { plan, samples, .. } = portions[0].whose;
        let mut all = vec![Counts::none(plan.dimensions); SCRAMBLES as usize];
        for portion in &portions {
            all.iter_mut().zip(&portion.all).for_each(|(whole, more)| whole.take(more));
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
        let of = |(i, [first, total]): (usize, &[f64; 2])| Self {
            first: *first,
            first_error: error(i, 0),
            total: *total,
            total_error: if *total == 0.0 { none_seen } else { error(i, 1) },
        };
        Ok(whole.iter().enumerate().map(of).collect())
    }
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
    fn none(dimensions: usize) -> Self {
        Self { good: 0, differ: vec![[0; 2]; dimensions] }
    }

    /// A portion's drops of one scramble.
    fn counted(whose: &Whose, scramble: u64, good: &(dyn Fn(&[f64]) -> bool + Sync)) -> Self {
        let Plan { dimensions, seed, points, .. } = whose.plan;
        let seed = (seed ^ 0x5e75_1717).wrapping_mul(SCRAMBLES).wrapping_add(scramble);
        let none = Self::none(dimensions);
        let Some(sobol) = Sobol::new(2 * dimensions, seed) else { return none };
        let both = |number: u64| match points {
            Points::Sobol => sobol.point(number),
            Points::Random => (0..2 * dimensions).map(|d| random(seed, number, d)).collect(),
        };
        let one = |number: u64| Self::of(&Asked::of(&both(number), good));
        let together = |mut a: Self, b: Self| {
            a.take(&b);
            a
        };
        // Sums of whole numbers: their order does not matter.
        whose.share(whose.samples).into_par_iter().panic_fuse().map(one).reduce(|| none.clone(), together)
    }

    fn of(asked: &Asked) -> Self {
        let differ =
            asked.mixed.iter().map(|mixed| [u64::from(asked.b != *mixed), u64::from(asked.a != *mixed)]);
        Self { good: u64::from(asked.a) + u64::from(asked.b), differ: differ.collect() }
    }

    fn take(&mut self, more: &Self) {
        self.good += more.good;
        for (own, more) in self.differ.iter_mut().zip(&more.differ) {
            own[0] += more[0];
            own[1] += more[1];
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
