//! What the next smooth piece of a motion will bring: looked at beforehand.

use super::island::MOST_TOGETHER;
use crate::MotionError;
use crate::planar::geometry::State;
use crate::planar::walk::{
    path::{Course, Leg},
    walker::Walker,
};

/// What one smooth piece of an island's motion will bring.
#[derive(Clone, Debug)]
pub(super) struct Ahead {
    /// When it ends [s]; infinite where it rests.
    pub(super) end: f64,
    path: Path,
}

#[derive(Clone, Debug)]
enum Path {
    Alone(Vec<Leg<1>>),
    Together(Vec<Leg<MOST_TOGETHER>>),
}

fn on_legs<const B: usize>(legs: &[Leg<B>], place: usize, time: f64) -> State {
    let leg = legs.iter().find(|l| time <= l.end()).or(legs.last());
    leg.map(|l| l.at(time)[place]).unwrap_or_default()
}

impl Ahead {
    /// What a walk of one body will bring.
    pub(super) fn of_one(walker: &Walker<'_, 1>) -> Result<Self, MotionError> {
        let (end, legs) = piece_of(walker)?;
        Ok(Self { end, path: Path::Alone(legs) })
    }

    /// What a walk of several bodies will bring.
    pub(super) fn of_several(walker: &Walker<'_, MOST_TOGETHER>) -> Result<Self, MotionError> {
        let (end, legs) = piece_of(walker)?;
        Ok(Self { end, path: Path::Together(legs) })
    }

    /// The state of the member at this place of the island.
    pub(super) fn state(&self, place: usize, time: f64) -> State {
        match &self.path {
            Path::Alone(legs) => on_legs(legs, place, time),
            Path::Together(legs) => on_legs(legs, place, time),
        }
    }

    /// Where the formulas of the motion change within a stretch of time.
    pub(super) fn joints(&self, (from, until): (f64, f64)) -> Vec<f64> {
        let within = |t: &f64| *t > from && *t < until;
        match &self.path {
            Path::Alone(legs) => legs.iter().map(Leg::end).filter(within).collect(),
            Path::Together(legs) => legs.iter().map(Leg::end).filter(within).collect(),
        }
    }
}

/// When the next piece of a walk ends, and its path.
fn piece_of<const B: usize>(walker: &Walker<'_, B>) -> Result<(f64, Vec<Leg<B>>), MotionError> {
    let rest =
        || vec![Leg { start: walker.time, length: f64::INFINITY, course: Course::Rest(walker.states) }];
    if walker.ended.is_some() {
        return Ok((f64::INFINITY, rest()));
    }
    let mut trial = walker.clone();
    trial.path = Some(vec![]);
    trial.advance_all(&mut [const { None }; B])?;
    let legs = trial.path.take().filter(|legs| !legs.is_empty());
    // A piece without length is one that rests, or that an impact at the start has ended.
    Ok((trial.time, legs.unwrap_or_else(rest)))
}
