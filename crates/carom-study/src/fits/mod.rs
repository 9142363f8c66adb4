//! Fits: which friction, which restitution (or whatever quantity is asked for) agrees with drops that were observed.
//!
//! The prior is flat over a range for each parameter. At a node of the range the engine drops the part, many times where something varies
//! from drop to drop, and says with what probability it ends how and when; how probable the observed drops are then is the likelihood. Nodes
//! are set where the posterior is, cell by cell ([`fit`]), and intervals are read off the cells.
//!
//! Which point is asked depends on the seed and its number alone, and cells are split in a fixed order, so that the result does not depend on
//! the number of threads.

mod cells;
mod likelihood;
mod observed;
mod posterior;
mod simulated;
mod stats;
mod urn;

pub use observed::{Observation, Seen, Timed};
pub use posterior::{Fit, Pair, Parameter};
pub use simulated::Simulated;

use crate::yields::REPETITIONS;
use carom_num::sobol::{MOST_DIMENSIONS, Sobol};
use cells::{Grid, Until};
use likelihood::Likelihood;
use rayon::prelude::*;
use thiserror::Error;

/// Most parameters of a fit: a cell of more has too many corners.
pub const MOST_PARAMETERS: usize = 4;
/// Most samples of a node: 2²⁰.
const MOST_SAMPLES: u64 = 1 << 20;
/// Nodes that a budget must allow for at least: fewer tell nothing.
const LEAST_NODES: usize = 16;

/// Samples for each observed drop from which their own chance hardly widens an interval: n drops beside m samples count for nm/(n + m).
const ENOUGH_SAMPLES: u64 = 10;

/// A time that is farther than this from all of the engine's, in standard deviations of its scatter, was not measured of such a drop.
const FAR: f64 = 8.0;

/// Nodes on which the posterior is followed between those of the engine.
const NODES: usize = 20_000;

/// What is fitted, and how finely.
///
/// # Example
/// Where something varies from drop to drop, samples are rounded up to 16 times a power of two; where nothing does, one drop says all.
/// ```
/// use carom_study::fits::Plan;
/// let plan = Plan { ranges: vec![[0.0, 1.0]], conditions: 1, dimensions: 2, samples: 100, seed: 1, nodes: 2000, level: 0.95 };
/// assert_eq!((plan.rounded(), Plan { dimensions: 0, ..plan }.rounded()), (16 * 8, 1));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// Low and high end of each parameter, SI: the prior is flat between them.
    pub ranges: Vec<[f64; 2]>,
    /// Conditions under which drops were observed: settings that differ from row to row.
    pub conditions: usize,
    /// Quantities that vary from drop to drop.
    pub dimensions: usize,
    /// Drops of each node under each condition: rounded up to 16 times a power of two, in [`REPETITIONS`] scrambles of their own.
    pub samples: u64,
    /// Every random number comes from it.
    pub seed: u64,
    /// Most nodes that are asked.
    pub nodes: usize,
    /// Probability that an interval holds, in (0, 1).
    pub level: f64,
}

/// Why nothing was fitted.
///
/// # Example
/// ```
/// use carom_study::fits::{FitError, Plan, Simulated, fit};
/// let plan = Plan { ranges: vec![], conditions: 1, dimensions: 0, samples: 1, seed: 1, nodes: 100, level: 0.95 };
/// let never = |_: &[f64], _: usize, _: &[f64]| -> Simulated { unreachable!() };
/// assert_eq!(fit(&plan, &[], never), Err(FitError::Parameters { found: 0 }));
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum FitError {
    /// Nothing is fitted, or too much.
    #[error("{found} parameters: 1 to {MOST_PARAMETERS} are fitted at once")]
    Parameters {
        /// How many.
        found: usize,
    },
    /// A range without an inside.
    #[error("parameter {parameter} has no range: its low end must be below its high end, both finite")]
    Range {
        /// Which parameter, from 0.
        parameter: usize,
    },
    /// More quantities vary than there are dimensions for.
    #[error("{found} quantities vary from drop to drop: at most {MOST_DIMENSIONS} are allowed")]
    Dimensions {
        /// How many.
        found: usize,
    },
    /// Samples, nodes or a level that cannot be.
    #[error(
        "{samples} samples, {nodes} nodes, level {level}: 1 to {MOST_SAMPLES}, {LEAST_NODES} or more, between 0 and 1 are allowed"
    )]
    Effort {
        /// Samples of a node.
        samples: u64,
        /// Nodes.
        nodes: usize,
        /// Probability of the interval.
        level: f64,
    },
    /// An observation of no drop, of an unknown condition, of nothing, or whose time or scatter is no number above 0.
    #[error("observation {observation} says nothing that can be computed with")]
    Observation {
        /// Which, from 0.
        observation: usize,
    },
    /// Nothing was observed.
    #[error("there are no observations")]
    Nothing,
    /// Outcomes that the engine gives nowhere in the range.
    #[error("the engine gives the outcome of observations {observations:?} nowhere in the range")]
    Never {
        /// Which, from 0: the first of each outcome under each condition.
        observations: Vec<usize>,
    },
    /// Times at which the engine's drops of that outcome do not end anywhere in the range.
    #[error("the engine's drops take other times than observations {observations:?}")]
    Untimely {
        /// Which, from 0.
        observations: Vec<usize>,
        /// The shortest and the longest time of the engine's drops that end like each of them [s].
        spans: Vec<[f64; 2]>,
    },
    /// The budget of nodes ended before it was found where the observations are most probable: intervals would be those of another place.
    #[error("the budget of {nodes} nodes ended before it was found where the observations agree best")]
    Lost {
        /// Nodes that were allowed.
        nodes: usize,
    },
    /// Every outcome occurs somewhere in the range, but nowhere all of them.
    #[error(
        "no point of the range gives all outcomes: at the best one observations {observations:?} do not occur"
    )]
    Contradiction {
        /// The first of each outcome under each condition that does not occur there.
        observations: Vec<usize>,
        /// That point, SI.
        at: Vec<f64>,
    },
}

impl Plan {
    /// Samples of a node under each condition, as they are taken.
    pub fn rounded(&self) -> u64 {
        match self.dimensions {
            0 => 1,
            _ => self.samples.div_ceil(REPETITIONS as u64).next_power_of_two() * REPETITIONS as u64,
        }
    }

    /// True where so many samples are no more than a few times the observed drops of one condition. Where nothing varies one sample says all.
    fn has_few_samples(&self, observations: &[Observation]) -> bool {
        let of = |condition: usize| {
            let own = observations.iter().filter(|seen| seen.condition == condition);
            own.map(|seen| seen.count).sum::<u64>()
        };
        let most = (0..self.conditions).map(of).max().unwrap_or(0);
        self.dimensions > 0 && self.rounded() < ENOUGH_SAMPLES * most
    }

    /// The points of what varies, one repetition after the other.
    fn points(&self) -> Vec<Vec<f64>> {
        let each = self.rounded() / REPETITIONS as u64;
        let scramble = |k: usize| self.seed.wrapping_mul(REPETITIONS as u64).wrapping_add(k as u64);
        let sobols = (0..REPETITIONS).filter_map(|k| Sobol::new(self.dimensions, scramble(k)));
        let points: Vec<Vec<f64>> =
            sobols.flat_map(|sobol| (0..each).map(move |number| sobol.point(number))).collect();
        // Without dimensions there is no sequence, and one point that has none.
        if points.is_empty() { vec![vec![]] } else { points }
    }

    fn check(&self, observations: &[Observation]) -> Result<(), FitError> {
        if !(1..=MOST_PARAMETERS).contains(&self.ranges.len()) {
            return Err(FitError::Parameters { found: self.ranges.len() });
        }
        let good = |[low, high]: &[f64; 2]| low.is_finite() && high.is_finite() && low < high;
        if let Some(parameter) = self.ranges.iter().position(|range| !good(range)) {
            return Err(FitError::Range { parameter });
        }
        if self.dimensions > MOST_DIMENSIONS {
            return Err(FitError::Dimensions { found: self.dimensions });
        }
        let (samples, nodes, level) = (self.samples, self.nodes, self.level);
        if !(1..=MOST_SAMPLES).contains(&samples) || nodes < LEAST_NODES || !(level > 0.0 && level < 1.0) {
            return Err(FitError::Effort { samples, nodes, level });
        }
        match observations.iter().position(|seen| !seen.is_sound(self.conditions)) {
            Some(observation) => Err(FitError::Observation { observation }),
            None if observations.is_empty() => Err(FitError::Nothing),
            None => Ok(()),
        }
    }
}

/// Fits parameters to observed drops. `simulate` drops the part once: with these values of the parameters, under the condition of this number, at
/// this point of the unit cube of all that varies from drop to drop (an empty one where nothing does).
///
/// The likelihood of counts is the Dirichlet-multinomial one, of the counts of the samples plus one half each (Jeffreys' prior): that they are
/// samples, too, widens it. Sobol's points count as so many independent ones as have the spread of their repetitions, where each outcome has 40 of them. Where nothing varies from drop to drop an outcome has the probability 0 or 1. A time is the engine's plus a normal
/// scatter, whose standard deviation is given or fitted; the spread of the engine's own times under what varies is added to it.
/// The engine's times are samples, too: each drop that is seen is put among them before the next is judged (Pólya's urn), and n drops beside m samples of
/// a node count for nm/(n + m), so that few samples widen an interval rather than move it.
///
/// Nodes are the corners of cells. A cell is halved where it may hold a noticeable share of the posterior and what the engine says in its middle
/// (shares of outcomes, mean times) is off the straight line between its corners by more than a fifth of a standard deviation of what was observed; what
/// may lie in it is judged by the best that values between those of its corners could do. The likelihood is then followed between nodes on
/// straight lines of shares and times.
///
/// # Limits
/// What is smaller than a cell of the first division (a 128th of the range of one parameter, a 64th of two, a 16th of three, a quarter of four; of a budget
/// below some ten thousand nodes twice that or more) and
/// shows at none of its corners is not seen. Simulated times of one outcome are kept as 48 quantiles.
///
/// # Errors
/// [`FitError`].
///
/// # Example
/// Ten throws of a coin that falls on *turned* with an unknown probability, three of which do. The posterior is Beta(4, 8): its median is 0.3238.
/// ```
/// use carom_feeder::Verdict;
/// use carom_study::Ending;
/// use carom_study::fits::{Observation, Plan, Seen, Simulated, fit};
/// let [turned, same] = [Verdict::Turned, Verdict::Same].map(Ending::Lies);
/// let coin = |p: &[f64], _: usize, u: &[f64]| Simulated {
///     ending: if u[0] < p[0] { turned } else { same }, face: None, time: None,
/// };
/// let seen = |ending, count| Observation {
///     condition: 0, seen: Seen { ending: Some(ending), face: None }, time: None, count,
/// };
/// let plan = Plan { ranges: vec![[0.0, 1.0]], conditions: 1, dimensions: 1, samples: 1024, seed: 1, nodes: 500, level: 0.5 };
/// let found = fit(&plan, &[seen(turned, 3), seen(same, 7)], coin)?;
/// let p = &found.parameters[0];
/// assert!((p.best - 0.3).abs() < 0.02 && (p.median - 0.3238).abs() < 0.005, "{p:?}");
/// # Ok::<(), carom_study::fits::FitError>(())
/// ```
pub fn fit(
    plan: &Plan,
    observations: &[Observation],
    simulate: impl Fn(&[f64], usize, &[f64]) -> Simulated + Sync,
) -> Result<Fit, FitError> {
    plan.check(observations)?;
    let likelihood = Likelihood::of(plan, observations);
    let points = plan.points();
    let ask = |values: &[f64]| {
        let under = |condition: usize| -> Vec<Simulated> {
            points.par_iter().panic_fuse().map(|point| simulate(values, condition, point)).collect()
        };
        likelihood.stats(&(0..plan.conditions).map(under).collect::<Vec<_>>())
    };
    let mut engine = Grid::new(plan, &likelihood, &ask);
    let mut resolved = engine.refine(Until::Straight, plan.nodes);
    let lost = !resolved && engine.is_lost();
    let wrong = never(&likelihood, &engine)
        .or_else(|| untimely(observations, &likelihood, &engine))
        .or_else(|| lost.then_some(FitError::Lost { nodes: plan.nodes }))
        .or_else(|| contradiction(&likelihood, &engine));
    if let Some(error) = wrong {
        return Err(error);
    }
    // What the engine says is straight between its nodes, but the likelihood is not: it is followed on nodes that cost no drop.
    let straight = |values: &[f64]| engine.between(values);
    let free = Plan { nodes: NODES, ..plan.clone() };
    let mut fine = Grid::new(&free, &likelihood, &straight);
    resolved &= fine.refine(Until::Alike, NODES);
    let few_samples = plan.has_few_samples(observations);
    let misfit = fine.best().and_then(|node| likelihood.misfit(&node.stats));
    Ok(Fit {
        nodes: engine.nodes.len(),
        few_samples,
        misfit,
        ..posterior::read_off(plan, &likelihood, &fine, resolved)
    })
}

/// The outcomes that occur at no node, where there are such.
fn never(likelihood: &Likelihood, engine: &Grid<'_>) -> Option<FitError> {
    let classes = &likelihood.classes;
    let none = |class: &usize| engine.nodes.values().all(|node| node.stats[*class].like == 0.0);
    let observations: Vec<usize> =
        (0..classes.len()).filter(none).map(|class| classes[class].first).collect();
    (!observations.is_empty()).then_some(FitError::Never { observations })
}

/// The times that are far from those of all drops that end so, at every node.
fn untimely(observations: &[Observation], likelihood: &Likelihood, engine: &Grid<'_>) -> Option<FitError> {
    let (mut far, mut spans) = (vec![], vec![]);
    for (number, seen) in observations.iter().enumerate() {
        let Some(timed) = seen.time else { continue };
        let own = |class: &likelihood::Class| class.condition == seen.condition && class.seen == seen.seen;
        let Some(class) = likelihood.classes.iter().position(own) else { continue };
        let times = || engine.nodes.values().flat_map(|node| node.stats[class].times.iter().copied());
        let [low, high] = [times().fold(f64::INFINITY, f64::min), times().fold(f64::NEG_INFINITY, f64::max)];
        // A scatter that is fitted can explain much, but no drop that takes less than half or more than twice as long.
        let near = match timed.scatter {
            Some(scatter) => low - FAR * scatter..=high + FAR * scatter,
            None => 0.5 * low..=2.0 * high,
        };
        if low <= high && !near.contains(&timed.time) {
            far.push(number);
            spans.push([low, high]);
        }
    }
    (!far.is_empty()).then_some(FitError::Untimely { observations: far, spans })
}

/// What makes the likelihood zero at every node, where it is, though every outcome occurs.
fn contradiction(likelihood: &Likelihood, engine: &Grid<'_>) -> Option<FitError> {
    let classes = &likelihood.classes;
    if engine.nodes.values().any(|node| node.log > f64::NEG_INFINITY) {
        return None;
    }
    let lost = |missing: &[usize]| missing.iter().map(|class| classes[*class].count).sum::<f64>();
    let nodes = engine.nodes.iter().map(|(place, node)| (place, likelihood.missing(&node.stats)));
    let (place, missing) = nodes.min_by(|a, b| lost(&a.1).total_cmp(&lost(&b.1)))?;
    let observations = missing.iter().map(|class| classes[*class].first).collect();
    Some(FitError::Contradiction { observations, at: engine.values(place) })
}
