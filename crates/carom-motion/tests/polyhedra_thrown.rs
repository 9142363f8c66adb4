//! Polyhedra that are thrown on the plane: what holds for all of them.

#![allow(clippy::print_stdout, reason = "what throws come to is a measurement")]

use carom_motion::spatial::{Body, End, Mode, Options, Polyhedron, Samples, State, Supports, World, run};
use carom_num::{Rotation, Vec3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::collections::BTreeMap;

const G: f64 = 9.81;
/// What an impact may add to the kinetic energy by rounding, as a fraction of it.
const GAIN: f64 = 1e-13;
/// Of the energy between events, in m g × reach + kinetic energy.
const DRIFT: f64 = 1e-12;
/// How deep a support may be below the plane between events, at samples of dense output, in units of the reach.
const DEPTH: f64 = 1e-11;

fn vector(random: &mut Pcg64Mcg, size: f64) -> Vec3 {
    Vec3::from_array(std::array::from_fn(|_| random.random_range(-size..size)))
}

/// Points of a body: a box, a prism, a double pyramid, or random ones on a sphere; 4 to 100 vertices.
fn points(case: u64, random: &mut Pcg64Mcg) -> Vec<Vec3> {
    let ring = |n: u32, z: f64, r: f64| {
        (0..n).map(move |j| {
            let (sin, cos) =
                carom_num::elementary::sin_cos(std::f64::consts::TAU * f64::from(j) / f64::from(n));
            Vec3::new(r * cos, r * sin, z)
        })
    };
    let height = random.random_range(0.05..0.4);
    let sides = random.random_range(3..9);
    match case % 5 {
        0 => ring(4, -height, 0.2).chain(ring(4, height, 0.2)).collect(),
        1 => ring(sides, -height, 0.2).chain(ring(sides, height, 0.2)).collect(),
        2 => ring(sides, 0.0, 0.2).chain([Vec3::Z * height, -Vec3::Z * (0.5 * height)]).collect(),
        3 => (0..random.random_range(4..12)).map(|_| vector(random, 0.2)).collect(),
        _ => (0..100).filter_map(|_| vector(random, 1.0).unit()).map(|r| r * 0.2).collect(),
    }
}

struct Thrown {
    hull: Polyhedron,
    centre: Vec3,
    world: World,
    start: State,
}

fn thrown(case: u64) -> Thrown {
    let mut random = Pcg64Mcg::seed_from_u64(case);
    let hull = Polyhedron::of_points(&points(case, &mut random), 1e-10).unwrap();
    let solid = hull.solid().unwrap();
    let supports: Vec<Vec3> = hull.vertices().iter().map(|r| *r - solid.centre).collect();
    let body = Body::new(1000.0 * solid.volume, solid.inertia * 1000.0, supports.clone()).unwrap();
    let attitude = Rotation::by(vector(&mut random, 3.0));
    let lowest = supports.iter().map(|r| attitude.apply(*r).z).fold(f64::INFINITY, f64::min);
    let height = random.random_range(0.0..0.1);
    let start = State {
        centre: Vec3::Z * (height - lowest),
        attitude,
        velocity: vector(&mut random, 0.2),
        spin: vector(&mut random, 3.0),
    };
    Thrown { hull, centre: solid.centre, world: World::new(body, Vec3::Z * -G).unwrap(), start }
}

/// The face that holds these supports.
fn face_of(hull: &Polyhedron, held: Supports) -> Option<usize> {
    hull.faces().iter().position(|face| held.iter().all(|i| face.corners.contains(&i)))
}

#[test]
fn thrown_bodies_lose_energy_stay_above_the_plane_and_rest_on_stable_faces() {
    let mut ends: BTreeMap<&str, u32> = BTreeMap::new();
    let mut most_vertices = 0;
    for case in 0..300 {
        let Thrown { hull, centre, world, start } = thrown(case);
        let mut samples = Samples::default();
        let options = Options { most_impacts: 400, ..Options::default() };
        let run = run(&world, &start, &options, &mut samples).unwrap();
        for impact in &run.impacts {
            assert!(
                impact.kinetic_after <= impact.kinetic_before * (1.0 + GAIN),
                "case {case} at {}: {} to {} J",
                impact.time,
                impact.kinetic_before,
                impact.kinetic_after
            );
        }
        assert!(run.drift < DRIFT, "case {case}: {:e}", run.drift);
        let (body, reach) = (world.body(), world.body().reach());
        for (time, mode, state) in &samples.instants {
            let place = |r: &Vec3| state.place(*r).z;
            let lowest = body.supports().iter().map(place).fold(f64::INFINITY, f64::min);
            assert!(lowest >= -DEPTH * reach, "case {case} at {time}, {mode:?}: {lowest:e} m");
        }
        let name = match run.end {
            End::AtRest { held } => {
                let face = face_of(&hull, held).unwrap();
                let stance = hull.stance(face, centre).unwrap();
                assert!(stance.margin > 0.0, "case {case}: rests on face {face}: {stance:?}");
                let down = run.state.attitude.apply(hull.faces()[face].normal).z;
                assert!((down + 1.0).abs() < 1e-9, "case {case}: face {face} is down: {down}");
                assert!((run.state.centre.z - stance.height).abs() < 1e-9 * reach, "case {case}");
                most_vertices = most_vertices.max(body.supports().len());
                "at rest"
            }
            End::NoConsistentOutcome(_) => "no consistent outcome",
            End::Balanced { .. } => "balanced",
            End::BudgetSpent(_) => "still moves",
            End::Overturned | End::FliesAway | End::Flat { .. } | End::Several(_) | End::Stopped => {
                "unexpected"
            }
        };
        *ends.entry(name).or_default() += 1;
    }
    println!("{ends:?}, at rest with up to {most_vertices} vertices");
    assert!(!ends.contains_key("unexpected"), "{ends:?}");
    assert!(ends["at rest"] > 60, "{ends:?}");
    assert!(most_vertices > 90, "bodies with many vertices come to rest too: {most_vertices}");
}

#[test]
fn a_body_that_is_let_go_flat_on_each_of_its_faces_rests_there_or_rolls_off() {
    for case in (0..200).filter(|case| case % 5 != 4) {
        let Thrown { hull, centre, world, .. } = thrown(case);
        for face in 0..hull.faces().len() {
            let normal = hull.faces()[face].normal;
            let Some(about) = normal.cross(-Vec3::Z).unit() else { continue };
            let angle = carom_num::elementary::atan2(normal.cross(-Vec3::Z).norm(), -normal.z);
            let attitude = Rotation::by(about * angle);
            let stance = hull.stance(face, centre).unwrap();
            // Clear answers only: the mass centre well inside, or well outside.
            if stance.margin.abs() < 1e-6 {
                continue;
            }
            let start =
                State { centre: Vec3::Z * stance.height, attitude, velocity: Vec3::ZERO, spin: Vec3::ZERO };
            let options = Options { most_impacts: 1, most_time: 0.01, ..Options::default() };
            let run = run(&world, &start, &options, &mut ()).unwrap();
            let rests = matches!(run.end, End::AtRest { .. });
            assert_eq!(rests, stance.margin > 0.0, "case {case}, face {face}: {stance:?} {:?}", run.end);
            if let End::AtRest { held } = run.end {
                assert_eq!(face_of(&hull, held), Some(face), "case {case}");
                assert_eq!(run.time, 0.0, "case {case}: at once");
                let corners: Supports = hull.faces()[face].corners.iter().copied().collect();
                assert_eq!(held, corners, "case {case}: all corners touch");
            }
        }
    }
}

#[test]
fn a_box_on_its_edge_goes_over_as_in_the_plane() {
    // About an edge: J_edge = m (a² + c²)/3, the impact on the next edge leaves ω′/ω = (2c² − a²)/(2 (a² + c²)) for a box a wide and c high.
    let (a, c) = (0.02, 0.06);
    let corners: Vec<Vec3> = (0..8)
        .map(|i: u32| {
            let sign = |k: u32| f64::from(2 * (i >> k & 1)) - 1.0;
            Vec3::new(0.5 * a * sign(0), 0.05 * sign(1), 0.5 * c * sign(2))
        })
        .collect();
    let hull = Polyhedron::of_points(&corners, 1e-10).unwrap();
    let solid = hull.solid().unwrap();
    let body = Body::new(solid.volume, solid.inertia, hull.vertices().to_vec()).unwrap();
    let world = World::new(body, Vec3::Z * -G).unwrap();
    // It leans over the lower edge at −x by a little less than what lets it fall back.
    let start = State::standing(world.body(), 0, Rotation::by(Vec3::Y * -0.05), Vec3::ZERO);
    let mut samples = Samples::default();
    let found = run(&world, &start, &Options::default(), &mut samples).unwrap();
    assert!(matches!(samples.pieces[0].mode, Mode::Edge { .. }), "{:?}", samples.pieces[0]);
    let first = &found.impacts[0];
    let ratio = first.spin_after.y / first.spin_before.y;
    let expected = (2.0 * c * c - a * a) / (2.0 * (a * a + c * c));
    assert!((ratio - expected).abs() < 1e-12, "{ratio} {expected}");
}
