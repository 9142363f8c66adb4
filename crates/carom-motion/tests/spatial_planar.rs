//! Boxes whose motion stays in a vertical plane: the engine of space against that of the plane.

#![allow(clippy::print_stdout, reason = "how far two engines differ is a measurement")]

use carom_impact::Law;
use carom_motion::planar::{self, Happening, Obstacle, Shape};
use carom_motion::spatial::{self, Friction, Mode, Samples};
use carom_num::{Mat3, Rotation, Vec2, Vec3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use rayon::prelude::*;

const G: f64 = 9.81;
const CASES: u64 = 300;
/// Places in units of the box, velocities in those of its fall: the engine of the plane lets no hop be shorter than 1e-6 of the box's time. Runs with a series of
/// impacts are left out: the two engines close it at different places.
const CLOSE: f64 = 1e-9;

/// A box in the plane, and how it starts.
struct Drop {
    half: [f64; 2],
    inertia: f64,
    friction: f64,
    restitution: f64,
    centre: Vec2,
    angle: f64,
    velocity: Vec2,
    spin: f64,
}

fn drawn(case: u64) -> Drop {
    let mut rng = Pcg64::seed_from_u64(case);
    let half: [f64; 2] = [rng.random_range(0.05..0.1), rng.random_range(0.02..0.1)];
    let angle: f64 = rng.random_range(-1.2..1.2);
    let (sin, cos) = carom_num::elementary::sin_cos(angle);
    let low = half[0] * sin.abs() + half[1] * cos;
    let slides = case.is_multiple_of(2);
    Drop {
        half,
        inertia: (half[0] * half[0] + half[1] * half[1]) / 3.0,
        friction: rng.random_range(0.0..1.0),
        restitution: if slides { 0.0 } else { rng.random_range(0.0..0.6) },
        centre: Vec2::new(0.0, low + rng.random_range(0.0..0.1)),
        angle,
        velocity: Vec2::new(rng.random_range(-1.0..1.0), 0.0),
        spin: rng.random_range(-6.0..6.0),
    }
}

/// Where the box is in the plane after this time.
fn in_the_plane(drop: &Drop, most_time: f64) -> (planar::State, usize) {
    let [a, b] = drop.half;
    let corners = [(-a, -b), (a, -b), (a, b), (-a, b)].map(|(x, y)| Vec2::new(x, y));
    let body =
        planar::Body { shape: Shape::new(corners.to_vec(), 0.0).unwrap(), mass: 1.0, inertia: drop.inertia };
    let ground = Obstacle::new(Vec2::new(-9.0, 0.0), Vec2::new(9.0, 0.0), drop.friction, drop.restitution);
    let world = planar::World::of_one(Vec2::new(0.0, -G), body, vec![ground], Law::Poisson);
    let start = planar::State {
        pose: planar::Pose { centre: drop.centre, angle: drop.angle },
        twist: planar::Twist { velocity: drop.velocity, spin: drop.spin },
    };
    let options = planar::Options { most_time, ..planar::Options::default() };
    let mut walker = planar::Walker::new(&world, start, vec![true], options).unwrap();
    let mut recorder = planar::Recorder::default();
    while walker.advance(&mut recorder).unwrap() == Happening::Moves {}
    let trace = recorder.into_trace();
    (trace.pieces.last().unwrap().end, trace.accumulations.len())
}

fn in_space(drop: &Drop, most_time: f64) -> (spatial::Run, Samples) {
    let [a, b] = drop.half;
    let width = 0.07;
    let mut corners = vec![];
    for (x, z) in [(-a, -b), (a, -b), (a, b), (-a, b)] {
        corners.extend([Vec3::new(x, -width, z), Vec3::new(x, width, z)]);
    }
    let inertia = Mat3::diagonal(0.9 * drop.inertia, drop.inertia, 0.8 * drop.inertia);
    let body = spatial::Body::new(1.0, inertia, corners).unwrap();
    let friction = Friction::new(drop.friction).with_restitution(drop.restitution);
    let world = spatial::World::new(body, Vec3::Z * -G).unwrap().with_friction(friction).unwrap();
    let start = spatial::State {
        centre: Vec3::new(drop.centre.x, 0.0, drop.centre.y),
        attitude: Rotation::by(Vec3::Y * -drop.angle),
        velocity: Vec3::new(drop.velocity.x, 0.0, drop.velocity.y),
        spin: Vec3::Y * -drop.spin,
    };
    let mut samples = Samples::default();
    let options = spatial::Options { most_time, ..spatial::Options::default() };
    (spatial::run(&world, &start, &options, &mut samples).unwrap(), samples)
}

#[test]
fn a_box_that_stays_in_a_plane_moves_as_the_plane_says() {
    // How far apart; slides, edges held, impacts.
    let compared = |case: u64| -> Option<(f64, [usize; 3])> {
        let drop = drawn(case);
        let size = (drop.half[0] * drop.half[0] + drop.half[1] * drop.half[1]).sqrt();
        let (run, samples) = in_space(&drop, 0.35);
        if !run.closings.is_empty() {
            return None;
        }
        // Neither side has gone over a series of strikes at once: their limits are known to less.
        let (plane, closed) = in_the_plane(&drop, 0.35);
        if closed > 0 {
            return None;
        }
        let (state, speed) = (run.state, (G * size).sqrt());
        let centre = plane.pose.centre;
        let place = (state.centre - Vec3::new(centre.x, 0.0, centre.y)).norm() / size;
        let velocity = plane.twist.velocity;
        let moves = (state.velocity - Vec3::new(velocity.x, 0.0, velocity.y)).norm() / speed;
        let spins = (state.spin + Vec3::Y * plane.twist.spin).norm() * size / speed;
        let worst = place.max(moves).max(spins);
        assert!(worst < CLOSE, "case {case}: {place:e} {moves:e} {spins:e}, {:?}", run.end);
        let slid = samples.pieces.iter().filter(|p| matches!(p.mode, Mode::Slides { .. })).count();
        let stuck = samples.pieces.iter().filter(|p| matches!(p.mode, Mode::Edge { .. })).count();
        Some((worst, [slid, stuck, run.impacts.len()]))
    };
    let all: Vec<_> = (0..CASES).into_par_iter().filter_map(compared).collect();
    let [slid, stuck, struck] =
        [0, 1, 2].map(|what| all.iter().map(|(_, counts)| counts[what]).sum::<usize>());
    let mut apart: Vec<f64> = all.into_iter().map(|(worst, _)| worst).collect();
    apart.sort_by(f64::total_cmp);
    let at = |part: usize| apart[(apart.len() - 1) * part / 100];
    println!("{} boxes, {struck} impacts, {slid} slides, {stuck} edges held", apart.len());
    println!("half within {:e}, 99 % {:e}, all {:e}", at(50), at(99), at(100));
    assert!(apart.len() > 100 && slid > 100 && stuck > 50 && at(99) < 1e-12, "{:e}", at(99));
}
