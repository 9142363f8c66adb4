//! What a run in space costs: a stool let go from a tilt without sliding and with friction, and a brick that is thrown with friction, each until it rests.

#![allow(clippy::unwrap_used, reason = "these bodies are known to be some")]
#![allow(clippy::print_stdout, reason = "the counts of work are part of the answer")]

use carom_motion::spatial::{Body, Friction, Options, State, World, run};
use carom_num::{Mat3, Rotation, Vec3};
use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;

const GRAVITY: Vec3 = Vec3 { x: 0.0, y: 0.0, z: -9.81 };

/// The body in this attitude and with this spin, its lowest support at a height \[m\].
fn above(body: &Body, turn: Vec3, spin: Vec3, height: f64) -> State {
    let attitude = Rotation::by(turn);
    let lowest = body.supports().iter().map(|r| attitude.apply(*r).z).fold(f64::INFINITY, f64::min);
    State { centre: Vec3::Z * (height - lowest), attitude, velocity: Vec3::ZERO, spin }
}

/// Four feet on a circle of 0.2 m, 0.4 m below the mass centre.
fn stool() -> Body {
    let foot = |k: u32| Rotation::by(Vec3::Z * (1.6 * f64::from(k))).apply(Vec3::new(0.2, 0.0, -0.4));
    Body::new(5.0, Mat3::diagonal(0.3, 0.3, 0.15), (0..4).map(foot).collect()).unwrap()
}

fn brick() -> Body {
    let [a, b, c] = [0.03, 0.02, 0.0125];
    let corner = |k: usize| Vec3::new([-a, a][k & 1], [-b, b][k >> 1 & 1], [-c, c][k >> 2]);
    let moment = |p: f64, q: f64| 0.162 * (p * p + q * q) / 3.0;
    let inertia = Mat3::diagonal(moment(b, c), moment(a, c), moment(a, b));
    Body::new(0.162, inertia, (0..8).map(corner).collect()).unwrap()
}

fn runs(c: &mut Criterion) {
    let tilted = above(&stool(), Vec3::new(0.1, 0.04, 0.0), Vec3::ZERO, 0.0);
    let thrown = above(&brick(), Vec3::new(0.4, 0.3, 1.0), Vec3::new(3.0, 1.0, 2.0), 0.03);
    let smooth = |body: Body| World::new(body, GRAVITY).unwrap();
    let rough = |body: Body, friction: f64| smooth(body).with_friction(Friction::new(friction)).unwrap();
    for (name, world, start) in [
        ("a stool, nothing slides", smooth(stool()), tilted),
        ("a stool, friction 0.3", rough(stool(), 0.3), tilted),
        ("a thrown brick, friction 0.3", rough(brick(), 0.3), thrown),
    ] {
        let options = Options::default();
        match run(&world, &start, &options, &mut ()) {
            Ok(run) => {
                println!("{name}: {:?} after {} impacts, {:?}", run.end, run.impacts.len(), run.effort)
            }
            Err(error) => println!("{name}: {error}"),
        }
        c.bench_function(name, |b| b.iter(|| run(black_box(&world), &start, &options, &mut ())));
    }
}

criterion_group!(benches, runs);
criterion_main!(benches);
