//! Painlevé's paradox: no hypothesis is consistent, and one contact, or several together, become the clock.

use super::stage::{Step, change};
use super::staged::Stage;
use super::walk::Walk;
use crate::Load;
use crate::planar::contacts::names::StageEnd;
use crate::planar::rates::answer::Solution;
use crate::planar::rates::rate::MOST_EXAMINED;
use crate::subsets::subsets;
use crate::tolerance::REST_IN_PARADOX;
use crate::{ImpactError, Phase};

/// A stage in which some contacts are the clock.
pub(in crate::planar) struct Loaded<const N: usize> {
    clocks: [bool; N],
    chosen: Solution<N>,
    change: [[f64; 2]; N],
    step: Step,
    /// How many consistent ways there were.
    branches: usize,
}

impl<const N: usize> Loaded<N> {
    /// The change of the normal velocity of each clock.
    fn sinking(&self) -> impl Iterator<Item = f64> {
        self.change.iter().zip(&self.clocks).filter(|(_, clock)| **clock).map(|(change, _)| change[1])
    }

    /// Its load drives every clock into its obstacle.
    fn drives_in(&self) -> bool {
        self.step.length.is_finite() && self.sinking().all(|by| by < 0.0)
    }

    /// How fast the clocks are driven in per impulse, negative.
    fn depth(&self) -> f64 {
        self.sinking().sum()
    }
}

impl<const N: usize, const M: usize> Walk<'_, N, M> {
    /// No hypothesis is consistent: one contact becomes the clock, loaded whatever its normal velocity does, up to the next event.
    ///
    /// It is the contact that friction drives in, alone or together with the contacts that touch; where there is none, contacts that
    /// close together drive each other in, and the one that approaches fastest is loaded first until it approaches no more. Where no
    /// contact can be loaded alone, because others would be driven in by it that cannot follow, these are loaded together. False where
    /// no contact can be loaded because all have come to rest.
    pub(in crate::planar) fn force(
        &mut self,
        phase: Phase,
        observe: &mut impl FnMut(&Stage<N>),
    ) -> Result<bool, ImpactError> {
        self.spend()?;
        let load = self
            .driven_in_alone()
            .or_else(|| self.fastest())
            .or_else(|| self.together(|load| load.drives_in()))
            .or_else(|| self.together(|load| self.stays_in(load)));
        let Some(Loaded { chosen, change, step, branches, .. }) = load else {
            return self.comes_to_rest();
        };
        self.branches = self.branches.max(branches);
        let stage = self.advance(phase, &chosen, &change, &step);
        self.finish(&stage, observe)?;
        Ok(true)
    }

    /// Contacts that hold each other and move by no more than the rounding of what stopped them are at rest; else they are jammed.
    fn comes_to_rest(&mut self) -> Result<bool, ImpactError> {
        let rounding = REST_IN_PARADOX * self.added;
        let moving = |u: &[f64; 2]| u.iter().any(|v| v.abs() > rounding);
        if self.now.velocity.iter().any(moving) {
            return Err(ImpactError::Jammed);
        }
        self.now.velocity = [[0.0; 2]; N];
        Ok(false)
    }

    /// Contacts that their own load drives into their obstacles: one, or several that drive each other in.
    pub(super) fn driven_in(&self) -> Option<Loaded<N>> {
        self.driven_in_alone().or_else(|| self.together(Loaded::drives_in))
    }

    /// A contact that its own load drives into its obstacle, by friction alone or with the help of the contacts that follow: of several,
    /// the one that is driven in fastest per impulse.
    fn driven_in_alone(&self) -> Option<Loaded<N>> {
        let touching = self.contacts().filter(|&i| self.normal(i) <= 0.0);
        let stages = touching.filter_map(|i| self.loaded(alone(i))).filter(Loaded::drives_in);
        stages.min_by(|a, b| a.depth().total_cmp(&b.depth()))
    }

    /// The contact that approaches fastest, loaded until it approaches no more.
    fn fastest(&self) -> Option<Loaded<N>> {
        let approaching = self.contacts().filter(|&i| self.normal(i) < 0.0);
        let fastest = approaching.min_by(|&i, &j| self.normal(i).total_cmp(&self.normal(j)))?;
        self.loaded(alone(fastest)).filter(|load| load.step.length.is_finite())
    }

    /// The fewest contacts that can be loaded together although none of them can alone; of several such sets, the one that is driven in
    /// fastest per impulse.
    ///
    /// Two contacts that are driven in by their own friction and by each other's load are such a set: neither follows the other. All
    /// take the same load, a convention: where both come to rest the share does not matter, where one slides off it may.
    fn together(&self, accept: impl Fn(&Loaded<N>) -> bool) -> Option<Loaded<N>> {
        let lonely = |&i: &usize| self.normal(i) <= 0.0 && self.loaded(alone(i)).is_none();
        let mut members = [0; N];
        let mut count = 0;
        for i in self.contacts().filter(lonely) {
            members[count] = i;
            count += 1;
        }
        let members = &members[..count];
        // Of more contacts than can be examined only pairs.
        let most = if count <= MOST_EXAMINED { count } else { 2 };
        (2..=most).find_map(|size| {
            let loads = subsets(members, size).filter_map(|clocks| self.loaded(clocks)).filter(&accept);
            loads.min_by(|a, b| a.depth().total_cmp(&b.depth()))
        })
    }

    /// No clock leaves its obstacle while it is loaded: it approaches, or is driven in.
    fn stays_in(&self, load: &Loaded<N>) -> bool {
        let stays = |i: usize| !load.clocks[i] || self.normal(i) < 0.0 || load.change[i][1] < 0.0;
        load.step.length.is_finite() && self.contacts().all(stays)
    }

    /// The straight stage in which the clocks are loaded at rate 1 each, touching contacts following; it ends where one of them approaches no
    /// more, if no event comes first.
    fn loaded(&self, clocks: [bool; N]) -> Option<Loaded<N>> {
        let load = std::array::from_fn(|i| {
            if clocks[i] {
                Load::Prescribed(1.0)
            } else if i < self.set.count && self.normal(i) == 0.0 {
                Load::Touching(0.0)
            } else {
                Load::Absent
            }
        });
        let drive = [[0.0; 2]; N];
        let answer = self.ask(drive, load).solve();
        let chosen = *answer.preferred(self.present.as_ref())?;
        let change = self.kept_out(change(&chosen, &drive), &chosen, Some(&clocks));
        let mut length = f64::INFINITY;
        for i in self.contacts().filter(|&i| clocks[i]) {
            let (u, by) = (self.normal(i), change[i][1]);
            length = if u < 0.0 && by > 0.0 { length.min(-u / by) } else { length };
        }
        let step = self.next_event(&chosen, &change, Step { length, why: StageEnd::CompressionEnds });
        Some(Loaded { clocks, chosen, change, step, branches: answer.count })
    }
}

fn alone<const N: usize>(clock: usize) -> [bool; N] {
    std::array::from_fn(|i| i == clock)
}
