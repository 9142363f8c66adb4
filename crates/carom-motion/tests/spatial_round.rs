//! Random bodies of points, balls and circles on floors, in grooves and in corners: what holds for all of them.

#![allow(clippy::print_stdout, reason = "what random bodies come to is a measurement")]

use crate::bodies::rising;

use carom_motion::spatial::{
    Body, Clock, End, Feature, Friction, Mode, Options, Plane, Samples, State, World, run,
};
use carom_num::{Mat3, Rotation, Vec3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use rayon::prelude::*;
use std::collections::BTreeMap;

const CASES: u64 = 120;
/// Of the energy between events less what friction has taken, in m g × reach + kinetic energy.
const DRIFT: f64 = 1e-10;
/// How deep a feature may be behind a plane at samples of dense output, in units of the reach.
const DEPTH: f64 = 1e-8;
/// How fast what sticks may slip, and what slips leave its plane, in units of the motion's speeds.
const SLIPS: f64 = 1e-8;

/// A feature as it is drawn: centre, axis, radius of the circle, radius of the ball.
type Drawn = (Vec3, Vec3, f64, f64);

fn features(rng: &mut Pcg64) -> Vec<Drawn> {
    let mut one = |least: f64, most: f64| rng.random_range(least..most);
    let (length, wide) = (one(0.2, 1.0), one(0.1, 0.6));
    let ring = |z: f64, radius: f64| (Vec3::Z * z, Vec3::Z, radius, 0.0);
    let ball = |place: Vec3, radius: f64| (place, Vec3::ZERO, 0.0, radius);
    let (other, round) = (one(0.05, 0.5), one(0.02, 0.1));
    match (one(0.0, 6.0)) as u32 {
        0 => vec![ring(-length, wide), ring(length, wide)],
        1 => vec![ring(-length, wide), ring(-0.6 * length, wide), ring(length, other)],
        2 => vec![ring(-0.4 * length, wide), ball(Vec3::Z * length, 0.0)],
        3 => vec![ball(Vec3::X * -length, wide), ball(Vec3::X * length, other)],
        4 => vec![(Vec3::ZERO, Vec3::Z, wide, round)],
        _ => {
            let sign = |k: u32, bit: u32| if k >> bit & 1 == 1 { 0.3 } else { -0.3 };
            (0..8).map(|k| ball(Vec3::new(sign(k, 0), sign(k, 1), sign(k, 2)), round)).collect()
        }
    }
}

fn drawn(case: u64) -> (World, State, Vec<Drawn>) {
    let mut rng = Pcg64::seed_from_u64(case);
    let drawn = features(&mut rng);
    let feature = |(place, axis, circle, radius): &Drawn| {
        let own =
            if *circle > 0.0 { Feature::circle(*place, *axis, *circle) } else { Feature::point(*place) };
        own.rounded(*radius)
    };
    let mut one = |least: f64, most: f64| rng.random_range(least..most);
    let inertia = Mat3::diagonal(one(0.09, 0.1), one(0.08, 0.1), one(0.06, 0.1));
    let body = Body::of(one(0.5, 2.0), inertia, drawn.iter().map(feature).collect()).unwrap();
    let planes: Vec<Plane> =
        (0..1 + case % 3)
            .map(|k| {
                if k == 0 {
                    Plane::FLOOR
                } else {
                    rising(one(0.3, 1.5), 2.1 * k as f64 + one(-0.4, 0.4), 0.0)
                }
            })
            .collect();
    let attitude = Rotation::by(Vec3::new(one(-2.0, 2.0), one(-2.0, 2.0), one(-2.0, 2.0)));
    let out = planes.iter().fold(Vec3::ZERO, |sum, plane| sum + plane.normal()).unit().unwrap();
    let lift = planes.iter().map(|plane| (body.reach() + one(0.0, 0.1)) / plane.normal().dot(out));
    let centre = out * lift.fold(0.0, f64::max);
    let velocity = Vec3::new(one(-2.0, 2.0), one(-2.0, 2.0), one(-2.0, 0.5));
    let spin = Vec3::new(one(-8.0, 8.0), one(-8.0, 8.0), one(-8.0, 8.0));
    let restitution = if case.is_multiple_of(2) { 0.0 } else { one(0.0, 0.5) };
    let friction = Friction::new(one(0.0, 1.0)).with_restitution(restitution);
    let world = World::new(body, Vec3::Z * -9.81).unwrap().with_friction(friction).unwrap();
    (world.among(planes).unwrap(), State { centre, attitude, velocity, spin }, drawn)
}

/// How far the lowest place of a feature is over a plane.
fn height((place, axis, circle, radius): &Drawn, plane: &Plane, state: &State) -> f64 {
    let sine = state.attitude.apply(*axis).cross(plane.normal()).norm();
    plane.height(state.place(*place)) - circle * sine - radius
}

/// What is wrong with a sample.
fn wrong(world: &World, drawn: &[Drawn], (mode, state): (&Mode, &State)) -> Option<String> {
    let reach = world.body().reach();
    for (i, plane) in (0..).zip(world.planes()) {
        for (k, feature) in drawn.iter().enumerate() {
            let deep = -height(feature, plane, state) / reach;
            if deep > DEPTH {
                return Some(format!("feature {k} is {deep:e} behind plane {i}"));
            }
        }
    }
    let Mode::Slides { sticking, slipping } = mode else { return None };
    let size = state.velocity.norm() + state.spin.norm() * reach + world.scales().speed;
    let velocity = |i: usize| state.velocity_of(world.touches_at(i, state).unwrap());
    let slips = |i: usize| velocity(i).norm() / size;
    let leaves = |i: usize| world.planes()[i / drawn.len()].normal().dot(velocity(i)).abs() / size;
    let stuck = sticking.iter().map(|i| (i, slips(i))).chain(slipping.iter().map(|i| (i, leaves(i))));
    stuck
        .into_iter()
        .find(|(_, fast)| *fast > SLIPS)
        .map(|(i, fast)| format!("support {i} moves at {fast:e}"))
}

fn followed(case: u64) -> String {
    let (world, start, drawn) = drawn(case);
    let options = Options { most_time: 0.6, most_steps: 20_000, ..Options::default() };
    let mut samples = Samples::default();
    let out =
        run(&world, &start, &options, &mut samples).unwrap_or_else(|error| panic!("case {case}: {error}"));
    assert!(out.drift < DRIFT, "case {case}: {:e}", out.drift);
    for (time, mode, state) in &samples.instants {
        let problem = wrong(&world, &drawn, (mode, state));
        assert_eq!(problem, None, "case {case} at {time}, in {mode:?}");
    }
    let gains = out.impacts.iter().map(|i| i.kinetic_after / i.kinetic_before).fold(0.0, f64::max);
    assert!(gains <= 1.0 + 1e-12, "case {case}: {gains}");
    match out.end {
        End::NoConsistentOutcome(Clock::Impact) => "no way through an impact".to_owned(),
        End::NoConsistentOutcome(Clock::Motion) => "no way on".to_owned(),
        End::BudgetSpent(budget) => format!("{budget:?} spent"),
        end => format!("{end:?}").split(' ').next().unwrap_or_default().to_owned(),
    }
}

#[test]
fn random_round_bodies_keep_to_their_planes() {
    let ends: Vec<String> = (0..CASES).into_par_iter().map(followed).collect();
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    ends.iter().for_each(|end| *counts.entry(end).or_default() += 1);
    println!("{counts:?}");
    let of = |end: &str| counts.get(end).copied().unwrap_or_default();
    let stall = of("no way on") + of("no way through an impact") + of("Steps spent") + of("Impacts spent");
    assert!(100 * stall <= 2 * ends.len(), "{counts:?}");
    assert!(of("Time spent") > 60, "most roll on: {counts:?}");
}

/// What is found in one place, and was looked for in ten million of a step: a flat circle over its plane, and a ring between others on the side of a cone.
#[test]
fn flat_circles_and_rings_between_others_take_no_search() {
    let world = |body: Body, gravity: Vec3| {
        World::new(body, gravity).unwrap().with_friction(Friction::new(0.6)).unwrap()
    };
    let disc =
        Body::of(1.0, Mat3::diagonal(0.25, 0.25, 0.5), vec![Feature::circle(Vec3::ZERO, Vec3::Z, 1.0)]);
    let down = State { centre: Vec3::Z, attitude: Rotation::NONE, velocity: Vec3::ZERO, spin: Vec3::Z };
    let flat = run(&world(disc.unwrap(), Vec3::Z * -9.81), &down, &Options::default(), &mut ()).unwrap();
    assert!(matches!(flat.end, End::Flat { .. }) && flat.effort.event_evaluations < 100, "{flat:?}");
    let rings = [(-0.25, 0.4), (0.25, 0.2)].map(|(z, radius)| Feature::circle(Vec3::Z * z, Vec3::Z, radius));
    let features = vec![rings[0], Feature::point(Vec3::Z * 0.75), rings[1]];
    let cone = Body::of(1.0, Mat3::diagonal(0.08, 0.08, 0.05), features).unwrap();
    let attitude =
        Rotation::by(Vec3::Y * (std::f64::consts::FRAC_PI_2 + carom_num::elementary::atan2(0.4, 1.0)));
    let centre = Vec3::Z * (0.05 - cone.lowest(attitude));
    let start = State { centre, attitude, velocity: Vec3::new(0.3, 0.2, 0.0), spin: Vec3::ZERO };
    let options = Options { most_time: 0.4, ..Options::default() };
    let lies = run(&world(cone, Vec3::new(1.0, 0.0, -10.0)), &start, &options, &mut ()).unwrap();
    assert!(lies.effort.steps < 100 && lies.effort.event_evaluations < 1000, "{:?}", lies.effort);
}
