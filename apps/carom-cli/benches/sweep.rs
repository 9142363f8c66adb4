//! `carom sweep` of 4096 designs to a temporary folder, files and all: `cargo bench -p carom-cli`, less than a minute.

#![allow(missing_docs, reason = "criterion's macros make public items")]
#![allow(clippy::unwrap_used, reason = "a bench that cannot run its command fails")]

use criterion::{Criterion, SamplingMode, Throughput, criterion_group, criterion_main};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

const WORDS: [&str; 6] = [
    "sweep",
    "case_1.toml",
    "--grid",
    "contact.friction=0.05..0.25:64",
    "--grid",
    "start.to_edge=60..200 mm:64",
];

fn sweep(folder: &Path) {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let status = Command::new(env!("CARGO_BIN_EXE_carom"))
        .args(WORDS)
        .arg("--force")
        .arg("--out")
        .arg(folder)
        .current_dir(examples)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status();
    assert!(status.unwrap().success(), "the sweep failed");
}

fn sweeps(c: &mut Criterion) {
    let folder = std::env::temp_dir().join(format!("carom-bench-sweep-{}", std::process::id()));
    let mut group = c.benchmark_group("sweep");
    group.sample_size(10).sampling_mode(SamplingMode::Flat);
    group.warm_up_time(Duration::from_secs(1)).measurement_time(Duration::from_secs(10));
    group.throughput(Throughput::Elements(4096));
    group.bench_function("case 1 over friction and reach, 64 × 64 designs to Parquet", |b| {
        b.iter(|| {
            // A sweep goes on where the folder's last one stopped.
            let _none_yet = std::fs::remove_dir_all(&folder);
            sweep(&folder);
        });
    });
    group.finish();
    std::fs::remove_dir_all(&folder).unwrap();
}

criterion_group!(benches, sweeps);
criterion_main!(benches);
