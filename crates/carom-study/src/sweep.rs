//! Sweeps: many designs, one drop each.

use crate::device::Device;
use crate::ending::Dropped;
use rayon::prelude::*;

/// Drops the part once in every one of these designs, on all cores; the answers are in the order of the designs.
///
/// `feeder` makes a feeder of a design's values, or none where what is drawn cannot be; `plate` is the number of the plate that is looked at.
///
/// # Example
/// Two designs of a slope of 3 in 4: friction of 1/2 lets a rod go, friction of 1 holds it.
/// ```
/// use carom_feeder::{Outcome, examples};
/// let slope = examples::rod_on_a_slope;
/// let designs = [vec![0.5], vec![1.0]];
/// let drops = carom_study::sweep::drops(&designs, 0, |values| Some(slope(values[0])));
/// let outcomes: Vec<_> = drops.iter().map(|dropped| dropped.run.as_ref().map(|run| run.outcome)).collect();
/// assert_eq!(outcomes, [Some(Outcome::Delivered), Some(Outcome::Stuck)]);
/// ```
pub fn drops<D: Device>(
    designs: &[Vec<f64>],
    plate: usize,
    feeder: impl Fn(&[f64]) -> Option<D> + Sync,
) -> Vec<Dropped<D::Run>> {
    dropped(designs, plate, &feeder)
}

fn dropped<D: Device>(
    designs: &[Vec<f64>],
    plate: usize,
    feeder: &(dyn Fn(&[f64]) -> Option<D> + Sync),
) -> Vec<Dropped<D::Run>> {
    let drop = |values: &Vec<f64>| Dropped::through(feeder(values).as_ref(), plate);
    designs.par_iter().panic_fuse().map(drop).collect()
}
