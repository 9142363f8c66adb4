//! How much restitution is left, by each law.

use crate::Law;

/// Measures restitution along the walk of several contacts.
#[derive(Clone, Copy, Default)]
pub(super) struct Clock {
    law: Law,
    /// The contact whose approach is restituted.
    pub(in crate::planar) striking: usize,
    spent: f64,
    /// Work that the striking contact's normal impulse has still to return: counted down, since e² of a work is lost in its sum with that
    /// work where e is small.
    work_left: f64,
    normal_at_end: f64,
}

impl Clock {
    /// `compression_work`: work of the striking contact's normal impulse so far; `approach`: its normal velocity before.
    pub(in crate::planar) fn new(
        law: Law,
        striking: usize,
        restitution: f64,
        compression_work: f64,
        approach: f64,
    ) -> Self {
        let e = restitution;
        let work_left = (-e * e * compression_work).max(0.0);
        Self { law, striking, spent: 0.0, work_left, normal_at_end: -e * approach }
    }

    /// Length of the present straight stage until restitution is used up, from the striking contact's normal velocity, the change of that
    /// velocity and its normal impulse, both per unit of length.
    pub(in crate::planar) fn left(&self, u: f64, change: f64, rate: f64) -> f64 {
        match self.law {
            Law::Poisson => (1.0 - self.spent).max(0.0),
            Law::Newton if change > 0.0 => ((self.normal_at_end - u) / change).max(0.0),
            Law::Stronge if change > 0.0 => {
                // Work over a length s: rate (u s + change s² / 2), solved for s without cancellation.
                let left = self.work_left / rate;
                let root = (u * u + 2.0 * change * left).sqrt();
                if root > 0.0 { 2.0 * left / (u + root) } else { 0.0 }
            }
            Law::Newton | Law::Stronge => f64::INFINITY,
        }
    }

    /// True where the work of contact i decides when restitution ends.
    pub(super) fn measures_work_at(&self, i: usize) -> bool {
        self.law == Law::Stronge && i == self.striking
    }

    /// Poisson's clock: from 0 to 1.
    pub(super) fn spent(&self) -> f64 {
        self.spent
    }

    /// How far Poisson's clock may still go; the other laws stop by themselves.
    pub(super) fn remaining(&self) -> f64 {
        if self.law == Law::Poisson { 1.0 - self.spent } else { f64::INFINITY }
    }

    /// Work that the striking contact's normal impulse has returned since `before`.
    pub(super) fn returned_since(&self, before: &Self) -> f64 {
        before.work_left - self.work_left
    }

    /// Whether so much work may still be returned.
    pub(in crate::planar) fn returns(&self, work: f64) -> bool {
        self.law != Law::Stronge || work <= self.work_left
    }

    /// How many rounds more fit, where the next uses what was used since `before`, work that is returned grows by `growth` a round, and
    /// the striking contact's normal velocity, `u`, by `rise`; infinite where nothing is used.
    pub(super) fn rounds_left(&self, before: &Self, growth: f64, [u, rise]: [f64; 2]) -> f64 {
        let (left, used, growth) = match self.law {
            Law::Poisson => ((1.0 - self.spent).max(0.0), self.spent - before.spent, 0.0),
            Law::Stronge => (self.work_left, self.returned_since(before), growth.max(0.0)),
            Law::Newton => ((self.normal_at_end - u).max(0.0), rise, 0.0),
        };
        if used <= 0.0 {
            return f64::INFINITY;
        }
        // k used + k (k + 1) growth / 2 = left, without cancellation.
        let first = used + 0.5 * growth;
        2.0 * left / (first + (first * first + 2.0 * growth * left).sqrt())
    }

    /// Counts so many rounds, as [`Self::rounds_left`] does.
    pub(in crate::planar) fn pass(&mut self, rounds: f64, before: &Self, growth: f64) {
        self.spent += rounds * (self.spent - before.spent);
        let used = self.returned_since(before);
        self.return_work(rounds * (used + 0.5 * (rounds + 1.0) * growth));
    }

    /// Counts a stage of this length.
    pub(super) fn spend(&mut self, length: f64) {
        self.spent += length;
    }

    /// Counts work of the striking contact's normal impulse.
    pub(super) fn return_work(&mut self, work: f64) {
        self.work_left = (self.work_left - work).max(0.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn poissons_clock_runs_from_zero_to_one_and_the_others_stop_by_themselves() {
        let mut clock = Clock::new(Law::Poisson, 0, 0.5, -3.0, -2.0);
        clock.spend(0.25);
        assert_eq!((clock.remaining(), clock.left(-1.0, 2.0, 1.0)), (0.75, 0.75), "the same in any stage");
        for law in [Law::Newton, Law::Stronge] {
            let clock = Clock::new(law, 0, 0.5, -3.0, -2.0);
            assert_eq!(clock.remaining(), f64::INFINITY, "{law:?}");
            assert_eq!(clock.left(0.5, -2.0, 1.0), f64::INFINITY, "{law:?}: a contact that is slowed down");
        }
    }

    /// As many rounds as are left use up what is left: of Poisson's clock, of Newton's velocity, of Stronge's work.
    #[test]
    fn the_rounds_that_are_left_use_up_restitution() {
        let before = Clock::new(Law::Poisson, 0, 0.5, -3.0, -2.0);
        let mut clock = before;
        clock.spend(0.125);
        let rounds = clock.rounds_left(&before, 0.0, [0.0, 0.0]);
        assert_eq!(rounds, 7.0, "an eighth is gone");
        clock.pass(rounds, &before, 0.0);
        assert_eq!((clock.spent(), clock.remaining()), (1.0, 0.0), "all is gone");

        // The normal velocity rises by 1/8 a round, to e times the approach: 0.5 · 2.
        let clock = Clock::new(Law::Newton, 0, 0.5, -3.0, -2.0);
        assert_eq!(clock.rounds_left(&clock, 0.0, [0.25, 0.125]), 6.0, "three quarters are missing");

        // e² 12 = 3 to be returned; a round has returned 1/4, the next returns 1/2, the one after 3/4, …
        let before = Clock::new(Law::Stronge, 0, 0.5, -12.0, -2.0);
        let mut clock = before;
        clock.return_work(0.25);
        assert_eq!(clock.returned_since(&before), 0.25, "a quarter of a joule");
        assert!(clock.returns(2.75) && !clock.returns(2.76), "the rest, and no more");
        let rounds = clock.rounds_left(&before, 0.25, [0.0, 0.0]);
        assert!((4.0 * rounds + rounds * (rounds + 1.0) * 2.0 - 2.75 * 16.0).abs() < 1e-12, "{rounds}");
        let mut two = clock;
        two.pass(2.0, &before, 0.25);
        assert_eq!(two.returned_since(&before), 0.25 + 0.5 + 0.75, "two rounds more");
        clock.pass(rounds, &before, 0.25);
        assert!((clock.returned_since(&before) - 3.0).abs() < 1e-14, "all is gone");
    }
}
