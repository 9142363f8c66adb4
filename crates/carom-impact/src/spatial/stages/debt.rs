//! What contacts still owe in restitution, by each law.

use super::leg::{Goal, Place, StageEvent};
use crate::Law;
use crate::spatial::contacts::set::ContactSet;

/// What contacts owe.
#[derive(Clone, Copy)]
pub(super) struct Debts<const N: usize> {
    law: Law,
    /// Rates at which the clock loads each contact; zero where nothing is owed.
    pub(super) rate: [f64; N],
    /// What is left of Poisson's clock.
    left: f64,
    /// Newton's: the striking contact, and its normal velocity at the end.
    striking: (usize, f64),
    /// Stronge's: the work that each normal impulse has left to do; infinite where nothing is owed.
    work: [f64; N],
    over: bool,
}

impl<const N: usize> Debts<N> {
    /// What is owed at the end of compression, each restitution times `factor`.
    pub(super) fn new(set: &ContactSet<N>, place: &Place<N>, law: Law, factor: f64) -> Self {
        let owes = |i: usize| i < set.count && place.at.velocity[i].z <= 0.0;
        let e = |i: usize| factor * set.restitution[i];
        // Under Stronge's law a contact that others kept from approaching has stored no work.
        let stored = |i: usize| (-place.work[i][1]).max(0.0);
        let owes = |i: usize| owes(i) && (law != Law::Stronge || stored(i) > 0.0);
        let rate = std::array::from_fn(|i| if owes(i) { e(i) * place.at.impulse[i].z } else { 0.0 });
        let work = std::array::from_fn(|i| {
            if owes(i) && rate[i] > 0.0 { e(i) * e(i) * stored(i) } else { f64::INFINITY }
        });
        let contact = (0..set.count).find(|&i| set.velocity[i].z < 0.0).unwrap_or(0);
        let striking = (contact, -e(contact) * set.velocity[contact].z);
        let over = match law {
            Law::Newton => rate[contact] <= 0.0,
            Law::Poisson | Law::Stronge => rate.iter().all(|r| *r <= 0.0),
        };
        Self { law, rate, left: 1.0, striking, work, over }
    }

    pub(super) fn any(&self) -> bool {
        !self.over
    }

    pub(super) fn goal(&self) -> Goal<N> {
        match self.law {
            Law::Poisson => Goal::Clock(self.left),
            Law::Newton => Goal::Velocity(self.striking.0, self.striking.1),
            Law::Stronge => Goal::Work(self.work),
        }
    }

    /// Counts work that is done.
    pub(super) fn count(&mut self, work: impl Fn(usize) -> f64) {
        for (i, left) in self.work.iter_mut().enumerate() {
            *left -= work(i);
        }
    }

    /// Counts a stage: what ended it, how far the clock went, and the work done.
    pub(super) fn pay(&mut self, event: StageEvent, clock: f64, work: &[[f64; 2]; N]) {
        self.left = (self.left - clock).max(0.0);
        self.count(|i| work[i][1]);
        match event {
            StageEvent::RestitutionEnds => self.over = true,
            StageEvent::Repaid(i) => {
                self.rate[i] = 0.0;
                self.work[i] = f64::INFINITY;
                self.over = self.rate.iter().all(|r| *r <= 0.0);
            }
            _ => {}
        }
    }
}
