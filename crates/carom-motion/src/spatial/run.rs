//! What a run says: its impacts, the series it closed, and how it ended.

use super::terms::Effort;
use super::{Mode, State, Supports};
use carom_impact::spatial::Conclusion;
use carom_num::{Rotation, Vec3};

/// An impact.
#[derive(Clone, Debug, PartialEq)]
pub struct Impact {
    /// Time \[s\].
    pub time: f64,
    /// The supports that touch the plane.
    pub touching: Supports,
    /// Those of them that come down on it.
    pub striking: Supports,
    /// Those that were held before it.
    pub held: Supports,
    /// Those that stay on the plane after it.
    pub kept: Supports,
    /// Those of them that slide; without friction none does.
    pub sliding: Supports,
    /// The rotation of the body's axes into the world's.
    pub attitude: Rotation,
    /// Angular velocity before, body axes [rad/s].
    pub spin_before: Vec3,
    /// Angular velocity after, body axes [rad/s].
    pub spin_after: Vec3,
    /// Kinetic energy before \[J\].
    pub kinetic_before: f64,
    /// Kinetic energy after \[J\].
    pub kinetic_after: f64,
    /// Potential energy, zero with the mass centre at the world's origin \[J\].
    pub potential: f64,
    /// The impulse on each touching support, world axes [N s]; where they are a family, the shortest member, or one that does not pull.
    pub impulses: Vec<(usize, Vec3)>,
    /// The least friction coefficient that the impulses need, as [`carom_impact::spatial::KeptState::friction_demand`] says.
    pub friction_demand: f64,
    /// How many different motions the law allows: of several, [`super::Options::choice`] has chosen.
    pub conclusion: Conclusion,
}

impl Impact {
    /// The supports that touch and leave the plane.
    pub fn opened(&self) -> Supports {
        self.touching.but(self.kept)
    }
}

/// A series of infinitely many impacts in finite time, closed at its limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closing {
    /// Time of the last impact that was resolved \[s\].
    pub time: f64,
    /// Time of the limit \[s\].
    pub limit: f64,
    /// How many impacts make a period.
    pub period: usize,
    /// The ratio of the lengths of successive periods.
    pub ratio: f64,
    /// The supports that rest after it.
    pub kept: Supports,
}

/// A stretch of motion between two events.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// What the body does.
    pub mode: Mode,
    /// Start \[s\].
    pub start_time: f64,
    /// End \[s\].
    pub end_time: f64,
    /// State at the start.
    pub start: State,
    /// State at the end.
    pub end: State,
}

/// Which clock a question was asked on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clock {
    /// In an impact.
    Impact,
    /// In motion: which of the supports that touch at rest are held.
    Motion,
}

/// Which budget was spent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Budget {
    /// Of time.
    Time,
    /// Of steps.
    Steps,
    /// Of impacts.
    Impacts,
}

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// It rests on these supports.
    AtRest {
        /// Three or more, not on one line.
        held: Supports,
    },
    /// It stands still on a support or an edge, in an equilibrium that does not last.
    Balanced {
        /// What it stands on.
        held: Supports,
    },
    /// It leans over as far as [`super::Overturning`] says.
    Overturned,
    /// Without sliding there is no way on.
    NoConsistentOutcome(Clock),
    /// There are several ways on, and [`super::Choice::End`] takes none of them.
    Several(Clock),
    /// The budget is used up.
    BudgetSpent(Budget),
    /// The observer has seen enough.
    Stopped,
}

/// A run, from its start to its end.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// How it ended.
    pub end: End,
    /// When it ended \[s\].
    pub time: f64,
    /// State at the end.
    pub state: State,
    /// All impacts, in their order.
    pub impacts: Vec<Impact>,
    /// All series that were closed.
    pub closings: Vec<Closing>,
    /// The largest change of the energy between two events, in units of m g × reach plus the kinetic energy; without the integration's error it
    /// were 0.
    pub drift: f64,
    /// Work of friction between impacts \[J\]: it is never positive.
    pub friction_work: f64,
    /// Work done.
    pub effort: Effort,
}
