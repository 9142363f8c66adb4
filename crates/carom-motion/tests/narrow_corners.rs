//! A rod between a plate and a wall that stand on one another, and beside them: what touches at both in one instant is struck at both.

use crate::walk::followed_with;

use carom_impact::Law;
use carom_motion::planar::{Happening, Obstacle, Options, Pose, State, Twist, World, examples};
use carom_num::Vec2;
use carom_num::elementary::sin_cos;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::f64::consts::FRAC_PI_2;

/// Length of a rod [m].
const LENGTH: f64 = 0.1;
/// Events after which a rod has gone astray: those in a corner come to rest after two hundred at most.
const MOST_EVENTS: u64 = 400;
/// Length of the plate and of the wall [m].
const SIDE: f64 = 1.0;

/// A plate that rises to the right from the origin at this angle from the vertical, and a wall that rises from there; a rod with them.
fn corner(angle: f64, friction: f64, restitution: f64) -> World {
    let (sine, cosine) = sin_cos(angle);
    let plate = Obstacle::new(Vec2::ZERO, Vec2::new(sine, cosine) * SIDE, friction, restitution);
    let wall = Obstacle::new(Vec2::ZERO, Vec2::new(0.0, SIDE), friction, restitution);
    let rod = examples::rod(LENGTH, 0.3, 0.3 * LENGTH * LENGTH / 12.0);
    World::of_one(Vec2::new(0.0, -9.81), rod, vec![plate, wall], Law::Poisson)
}

#[test]
fn a_rod_that_falls_into_a_narrow_corner_stays_in_it() {
    for seed in 0..100 {
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        let mut between = |low: f64, high: f64| random.random_range(low..high);
        let angle = between(0.05, 0.5);
        let world = corner(angle, between(0.0, 0.5), between(0.0, 0.7));
        let (sine, cosine) = sin_cos(angle);
        // Upright in the middle between the two, its lower end some way above the corner.
        let height = between(0.2, 0.6);
        let pose = Pose {
            centre: Vec2::new(0.5 * height * sine / cosine, height + 0.5 * LENGTH),
            angle: FRAC_PI_2 + between(-0.02, 0.02),
        };
        let twist = Twist { velocity: Vec2::new(0.0, -between(0.0, 3.0)), spin: between(-0.5, 0.5) };
        let options = Options { most_time: 2.0, most_events: MOST_EVENTS, ..Options::default() };
        let start = State { pose, twist };
        let (end, trace, happening) = followed_with(&world, start, vec![false, false], options);
        assert!(
            trace.pieces.len() < MOST_EVENTS as usize,
            "rod {seed}: {happening:?} after {} pieces",
            trace.pieces.len()
        );
        for piece in &trace.pieces {
            for obstacle in 0..2 {
                let clear = world.clearance(0, &piece.end, obstacle);
                assert!(
                    clear >= -1e-10,
                    "rod {seed} overlaps {obstacle} by {clear} m at {} s",
                    piece.end_time
                );
            }
        }
        assert!(end.pose.centre.x > -1e-10, "rod {seed} went through the wall: {end:?}");
    }
}

#[test]
fn a_rod_that_falls_along_a_wall_passes_the_plate_behind_its_foot() {
    // On the wall's left, farther off than what counts as met and nearer than the eye could see; the plate's end at the wall's foot is as near.
    for gap in [2e-12, 1e-11, 1e-10, 1e-9, 1e-8] {
        let world = corner(0.5, 0.3, 0.5);
        let pose = Pose { centre: Vec2::new(-gap, 0.3), angle: FRAC_PI_2 };
        let start = State { pose, twist: Twist { velocity: Vec2::new(-1e-12, -0.04), spin: 0.0 } };
        let (_, trace, happening) = followed_with(&world, start, vec![true, true], Options::default());
        assert_eq!((happening, trace.impacts.len()), (Happening::FliesAway, 0), "{gap} m from the wall");
    }
}
