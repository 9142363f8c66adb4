//! Yield: with what probability drops end as wanted, when a feeder's quantities are not exactly what is drawn.
//!
//! The unit cube stands for everything that varies, one dimension a quantity; whoever asks turns a point of it into a feeder. Points are
//! Sobol's with Owen's scrambling ([`carom_num::sobol`]), in [`REPETITIONS`] scrambles of their own: their spread tells how sure a probability
//! is. Which point is asked depends on the seed and its number alone, so that the result does not depend on the number of threads.

mod estimate;
mod histogram;
mod located;
mod portion;
mod recirculation;
mod sensitivity;
mod surface;
mod tally;

pub use estimate::{Estimate, REPETITIONS, Spread};
pub(crate) use estimate::{FEW, wilson};
pub use histogram::Histogram;
pub use located::{Located, locate};
pub use portion::Portion;
pub use recirculation::Recirculation;
pub use sensitivity::{Contrasts, NoIndices, Sensitivity, sensitivity};
pub use tally::{PlateSpread, Transition, Worst};

use crate::device::Device;
use crate::ending::Ending;
use carom_num::sobol::{MOST_DIMENSIONS, Sobol, random};
use thiserror::Error;

/// Most samples of a repetition: 2³⁰.
const MOST_DIGITS: u32 = 30;

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
/// let nothing = |_: &[f64]| None::<carom_feeder::Feeder>;
/// assert_eq!(sample(&plan, nothing, |_| true, |_| 0.0), Err(YieldError::Dimensions { found: 0 }));
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
    /// A share of the work that there is not.
    #[error("portion {number} of {of}: they are numbered from 0")]
    Portion {
        /// Its number.
        number: u32,
        /// Of how many.
        of: u32,
    },
    /// Numbers that no [`Portion`] gave.
    #[error("these numbers are no portion of a sampling")]
    Unread,
    /// Portions of different samplings, or not all of one.
    #[error("these are not all portions of one sampling, each once")]
    Portions,
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

    /// Drops of all repetitions.
    pub fn drops(&self) -> u64 {
        self.rounded().saturating_mul(REPETITIONS as u64)
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
pub fn sample<D: Device>(
    plan: &Plan,
    feeder: impl Fn(&[f64]) -> Option<D> + Sync,
    wanted: impl Fn(&D::Run) -> bool + Sync,
    distance: impl Fn(&[f64]) -> f64 + Sync,
) -> Result<Yield, YieldError> {
    sample_within(plan, feeder, (wanted, |_: &D::Run| true), distance)
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
pub fn sample_within<D: Device>(
    plan: &Plan,
    feeder: impl Fn(&[f64]) -> Option<D> + Sync,
    (wanted, keeps): (impl Fn(&D::Run) -> bool + Sync, impl Fn(&D::Run) -> bool + Sync),
    distance: impl Fn(&[f64]) -> f64 + Sync,
) -> Result<Yield, YieldError> {
    Yield::of(vec![Portion::sampled(plan, (0, 1), feeder, (wanted, keeps), distance)?])
}
