//! Painlevé's paradox in space: no hypothesis is consistent, and one contact, or several together, become the clock.

use super::leg::{Goal, Leg};
use super::staged::{Ground, Stage};
use super::walk::{Purpose, Walk};
use crate::ImpactError;
use crate::Load;
use crate::spatial::rates::answer::Solution;
use crate::subsets::subsets;
use crate::tolerance::{AS_FAST, REST_IN_PARADOX};
use carom_num::Vec3;

/// Of more contacts that no load of their own explains only pairs are loaded together.
const MOST_TOGETHER: usize = 8;

/// A stage in which some contacts are the clock.
pub(super) struct Forced<'a, const N: usize> {
    clocks: [bool; N],
    leg: Leg<'a, N>,
    solution: Solution<N>,
    branches: usize,
}

impl<const N: usize> Forced<'_, N> {
    /// How fast each clock is moved out by the load of all, or in, which is negative.
    fn outward(&self) -> impl Iterator<Item = f64> {
        self.solution
            .response
            .iter()
            .zip(&self.clocks)
            .filter(|(_, clock)| **clock)
            .map(|(response, _)| response.z)
    }

    fn depth(&self) -> f64 {
        self.outward().sum()
    }

    fn drives_in(&self) -> bool {
        self.outward().all(|by| by < 0.0)
    }

    fn first(&self) -> usize {
        self.clocks.iter().position(|clock| *clock).unwrap_or(0)
    }
}

impl<'a, const N: usize> Walk<'a, N> {
    /// No hypothesis is consistent: the contact that friction drives in becomes the clock; where there is none, the one that approaches fastest; where none can be
    /// loaded alone, contacts that drive each other in. Those that are alike are loaded alike. False where nothing can be loaded because all have come to rest. Where a
    /// slip has `turned` into the paradox, the contact that is driven in is the one that its own load hardly drives out any more. `asked` is what has no consistent answer.
    pub(super) fn force(
        &mut self,
        asked: &Purpose<N>,
        turned: bool,
        observe: &mut impl FnMut(&Stage<N>),
    ) -> Result<bool, ImpactError> {
        self.spend()?;
        let driven = |forced: Forced<'a, N>| (Ground::DrivenIn(forced.first()), forced);
        let first = |forced: Forced<'a, N>| (Ground::FastestFirst(forced.first()), forced);
        let forced = self
            .driven_in_alone(turned)
            .map(driven)
            .or_else(|| self.fastest().map(first))
            .or_else(|| self.together(Forced::drives_in).map(driven))
            .or_else(|| self.together(|load| self.stays_in(load)).map(driven));
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

    /// True where friction drives something in although nothing approaches.
    pub(super) fn is_driven_in(&self) -> bool {
        self.driven_in_alone(false).or_else(|| self.together(Forced::drives_in)).is_some()
    }

    /// A contact that its own load drives in: of several, the one that is driven in fastest per impulse, with those that are driven in as fast.
    fn driven_in_alone(&self, turned: bool) -> Option<Forced<'a, N>> {
        let touching = self.contacts().filter(|&i| self.normal(i) <= 0.0);
        let forced = touching.filter_map(|i| self.loaded(alone(i))).filter(|f| turned || f.drives_in());
        // Without a slip to stop nothing would end it.
        let ends: Vec<Forced<'a, N>> = forced.filter(|f| self.ends(f)).collect();
        let deepest = ends.iter().map(Forced::depth).fold(f64::INFINITY, f64::min);
        let as_fast = |f: &&Forced<'a, N>| (f.depth() - deepest).abs() <= AS_FAST * deepest.abs();
        let mut clocks = [false; N];
        ends.iter().filter(as_fast).for_each(|f| clocks[f.first()] = true);
        let alike = clocks.iter().filter(|clock| **clock).count() > 1;
        let together = if alike { self.loaded(clocks) } else { None };
        let together = together.filter(|f| self.ends(f) && (turned || f.drives_in()));
        together.or_else(|| ends.into_iter().min_by(|a, b| a.depth().total_cmp(&b.depth())))
    }

    /// The contact that approaches fastest, with those that approach as fast.
    fn fastest(&self) -> Option<Forced<'a, N>> {
        let approaching = || self.contacts().filter(|&i| self.normal(i) < 0.0);
        let fastest = approaching().min_by(|&i, &j| self.normal(i).total_cmp(&self.normal(j)))?;
        let most = self.normal(fastest);
        let mut clocks = [false; N];
        approaching().filter(|&i| self.normal(i) <= (1.0 - AS_FAST) * most).for_each(|i| clocks[i] = true);
        self.loaded(clocks).or_else(|| self.loaded(alone(fastest)))
    }

    /// The fewest contacts that can be loaded together although none of them can alone; of several such sets, the one that is driven in fastest per impulse. All take
    /// the same load, as in the plane.
    fn together(&self, accept: impl Fn(&Forced<'a, N>) -> bool) -> Option<Forced<'a, N>> {
        let lonely = |&i: &usize| self.normal(i) <= 0.0 && self.loaded(alone(i)).is_none();
        let members: Vec<usize> = self.contacts().filter(lonely).collect();
        let most = if members.len() <= MOST_TOGETHER { members.len() } else { 2 };
        (2..=most).find_map(|size| {
            let loads = subsets(&members, size).filter_map(|clocks| self.loaded(clocks));
            let loads = loads.filter(|load| self.ends(load) && accept(load));
            loads.min_by(|a, b| a.depth().total_cmp(&b.depth()))
        })
    }

    /// No clock leaves its obstacle while it is loaded: it approaches, or is driven in.
    fn stays_in(&self, load: &Forced<'a, N>) -> bool {
        let stays = |i: usize| self.normal(i) < 0.0 || load.solution.response[i].z < 0.0;
        self.contacts().all(|i| !load.clocks[i] || stays(i))
    }

    /// There is a slip that it may stop.
    fn ends(&self, load: &Forced<'a, N>) -> bool {
        self.contacts().any(|i| load.leg.is_tracked(i))
    }

    /// The stage in which the clocks are loaded at rate 1 each, touching contacts following.
    fn loaded(&self, clocks: [bool; N]) -> Option<Forced<'a, N>> {
        let load = std::array::from_fn(|i| {
            if clocks[i] {
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
        let first = clocks.iter().position(|clock| *clock)?;
        let leg = self.leg_of(&solution, drive, load, Goal::Approach(first));
        Some(Forced { clocks, leg, solution, branches: answer.count })
    }
}

/// One contact as the clock.
fn alone<const N: usize>(contact: usize) -> [bool; N] {
    std::array::from_fn(|i| i == contact)
}
