//! Painlevé's paradox: no hypothesis is consistent, and one contact becomes the clock.

use super::answer::Solution;
use super::rate::Load;
use super::stage::{Step, change};
use super::staged::StagedStage;
use super::walk::Walk;
use super::{ImpactError, Phase, StageEnd};

/// Velocities below this fraction of all that was added to them are rounding, where nothing else can be said of them.
const REST: f64 = 1e-10;

/// A stage in which one contact is the clock.
pub(super) struct Loaded<const N: usize> {
    clock: usize,
    chosen: Solution<N>,
    change: [[f64; 2]; N],
    step: Step,
    /// How many consistent ways there were.
    branches: usize,
}

impl<const N: usize, const M: usize> Walk<'_, N, M> {
    /// No hypothesis is consistent: one contact becomes the clock, loaded whatever its normal velocity does, up to the next event.
    ///
    /// It is the contact that friction drives in, alone or together with the contacts that touch; where there is none, contacts that
    /// close together drive each other in, and the one that approaches fastest is loaded first until it approaches no more. False where
    /// no contact can be loaded because all have come to rest.
    pub(super) fn force(
        &mut self,
        phase: Phase,
        observe: &mut impl FnMut(&StagedStage<N>),
    ) -> Result<bool, ImpactError> {
        self.spend()?;
        let fastest = || {
            let approaching = self.contacts().filter(|&i| self.normal(i) < 0.0);
            approaching.min_by(|&i, &j| self.normal(i).total_cmp(&self.normal(j)))
        };
        let load = self
            .driven_in()
            .or_else(|| fastest().and_then(|i| self.loaded(i)).filter(|l| l.step.length.is_finite()));
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
        let rounding = REST * self.added;
        let moving = |u: &[f64; 2]| u.iter().any(|v| v.abs() > rounding);
        if self.now.velocity.iter().any(moving) {
            return Err(ImpactError::Jammed);
        }
        self.now.velocity = [[0.0; 2]; N];
        Ok(false)
    }

    /// A contact that its own load drives into its obstacle, by friction alone or with the help of the contacts that follow: of several,
    /// the one that is driven in fastest per impulse.
    pub(super) fn driven_in(&self) -> Option<Loaded<N>> {
        let touching = self.contacts().filter(|&i| self.normal(i) <= 0.0);
        let stages = touching
            .filter_map(|i| self.loaded(i))
            .filter(|l| l.change[l.clock][1] < 0.0 && l.step.length.is_finite());
        stages.min_by(|a, b| a.change[a.clock][1].total_cmp(&b.change[b.clock][1]))
    }

    /// The straight stage in which contact `clock` is loaded at rate 1, touching contacts following.
    fn loaded(&self, clock: usize) -> Option<Loaded<N>> {
        let load = std::array::from_fn(|i| {
            if i == clock {
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
        let change = self.kept_out(change(&chosen, &drive), &chosen, Some(clock));
        let (u, by) = (self.normal(clock), change[clock][1]);
        let length = if u < 0.0 && by > 0.0 { -u / by } else { f64::INFINITY };
        let step = self.next_event(&chosen, &change, Step { length, why: StageEnd::CompressionEnds });
        Some(Loaded { clock, chosen, change, step, branches: answer.count })
    }
}
