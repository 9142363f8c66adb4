//! What the engine says at one node of one class of drops.

use super::{Seen, Simulated};
use crate::yields::{FEW, REPETITIONS};

/// Most quantiles by which the times of a class are kept.
const QUANTILES: usize = 48;

/// What the engine says of one class at one node.
#[derive(Clone, Debug, Default)]
pub(super) struct Stats {
    /// Drops that could be followed.
    pub(super) drops: f64,
    /// Those that ended so.
    pub(super) like: f64,
    /// Variance of their share, from that of the repetitions.
    pub(super) spread: f64,
    /// Their mean time [s] and its variance [s²].
    pub(super) mean: f64,
    pub(super) variance: f64,
    /// Quantiles of their times [s], of equal weight, ascending, from the earliest to the latest; empty where there are none.
    pub(super) times: Vec<f64>,
}

impl Stats {
    /// Of the drops under one condition, one repetition after the other; `exact` where nothing varies.
    pub(super) fn of(drops: &[Simulated], seen: &Seen, exact: bool) -> Self {
        let possible = || drops.iter().filter(|drop| drop.is_possible());
        let like = || possible().filter(|drop| seen.matches(drop));
        let mut times: Vec<f64> = like().filter_map(|drop| drop.time).collect();
        times.sort_by(f64::total_cmp);
        let (count, mean, squares) = moments(times.iter().copied());
        let kept = times.len().min(if exact { 1 } else { QUANTILES });
        let rank = |k: usize| times[k * (times.len() - 1) / (kept - 1).max(1)];
        Self {
            drops: possible().count() as f64,
            like: like().count() as f64,
            spread: if exact { 0.0 } else { spread(drops, seen) },
            mean,
            variance: if exact { 0.0 } else { squares / count.max(1.0) },
            times: (0..kept).map(rank).collect(),
        }
    }

    /// Share of the drops.
    pub(super) fn share(&self) -> f64 {
        if self.drops > 0.0 { self.like / self.drops } else { 0.0 }
    }

    /// The mean of several nodes by weight. Times are taken quantile by quantile, and count as often as they occur.
    pub(super) fn mixed(nodes: &[(f64, &[Self])]) -> Vec<Self> {
        let classes = nodes.first().map_or(0, |(_, stats)| stats.len());
        (0..classes).map(|class| Self::mixed_class(nodes, class)).collect()
    }

    fn mixed_class(nodes: &[(f64, &[Self])], class: usize) -> Self {
        let sum =
            |what: fn(&Self) -> f64| nodes.iter().map(|(w, stats)| w * what(&stats[class])).sum::<f64>();
        let like = sum(|s| s.like);
        let mean = |what: &dyn Fn(&Self) -> f64| {
            let seen = nodes.iter().filter(|(_, stats)| stats[class].like > 0.0);
            let sum: f64 = seen.map(|(w, stats)| w * stats[class].like * what(&stats[class])).sum();
            if like > 0.0 { sum / like } else { 0.0 }
        };
        let kept = nodes.iter().map(|(_, stats)| stats[class].times.len()).max().unwrap_or(0);
        let quantile = |k: usize| {
            let rank = |s: &Self| k * s.times.len().saturating_sub(1) / (kept - 1).max(1);
            mean(&|s| s.times.get(rank(s)).copied().unwrap_or(s.mean))
        };
        Self {
            drops: sum(|s| s.drops),
            like,
            spread: sum(|s| s.spread),
            mean: mean(&|s| s.mean),
            variance: mean(&|s| s.variance),
            times: (0..kept).map(quantile).collect(),
        }
    }

    /// The same with another mean time: all times move alike.
    pub(super) fn moved_to(mut self, mean: f64) -> Self {
        let by = mean - self.mean;
        self.times.iter_mut().for_each(|time| *time += by);
        self.mean = mean;
        self
    }

    /// Its times, each with the variance of what it stands for: everything half way to its neighbours, and as far again beyond the ends.
    pub(super) fn kernels(&self) -> Vec<(f64, f64)> {
        let times = &self.times;
        let last = times.len().saturating_sub(1);
        let of = |k: usize| {
            let (before, after) = (times[k.saturating_sub(1)], times[(k + 1).min(last)]);
            let sides = if k == 0 || k == last { 1.0 } else { 2.0 };
            (times[k], ((after - before) / sides).powi(2) / 12.0)
        };
        (0..times.len()).map(of).collect()
    }
}

/// Variance of the mean of the shares that the repetitions give. Counts are whole: equal ones say no more than that the spread is below half of one.
fn spread(drops: &[Simulated], seen: &Seen) -> f64 {
    let each = (drops.len() / REPETITIONS).max(1);
    let share = |drops: &[Simulated]| {
        drops.iter().filter(|drop| drop.is_possible() && seen.matches(drop)).count() as f64 / each as f64
    };
    let (count, _, squares) = moments(drops.chunks(each).map(share));
    (squares / (count - 1.0).max(1.0)).max((0.5 / each as f64).powi(2)) / count.max(1.0)
}

/// How many independent samples a sample of these classes is worth: evenly spread points spread less. One, where an outcome is too rare to tell.
pub(super) fn worth<'s>(stats: impl Iterator<Item = &'s Stats> + Clone) -> f64 {
    if stats.clone().any(|stats| stats.like.min(stats.drops - stats.like) < FEW as f64) {
        return 1.0;
    }
    let independent: f64 = stats.clone().map(|s| s.like * (s.drops - s.like) / s.drops.powi(3)).sum();
    let found: f64 = stats.map(|stats| stats.spread).sum();
    (independent / found).max(1.0)
}

/// Count, mean, and sum of the squared distances from it.
fn moments(values: impl Iterator<Item = f64> + Clone) -> (f64, f64, f64) {
    let (count, sum) = values.clone().fold((0.0, 0.0), |(count, sum), value| (count + 1.0, sum + value));
    let mean = if count > 0.0 { sum / count } else { 0.0 };
    (count, mean, values.map(|value| (value - mean).powi(2)).sum())
}
