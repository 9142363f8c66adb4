//! Random bodies that slide, strike and chatter: what holds for all of them.

#![allow(clippy::print_stdout, reason = "what random bodies come to is a measurement")]

use crate::bodies;

use carom_motion::spatial::{
    Body, Budget, Clock, End, Friction, Impact, Mode, Options, Run, Samples, State, World, run,
};
use carom_num::{Mat3, Rotation, Vec3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use rayon::prelude::*;
use std::collections::BTreeMap;

const CASES: u64 = 1000;
const DICE: u64 = 50;
/// Of each shape at each friction.
const TILES: u64 = 40;
/// Impacts that are followed of each body: bodies that rebound chatter long.
const MOST_IMPACTS: u64 = 60;
/// What an impact may add to the kinetic energy by rounding, as a fraction of it.
const GAIN: f64 = 1e-12;
/// Of the energy between events less what friction has taken, in m g × reach + kinetic energy.
const DRIFT: f64 = 1e-12;
/// How deep a support may be below the plane at samples of dense output, in units of the reach: that of the start of a slip is of order 6.
const DEPTH: f64 = 1e-9;

/// Random friction, and for every other body random restitution.
fn drawn(case: u64) -> (World, State) {
    let (world, start) = bodies::drawn(case);
    let mut rng = Pcg64::seed_from_u64(case + 1_000_000);
    let friction = rng.random_range(0.0..1.2);
    let restitution = if case.is_multiple_of(2) { 0.0 } else { rng.random_range(0.0..0.9) };
    (world.with_friction(Friction::new(friction).with_restitution(restitution)).unwrap(), start)
}

fn name(end: &End) -> &'static str {
    match end {
        End::AtRest { .. } => "at rest",
        End::NoConsistentOutcome(Clock::Impact) => "no consistent impact",
        End::NoConsistentOutcome(Clock::Motion) => "no consistent motion",
        End::BudgetSpent(Budget::Time | Budget::Impacts) => "still moves",
        End::BudgetSpent(Budget::Steps) => "stalls",
        _ => "unexpected",
    }
}

fn deepest(world: &World, samples: &Samples) -> f64 {
    let supports = world.body().supports();
    let lowest = |state: &State| supports.iter().map(|r| state.place(*r).z).fold(f64::INFINITY, f64::min);
    -samples.instants.iter().map(|(_, _, state)| lowest(state)).fold(f64::INFINITY, f64::min)
        / world.scales().length
}

fn gain(run: &Run) -> f64 {
    let of = |i: &Impact| (i.kinetic_after - i.kinetic_before) / i.kinetic_before;
    run.impacts.iter().map(of).fold(f64::NEG_INFINITY, f64::max)
}

#[test]
fn energy_never_grows_and_nothing_sinks_into_the_plane() {
    let mut ends: BTreeMap<&str, u32> = BTreeMap::new();
    let followed = |case| {
        let (world, start) = drawn(case);
        let mut samples = Samples::default();
        let options =
            Options { most_time: 2.0, most_impacts: MOST_IMPACTS, most_steps: 20_000, ..Options::default() };
        let run = run(&world, &start, &options, &mut samples).unwrap();
        let energy = |s: &State| s.kinetic(world.body()) + s.potential(&world);
        let grown =
            (energy(&run.state) - energy(&start)) / (world.scales().energy + start.kinetic(world.body()));
        let own = [run.drift, gain(&run), deepest(&world, &samples), grown];
        assert!(own[0] < DRIFT && own[1] < GAIN && own[2] < DEPTH && own[3] < DRIFT, "case {case}: {own:?}");
        assert!(name(&run.end) != "unexpected" && run.friction_work <= 0.0, "case {case}: {:?}", run.end);
        let slides = samples.pieces.iter().filter(|p| matches!(p.mode, Mode::Slides { .. })).count();
        (name(&run.end), own, run.impacts.len(), slides)
    };
    let all: Vec<_> = (0..CASES).into_par_iter().map(followed).collect();
    let (mut worst, mut impacts, mut slides) = ([f64::NEG_INFINITY; 4], 0, 0);
    for (end, own, struck, slid) in all {
        *ends.entry(end).or_default() += 1;
        worst = std::array::from_fn(|i| worst[i].max(own[i]));
        (impacts, slides) = (impacts + struck, slides + slid);
    }
    println!("{CASES} bodies, {impacts} impacts, {slides} slides: {ends:?}");
    println!("drift {:e}, gain {:e}, depth {:e}", worst[0], worst[1], worst[2]);
    assert!(slides > 1000 && ends["at rest"] > 80, "{ends:?}");
    // What the walk of an impact gives up is a fault of that walk.
    let lost: u32 = ends.iter().filter(|(name, _)| name.starts_with("no consistent")).map(|(_, n)| n).sum();
    let stalled = ends.get("stalls").copied().unwrap_or(0);
    assert_eq!(stalled, 0, "{ends:?}");
    assert_eq!(lost, 0, "{ends:?}");
}

#[test]
fn a_run_is_the_same_whoever_looks_on() {
    for case in 0..60 {
        let (world, start) = drawn(case);
        let options = Options { most_time: 1.0, most_impacts: MOST_IMPACTS, ..Options::default() };
        let alone = run(&world, &start, &options, &mut ()).unwrap();
        let seen = run(&world, &start, &options, &mut Samples::default()).unwrap();
        assert_eq!(alone, seen, "case {case}");
    }
}

/// A box with these half sides \[m\], thrown from 100 mm.
fn thrown(half: [f64; 3], friction: Friction, rng: &mut Pcg64) -> (World, State) {
    let mut vector = |size: f64| {
        let mut one = || rng.random_range(-size..size);
        Vec3::new(one(), one(), one())
    };
    let mass = 0.005;
    let corner = |k: usize| {
        let side = |axis: usize| if k >> axis & 1 == 0 { -half[axis] } else { half[axis] };
        Vec3::new(side(0), side(1), side(2))
    };
    let moment = |a: usize, b: usize| mass * (half[a] * half[a] + half[b] * half[b]) / 3.0;
    let inertia = Mat3::diagonal(moment(1, 2), moment(0, 2), moment(0, 1));
    let body = Body::new(mass, inertia, (0..8).map(corner).collect()).unwrap();
    let attitude = Rotation::by(vector(3.0));
    let start = State { centre: Vec3::Z * 0.1, attitude, velocity: vector(1.0), spin: vector(40.0) };
    (World::new(body, Vec3::Z * -9.81).unwrap().with_friction(friction).unwrap(), start)
}

/// Follows a throw; returns how many strikes there were, and whether it came to lie on a face.
fn lies(case: u64, world: &World, start: &State) -> (usize, bool) {
    let options = Options { most_time: 30.0, most_steps: 20_000, ..Options::default() };
    let run = run(world, start, &options, &mut ()).unwrap();
    let End::AtRest { held } = run.end else { return (run.impacts.len(), false) };
    let up = run.state.up();
    let leans = 1.0 - up.x.abs().max(up.y.abs()).max(up.z.abs());
    assert!(leans < 1e-9 && held.len() == 4, "case {case}: {leans:e} {held:?}");
    (run.impacts.len(), true)
}

/// Dice with sharp corners, thrown: they bounce, slide and chatter, and come to lie on a face.
#[test]
fn thrown_dice_come_to_rest_on_a_face() {
    let (mut rested, mut impacts) = (0_u32, 0);
    for case in 0..DICE {
        let mut rng = Pcg64::seed_from_u64(case);
        let friction = rng.random_range(0.1..0.8);
        let friction = Friction::new(friction).with_restitution(rng.random_range(0.0..0.5));
        let (world, start) = thrown([0.008; 3], friction, &mut rng);
        let (strikes, rests) = lies(case, &world, &start);
        impacts += strikes;
        rested += u32::from(rests);
    }
    println!("{rested} of {DICE} dice at rest, {impacts} impacts");
    assert_eq!(u64::from(rested), DICE);
}

/// Tiles and bars tip over their edges: where friction hardly holds, both ends of an edge start to slip together, and grow slowly.
#[test]
fn thrown_tiles_and_bars_come_to_rest_on_a_face() {
    for half in [[0.03, 0.03, 0.0075], [0.03, 0.03, 0.0015], [0.05, 0.005, 0.005]] {
        for friction in [0.1, 0.3, 0.6, 1.0, 1.5] {
            let mut rng = Pcg64::seed_from_u64(7);
            for case in 0..TILES {
                let (world, start) = thrown(half, Friction::new(friction), &mut rng);
                let (_, rests) = lies(case, &world, &start);
                assert!(rests, "case {case} of {half:?} at friction {friction}");
            }
        }
    }
}
