//! Rounded bodies on the edges and corners of plates, against closed forms and what stays.

use crate::bodies::ran;
use carom_motion::spatial::{Body, Feature, Friction, Mode, Obstacle, State, Touch, World};
use carom_num::elementary::{acos, atan2, cos, sin};
use carom_num::{Mat3, Rotation, Vec3};
use carom_theory::spatial::RoundOverEdge;

const G: f64 = 9.81;
const MASS: f64 = 1.3;
const RADIUS: f64 = 0.05;

/// A level plate that ends at the y axis.
fn table() -> Obstacle {
    let corner = |x: f64, y: f64| Vec3::new(x, y, 0.0);
    Obstacle::plate(&[corner(-2.0, -9.0), corner(0.0, -9.0), corner(0.0, 9.0), corner(-2.0, 9.0)]).unwrap()
}

fn among(body: Body, gravity: Vec3, friction: f64, obstacles: Vec<Obstacle>) -> World {
    let world = World::new(body, gravity).unwrap().with_friction(Friction::new(friction)).unwrap();
    world.among(obstacles).unwrap()
}

/// A ball, or a capsule along y with half that length between its ends.
fn round(half: f64, moments: [f64; 2]) -> Body {
    let [across, along] = moments.map(|share| share * MASS * RADIUS * RADIUS);
    let ends = if half > 0.0 { vec![-half, half] } else { vec![0.0] };
    let features = ends.into_iter().map(|y| Feature::point(Vec3::Y * y).rounded(RADIUS)).collect();
    Body::of(MASS, Mat3::diagonal(across, along, across), features).unwrap()
}

/// At this angle from upright over the edge, where it turns about it at a rate.
fn over_the_edge(angle: f64, rate: f64) -> State {
    let (normal, along) = (Vec3::new(sin(angle), 0.0, cos(angle)), Vec3::new(cos(angle), 0.0, -sin(angle)));
    State {
        centre: normal * RADIUS,
        attitude: Rotation::NONE,
        velocity: along * (RADIUS * rate),
        spin: Vec3::Y * rate,
    }
}

fn angle_of(state: &State) -> f64 {
    atan2(state.centre.x, state.centre.z)
}

#[test]
fn a_ball_without_friction_leaves_an_edge_as_its_theory_says() {
    let theory = RoundOverEdge { radius: RADIUS, share: 0.0, gravity: G };
    for (angle, rate, along) in [(0.1, 0.0, 0.3), (0.02, 3.0, -1.0), (0.2, 1.0, 0.0), (1e-4, 0.0, 2.0)] {
        let world = among(round(0.0, [0.4; 2]), Vec3::Z * -G, 0.0, vec![table()]);
        let mut start = over_the_edge(angle, rate);
        start.velocity.y = along;
        let (_, samples) = ran(&world, &start, 1.5);
        let [first, last] = [samples.pieces.first(), samples.pieces.last()].map(Option::unwrap);
        let Mode::Slides { slipping, .. } = first.mode else { panic!("{angle}: {:?}", first.mode) };
        assert_eq!(
            world.touch(slipping.iter().next().unwrap()),
            Some(Touch::PointOnEdge { point: 0, other: 1 })
        );
        assert_eq!(last.mode, Mode::Flight, "{angle}: {:?}", samples.pieces);
        let leaves = acos(theory.leaves([angle, rate]).unwrap());
        let there = angle_of(&last.start);
        assert!((there - leaves).abs() < 1e-10, "{angle}: {there} {leaves}");
        let speed = RADIUS * theory.square([angle, rate], leaves).unwrap().sqrt();
        let moves = Vec3::new(cos(leaves) * speed, along, -sin(leaves) * speed);
        let off = (last.start.velocity - moves).norm();
        assert!(off < 1e-10, "{angle}: {off:e}");
        assert!((last.start.spin - start.spin).norm() < 1e-12, "nothing turns it");
    }
}

/// It goes along the edge too, and turns back there.
#[test]
fn a_ball_rolls_over_an_edge_and_along_it() {
    let theory = RoundOverEdge { radius: RADIUS, share: 0.4, gravity: G };
    for (angle, rate, across, about) in
        [(0.05, 0.5, 6.0, 0.0), (0.02, 1.0, -3.0, 20.0), (0.1, 0.2, 0.0, -30.0), (0.0, 2.0, 8.0, 5.0)]
    {
        let world = among(round(0.0, [0.4; 2]), Vec3::Z * -G, 50.0, vec![table()]);
        let frame = |angle: f64| {
            let normal = Vec3::new(sin(angle), 0.0, cos(angle));
            [Vec3::Y, normal, Vec3::Y.cross(normal)]
        };
        let [edge, normal, third] = frame(angle);
        let spin = edge * rate + third * across + normal * about;
        let start = State { velocity: spin.cross(normal * RADIUS), spin, ..over_the_edge(angle, rate) };
        let (end, samples) = ran(&world, &start, 0.08);
        let rolls = |mode: &Mode| matches!(mode, Mode::Slides { slipping, .. } if slipping.is_empty());
        assert!(samples.pieces.iter().all(|p| rolls(&p.mode)), "{angle}: {:?}", samples.pieces);
        let there = angle_of(&end.state);
        assert!(there > angle + 0.05, "{angle}: it has gone on to {there} alone");
        let [edge, normal, third] = frame(there);
        let spin = end.state.attitude.apply(end.state.spin);
        let [turned, about_now] = theory.spins([across, about], there - angle).unwrap();
        let rate = theory.square([angle, rate], there).unwrap().sqrt();
        let off = (spin - edge * rate - third * turned - normal * about_now).norm();
        assert!(off < 1e-9, "{angle}: {off:e}");
        assert!((end.state.centre.dot(normal) - RADIUS).abs() < 1e-13, "it stays on the edge");
        assert!((end.state.velocity.y + RADIUS * turned).abs() < 1e-10, "as fast along it");
    }
}

#[test]
fn a_capsule_that_lies_along_an_edge_rolls_over_it_until_it_slips() {
    let theory = RoundOverEdge { radius: RADIUS, share: 0.5, gravity: G };
    for (angle, rate, friction) in [(0.05, 0.0, 0.3), (0.1, 2.0, 0.8), (0.01, 0.5, 3.0)] {
        let world = among(round(0.2, [3.0, 0.5]), Vec3::Z * -G, friction, vec![table()]);
        let (_, samples) = ran(&world, &over_the_edge(angle, rate), 0.6);
        let both = |mode: &Mode| matches!(mode, Mode::Slides { sticking, slipping } if sticking.len() == 2 && slipping.is_empty());
        let first = samples.pieces.first().unwrap();
        assert!(both(&first.mode), "{angle}: {:?}", samples.pieces);
        let slips = angle_of(&first.end);
        let [across, pushes] = theory.forces([angle, rate], slips).unwrap();
        assert!((across - friction * pushes).abs() < 1e-10, "{angle}: {across} {pushes} at {slips}");
        let turns = theory.square([angle, rate], slips).unwrap().sqrt();
        assert!((first.end.spin - Vec3::Y * turns).norm() < 1e-9, "{angle}: {:?} {turns}", first.end.spin);
    }
}

/// From the plate over its end, and nothing is lost: rolling on the face goes on as rolling on the edge.
#[test]
fn a_ball_rolls_off_a_plate_without_an_impact() {
    let theory = RoundOverEdge { radius: RADIUS, share: 0.4, gravity: G };
    for speed in [0.05, 0.3] {
        let world = among(round(0.0, [0.4; 2]), Vec3::Z * -G, 20.0, vec![table()]);
        let spin = Vec3::Y * (speed / RADIUS);
        let start = State {
            centre: Vec3::new(-0.1, 0.0, RADIUS),
            attitude: Rotation::NONE,
            velocity: Vec3::X * speed,
            spin,
        };
        let (end, samples) = ran(&world, &start, 0.1 / speed + 0.05);
        assert!(end.impacts.is_empty(), "{speed}: {:?}", end.impacts);
        let [face, edge] = [samples.pieces[0], samples.pieces[1]];
        assert!((face.end_time - 0.1 / speed).abs() < 1e-10, "{speed}: {}", face.end_time);
        let Mode::Slides { sticking, slipping } = edge.mode else { panic!("{speed}: {:?}", edge.mode) };
        assert!(sticking.len() == 1 && slipping.is_empty(), "{speed}: {:?}", edge.mode);
        let there = angle_of(&edge.end);
        let square = theory.square([0.0, speed / RADIUS], there).unwrap();
        assert!((edge.end.spin.y - square.sqrt()).abs() < 1e-9, "{speed}: {} {square}", edge.end.spin.y);
    }
}

/// Askew over a rail without friction: gravity acts along the rail, and nothing about it, nor about the capsule's own axis.
#[test]
fn a_capsule_slides_over_an_edge_and_keeps_what_it_must() {
    let rail = |y: f64, z: f64| Vec3::new(0.0, y, z);
    let rail =
        Obstacle::plate(&[rail(-9.0, 0.0), rail(9.0, 0.0), rail(9.0, -1.0), rail(-9.0, -1.0)]).unwrap();
    let [axial, across, half] = [0.6 * RADIUS * RADIUS * MASS, 0.01, 0.4];
    let features = [-half, half].map(|x| Feature::point(Vec3::X * x).rounded(RADIUS)).to_vec();
    let body = Body::of(MASS, Mat3::diagonal(axial, across, across), features).unwrap();
    for (turn, spin, velocity) in [
        (Vec3::new(0.3, 0.0, 0.4), Vec3::new(9.0, -2.0, 1.0), Vec3::new(1.0, 0.3, 0.0)),
        (Vec3::new(0.0, 0.1, -0.7), Vec3::new(-4.0, -1.0, -2.0), Vec3::new(0.5, -1.0, 0.0)),
    ] {
        let world = among(body.clone(), Vec3::Y * -G, 0.0, vec![rail.clone()]);
        let attitude = Rotation::by(turn);
        // Its axis is RADIUS above the rail, and it moves away from it only as its turning makes it.
        let axis = attitude.apply(Vec3::X);
        let normal = axis.cross(Vec3::Y).unit().unwrap();
        let centre = normal * RADIUS + axis * 0.03;
        let turns = attitude.apply(spin);
        let material = velocity + turns.cross(normal * RADIUS - centre);
        let start = State { centre, attitude, velocity: velocity - normal * normal.dot(material), spin };
        let (end, samples) = ran(&world, &start, 0.15);
        let modes: Vec<Mode> = samples.pieces.iter().map(|p| p.mode).collect();
        assert!(matches!(modes[0], Mode::Slides { .. }), "{modes:?}");
        let kept = |state: &State, time: f64| {
            let world_spin = state.attitude.turn(body.inertia()) * state.attitude.apply(state.spin);
            let about = world_spin + state.centre.cross(state.velocity) * MASS;
            let gone = state.velocity.y + G * time;
            [about.y, state.spin.x, gone, state.kinetic(&body) + MASS * G * state.centre.y]
        };
        let piece = samples.pieces[0];
        assert!(piece.end_time > 0.01, "{:?}", samples.pieces);
        let (before, after) = (kept(&start, 0.0), kept(&piece.end, piece.end_time));
        for (one, other) in before.into_iter().zip(after) {
            assert!((one - other).abs() < 1e-10, "{before:?} {after:?}");
        }
        let axis = piece.end.attitude.apply(Vec3::X);
        let apart = axis.cross(Vec3::Y).unit().unwrap().dot(piece.end.centre);
        assert!((apart - RADIUS).abs() < 1e-12, "{apart}");
        assert!(end.impacts.is_empty());
    }
}
