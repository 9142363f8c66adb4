//! Poses: with what probability a body that is thrown on a plane comes to rest on which of its faces.
//!
//! The unit cube stands for what varies from throw to throw, the attitude first; whoever asks turns a point of it into a release. Points are those of
//! [`yields`](crate::yields): Sobol's, scrambled in [`REPETITIONS`] ways, each known from the seed and its number, so that the result does not depend on the
//! number of threads.

mod ends;
mod planar;
mod spatial;

pub use ends::{Pose, Posed, Poses, Spent};
pub use planar::thrown_in_plane;
pub use spatial::thrown_in_space;

use crate::yields::{Estimate, REPETITIONS, Spread, wilson};
use carom_num::sobol::Sobol;
use carom_num::{Rotation, Vec3};
use rayon::prelude::*;
use std::collections::BTreeMap;
use thiserror::Error;

/// Most throws of a repetition.
const MOST: u64 = 1 << 24;
/// Throws that one thread takes at once.
const CHUNK: u64 = 16;

/// What is sampled.
///
/// # Example
/// A throw is known from the seed, its repetition and its number.
/// ```
/// use carom_study::poses::Plan;
/// let plan = Plan { dimensions: 3, throws: 100, seed: 7 };
/// assert_eq!(plan.point(2, 40), plan.point(2, 40));
/// assert_ne!(plan.point(2, 40), Plan { seed: 8, ..plan }.point(2, 40));
/// assert!(plan.point(2, 40).iter().all(|u| (0.0..1.0).contains(u)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Plan {
    /// Quantities that vary: coordinates of a point.
    pub dimensions: usize,
    /// Throws of each repetition: rounded up to a power of two.
    pub throws: u64,
    /// Every random number comes from it.
    pub seed: u64,
}

/// Why nothing was sampled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum PosesError {
    /// Nothing varies, or more than there are dimensions for.
    #[error("{found} quantities vary: 1 to {} are allowed", carom_num::sobol::MOST_DIMENSIONS)]
    Dimensions {
        /// How many.
        found: usize,
    },
    /// No throws, or too many.
    #[error("{found} throws a repetition: 1 to {most} are allowed")]
    Throws {
        /// How many.
        found: u64,
        /// How many there may be.
        most: u64,
    },
}

/// How one throw ended.
///
/// # Example
/// See [`thrown_in_plane`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thrown {
    /// How.
    pub pose: Pose,
    /// When \[s\].
    pub time: f64,
    /// Impacts until then.
    pub impacts: u64,
}

impl Thrown {
    /// It could not be followed.
    pub const LOST: Self = Self { pose: Pose::Failed, time: 0.0, impacts: 0 };
}

/// A throw with the repetition that it is of, and its number there.
struct Numbered {
    repetition: usize,
    number: u64,
    thrown: Thrown,
}

impl Plan {
    /// Throws of a repetition, as they are made.
    ///
    /// # Example
    /// ```
    /// use carom_study::poses::Plan;
    /// assert_eq!(Plan { dimensions: 3, throws: 100, seed: 7 }.rounded(), 128);
    /// ```
    pub fn rounded(&self) -> u64 {
        self.throws.next_power_of_two()
    }

    /// A point of the unit cube, by repetition and number.
    ///
    /// # Panics
    /// Never: a plan with more dimensions than there are gives a point without coordinates.
    ///
    /// # Example
    /// Of 2ᵏ points of a repetition half lie in the lower half of each coordinate.
    /// ```
    /// use carom_study::poses::Plan;
    /// let plan = Plan { dimensions: 3, throws: 64, seed: 7 };
    /// let low = (0..64).filter(|number| plan.point(0, *number)[1] < 0.5).count();
    /// assert_eq!(low, 32);
    /// ```
    pub fn point(&self, repetition: usize, number: u64) -> Vec<f64> {
        let seed = self.seed.wrapping_mul(REPETITIONS as u64).wrapping_add(repetition as u64);
        Sobol::new(self.dimensions, seed).map_or(vec![], |sobol| sobol.point(number))
    }

    fn check(&self) -> Result<(), PosesError> {
        if Sobol::new(self.dimensions, 0).is_none() {
            return Err(PosesError::Dimensions { found: self.dimensions });
        }
        if !(1..=MOST).contains(&self.throws) {
            return Err(PosesError::Throws { found: self.throws, most: MOST });
        }
        Ok(())
    }
}

/// The rotation at three coordinates of the unit cube: where those are uniform, every attitude is as probable as any other.
///
/// # Source
/// K. Shoemake, Uniform random rotations, Graphics Gems III (1992) 124.
///
/// # Example
/// ```
/// use carom_study::poses::attitude;
/// let turned = attitude([1.0, 0.3, 0.0]);
/// assert!((turned.w - 1.0).abs() < 1e-15, "no turn: {turned:?}");
/// ```
pub fn attitude([share, first, second]: [f64; 3]) -> Rotation {
    let tau = std::f64::consts::TAU;
    let (outer, inner) = ((1.0 - share).max(0.0).sqrt(), share.max(0.0).sqrt());
    let (s, c) = carom_num::elementary::sin_cos(tau * first);
    let (sin, cos) = carom_num::elementary::sin_cos(tau * second);
    Rotation { w: inner * cos, v: Vec3::new(outer * s, outer * c, inner * sin) }
}

/// The direction at two coordinates of the unit square: where those are uniform, every direction is as probable as any other (Archimedes).
///
/// # Example
/// From straight up, over a point of the equator, to straight down.
/// ```
/// use carom_num::Vec3;
/// use carom_study::poses::direction;
/// assert_eq!([0.0, 0.5, 1.0].map(|height| direction([height, 0.0])), [Vec3::Z, Vec3::X, -Vec3::Z]);
/// ```
pub fn direction([height, turn]: [f64; 2]) -> Vec3 {
    let z = 1.0 - 2.0 * height;
    let across = (1.0 - z * z).max(0.0).sqrt();
    let (sin, cos) = carom_num::elementary::sin_cos(std::f64::consts::TAU * turn);
    Vec3::new(across * cos, across * sin, z)
}

/// Throws a body: `throw` follows the one at a point of the unit cube to its end, `done` is called after every throw. The faces `asked` about are in
/// the result even where no throw comes to rest on them.
///
/// # Errors
/// [`PosesError`].
///
/// # Limits
/// Intervals as those of [`yields::sample`](crate::yields::sample). Forty bytes of every throw are kept until all are made.
///
/// # Example
/// A cube that falls flat from up to 0.2 m comes to rest on its lower face, and never on the upper one.
/// ```
/// use carom_motion::spatial::{Options, State, Supports, examples};
/// use carom_num::Vec3;
/// use carom_study::poses::{Plan, Pose, sample, thrown_in_space};
/// let (world, start) = examples::falling_cube();
/// let below = |held: Supports| (held.len() == 4).then_some(0);
/// let throw = |u: &[f64]| {
///     let release = State { centre: Vec3::Z * (0.5 + 0.2 * u[0]), ..start };
///     thrown_in_space((&world, &Options::default()), &release, below)
/// };
/// let found = sample(&Plan { dimensions: 1, throws: 4, seed: 1 }, throw, &[0, 1], || ())?;
/// let shares: Vec<_> = found.ends.iter().map(|end| (end.pose, end.probability.share)).collect();
/// assert_eq!(shares, [(Pose::Face(0), 1.0), (Pose::Face(1), 0.0)]);
/// # Ok::<(), carom_study::poses::PosesError>(())
/// ```
pub fn sample(
    plan: &Plan,
    throw: impl Fn(&[f64]) -> Thrown + Sync,
    asked: &[usize],
    done: impl Fn() + Sync,
) -> Result<Poses, PosesError> {
    plan.check()?;
    let samples = plan.rounded();
    let chunks = samples.div_ceil(CHUNK);
    let all: Vec<u64> = (0..chunks * REPETITIONS as u64).collect();
    let thrown: Vec<Vec<Numbered>> = all
        .par_iter()
        .panic_fuse()
        .map(|place| {
            let (repetition, chunk) = ((place / chunks) as usize, place % chunks);
            let numbers = chunk * CHUNK..((chunk + 1) * CHUNK).min(samples);
            let one = |number| {
                let thrown = throw(&plan.point(repetition, number));
                done();
                Numbered { repetition, number, thrown }
            };
            numbers.map(one).collect()
        })
        .collect();
    Ok(summed_up(thrown.into_iter().flatten().collect(), samples, asked))
}

/// Counts of an end by repetition, and the first throw that has it.
#[derive(Default)]
struct Count {
    by_repetition: [u64; REPETITIONS],
    first: Option<(usize, u64)>,
}

fn summed_up(throws: Vec<Numbered>, samples: u64, asked: &[usize]) -> Poses {
    let mut counts: BTreeMap<Pose, Count> =
        asked.iter().map(|face| (Pose::Face(*face), Count::default())).collect();
    let mut resting = [0; REPETITIONS];
    for throw in &throws {
        let count = counts.entry(throw.thrown.pose).or_default();
        count.by_repetition[throw.repetition] += 1;
        count.first = count.first.or(Some((throw.repetition, throw.number)));
        if throw.thrown.pose.is_face() {
            resting[throw.repetition] += 1;
        }
    }
    let rest: u64 = resting.iter().sum();
    let ends = counts.iter().map(|(pose, count)| {
        let probability = Estimate::of(&count.by_repetition, samples);
        let is_face = pose.is_face();
        // How many throws rest differs between repetitions. Wilson's interval takes all throws as independent, which is on the safe side: these spread less.
        let of_resting = (is_face && rest > 0).then(|| among(probability.count, rest));
        Posed { pose: *pose, probability, of_resting, first: count.first }
    });
    let measured = |of: &dyn Fn(&Thrown) -> f64| {
        let at_rest = throws.iter().map(|t| &t.thrown).filter(|t| t.pose.is_face());
        Spread::of(at_rest.map(of).collect())
    };
    Poses {
        ends: ends.collect(),
        resting: Estimate::of(&resting, samples),
        time: measured(&|t| t.time),
        impacts: measured(&|t| t.impacts as f64),
        throws: throws.len() as u64,
    }
}

/// A share of so many independent throws.
fn among(count: u64, whole: u64) -> Estimate {
    let share = count as f64 / whole as f64;
    let [low, high] = wilson(share, whole as f64);
    Estimate { share, low: low.clamp(0.0, share), high: high.clamp(share, 1.0), count }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn attitudes_and_directions_are_uniform() {
        // The mean of every entry of a uniform rotation is 0, that of its square 1/3; so of a direction. Sobol's points come close.
        let plan = Plan { dimensions: 5, throws: 1 << 12, seed: 7 };
        let (mut first, mut second, mut place) = ([0.0; 9], [0.0; 9], Vec3::ZERO);
        for number in 0..plan.throws {
            let point = plan.point(3, number);
            let matrix = attitude([point[0], point[1], point[2]]).matrix();
            let entries: Vec<f64> = matrix.rows.iter().flat_map(|row| row.to_array()).collect();
            for k in 0..9 {
                first[k] += entries[k] / 4096.0;
                second[k] += entries[k] * entries[k] / 4096.0;
            }
            let way = direction([point[3], point[4]]);
            assert!((way.norm() - 1.0).abs() < 1e-15, "{way:?}");
            place += way / 4096.0;
        }
        assert!(first.iter().all(|m| m.abs() < 2e-3), "{first:?}");
        assert!(second.iter().all(|m| (m - 1.0 / 3.0).abs() < 2e-3), "{second:?}");
        assert!(place.norm() < 2e-3, "{place:?}");
    }
}
