//! How probable times are beside the engine's, which are no more than samples.

use super::stats::Stats;
use carom_num::elementary::{exp, ln};
use std::f64::consts::TAU;

/// Beside the samples so many drops may have a time farther away.
const FARTHER: f64 = 1.0;
/// A normal density less than e to this of its highest is none: beside one of the longest time it has no digit.
const NOTHING: f64 = -45.0;

/// Pólya's urn of the engine's drops of one class: each says where the next one may be, and each that is seen is put into it as one more.
/// So the engine's times are taken as the samples that they are. What is seen counts for those near it, by how probably it was one of them.
pub(super) struct Urn {
    /// Each time, minus a half over its variance, its highest density, and how many drops it stands for.
    kernels: Vec<(f64, f64, f64, f64)>,
}

impl Urn {
    /// Of what a node says; `longest` is the longest time that was seen.
    pub(super) fn of(stats: &Stats, scatter: f64, longest: f64) -> Self {
        let drops = stats.like / stats.times.len() as f64;
        let kernel = |(time, width): (f64, f64), drops: f64| {
            let variance = width + scatter * scatter;
            (time, -0.5 / variance, 1.0 / (TAU * variance).sqrt(), drops)
        };
        let mut kernels: Vec<_> = stats.kernels().into_iter().map(|of| kernel(of, drops)).collect();
        // How far the samples do not reach is not known: any scale is alike, from theirs to the longest time.
        let least = (stats.variance + scatter * scatter).sqrt();
        // The longest that is seen or simulated: a time that is seen has a density at every node.
        let longest = longest.max(stats.mean);
        let doubled = std::iter::successors(Some(least), |scale| Some(2.0 * scale));
        let scales: Vec<f64> = doubled.take_while(|scale| *scale < longest).chain([longest]).collect();
        let share = FARTHER / scales.len() as f64;
        kernels.extend(scales.iter().map(|scale| kernel((stats.mean, scale * scale), share)));
        Self { kernels }
    }

    /// Logarithm of how probable these times are, each seen so many times, one after the other.
    pub(super) fn log(mut self, each: &[(f64, f64)]) -> f64 {
        let mut all = self.kernels.iter().map(|kernel| kernel.3).sum::<f64>();
        let (mut log, mut parts) = (0.0, vec![0.0; self.kernels.len()]);
        for (time, count) in each {
            let mut seen = 0.0;
            while seen < *count {
                // Of many equal ones as many at once as there were before.
                let lot = f64::min(count - seen, f64::max(seen, 1.0));
                let mut density = 0.0;
                for (part, (at, factor, highest, drops)) in parts.iter_mut().zip(&self.kernels) {
                    let power = factor * (time - at).powi(2);
                    *part = if power > NOTHING { drops * highest * exp(power) } else { 0.0 };
                    density += *part;
                }
                log += lot * ln(density / all);
                for (part, kernel) in parts.iter().zip(&mut self.kernels) {
                    kernel.3 += lot * part / density;
                }
                (seen, all) = (seen + lot, all + lot);
            }
        }
        log
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stats(times: &[f64]) -> Stats {
        let (count, mean) = (times.len() as f64, times.iter().sum::<f64>() / times.len() as f64);
        let variance = times.iter().map(|time| (time - mean).powi(2)).sum::<f64>() / count;
        Stats { drops: count, like: count, mean, variance, times: times.to_vec(), ..Stats::default() }
    }

    #[test]
    fn what_may_come_next_has_the_probability_one() {
        let seen = [(1.02, 1.0), (0.97, 3.0)];
        let log = |each: &[(f64, f64)]| Urn::of(&stats(&[0.9, 0.95, 1.0, 1.1]), 0.02, 2.0).log(each);
        let step = 0.001;
        let next = |k: i32| exp(log(&[seen[0], seen[1], (f64::from(k) * step, 1.0)]) - log(&seen)) * step;
        let whole: f64 = (-15_000..17_000).map(next).sum();
        assert!((whole - 1.0).abs() < 1e-6, "the density of the next time, summed: {whole}");
    }

    #[test]
    fn what_is_far_from_all_samples_is_not_impossible() {
        let log = Urn::of(&stats(&[100.0, 100.1, 100.2]), 1e-12, 1.0).log(&[(1.0, 1000.0)]);
        assert!(log.is_finite(), "a second where the engine says 100: {log}");
    }

    #[test]
    fn the_unit_of_time_favours_no_node() {
        let ratio = |unit: f64| {
            let log = |times: &[f64]| {
                let times: Vec<f64> = times.iter().map(|time| time * unit).collect();
                Urn::of(&stats(&times), 0.02 * unit, 2.0 * unit)
                    .log(&[(1.02 * unit, 1.0), (0.95 * unit, 1.0)])
            };
            log(&[0.9, 1.0, 1.1]) - log(&[0.93, 0.95, 0.97, 1.0, 1.01])
        };
        assert!((ratio(1.0) - ratio(1000.0)).abs() < 1e-9, "seconds or milliseconds");
    }
}
