//! Faces of many corners: few of these speak for the others, and nothing of what is known of the whole face is lost.

use crate::bodies::on;
use carom_motion::spatial::{
    Body, End, Friction, Impact, Observer, Obstacle, Options, Plane, Run, State, Supports, World, run,
};
use carom_num::elementary::{atan, cos, sin};
use carom_num::{Mat3, Rotation, Vec3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use std::f64::consts::{PI, TAU};
use std::ops::ControlFlow;

const G: f64 = 9.81;
const RADIUS: f64 = 0.05;

/// A prism of 1 kg on a regular polygon, upright: the corners of its lower face come first, the first of them at this angle from the x axis.
fn prism(sides: u32, half: f64, angle: f64) -> Body {
    let corner = |z: f64| {
        move |k: u32| {
            let at = angle + TAU * f64::from(k) / f64::from(sides);
            Vec3::new(RADIUS * cos(at), RADIUS * sin(at), z)
        }
    };
    let corners = (0..sides).map(corner(-half)).chain((0..sides).map(corner(half))).collect();
    let (across, axial) = (RADIUS * RADIUS / 4.0 + half * half / 3.0, RADIUS * RADIUS / 2.0);
    Body::new(1.0, Mat3::diagonal(across, across, axial), corners).unwrap()
}

/// Ends a run at its first impact.
struct First;

impl Observer for First {
    fn impact(&mut self, _: &Impact) -> ControlFlow<()> {
        ControlFlow::Break(())
    }
}

/// From the axis of a regular polygon to its sides.
fn inner(sides: u32) -> f64 {
    RADIUS * cos(PI / f64::from(sides))
}

fn upright(half: f64) -> State {
    State { centre: Vec3::Z * half, attitude: Rotation::NONE, velocity: Vec3::ZERO, spin: Vec3::ZERO }
}

/// Gravity on a plane z = 0 that descends towards −y by this angle.
fn down(slope: f64) -> Vec3 {
    Vec3::new(0.0, -sin(slope), -cos(slope)) * G
}

fn ran(world: &World, start: &State, most_impacts: u64) -> Run {
    let options = Options { most_time: 0.2, most_impacts, ..Options::default() };
    run(world, start, &options, &mut ()).unwrap()
}

/// Prisms on a slope with more friction than they need: they tip over where the mass centre comes to be above the lowest side, be it a side of which no corner is among those that are asked first.
#[test]
fn a_prism_of_many_sides_tips_over_its_lowest_side() {
    let half = 0.1;
    for sides in [9, 16, 17, 40, 90] {
        for turn in [0.0, 0.3, 0.5] {
            // A side, and no corner, is lowest: its normal points down the slope.
            let angle = -0.5 * PI
                + (turn * f64::from(sides)).floor() * TAU / f64::from(sides)
                + PI / f64::from(sides);
            let steepest = atan(inner(sides) / half);
            for (slope, tips) in [(steepest - 1e-6, false), (steepest + 1e-6, true)] {
                let plate = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
                let plate = Obstacle::plate(&plate.map(|(x, y)| Vec3::new(x, y, 0.0))).unwrap();
                let on_floor = on(prism(sides, half, angle), down(slope), 2.0);
                let on_plate = on_floor.clone().among(vec![plate]).unwrap();
                for world in [on_floor, on_plate] {
                    let run = ran(&world, &upright(half), 10);
                    let stays = matches!(run.end, End::AtRest { .. }) && run.state == upright(half);
                    assert_eq!(stays, !tips, "{sides} sides, {turn}: {:?}", run.end);
                    assert!(
                        !tips || run.impacts.is_empty() && run.state.spin.x > 0.0,
                        "{sides}: {:?}",
                        run.state
                    );
                }
            }
        }
    }
}

/// With friction below that they slide as blocks do, and without end.
#[test]
fn a_prism_of_many_sides_slides_as_a_block_does() {
    let (slope, friction, half) = (0.4, 0.2, 0.02);
    for sides in [8, 12, 40] {
        let world = on(prism(sides, half, 0.1), down(slope), friction);
        let run = ran(&world, &upright(half), 10);
        let way = 0.5 * G * (sin(slope) - friction * cos(slope)) * 0.2 * 0.2;
        assert!((run.state.centre - Vec3::new(0.0, -way, half)).norm() < 1e-12, "{sides}: {:?}", run.state);
        assert!(run.state.attitude.apply(Vec3::X).y.abs() < 1e-12, "{sides}");
    }
}

/// One that falls flat with any motion: no corner of its face is driven in by the impact, whichever are asked, and no energy is made.
#[test]
fn an_impact_of_a_face_of_many_corners_drives_none_of_them_in() {
    let mut rng = Pcg64::seed_from_u64(11);
    let (mut outside, half) = (0, 0.03);
    for case in 0..600 {
        let sides = rng.random_range(9..60);
        let restitution = if case % 2 == 0 { 0.0 } else { rng.random_range(0.0..0.8) };
        let friction = Friction::new(rng.random_range(0.05..0.8)).with_restitution(restitution);
        let body = prism(sides, half, rng.random_range(0.0..1.0));
        let world = World::new(body, Vec3::Z * -G).unwrap().with_friction(friction).unwrap();
        let mut one = |size: f64| rng.random_range(-size..size);
        let velocity = Vec3::new(one(1.0), one(1.0), -2.0 + one(1.0));
        // Spins that take one side of the face down, and may take the other one up.
        let start = State { velocity, spin: Vec3::new(one(30.0), one(30.0), one(20.0)), ..upright(half) };
        let mut first = First;
        let run = run(&world, &start, &Options::default(), &mut first).unwrap();
        let (Some(impact), after) = (run.impacts.first(), &run.state) else { continue };
        assert!(impact.kinetic_after <= impact.kinetic_before * (1.0 + 1e-12), "case {case}");
        let rises = |i: usize| after.velocity_of(world.body().supports()[i]).z;
        let lowest = (0..sides as usize).map(rises).fold(f64::INFINITY, f64::min);
        assert!(lowest > -1e-10, "case {case}, {sides} sides: {lowest:e}");
        outside += u32::from(impact.touching.len() > 6);
    }
    assert!(outside > 10, "corners that nobody spoke for were asked in {outside} cases");
}

/// A disc that falls flat without spin on its face comes to rest at once, or rebounds as it came.
#[test]
fn a_disc_of_many_corners_falls_flat() {
    let half = 0.01;
    for (sides, restitution) in [(9, 0.0), (33, 0.0), (33, 0.5), (90, 0.5)] {
        let friction = Friction::new(0.3).with_restitution(restitution);
        let world =
            World::new(prism(sides, half, 0.2), Vec3::Z * -G).unwrap().with_friction(friction).unwrap();
        let start = State { centre: Vec3::Z * (half + 0.05), ..upright(half) };
        let options = Options { most_time: 2.0, ..Options::default() };
        let run = run(&world, &start, &options, &mut ()).unwrap();
        assert!(matches!(run.end, End::AtRest { .. }), "{sides}: {:?}", run.end);
        let first = (2.0 * 0.05 / G).sqrt();
        // Of the times between its strikes each is the one before times the restitution.
        let rests = first * (1.0 + 2.0 * restitution / (1.0 - restitution));
        assert!((run.time - rests).abs() < 1e-9, "{sides}, {restitution}: {} and {rests}", run.time);
        assert!((run.state.centre - upright(half).centre).norm() < 1e-9, "{sides}");
    }
}

/// Half of a disc's corners in a groove's corner: it lies on a plane, and leans with other corners on a wall, which is more than are asked of one face.
#[test]
fn corners_are_numbered_as_one_likes() {
    let (half, sides) = (0.02, 24);
    let body = prism(sides, half, 0.0);
    let count = body.supports().len();
    let order: Vec<usize> = (0..count).map(|i| (7 * i + 5) % count).collect();
    let mixed = order.iter().map(|i| body.supports()[*i]).collect();
    let mixed = Body::new(body.mass(), body.inertia(), mixed).unwrap();
    let start = State { velocity: Vec3::new(0.3, -0.2, 0.0), spin: Vec3::Z * 9.0, ..upright(half) };
    let ends = [body, mixed].map(|body| {
        let obstacles = vec![Plane::FLOOR.into(), Obstacle::from(Plane::new(-Vec3::X, -0.06).unwrap())];
        let world = on(body, Vec3::Z * -G, 0.3).among(obstacles).unwrap();
        ran(&world, &start, 50)
    });
    let [a, b] = &ends;
    assert!((a.state.centre - b.state.centre).norm() < 1e-9, "{:?}\n{:?}", a.state, b.state);
    assert!((a.time - b.time).abs() < 1e-9 && a.impacts.len() == b.impacts.len());
    let named: Vec<Supports> = b
        .impacts
        .iter()
        .map(|impact| impact.striking.iter().map(|i| i / count * count + order[i % count]).collect())
        .collect();
    assert_eq!(a.impacts.iter().map(|impact| impact.striking).collect::<Vec<_>>(), named);
}

/// It spins and slides on its face until friction stops both: slip and spin end together, whatever the corners (Farkas, Bartels, Unger and Wolf, Physical Review Letters 90 (2003) 248302).
#[test]
fn a_disc_that_spins_and_slides_stops_both_at_once() {
    let half = 0.005;
    for sides in [12, 40] {
        let world = on(prism(sides, half, 0.1), Vec3::Z * -G, 0.4);
        let start = State { velocity: Vec3::X * 0.4, spin: Vec3::Z * 12.0, ..upright(half) };
        let options = Options { most_time: 1.0, ..Options::default() };
        let run = run(&world, &start, &options, &mut ()).unwrap();
        assert!(matches!(run.end, End::AtRest { .. }), "{sides}: {:?}", run.end);
        let tilt = run.state.attitude.apply(Vec3::X).z;
        assert!(run.time > 0.05 && tilt.abs() < 1e-12 && run.impacts.is_empty(), "{sides}: {}", run.time);
    }
}
