//! Random numbers of a case.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// Most numbers of a case.
const MOST: usize = 16;

/// Independent numbers in [0, 1), the same whenever the case is the same.
pub(crate) fn numbers(case: u32) -> impl Fn(usize) -> f64 {
    let mut rng = Pcg64::seed_from_u64(u64::from(case));
    let numbers: [f64; MOST] = std::array::from_fn(|_| rng.random_range(0.0..1.0));
    move |k| numbers[k]
}
