//! One two-plate drop for its verdict alone: the paper's two cases.
//!
//! `cargo bench -p carom-feeder` prints the time of a drop and, first, its counts of work.

#![allow(missing_docs, reason = "criterion's macros make public items")]
#![allow(clippy::print_stdout, reason = "the counts of work are part of the answer")]
#![allow(clippy::unwrap_used, reason = "the paper's feeder is known to be one")]

#[path = "../tests/paper/mod.rs"]
mod paper;

use carom_motion::planar::Options;
use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;

fn drops(c: &mut Criterion) {
    let options = Options { tolerance: 1e-10, ..Options::default() };
    for (name, slope, line) in [("case 1", 15.0, (0.347, 0.2)), ("case 2", 10.0, (0.428, 0.3))] {
        let feeder = paper::feeder(slope, line, 0.0);
        let Ok(prepared) = feeder.prepare(options) else { continue };
        if let Ok(run) = prepared.run_untraced() {
            println!("{name}: {:?}, {} events", run.effort, run.effort.events);
        }
        c.bench_function(&format!("two-plate drop, {name}, rtol 1e-10, no trace"), |b| {
            b.iter(|| black_box(&prepared).run_untraced());
        });
    }
}

criterion_group!(benches, drops);
criterion_main!(benches);
