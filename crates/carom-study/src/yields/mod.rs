//! Yield: with what probability drops end as wanted, when a feeder's quantities are not exactly what is drawn.
//!
//! The unit cube stands for everything that varies, one dimension a quantity; whoever asks turns a point of it into a feeder. Points are
//! Sobol's with Owen's scrambling ([`carom_num::sobol`]), in [`REPETITIONS`] scrambles of their own: their spread tells how sure a probability
//! is. Which point is asked depends on the seed and its number alone, so that the result does not depend on the number of threads.

mod estimate;
mod histogram;
mod recirculation;
mod sensitivity;
mod tally;

pub use estimate::{Estimate, REPETITIONS, Spread};
pub(crate) use estimate::{FEW, wilson};
pub use histogram::Histogram;
pub use recirculation::Recirculation;
pub use sensitivity::{NoIndices, Sensitivity, sensitivity};
pub use tally::{PlateSpread, Transition, Worst};

use crate::ending::{Dropped, Ending};
use carom_feeder::{Feeder, Run};
use carom_motion::planar::Options;
use carom_num::sobol::{MOST_DIMENSIONS, Sobol, random};
use rayon::prelude::*;
use tally::Tally;
use thiserror::Error;

/// Most samples of a repetition: 2³⁰.
const MOST_DIGITS: u32 = 30;
/// Samples that one thread takes at once.
const CHUNK: u64 = 256;

/// Where the points of a sampling come from.
///
/// # Example
/// By plain Monte Carlo half of the drops are held too, but not exactly.
/// ```
/// use carom_feeder::{Outcome, examples};
/// use carom_study::yields::{Plan, Points, sample};
/// let slope = examples::rod_on_a_slope;
/// let plan = Plan { dimensions: 1, samples: 64, seed: 1, points: Points::Random, plates: 1, plate: 0 };
/// let varied = |u: &[f64]| Some(slope(0.5 + 0.5 * u[0]));
/// let found = sample(&plan, varied, |run| run.outcome == Outcome::Stuck, |_| 0.0)?.wanted;
/// // The spread of 1024 throws of a coin is 1/64; this is four times as much.
/// assert!((found.share - 0.5).abs() < 4.0 / 64.0);
/// # Ok::<(), carom_study::yields::YieldError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Points {
    /// Sobol's, scrambled.
    #[default]
    Sobol,
    /// Independent random numbers: plain Monte Carlo.
    Random,
}

/// What is sampled.
///
/// # Example
/// ```
/// use carom_study::yields::{Plan, Points};
/// let plan = Plan { dimensions: 3, samples: 100, seed: 1, points: Points::Sobol, plates: 2, plate: 1 };
/// assert_eq!(plan.rounded(), 128);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// Quantities that vary.
    pub dimensions: usize,
    /// Drops of each repetition: rounded up to a power of two.
    pub samples: u64,
    /// Every random number comes from it.
    pub seed: u64,
    /// Where the points come from.
    pub points: Points,
    /// Plates of the feeder.
    pub plates: usize,
    /// The plate whose endings are told apart.
    pub plate: usize,
}

/// Why nothing was sampled.
///
/// # Example
/// ```
/// use carom_study::yields::{Plan, Points, YieldError, sample};
/// let plan = Plan { dimensions: 0, samples: 4, seed: 1, points: Points::Sobol, plates: 1, plate: 0 };
/// assert_eq!(sample(&plan, |_| None, |_| true, |_| 0.0), Err(YieldError::Dimensions { found: 0 }));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum YieldError {
    /// Nothing varies, or more than there are dimensions for.
    #[error("{found} quantities vary: 1 to {MOST_DIMENSIONS} are allowed")]
    Dimensions {
        /// How many.
        found: usize,
    },
    /// No samples, or too many.
    #[error("{found} samples a repetition: 1 to {most} are allowed")]
    Samples {
        /// How many.
        found: u64,
        /// How many there may be.
        most: u64,
    },
}

/// What a sampling found.
///
/// # Example
/// Half of the drops are held and half are delivered: no drop is lost.
/// ```
/// use carom_feeder::{Outcome, Run, examples};
/// use carom_study::Ending;
/// use carom_study::yields::{Plan, Points, Yield, sample};
/// let slope = examples::rod_on_a_slope;
/// let plan = Plan { dimensions: 1, samples: 4, seed: 1, points: Points::Sobol, plates: 1, plate: 0 };
/// let varied = |u: &[f64]| Some(slope(0.5 + 0.5 * u[0]));
/// let held = |run: &Run| run.outcome == Outcome::Stuck;
/// let found = sample(&plan, varied, held, |u| (u[0] - 0.5).abs())?;
/// let Yield { wanted, endings, drops, .. } = &found;
/// assert_eq!(endings.iter().map(|(_, estimate)| estimate.count).sum::<u64>(), *drops);
/// let held = endings.iter().find(|(ending, _)| *ending == Ending::Otherwise(Outcome::Stuck)).unwrap();
/// assert_eq!((held.1.share, wanted.share), (0.5, 0.5));
/// # Ok::<(), carom_study::yields::YieldError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Yield {
    /// With what probability a drop ends as wanted.
    pub wanted: Estimate,
    /// With what probability it does and keeps what must be kept as well.
    pub kept: Estimate,
    /// Every ending on the plate that is looked at, the most probable first.
    pub endings: Vec<(Ending, Estimate)>,
    /// From which face on the plate before to which on this one, plate by plate.
    pub transitions: Vec<Transition>,
    /// What a loop that throws the rejected back comes to. `None` of a disc; where no drop ends as wanted; where a rejected part lies on a face on
    /// which none was dropped.
    pub recirculation: Option<Recirculation>,
    /// Speeds and times on each plate.
    pub plates: Vec<PlateSpread>,
    /// When a run ends that ends as wanted [s].
    pub time: Option<Spread>,
    /// Of each ending that is not wanted the drop nearest to the middle of all that varies; then the hardest strike.
    pub worst: Vec<Worst>,
    /// Drops that were followed.
    pub drops: u64,
}

impl Plan {
    /// Samples of a repetition, as they are taken.
    ///
    /// # Example
    /// ```
    /// use carom_study::yields::{Plan, Points};
    /// let plan = Plan { dimensions: 1, samples: 5, seed: 1, points: Points::Sobol, plates: 1, plate: 0 };
    /// assert_eq!(plan.rounded(), 8);
    /// ```
    pub fn rounded(&self) -> u64 {
        self.samples.next_power_of_two()
    }

    fn check(&self) -> Result<(), YieldError> {
        let most = 1 << MOST_DIGITS;
        if !(1..=MOST_DIMENSIONS).contains(&self.dimensions) {
            return Err(YieldError::Dimensions { found: self.dimensions });
        }
        if !(1..=most).contains(&self.samples) {
            return Err(YieldError::Samples { found: self.samples, most });
        }
        Ok(())
    }

    /// The points of one of the repetitions, by number.
    fn points(&self, repetition: usize) -> Option<impl Fn(u64) -> Vec<f64> + Sync> {
        let (points, dimensions) = (self.points, self.dimensions);
        let seed = self.seed.wrapping_mul(REPETITIONS as u64).wrapping_add(repetition as u64);
        let sobol = Sobol::new(dimensions, seed)?;
        Some(move |number: u64| match points {
            Points::Sobol => sobol.point(number),
            Points::Random => (0..dimensions).map(|d| random(seed, number, d)).collect(),
        })
    }
}

/// Samples a feeder. `feeder` makes one from a point of the unit cube, or none where the drawing cannot be. `wanted` says whether a run ends as it
/// should. `distance` says how far a point is from the middle of all that varies: the farther it is, the less probable.
///
/// # Limits
/// The interval is Student's: it supposes that the means of the repetitions are about normal, which they are but for very rare endings.
/// Every speed and time is kept until its quantiles are taken: 8 bytes each, three for every plate that a drop lies on and one more, or 56 MB
/// for a million drops over two plates after the first.
///
/// # Errors
/// [`YieldError`].
///
/// # Example
/// A rod on a slope of 3 in 4, whose friction is anything from 1/2 to 1: 3/4 and more hold it, and Sobol's
/// points fall into both halves alike.
/// ```
/// use carom_feeder::{Outcome, Run, examples};
/// use carom_study::yields::{Plan, Points, sample};
/// let slope = examples::rod_on_a_slope;
/// let plan = Plan { dimensions: 1, samples: 4, seed: 1, points: Points::Sobol, plates: 1, plate: 0 };
/// let varied = |u: &[f64]| Some(slope(0.5 + 0.5 * u[0]));
/// let held = |run: &Run| run.outcome == Outcome::Stuck;
/// let found = sample(&plan, varied, held, |u| (u[0] - 0.5).abs())?;
/// assert_eq!(found.wanted.share, 0.5);
/// # Ok::<(), carom_study::yields::YieldError>(())
/// ```
pub fn sample(
    plan: &Plan,
    feeder: impl Fn(&[f64]) -> Option<Feeder> + Sync,
    wanted: impl Fn(&Run) -> bool + Sync,
    distance: impl Fn(&[f64]) -> f64 + Sync,
) -> Result<Yield, YieldError> {
    sample_within(plan, feeder, (wanted, |_: &Run| true), distance)
}

/// As [`sample`]. It also counts, apart, the runs that end as wanted and for which `keeps` is true: those that keep a limit on their speed, say.
///
/// # Errors
/// [`YieldError`].
///
/// # Example
/// Of the rods that are held a half has a friction of at least 7/8, and so a margin of `(7/8 − 3/4)/(7/8 +
/// 3/4)`, 1/13, or more.
/// ```
/// use carom_feeder::{Outcome, Run, examples};
/// use carom_study::yields::{Plan, Points, sample_within};
/// let slope = examples::rod_on_a_slope;
/// let plan = Plan { dimensions: 1, samples: 4, seed: 1, points: Points::Sobol, plates: 1, plate: 0 };
/// let varied = |u: &[f64]| Some(slope(0.5 + 0.5 * u[0]));
/// let held = |run: &Run| run.outcome == Outcome::Stuck;
/// let surely = |run: &Run| run.margin >= 1.0 / 13.0;
/// let found = sample_within(&plan, varied, (held, surely), |_| 0.0)?;
/// assert_eq!((found.wanted.share, found.kept.share), (0.5, 0.25));
/// # Ok::<(), carom_study::yields::YieldError>(())
/// ```
pub fn sample_within(
    plan: &Plan,
    feeder: impl Fn(&[f64]) -> Option<Feeder> + Sync,
    (wanted, keeps): (impl Fn(&Run) -> bool + Sync, impl Fn(&Run) -> bool + Sync),
    distance: impl Fn(&[f64]) -> f64 + Sync,
) -> Result<Yield, YieldError> {
    sampled(plan, &feeder, (&wanted, &keeps), &distance)
}

/// Says something of a run.
type Judge<'a> = &'a (dyn Fn(&Run) -> bool + Sync);

fn sampled(
    plan: &Plan,
    feeder: &(dyn Fn(&[f64]) -> Option<Feeder> + Sync),
    (wanted, keeps): (Judge<'_>, Judge<'_>),
    distance: &(dyn Fn(&[f64]) -> f64 + Sync),
) -> Result<Yield, YieldError> {
    plan.check()?;
    let samples = plan.rounded();
    let mut whole = Tally::new(plan);
    for repetition in 0..REPETITIONS {
        let Some(points) = plan.points(repetition) else { continue };
        // Parts of a fixed size, put together in their order: the number of threads changes nothing.
        let chunks: Vec<u64> = (0..samples.div_ceil(CHUNK)).collect();
        let tallies: Vec<Tally> = chunks
            .par_iter()
            .map(|chunk| {
                let mut tally = Tally::new(plan);
                for number in chunk * CHUNK..((chunk + 1) * CHUNK).min(samples) {
                    let point = points(number);
                    let feeder = feeder(&point);
                    let dropped = Dropped::of(feeder.as_ref(), plan.plate, &Options::default());
                    let good = dropped.run.as_ref().is_some_and(wanted);
                    tally.add(repetition, (&point, distance(&point)), &dropped, good);
                    tally.add_faces(
                        repetition,
                        feeder.as_ref().map(|f| f.start.face),
                        &dropped,
                        (plan.plate, good),
                    );
                    tally.keep(repetition, good && dropped.run.as_ref().is_some_and(keeps));
                }
                tally
            })
            .collect();
        tallies.into_iter().for_each(|tally| whole.take(tally));
    }
    Ok(whole.summed_up(samples))
}
