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
///
/// # Example
/// The number of layouts of the first look is rounded up to a power of two.
/// ```
/// # use {carom_feeder::*, carom_impact::planar::Law, carom_motion::planar::Options, carom_num::Vec2};
/// # let slope = |friction: f64| Feeder {
/// #     gravity: 10.0, stop: Stop::Delivered, law: Law::Poisson, walls: vec![],
/// #     part: Part::rod(0.1, 0.3, 2.5e-4).unwrap(),
/// #     start: Start { to_edge: 2.0, speed: 0.0, face: 0 },
/// #     plates: vec![Plate {
/// #         name: "slope".into(), uphill: Vec2::new(-4.0, 3.0), edge: Vec2::ZERO,
/// #         friction, restitution: 0.0, unbounded: false,
/// #     }],
/// # };
/// # use carom_study::design::*;
/// # struct Friction<F>(F);
/// # impl<F: Fn(f64) -> Feeder + Sync> Space for Friction<F> {
/// #     fn dimensions(&self) -> usize { 1 }
/// #     fn varying(&self) -> usize { 1 }
/// #     fn layout(&self, point: &[f64]) -> Option<Layout> {
/// #         Some(Layout { feeder: (self.0)(point[0]), height: 3.0, width: 4.0 })
/// #     }
/// #     fn met(&self, _: &[f64], run: &Run) -> bool { run.outcome == Outcome::Stuck }
/// #     fn varied(&self, _: &[f64], _: f64) -> Option<Varying<'_>> { None }
/// # }
/// let goal = Goal { limits: Limits::default(), aim: Aim::Yield, seed: 1, scanned: 13, confirming: 1 };
/// assert_eq!(search(&Friction(slope), &goal).unwrap().scanned, 16);
/// ```
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
