//! A face across the joint of two plates in line moves as on one plate.

use carom_impact::Law;
use carom_motion::planar::{
    Body, Happening, Obstacle, Options, Pose, Recorder, Shape, State, Twist, Walker, World,
};
use carom_num::Vec2;

const SLOPE: f64 = 0.4;
const FRICTION: f64 = 0.25;

/// Plates in line down the slope, between these distances along it.
fn plates(joints: &[f64]) -> Vec<Obstacle> {
    let along = Vec2::at_angle(-SLOPE);
    joints.windows(2).map(|j| Obstacle::new(along * j[0], along * j[1], FRICTION, 0.3)).collect()
}

fn world(shape: Shape, joints: &[f64]) -> World {
    let body = Body { shape, mass: 0.3, inertia: 2.5e-4 };
    World::of_one(Vec2::new(0.0, -9.81), body, plates(joints), Law::Poisson)
}

fn shape(corners: &[(f64, f64)]) -> Shape {
    Shape::new(corners.iter().map(|(x, y)| Vec2::new(*x, *y)).collect(), 0.0).unwrap()
}

/// Lying on the slope, the mass centre at this distance along it.
fn lying(at: f64, height: f64) -> State {
    let along = Vec2::at_angle(-SLOPE);
    let pose = Pose { centre: along * at + along.turned_left() * height, angle: -SLOPE };
    State { pose, twist: Twist::default() }
}

/// Where it is after `time`, and after how many events.
fn after(world: &World, start: State, time: f64) -> (State, u64) {
    let options = Options { most_time: time, ..Options::default() };
    let mut walker = Walker::new(world, start, vec![true; world.obstacles.len()], options).unwrap();
    while walker.advance(&mut Recorder::default()).unwrap() == Happening::Moves {}
    (*walker.state(), walker.effort().events)
}

#[test]
fn a_face_slides_over_flush_joints_as_over_one_plate() {
    let parts = [
        ("box", shape(&[(-0.05, -0.01), (0.05, -0.01), (0.05, 0.01), (-0.05, 0.01)]), 0.01),
        ("rod", shape(&[(-0.05, 0.0), (0.05, 0.0)]), 0.0),
    ];
    for (name, part, height) in parts {
        let (whole, _) = after(&world(part.clone(), &[0.0, 2.0]), lying(0.1, height), 0.5);
        for joints in [&[0.0, 0.2, 2.0][..], &[0.0, 0.12, 2.0], &[0.0, 0.2, 0.25, 2.0]] {
            let (state, events) = after(&world(part.clone(), joints), lying(0.1, height), 0.5);
            assert!(events < 40, "{name} over {joints:?}: {events} events");
            let (shift, slower) = (
                (state.pose.centre - whole.pose.centre).norm(),
                (state.twist.velocity - whole.twist.velocity).norm(),
            );
            assert!(shift < 1e-9 && slower < 1e-9, "{name} over {joints:?}: {shift:e} m, {slower:e} m/s");
        }
    }
}
