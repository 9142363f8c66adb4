//! A million impacts in a loop of Rust, on all cores: what the package's call is measured against. Prints the least time of fifteen [s].

use carom_impact::Law;
use carom_impact::planar::{ContactSet, Touch, single};
use carom_num::Vec2;
use rayon::prelude::*;
use std::time::Instant;

/// The columns of `measure.py`: the same golden-ratio sequence.
fn spread(i: usize, k: usize) -> f64 {
    ((i * k + 1) as f64 * 0.618_033_988_749_894_9).fract()
}

fn struck(i: usize) -> Option<(single::Outcome, Vec2, f64)> {
    let between = |low: f64, high: f64, k: usize| low + (high - low) * spread(i, k);
    let (mass, inertia) = (between(0.1, 5.0, 3), between(0.05, 2.0, 5));
    let touch = Touch {
        arm: Vec2::new(between(-1.0, 1.0, 7), between(-1.0, 0.0, 11)),
        normal: Vec2::new(0.0, 1.0),
        friction: between(0.0, 1.5, 13),
        restitution: between(0.0, 1.0, 17),
    };
    let (velocity, spin) =
        (Vec2::new(between(-3.0, 3.0, 19), between(-3.0, -1.0, 23)), between(-1.0, 1.0, 29));
    let set = ContactSet::<1, 2>::of_free_body(mass, inertia, velocity, spin, &[touch]).ok()?;
    let out = single::resolve(&set.alone(0), Law::Poisson).ok()?;
    let impulse = touch.normal * out.normal_impulse + touch.normal.turned_right() * out.tangential_impulse;
    Some((out, velocity + impulse * (1.0 / mass), spin + touch.arm.cross(impulse) / inertia))
}

#[expect(clippy::print_stdout, reason = "the time is the result")]
fn main() {
    let timed = || {
        let begun = Instant::now();
        let found: Vec<_> = (0..1_000_000).into_par_iter().map(struck).collect();
        let struck = found.iter().flatten().filter(|(out, ..)| out.normal_impulse > 0.0).count();
        (begun.elapsed().as_secs_f64(), struck)
    };
    let times: Vec<(f64, usize)> = (0..15).map(|_| timed()).collect();
    let least = times.iter().map(|(seconds, _)| *seconds).fold(f64::INFINITY, f64::min);
    println!("{least} {}", times[0].1);
}
