//! Following a body through its strikes.

use super::{RollKind, RollProblem};
use crate::tolerance::ROLL_STILL;
use carom_motion::planar::trace::Trace;
use carom_motion::planar::{Happening, MotionError, Options, Recorder, Walker};
use std::f64::consts::FRAC_PI_2;

/// How a roll ends.
///
/// # Example
/// ```
/// use carom_scene::RollEnd;
/// assert_eq!((RollEnd::AtRest.word(), RollEnd::Overturned.word()), ("at rest", "overturned"));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RollEnd {
    /// Nothing moves any more and nothing will.
    AtRest,
    /// It turns on a contact.
    Rolling,
    /// It moves on its contacts without turning.
    Sliding,
    /// It moves without contact.
    Free,
    /// A rod turned up over its supports.
    Overturned,
    /// As many strikes as were asked for, and it still moves.
    StrikesReached,
    /// No hypothesis about its contacts is consistent.
    NoConsistentOutcome,
}

impl RollEnd {
    /// Its name in results.
    ///
    /// # Example
    /// ```
    /// use carom_scene::RollEnd;
    /// assert_eq!(RollEnd::NoConsistentOutcome.word(), "no consistent outcome");
    /// ```
    pub fn word(self) -> &'static str {
        match self {
            Self::AtRest => "at rest",
            Self::Rolling => "rolling",
            Self::Sliding => "sliding",
            Self::Free => "free",
            Self::Overturned => "overturned",
            Self::StrikesReached => "strikes reached",
            Self::NoConsistentOutcome => "no consistent outcome",
        }
    }
}

/// A body followed through its strikes.
///
/// # Example
/// The run ends with the last strike that was asked for.
/// ```
/// use carom_scene::*;
/// let square = RollProblem::parse(RollKind::Prism, "square.toml", "sides = 4\nstrikes = 1", &[])?;
/// let run = square.follow()?;
/// assert_eq!((run.end, run.end_time), (RollEnd::StrikesReached, run.trace.impacts[0].time));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct RollRun {
    /// Pieces, strikes and accumulations. After the last strike asked for, the motion up to the next one.
    pub trace: Trace,
    /// How it ends.
    pub end: RollEnd,
    /// When that is so [s].
    pub end_time: f64,
}

pub(super) fn follow(problem: &RollProblem) -> Result<RollRun, MotionError> {
    let world = &problem.world;
    let options = Options { most_time: problem.most_time, ..Options::default() };
    let mut walker = Walker::new(world, problem.start, vec![true; world.obstacles.len()], options)?;
    let mut recorder = Recorder::default();
    let most = problem.strikes.unwrap_or(problem.kind.usual_strikes()) as usize;
    let ended = loop {
        let happening = walker.advance(&mut recorder)?;
        let trace = recorder.trace();
        let beyond = trace.impacts.get(most).map(|impact| impact.time);
        let over = problem.kind == RollKind::Rod && walker.state().pose.angle.abs() > FRAC_PI_2;
        match happening {
            _ if beyond.is_some() => break None,
            Happening::Rests => break Some(RollEnd::AtRest),
            Happening::FliesAway => break Some(RollEnd::Free),
            Happening::Jams | Happening::GivenUp => break Some(RollEnd::NoConsistentOutcome),
            Happening::BudgetSpent => break None,
            Happening::Moves if over => break Some(RollEnd::Overturned),
            Happening::Moves => {}
        }
    };
    let mut trace = recorder.into_trace();
    let beyond = trace.impacts.get(most).map(|impact| impact.time);
    trace.impacts.truncate(most);
    let Some(next) = beyond else {
        let end = ended.unwrap_or_else(|| goes_on(problem, &trace));
        return Ok(RollRun { trace, end, end_time: walker.time() });
    };
    trace.pieces.retain(|piece| piece.end_time <= next);
    trace.accumulations.retain(|(_, to)| *to < next);
    let end = if problem.strikes.is_some() { RollEnd::StrikesReached } else { goes_on(problem, &trace) };
    let last = trace.impacts.last().map_or(next, |impact| impact.time);
    let end_time = if problem.strikes.is_some() { last } else { next };
    Ok(RollRun { trace, end, end_time })
}

/// What it does in the last piece of its motion.
fn goes_on(problem: &RollProblem, trace: &Trace) -> RollEnd {
    let Some(piece) = trace.pieces.last() else { return RollEnd::Free };
    let scales = problem.world.scales();
    let turns = piece.start.twist.spin.abs().max(piece.end.twist.spin.abs()) * scales.length;
    match piece.held.is_empty() {
        true => RollEnd::Free,
        false if turns > ROLL_STILL * scales.speed => RollEnd::Rolling,
        false => RollEnd::Sliding,
    }
}
