//! 10 000 random feeders: every run ends by name, energy never grows, nothing penetrates.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "a test fails by panicking, and says what it measured"
)]

use crate::random;

use carom_feeder::{Feeder, Outcome, Run, RunError};
use carom_motion::planar::{Options, World};
use std::collections::BTreeMap;

#[derive(Default)]
struct Worst {
    energy: f64,
    penetration: f64,
}

/// Largest growth of energy over a smooth piece or an impact, in units of the energy at stake, and deepest penetration, in units of the
/// part's size.
fn worst_of(feeder: &Feeder, world: &World, run: &Run) -> Worst {
    let mut worst = Worst::default();
    let size = feeder.part.body.shape.size();
    let weight = feeder.part.body.mass * feeder.gravity;
    for piece in &run.trace.pieces {
        let start = world.energy(&[piece.start]);
        let lowest =
            piece.samples.iter().map(|s| s.state.pose.centre.y).fold(piece.start.pose.centre.y, f64::min);
        // What can be lost is at stake: kinetic energy at the lowest point.
        let at_stake = (start - weight * lowest).abs().max(weight * size);
        worst.energy = worst.energy.max((world.energy(&[piece.end]) - start) / at_stake);
        for sample in &piece.samples {
            for o in 0..world.obstacles.len() {
                worst.penetration = worst.penetration.max(-world.clearance(0, &sample.state, o) / size);
            }
        }
    }
    for impact in &run.trace.impacts {
        let at_stake = impact.energy_before.max(weight * size);
        worst.energy = worst.energy.max((impact.energy_after - impact.energy_before) / at_stake);
    }
    worst
}

/// What a stretch of seeds gave.
#[derive(Default)]
struct Tally {
    ends: BTreeMap<Outcome, u32>,
    worst: Worst,
    faults: Vec<String>,
    impacts: usize,
    accumulations: usize,
}

/// Runs one feeder; false where the seed gives none (a plate crosses the start).
fn take(tally: &mut Tally, seed: u64) -> bool {
    let feeder = random::feeder(seed);
    let prepared = match feeder.prepare(Options::default()) {
        Ok(prepared) => prepared,
        Err(RunError::Problems(_)) => return false,
        Err(error) => panic!("seed {seed}: {error}"),
    };
    match prepared.run() {
        Ok(run) => {
            *tally.ends.entry(run.outcome).or_default() += 1;
            tally.impacts += run.trace.impacts.len();
            tally.accumulations += run.trace.accumulations.len();
            let here = worst_of(&feeder, prepared.world(), &run);
            if here.energy > 1e-10 || here.penetration > 1e-9 {
                tally.faults.push(format!(
                    "seed {seed}: energy {:e}, penetration {:e}",
                    here.energy, here.penetration
                ));
            }
            tally.worst.energy = tally.worst.energy.max(here.energy);
            tally.worst.penetration = tally.worst.penetration.max(here.penetration);
        }
        Err(error) => tally.faults.push(format!("seed {seed}: {error}")),
    }
    true
}

#[test]
fn ten_thousand_random_feeders_end_by_name() {
    let half = |first: u64| {
        let mut tally = Tally::default();
        let runs = (first..).step_by(2).filter(|seed| take(&mut tally, *seed)).take(5_000).count();
        (tally, runs)
    };
    let (even, odd) = std::thread::scope(|scope| {
        let other = scope.spawn(|| half(1));
        (half(0), other.join().unwrap())
    });
    let mut ends = even.0.ends.clone();
    for (outcome, count) in &odd.0.ends {
        *ends.entry(*outcome).or_default() += count;
    }
    let faults: Vec<&String> = even.0.faults.iter().chain(&odd.0.faults).collect();
    println!("{} feeders: {ends:?}", even.1 + odd.1);
    println!(
        "{} impacts, {} accumulations",
        even.0.impacts + odd.0.impacts,
        even.0.accumulations + odd.0.accumulations
    );
    println!(
        "energy grows by at most {:.1e} of what is at stake, penetration at most {:.1e} of the size",
        even.0.worst.energy.max(odd.0.worst.energy),
        even.0.worst.penetration.max(odd.0.worst.penetration)
    );
    assert!(faults.is_empty(), "{} faults: {:?}", faults.len(), &faults[..faults.len().min(12)]);
}
