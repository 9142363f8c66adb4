//! What a search of intervals found.

use super::{Happens, Kind, Longest, Meets};
use crate::ending::Ending;
use crate::stretches::Stretch;
use carom_feeder::Run;

/// The smallest interval above which parts do not touch.
///
/// # Example
/// Discs of radius r that start from rest at a m/s² are free of each other once the first has gone 2 r: after
/// `√(4 r/a)`. With 0.06 m and 6 m/s² that is 0.2 s.
/// ```
/// use carom_feeder::{Feed, examples};
/// use carom_motion::planar::Surface;
/// use carom_study::feeds::{Kind, Plan, Smallest, search};
/// let feeder = examples::disc_on_a_slope();
/// let feed = Feed { parts: 2, interval: 1.0, between: Surface { friction: 0.0, restitution: 0.0 } };
/// let plan = Plan { nodes: 16, accuracy: 1e-4, most: 1 };
/// let Smallest { touching, free, below, .. } =
///     search(&feeder, &feed, &plan, |_| None, || ()).unwrap().smallest.unwrap();
/// assert!(touching < 0.2 + 1e-4 && 0.2 - 1e-4 < free && free - touching < 2e-4);
/// assert_eq!(below, Kind::Blocked);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Smallest {
    /// The longest interval that was seen at which they touch, or at which it is not resolved whether they do [s].
    pub touching: f64,
    /// The next longer one that was asked, at which they do not [s].
    pub free: f64,
    /// What happens at the former: anything but [`Kind::Free`].
    pub below: Kind,
    /// How they touch there; `None` where that is not resolved.
    pub meets: Option<Meets>,
}

/// What a search found.
///
/// # Example
/// One disc alone is gone after `√(2·2/6)` s; intervals of less than 0.2 s are too short.
/// ```
/// use carom_feeder::{Feed, examples};
/// use carom_motion::planar::Surface;
/// use carom_study::feeds::{Plan, search};
/// let feeder = examples::disc_on_a_slope();
/// let feed = Feed { parts: 2, interval: 1.0, between: Surface { friction: 0.0, restitution: 0.0 } };
/// let plan = Plan { nodes: 16, accuracy: 1e-4, most: 1 };
/// let found = search(&feeder, &feed, &plan, |_| None, || ()).unwrap();
/// assert!((found.alone.end_time - (2.0 / 3.0f64).sqrt()).abs() < 1e-9);
/// assert!(found.stretches.iter().all(|piece| piece.label.is_free() == (piece.first > 0.2 - 1e-4)));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Feeds<R = Run> {
    /// The run of one part, followed until it has left the feeder or rests; with its trace.
    pub alone: R,
    /// How it ends on the last plate.
    pub ending: Ending,
    /// The plate or wall on which it comes to rest, plates first; `None` where it leaves the feeder.
    pub rests_on: Option<usize>,
    /// The longest interval at which its way meets itself; `None` where it comes to rest, and its way never ends.
    pub longest: Option<Longest>,
    /// The smallest interval above which parts do not touch; `None` where they touch at the longest one that was asked.
    pub smallest: Option<Smallest>,
    /// What happens at which interval, from the shortest to the longest that was asked.
    pub stretches: Vec<Stretch<Happens>>,
    /// What of the range lies between changes that were not followed [s].
    pub unresolved: f64,
    /// Feeds that were followed.
    pub runs: usize,
}

impl<R> Feeds<R> {
    /// True where parts come to rest on the feeder and are in the way of every later one.
    pub fn piles_up(&self) -> bool {
        self.longest.is_none() && self.smallest.is_none()
    }
}
