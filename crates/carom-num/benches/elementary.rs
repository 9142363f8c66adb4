//! What the elementary functions cost: the platform's against those of `carom_num::elementary`, and how often their bits differ.
//!
//! `docs/decisions/0001-elementary-functions.md` quotes one run of `cargo bench -p carom-num --bench elementary`.
#![allow(clippy::print_stdout, reason = "a bench reports to the person who runs it")]
#![allow(clippy::disallowed_methods, reason = "the platform's functions are what is compared")]

use carom_num::elementary;
use criterion::{Criterion, Throughput};
use std::hint::black_box;

/// Arguments of one timed pass: few enough to stay in the first-level cache.
const PASS: usize = 1000;
/// Arguments whose results are compared bit by bit.
const COMPARED: usize = 1_000_000;
/// The argument of `sin_cos` runs over (0, `RANGE`) rad: a part may turn a dozen times.
const RANGE: f64 = 100.0;

/// The i-th point of the golden-ratio sequence in [0, 1): evenly spread, and the same in every run.
fn spread(i: usize) -> f64 {
    (i as f64 * 0.618_033_988_749_894_9).fract()
}

/// An angle in (0, `RANGE`) [rad].
fn angle(i: usize) -> f64 {
    RANGE * spread(i + 1)
}

/// A vector (y, x) in the square of half-side 1.
fn vector(i: usize) -> (f64, f64) {
    (2.0 * spread(i + 1) - 1.0, 2.0 * spread(7 * i + 3) - 1.0)
}

fn time_sin_cos(c: &mut Criterion) {
    let angles: Vec<f64> = (0..PASS).map(angle).collect();
    let mut group = c.benchmark_group("sin_cos");
    group.throughput(Throughput::Elements(PASS as u64));
    group.bench_function("platform", |b| b.iter(|| sum(&angles, |x| black_box(x).sin_cos())));
    group.bench_function("libm", |b| b.iter(|| sum(&angles, |x| elementary::sin_cos(black_box(x)))));
    group.bench_function("platform, in a chain", |b| b.iter(|| chain(&angles, f64::sin_cos)));
    group.bench_function("libm, in a chain", |b| b.iter(|| chain(&angles, elementary::sin_cos)));
    group.finish();
}

fn time_atan2(c: &mut Criterion) {
    let vectors: Vec<(f64, f64)> = (0..PASS).map(vector).collect();
    let mut group = c.benchmark_group("atan2");
    group.throughput(Throughput::Elements(PASS as u64));
    group.bench_function("platform", |b| b.iter(|| total(&vectors, |y, x| black_box(y).atan2(x))));
    group.bench_function("libm", |b| b.iter(|| total(&vectors, |y, x| elementary::atan2(black_box(y), x))));
    group.finish();
}

fn sum(angles: &[f64], f: impl Fn(f64) -> (f64, f64)) -> f64 {
    angles.iter().map(|&x| f(x)).map(|(s, c)| s + c).sum()
}

/// Each argument waits for the result before it, as in an integration.
fn chain(angles: &[f64], f: impl Fn(f64) -> (f64, f64)) -> f64 {
    angles.iter().fold(0.0, |before, &x| {
        let (s, c) = f(black_box(x) + 0.0 * before);
        s + c
    })
}

fn total(vectors: &[(f64, f64)], f: impl Fn(f64, f64) -> f64) -> f64 {
    vectors.iter().map(|&(y, x)| f(y, x)).sum()
}

/// Steps between two numbers of one sign on the line of all f64.
fn steps_apart(a: f64, b: f64) -> u64 {
    a.to_bits().abs_diff(b.to_bits())
}

/// Prints how many of the results differ, and by how many steps at most.
fn report(name: &str, differences: impl Iterator<Item = u64>) {
    let (mut unequal, mut largest) = (0_u64, 0);
    for d in differences {
        unequal += u64::from(d > 0);
        largest = largest.max(d);
    }
    println!("{name}: {unequal} of {COMPARED} differ, by {largest} ulp at most");
}

fn compare_bits() {
    let pairs = || (0..COMPARED).map(angle).map(|x| (x.sin_cos(), elementary::sin_cos(x)));
    report("sin", pairs().map(|(p, l)| steps_apart(p.0, l.0)));
    report("cos", pairs().map(|(p, l)| steps_apart(p.1, l.1)));
    let either = |p: (f64, f64), l: (f64, f64)| steps_apart(p.0, l.0).max(steps_apart(p.1, l.1));
    report("sin or cos", pairs().map(|(p, l)| either(p, l)));
    report("atan2", (0..COMPARED).map(vector).map(|(y, x)| steps_apart(y.atan2(x), elementary::atan2(y, x))));
}

fn main() {
    compare_bits();
    let mut criterion = Criterion::default().configure_from_args();
    time_sin_cos(&mut criterion);
    time_atan2(&mut criterion);
    criterion.final_summary();
}
