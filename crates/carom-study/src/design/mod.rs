//! Inverse design: which layout of a feeder makes drops end as wanted, and how surely.
//!
//! The search knows the layouts as a unit cube, one dimension a quantity that may be chosen. It
//!
//! 1. asks many layouts, spread evenly over the cube, what their drop does where nothing varies: which of the demands each fails;
//! 2. samples the tolerances of those that fail none ([`crate::yields`]), as they are and doubled: the second tells apart layouts that
//!    all succeed;
//! 3. looks ever closer around the best of them.
//!
//! Where no layout meets all demands, what each demand forbids is the answer: how many layouts fail it, and how near the best one comes that
//! meets all others.
//!
//! # Limits
//! A search, not a proof: a layout that works in a corner smaller than the spacing of the first look is missed.

mod judge;

pub use judge::{Demand, Judged, to_the_end};

use crate::yields::Estimate;
use carom_feeder::{Feeder, Run};
use carom_num::sobol::Sobol;
use judge::Judge;
use rayon::prelude::*;

/// What must be kept.
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
}

/// What to be best at, once all demands are met.
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
pub const ENOUGH: f64 = 0.99;

/// A layout.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    /// The feeder where nothing varies.
    pub feeder: Feeder,
    /// How high it is [m].
    pub height: f64,
    /// How wide it is [m].
    pub width: f64,
}

/// What a layout's feeder may be: one for every point of the unit cube of what varies, or none where it cannot be drawn.
pub type Varying<'a> = Box<dyn Fn(&[f64]) -> Option<Feeder> + Sync + 'a>;

/// The layouts that may be chosen.
pub trait Space: Sync {
    /// Quantities that may be chosen.
    fn dimensions(&self) -> usize;

    /// Quantities that vary.
    fn varying(&self) -> usize;

    /// The layout at a point of the unit cube; `None` where what is drawn cannot be.
    fn layout(&self, point: &[f64]) -> Option<Layout>;

    /// Does a run of the layout at a point end as wanted?
    fn met(&self, point: &[f64], run: &Run) -> bool;

    /// What a layout's feeder may be, for points of the unit cube of what varies; tolerances are `widened` so many times.
    fn varied(&self, point: &[f64], widened: f64) -> Option<Varying<'_>>;
}

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

/// A layout that meets the demands where nothing varies, with how surely it does.
#[derive(Clone, Debug, PartialEq)]
pub struct Design {
    /// Where it is in the unit cube.
    pub point: Vec<f64>,
    /// What it measures where nothing varies.
    pub judged: Judged,
    /// Share of drops that meet all demands, under the tolerances.
    pub yields: Estimate,
    /// The same with every tolerance doubled.
    pub doubled: Estimate,
}

/// What stands in the way of a demand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Forbidden {
    /// The demand.
    pub demand: Demand,
    /// Layouts of the first look that fail it.
    pub failed: u64,
    /// Those that fail it and no other.
    pub alone: u64,
    /// The nearest to it of these, in its unit; `None` where there is none, or the demand has no measure.
    pub nearest: Option<f64>,
}

/// What a search found.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// The best layout.
    pub winner: Option<Design>,
    /// Layouts none of which is worse than another in yield, height and impact speed at once, the surest first.
    pub front: Vec<Design>,
    /// What each demand forbids, by the first look.
    pub forbidden: Vec<Forbidden>,
    /// Layouts of the first look, and how many of them meet all demands.
    pub scanned: u64,
    /// How many of them meet all demands where nothing varies.
    pub met: u64,
}

/// Designs whose tolerances are sampled after the first look.
const SAMPLED: usize = 96;
/// Designs that are looked around.
const KEPT: usize = 6;
/// Looks around them, each in a box of [`SHRINK`] times the size.
const ROUNDS: u32 = 6;
/// Layouts of one look around a design.
const AROUND: u64 = 16;
/// Half the size of the first box.
const REACH: f64 = 0.15;
const SHRINK: f64 = 0.6;
/// Designs of the front that are confirmed.
const MOST_SHOWN: usize = 8;
/// Drops of a repetition while searching.
const SAMPLES: u64 = 8;

/// Searches a space; `None` where nothing may be chosen or more than there are dimensions for.
pub fn search(space: &impl Space, goal: &Goal) -> Option<Found> {
    let sobol = Sobol::new(space.dimensions(), goal.seed)?;
    let judge = Judge { space, goal };
    let scanned = goal.scanned.next_power_of_two();
    let points: Vec<Vec<f64>> = (0..scanned).map(|number| sobol.point(number)).collect();
    let judged: Vec<Judged> = points.par_iter().map(|point| judge.nominal(point)).collect();
    let forbidden = Demand::ALL.iter().map(|demand| judge.forbidden(*demand, &judged)).collect();
    let mut met: Vec<(&Vec<f64>, &Judged)> =
        points.iter().zip(&judged).filter(|(_, judged)| judged.failed.is_empty()).collect();
    let count = met.len() as u64;
    // Where something besides the yield is aimed at, what is best at it comes first.
    met.sort_by(|a, b| goal.rank(a.1).total_cmp(&goal.rank(b.1)));
    let first: Vec<Vec<f64>> = met.into_iter().take(SAMPLED).map(|(point, _)| point.clone()).collect();
    let mut designs = judge.designs(&first, SAMPLES);
    for round in 0..ROUNDS {
        sort(&mut designs, goal);
        let reach = REACH * carom_num::elementary::pow(SHRINK, f64::from(round));
        let near: Vec<Vec<f64>> = designs
            .iter()
            .take(KEPT)
            .flat_map(|design| around(&sobol, &design.point, reach, round))
            .collect();
        designs.extend(judge.designs(&near, SAMPLES));
    }
    sort(&mut designs, goal);
    let best: Vec<Vec<f64>> = front(&designs)
        .into_iter()
        .take(MOST_SHOWN)
        .chain(designs.iter().take(KEPT).cloned())
        .map(|design| design.point)
        .collect();
    let mut confirmed = judge.designs(&distinct(best), goal.confirming);
    sort(&mut confirmed, goal);
    // Of those near the least yield that suffices chance favours some: one that has it for certain goes before.
    let suffices = |design: &&Design| goal.suffices(&design.yields);
    let certain = confirmed.iter().find(|design| goal.assures(&design.yields));
    let winner = certain.or(confirmed.first().filter(suffices)).cloned();
    let mut front = front(&confirmed);
    front.sort_by(|a, b| b.yields.share.total_cmp(&a.yields.share));
    Some(Found { winner, front, forbidden, scanned, met: count })
}

/// Points in a box around one, within the cube.
fn around(sobol: &Sobol, point: &[f64], reach: f64, round: u32) -> Vec<Vec<f64>> {
    let first = (u64::from(round) + 1) << 20;
    let near = |number: u64| {
        let shift = |(x, u): (&f64, f64)| (x + (2.0 * u - 1.0) * reach).clamp(0.0, 1.0);
        point.iter().zip(sobol.point(first + number)).map(shift).collect()
    };
    (0..AROUND).map(near).collect()
}

fn distinct(points: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let mut out: Vec<Vec<f64>> = vec![];
    for point in points {
        if !out.contains(&point) {
            out.push(point);
        }
    }
    out
}

fn sort(designs: &mut [Design], goal: &Goal) {
    designs.sort_by(|a, b| {
        goal.better(a, b).then_with(|| a.point.partial_cmp(&b.point).unwrap_or(std::cmp::Ordering::Equal))
    });
}

/// Those to which no other is at least equal in yield, height and impact speed, and better in one.
fn front(designs: &[Design]) -> Vec<Design> {
    let measures = |d: &Design| [-d.yields.share, d.judged.height, d.judged.impact_speed];
    let beats = |a: &Design, b: &Design| {
        let pairs = measures(a).into_iter().zip(measures(b));
        measures(a) != measures(b) && pairs.into_iter().all(|(a, b)| a <= b)
    };
    designs.iter().filter(|design| !designs.iter().any(|other| beats(other, design))).cloned().collect()
}

impl Goal {
    /// What a layout is ranked by before its yield is known: the smaller, the better.
    fn rank(&self, judged: &Judged) -> f64 {
        match self.aim {
            Aim::Yield => -judged.margin,
            Aim::Height => judged.height,
            Aim::Time => judged.time,
        }
    }

    /// True for a yield that is enough for what is aimed at.
    pub fn suffices(&self, yields: &Estimate) -> bool {
        self.aim == Aim::Yield || yields.share >= ENOUGH
    }

    /// True where the whole interval of a yield is enough.
    fn assures(&self, yields: &Estimate) -> bool {
        self.aim == Aim::Yield || yields.low >= ENOUGH
    }

    /// The better one comes first.
    fn better(&self, a: &Design, b: &Design) -> std::cmp::Ordering {
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
