//! What happens in a feed.

use crate::ending::Ending;
use carom_feeder::{Doing, FeedRun, Outcome, Run};

/// The first time that two parts are in each other's way, but for the time.
///
/// # Example
/// Discs that start from rest on one spot touch there, if at all: the second finds its place taken.
/// ```
/// use carom_feeder::{Feed, examples};
/// use carom_motion::planar::Surface;
/// use carom_study::feeds::{Meets, Plan, search};
/// let feeder = examples::disc_on_a_slope();
/// let feed = Feed { parts: 2, interval: 1.0, between: Surface { friction: 0.0, restitution: 0.0 } };
/// let plan = Plan { nodes: 16, accuracy: 1e-4, most: 1 };
/// let smallest = search(&feeder, &feed, &plan, |_| None, || ()).unwrap().smallest.unwrap();
/// let Meets { parts, blocked, .. } = smallest.meets.unwrap();
/// assert_eq!((parts, blocked), ([0, 1], true));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Meets {
    /// Their numbers, from 0; the lower one goes ahead.
    pub parts: [usize; 2],
    /// What each was doing until then.
    pub doing: [Doing; 2],
    /// True where the second found its place taken and did not start.
    pub blocked: bool,
}

/// What becomes of one part of a feed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct End {
    /// How it ends on the last plate.
    pub ending: Ending,
    /// How its run ends.
    pub outcome: Outcome,
    /// True where it ends as is wanted, and leaves the feeder or does what one alone does.
    pub as_wanted: bool,
}

/// What happens in a feed.
///
/// # Example
/// Long after each other no two parts touch, and both are delivered.
/// ```
/// use carom_feeder::{Feed, examples};
/// use carom_motion::planar::Surface;
/// use carom_study::feeds::{Happens, Plan, search};
/// let feeder = examples::disc_on_a_slope();
/// let feed = Feed { parts: 2, interval: 1.0, between: Surface { friction: 0.0, restitution: 0.0 } };
/// let plan = Plan { nodes: 16, accuracy: 1e-4, most: 1 };
/// let found = search(&feeder, &feed, &plan, |_| None, || ()).unwrap();
/// let Happens { meets, ends, broken_off } = &found.stretches.last().unwrap().label;
/// assert_eq!((meets, ends.len(), *broken_off), (&None, 2, false));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Happens {
    /// How parts are first in each other's way; `None` where none is.
    pub meets: Option<Meets>,
    /// What becomes of each part; none where solid parts touch, which are not followed on.
    pub ends: Vec<End>,
    /// True where the feed was broken off.
    pub broken_off: bool,
}

/// What happens in a feed, in a word.
///
/// # Example
/// Parts that touch without harm are told from those that touch with it.
/// ```
/// use carom_study::{Ending, feeds::{End, Happens, Kind}};
/// use carom_feeder::Outcome;
/// let end = |as_wanted| End { ending: Ending::Stays, outcome: Outcome::Delivered, as_wanted };
/// let free = Happens { meets: None, ends: vec![end(true); 2], broken_off: false };
/// assert_eq!(free.kind(), Kind::Free);
/// assert_eq!(Happens { broken_off: true, ..free }.kind(), Kind::Unresolved);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// No two parts touch.
    Free,
    /// Parts touch, and all end as is wanted.
    Harmless,
    /// Parts touch, and one at least ends otherwise.
    Harmful,
    /// Solid parts touch; they are not followed on.
    Touching,
    /// A part finds its place taken and does not start.
    Blocked,
    /// More parts or contacts meet at once than are resolved, or a budget ran out.
    Unresolved,
}

impl Happens {
    /// In a word.
    ///
    /// # Example
    /// A part whose budget ran out leaves the whole feed unresolved, whatever became of the other.
    /// ```
    /// use carom_feeder::Outcome;
    /// use carom_study::{Ending, feeds::{End, Happens, Kind}};
    /// let end = |outcome| End { ending: Ending::Otherwise(outcome), outcome, as_wanted: true };
    /// let ends = vec![end(Outcome::Delivered), end(Outcome::NeverFlat)];
    /// assert_eq!(Happens { meets: None, ends, broken_off: false }.kind(), Kind::Unresolved);
    /// ```
    pub fn kind(&self) -> Kind {
        let any = |outcome: Outcome| self.ends.iter().any(|end| end.outcome == outcome);
        if self.broken_off || any(Outcome::Unresolved) || any(Outcome::NeverFlat) {
            Kind::Unresolved
        } else if self.meets.is_none() {
            Kind::Free
        } else if any(Outcome::Blocked) || self.meets.is_some_and(|meets| meets.blocked) {
            Kind::Blocked
        } else if self.ends.is_empty() {
            Kind::Touching
        } else if self.ends.iter().all(|end| end.as_wanted) {
            Kind::Harmless
        } else {
            Kind::Harmful
        }
    }

    /// True where no two parts touch.
    ///
    /// # Example
    /// ```
    /// use carom_study::feeds::Happens;
    /// let free = Happens { meets: None, ends: vec![], broken_off: false };
    /// assert!(free.is_free() && !Happens { broken_off: true, ..free }.is_free());
    /// ```
    pub fn is_free(&self) -> bool {
        self.kind() == Kind::Free
    }
}

impl Happens {
    pub(super) fn of(run: &FeedRun, end: impl Fn(&Run) -> End, fixed: usize) -> Self {
        let ends = run.parts.iter().map(|part| end(&part.run)).collect();
        let meets = run.first_meeting(fixed);
        let meets = meets.map(|m| Meets { parts: m.parts, doing: m.doing, blocked: m.blocked });
        Self { meets, ends, broken_off: run.broken_off.is_some() }
    }
}
