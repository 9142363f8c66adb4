//! The worst of many drops: what limits on speed and time have to hold against, where quantities vary.

use super::judge::speeds;
use crate::device::Landed;
use std::sync::atomic::{AtomicU64, Ordering};

/// The largest speeds and the longest time of drops, whatever order and thread they come from.
#[derive(Debug, Default)]
pub struct Worst {
    /// Bits of numbers that are not negative: these are in the order of the numbers.
    measures: [AtomicU64; 3],
    drops: AtomicU64,
}

/// The worst of the drops that were seen.
///
/// # Example
/// ```
/// use carom_study::design::{Extremes, Worst};
/// assert_eq!(Worst::default().found(), Extremes::default());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Extremes {
    /// The hardest strike on a plate, the first or a later one [m/s].
    pub impact_speed: f64,
    /// The largest slip velocity on a plate [m/s].
    pub sliding_speed: f64,
    /// When the last of the runs ends [s].
    pub time: f64,
    /// How many drops were seen.
    pub drops: u64,
}

impl Worst {
    /// Looks at a drop.
    pub fn see(&self, run: &impl Landed) {
        let [impact, slide] = speeds(run);
        for (most, value) in self.measures.iter().zip([impact, slide, run.end_time()]) {
            if value > 0.0 {
                most.fetch_max(value.to_bits(), Ordering::Relaxed);
            }
        }
        self.drops.fetch_add(1, Ordering::Relaxed);
    }

    /// The worst of those seen so far.
    pub fn found(&self) -> Extremes {
        let [impact_speed, sliding_speed, time] =
            [0, 1, 2].map(|i: usize| f64::from_bits(self.measures[i].load(Ordering::Relaxed)));
        Extremes { impact_speed, sliding_speed, time, drops: self.drops.load(Ordering::Relaxed) }
    }
}
