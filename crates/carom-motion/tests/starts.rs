//! How a walk begins: what touches at the start is asked what it does, and strikes at once are told.

use carom_impact::Law;
use carom_motion::MotionError;
use carom_motion::planar::{
    Body, ChainPoint, Feature, Happening, Obstacle, Options, Pose, Recorder, Shape, State, Twist, Walker,
    World,
};
use carom_num::Vec2;

fn segment(from: (f64, f64), to: (f64, f64), friction: f64) -> Obstacle {
    Obstacle::new(Vec2::new(from.0, from.1), Vec2::new(to.0, to.1), friction, 0.0)
}

fn world(corners: &[(f64, f64)], obstacles: Vec<Obstacle>) -> World {
    let shape = Shape::new(corners.iter().map(|(x, y)| Vec2::new(*x, *y)).collect(), 0.0).unwrap();
    let body = Body { shape, mass: 0.3, inertia: 2.5e-4 };
    World::of_one(Vec2::new(0.0, -9.81), body, obstacles, Law::Poisson)
}

fn at(x: f64, y: f64, vx: f64) -> State {
    State {
        pose: Pose { centre: Vec2::new(x, y), angle: 0.0 },
        twist: Twist { velocity: Vec2::new(vx, 0.0), spin: 0.0 },
    }
}

fn begin(world: &World, start: State, recorder: &mut Recorder) -> Result<Happening, MotionError> {
    Walker::new(world, start, vec![true; world.obstacles.len()], Options::default())
        .unwrap()
        .advance(recorder)
}

#[test]
fn a_rod_on_the_common_end_of_two_plates_tips_over_it() {
    let plates = vec![segment((-1.0, 0.0), (0.0, 0.0), 0.9), segment((0.0, 0.0), (0.3, -1.0), 0.9)];
    let world = world(&[(-0.05, 0.0), (0.05, 0.0)], plates);
    let happening = begin(&world, at(0.02, 0.0, 0.0), &mut Recorder::default());
    assert_eq!(happening, Ok(Happening::Moves), "its centre is beyond the joint");
}

#[test]
fn a_strike_at_the_start_is_told() {
    let obstacles = vec![segment((-1.0, 0.0), (1.0, 0.0), 0.1), segment((0.05, 0.0), (0.05, 1.0), 0.1)];
    let world = world(&[(-0.05, -0.01), (0.05, -0.01), (0.05, 0.01), (-0.05, 0.01)], obstacles);
    let mut recorder = Recorder::default();
    begin(&world, at(0.0, 0.01, 1.0), &mut recorder).unwrap();
    let impact = &recorder.trace().impacts[0];
    assert_eq!((impact.time, impact.before.velocity.x), (0.0, 1.0));
    assert!(impact.after.velocity.x <= 1e-12, "{:?}", impact.after);
}

#[test]
fn more_contacts_than_fit_are_an_error_from_the_start() {
    let joints = [-0.2, -0.06, -0.05, -0.04, -0.03, -0.02, -0.01, 0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.2];
    let plates = joints.windows(2).map(|j| segment((j[0], 0.0), (j[1], 0.0), 0.5)).collect();
    let world = world(&[(-0.07, -0.01), (0.07, -0.01), (0.07, 0.01), (-0.07, 0.01)], plates);
    let happening = begin(&world, at(0.0, 0.01, 0.0), &mut Recorder::default());
    assert!(matches!(happening, Err(MotionError::Impact { .. })), "{happening:?}");
}

#[test]
fn a_rod_and_a_bent_obstacle_that_are_both_without_thickness_are_refused() {
    let bent = [(-1.0, 0.5), (0.0, 0.0), (1.0, 0.5)].map(|(x, y)| ChainPoint::straight(Vec2::new(x, y)));
    let bent = Obstacle::of_shape(Shape::of_open_chain(&bent).unwrap(), 0.3, 0.0);
    let floor = segment((-1.0, -1.0), (1.0, -1.0), 0.3);
    let among = |body: &[(f64, f64)]| {
        let world = world(body, vec![floor.clone(), bent.clone()]);
        Walker::new(&world, at(0.0, 0.9, 0.0), vec![], Options::default()).map(|_| ())
    };
    let refused = MotionError::BothThin { body: 0, obstacle: 1 };
    assert_eq!(among(&[(-0.1, 0.0), (0.1, 0.0)]), Err(refused));
    assert_eq!(among(&[(-0.1, 0.0), (0.1, 0.0), (0.0, 1e-9)]), Ok(()), "a sliver has an inside");
}

/// A rod without thickness over the end of a sheet, its front beyond the end and a hair below the sheet's line: it turns about the end, and its rear
/// strikes the sheet from above after the angle over the spin.
#[test]
fn a_rod_that_reaches_below_the_line_of_a_sheet_beyond_its_end_is_still_above_it() {
    let (spin, half) = (200.0, 0.05);
    for exponent in 3..10 {
        for beyond in [0.1, 0.5, 0.9] {
            let angle = 10f64.powi(-exponent);
            let sheet = Obstacle::new(Vec2::new(-1.0, 0.0), Vec2::ZERO, 0.0, 0.5);
            let world = world(&[(-half, 0.0), (half, 0.0)], vec![sheet]);
            let arm = beyond * half;
            let along = Vec2::new(1.0, -angle).unit().unwrap();
            // It turns about the end, and slides back, which lifts it off the end.
            let velocity = along.turned_left() * (spin * arm) - along * 0.1;
            let start =
                State { pose: Pose { centre: along * arm, angle: -angle }, twist: Twist { velocity, spin } };
            let mut recorder = Recorder::default();
            begin(&world, start, &mut recorder).unwrap();
            let impact = &recorder.trace().impacts[0];
            let Feature::VertexOnFace { vertex: 0, face: Obstacle::LEFT } = impact.contacts[0].feature else {
                panic!("{angle:e} rad, {beyond}: {impact:#?}")
            };
            let late = impact.time * spin / angle - 1.0;
            assert!(late.abs() < 2.0 * angle + 1e-5, "{angle:e} rad, {beyond}: by {late:e}");
        }
    }
}
