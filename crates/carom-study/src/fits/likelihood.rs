//! How probable the observed drops are where the engine's drops came out so.

use super::cells::sum_exp;
use super::stats::{Stats, worth};
use super::urn::Urn;
use super::{Observation, Plan, Seen, Simulated};
use carom_num::elementary::{exp, ln};
use std::f64::consts::TAU;

/// Weight of each outcome before any sample: Jeffreys' prior.
const PRIOR: f64 = 0.5;
/// Scatters at which a fitted one is looked at, evenly in their logarithm.
const SCATTERS: usize = 49;
/// The smallest fitted scatter, as a share of the longest time: 0.1 ms in a second, better than drops are timed.
const LEAST_SCATTER: f64 = 1.0e-4;

/// What a scatter that is not known is taken for where a straight line is judged, as a share of the longest time, and repetitions show less.
const SHOWN_SCATTER: f64 = 1.0e-3;

/// Drops that were seen to end alike under one condition.
pub(super) struct Class {
    pub(super) condition: usize,
    pub(super) seen: Seen,
    /// The first observation of it.
    pub(super) first: usize,
    /// How many drops.
    pub(super) count: f64,
}

/// Times of one class that were measured with one scatter.
struct Times {
    class: usize,
    /// Known, or fitted.
    scatter: Option<f64>,
    count: f64,
    mean: f64,
    /// Sum of the squared distances from the mean.
    squares: f64,
    /// Each time, and how often it was measured.
    each: Vec<(f64, f64)>,
}

/// The observations, sorted for the likelihood.
pub(super) struct Likelihood {
    pub(super) classes: Vec<Class>,
    times: Vec<Times>,
    /// Classes that exclude each other: under one condition, and looked at alike.
    batches: Vec<Vec<usize>>,
    /// True where nothing varies from drop to drop: an outcome is certain or impossible.
    exact: bool,
    /// Fitted scatters that are looked at; empty where none is fitted.
    pub(super) scatters: Vec<f64>,
    longest: f64,
    /// Of each condition, by how much less a time says than it would beside samples without end: 1 + n/m.
    vague: Vec<f64>,
}

impl Likelihood {
    pub(super) fn of(plan: &Plan, observations: &[Observation]) -> Self {
        let mut found = Self {
            classes: vec![],
            times: vec![],
            batches: vec![],
            exact: plan.dimensions == 0,
            scatters: vec![],
            longest: 0.0,
            vague: vec![1.0; plan.conditions],
        };
        for (number, observation) in observations.iter().enumerate() {
            let class = found.class(number, observation);
            if let Some(timed) = observation.time {
                found.longest = found.longest.max(timed.time);
                found.vague[observation.condition] += observation.count as f64 / plan.rounded() as f64;
                found.time(class, (timed.scatter, timed.time), observation.count as f64);
            }
        }
        for times in &mut found.times {
            times.each = spread_out(std::mem::take(&mut times.each));
        }
        if found.times.iter().any(|times| times.scatter.is_none()) {
            let step = -ln(LEAST_SCATTER) / (SCATTERS - 1) as f64;
            found.scatters =
                (0..SCATTERS).map(|k| found.longest * LEAST_SCATTER * exp(step * k as f64)).collect();
        }
        found
    }

    /// The class of an observation, which counts it.
    fn class(&mut self, number: usize, observation: &Observation) -> usize {
        let Observation { condition, seen, count, .. } = *observation;
        let known = self.classes.iter().position(|class| class.condition == condition && class.seen == seen);
        if let Some(class) = known {
            self.classes[class].count += count as f64;
            return class;
        }
        let class = self.classes.len();
        let alike = |other: &Class| other.condition == condition && other.seen.kind() == seen.kind();
        if seen.kind() != (false, false) {
            match self.batches.iter_mut().find(|batch| alike(&self.classes[batch[0]])) {
                Some(batch) => batch.push(class),
                None => self.batches.push(vec![class]),
            }
        }
        self.classes.push(Class { condition, seen, first: number, count: count as f64 });
        class
    }

    fn time(&mut self, class: usize, (scatter, time): (Option<f64>, f64), count: f64) {
        let known = self.times.iter_mut().find(|times| times.class == class && times.scatter == scatter);
        match known {
            // Welford's update, of so many equal times at once.
            Some(times) => {
                times.each.push((time, count));
                let before = times.count;
                times.count += count;
                let off = time - times.mean;
                times.mean += off * count / times.count;
                times.squares += off * off * before * count / times.count;
            }
            None => {
                let each = vec![(time, count)];
                self.times.push(Times { class, scatter, count, mean: time, squares: 0.0, each });
            }
        }
    }

    /// What the drops of a node say of each class. `drops` are those of each condition.
    pub(super) fn stats(&self, drops: &[Vec<Simulated>]) -> Vec<Stats> {
        let of = |class: &Class| Stats::of(&drops[class.condition], &class.seen, self.exact);
        self.classes.iter().map(of).collect()
    }

    /// The best that values between those of several nodes could do.
    pub(super) fn between(&self, corners: &[&[Stats]]) -> Vec<Stats> {
        let mut best: Vec<Stats> =
            (0..self.classes.len()).map(|class| spanned(corners, class, None)).collect();
        for batch in &self.batches {
            let all: f64 = batch.iter().map(|class| self.classes[*class].count).sum();
            for class in batch {
                best[*class] = spanned(corners, *class, Some(self.classes[*class].count / all));
            }
        }
        for times in &self.times {
            let seen = || corners.iter().map(|stats| &stats[times.class]).filter(|stats| stats.like > 0.0);
            let low = seen().map(|stats| stats.mean).fold(f64::INFINITY, f64::min);
            let high = seen().map(|stats| stats.mean).fold(f64::NEG_INFINITY, f64::max);
            if low <= high {
                let class = std::mem::take(&mut best[times.class]);
                best[times.class] = class.moved_to(times.mean.clamp(low, high));
            }
        }
        best
    }

    /// Logarithm of the likelihood at a node; a fitted scatter is averaged over.
    pub(super) fn log(&self, stats: &[Stats]) -> f64 {
        let (fixed, by_scatter) = self.parts(stats);
        match by_scatter.len() {
            0 => fixed,
            scatters => fixed + sum_exp(by_scatter.into_iter()) - ln(scatters as f64),
        }
    }

    /// Its part that does not depend on a fitted scatter, and the other at each of them.
    pub(super) fn parts(&self, stats: &[Stats]) -> (f64, Vec<f64>) {
        let outcomes: f64 = self.batches.iter().map(|batch| self.outcomes(batch, stats)).sum();
        let known = self.times.iter().filter_map(|times| Some(self.timed(times, times.scatter?, stats)));
        let fixed = outcomes + known.sum::<f64>();
        let fitted = |scatter: &f64| {
            let open = self.times.iter().filter(|times| times.scatter.is_none());
            open.map(|times| self.timed(times, *scatter, stats)).sum()
        };
        (fixed, self.scatters.iter().map(fitted).collect())
    }

    /// How far apart two nodes are, in standard deviations of what was observed.
    pub(super) fn distance(&self, a: &[Stats], b: &[Stats]) -> f64 {
        let shares = self.classes.iter().zip(a.iter().zip(b)).map(|(class, (a, b))| {
            let (off, middle) = (a.share() - b.share(), 0.5 * (a.share() + b.share()));
            let each = 1.0 / class.count + if self.exact { 0.0 } else { 1.0 / a.drops.max(1.0) };
            // A share of none or all is not known better than to a quarter of a drop.
            off * off / (middle * (1.0 - middle) * each + (0.25 * each).powi(2))
        });
        let times = self.times.iter().map(|times| {
            let (a, b) = (&a[times.class], &b[times.class]);
            if a.like == 0.0 || b.like == 0.0 {
                return 0.0;
            }
            let shown = (times.squares / times.count).sqrt().max(self.longest * SHOWN_SCATTER);
            let scatter = times.scatter.unwrap_or(shown);
            let each = a.variance + scatter * scatter;
            (a.mean - b.mean).powi(2) / (each / times.count + a.variance / a.like)
        });
        (shares.sum::<f64>() + times.sum::<f64>()).sqrt()
    }

    /// How far the times of a known scatter are off those of a node, as a root mean square in standard deviations; `None` without such times.
    pub(super) fn misfit(&self, stats: &[Stats]) -> Option<f64> {
        let (mut count, mut squares) = (0.0, 0.0);
        for times in &self.times {
            let Some(scatter) = times.scatter else { continue };
            let at = &stats[times.class];
            let off = times.count * (times.mean - at.mean).powi(2) + times.squares;
            count += times.count;
            squares += off / (at.variance + scatter * scatter);
        }
        (count > 0.0).then(|| (squares / count).sqrt())
    }

    /// Classes that do not occur at a node.
    pub(super) fn missing(&self, stats: &[Stats]) -> Vec<usize> {
        (0..self.classes.len()).filter(|class| stats[*class].like == 0.0).collect()
    }

    fn outcomes(&self, batch: &[usize], stats: &[Stats]) -> f64 {
        let drops = stats[batch[0]].drops;
        if drops == 0.0 {
            return f64::NEG_INFINITY;
        }
        if self.exact {
            // Between a node where it occurs and one where it does not, the border may be anywhere.
            return batch.iter().map(|class| ln(stats[*class].share().min(1.0))).sum();
        }
        let like: f64 = batch.iter().map(|class| stats[*class].like).sum();
        let worth = worth(batch.iter().map(|class| &stats[*class]));
        let rest = worth * (drops - like).max(0.0) + PRIOR;
        let (mut weights, mut seen, mut log) = (rest, 0.0, 0.0);
        for class in batch {
            let (weight, count) = (worth * stats[*class].like + PRIOR, self.classes[*class].count);
            log += ln_gamma(weight + count) - ln_gamma(weight);
            (weights, seen) = (weights + weight, seen + count);
        }
        log + ln_gamma(weights) - ln_gamma(weights + seen)
    }

    /// Logarithm of how probable the times of a class are, with this scatter.
    ///
    /// Every node is asked with the same points, so that what is by chance in the samples moves the posterior as a whole, which no node sees for
    /// itself. So n drops beside m samples count for nm/(n + m). The factor is the same at every node: one that differs from node to node
    /// would favour some of them by the unit of time.
    fn timed(&self, times: &Times, scatter: f64, stats: &[Stats]) -> f64 {
        let vague = self.vague[self.classes[times.class].condition];
        let stats = &stats[times.class];
        if stats.times.is_empty() {
            // Nothing is known of when: any time up to twice the longest, alike.
            return if self.exact {
                f64::NEG_INFINITY
            } else {
                -times.count * ln(2.0 * self.longest) / vague
            };
        }
        if self.exact {
            let (time, variance) = (stats.times[0], scatter * scatter);
            let density = |at: f64| -0.5 * (ln(TAU * variance) + (at - time).powi(2) / variance);
            return times.each.iter().map(|(at, count)| count * density(*at)).sum();
        }
        Urn::of(stats, scatter, self.longest).log(&times.each) / vague
    }
}

/// One class between several nodes, as near to this share of all drops as may be.
fn spanned(corners: &[&[Stats]], class: usize, share: Option<f64>) -> Stats {
    let of = || corners.iter().map(|stats| &stats[class]);
    let shares = || of().filter(|stats| stats.drops > 0.0).map(Stats::share);
    let low = shares().fold(f64::INFINITY, f64::min);
    let high = shares().fold(f64::NEG_INFINITY, f64::max);
    let drops = of().map(|stats| stats.drops).fold(0.0, f64::max);
    let like = if low <= high { share.unwrap_or(high).clamp(low, high) * drops } else { 0.0 };
    let timed = of().filter(|stats| !stats.times.is_empty());
    let least = timed.reduce(|a, b| if b.variance < a.variance { b } else { a }).cloned();
    Stats { drops, like, ..least.unwrap_or_default() }
}

/// These times, each and how often, equal ones as one, in an order that does not depend on that of the rows: every beginning of it is spread over all of them.
fn spread_out(mut each: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    each.sort_by(|a, b| a.0.total_cmp(&b.0));
    each.dedup_by(|next, kept| {
        let equal = next.0 == kept.0;
        kept.1 += if equal { next.1 } else { 0.0 };
        equal
    });
    let mut order: Vec<usize> = (0..each.len()).collect();
    order.sort_by_key(|k| k.reverse_bits());
    order.into_iter().map(|k| each[k]).collect()
}

/// Logarithm of the gamma function of a number above 0, by Stirling's series from 10 on and the recurrence below.
fn ln_gamma(x: f64) -> f64 {
    let (mut x, mut below) = (x, 1.0);
    while x < 10.0 {
        below *= x;
        x += 1.0;
    }
    let z = 1.0 / (x * x);
    let series = (1.0 / 12.0 - z * (1.0 / 360.0 - z * (1.0 / 1260.0 - z / 1680.0))) / x;
    (x - 0.5) * ln(x) - x + 0.5 * ln(TAU) + series - ln(below)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gamma_of_a_whole_number_is_a_factorial() {
        for (x, log) in [(1.0, 0.0), (2.0, 0.0), (5.0, ln(24.0)), (0.5, 0.5 * ln(0.5 * TAU))] {
            assert!((ln_gamma(x) - log).abs() < 1e-12, "ln Γ({x}) = {}, not {log}", ln_gamma(x));
        }
        let big = (1..=170).map(|k| ln(f64::from(k))).sum::<f64>();
        assert!((ln_gamma(171.0) - big).abs() < 1e-9, "170!");
    }

    #[test]
    fn the_order_of_times_is_their_own() {
        let spread = |each: &[(f64, f64)]| spread_out(each.to_vec());
        let sorted = spread(&[(1.0, 1.0), (1.1, 2.0), (1.2, 1.0), (1.3, 1.0)]);
        assert_eq!(sorted, [(1.0, 1.0), (1.2, 1.0), (1.1, 2.0), (1.3, 1.0)], "spread over all of them");
        let mixed = spread(&[(1.3, 1.0), (1.1, 1.0), (1.0, 1.0), (1.2, 1.0), (1.1, 1.0)]);
        assert_eq!(sorted, mixed, "whatever the order of the rows");
    }

    #[test]
    fn equal_times_count_as_often_as_they_occur() {
        let timed = |time: f64, count: u64| Observation {
            condition: 0,
            seen: Seen { ending: None, face: None },
            time: Some(super::super::Timed { time, scatter: Some(0.1) }),
            count,
        };
        let plan = Plan {
            ranges: vec![[0.0, 1.0]],
            conditions: 1,
            dimensions: 0,
            samples: 1,
            seed: 1,
            nodes: 100,
            level: 0.95,
        };
        let at = [Stats { drops: 1.0, like: 1.0, mean: 1.05, times: vec![1.05], ..Stats::default() }];
        let together = Likelihood::of(&plan, &[timed(1.0, 2), timed(1.2, 3)]).log(&at);
        let apart = Likelihood::of(
            &plan,
            &[timed(1.2, 1), timed(1.0, 1), timed(1.2, 1), timed(1.0, 1), timed(1.2, 1)],
        );
        assert!((together - apart.log(&at)).abs() < 1e-12, "five drops either way");
        let density = |time: f64| -0.5 * (ln(TAU * 0.01) + ((time - 1.05) / 0.1).powi(2));
        assert!(
            (together - 2.0 * density(1.0) - 3.0 * density(1.2)).abs() < 1e-9,
            "a product of normal densities"
        );
    }
}
