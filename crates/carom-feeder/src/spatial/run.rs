//! What a run of a feeder in space says.

use crate::first_contact::Doing;
use crate::run::{Effort, Jam, Landing, Outcome, Stage};
use carom_motion::spatial::{Closing, Impact, Samples, State, Touch};

/// How the part left over the last plate's edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exit {
    /// Time [s].
    pub time: f64,
    /// Place, attitude and motion.
    pub state: State,
}

/// One run.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// How it ended.
    pub outcome: Outcome,
    /// When it ended [s].
    pub end_time: f64,
    /// Place, attitude and motion then.
    pub end: State,
    /// The landings, in order.
    pub landings: Vec<Landing>,
    /// The walls that it touched on its way, by their numbers from 0.
    pub walls_touched: Vec<usize>,
    /// How it left, when delivered.
    pub exit: Option<Exit>,
    /// Between what it jammed; `None` for every other outcome.
    pub jam: Option<Jam<Touch>>,
    /// Impacts that had more than one consistent outcome, of which one was followed.
    pub forks: u64,
    /// Counts of the work done.
    pub effort: Effort,
    /// Stages by name; empty without a trace.
    pub stages: Vec<Stage<State, Touch>>,
    /// All impacts, in order.
    pub impacts: Vec<Impact>,
    /// Speed of the striking point just before each of them [m/s].
    pub struck_at: Vec<f64>,
    /// The plate or wall that each of them strikes first: plates first, then walls.
    pub struck: Vec<usize>,
    /// Series of impacts that were closed at their limit.
    pub closings: Vec<Closing>,
    /// The way between them; empty without a trace.
    pub samples: Samples,
}

impl Run {
    /// The landing with which the run ended: the last one, where the part stayed on that plate or was delivered from it.
    pub fn final_landing(&self) -> Option<&Landing> {
        let stays = matches!(self.outcome, Outcome::Landed | Outcome::Delivered | Outcome::Stuck);
        let at = match self.outcome {
            Outcome::Stuck => self.stages.last().and_then(|stage| stage.obstacle),
            _ => None,
        };
        self.landings.last().filter(|landing| stays && at.is_none_or(|plate| landing.plate == plate))
    }

    /// The number of the first strike on the plate of the final landing: the one that decides.
    pub fn deciding_strike(&self) -> Option<usize> {
        let landing = self.final_landing()?;
        self.struck.iter().position(|owner| *owner == landing.plate)
    }

    /// What the part was doing until a time [s]: its last stage that began before; in flight, the plate or wall that it left or struck last.
    pub fn doing_until(&self, time: f64) -> Doing {
        let strikes = self.impacts.iter().map(|impact| impact.time).zip(self.struck.iter().copied());
        Doing::until(time, &self.stages, strikes, usize::MAX)
    }
}
