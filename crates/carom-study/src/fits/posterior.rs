//! Intervals, and what cannot be told apart, read off the cells.

use super::Plan;
use super::cells::Grid;
use super::likelihood::Likelihood;
use carom_num::elementary::{exp, ln};

/// An interval that is at least this share of what a flat posterior has says nothing.
const UNTOLD: f64 = 0.8;
/// Parameters whose correlation is at least this are not told apart.
const CORRELATED: f64 = 0.9;
/// So is one of which another explains this share of the variance, along whatever curve.
const EXPLAINED: f64 = 0.81;
/// Lots of equal weight in which one parameter is looked at to see what it explains of another.
const LOTS: usize = 20;

/// One parameter.
///
/// # Example
/// ```
/// use carom_study::fits::Parameter;
/// let friction = Parameter { best: 0.2, median: 0.21, low: 0.15, high: 0.27, mean: 0.21, deviation: 0.03, told: true };
/// assert!(friction.low <= friction.best && friction.best <= friction.high);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    /// Where the likelihood is highest, of the nodes that are in the intervals of all parameters.
    pub best: f64,
    /// The posterior lies half below it.
    pub median: f64,
    /// Lower end of the interval: the posterior lies equally below it and above the upper one.
    pub low: f64,
    /// Upper end of the interval.
    pub high: f64,
    /// Mean of the posterior.
    pub mean: f64,
    /// Its standard deviation.
    pub deviation: f64,
    /// False where the interval is about as wide as without any observation.
    pub told: bool,
}

/// How much two parameters go together.
///
/// # Example
/// ```
/// use carom_study::fits::Pair;
/// let ridge = Pair { of: [0, 1], correlation: -0.97, explained: 0.95, told: false };
/// assert!(ridge.correlation * ridge.correlation <= ridge.explained + 0.01);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// Which, from 0.
    pub of: [usize; 2],
    /// Correlation under the posterior, −1 to 1.
    pub correlation: f64,
    /// Share of the variance of one that the other explains, along whatever curve (the correlation ratio); the larger of both, 0 to 1.
    pub explained: f64,
    /// False where they are on a ridge: the observations tell a combination of both, and neither alone.
    pub told: bool,
}

/// What was fitted.
///
/// # Example
/// A rod on a slope of 3 in 4 was held: its friction is 3/4 or more, and everything between that and 1 is as likely.
/// ```
/// use carom_feeder::{Outcome, examples};
/// use carom_motion::planar::Options;
/// use carom_study::fits::{Observation, Plan, Seen, Simulated, fit};
/// use carom_study::{Dropped, Ending};
/// let slope = |friction: &[f64], _: usize, _: &[f64]| {
///     Simulated::of(&Dropped::of(Some(&examples::rod_on_a_slope(friction[0])), 0, &Options::default()), 0)
/// };
/// let seen = Seen { ending: Some(Ending::Otherwise(Outcome::Stuck)), face: None };
/// let held = Observation { condition: 0, seen, time: None, count: 1 };
/// let plan = Plan { ranges: vec![[0.0, 1.0]], conditions: 1, dimensions: 0, samples: 1, seed: 1, nodes: 500, level: 0.9 };
/// let friction = fit(&plan, &[held], slope)?.parameters[0];
/// assert!((friction.low - 0.7625).abs() < 1e-3 && (friction.high - 0.9875).abs() < 1e-3);
/// # Ok::<(), carom_study::fits::FitError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// In the order of the ranges.
    pub parameters: Vec<Parameter>,
    /// Standard deviation of the times [s], where it was fitted.
    pub scatter: Option<Parameter>,
    /// Natural logarithm of the highest likelihood at a node, a fitted scatter averaged over; without the multinomial coefficients.
    pub log_likelihood: f64,
    /// Every two parameters.
    pub pairs: Vec<Pair>,
    /// Nodes that were asked.
    pub nodes: usize,
    /// False where the budget of nodes ended before all cells were small enough: intervals are then coarse.
    pub resolved: bool,
    /// True where the engine's drops at a node are fewer than ten times those observed under one condition: intervals are then wider than the observed
    /// drops allow, and may miss by several of their widths where an outcome is rare.
    pub few_samples: bool,
    /// How far times of a known scatter are off the engine's where the likelihood is highest, as a root mean square in standard deviations of both
    /// together: about 1 where all is as it is said. `None` without such times.
    pub misfit: Option<f64>,
}

/// A share of the posterior: a box by its ends, its middle and its weight.
struct Piece {
    ends: Vec<[f64; 2]>,
    weight: f64,
}

impl Piece {
    fn middle(&self, axis: usize) -> f64 {
        0.5 * (self.ends[axis][0] + self.ends[axis][1])
    }
}

pub(super) fn read_off(plan: &Plan, likelihood: &Likelihood, grid: &Grid<'_>, resolved: bool) -> Fit {
    let log_likelihood = grid.nodes.values().map(|node| node.log).fold(f64::NEG_INFINITY, f64::max);
    let pieces = pieces(grid, log_likelihood);
    let axes = plan.ranges.len();
    let mut parameters: Vec<Parameter> = (0..axes).map(|axis| marginal(plan, &pieces, axis)).collect();
    let best = best(grid, &parameters);
    for (parameter, best) in parameters.iter_mut().zip(&best) {
        parameter.best = *best;
    }
    let pairs = (0..axes).flat_map(|a| (a + 1..axes).map(move |b| [a, b]));
    let pairs = pairs.map(|of| pair(&pieces, &parameters, of)).collect();
    let scatter = (!likelihood.scatters.is_empty()).then(|| scatter(plan, likelihood, grid, log_likelihood));
    Fit {
        parameters,
        scatter,
        log_likelihood,
        pairs,
        nodes: grid.nodes.len(),
        resolved,
        few_samples: false,
        misfit: None,
    }
}

/// The weight of each corner of a cell, of the quarter (half, eighth) of the cell that is next to it.
fn pieces(grid: &Grid<'_>, highest: f64) -> Vec<Piece> {
    let mut found = vec![];
    for cell in &grid.cells {
        let (low, high) = cell.ends();
        let [low_values, high_values] = [low, high].map(|place| grid.values(place));
        let around = grid.around(low, high);
        let volume = exp(cell.log_volume()) / around.len() as f64;
        for (bits, node) in around.iter().enumerate() {
            let weight = exp(node.log - highest) * volume;
            if weight > 0.0 {
                let side = |axis: usize| {
                    let (low, high) = (low_values[axis], high_values[axis]);
                    let middle = 0.5 * (low + high);
                    if bits >> axis & 1 == 1 { [middle, high] } else { [low, middle] }
                };
                found.push(Piece { ends: (0..low.len()).map(side).collect(), weight });
            }
        }
    }
    let whole: f64 = found.iter().map(|piece| piece.weight).sum();
    found.iter_mut().for_each(|piece| piece.weight /= whole);
    found
}

fn marginal(plan: &Plan, pieces: &[Piece], axis: usize) -> Parameter {
    let spans: Vec<([f64; 2], f64)> = pieces.iter().map(|piece| (piece.ends[axis], piece.weight)).collect();
    let tail = 0.5 * (1.0 - plan.level);
    let [low, median, high] = quantiles(&spans, [tail, 0.5, 1.0 - tail]);
    let mean: f64 = pieces.iter().map(|piece| piece.weight * piece.middle(axis)).sum();
    let square = |([a, b], weight): &([f64; 2], f64)| {
        weight * ((0.5 * (a + b) - mean).powi(2) + (b - a).powi(2) / 12.0)
    };
    let deviation = spans.iter().map(square).sum::<f64>().sqrt();
    let [from, to] = plan.ranges[axis];
    let told = high - low < UNTOLD * plan.level * (to - from);
    Parameter { best: median, median, low, high, mean, deviation, told }
}

/// Values below which these shares lie, of weights that are spread evenly over their spans; shares ascend.
fn quantiles<const N: usize>(spans: &[([f64; 2], f64)], shares: [f64; N]) -> [f64; N] {
    let mut changes: Vec<(f64, f64)> = vec![];
    for ([a, b], weight) in spans {
        let density = weight / (b - a);
        changes.extend([(*a, density), (*b, -density)]);
    }
    changes.sort_by(|a, b| a.0.total_cmp(&b.0));
    let whole: f64 = spans.iter().map(|(_, weight)| weight).sum();
    let mut found = [changes.last().map_or(f64::NAN, |last| last.0); N];
    let (mut density, mut below, mut next) = (0.0, 0.0, 0);
    for k in 1..changes.len() {
        density += changes[k - 1].1;
        let (from, to) = (changes[k - 1].0, changes[k].0);
        let here = density * (to - from);
        while next < N && here > 0.0 && below + here >= shares[next] * whole {
            found[next] = (from + (shares[next] * whole - below).max(0.0) / density).min(to);
            next += 1;
        }
        below += here;
    }
    found
}

/// The node of the highest likelihood in all intervals; of equal ones the nearest to the medians.
fn best(grid: &Grid<'_>, parameters: &[Parameter]) -> Vec<f64> {
    let mut found: Option<(f64, f64, Vec<f64>)> = None;
    for (place, node) in &grid.nodes {
        let values = grid.values(place);
        let mut at = values.iter().zip(parameters);
        if node.log == f64::NEG_INFINITY || !at.all(|(value, p)| (p.low..=p.high).contains(value)) {
            continue;
        }
        let off = |(value, p): (&f64, &Parameter)| ((value - p.median) / (p.high - p.low)).powi(2);
        let off: f64 = values.iter().zip(parameters).map(off).sum();
        let better =
            found.as_ref().is_none_or(|(log, known, _)| node.log > *log || node.log == *log && off < *known);
        if better {
            found = Some((node.log, off, values));
        }
    }
    found.map_or_else(|| parameters.iter().map(|p| p.median).collect(), |(_, _, values)| values)
}

fn pair(pieces: &[Piece], parameters: &[Parameter], of: [usize; 2]) -> Pair {
    let [a, b] = of.map(|axis| &parameters[axis]);
    let product =
        |piece: &Piece| piece.weight * (piece.middle(of[0]) - a.mean) * (piece.middle(of[1]) - b.mean);
    let covariance: f64 = pieces.iter().map(product).sum();
    let correlation = (covariance / (a.deviation * b.deviation)).clamp(-1.0, 1.0);
    let explained = explained(pieces, of, a).max(explained(pieces, [of[1], of[0]], b)).min(1.0);
    Pair { of, correlation, explained, told: correlation.abs() < CORRELATED && explained < EXPLAINED }
}

/// The share of the variance of the first that the second explains.
fn explained(pieces: &[Piece], [first, second]: [usize; 2], parameter: &Parameter) -> f64 {
    let mut order: Vec<&Piece> = pieces.iter().collect();
    order.sort_by(|a, b| a.middle(second).total_cmp(&b.middle(second)));
    let mut lots = [(0.0, 0.0); LOTS];
    let mut below = 0.0;
    for piece in order {
        let middle = below + 0.5 * piece.weight;
        let lot = &mut lots[((middle * LOTS as f64) as usize).min(LOTS - 1)];
        lot.0 += piece.weight;
        lot.1 += piece.weight * piece.middle(first);
        below += piece.weight;
    }
    let between = |(weight, sum): &(f64, f64)| {
        if *weight > 0.0 { weight * (sum / weight - parameter.mean).powi(2) } else { 0.0 }
    };
    lots.iter().map(between).sum::<f64>() / parameter.deviation.powi(2)
}

/// The scatter of the times, all else averaged over.
fn scatter(plan: &Plan, likelihood: &Likelihood, grid: &Grid<'_>, highest: f64) -> Parameter {
    let scatters = &likelihood.scatters;
    let mut weights = vec![0.0; scatters.len()];
    for cell in &grid.cells {
        let (low, high) = cell.ends();
        let volume = exp(cell.log_volume());
        for node in grid.around(low, high).iter().filter(|node| node.log > f64::NEG_INFINITY) {
            let (fixed, by_scatter) = likelihood.parts(&node.stats);
            let add = |(weight, log): (&mut f64, &f64)| *weight += volume * exp(fixed + log - highest);
            weights.iter_mut().zip(&by_scatter).for_each(add);
        }
    }
    let half = if scatters.len() > 1 { 0.5 * ln(scatters[1] / scatters[0]) } else { 0.0 };
    let spans: Vec<([f64; 2], f64)> =
        scatters.iter().map(|s| [ln(*s) - half, ln(*s) + half]).zip(weights.iter().copied()).collect();
    let tail = 0.5 * (1.0 - plan.level);
    let [low, median, high] = quantiles(&spans, [tail, 0.5, 1.0 - tail]).map(exp);
    let whole: f64 = weights.iter().sum();
    let mean = scatters.iter().zip(&weights).map(|(s, w)| s * w).sum::<f64>() / whole;
    let square = scatters.iter().zip(&weights).map(|(s, w)| w * (s - mean).powi(2)).sum::<f64>() / whole;
    let most = (0..scatters.len()).max_by(|a, b| weights[*a].total_cmp(&weights[*b])).unwrap_or(0);
    let best = scatters[most].clamp(low, high);
    Parameter { best, median, low, high, mean, deviation: square.sqrt(), told: true }
}
