//! Very many, or infinitely many, stages within a finite impulse.
//!
//! Contacts may hand the load to each other again and again: the one that is loaded stops the slip of the other and so takes over, and
//! each round repeats the one before, scaled by a ratio ρ. Such a series is geometric: k rounds more add `d (ρ + … + ρᵏ)` to every
//! velocity and impulse, d being the change of the last round. Where ρ < 1 it converges, and is followed to its limit
//! `d ρ/(1 − ρ)`; where restitution is used up before, the rounds that fit into it are passed over.
//!
//! Rounds that repeat each other without any ratio are those of [`super::circle`].

use super::clock::Clock;
use super::staged::{Stage, Station};
use super::walk::Walk;
use crate::planar::contacts::names::Slip;
use crate::planar::contacts::names::StageEnd;
use crate::tolerance::{AT_LIMIT, SAME_ROUND, STAGE_ZERO};
use crate::{ImpactError, Phase};

/// Stages walked before series are looked for: nearly all impacts end sooner.
const PATIENCE: usize = 12;
/// Longest round, in stages.
pub(super) const LONGEST_ROUND: usize = 24;
/// Rounds that are passed over at once, at most.
const MOST_ROUNDS: usize = 100_000;

/// The end of a stage.
#[derive(Clone, Copy)]
pub(super) struct Mark<const N: usize> {
    kind: (Phase, [Slip; N], StageEnd),
    /// Whether many rounds are passed over here: a round of rounds may hold a series.
    passed: bool,
    pub(in crate::planar) at: Station<N>,
    /// Impulses since the mark before.
    pub(in crate::planar) step: [[f64; 2]; N],
    pub(in crate::planar) work: [[f64; 2]; N],
    pub(in crate::planar) clock: Clock,
    /// What was added to velocities since the start.
    pub(in crate::planar) added: f64,
}

/// The ends of the last stages, since the walk became long.
#[derive(Clone)]
pub(super) struct History<const N: usize> {
    pub(super) marks: Vec<Mark<N>>,
}

impl<const N: usize> Default for History<N> {
    fn default() -> Self {
        Self { marks: Vec::new() }
    }
}

/// A series of rounds that repeat each other.
struct Series<const N: usize> {
    /// Change of the last round.
    round: Station<N>,
    /// What it used of the clock of restitution.
    spent: f64,
    /// Work that the striking contact returned in it.
    returned: f64,
    ratio: f64,
}

impl<const N: usize> Series<N> {
    /// How much of the last round is still to come, `ρ + ρ² + …`, and whether that is the limit of the series.
    fn rest(&self, clock: &Clock) -> (f64, bool) {
        let (whole, remaining) = (self.ratio / (1.0 - self.ratio), clock.remaining());
        // Work shrinks at least as fast as impulses do.
        if self.ratio < 1.0 && whole * self.spent <= remaining && clock.returns(whole * self.returned) {
            return (whole, true);
        }
        // By the other laws nothing is spent by length: such rounds are walked.
        if self.spent <= 0.0 || !remaining.is_finite() {
            return (0.0, false);
        }
        let (mut sum, mut power) = (0.0, self.ratio);
        for _ in 0..MOST_ROUNDS {
            if (sum + power) * self.spent > remaining {
                break;
            }
            sum += power;
            power *= self.ratio;
        }
        (sum, false)
    }
}

impl<const N: usize> History<N> {
    /// Where the last two rounds of so many stages start and end, where they do the same.
    pub(super) fn rounds(&self, round: usize) -> Option<[&Mark<N>; 3]> {
        let last = self.marks.len().checked_sub(1)?;
        let first = last.checked_sub(2 * round)?;
        let what = |k: usize| (self.marks[k].kind, self.marks[k].passed);
        let alike = |k: usize| what(last - k) == what(last - k - round);
        (0..round).all(alike).then(|| [first, last - round, last].map(|i| &self.marks[i]))
    }

    /// The shortest series that ends here.
    fn series(&self) -> Option<Series<N>> {
        (2..=LONGEST_ROUND).find_map(|round| self.series_of(round))
    }

    fn series_of(&self, round: usize) -> Option<Series<N>> {
        let [a, b, c] = self.rounds(round)?;
        let (before, now) = (difference(&b.at, &a.at), difference(&c.at, &b.at));
        let ratio = product(&now.velocity, &before.velocity) / product(&before.velocity, &before.velocity);
        let repeats = repeats(&now.velocity, &before.velocity, ratio, SAME_ROUND)
            && repeats(&now.impulse, &before.impulse, ratio, SAME_ROUND);
        let spent = c.clock.spent() - b.clock.spent();
        let returned = c.clock.returned_since(&b.clock);
        let in_step = (spent - ratio * (b.clock.spent() - a.clock.spent())).abs() <= SAME_ROUND;
        (repeats && in_step && ratio > 0.0).then_some(Series { round: now, spent, returned, ratio })
    }
}

pub(in crate::planar) fn difference<const N: usize>(a: &Station<N>, b: &Station<N>) -> Station<N> {
    let minus = |x: &[[f64; 2]; N], y: &[[f64; 2]; N]| {
        std::array::from_fn(|i| [x[i][0] - y[i][0], x[i][1] - y[i][1]])
    };
    Station { velocity: minus(&a.velocity, &b.velocity), impulse: minus(&a.impulse, &b.impulse) }
}

fn product<const N: usize>(a: &[[f64; 2]; N], b: &[[f64; 2]; N]) -> f64 {
    a.iter().flatten().zip(b.iter().flatten()).map(|(x, y)| x * y).sum()
}

/// Whether `now` is `ratio` times `before`, but for a fraction of the largest.
fn repeats<const N: usize>(now: &[[f64; 2]; N], before: &[[f64; 2]; N], ratio: f64, close: f64) -> bool {
    let largest = before.iter().flatten().fold(0.0, |m: f64, v| m.max(v.abs()));
    let pairs = now.iter().flatten().zip(before.iter().flatten());
    pairs.map(|(x, y)| (x - ratio * y).abs()).all(|off| off <= close * largest)
}

impl<const N: usize, const M: usize> Walk<'_, N, M> {
    /// Notes the end of a stage; where it ends a round of a series or of a circle, passes over the rest of it and returns that as one stage.
    ///
    /// # Errors
    /// [`ImpactError::Circling`] where the rest of it has no end.
    pub(super) fn accumulate(&mut self, stage: &Stage<N>) -> Result<Option<Stage<N>>, ImpactError> {
        if self.stages <= PATIENCE {
            self.step = [[0.0; 2]; N];
            return Ok(None);
        }
        self.mark(stage, false);
        let start = self.now;
        let passed = self.go_round()? || self.go_on();
        if passed {
            self.mark(stage, true);
        }
        let slip = self.slip_since(&start, stage);
        Ok(passed.then_some(Stage { start, end: self.now, slip, ..*stage }))
    }

    /// What each contact does in the rounds that are passed over at `stage`: the same as there. But a contact that takes an impulse in these
    /// rounds is not open: it does what it did when it last took one.
    fn slip_since(&self, start: &Station<N>, stage: &Stage<N>) -> [Slip; N] {
        std::array::from_fn(|i| {
            let loaded = self.now.impulse[i][1] > start.impulse[i][1];
            let last = self.history.marks.iter().rev().map(|mark| mark.kind.1[i]);
            match stage.slip[i] {
                Slip::Open if loaded => last.into_iter().find(|s| *s != Slip::Open).unwrap_or(Slip::Open),
                slip => slip,
            }
        })
    }

    fn mark(&mut self, stage: &Stage<N>, passed: bool) {
        if self.history.marks.len() > 2 * LONGEST_ROUND {
            self.history.marks.remove(0);
        }
        let kind = (stage.phase, stage.slip, stage.ended_by);
        let (at, work, clock, added) = (self.now, self.work, self.clock, self.added);
        let step = std::mem::replace(&mut self.step, [[0.0; 2]; N]);
        self.history.marks.push(Mark { kind, passed, at, step, work, clock, added });
    }

    /// Passes over the rest of a series that ends here; false where there is none.
    fn go_on(&mut self) -> bool {
        let Some(series) = self.history.series() else {
            return false;
        };
        let (rest, to_limit) = series.rest(&self.clock);
        let target = self.after(&series.round, rest, to_limit);
        // A velocity that changes its sign is an event that ends the series.
        let crosses = |i: usize| (0..2).any(|a| self.now.velocity[i][a] * target[i][a] < 0.0);
        if rest <= 0.0 || self.contacts().any(crosses) {
            return false;
        }
        for i in self.contacts() {
            for axis in 0..2 {
                self.book(i, axis, target[i][axis], rest * series.round.impulse[i][axis]);
            }
        }
        self.clock.spend(rest * series.spent);
        true
    }

    /// Velocities after `rest` of the last round.
    fn after(&self, round: &Station<N>, rest: f64, to_limit: bool) -> [[f64; 2]; N] {
        std::array::from_fn(|i| {
            std::array::from_fn(|axis| {
                let (u, by) = (self.now.velocity[i][axis], rest * round.velocity[i][axis]);
                let small = if to_limit { AT_LIMIT * (u.abs() + by.abs()) } else { 0.0 };
                if (u + by).abs() <= small.max(STAGE_ZERO * self.fastest) { 0.0 } else { u + by }
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Law;

    fn series(spent: f64, ratio: f64) -> Series<1> {
        let round = Station { velocity: [[0.0; 2]], impulse: [[0.0; 2]] };
        Series { round, spent, returned: 0.0, ratio }
    }

    /// Poisson's clock after so much restitution.
    fn poisson(spent: f64) -> Clock {
        let mut clock = Clock::new(Law::Poisson, 0, 0.5, -1.0, -1.0);
        clock.spend(spent);
        clock
    }

    #[test]
    fn a_series_is_followed_to_its_limit_or_as_far_as_restitution_reaches() {
        assert_eq!(series(0.25, 0.5).rest(&poisson(0.75)), (1.0, true), "the limit uses the clock up");
        assert_eq!(series(0.25, 0.5).rest(&poisson(0.85)), (0.5, false), "a second round, 1/16, is too much");
        let (sum, limit) = series(0.25, 0.8).rest(&poisson(0.5));
        assert!((sum - (0.8 + 0.64 + 0.512)).abs() < 1e-15 && !limit, "{sum}: a fourth round is too much");
        assert_eq!(series(0.25, 2.0).rest(&poisson(0.25)), (2.0, false), "rounds that grow: 1/2, not 1");
        assert_eq!(series(0.0, 1.0).rest(&poisson(0.5)), (0.0, false), "nothing is used, and no limit");
    }

    #[test]
    fn a_series_under_other_laws_has_its_limit_or_is_walked() {
        let clock = Clock::new(Law::Stronge, 0, 0.5, -4.0, -1.0);
        let returns = |returned: f64, ratio| Series { returned, ..series(0.1, ratio) };
        assert_eq!(returns(1.0, 0.5).rest(&clock), (1.0, true), "it returns 1 of 1");
        assert_eq!(returns(1.1, 0.5).rest(&clock), (0.0, false), "it would return more");
        assert_eq!(returns(0.0, 1.5).rest(&clock), (0.0, false), "it grows");
    }
}
