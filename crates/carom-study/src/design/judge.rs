//! Which demands a layout meets, and how surely.

use super::{Design, Forbidden, Goal, Limits, Space};
use crate::device::{Device, Landed};
use crate::ending::Dropped;
use crate::yields::{Estimate, Plan, Points, sample};
use carom_feeder::Outcome;
use rayon::prelude::*;

/// One of the demands on a design.
///
/// # Example
/// A disc that strikes with 7 m/s fails a limit of 5 m/s, and only that.
/// ```
/// use carom_feeder::examples;
/// use carom_study::design::{Aim, Demand, Goal, Limits};
/// let feeder = examples::disc_above_a_tray();
/// let limits = Limits { impact_speed: Some(5.0), ..Limits::default() };
/// let goal = Goal { limits, aim: Aim::Yield, seed: 1, scanned: 16, confirming: 1 };
/// let run = feeder.run_untraced().unwrap();
/// assert_eq!(goal.judged(&feeder, [13.0, 4.262], &run, true).failed, [Demand::ImpactSpeed]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Demand {
    /// It can be drawn.
    Drawable,
    /// No two plates cross.
    Clear,
    /// The drop ends as wanted on every plate.
    Wanted,
    /// It strikes no harder than allowed.
    ImpactSpeed,
    /// It slides no faster than allowed.
    SlidingSpeed,
    /// The feeder is no higher than allowed.
    Height,
    /// The feeder is no wider than allowed.
    Width,
    /// It takes no longer than allowed.
    Time,
    /// It touches no wall.
    Walls,
    /// What follows does not jam it. Asked only where all else is met.
    ComesOut,
}

impl Demand {
    /// All of them.
    ///
    /// # Example
    /// Each once, in their order.
    /// ```
    /// use carom_study::design::Demand;
    /// assert!(Demand::ALL.windows(2).all(|pair| pair[0] < pair[1]));
    /// assert_eq!((Demand::ALL[0], Demand::ALL[9]), (Demand::Drawable, Demand::ComesOut));
    /// ```
    pub const ALL: [Self; 10] = [
        Self::Drawable,
        Self::Clear,
        Self::Wanted,
        Self::ImpactSpeed,
        Self::SlidingSpeed,
        Self::Height,
        Self::Width,
        Self::Time,
        Self::Walls,
        Self::ComesOut,
    ];
}

/// What a layout measures where nothing varies.
///
/// # Example
/// A disc slides 2 m down at 6 m/s², then falls 1.25 m: it strikes with `√(2·6·2 + 2·10·1.25)`, 7 m/s.
/// ```
/// use carom_feeder::examples;
/// use carom_study::design::{Aim, Goal, Limits};
/// let feeder = examples::disc_above_a_tray();
/// let goal = Goal { limits: Limits::default(), aim: Aim::Yield, seed: 1, scanned: 16, confirming: 1 };
/// let judged = goal.judged(&feeder, [13.0, 4.262], &feeder.run_untraced().unwrap(), true);
/// assert!((judged.impact_speed - 7.0).abs() < 1e-12 && judged.failed.is_empty());
/// assert_eq!((judged.width, judged.height), (13.0, 4.262));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Judged {
    /// The demands that it fails.
    pub failed: Vec<Demand>,
    /// The hardest strike on a plate, the first or a later one [m/s].
    pub impact_speed: f64,
    /// The largest slip velocity on a plate [m/s].
    pub sliding_speed: f64,
    /// How high it is [m].
    pub height: f64,
    /// How wide it is [m].
    pub width: f64,
    /// When the run ends [s].
    pub time: f64,
    /// The smallest decided inequality of the run, scaled.
    pub margin: f64,
}

impl Judged {
    fn impossible() -> Self {
        Self {
            failed: vec![Demand::Drawable],
            impact_speed: f64::INFINITY,
            sliding_speed: f64::INFINITY,
            height: f64::INFINITY,
            width: f64::INFINITY,
            time: f64::INFINITY,
            margin: 0.0,
        }
    }

    fn measure(&self, demand: Demand) -> Option<f64> {
        match demand {
            Demand::Drawable | Demand::Clear | Demand::Wanted | Demand::Walls | Demand::ComesOut => None,
            Demand::ImpactSpeed => Some(self.impact_speed),
            Demand::SlidingSpeed => Some(self.sliding_speed),
            Demand::Height => Some(self.height),
            Demand::Width => Some(self.width),
            Demand::Time => Some(self.time),
        }
    }
}

impl Limits {
    /// True where a drop keeps the limits that depend on it: speeds, time, and that no wall is touched.
    pub fn keeps(&self, run: &impl Landed) -> bool {
        let within = |value: f64, limit: Option<f64>| limit.is_none_or(|limit| value <= limit);
        let [impact_speed, sliding_speed] = speeds(run);
        within(impact_speed, self.impact_speed)
            && within(sliding_speed, self.sliding_speed)
            && within(run.end_time(), self.time)
            && (!self.no_wall || run.walls_touched().is_empty())
    }

    /// True where some limit depends on the drop.
    ///
    /// # Example
    /// How high a feeder is does not depend on the drop, how long it takes does.
    /// ```
    /// use carom_study::design::Limits;
    /// let none = Limits::default();
    /// assert!(!Limits { height: Some(0.5), ..none }.are_of_drops());
    /// assert!(Limits { time: Some(2.0), ..none }.are_of_drops());
    /// ```
    pub fn are_of_drops(&self) -> bool {
        self.no_wall || [self.impact_speed, self.sliding_speed, self.time].iter().any(Option::is_some)
    }

    /// The limit of a demand, in its unit; `None` where it has none.
    ///
    /// # Example
    /// ```
    /// use carom_study::design::{Demand, Limits};
    /// let limits = Limits { height: Some(0.5), ..Limits::default() };
    /// assert_eq!((limits.of(Demand::Height), limits.of(Demand::Width)), (Some(0.5), None));
    /// assert_eq!(limits.of(Demand::Wanted), None);
    /// ```
    pub fn of(&self, demand: Demand) -> Option<f64> {
        match demand {
            Demand::Drawable | Demand::Clear | Demand::Wanted | Demand::Walls | Demand::ComesOut => None,
            Demand::ImpactSpeed => self.impact_speed,
            Demand::SlidingSpeed => self.sliding_speed,
            Demand::Height => self.height,
            Demand::Width => self.width,
            Demand::Time => self.time,
        }
    }
}

/// The hardest strike, and the largest slip.
pub(super) fn speeds(run: &impl Landed) -> [f64; 2] {
    run.landings().iter().fold([0.0; 2], |[hard, fast], landing| {
        [f64::max(hard, landing.max_impact_speed), f64::max(fast, landing.max_sliding_speed)]
    })
}

impl Goal {
    /// Judges a feeder of this width and height [m]. `run` is its run where nothing varies; `met` says that this run ends as wanted.
    pub fn judged<F: Device>(
        &self,
        feeder: &F,
        [width, height]: [f64; 2],
        run: &F::Run,
        met: bool,
    ) -> Judged {
        let [impact_speed, sliding_speed] = speeds(run);
        let (time, margin) = (run.end_time(), run.margin());
        let mut judged = Judged { failed: vec![], impact_speed, sliding_speed, height, width, time, margin };
        if !feeder.crossing_plates().is_empty() {
            judged.failed.push(Demand::Clear);
        }
        if !met {
            judged.failed.push(Demand::Wanted);
        }
        for demand in Demand::ALL {
            let exceeds = |limit: f64| judged.measure(demand).is_some_and(|value| value > limit);
            if self.limits.of(demand).is_some_and(exceeds) {
                judged.failed.push(demand);
            }
        }
        if self.limits.no_wall && !run.walls_touched().is_empty() {
            judged.failed.push(Demand::Walls);
        }
        let jams = || feeder.to_the_end().is_none_or(|run| run.outcome() == Outcome::Jammed);
        if judged.failed.is_empty() && jams() {
            judged.failed.push(Demand::ComesOut);
        }
        judged
    }
}

/// Judges layouts by a goal.
pub(super) struct Judge<'a, S> {
    pub(super) space: &'a S,
    pub(super) goal: &'a Goal,
}

impl<S: Space> Judge<'_, S> {
    /// What a layout does where nothing varies.
    pub(super) fn nominal(&self, point: &[f64]) -> Judged {
        let Some(layout) = self.space.layout(point) else { return Judged::impossible() };
        let dropped = Dropped::through(Some(&layout.feeder), 0);
        match dropped.run {
            Some(run) => {
                let met = self.space.met(point, &run);
                self.goal.judged(&layout.feeder, [layout.width, layout.height], &run, met)
            }
            None => Judged::impossible(),
        }
    }

    /// How surely a layout meets the demands.
    fn yields(&self, point: &[f64], widened: f64, samples: u64) -> Option<Estimate> {
        let varied = self.space.varied(point, widened)?;
        let plan = Plan {
            dimensions: self.space.varying(),
            samples,
            seed: self.goal.seed,
            points: Points::Sobol,
            plates: self.space.layout(point)?.feeder.plate_ends().len(),
            plate: 0,
        };
        sample(&plan, &*varied, |run| self.space.met(point, run) && self.goal.limits.keeps(run), |_| 0.0)
            .ok()
            .map(|found| found.wanted)
    }

    /// Those of the layouts that meet all demands where nothing varies, with their yields.
    pub(super) fn designs(&self, points: &[Vec<f64>], samples: u64) -> Vec<Design> {
        let of = |point: &Vec<f64>| {
            let judged = self.nominal(point);
            if !judged.failed.is_empty() {
                return None;
            }
            let yields = self.yields(point, 1.0, samples)?;
            let doubled = self.yields(point, 2.0, samples)?;
            Some(Design { point: point.clone(), judged, yields, doubled })
        };
        points.par_iter().panic_fuse().filter_map(of).collect()
    }

    /// What a demand forbids among these layouts.
    pub(super) fn forbidden(&self, demand: Demand, judged: &[Judged]) -> Forbidden {
        let failing = judged.iter().filter(|judged| judged.failed.contains(&demand));
        let alone: Vec<&Judged> =
            judged.iter().filter(|judged| judged.failed.as_slice() == [demand]).collect();
        let nearest = alone
            .iter()
            .filter_map(|judged| judged.measure(demand))
            .fold(None, |best, value| Some(best.map_or(value, |best: f64| best.min(value))));
        Forbidden { demand, failed: failing.count() as u64, alone: alone.len() as u64, nearest }
    }
}
