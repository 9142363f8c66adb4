//! What is asked of a design.

use super::{Design, Judged};
use crate::yields::Estimate;

/// What must be kept.
///
/// # Example
/// Nothing is limited where nothing is said.
/// ```
/// use carom_study::design::{Demand, Limits};
/// assert!(Demand::ALL.iter().all(|demand| Limits::default().of(*demand).is_none()));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Limits {
    /// Highest speed of a strike on a plate [m/s].
    pub impact_speed: Option<f64>,
    /// Highest slip velocity [m/s].
    pub sliding_speed: Option<f64>,
    /// Highest feeder [m].
    pub height: Option<f64>,
    /// Widest feeder [m].
    pub width: Option<f64>,
    /// Longest time [s].
    pub time: Option<f64>,
    /// True where the part may touch no wall.
    pub no_wall: bool,
}

/// What to be best at, once all demands are met.
///
/// # Example
/// Whoever aims at height or time must reach a yield of 0.99; whoever aims at yield takes the best there is.
/// ```
/// use carom_study::{design::{Aim, Goal, Limits}, yields::Estimate};
/// let half = Estimate { share: 0.5, low: 0.4, high: 0.6, count: 128 };
/// let of = |aim| Goal { limits: Limits::default(), aim, seed: 1, scanned: 16, confirming: 1 };
/// assert!(of(Aim::Yield).suffices(&half) && !of(Aim::Height).suffices(&half));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Aim {
    /// The largest share of drops that meet the demands.
    #[default]
    Yield,
    /// The lowest feeder whose yield is at least [`ENOUGH`].
    Height,
    /// The quickest one whose yield is at least [`ENOUGH`].
    Time,
}

/// A layout that aims at height or time must have at least this yield.
///
/// # Example
/// One drop in a hundred may fail.
/// ```
/// use carom_study::{design::{Aim, ENOUGH, Goal, Limits}, yields::Estimate};
/// let goal = Goal { limits: Limits::default(), aim: Aim::Time, seed: 1, scanned: 16, confirming: 1 };
/// let yields = |count: u64| Estimate { share: count as f64 / 100.0, low: 0.9, high: 1.0, count };
/// assert_eq!(ENOUGH, 0.99);
/// assert!(goal.suffices(&yields(99)) && !goal.suffices(&yields(98)));
/// ```
pub const ENOUGH: f64 = 0.99;

/// What is asked of a design.
#[derive(Clone, Copy, Debug)]
pub struct Goal {
    /// What must be kept.
    pub limits: Limits,
    /// What to be best at.
    pub aim: Aim,
    /// Every random number comes from it.
    pub seed: u64,
    /// Layouts of the first look.
    pub scanned: u64,
    /// Drops of each of the 16 repetitions for the designs that are reported.
    pub confirming: u64,
}

impl Goal {
    /// What a layout is ranked by before its yield is known: the smaller, the better.
    pub(super) fn rank(&self, judged: &Judged) -> f64 {
        match self.aim {
            Aim::Yield => -judged.margin,
            Aim::Height => judged.height,
            Aim::Time => judged.time,
        }
    }

    /// True for a yield that is enough for what is aimed at.
    ///
    /// # Example
    /// ```
    /// use carom_study::{design::{Aim, Goal, Limits}, yields::Estimate};
    /// let goal = Goal { limits: Limits::default(), aim: Aim::Height, seed: 1, scanned: 16, confirming: 1 };
    /// let sure = Estimate { share: 1.0, low: 0.99, high: 1.0, count: 256 };
    /// assert!(goal.suffices(&sure) && !goal.suffices(&Estimate { share: 0.98, ..sure }));
    /// ```
    pub fn suffices(&self, yields: &Estimate) -> bool {
        self.aim == Aim::Yield || yields.share >= ENOUGH
    }

    /// True where the whole interval of a yield is enough.
    pub(super) fn assures(&self, yields: &Estimate) -> bool {
        self.aim == Aim::Yield || yields.low >= ENOUGH
    }

    /// The better one comes first.
    pub(super) fn better(&self, a: &Design, b: &Design) -> std::cmp::Ordering {
        let surer =
            || b.yields.share.total_cmp(&a.yields.share).then(b.doubled.share.total_cmp(&a.doubled.share));
        match self.aim {
            Aim::Yield => surer(),
            Aim::Height | Aim::Time => match (self.suffices(&a.yields), self.suffices(&b.yields)) {
                (true, true) => self.rank(&a.judged).total_cmp(&self.rank(&b.judged)).then_with(surer),
                (false, false) => surer(),
                (a, b) => b.cmp(&a),
            },
        }
    }
}
