//! Following a body in space through its strikes.

use super::SpatialRollProblem;
use carom_motion::spatial::{
    Budget, Closing, End, Impact, Mode, MotionError, Observer, Piece, Run, State, run,
};
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
    /// The largest change of the energy between two events, as [`carom_motion::spatial::Run::drift`].
    pub drift: f64,
}

/// Keeps what a person or a picture wants to see, and stops at a strike too many.
struct Witness {
    most: usize,
    before: State,
    instants: Vec<(f64, Mode, State)>,
    pieces: Vec<Piece>,
    strikes: Vec<(Impact, State)>,
    /// When the strike came that is one too many \[s\].
    beyond: Option<f64>,
}

impl Observer for Witness {
    fn is_dense(&self) -> bool {
        true
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
        self.strikes.push((impact.clone(), before));
        ControlFlow::Continue(())
    }
}

pub(super) fn follow(problem: &SpatialRollProblem) -> Result<SpatialRollRun, MotionError> {
    let usual = if problem.pyramid.is_some() { PYRAMID_STRIKES } else { MOST_STRIKES };
    let mut witness = Witness {
        most: problem.strikes.unwrap_or(usual) as usize,
        before: problem.start,
        instants: vec![],
        pieces: vec![],
        strikes: vec![],
        beyond: None,
    };
    let run = run(&problem.world, &problem.start, &problem.options(), &mut witness)?;
    Ok(put_together(problem, run, witness))
}

fn put_together(problem: &SpatialRollProblem, run: Run, witness: Witness) -> SpatialRollRun {
    let Witness { instants, pieces, strikes, beyond, .. } = witness;
    let strikes = strikes.into_iter().map(|(impact, before)| {
        let after =
            State { velocity: velocity_after(problem, &before, &impact), spin: impact.spin_after, ..before };
        SpatialStrike { impact, before, after }
    });
    let strikes: Vec<SpatialStrike> = strikes.collect();
    let closings = run.closings.into_iter().filter(|c| beyond.is_none_or(|time| c.time < time)).collect();
    let last = match (beyond, pieces.last()) {
        (Some(_), Some(piece)) => piece.end,
        _ => run.state,
    };
    SpatialRollRun {
        instants,
        pieces,
        closings,
        end: match beyond {
            None => Some(run.end),
            // Nobody asked for so many.
            Some(_) if problem.strikes.is_none() && problem.pyramid.is_none() => {
                Some(End::BudgetSpent(Budget::Impacts))
            }
            Some(_) => None,
        },
        end_time: if beyond.is_some() { strikes.last().map_or(0.0, |s| s.impact.time) } else { run.time },
        strikes,
        last,
        drift: run.drift,
    }
}

/// What the impulses leave of the mass centre's velocity.
fn velocity_after(problem: &SpatialRollProblem, before: &State, impact: &Impact) -> carom_num::Vec3 {
    let mass = problem.world.body().mass();
    impact.impulses.iter().fold(before.velocity, |velocity, (_, impulse)| velocity + *impulse / mass)
}
