//! Which of the quantities that vary decides.
//!
//! Source: I. M. Sobol', Mathematics and Computers in Simulation 55 (2001) 271, for the indices; M. J. W. Jansen, Computer Physics
//! Communications 117 (1999) 35, for the estimators.

use super::Plan;
use carom_num::sobol::{MOST_DIMENSIONS, Sobol};
use rayon::prelude::*;

/// How much one quantity has to do with whether a drop ends as wanted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensitivity {
    /// Share of the variance that this quantity explains by itself, 0 to 1 but for the error of sampling.
    pub first: f64,
    /// Share of the variance that is left when all others are known: its own part and what it does together with others.
    pub total: f64,
}

/// Does a drop end as wanted at two points, and at the first with one coordinate of the second?
struct Asked {
    a: bool,
    b: bool,
    mixed: Vec<bool>,
}

/// Sobol's indices of whether a drop ends as wanted, a pair for each quantity; `None` where all sampled drops end alike, or twice the
/// quantities are more than there are dimensions for.
///
/// Takes `samples` × (dimensions + 2) drops; `good` says whether the drop at a point of the unit cube ends as wanted.
pub fn sensitivity(
    plan: &Plan,
    samples: u64,
    good: impl Fn(&[f64]) -> bool + Sync,
) -> Option<Vec<Sensitivity>> {
    let dimensions = plan.dimensions;
    if 2 * dimensions > MOST_DIMENSIONS || dimensions == 0 {
        return None;
    }
    let sobol = Sobol::new(2 * dimensions, plan.seed ^ 0x5e75_1717)?;
    let samples = samples.next_power_of_two();
    let asked: Vec<Asked> = (0..samples)
        .into_par_iter()
        .map(|number| {
            let both = sobol.point(number);
            let (a, b) = both.split_at(dimensions);
            let mixed = |i: usize| {
                let mut point = a.to_vec();
                point[i] = b[i];
                good(&point)
            };
            Asked { a: good(a), b: good(b), mixed: (0..dimensions).map(mixed).collect() }
        })
        .collect();
    let n = samples as f64;
    let share = asked.iter().map(|one| f64::from(u8::from(one.a) + u8::from(one.b))).sum::<f64>() / (2.0 * n);
    let variance = share * (1.0 - share);
    if variance == 0.0 {
        return None;
    }
    let differ = |pair: &dyn Fn(&Asked) -> bool| {
        asked.iter().filter(|one| pair(one)).count() as f64 / (2.0 * n * variance)
    };
    let of = |i: usize| Sensitivity {
        first: 1.0 - differ(&|one| one.b != one.mixed[i]),
        total: differ(&|one| one.a != one.mixed[i]),
    };
    Some((0..dimensions).map(of).collect())
}
