//! How closely parts may follow each other: the smallest interval above which the parts of a feed do not touch, and what happens below it.
//!
//! Whether parts touch is not monotone in the interval: below the smallest one free of touch there may be windows in which they happen to miss
//! each other. [`search`] therefore asks two ways.
//!
//! 1. The way of one part alone says at which intervals it would meet itself: the longest of them is found by branch and bound, windows of any
//!    width included ([`Longest`]).
//! 2. Whole feeds are followed at intervals all over the range, close to that one, and above it up to the time that a part takes to leave. Every
//!    change of what happens is located by bisection ([`stretches`]).
//!
//! Every part is followed until it has left the last plate or rests, whatever the feeder stops at: a part that has landed is in the way of the
//! next until it is gone. Where a part alone comes to rest, later ones pile up behind it at every interval.
//!
//! Of solid parts [`search_solid`] goes the first way alone, interval by interval: whether the way of one part meets itself that much later says whether parts touch. What parts that touch
//! do is not followed.
//!
//! # Limits
//! Parts are identical, so parts that do not touch all do what one does. The first way sees the motion between samples as cubics: of swings
//! it is as exact as these. The second sees single intervals: what happens on a stretch shorter than the distance of two nodes may be missed.

mod found;
mod happening;
mod in_plane;
mod in_space;
mod path;
mod solid;

pub use found::{Feeds, Smallest};
pub use happening::{End, Happens, Kind, Meets};
pub use path::{Longest, longest_meeting};
pub use solid::search_solid;

use crate::ending::Ending;
use crate::stretches::{self, Stretches};
use crate::tolerance::{FEEDS_ACCURACY, LEAST_FEEDS_ACCURACY};
use carom_feeder::{Feed, Feeder, FeederProblem, Outcome, Run, RunError, Stop};
use carom_motion::planar;
use thiserror::Error;

/// What to look at, and how carefully.
///
/// # Example
/// Fewer than 16 intervals say nothing.
/// ```
/// use carom_feeder::{Feed, examples};
/// use carom_motion::planar::Surface;
/// use carom_study::feeds::{FeedsError, Plan, search};
/// let feeder = examples::disc_on_a_slope();
/// let feed = Feed { parts: 2, interval: 1.0, between: Surface { friction: 0.0, restitution: 0.0 } };
/// let plan = Plan { nodes: 15, ..Plan::default() };
/// assert_eq!(search(&feeder, &feed, &plan, |_| None, || ()), Err(FeedsError::Nodes { nodes: 15 }));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// Intervals that are asked all over the range, 16 to [`MOST_NODES`].
    pub nodes: usize,
    /// How finely changes are located [s], 1e-9 to 0.1.
    pub accuracy: f64,
    /// Changes that are followed between two neighbouring nodes.
    pub most: usize,
}

/// Most intervals that are asked all over the range.
pub const MOST_NODES: usize = 1_000_000;
/// How far the range goes above the longest interval with a touch, and above the rest of a part that stays.
const ABOVE: f64 = 1.25;
/// The shortest interval, as a share of the range.
const SHORTEST: f64 = 1e-3;
/// Intervals that are asked between the range and the time that a part takes.
const BEYOND: usize = 32;

impl Default for Plan {
    /// 400 nodes, a microsecond, eight changes between two nodes.
    fn default() -> Self {
        Self { nodes: 400, accuracy: FEEDS_ACCURACY, most: 8 }
    }
}

/// Why nothing was searched.
///
/// # Example
/// One part has no other to touch.
/// ```
/// use carom_feeder::{Feed, examples};
/// use carom_motion::planar::Surface;
/// use carom_study::feeds::{FeedsError, Plan, search};
/// let feeder = examples::disc_on_a_slope();
/// let feed = Feed { parts: 2, interval: 1.0, between: Surface { friction: 0.0, restitution: 0.0 } };
/// let plan = Plan { nodes: 16, accuracy: 1e-4, most: 1 };
/// let one = Feed { parts: 1, ..feed };
/// let error = search(&feeder, &one, &plan, |_| None, || ()).unwrap_err();
/// assert_eq!(error, FeedsError::Parts { parts: 1 });
/// assert_eq!(error.to_string(), "1 parts: 2 to 100 are allowed");
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum FeedsError {
    /// The number of intervals.
    #[error("{nodes} intervals: 16 to {MOST_NODES} are allowed")]
    Nodes {
        /// The number.
        nodes: usize,
    },
    /// The accuracy.
    #[error("the accuracy {accuracy} s is outside 1e-9 s to 0.1 s")]
    Accuracy {
        /// The accuracy [s].
        accuracy: f64,
    },
    /// One part cannot touch another.
    #[error("{parts} parts: 2 to 100 are allowed")]
    Parts {
        /// The number.
        parts: usize,
    },
    /// The feeder or the feed cannot be.
    #[error("{}", .0.iter().map(ToString::to_string).collect::<Vec<_>>().join("; "))]
    Problems(Vec<FeederProblem>),
    /// A part that has no form.
    #[error("the part: {0}")]
    Form(String),
    /// One part alone neither leaves the feeder nor comes to rest on it.
    #[error("one part alone neither leaves the feeder nor rests on it")]
    Alone(Outcome),
    /// A fault of the numbers, of one part alone.
    #[error("one part alone: {0}")]
    Motion(carom_motion::MotionError),
}

/// The feeder that is searched: the same, with parts followed until they have left the last plate.
///
/// # Example
/// ```
/// use carom_feeder::{Stop, examples};
/// let feeder = examples::disc_above_a_tray();
/// let followed = carom_study::feeds::followed(&feeder);
/// assert_eq!((feeder.stop, followed.stop), (Stop::Landed, Stop::Delivered));
/// assert_eq!(followed.plates, feeder.plates);
/// ```
pub fn followed(feeder: &Feeder) -> Feeder {
    Feeder { stop: Stop::Delivered, ..feeder.clone() }
}

/// Searches all intervals at which this feeder may be fed; the interval of `feed` does not matter. `wanted` says whether a run ends as is wanted.
/// Where it says nothing, a run ends as wanted if it ends as that of a part alone. `step` is called after every feed.
///
/// # Guarantees, limits
/// As the [module](self). The result does not depend on the number of threads.
///
/// # Errors
/// [`FeedsError`].
///
/// # Example
/// Discs of 0.06 m that start from rest at 6 m/s² may follow each other after `√(4·0.06/6)` = 0.2 s.
/// ```
/// use carom_feeder::{Feed, examples};
/// use carom_motion::planar::Surface;
/// use carom_study::feeds::{Plan, search};
/// let feeder = examples::disc_on_a_slope();
/// let feed = Feed { parts: 2, interval: 1.0, between: Surface { friction: 0.0, restitution: 0.0 } };
/// let plan = Plan { nodes: 16, accuracy: 1e-4, most: 1 };
/// let feeds = std::sync::atomic::AtomicUsize::new(1);
/// let step = || { feeds.fetch_add(1, std::sync::atomic::Ordering::Relaxed); };
/// let found = search(&feeder, &feed, &plan, |_| None, step).unwrap();
/// assert!((found.smallest.unwrap().free - 0.2).abs() < 2e-4);
/// assert_eq!(found.runs, feeds.into_inner());
/// ```
pub fn search(
    feeder: &Feeder,
    feed: &Feed,
    plan: &Plan,
    wanted: impl Fn(&Run) -> Option<bool> + Sync,
    step: impl Fn() + Sync,
) -> Result<Feeds, FeedsError> {
    searched(feeder, feed, plan, &wanted, &step)
}

fn searched(
    feeder: &Feeder,
    feed: &Feed,
    plan: &Plan,
    wanted: &(dyn Fn(&Run) -> Option<bool> + Sync),
    step: &(dyn Fn() + Sync),
) -> Result<Feeds, FeedsError> {
    plan.check()?;
    if feed.parts < 2 {
        return Err(FeedsError::Parts { parts: feed.parts });
    }
    let feeder = followed(feeder);
    let prepared = feeder.prepare(planar::Options::default()).map_err(refused)?;
    let one = prepared.feed(&Feed { parts: 1, interval: 1.0, ..*feed }).map_err(refused)?;
    let alone = match one.parts.into_iter().next() {
        Some(part) => part.run,
        None => return Err(FeedsError::Alone(Outcome::Unresolved)),
    };
    let last = feeder.plates.len() - 1;
    let ending = Ending::of(&alone, last);
    let fixed = feeder.plates.len() + feeder.walls.len();
    let end = |run: &Run| {
        let own = Ending::of(run, last);
        let good = wanted(run).unwrap_or(own == ending);
        let on_its_way = run.outcome == alone.outcome || run.outcome == Outcome::Delivered;
        End { ending: own, outcome: run.outcome, as_wanted: good && on_its_way }
    };
    let classify = |interval: f64| {
        step();
        match prepared.feed(&Feed { interval, ..*feed }) {
            Ok(run) => Happens::of(&run, end, fixed),
            // Only a bad feed is refused, and that was checked.
            Err(_) => Happens { meets: None, ends: vec![], broken_off: true },
        }
    };
    let leaves = leaves(alone.outcome)?;
    let shape = &feeder.part.body.shape;
    let longest = leaves.then(|| longest_meeting(shape, &alone, 0.1 * plan.accuracy));
    let nodes = plan.intervals(longest.as_ref(), alone.end_time);
    let options = stretches::Options { accuracy: plan.accuracy, most: plan.most };
    let found = stretches::find(&nodes, options, classify, Happens::is_free);
    let smallest = smallest(&found);
    let runs = found.evaluations + 1;
    let unresolved = found.unresolved;
    let rests_on = alone.stages.last().and_then(|stage| stage.obstacle).filter(|_| !leaves);
    Ok(Feeds { alone, ending, rests_on, longest, smallest, stretches: found.pieces, unresolved, runs })
}

/// Whether a part that ends so has left the feeder, or rests on it.
fn leaves(outcome: Outcome) -> Result<bool, FeedsError> {
    match outcome {
        Outcome::Delivered | Outcome::Escaped | Outcome::Missed => Ok(true),
        Outcome::Stuck | Outcome::OnEnd | Outcome::Jammed | Outcome::Landed => Ok(false),
        Outcome::NeverFlat | Outcome::Unresolved | Outcome::Blocked => Err(FeedsError::Alone(outcome)),
    }
}

/// The last change to no touch; `None` where the longest interval is not free of it.
fn smallest(found: &Stretches<Happens>) -> Option<Smallest> {
    let touching = found.pieces.iter().rposition(|piece| !piece.label.is_free())?;
    let (before, after) = (&found.pieces[touching], found.pieces.get(touching + 1)?);
    Some(Smallest {
        touching: before.last,
        free: after.first,
        below: before.label.kind(),
        meets: before.label.meets,
    })
}

fn refused(error: RunError) -> FeedsError {
    match error {
        RunError::Problems(problems) => FeedsError::Problems(problems),
        RunError::Motion(error) => FeedsError::Motion(error),
        _ => FeedsError::Alone(Outcome::Unresolved),
    }
}

impl Plan {
    fn check(&self) -> Result<(), FeedsError> {
        if !(16..=MOST_NODES).contains(&self.nodes) {
            return Err(FeedsError::Nodes { nodes: self.nodes });
        }
        if !(LEAST_FEEDS_ACCURACY..=0.1).contains(&self.accuracy) {
            return Err(FeedsError::Accuracy { accuracy: self.accuracy });
        }
        Ok(())
    }

    /// The intervals that are asked: all over the range, ever closer to the longest one at which the way meets itself, and a few beyond.
    fn intervals(&self, longest: Option<&Longest>, lasts: f64) -> Vec<f64> {
        let reach = longest.map_or(lasts, |longest| longest.high);
        let top = ABOVE * reach;
        let evenly = |from: f64, to: f64, count: usize| {
            (0..=count).map(move |k| from + (to - from) * (k as f64 / count as f64))
        };
        let mut intervals: Vec<f64> = evenly(SHORTEST * top, top, self.nodes).collect();
        if let Some(longest) = longest {
            let mut off = self.accuracy;
            while off < 0.1 * reach {
                intervals.extend([longest.low - off, longest.high + off]);
                off *= 10.0;
            }
            if lasts > top {
                intervals.extend(evenly(top, ABOVE * lasts, BEYOND));
            }
        }
        intervals.retain(|interval| *interval > 0.0);
        intervals
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stretches::Stretch;

    #[test]
    fn what_is_not_resolved_below_the_answer_is_no_touch() {
        let end = End { ending: Ending::Stays, outcome: Outcome::Delivered, as_wanted: true };
        let happens = |broken_off| Happens { meets: None, ends: vec![end; 2], broken_off };
        let piece = |label, first, last| Stretch { label, first, last };
        let pieces = vec![piece(happens(true), 0.1, 0.2), piece(happens(false), 0.3, 0.4)];
        let found = smallest(&Stretches { pieces, unresolved: 0.0, evaluations: 4 }).unwrap();
        assert_eq!((found.touching, found.free, found.meets), (0.2, 0.3, None));
        assert_eq!(found.below, Kind::Unresolved);
    }
}
