//! A map of 30 × 30 cells, the outcomes of 300 × 300 cells, a yield of 1024 drops, and one by its boundary: `cargo bench -p carom-scene`, about a minute; on one core with
//! `RAYON_NUM_THREADS=1`.

#![allow(missing_docs, reason = "criterion's macros make public items")]
#![allow(clippy::unwrap_used, reason = "the examples are known to be scenes")]
#![allow(clippy::print_stdout, reason = "what a yield is known to belongs to its time")]

use carom_scene::{Drawn, Scene};
use carom_study::regions::{Options, Range, cells};
use carom_study::yields::{Plan, Points, REPETITIONS, locate, sample};
use carom_study::{Dropped, Ending, map};
use criterion::{Criterion, SamplingMode, Throughput, criterion_group, criterion_main};
use std::path::Path;
use std::time::Duration;

/// Drops of the yield.
const SAMPLES: u64 = 1024;

/// Lines of each repetition of a yield that is located.
const LINES: u64 = 8;

fn example(name: &str) -> Scene {
    Scene::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name)).unwrap()
}

fn maps(c: &mut Criterion) {
    let scene = example("case_1.toml");
    let variants = scene.variants(&["contact.friction", "start.to_edge"]).unwrap();
    let (friction, reach) =
        (Range { from: 0.05, to: 0.25, count: 30 }, Range { from: 0.06, to: 0.2, count: 30 });
    let draw =
        || map::draw(friction, reach, &Options::default(), 1, |x, y| variants.feeder(&[x, y]).ok()).unwrap();
    let mut group = c.benchmark_group("map");
    group.sample_size(10).sampling_mode(SamplingMode::Flat);
    group.warm_up_time(Duration::from_secs(1)).measurement_time(Duration::from_secs(10));
    group.throughput(Throughput::Elements(draw().drops as u64));
    group.bench_function("case 1 over friction and reach, 30 × 30 cells", |b| b.iter(draw));
    let scene = example("case_2.toml");
    let variants = scene.variants(&["contact.friction", "start.to_edge"]).unwrap();
    let [friction, reach] = [friction, reach].map(|range| Range { count: 300, ..range });
    let draw = || {
        cells(friction, reach, |x, y| {
            Dropped::of(variants.feeder(&[x, y]).ok().as_ref(), 1, &Default::default()).ending
        })
        .unwrap()
    };
    group.throughput(Throughput::Elements(draw().evaluations as u64));
    group.bench_function("case 2 over friction and reach, 300 × 300 cells", |b| b.iter(draw));
    group.finish();
}

fn yields(c: &mut Criterion) {
    let scene = example("design_turn_once.toml");
    let varied = scene.varied().unwrap();
    let plates = scene.feeder().plates.len();
    let plan = Plan {
        dimensions: varied.dimensions(),
        samples: SAMPLES / REPETITIONS as u64,
        seed: 1,
        points: Points::Sobol,
        plates,
        plate: plates - 1,
    };
    let wanted = |run: &_| scene.ends_as_wanted(run).unwrap_or_else(|| Ending::of(run, plates - 1).arrives());
    let draw =
        || sample(&plan, |point| varied.feeder(point), wanted, |point| varied.distance(point)).unwrap();
    let mut group = c.benchmark_group("yield");
    group.sample_size(10).sampling_mode(SamplingMode::Flat);
    group.warm_up_time(Duration::from_secs(1)).measurement_time(Duration::from_secs(10));
    group.throughput(Throughput::Elements(draw().drops));
    group.bench_function("three plates with tolerances, 1024 drops", |b| b.iter(draw));
    group.finish();
}

/// A yield by its boundary; what came out is said, so that the time stands beside what it buys.
fn located(c: &mut Criterion) {
    let scene = example("designer.toml");
    let varied = scene.varied().unwrap();
    let plan = Plan {
        dimensions: varied.dimensions(),
        samples: LINES,
        seed: 1,
        points: Points::Sobol,
        plates: scene.feeder().plates.len(),
        plate: scene.feeder().plates.len() - 1,
    };
    let ends = |point: &[f64]| {
        let dropped = Dropped::of(varied.feeder(point).as_ref(), plan.plate, &Default::default());
        dropped.run.is_some_and(|run| scene.ends_as_wanted(&run) == Some(true))
    };
    let draw = || locate(&plan, ends).unwrap();
    let found = draw();
    let half = 0.5 * (found.wanted.high - found.wanted.low);
    println!(
        "{:.5} ± {half:.1e} by {} drops, {} quantities",
        found.wanted.share, found.drops, plan.dimensions
    );
    let mut group = c.benchmark_group("yield");
    group.sample_size(10).sampling_mode(SamplingMode::Flat);
    group.throughput(Throughput::Elements(found.drops));
    group.bench_function("two plates with tolerances, by the boundary", |b| b.iter(draw));
    group.finish();
}

criterion_group!(benches, maps, yields, located);
criterion_main!(benches);
