//! A sampling in portions, which several machines may count: put together they say what one machine would have said, to the last digit.

use super::estimate::REPETITIONS;
use super::tally::Tally;
use super::{Plan, Points, Yield, YieldError};
use crate::device::Device;
use crate::ending::Dropped;
use crate::packed::{Packed, packed};
use rayon::prelude::*;
use std::ops::Range;
use std::slice::Iter;

/// Samples that one thread takes at once.
const CHUNK: u64 = 256;

/// Which portion of what: the plan, the samples of each repetition, the portion's number, and how many there are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Whose {
    pub(super) plan: Plan,
    pub(super) samples: u64,
    pub(super) number: u32,
    pub(super) of: u32,
}

packed!(Plan { dimensions, samples, seed, points, plates, plate });
packed!(Whose { plan, samples, number, of });

impl Packed for Points {
    fn pack(&self, words: &mut Vec<u64>) {
        u64::from(*self == Self::Random).pack(words);
    }

    fn unpack(words: &mut Iter<'_, u64>) -> Option<Self> {
        match words.next()? {
            0 => Some(Self::Sobol),
            1 => Some(Self::Random),
            _ => None,
        }
    }
}

impl Whose {
    /// What this portion has of a number of pieces of work.
    pub(super) fn share(&self, pieces: u64) -> Range<u64> {
        let upto = |number: u64| (u128::from(pieces) * u128::from(number) / u128::from(self.of)) as u64;
        upto(u64::from(self.number))..upto(u64::from(self.number) + 1)
    }

    /// Puts portions in their order; false where they are not all of one whole, each once.
    pub(super) fn order<P>(portions: &mut [P], whose: impl Fn(&P) -> &Self) -> bool {
        portions.sort_by_key(|portion| whose(portion).number);
        let Some(first) = portions.first().map(|portion| *whose(portion)) else { return false };
        let in_place = |(k, portion): (usize, &P)| {
            u32::try_from(k).is_ok_and(|number| *whose(portion) == Self { number, ..first })
        };
        first.of as usize == portions.len() && portions.iter().enumerate().all(in_place)
    }
}

/// The counts of one portion of a sampling's drops. As whole numbers they can be sent to where all portions are put together.
///
/// # Example
/// Two machines count half of the drops each.
/// ```
/// use carom_feeder::{Outcome, Run, examples};
/// use carom_study::yields::{Plan, Points, Portion, Yield, sample};
/// let plan = Plan { dimensions: 1, samples: 4, seed: 1, points: Points::Sobol, plates: 1, plate: 0 };
/// let varied = |u: &[f64]| Some(examples::rod_on_a_slope(0.5 + 0.5 * u[0]));
/// let held = |run: &Run| run.outcome == Outcome::Stuck;
/// let all = |_: &Run| true;
/// let sent = Portion::sampled(&plan, (1, 2), varied, (held, all), |_| 0.0)?.to_words();
/// let own = Portion::sampled(&plan, (0, 2), varied, (held, all), |_| 0.0)?;
/// let found = Yield::of(vec![Portion::of_words(&sent)?, own])?;
/// assert_eq!(found, sample(&plan, varied, held, |_| 0.0)?);
/// # Ok::<(), carom_study::yields::YieldError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Portion {
    whose: Whose,
    tally: Tally,
}

packed!(Portion { whose, tally });

/// Says something of a run.
type Judge<'a, R> = &'a (dyn Fn(&R) -> bool + Sync);

impl Portion {
    /// Drops a portion of what the plan asks for: `number` of `of` portions, from 0. All else as in [`sample_within`](super::sample_within).
    ///
    /// # Errors
    /// [`YieldError`]: a plan that cannot be followed, a number that is not below `of`.
    pub fn sampled<D: Device>(
        plan: &Plan,
        (number, of): (u32, u32),
        feeder: impl Fn(&[f64]) -> Option<D> + Sync,
        (wanted, keeps): (impl Fn(&D::Run) -> bool + Sync, impl Fn(&D::Run) -> bool + Sync),
        distance: impl Fn(&[f64]) -> f64 + Sync,
    ) -> Result<Self, YieldError> {
        plan.check()?;
        if number >= of {
            return Err(YieldError::Portion { number, of });
        }
        let whose = Whose { plan: *plan, samples: plan.rounded(), number, of };
        Ok(Self { whose, tally: counted(&whose, &feeder, (&wanted, &keeps), &distance) })
    }

    /// The plan of the whole sampling.
    pub fn plan(&self) -> &Plan {
        &self.whose.plan
    }

    /// The counts as whole numbers.
    pub fn to_words(&self) -> Vec<u64> {
        self.sealed()
    }

    /// The counts that [`Portion::to_words`] gave.
    ///
    /// # Errors
    /// [`YieldError::Unread`]: numbers that are no portion.
    pub fn of_words(words: &[u64]) -> Result<Self, YieldError> {
        let read = Self::unsealed(words).filter(|portion| {
            let Whose { plan, samples, number, of } = portion.whose;
            let planned = plan.check().is_ok() && plan.rounded() == samples && number < of;
            planned && portion.tally.fits(plan.plates)
        });
        read.ok_or(YieldError::Unread)
    }
}

impl Yield {
    /// What all portions of a sampling say together, whoever counted them and in whatever order they come.
    ///
    /// # Errors
    /// [`YieldError::Portions`]: portions of different samplings, one twice, or not all of them.
    pub fn of(mut portions: Vec<Portion>) -> Result<Self, YieldError> {
        if !Whose::order(&mut portions, |portion| &portion.whose) {
            return Err(YieldError::Portions);
        }
        let plan = portions[0].whose.plan;
        let mut whole = Tally::new(&plan);
        portions.into_iter().for_each(|portion| whole.take(portion.tally));
        Ok(whole.summed_up(plan.rounded()))
    }
}

fn counted<D: Device>(
    whose: &Whose,
    feeder: &(dyn Fn(&[f64]) -> Option<D> + Sync),
    (wanted, keeps): (Judge<'_, D::Run>, Judge<'_, D::Run>),
    distance: &(dyn Fn(&[f64]) -> f64 + Sync),
) -> Tally {
    let (plan, samples) = (whose.plan, whose.samples);
    let points: Vec<_> = (0..REPETITIONS).map(|repetition| plan.points(repetition)).collect();
    let chunks = samples.div_ceil(CHUNK);
    // Chunks of a fixed size, put together in their order: neither the number of threads nor that of portions changes anything.
    let pieces: Vec<u64> = whose.share(chunks * REPETITIONS as u64).collect();
    let tally = |piece: &u64| {
        let (repetition, chunk) = ((piece / chunks) as usize, piece % chunks);
        let mut tally = Tally::new(&plan);
        let Some(points) = &points[repetition] else { return tally };
        for number in chunk * CHUNK..((chunk + 1) * CHUNK).min(samples) {
            let point = points(number);
            let feeder = feeder(&point);
            let dropped = Dropped::through(feeder.as_ref(), plan.plate);
            let good = dropped.run.as_ref().is_some_and(wanted);
            let start = feeder.as_ref().map(Device::start_face);
            tally.add(repetition, (&point, distance(&point)), &dropped, good);
            tally.add_faces(repetition, start, &dropped, (plan.plate, good));
            tally.keep(repetition, good && dropped.run.as_ref().is_some_and(keeps));
        }
        tally
    };
    let mut whole = Tally::new(&plan);
    // So many at a time that counts which wait to be put together take little memory.
    for some in pieces.chunks(1024) {
        let tallies: Vec<Tally> = some.par_iter().panic_fuse().map(tally).collect();
        tallies.into_iter().for_each(|tally| whole.take(tally));
    }
    whole
}
