//! How often the 95 % intervals of a fit hold the truth.
//!
//! ```sh
//! cargo run --release -p carom-study --example fit_coverage
//! ```
//!
//! 400 cases. In each, friction and restitution are drawn evenly from their ranges; the engine makes 20 drops over two plates, while slope and
//! start vary from drop to drop; the end of each is noted and its time, with a normal scatter of 10 ms. The fit gets these notes alone.
//! The part bounces, up to a restitution of 0.4: its times spread by ten to a hundred milliseconds, in lumps. A node has 64 samples, which is few
//! beside 20 drops: what is by chance in them must not make intervals too narrow.
//! A calibrated fit holds the truth in 95 % of the cases, give or take 2.2 % (two standard deviations of 400 throws).

#![allow(clippy::print_stdout, reason = "the share is what it is run for")]

#[path = "../tests/paper/mod.rs"]
mod paper;

use carom_feeder::Feeder;
use carom_motion::planar::Options;
use carom_num::normal::quantile;
use carom_num::sobol::random;
use carom_study::Dropped;
use carom_study::fits::{FitError, Observation, Plan, Seen, Simulated, Timed, fit};
use std::collections::BTreeMap;
use std::process::ExitCode;
use std::sync::Mutex;

const CASES: u64 = 400;
const DROPS: u64 = 20;
const LEVEL: f64 = 0.95;
/// How far the share may be from the level.
const ALLOWED: f64 = 0.03;
/// Scatter of the stopwatch [s].
const SCATTER: f64 = 0.01;
const SEED: u64 = 2024;
const RANGES: [[f64; 2]; 2] = [[0.04, 0.16], [0.0, 0.4]];
const NAMES: [&str; 2] = ["friction", "restitution"];

/// A rod of 0.1 m on two plates. The slope of the upper one has a standard deviation of 0.3°, the way to its edge one of 1 mm.
fn feeder(parameters: &[f64], point: &[f64]) -> Option<Feeder> {
    let [friction, restitution] = *parameters else { return None };
    let normal = |k: usize| point.get(k).map_or(0.0, |share| quantile(*share));
    let slope = (14.0 + 0.3 * normal(0)).to_radians();
    let to_edge = 0.1 + 0.001 * normal(1);
    let mut feeder = paper::layout(0.33, 0.35, friction, slope, to_edge)?;
    feeder.plates.iter_mut().for_each(|plate| plate.restitution = restitution);
    Some(feeder)
}

fn drop(parameters: &[f64], point: &[f64]) -> Simulated {
    Simulated::of(&Dropped::of(feeder(parameters, point).as_ref(), 1, &Options::default()), 1)
}

/// What an observer notes of a case.
fn observed(case: u64, truth: &[f64]) -> Vec<Observation> {
    let note = |k: u64| {
        let number = case * DROPS + k;
        let at = |dimension: usize| random(SEED, number, 2 + dimension);
        let drop = drop(truth, &[at(0), at(1)]);
        let time = drop.time.map(|time| time + SCATTER * quantile(at(2)));
        Observation {
            condition: 0,
            seen: Seen { ending: Some(drop.ending), face: None },
            time: time.map(|time| Timed { time, scatter: Some(SCATTER) }),
            count: 1,
        }
    };
    (0..DROPS).map(note).collect()
}

/// Drops of a node, by the bits of what they depend on: every case asks the same ones.
type Known = BTreeMap<Vec<u64>, Simulated>;

fn main() -> Result<ExitCode, FitError> {
    let known: Mutex<Known> = Mutex::new(BTreeMap::new());
    let remembered = |parameters: &[f64], _: usize, point: &[f64]| {
        let key: Vec<u64> = parameters.iter().chain(point).map(|value| value.to_bits()).collect();
        let before = known.lock().ok().and_then(|known| known.get(&key).copied());
        before.unwrap_or_else(|| {
            let found = drop(parameters, point);
            if let Ok(mut known) = known.lock() {
                known.insert(key, found);
            }
            found
        })
    };
    let plan = Plan {
        ranges: RANGES.to_vec(),
        conditions: 1,
        dimensions: 2,
        samples: 64,
        seed: 1,
        nodes: 2500,
        level: LEVEL,
    };
    let (mut held, mut resolved) = ([0_u32; 2], 0);
    for case in 0..CASES {
        let draw = |axis: usize| {
            let [low, high] = RANGES[axis];
            low + (high - low) * random(SEED, case, axis)
        };
        let truth = [draw(0), draw(1)];
        let found = fit(&plan, &observed(case, &truth), remembered)?;
        resolved += u32::from(found.resolved);
        for ((held, parameter), truth) in held.iter_mut().zip(&found.parameters).zip(truth) {
            *held += u32::from(parameter.low <= truth && truth <= parameter.high);
        }
    }
    println!("{} drops of the engine", known.lock().map_or(0, |known| known.len()));
    println!("{CASES} cases of {DROPS} drops, seed {SEED}; {resolved} resolved within {} nodes", plan.nodes);
    let mut good = true;
    for (name, held) in NAMES.iter().zip(held) {
        let share = f64::from(held) / CASES as f64;
        println!("{name}: {held} intervals hold the truth, {:.2} % (95 ± 3 % wanted)", 100.0 * share);
        good &= (share - LEVEL).abs() <= ALLOWED;
    }
    Ok(if good { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
