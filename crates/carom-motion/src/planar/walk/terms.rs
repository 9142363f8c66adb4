//! What a walk is given, and what it says: options, happenings, errors, effort and margin.

use crate::tolerance::{MOST_SIGNIFICANT_RATE, PLANAR_TOLERANCE, SIGNIFICANT_RATE};

/// How exactly and how long to walk.
///
/// # Example
/// A ball that falls for 0.2 s is not followed beyond its first strike where one event is allowed.
/// ```
/// use carom_motion::planar::{Happening, Options, Walker, examples};
/// let (world, start) = examples::falling_ball();
/// let options = Options { most_events: 1, ..Options::default() };
/// let mut walker = Walker::new(&world, start, vec![], options)?;
/// assert_eq!(walker.advance(&mut ())?, Happening::Moves);
/// assert_eq!(walker.advance(&mut ())?, Happening::BudgetSpent);
/// assert!((walker.time() - 0.2).abs() < 1e-12);
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Relative tolerance of the integration.
    pub tolerance: f64,
    /// Simulated time after which the walk stops [s].
    pub most_time: f64,
    /// Events after which the walk stops.
    pub most_events: u64,
}

impl Options {
    /// Rates below this, in the world's own units, count as none: rounding, or what the integration's own error leaves of a zero.
    pub(super) fn significant(&self) -> f64 {
        (100.0 * self.tolerance).clamp(SIGNIFICANT_RATE, MOST_SIGNIFICANT_RATE)
    }
}

impl Default for Options {
    fn default() -> Self {
        Self { tolerance: PLANAR_TOLERANCE, most_time: 600.0, most_events: 20_000 }
    }
}

/// Counts of the work done: the same for the same input, on any machine.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effort {
    /// Evaluations of a mode's forces and accelerations.
    pub evaluations: u64,
    /// Steps of the integration.
    pub steps: u64,
    /// Evaluations of event functions.
    pub event_evaluations: u64,
    /// Rate problems that were asked between impacts.
    pub rate_problems: u64,
    /// Events.
    pub events: u64,
    /// Impacts.
    pub impacts: u64,
}

impl Effort {
    /// The larger of the counts of two walks.
    pub(in crate::planar) fn at_least(&self, other: &Self) -> Self {
        Self {
            evaluations: self.evaluations.max(other.evaluations),
            steps: self.steps.max(other.steps),
            event_evaluations: self.event_evaluations.max(other.event_evaluations),
            rate_problems: self.rate_problems.max(other.rate_problems),
            events: self.events.max(other.events),
            impacts: self.impacts.max(other.impacts),
        }
    }
}

/// How certain the walk is.
///
/// # Example
/// A block on a slope of 3 in 4 (gravity (6, −8) along it) holds from μ = 3/4 on: the nearer to that, the
/// smaller the margin.
/// ```
/// use carom_motion::MotionError;
/// use carom_motion::planar::{Margin, MarginOf, Options, Walker, examples};
/// use carom_num::Vec2;
/// let margin = |friction: f64| -> Result<Margin, MotionError> {
///     let (world, start) = examples::lying_block(Vec2::new(6.0, -8.0), friction);
///     let mut walker = Walker::new(&world, start, vec![], Options::default())?;
///     walker.advance(&mut ())?;
///     Ok(walker.margin())
/// };
/// assert_eq!(margin(0.76)?.of, MarginOf::Rate);
/// assert!(0.0 < margin(0.76)?.value && margin(0.76)?.value < margin(0.9)?.value);
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Margin {
    /// Smallest decided inequality divided by the sum of its terms' magnitudes.
    pub value: f64,
    /// What it was about.
    pub of: MarginOf,
    /// When [s].
    pub time: f64,
}

/// What a margin is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MarginOf {
    /// Nothing was decided yet.
    Nothing,
    /// Which contacts hold, stick or slip in motion.
    Rate,
    /// The course of an impact.
    Impact,
}

/// What one advance of the walk brought.
///
/// # Example
/// A ball that falls past a floor flies away; one over it comes to rest.
/// ```
/// use carom_motion::MotionError;
/// use carom_motion::planar::{Happening, Options, Pose, State, Walker, examples};
/// use carom_num::Vec2;
/// let (world, start) = examples::falling_ball();
/// let end = |x: f64| -> Result<Happening, MotionError> {
///     let start = State { pose: Pose { centre: Vec2::new(x, 0.3), angle: 0.0 }, ..start };
///     let mut walker = Walker::new(&world, start, vec![], Options::default())?;
///     while walker.advance(&mut ())? == Happening::Moves {}
///     walker.advance(&mut ())
/// };
/// assert_eq!((end(-2.0)?, end(0.0)?), (Happening::FliesAway, Happening::Rests));
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Happening {
    /// It goes on.
    Moves,
    /// Nothing moves any more and nothing will.
    Rests,
    /// It flies and can meet nothing any more.
    FliesAway,
    /// No impact resolves its contacts. In a crowd it stands still from then on, until another body comes.
    Jams,
    /// Of more contacts than can be examined no solution was found; there may be one. In a crowd it stands still as if it jammed.
    GivenUp,
    /// It swings to and fro without loss, and nothing is left that could end it. Only of a walk that [asks for it](super::Walker::ending_at_swings).
    Swings,
    /// The budget of time or events is used up.
    BudgetSpent,
}
