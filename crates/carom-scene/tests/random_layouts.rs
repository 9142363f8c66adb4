//! Drops through layouts taken at random: those that designs search among, plates that cross and narrow gaps included.

#![allow(clippy::print_stdout, reason = "the numbers that were measured")]

use carom_feeder::{Effort, Outcome};
use carom_scene::Scene;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use std::path::Path;

/// Layouts of each design.
const LAYOUTS: u64 = 400;
/// Events of the longest of these drops: 196 were seen; one that goes round in circles spends thousands.
const MOST_EVENTS: u64 = 500;
/// Evaluations of its equations: 3924 were seen.
const MOST_EVALUATIONS: u64 = 10_000;

/// A drop of each of a design's layouts, with tolerances: how it ended, and its work.
fn drops(design: &str) -> Vec<(u64, Outcome, Effort)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../bench/studies/designs");
    let scene = Scene::read(&folder.join(format!("{design}.toml"))).unwrap();
    let space = scene.design_space().unwrap();
    let mut out = vec![];
    for seed in 0..LAYOUTS {
        let mut rng = Pcg64::seed_from_u64(seed);
        let mut point =
            |count: usize| -> Vec<f64> { (0..count).map(|_| rng.random_range(0.0..1.0)).collect() };
        let Ok(layout) = space.scene(&point(space.quantities().len())) else { continue };
        let varied = layout.varied().unwrap();
        let Some(feeder) = varied.feeder(&point(varied.quantities().len())) else { continue };
        let run = feeder.run_untraced().unwrap_or_else(|error| panic!("{design}, layout {seed}: {error}"));
        out.push((seed, run.outcome, run.effort));
    }
    out
}

#[test]
fn a_drop_ends_after_work_in_proportion() {
    let (mut events, mut evaluations, mut count) = (0, 0, 0);
    for part in ["paper", "steel_plate", "hex_bar"] {
        for aim in ["gentle_turn", "never_turn"] {
            for (seed, outcome, work) in drops(&format!("{part}_{aim}")) {
                let at = format!("{part}_{aim}, layout {seed}: {outcome:?} after {work:?}");
                assert_ne!(outcome, Outcome::NeverFlat, "{at}");
                assert!(work.events <= MOST_EVENTS && work.rhs_evaluations <= MOST_EVALUATIONS, "{at}");
                (events, evaluations) = (work.events.max(events), work.rhs_evaluations.max(evaluations));
                count += 1;
            }
        }
    }
    println!("{count} drops: at most {events} events and {evaluations} evaluations");
    assert!(count > 2000, "{count}");
}
