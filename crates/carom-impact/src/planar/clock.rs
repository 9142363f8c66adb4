//! How much restitution is left, by each law.

use super::Law;

/// Measures restitution along the walk of several contacts.
pub(super) struct Clock {
    law: Law,
    /// The contact whose approach is restituted.
    pub(super) striking: usize,
    spent: f64,
    work_at_end: f64,
    normal_at_end: f64,
}

impl Clock {
    /// `compression_work`: work of the striking contact's normal impulse so far; `approach`: its normal velocity before.
    pub(super) fn new(
        law: Law,
        striking: usize,
        restitution: f64,
        compression_work: f64,
        approach: f64,
    ) -> Self {
        let e = restitution;
        Self {
            law,
            striking,
            spent: 0.0,
            work_at_end: compression_work - e * e * compression_work,
            normal_at_end: -e * approach,
        }
    }

    /// Length of the present straight stage until restitution is used up, from the striking contact's normal velocity and work so far, the
    /// change of that velocity and its normal impulse, both per unit of length.
    pub(super) fn left(&self, (u, work): (f64, f64), change: f64, rate: f64) -> f64 {
        match self.law {
            Law::Poisson => 1.0 - self.spent,
            Law::Newton if change > 0.0 => ((self.normal_at_end - u) / change).max(0.0),
            Law::Stronge if change > 0.0 => {
                // Work over a length s: rate (u s + change s² / 2), solved for s without cancellation.
                let left = ((self.work_at_end - work) / rate).max(0.0);
                let root = (u * u + 2.0 * change * left).sqrt();
                if root > 0.0 { 2.0 * left / (u + root) } else { 0.0 }
            }
            Law::Newton | Law::Stronge => f64::INFINITY,
        }
    }

    pub(super) fn spend(&mut self, length: f64) {
        self.spent += length;
    }
}
