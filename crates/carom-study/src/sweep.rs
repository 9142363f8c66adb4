//! Sweeps: many designs, one drop each.

use crate::ending::Dropped;
use carom_feeder::Feeder;
use carom_motion::planar::Options;
use rayon::prelude::*;

/// Drops the part once in every one of these designs, on all cores; the answers are in the order of the designs.
///
/// `feeder` makes a feeder of a design's values, or none where what is drawn cannot be; `plate` is the number of the plate that is looked at.
pub fn drops(
    designs: &[Vec<f64>],
    plate: usize,
    feeder: impl Fn(&[f64]) -> Option<Feeder> + Sync,
) -> Vec<Dropped> {
    let drop = |values: &Vec<f64>| Dropped::of(feeder(values).as_ref(), plate, &Options::default());
    designs.par_iter().map(drop).collect()
}
