//! How a drop ends, as plain numbers.

use crate::plain::{DropOutcome, DropResult, Verdict};
use crate::refusal::Refusal;
use crate::text::{no_run, scene};
use carom_feeder::{Outcome, Run};
use std::ffi::c_int;

/// Drops the part of a scene.
pub(crate) fn drop(name: &str, text: &str) -> Result<DropResult, Refusal> {
    let scene = scene(name, text)?;
    let run = scene.feeder().run_untraced().map_err(|error| no_run(scene.name(), error))?;
    Ok(result(&run))
}

fn result(run: &Run) -> DropResult {
    let landing = run.final_landing();
    let verdict = match landing.and_then(|landing| landing.verdict) {
        None => Verdict::None,
        Some(carom_feeder::Verdict::Same) => Verdict::Same,
        Some(carom_feeder::Verdict::Turned) => Verdict::Turned,
        Some(carom_feeder::Verdict::Face(_)) => Verdict::Face,
    };
    let face = landing.filter(|_| verdict != Verdict::None).and_then(|landing| landing.face);
    DropResult {
        outcome: outcome(run.outcome),
        verdict,
        face: face.and_then(|face| c_int::try_from(face).ok()).unwrap_or(-1),
        end_time: run.end_time,
        strikes: run.effort.impacts,
        landings: run.landings.len(),
        margin: run.margin,
    }
}

fn outcome(outcome: Outcome) -> DropOutcome {
    match outcome {
        Outcome::Landed => DropOutcome::Landed,
        Outcome::Delivered => DropOutcome::Delivered,
        Outcome::Stuck => DropOutcome::Stuck,
        Outcome::OnEnd => DropOutcome::OnEnd,
        Outcome::Jammed => DropOutcome::Jammed,
        Outcome::Missed => DropOutcome::Missed,
        Outcome::Escaped => DropOutcome::Escaped,
        Outcome::NeverFlat => DropOutcome::NeverFlat,
        Outcome::Unresolved => DropOutcome::Unresolved,
        Outcome::Blocked => DropOutcome::Blocked,
    }
}

#[cfg(test)]
mod tests;
