//! How often a measure takes which values.

use crate::tolerance::ALIKE;

/// Counts over bins of equal width.
///
/// # Example
/// 32 drops with 7 m/s each fall into one bin.
/// ```
/// use carom_feeder::examples;
/// use carom_study::yields::{Histogram, Plan, Points, sample};
/// let feeder = examples::disc_above_a_tray();
/// let plan = Plan { dimensions: 1, samples: 2, seed: 1, points: Points::Sobol, plates: 2, plate: 1 };
/// let found = sample(&plan, |_| Some(feeder.clone()), |_| true, |_| 0.0)?;
/// let Histogram { edges, counts, below, above } = &found.plates[1].impact_speed.as_ref().unwrap().histogram;
/// assert_eq!((counts.as_slice(), *below, *above), ([32].as_slice(), 0, 0));
/// assert!(edges[0] < 7.1 && 6.9 < edges[1]);
/// # Ok::<(), carom_study::yields::YieldError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Histogram {
    /// Edges of the bins, ascending, one more than there are bins: multiples of a round step.
    pub edges: Vec<f64>,
    /// Values from each edge up to below the next; the last bin holds its upper edge too.
    pub counts: Vec<u64>,
    /// Values below the first edge: far from the others.
    pub below: u64,
    /// Values above the last edge.
    pub above: u64,
}

/// Bins over the middle 98 % of the values, where there are enough of them.
const MOST: f64 = 40.0;
/// Bins over those of a few values.
const LEAST: f64 = 5.0;
/// How far bins go beyond the middle 98 %, as a share of its width: a run in a hundred may take ten times as long as all others.
const BEYOND: f64 = 0.5;

/// A step that is 1, 2, 2.5 or 5 times a power of ten: a whole number over, or times, one.
#[derive(Clone, Copy, Debug)]
struct Step {
    whole: f64,
    exponent: i32,
}

impl Step {
    /// The smallest that is at least `least` > 0.
    fn above(least: f64) -> Self {
        let text = format!("{least:e}");
        let exponent: i32 = text.split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or(0);
        let found = [10.0, 20.0, 25.0, 50.0].map(|whole| Self { whole, exponent: exponent - 1 });
        let fits = found.into_iter().find(|step| step.times(1.0) >= least);
        fits.unwrap_or(Self { whole: 10.0, exponent })
    }

    /// So many steps from zero. A quotient of whole numbers is the nearest number there is: 0.3, not three times 0.1.
    fn times(self, count: f64) -> f64 {
        let scale = 10f64.powi(self.exponent.abs());
        if self.exponent < 0 { count * self.whole / scale } else { count * self.whole * scale }
    }

    /// The whole number of steps at or below a value.
    fn below(self, value: f64) -> f64 {
        let count = (value / self.times(1.0)).floor();
        if self.times(count) > value { count - 1.0 } else { count }
    }
}

impl Histogram {
    /// Of ascending values; without edges where there are none.
    ///
    /// The middle 98 % of the values get as many bins as the square root of their number, 5 to 40; a round width makes them fewer. At most as many
    /// again hold the values near them on either side. Values that are all alike get one bin.
    pub(super) fn of(sorted: &[f64]) -> Self {
        let (Some(&lowest), Some(&highest)) = (sorted.first(), sorted.last()) else {
            return Self { edges: vec![], counts: vec![], below: 0, above: 0 };
        };
        let at = |share: f64| sorted[((sorted.len() - 1) as f64 * share).round() as usize];
        let width = at(0.99) - at(0.01);
        // The outermost values that are not far away.
        let low = sorted.iter().find(|v| **v >= at(0.01) - BEYOND * width).map_or(lowest, |v| *v);
        let high = sorted.iter().rev().find(|v| **v <= at(0.99) + BEYOND * width).map_or(highest, |v| *v);
        let size = low.abs().max(high.abs());
        let bins = (sorted.len() as f64).sqrt().clamp(LEAST, MOST);
        let step = Step::above(match size {
            0.0 => 1.0,
            _ if width <= ALIKE * size => 0.1 * size,
            _ => width / bins,
        });
        let mut count = step.below(low);
        let mut edges = vec![step.times(count)];
        while edges.last().is_none_or(|edge| *edge < high) || edges.len() < 2 {
            count += 1.0;
            edges.push(step.times(count));
        }
        let mut starts: Vec<usize> =
            edges.iter().map(|edge| sorted.partition_point(|value| value < edge)).collect();
        // The last bin holds its upper edge.
        if let (Some(last), Some(edge)) = (starts.last_mut(), edges.last()) {
            *last = sorted.partition_point(|value| value <= edge);
        }
        let counts = starts.windows(2).map(|pair| (pair[1] - pair[0]) as u64).collect();
        let below = starts.first().map_or(0, |first| *first as u64);
        let above = starts.last().map_or(0, |last| (sorted.len() - last) as u64);
        Self { edges, counts, below, above }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_are_round_and_counts_are_those_of_a_direct_count() {
        // Two far away, and values on edges.
        let mut values: Vec<f64> = (0..2000).map(|i| 1.5 + 0.1 * (f64::from(i) * 0.618).fract()).collect();
        values.extend([1.2, 1.6, 240.0]);
        values.sort_by(f64::total_cmp);
        let found = Histogram::of(&values);
        assert_eq!((found.below, found.above), (1, 1), "{found:?}");
        assert!(found.edges.contains(&1.5) && found.edges.contains(&1.6), "{:?}", found.edges);
        let direct = |k: usize| {
            let last = k + 1 == found.counts.len();
            let inside = |v: &&f64| {
                **v >= found.edges[k] && (**v < found.edges[k + 1] || (last && **v == found.edges[k + 1]))
            };
            values.iter().filter(inside).count() as u64
        };
        for k in 0..found.counts.len() {
            assert_eq!(found.counts[k], direct(k), "bin {k}");
        }
        assert_eq!(found.counts.iter().sum::<u64>() + 2, values.len() as u64, "every value once");
        assert!(
            (20..=40).contains(&found.counts.len()),
            "those far away take no room: {}",
            found.counts.len()
        );
    }

    #[test]
    fn values_that_are_alike_have_one_bin() {
        for value in [0.0, 1.7, -3e-5, 1e12] {
            let found = Histogram::of(&[value; 3]);
            assert_eq!(found.counts, [3], "{found:?}");
            assert!(found.edges[0] <= value && value <= found.edges[1], "{found:?}");
        }
        assert_eq!(Histogram::of(&[]).counts, [0u64; 0], "of nothing");
    }

    #[test]
    fn steps_are_the_next_round_ones() {
        let cases =
            [(0.011, 0.02), (0.021, 0.025), (0.3, 0.5), (0.7, 1.0), (2.0, 2.0), (51.0, 100.0), (1e-7, 1e-7)];
        for (least, step) in cases {
            assert_eq!(Step::above(least).times(1.0), step, "{least}");
        }
        assert_eq!(Step::above(0.1).times(3.0), 0.3, "the nearest number");
    }
}
