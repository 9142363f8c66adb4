//! How throws end, and with what probability.

use crate::yields::{Estimate, Spread};

/// How a throw ends. Every throw ends in exactly one way.
///
/// # Example
/// A cube that falls flat comes to rest on its lower face; on none, where nobody says to which face its
/// corners belong.
/// ```
/// use carom_motion::spatial::{Options, State, examples};
/// use carom_num::Vec3;
/// use carom_study::poses::{Pose, thrown_in_space};
/// let (world, start) = examples::falling_cube();
/// let release = State { centre: Vec3::Z * 0.6, ..start };
/// let thrown = |face| thrown_in_space((&world, &Options::default()), &release, |_| face).pose;
/// assert_eq!((thrown(Some(0)), thrown(None)), (Pose::Face(0), Pose::NoFace));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Pose {
    /// At rest on a face.
    Face(usize),
    /// At rest on points that belong to no face together.
    NoFace,
    /// Balanced on a vertex or an edge.
    Balanced,
    /// The law has no way on.
    NoConsistentOutcome,
    /// The law has several ways on, and none is to be chosen.
    Several,
    /// It still moves at the end of the time, the steps or the impacts that it has.
    StillMoves(Spent),
    /// It could not be followed: a fault of the numbers.
    Failed,
}

impl Pose {
    /// True at rest on a face.
    pub fn is_face(self) -> bool {
        matches!(self, Self::Face(_))
    }
}

/// What a body that still moves has used up.
///
/// # Example
/// No cube falls 0.2 m in a microsecond.
/// ```
/// use carom_motion::spatial::{Options, State, examples};
/// use carom_num::Vec3;
/// use carom_study::poses::{Pose, Spent, thrown_in_space};
/// let (world, start) = examples::falling_cube();
/// let release = State { centre: Vec3::Z * 0.7, ..start };
/// let short = Options { most_time: 1e-6, ..Options::default() };
/// assert_eq!(thrown_in_space((&world, &short), &release, |_| None).pose, Pose::StillMoves(Spent::Time));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Spent {
    /// Time.
    Time,
    /// Steps of the integration.
    Steps,
    /// Impacts.
    Impacts,
}

/// One way in which throws end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Posed {
    /// Which.
    pub pose: Pose,
    /// With what probability, of all throws.
    pub probability: Estimate,
    /// Of the throws that come to rest on a face; the interval is Wilson's, of independent throws: these spread less. `None` of other ends.
    pub of_resting: Option<Estimate>,
    /// The first throw that ends so: its repetition and its number in it; `None` where none does.
    pub first: Option<(usize, u64)>,
}

/// What a sampling found.
///
/// # Example
/// A cube that falls flat from up to 0.2 m rests after at most 0.2 s (g = 10 m/s²), and strikes once. No
/// throw is lost.
/// ```
/// use carom_motion::spatial::{Options, State, examples};
/// use carom_num::Vec3;
/// use carom_study::poses::{Plan, sample, thrown_in_space};
/// let (world, start) = examples::falling_cube();
/// let throw = |u: &[f64]| {
///     let release = State { centre: Vec3::Z * (0.5 + 0.2 * u[0]), ..start };
///     thrown_in_space((&world, &Options::default()), &release, |_| Some(0))
/// };
/// let found = sample(&Plan { dimensions: 1, throws: 4, seed: 1 }, throw, &[0, 1], || ())?;
/// assert_eq!((found.throws, found.resting.count), (16 * 4, 16 * 4));
/// assert!(found.time.unwrap().high < 0.2);
/// let impacts = found.impacts.unwrap();
/// assert_eq!((impacts.low, impacts.high), (1.0, 1.0));
/// # Ok::<(), carom_study::poses::PosesError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Poses {
    /// Every face that was asked about and every other end that came up: faces in their order, then the others.
    pub ends: Vec<Posed>,
    /// With what probability a throw comes to rest on a face.
    pub resting: Estimate,
    /// When those come to rest \[s\].
    pub time: Option<Spread>,
    /// Their impacts.
    pub impacts: Option<Spread>,
    /// Throws.
    pub throws: u64,
}
