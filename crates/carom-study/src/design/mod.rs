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

pub mod examples;
mod goal;
mod judge;
mod space;
mod worst;

pub use goal::{Aim, ENOUGH, Goal, Limits};
pub use judge::{Demand, Judged};
pub use space::{Layout, Looked, Space, Varying};
pub use worst::{Extremes, Worst};

use crate::device::Device;
use crate::yields::Estimate;
use carom_num::sobol::Sobol;
use judge::Judge;
use rayon::prelude::*;

/// A layout that meets the demands where nothing varies, with how surely it does.
///
/// # Example
/// Where nothing has a tolerance, what works works always. Of those that hold a rod on a slope of 3 in 4 the
/// one with the most friction has the largest margin, `(μ − 3/4)/(μ + 3/4)`.
/// ```
/// use carom_study::design::examples::FrictionOfASlope;
/// use carom_study::design::{Aim, Goal, Limits, search};
/// let goal = Goal { limits: Limits::default(), aim: Aim::Yield, seed: 1, scanned: 16, confirming: 1 };
/// let design = search(&FrictionOfASlope, &goal).unwrap().winner.unwrap();
/// let friction = design.point[0];
/// assert_eq!((design.yields.share, design.doubled.share), (1.0, 1.0));
/// assert!((design.judged.margin - (friction - 0.75) / (friction + 0.75)).abs() < 1e-12);
/// ```
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
///
/// # Example
/// Of 16 frictions from 0 to 1, spread evenly, 12 do not hold a rod on a slope of 3 in 4.
/// ```
/// use carom_study::design::examples::FrictionOfASlope;
/// use carom_study::design::{Aim, Demand, Goal, Limits, search};
/// let goal = Goal { limits: Limits::default(), aim: Aim::Yield, seed: 1, scanned: 16, confirming: 1 };
/// let found = search(&FrictionOfASlope, &goal).unwrap();
/// let wanted = found.forbidden.iter().find(|forbidden| forbidden.demand == Demand::Wanted).unwrap();
/// assert_eq!((wanted.failed, wanted.alone, wanted.nearest), (12, 12, None));
/// ```
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
///
/// # Example
/// Every layout of the first look either meets the demands or fails one.
/// ```
/// use carom_study::design::examples::FrictionOfASlope;
/// use carom_study::design::{Aim, Goal, Limits, search};
/// let goal = Goal { limits: Limits::default(), aim: Aim::Yield, seed: 1, scanned: 16, confirming: 1 };
/// let found = search(&FrictionOfASlope, &goal).unwrap();
/// let failed = found.forbidden.iter().map(|forbidden| forbidden.alone).sum::<u64>();
/// assert_eq!((found.scanned, found.met + failed), (16, 16));
/// ```
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

/// How many drops a search takes: a drop in space costs a hundred times one in the plane.
///
/// # Example
/// ```
/// use carom_study::design::Pace;
/// assert!(Pace::IN_SPACE.sampled < Pace::IN_THE_PLANE.sampled);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pace {
    /// Layouts of the first look, where nobody asks for another number.
    pub scanned: u64,
    /// Designs whose tolerances are sampled after the first look.
    pub sampled: usize,
    /// Designs that are looked around.
    pub kept: usize,
    /// Looks around them, each in a smaller box.
    pub rounds: u32,
    /// Layouts of one look around a design.
    pub around: u64,
    /// Drops of each of the 16 repetitions while searching.
    pub samples: u64,
    /// The same for the designs that are compared in the end, at most.
    pub confirming: u64,
    /// Drops that confirm the winner, where nobody asks for another number.
    pub winner: u64,
}

impl Pace {
    /// Some 200 000 drops.
    pub const IN_THE_PLANE: Self = Self {
        scanned: 4096,
        sampled: 96,
        kept: 6,
        rounds: 6,
        around: 16,
        samples: 8,
        confirming: 256,
        winner: 16_384,
    };
    /// Some 10 000 drops. Yields are told apart by sixteenths while searching: what is close is decided by the confirming drops.
    pub const IN_SPACE: Self = Self {
        scanned: 512,
        sampled: 24,
        kept: 3,
        rounds: 4,
        around: 8,
        samples: 1,
        confirming: 8,
        winner: 1024,
    };

    /// Looks in all: the first, the sampling of its best, those around them, the confirming of the best.
    const fn looks(&self) -> u32 {
        self.rounds + 3
    }
}

/// Half the size of the first box.
const REACH: f64 = 0.15;
const SHRINK: f64 = 0.6;
/// Designs of the front that are confirmed.
const MOST_SHOWN: usize = 8;

/// Searches a space at the pace of its feeders; `None` where nothing may be chosen or more than there are dimensions for.
///
/// # Example
/// A rod on a slope of 3 in 4 is held from a friction of 3/4 on.
/// ```
/// use carom_study::design::examples::FrictionOfASlope;
/// use carom_study::design::{Aim, Goal, Limits, search};
/// let goal = Goal { limits: Limits::default(), aim: Aim::Yield, seed: 1, scanned: 16, confirming: 1 };
/// let found = search(&FrictionOfASlope, &goal).unwrap();
/// assert!(found.winner.unwrap().point[0] >= 0.75);
/// assert!(found.front.iter().all(|design| design.point[0] >= 0.75));
/// ```
pub fn search<S: Space>(space: &S, goal: &Goal) -> Option<Found> {
    let pace = S::Feeder::PACE;
    let sobol = Sobol::new(space.dimensions(), goal.seed)?;
    let judge = Judge { space, goal };
    let scanned = goal.scanned.next_power_of_two();
    let points: Vec<Vec<f64>> = (0..scanned).map(|number| sobol.point(number)).collect();
    let judged: Vec<Judged> = points.par_iter().panic_fuse().map(|point| judge.nominal(point)).collect();
    let forbidden = Demand::ALL.iter().map(|demand| judge.forbidden(*demand, &judged)).collect();
    let mut met: Vec<(&Vec<f64>, &Judged)> =
        points.iter().zip(&judged).filter(|(_, judged)| judged.failed.is_empty()).collect();
    let count = met.len() as u64;
    // Where something besides the yield is aimed at, what is best at it comes first.
    met.sort_by(|a, b| goal.rank(a.1).total_cmp(&goal.rank(b.1)));
    let first: Vec<Vec<f64>> = met.into_iter().take(pace.sampled).map(|(point, _)| point.clone()).collect();
    let mut look = 0;
    let mut looked = |best: Option<&Design>| {
        look += 1;
        space.looked(&Looked { look, looks: pace.looks(), best });
    };
    looked(None);
    let mut designs = judge.designs(&first, pace.samples);
    sort(&mut designs, goal);
    looked(designs.first());
    for round in 0..pace.rounds {
        let reach = REACH * carom_num::elementary::pow(SHRINK, f64::from(round));
        let near: Vec<Vec<f64>> = designs
            .iter()
            .take(pace.kept)
            .flat_map(|design| around(&sobol, &design.point, reach, (round, pace.around)))
            .collect();
        designs.extend(judge.designs(&near, pace.samples));
        sort(&mut designs, goal);
        looked(designs.first());
    }
    let best: Vec<Vec<f64>> = front(&designs)
        .into_iter()
        .take(MOST_SHOWN)
        .chain(designs.iter().take(pace.kept).cloned())
        .map(|design| design.point)
        .collect();
    let mut confirmed = judge.designs(&distinct(best), goal.confirming);
    sort(&mut confirmed, goal);
    looked(confirmed.first());
    // Of those near the least yield that suffices chance favours some: one that has it for certain goes before.
    let suffices = |design: &&Design| goal.suffices(&design.yields);
    let certain = confirmed.iter().find(|design| goal.assures(&design.yields));
    let winner = certain.or(confirmed.first().filter(suffices)).cloned();
    let mut front = front(&confirmed);
    front.sort_by(|a, b| b.yields.share.total_cmp(&a.yields.share));
    Some(Found { winner, front, forbidden, scanned, met: count })
}

/// Points in a box around one, within the cube.
fn around(sobol: &Sobol, point: &[f64], reach: f64, (round, count): (u32, u64)) -> Vec<Vec<f64>> {
    let first = (u64::from(round) + 1) << 20;
    let near = |number: u64| {
        let shift = |(x, u): (&f64, f64)| (x + (2.0 * u - 1.0) * reach).clamp(0.0, 1.0);
        point.iter().zip(sobol.point(first + number)).map(shift).collect()
    };
    (0..count).map(near).collect()
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
