//! What was observed of drops.

use super::Simulated;
use crate::ending::Ending;

/// How drops were seen to end; what was not looked at is none.
///
/// # Example
/// ```
/// use carom_feeder::Verdict;
/// use carom_study::Ending;
/// use carom_study::fits::{Seen, Simulated};
/// let third = Simulated { ending: Ending::Lies(Verdict::Face(3)), face: Some(3), time: Some(1.2) };
/// assert!(Seen { ending: None, face: Some(3) }.matches(&third));
/// assert!(!Seen { ending: Some(Ending::Stays), face: Some(3) }.matches(&third));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Seen {
    /// How they end on the plate that is looked at.
    pub ending: Option<Ending>,
    /// Number of the face on which they lie there.
    pub face: Option<usize>,
}

impl Seen {
    /// True where a drop of the engine ends as was seen.
    pub fn matches(&self, drop: &Simulated) -> bool {
        self.ending.is_none_or(|ending| ending == drop.ending)
            && (self.face.is_none() || self.face == drop.face)
    }

    /// What was looked at: ending, face.
    pub(super) fn kind(&self) -> (bool, bool) {
        (self.ending.is_some(), self.face.is_some())
    }
}

/// A time that was measured.
///
/// # Example
/// A stopwatch by hand: a tenth of a second.
/// ```
/// use carom_study::fits::Timed;
/// let Timed { time, scatter } = Timed { time: 1.3, scatter: Some(0.1) };
/// assert!(scatter.is_some_and(|scatter| scatter < time));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Timed {
    /// From the start [s].
    pub time: f64,
    /// Standard deviation of the measurement [s]; of all times without one, one is fitted.
    pub scatter: Option<f64>,
}

/// So many drops that were observed alike.
///
/// # Example
/// Seven drops under the first condition turned over.
/// ```
/// use carom_feeder::Verdict;
/// use carom_study::Ending;
/// use carom_study::fits::{Observation, Seen};
/// let seen = Seen { ending: Some(Ending::Lies(Verdict::Turned)), face: None };
/// let Observation { count, time, .. } = Observation { condition: 0, seen, time: None, count: 7 };
/// assert_eq!((count, time), (7, None));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Observation {
    /// Number of the condition under which they were made, from 0.
    pub condition: usize,
    /// How they ended.
    pub seen: Seen,
    /// When, where it was measured.
    pub time: Option<Timed>,
    /// How many drops: at least one.
    pub count: u64,
}

impl Observation {
    /// True where it says something, in numbers that can be computed with.
    pub(super) fn is_sound(&self, conditions: usize) -> bool {
        let above = |value: f64| value.is_finite() && value > 0.0;
        let timed = |timed: Timed| above(timed.time) && timed.scatter.is_none_or(above);
        let something = self.time.is_some() || self.seen.kind() != (false, false);
        something && self.count > 0 && self.condition < conditions && self.time.is_none_or(timed)
    }
}
