//! Following a body in space through its strikes.

use super::SpatialRollProblem;
use crate::roll::poses::{RollPose, Sampler};
use carom_motion::MotionError;
use carom_motion::spatial::{Budget, Closing, End, Impact, Mode, Observer, Piece, Run, State, run};
use std::ops::ControlFlow;

/// Strikes that are followed where nothing is written.
const PYRAMID_STRIKES: u32 = 1;
pub(super) const MOST_STRIKES: u32 = 10_000;

/// A strike, and the state that it finds.
///
/// # Example
/// A cube that is let go on its edge keeps a quarter of its spin.
/// ```
/// use carom_scene::*;
/// let cube = SpatialRollProblem::parse(SpatialRollKind::Stool, "cube.toml", "axis = [1, 1, 0]", &[])?;
/// let run = cube.follow()?;
/// let SpatialStrike { before, after, .. } = &run.strikes[0];
/// assert!((after.spin.norm() / before.spin.norm() - 0.25).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SpatialStrike {
    /// The engine's impact.
    pub impact: Impact,
    /// The body before it.
    pub before: State,
    /// The body after it.
    pub after: State,
}

/// A body followed through its strikes.
///
/// # Example
/// It rocks until its strikes are closed at their limit, and rests then.
/// ```
/// use carom_scene::*;
/// let cube = SpatialRollProblem::parse(SpatialRollKind::Stool, "cube.toml", "axis = [1, 1, 0]", &[])?;
/// let run = cube.follow()?;
/// assert_eq!(run.closings.len(), 1);
/// assert!(matches!(run.end, Some(carom_motion::spatial::End::AtRest { held }) if held.len() == 4));
/// assert!(run.end_time >= run.closings[0].limit);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SpatialRollRun {
    /// Instants of the motion: time \[s\], what the body does, its state.
    pub instants: Vec<(f64, Mode, State)>,
    /// The stretches between events. After the last strike asked for, the motion up to the next one.
    pub pieces: Vec<Piece>,
    /// The strikes.
    pub strikes: Vec<SpatialStrike>,
    /// Series of strikes that were closed at their limit.
    pub closings: Vec<Closing>,
    /// How it ends; `None` where as many strikes as were asked for are done and it still moves.
    pub end: Option<End>,
    /// When that is so \[s\].
    pub end_time: f64,
    /// State at the end.
    pub last: State,
    /// Its poses, where they were asked for.
    pub poses: Option<Vec<RollPose<State>>>,
    /// The largest change of the energy between two events, as [`carom_motion::spatial::Run::drift`].
    pub drift: f64,
}

/// Keeps what a person or a picture wants to see, and stops at a strike too many.
struct Witness {
    mass: f64,
    most: usize,
    before: State,
    instants: Vec<(f64, Mode, State)>,
    pieces: Vec<Piece>,
    strikes: Vec<(Impact, State)>,
    sampler: Sampler<State>,
    /// When the strike came that is one too many \[s\].
    beyond: Option<f64>,
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

    fn sample(&mut self, time: f64, mode: Mode, state: &State) {
        self.instants.push((time, mode, *state));
    }

    fn piece(&mut self, piece: &Piece) {
        self.before = piece.end;
        self.pieces.push(*piece);
    }

    fn impact(&mut self, impact: &Impact) -> ControlFlow<()> {
        if self.strikes.len() >= self.most {
            self.beyond = Some(impact.time);
            return ControlFlow::Break(());
        }
        let before = State { attitude: impact.attitude, spin: impact.spin_before, ..self.before };
        self.sampler.strike(impact.time, before, after(self.mass, &before, impact));
        self.strikes.push((impact.clone(), before));
        ControlFlow::Continue(())
    }
}

/// The run, and how many poses it would have, where those are too many.
pub(super) fn follow(
    problem: &SpatialRollProblem,
    every: Option<f64>,
) -> Result<(SpatialRollRun, Option<f64>), MotionError> {
    let usual = if problem.pyramid.is_some() { PYRAMID_STRIKES } else { MOST_STRIKES };
    let mut witness = Witness {
        mass: problem.world.body().mass(),
        most: problem.strikes.unwrap_or(usual) as usize,
        before: problem.start,
        instants: vec![],
        pieces: vec![],
        strikes: vec![],
        sampler: Sampler::new(every),
        beyond: None,
    };
    let run = run(&problem.world, &problem.start, &problem.options(), &mut witness)?;
    Ok(put_together(problem, run, witness))
}

fn put_together(problem: &SpatialRollProblem, run: Run, witness: Witness) -> (SpatialRollRun, Option<f64>) {
    let Witness { mass, instants, pieces, strikes, sampler, beyond, .. } = witness;
    let strikes = strikes.into_iter().map(|(impact, before)| {
        let after = after(mass, &before, &impact);
        SpatialStrike { impact, before, after }
    });
    let strikes: Vec<SpatialStrike> = strikes.collect();
    let closings = run.closings.into_iter().filter(|c| beyond.is_none_or(|time| c.time < time)).collect();
    let last = match (beyond, pieces.last()) {
        (Some(_), Some(piece)) => piece.end,
        _ => run.state,
    };
    let end = match beyond {
        None => Some(run.end),
        // Nobody asked for so many.
        Some(_) if problem.strikes.is_none() && problem.pyramid.is_none() => {
            Some(End::BudgetSpent(Budget::Impacts))
        }
        Some(_) => None,
    };
    let (end_time, state) = match (beyond, strikes.last()) {
        (None, _) => (run.time, run.state),
        (_, Some(strike)) => (strike.impact.time, strike.after),
        (_, None) => (0.0, problem.start),
    };
    let (poses, too_many) = sampler.finish(strikes.len(), end_time, state);
    let drift = run.drift;
    (SpatialRollRun { instants, pieces, strikes, closings, end, end_time, last, poses, drift }, too_many)
}

/// The body after an impact: the impulses change the mass centre's velocity.
fn after(mass: f64, before: &State, impact: &Impact) -> State {
    let velocity = impact.impulses.iter().fold(before.velocity, |v, (_, impulse)| v + *impulse / mass);
    State { velocity, spin: impact.spin_after, ..*before }
}
