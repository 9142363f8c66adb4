//! Following a body through its strikes.

use super::poses::{RollPose, Sampler};
use super::{RollKind, RollProblem};
use crate::tolerance::ROLL_STILL;
use carom_motion::MotionError;
use carom_motion::planar::observer::{ContactSample, HeldContact, ImpactFacts, PieceFacts};
use carom_motion::planar::trace::{Impact, Trace};
use carom_motion::planar::{Happening, Observer, Options, Recorder, State, Walker};
use std::f64::consts::FRAC_PI_2;

/// How a roll ends.
///
/// # Example
/// ```
/// use {carom_scene::RollEnd, carom_words::Words};
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

carom_words::words! {
    RollEnd {
        AtRest = "at rest",
        Rolling = "rolling",
        Sliding = "sliding",
        Free = "free",
        Overturned = "overturned",
        StrikesReached = "strikes reached",
        NoConsistentOutcome = "no consistent outcome",
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
    /// Its poses, where they were asked for.
    pub poses: Option<Vec<RollPose<State>>>,
}

/// Keeps everything, and poses at equal intervals.
struct Witness {
    recorder: Recorder,
    sampler: Sampler<State>,
}

impl Observer for Witness {
    fn is_dense(&self) -> bool {
        true
    }

    fn next_instant(&self) -> f64 {
        self.sampler.next()
    }

    fn instant(&mut self, time: f64, state: &State) {
        self.sampler.show(time, *state);
    }

    fn starts(&mut self, time: f64, state: &State, held: &mut dyn Iterator<Item = HeldContact>) {
        self.recorder.starts(time, state, held);
    }

    fn sample(&mut self, time: f64, state: &State, contacts: &mut dyn Iterator<Item = ContactSample>) {
        self.recorder.sample(time, state, contacts);
    }

    fn piece(&mut self, piece: &PieceFacts) {
        self.recorder.piece(piece);
    }

    fn impact(&mut self, facts: &ImpactFacts, whole: Option<Impact>) {
        self.sampler.strike(facts.time, facts.before, facts.after);
        self.recorder.impact(facts, whole);
    }

    fn lifts_off(&mut self, needed_force: f64) {
        self.recorder.lifts_off(needed_force);
    }

    fn accumulation(&mut self, from: f64, to: f64) {
        self.recorder.accumulation(from, to);
    }
}

/// The run, and how many poses it would have, where those are too many.
pub(super) fn follow(
    problem: &RollProblem,
    every: Option<f64>,
) -> Result<(RollRun, Option<f64>), MotionError> {
    let world = &problem.world;
    let options = Options { most_time: problem.most_time, ..Options::default() };
    let mut walker = Walker::new(world, problem.start, vec![true; world.obstacles.len()], options)?;
    let mut witness = Witness { recorder: Recorder::default(), sampler: Sampler::new(every) };
    let most = problem.strikes.unwrap_or(problem.kind.usual_strikes()) as usize;
    let ended = loop {
        let happening = walker.advance(&mut witness)?;
        let trace = witness.recorder.trace();
        // One strike more than asked for is followed: what the body does until then is how it ends.
        let beyond = trace.impacts.get(most).map(|impact| impact.time);
        let over = problem.kind == RollKind::Rod && walker.state().pose.angle.abs() > FRAC_PI_2;
        match happening {
            _ if beyond.is_some() => break None,
            Happening::Rests => break Some(RollEnd::AtRest),
            Happening::FliesAway => break Some(RollEnd::Free),
            Happening::Jams | Happening::GivenUp => break Some(RollEnd::NoConsistentOutcome),
            Happening::Swings | Happening::BudgetSpent => break None,
            Happening::Moves if over => break Some(RollEnd::Overturned),
            Happening::Moves => {}
        }
    };
    let Witness { recorder, sampler } = witness;
    let mut trace = recorder.into_trace();
    let beyond = trace.impacts.get(most).map(|impact| impact.time);
    trace.impacts.truncate(most);
    let strikes = trace.impacts.len();
    let Some(next) = beyond else {
        let end = ended.unwrap_or_else(|| goes_on(problem, &trace));
        let (poses, too_many) = sampler.finish(strikes, walker.time(), *walker.state());
        return Ok((RollRun { trace, end, end_time: walker.time(), poses }, too_many));
    };
    trace.pieces.retain(|piece| piece.end_time <= next);
    trace.accumulations.retain(|(_, to)| *to < next);
    let last =
        trace.impacts.last().map(|impact| (impact.time, State { pose: impact.pose, twist: impact.after }));
    let (end, (end_time, state)) = match last {
        Some(last) if problem.strikes.is_some() => (RollEnd::StrikesReached, last),
        _ => {
            let there = trace.pieces.last().map_or(*walker.state(), |piece| piece.end);
            (goes_on(problem, &trace), (next, there))
        }
    };
    let (poses, too_many) = sampler.finish(strikes, end_time, state);
    Ok((RollRun { trace, end, end_time, poses }, too_many))
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
