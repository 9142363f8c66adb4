//! 10 000 random feeders: every run ends by name, energy never grows, nothing penetrates.

mod random;

use carom_feeder::{Feeder, Outcome, Run, RunError};
use carom_motion::planar::World;
use std::collections::BTreeMap;

#[derive(Default)]
struct Worst {
    energy: f64,
    penetration: f64,
}

/// Largest growth of energy over a run, in units of the energy at stake, and deepest penetration, in units of the part's size.
fn worst_of(feeder: &Feeder, world: &World, run: &Run) -> Worst {
    let mut worst = Worst::default();
    let size = feeder.part.body.shape.size();
    let weight = feeder.part.body.mass * feeder.gravity;
    let scale = |e: f64| e.abs().max(weight * size);
    for piece in &run.trace.pieces {
        let start = world.energy(&piece.start);
        let lowest =
            piece.samples.iter().map(|s| s.state.pose.centre.y).fold(piece.start.pose.centre.y, f64::min);
        // What falls can be lost: kinetic energy at the lowest point is the scale.
        let at_stake = scale(start + weight * -lowest);
        let mut before = start;
        for sample in &piece.samples {
            let energy = world.energy(&sample.state);
            worst.energy = worst.energy.max((energy - before) / at_stake);
            before = energy;
            for o in 0..world.obstacles.len() {
                worst.penetration = worst.penetration.max(-world.clearance(&sample.state, o) / size);
            }
        }
    }
    for impact in &run.trace.impacts {
        worst.energy =
            worst.energy.max((impact.energy_after - impact.energy_before) / scale(impact.energy_before));
    }
    worst
}

#[test]
fn random_feeders_end_by_name() {
    let (mut ends, mut worst, mut faults) = (BTreeMap::<Outcome, u32>::new(), Worst::default(), vec![]);
    let (mut impacts, mut accumulations, mut checked) = (0, 0, 0_u32);
    let mut deep = vec![];
    for seed in 0.. {
        let feeder = random::feeder(seed);
        let prepared = match feeder.prepare(Default::default()) {
            Ok(prepared) => prepared,
            // A plate that crosses the start: not a feeder.
            Err(RunError::Problems(_)) => continue,
            Err(error) => panic!("seed {seed}: {error}"),
        };
        checked += 1;
        match prepared.run() {
            Ok(run) => {
                *ends.entry(run.outcome).or_default() += 1;
                impacts += run.trace.impacts.len();
                accumulations += run.trace.accumulations.len();
                let here = worst_of(&feeder, prepared.world(), &run);
                if here.energy > 1e-10 || here.penetration > 1e-9 {
                    deep.push((seed, here.energy, here.penetration));
                }
                worst.energy = worst.energy.max(here.energy);
                worst.penetration = worst.penetration.max(here.penetration);
            }
            Err(error) => faults.push((seed, error)),
        }
        if checked == 10_000 {
            break;
        }
    }
    println!("{checked} feeders: {ends:?}; {impacts} impacts, {accumulations} accumulations");
    println!(
        "energy grows by at most {:.1e} of what is at stake, penetration at most {:.1e} of the size",
        worst.energy, worst.penetration
    );
    assert!(faults.is_empty(), "{} faults: {:?}", faults.len(), &faults[..faults.len().min(12)]);
    assert!(deep.is_empty(), "{} bad runs: {:?}", deep.len(), &deep[..deep.len().min(12)]);
}
