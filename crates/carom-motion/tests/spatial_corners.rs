//! Random bodies that fall into grooves and corners of two or three planes: what holds for all of them.

#![allow(clippy::print_stdout, reason = "what random bodies come to is a measurement")]

use crate::bodies::{self, rising};

use carom_motion::spatial::{Budget, Clock, End, Friction, Options, Plane, Run, Samples, State, World, run};
use carom_num::Vec3;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use rayon::prelude::*;
use std::collections::BTreeMap;

const CASES: u64 = 200;
/// Of the energy between events less what friction has taken, in m g × reach + kinetic energy.
const DRIFT: f64 = 1e-10;
/// What a run may gain, in the same units: closed series keep the friction of their impulses to first order in what is left of them.
const GAIN: f64 = 1e-7;
/// How deep a point may be behind a plane at samples of dense output, in units of the reach.
const DEPTH: f64 = 1e-8;

/// A body above a groove, in front of a wall on a floor, or above a corner of three planes.
fn drawn(case: u64) -> (World, State) {
    let (world, mut start) = bodies::drawn(case);
    let mut rng = Pcg64::seed_from_u64(case + 2_000_000);
    let mut between = |least: f64, most: f64| rng.random_range(least..most);
    let third = std::f64::consts::TAU / 3.0;
    let planes: Vec<Plane> = match case % 3 {
        0 => (0..2)
            .map(|k| rising(between(0.1, 1.3), 1.5 * third * f64::from(k), between(-0.3, 0.3)))
            .collect(),
        1 => vec![Plane::FLOOR, rising(between(1.2, 1.9), 0.0, -0.5)],
        _ => {
            let first = between(0.0, 6.0);
            let one = |k: u32, more: f64| first + third * f64::from(k) + more;
            (0..3)
                .map(|k| rising(between(0.2, 1.2), one(k, between(-0.4, 0.4)), between(-0.3, 0.3)))
                .collect()
        }
    };
    let restitution = if case.is_multiple_of(2) { 0.0 } else { between(0.0, 0.5) };
    let friction = Friction::new(between(0.0, 1.0)).with_restitution(restitution);
    // Away from all of them, until no point is behind one.
    let out = planes.iter().fold(Vec3::ZERO, |sum, plane| sum + plane.normal()).unit().unwrap();
    let points = world.body().supports();
    let lacks = |plane: &Plane| {
        let least = points.iter().map(|r| plane.height(start.place(*r))).fold(f64::INFINITY, f64::min);
        -least / plane.normal().dot(out)
    };
    let lift = planes.iter().map(lacks).fold(f64::NEG_INFINITY, f64::max);
    start.centre += out * (lift + between(0.0, 0.2));
    (world.with_friction(friction).unwrap().among(planes).unwrap(), start)
}

fn name(run: &Run) -> &'static str {
    match run.end {
        End::AtRest { .. } => "at rest",
        End::Balanced { .. } => "balanced",
        End::BudgetSpent(Budget::Time | Budget::Impacts) => "still moves",
        End::BudgetSpent(Budget::Steps) => "stalls",
        End::NoConsistentOutcome(Clock::Impact | Clock::Motion) => "no way on",
        _ => "unexpected",
    }
}

fn followed(case: u64) -> &'static str {
    let (world, start) = drawn(case);
    let mut samples = Samples::default();
    let options = Options { most_time: 1.0, most_impacts: 30, most_steps: 20_000, ..Options::default() };
    let run = run(&world, &start, &options, &mut samples).unwrap();
    let scale = world.scales().energy + start.kinetic(world.body());
    let energy = |s: &State| s.kinetic(world.body()) + s.potential(&world);
    let gain = (energy(&run.state) - energy(&start)) / scale;
    let height = |s: &State| {
        let of = |plane: &Plane| {
            let points = world.body().supports().iter();
            points.map(|r| plane.height(s.place(*r))).fold(f64::INFINITY, f64::min)
        };
        world.planes().iter().map(of).fold(f64::INFINITY, f64::min)
    };
    let lowest = samples.instants.iter().map(|(_, _, s)| height(s)).fold(f64::INFINITY, f64::min);
    let depth = -lowest / world.scales().length;
    assert!(
        run.drift < DRIFT && gain < GAIN && depth < DEPTH,
        "case {case}: {:e} {gain:e} {depth:e}",
        run.drift
    );
    assert!(run.friction_work <= 0.0, "case {case}: {:e}", run.friction_work);
    name(&run)
}

#[test]
fn energy_never_grows_and_nothing_sinks_into_any_plane() {
    let all: Vec<&str> = (0..CASES).into_par_iter().map(followed).collect();
    let mut ends: BTreeMap<&str, u64> = BTreeMap::new();
    all.into_iter().for_each(|end| *ends.entry(end).or_default() += 1);
    println!("{ends:?}");
    let lost = |name: &str| ends.get(name).copied().unwrap_or(0);
    assert_eq!(lost("unexpected"), 0, "{ends:?}");
    assert!(lost("at rest") > 10 && lost("no way on") + lost("stalls") <= CASES / 100, "{ends:?}");
}
