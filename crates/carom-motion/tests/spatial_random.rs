//! Random bodies in space: what holds for all of them.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]
#![allow(clippy::print_stdout, reason = "what random bodies come to is a measurement")]

use carom_motion::spatial::{Body, End, Mode, Observer, Options, RollError, Run, Samples, State, World, run};
use carom_num::{Mat3, Rotation, Vec3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use std::collections::BTreeMap;

fn vector(rng: &mut Pcg64, size: f64) -> Vec3 {
    let mut one = || rng.random_range(-size..size);
    Vec3::new(one(), one(), one())
}

fn draw(case: u64) -> (World, State) {
    let mut rng = Pcg64::seed_from_u64(case);
    let count = rng.random_range(1..9);
    let reach = rng.random_range(0.1..0.5);
    let supports: Vec<Vec3> = (0..count).map(|_| vector(&mut rng, reach)).collect();
    let mass = rng.random_range(0.5..2.0);
    // A cloud of mass with these mean squares along its axes.
    let [x, y, z] = [0; 3].map(|_| reach * reach * rng.random_range(0.02..0.5));
    let turn = Rotation::by(vector(&mut rng, 2.0));
    let inertia = turn.turn(Mat3::diagonal(y + z, z + x, x + y)) * mass;
    let inertia = (inertia + inertia.transposed()) * 0.5;
    let body = Body::new(mass, inertia, supports.clone()).unwrap();
    let attitude = Rotation::by(vector(&mut rng, 3.0));
    let height = |i: usize| attitude.apply(supports[i]).z;
    let lowest = (0..count).min_by(|a, b| height(*a).total_cmp(&height(*b))).unwrap();
    let spin = vector(&mut rng, if case.is_multiple_of(3) { 8.0 } else { 1.0 });
    let mut state = State::standing(&body, lowest, attitude, spin);
    if case.is_multiple_of(2) {
        state.centre.z += rng.random_range(0.0..0.3);
        state.velocity = vector(&mut rng, 0.5);
    }
    (World::new(body, Vec3::new(0.0, 0.0, -9.81)).unwrap(), state)
}

#[test]
fn dbg() {
    let mut ends: BTreeMap<String, u32> = BTreeMap::new();
    let (mut drift, mut deep, mut gain) = (0.0_f64, 0.0_f64, f64::NEG_INFINITY);
    let (mut evals, mut most) = (0u64, 0);
    for case in 0..20000 {
        let (world, start) = draw(case);
        let mut samples = Samples::default();
        let options = Options { most_time: 5.0, most_impacts: 2000, most_steps: 20000, ..Options::default() };
        let r = match run(&world, &start, &options, &mut samples) {
            Ok(r) => r,
            Err(e) => {
                println!("{case} {e:?}");
                continue;
            }
        };
        let name: String = format!("{:?}", r.end).chars().take_while(|c| *c != '{').collect();
        *ends.entry(name).or_default() += 1;
        if r.drift > 1e-13 {
            println!("{case} drift {:e}", r.drift);
        }
        drift = drift.max(r.drift);
        evals += r.effort.evaluations;
        most = most.max(r.effort.evaluations);
        if r.effort.impacts > 300 || r.effort.steps > 3000 {
            println!("{case} {:?} {:?}", r.end, r.effort);
        }
        for i in &r.impacts {
            gain = gain.max((i.kinetic_after - i.kinetic_before) / (i.kinetic_before));
            if i.kinetic_after > i.kinetic_before * (1.0 + 1e-10) {
                println!("{case} gain {:?}", i);
            }
        }
        for (t, mode, s) in &samples.instants {
            for a in world.body().supports() {
                let h = s.place(*a).z / world.scales().length;
                if h < -1e-12 {
                    println!("{case} {t} {mode:?} {h:e}");
                }
                deep = deep.max(-h);
            }
        }
    }
    println!("{ends:?} drift {drift:e} deep {deep:e} gain {gain:e} evals {evals} most {most}");
}
#[test]
fn one() {
    let Ok(case) = std::env::var("CASE") else { return };
    let (world, start) = draw(case.parse().unwrap());
    let mut samples = Samples::default();
    let most: u64 = std::env::var("MOST").map_or(40, |m| m.parse().unwrap());
    let options = Options { most_time: 5.0, most_impacts: most, most_steps: 20000, ..Options::default() };
    let r = run(&world, &start, &options, &mut samples).unwrap();
    println!("{:?} {:?}", world.scales(), r.end);
    println!("{:?}", world.body().supports());
    for p in &samples.pieces {
        println!(
            "piece {:.12} {:e} {:?} E {:e}",
            p.start_time,
            p.end_time - p.start_time,
            p.mode,
            p.end.kinetic(world.body())
        );
        for (t, mode, s) in samples.instants.iter().filter(|(t, _, _)| *t >= p.start_time && *t <= p.end_time)
        {
            for (j, a) in world.body().supports().iter().enumerate() {
                let h = s.place(*a).z / world.scales().length;
                if h < -1e-12 {
                    println!("   {t} {j} {h:e}");
                }
            }
        }
        let r = r.impacts.iter().find(|i| i.time == p.end_time);
        if let Some(i) = r {
            println!(
                "  impact touching {:?} striking {:?} kept {:?} T {:e} {:e} {:?} demand {}",
                i.touching.iter().collect::<Vec<_>>(),
                i.striking.iter().collect::<Vec<_>>(),
                i.kept.iter().collect::<Vec<_>>(),
                i.kinetic_before,
                i.kinetic_after,
                i.conclusion,
                i.friction_demand
            );
        }
    }
}
