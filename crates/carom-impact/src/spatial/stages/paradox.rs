//! Painlevé's paradox in space: no hypothesis is consistent, and one contact becomes the clock.

use super::leg::{Goal, Leg};
use super::staged::{Ground, Stage};
use super::walk::{Purpose, Walk};
use crate::ImpactError;
use crate::Load;
use crate::spatial::rates::answer::Solution;
use crate::tolerance::REST_IN_PARADOX;
use carom_num::Vec3;

/// A stage in which one contact is the clock, and how fast its load drives that contact in (negative) or out.
pub(super) struct Forced<'a, const N: usize> {
    clock: usize,
    leg: Leg<'a, N>,
    solution: Solution<N>,
    outward: f64,
    branches: usize,
}

impl<'a, const N: usize> Walk<'a, N> {
    /// No hypothesis is consistent: the contact that friction drives in becomes the clock; where there is none, the one that approaches fastest. False where nothing
    /// can be loaded because all have come to rest. Where a slip has `turned` into the paradox, the contact that is driven in is the one that its own load hardly
    /// drives out any more. `asked` is what has no consistent answer.
    pub(super) fn force(
        &mut self,
        asked: &Purpose<N>,
        turned: bool,
        observe: &mut impl FnMut(&Stage<N>),
    ) -> Result<bool, ImpactError> {
        self.spend()?;
        let fastest = || {
            let approaching = self.contacts().filter(|&i| self.normal(i) < 0.0);
            approaching.min_by(|&i, &j| self.normal(i).total_cmp(&self.normal(j)))
        };
        let driven = self.driven_in(turned).map(|forced| (Ground::DrivenIn(forced.clock), forced));
        let forced = driven.or_else(|| {
            let forced = self.loaded(fastest()?)?;
            Some((Ground::FastestFirst(forced.clock), forced))
        });
        if let Some((ground, Forced { leg, solution, branches, .. })) = forced {
            self.branches = self.branches.max(branches);
            if self.go(&leg, &solution, &Purpose { ground, ..*asked }, observe)?.is_some() {
                return Ok(true);
            }
        }
        self.comes_to_rest()
    }

    /// Contacts that hold each other and move by no more than the rounding of what stopped them are at rest; else they are jammed.
    fn comes_to_rest(&mut self) -> Result<bool, ImpactError> {
        let rounding = REST_IN_PARADOX * self.added;
        if self.place.at.velocity[..self.set.count].iter().any(|u| u.norm() > rounding) {
            return Err(ImpactError::Jammed);
        }
        self.place.at.velocity = [Vec3::ZERO; N];
        Ok(false)
    }

    /// A contact that its own load drives in: of several, the one that is driven in fastest per impulse.
    pub(super) fn driven_in(&self, turned: bool) -> Option<Forced<'a, N>> {
        let touching = self.contacts().filter(|&i| self.normal(i) <= 0.0);
        let forced = touching.filter_map(|i| self.loaded(i)).filter(|f| turned || f.outward < 0.0);
        // Without a slip to stop nothing would end it.
        let ends = forced.filter(|f| self.contacts().any(|i| f.leg.is_tracked(i)));
        ends.min_by(|a, b| a.outward.total_cmp(&b.outward))
    }

    /// The stage in which contact `clock` is loaded at rate 1, touching contacts following.
    fn loaded(&self, clock: usize) -> Option<Forced<'a, N>> {
        let load = std::array::from_fn(|i| {
            if i == clock {
                Load::Prescribed(1.0)
            } else if i < self.set.count && self.normal(i) == 0.0 {
                Load::Touching(0.0)
            } else {
                Load::Absent
            }
        });
        let drive = [Vec3::ZERO; N];
        let answer = self.ask(drive, load).solve_first();
        let solution = self.preferred(&answer)?;
        let leg = self.leg_of(&solution, drive, load, Goal::Approach(clock));
        Some(Forced { clock, leg, outward: solution.response[clock].z, solution, branches: answer.count })
    }
}
