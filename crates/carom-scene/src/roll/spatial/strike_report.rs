//! One strike of a body in space, told.

use super::SpatialRollProblem;
use super::SpatialRollRun;
use super::follow::SpatialStrike;
use super::report::{
    SpatialContactReport, SpatialEndStateReport, SpatialRejectedReport, SpatialStrikeReport, finite,
};
use super::rough_strike;
use super::states::{Fails, States, states, touching_at};
use super::words::{kept_words, names};
use carom_impact::spatial::Conclusion;
use carom_motion::spatial::{Clock, End, State, Supports};
use carom_num::Vec3;

fn outcome(conclusion: Conclusion) -> &'static str {
    match conclusion {
        Conclusion::Unique => "unique",
        Conclusion::Several => "several",
        Conclusion::None => "none",
    }
}

/// A strike, as it is followed.
pub(super) fn strike_report(
    problem: &SpatialRollProblem,
    strike: &SpatialStrike,
) -> Option<SpatialStrikeReport> {
    let impact = &strike.impact;
    let rough = problem.world.friction().is_some();
    let states = if rough {
        rough_strike::states(problem, &strike.before, [impact.touching, impact.held], impact.conclusion)?
    } else {
        states(problem, &strike.before, impact.touching)?
    };
    let followed = Followed { kept: Some(impact.kept), striking: impact.striking };
    let contacts = contacts(problem, &states, &followed, [impact.kept, impact.sliding], &|k| {
        let impulse = impact.impulses.get(k).map_or(Vec3::ZERO, |(_, p)| *p);
        let Some((i, _)) = impact.impulses.get(k) else { return [impulse, Vec3::ZERO] };
        let velocity = strike.after.velocity_of(problem.world.body().supports()[*i]);
        // What stays on the plane, or rests, is known better than the impulses say it.
        let velocity = match (impact.kept.contains(*i), impact.sliding.contains(*i)) {
            (true, false) => Vec3::ZERO,
            (true, true) => Vec3::new(velocity.x, velocity.y, 0.0),
            _ => velocity,
        };
        [impulse, velocity]
    });
    Some(SpatialStrikeReport {
        contacts,
        state: kept_words(problem, [impact.kept, impact.sliding], impact.touching),
        kept: names(problem, impact.kept),
        friction_demand: finite(impact.friction_demand).filter(|_| !rough),
        friction_is_bound: states.consistent.iter().any(|s| s.kept == impact.kept && s.freedom > 1),
        velocity_m_s: Some(strike.after.velocity.to_array()),
        spin_rad_s: Some(impact.spin_after.to_array()),
        energy_after: Some(impact.kinetic_after),
        ..unresolved(problem, &states, &followed, &strike.before, impact.time)
    })
}

/// Which state of a strike is followed, and which contacts come down.
struct Followed {
    kept: Option<Supports>,
    striking: Supports,
}

/// The strike in which a run has ended, because the law has no way on or several.
pub(super) fn last_strike(problem: &SpatialRollProblem, run: &SpatialRollRun) -> Option<SpatialStrikeReport> {
    let (Some(End::NoConsistentOutcome(Clock::Impact)) | Some(End::Several(Clock::Impact))) = run.end else {
        return None;
    };
    let touching = touching_at(problem, &run.last);
    let held = run.pieces.last().map_or(Supports::NONE, |piece| piece.mode.held(problem.world.body()));
    let states = if problem.world.friction().is_some() {
        let several = matches!(run.end, Some(End::Several(_)));
        let conclusion = if several { Conclusion::Several } else { Conclusion::None };
        rough_strike::states(problem, &run.last, [touching, held], conclusion)?
    } else {
        states(problem, &run.last, touching)?
    };
    let followed = Followed { kept: None, striking: touching.but(held) };
    Some(unresolved(problem, &states, &followed, &run.last, run.end_time))
}

/// A strike as far as it is known before a way on is chosen.
fn unresolved(
    problem: &SpatialRollProblem,
    states: &States,
    followed: &Followed,
    before: &State,
    time: f64,
) -> SpatialStrikeReport {
    let ends = states.consistent.iter().map(|s| SpatialEndStateReport {
        hypothesis: s.hypothesis.clone(),
        kept: names(problem, s.kept),
        contacts: contacts(problem, states, followed, [s.kept, Supports::NONE], &|k| s.contacts[k]),
        friction_demand: finite(s.friction_demand),
        margin: s.slack,
        indeterminate: s.freedom > 0,
        friction_is_bound: s.freedom > 1,
        followed: followed.kept == Some(s.kept),
    });
    let rejected = states.rejected.iter().map(|r| SpatialRejectedReport {
        hypothesis: r.hypothesis.clone(),
        kept: names(problem, r.kept),
        because: r.because.clone(),
        at: r.fails.map(|(i, _)| names(problem, Supports::one(i)).concat()),
        normal_impulse: r.fails.and_then(|(_, f)| if let Fails::Impulse(p) = f { Some(p) } else { None }),
        normal_velocity_m_s: r
            .fails
            .and_then(|(_, f)| if let Fails::Velocity(v) = f { Some(v) } else { None }),
    });
    let word = outcome(states.conclusion);
    SpatialStrikeReport {
        t_s: time,
        outcome: word,
        state: match (problem.world.friction().is_some(), word) {
            (false, "none") => "no state is consistent",
            (false, _) => "several states are consistent",
            (true, "none") => "no way through it was found",
            (true, _) => "several ways through it are consistent",
        }
        .to_owned(),
        kept: vec![],
        struck: names(problem, followed.striking),
        contacts: vec![],
        end_states: ends.collect(),
        rejected: rejected.collect(),
        rejected_left_out: states.left_out,
        forks: states.forks.clone(),
        friction_demand: None,
        friction_is_bound: false,
        velocity_before_m_s: before.velocity.to_array(),
        velocity_m_s: None,
        spin_before_rad_s: before.spin.to_array(),
        spin_rad_s: None,
        tilt_rad: problem.tilt(before),
        energy_before: before.kinetic(problem.world.body()),
        energy_after: None,
        closed_form: None,
    }
}

fn contacts(
    problem: &SpatialRollProblem,
    states: &States,
    followed: &Followed,
    [kept, sliding]: [Supports; 2],
    of: &dyn Fn(usize) -> [Vec3; 2],
) -> Vec<SpatialContactReport> {
    let report = |(k, i): (usize, usize)| {
        let [impulse, velocity] = of(k);
        SpatialContactReport {
            name: names(problem, Supports::one(i)).concat(),
            strikes: followed.striking.contains(i),
            state: match (kept.contains(i), sliding.contains(i)) {
                (true, true) => "slides",
                (true, false) => "keeps",
                (false, _) => "opens",
            },
            normal_impulse: impulse.z,
            tangential_impulse: (impulse.x * impulse.x + impulse.y * impulse.y).sqrt(),
            impulse: impulse.to_array(),
            velocity_before_m_s: states.before.get(k).copied().unwrap_or(Vec3::ZERO).to_array(),
            velocity_m_s: velocity.to_array(),
        }
    };
    states.touching.iter().enumerate().map(report).collect()
}
