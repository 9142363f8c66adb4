//! A throw in space, on a plane.

use super::{Pose, Spent, Thrown};
use carom_motion::spatial::{Budget, End, Options, State, Supports, World, run};

/// Follows a throw to its end: `face_of` says to which face supports at rest belong.
///
/// # Example
/// See [`sample`](super::sample).
pub fn thrown_in_space(
    (world, options): (&World, &Options),
    release: &State,
    face_of: impl Fn(Supports) -> Option<usize>,
) -> Thrown {
    let Ok(run) = run(world, release, options, &mut ()) else { return Thrown::LOST };
    let pose = match run.end {
        End::AtRest { held } => face_of(held).map_or(Pose::NoFace, Pose::Face),
        End::Balanced { .. } | End::Overturned => Pose::Balanced,
        End::Flat { .. } | End::FliesAway => Pose::NoFace,
        End::NoConsistentOutcome(_) => Pose::NoConsistentOutcome,
        End::Several(_) => Pose::Several,
        End::BudgetSpent(Budget::Time) => Pose::StillMoves(Spent::Time),
        End::BudgetSpent(Budget::Steps) => Pose::StillMoves(Spent::Steps),
        End::BudgetSpent(Budget::Impacts) => Pose::StillMoves(Spent::Impacts),
        End::Stopped => Pose::Failed,
    };
    Thrown { pose, time: run.time, impacts: run.effort.impacts }
}
