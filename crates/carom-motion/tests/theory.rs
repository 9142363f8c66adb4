//! Motion against the closed forms of the literature.

use carom_impact::Law;
use carom_impact::planar::Slip;
use carom_motion::planar::trace::{Piece, PieceEnd, Trace};
use carom_motion::planar::{
    Body, Feature, Happening, Obstacle, Options, Pose, Recorder, Shape, State, Twist, Walker, World,
};
use carom_num::Vec2;
use carom_theory::bouncing::Drop;
use carom_theory::incline::{Incline, tipping_offset_at_rest, tipping_offset_sliding};
use carom_theory::rod_on_edge::{EdgeState, PartOnEdge};
use carom_theory::rod_on_plate::{EndState, SlidingEnd};

const G: f64 = 9.81;
/// Forces and rates agree to what a state of 1e-11 accuracy leaves of them.
const CLOSE: f64 = 1e-9;

fn world(shape: Shape, inertia: f64, obstacles: Vec<Obstacle>) -> World {
    World::of_one(Vec2::new(0.0, -G), Body { shape, mass: 0.3, inertia }, obstacles, Law::Poisson)
}

/// A plate that descends to the right by `slope` to its free edge at the origin.
fn plate(slope: f64, friction: f64, restitution: f64) -> Obstacle {
    Obstacle::new(Vec2::at_angle(-slope) * -2.0, Vec2::ZERO, friction, restitution)
}

fn rectangle(length: f64, height: f64) -> Shape {
    let (a, b) = (0.5 * length, 0.5 * height);
    Shape::new([(-a, -b), (a, -b), (a, b), (-a, b)].map(|(x, y)| Vec2::new(x, y)).to_vec(), 0.0).unwrap()
}

/// Lying on a plate of this slope, the mass centre `back` before its edge and `height` above it.
fn lying(slope: f64, back: f64, height: f64) -> State {
    let along = Vec2::at_angle(-slope);
    let pose = Pose { centre: along * -back + along.turned_left() * height, angle: -slope };
    State { pose, twist: Twist::default() }
}

fn walk(world: &World, start: State, most_events: u64) -> (Trace, Happening) {
    let options = Options { most_events, ..Options::default() };
    let mut walker = Walker::new(world, start, vec![true; world.obstacles.len()], options).unwrap();
    let mut recorder = Recorder::default();
    loop {
        let happening = walker.advance(&mut recorder).unwrap();
        if happening != Happening::Moves {
            return (recorder.into_trace(), happening);
        }
    }
}

fn near(ours: f64, theory: f64, scale: f64, what: &str) {
    assert!((ours - theory).abs() <= CLOSE * scale, "{what}: {ours} is not {theory}");
}

#[test]
fn a_box_slides_down_a_plate_and_starts_to_tip_where_statics_says() {
    for (slope, friction, height) in [(0.26, 0.15, 0.001), (0.5, 0.3, 0.02), (0.9, 0.0, 0.01)] {
        let world = world(rectangle(0.1, height), 2.5e-4, vec![plate(slope, friction, 0.0)]);
        let (trace, _) = walk(&world, lying(slope, 0.4, 0.5 * height), 30);
        let tips = trace.pieces.iter().find(|p| matches!(p.ended_by, PieceEnd::ForceZero(_))).unwrap();
        let way = 0.4 - tipping_offset_sliding(height, friction);
        let arrival = Incline { slope, friction, gravity: G }.slide(0.0, way).unwrap().unwrap();
        near(tips.end_time, arrival.time, arrival.time, "time to the tip");
        near(tips.end.twist.velocity.norm(), arrival.speed, arrival.speed, "speed at the tip");
    }
}

#[test]
fn a_box_at_rest_stays_up_to_the_edge_of_statics_and_no_farther() {
    let (slope, friction, height) = (0.2_f64, 0.5, 0.04);
    let world = world(rectangle(0.1, height), 2.5e-4, vec![plate(slope, friction, 0.0)]);
    let limit = tipping_offset_at_rest(height, slope).unwrap();
    for (back, rests) in [(1.001 * limit, true), (0.999 * limit, false)] {
        let (_, end) = walk(&world, lying(slope, back, 0.5 * height), 1);
        assert_eq!(end == Happening::Rests, rests, "{back} before the edge, limit {limit}");
    }
}

/// The pieces in which the body turns over the plate's free edge.
fn tips(trace: &Trace) -> impl Iterator<Item = &Piece> {
    let on_edge = |p: &&Piece| p.held.len() == 1 && matches!(p.held[0].feature, Feature::FaceOnEnd { .. });
    trace.pieces.iter().filter(on_edge)
}

#[test]
fn a_part_on_an_edge_meets_its_normal_force() {
    for (slope, friction, height) in [(0.26, 0.15, 0.0), (0.26, 0.15, 0.001), (0.4, 0.2, 0.01)] {
        let shape = match height {
            0.0 => Shape::new(vec![Vec2::new(-0.05, 0.0), Vec2::new(0.05, 0.0)], 0.0).unwrap(),
            _ => rectangle(0.1, height),
        };
        let world = world(shape, 2.5e-4, vec![plate(slope, friction, 0.0)]);
        let (trace, _) = walk(&world, lying(slope, 0.1, 0.5 * height), 30);
        let theory = PartOnEdge {
            mass: 0.3,
            inertia: 2.5e-4,
            half_thickness: 0.5 * height,
            friction,
            slope,
            gravity: G,
        };
        let mut compared = 0;
        for sample in tips(&trace).flat_map(|p| &p.samples) {
            let contact = &sample.contacts[0];
            let along = Vec2::at_angle(sample.state.pose.angle);
            let state = EdgeState {
                reach: sample.state.pose.centre.dot(along),
                tilt: -sample.state.pose.angle - slope,
                slip: contact.slip,
                tilt_rate: -sample.state.twist.spin,
            };
            near(
                contact.normal_force,
                theory.motion(&state).normal_force,
                0.3 * G,
                "normal force on the edge",
            );
            compared += 1;
        }
        assert!(compared > 10, "{compared} instants compared");
    }
}

#[test]
fn a_rod_that_slides_on_its_end_meets_its_normal_force() {
    let friction = 0.25;
    let shape = Shape::new(vec![Vec2::new(-0.05, 0.0), Vec2::new(0.05, 0.0)], 0.0).unwrap();
    let floor = Obstacle::new(Vec2::new(-5.0, 0.0), Vec2::new(5.0, 0.0), friction, 0.0);
    let world = world(shape, 2.5e-4, vec![floor]);
    // Its end on the floor, leaning at 1.1 rad, sliding to the right.
    let centre = Vec2::at_angle(1.1) * 0.05;
    let state = State {
        pose: Pose { centre, angle: 1.1 },
        twist: Twist { velocity: Vec2::new(0.6, 0.0), spin: 0.0 },
    };
    let (trace, _) = walk(&world, state, 30);
    let theory = SlidingEnd { mass: 0.3, inertia: 2.5e-4, arm: 0.05, friction, gravity: [0.0, G] };
    let mut compared = 0;
    for piece in trace.pieces.iter().filter(|p| p.held.len() == 1 && p.held[0].slip != Slip::Sticks) {
        for sample in &piece.samples {
            let contact = &sample.contacts[0];
            // From the end to the mass centre.
            let arm = sample.state.pose.centre - contact.point;
            let angle = carom_num::elementary::atan2(arm.y, arm.x);
            let state = EndState { angle, spin: sample.state.twist.spin, slip: contact.slip };
            near(
                contact.normal_force,
                theory.motion(&state).normal_force,
                0.3 * G,
                "normal force on the end",
            );
            compared += 1;
        }
    }
    assert!(compared > 10, "{compared} instants compared");
}

#[test]
fn a_ball_bounces_at_its_times_and_stops_at_its_limit() {
    for restitution in [0.3, 0.7, 0.9] {
        let floor = Obstacle::new(Vec2::new(-1.0, 0.0), Vec2::new(1.0, 0.0), 0.0, restitution);
        let ball = Shape::new(vec![Vec2::ZERO], 0.02).unwrap();
        let world = world(ball, 1e-4, vec![floor]);
        let theory = Drop { height: 0.5, gravity: G, restitution };
        let start =
            State { pose: Pose { centre: Vec2::new(0.0, 0.52), angle: 0.0 }, twist: Twist::default() };
        let (trace, end) = walk(&world, start, 10_000);
        for (n, impact) in (1..).zip(&trace.impacts).take(12) {
            near(impact.time, theory.touch_time(n), 1.0, "touch");
            near(impact.after.velocity.y, theory.rebound_speed(n), 1.0, "rebound");
        }
        assert_eq!(end, Happening::Rests);
        let last = trace.pieces.last().unwrap().end_time;
        let limit = theory.end_of_bouncing().unwrap();
        assert!(
            (last - limit).abs() < 1e-5 * (0.02 / G).sqrt() / (1.0 - restitution),
            "{last} is not {limit}"
        );
        assert!(!trace.accumulations.is_empty(), "the series is closed at its limit, and said to be");
    }
}

#[test]
fn a_disc_rolls_or_slides_as_friction_allows() {
    // A uniform disc rolls where tan α ≤ 3 μ, with a = (2/3) g sin α; else it slides.
    let radius = 0.02;
    for (slope, friction, rolls) in [(0.3_f64, 0.2, true), (0.3, 0.08, false)] {
        let disc = Shape::new(vec![Vec2::ZERO], radius).unwrap();
        let world = world(disc, 0.5 * 0.3 * radius * radius, vec![plate(slope, friction, 0.0)]);
        let (trace, _) = walk(&world, lying(slope, 0.5, radius), 3);
        let first = &trace.pieces[0];
        assert_eq!(first.held[0].slip == Slip::Sticks, rolls, "slope {slope}, friction {friction}");
        let (sin, cos) = carom_num::elementary::sin_cos(slope);
        let a = if rolls { 2.0 / 3.0 * G * sin } else { G * (sin - friction * cos) };
        near(first.end_time, (2.0 * 0.5 / a).sqrt(), 1.0, "time to the edge");
        near(first.end.twist.velocity.norm(), (2.0 * 0.5 * a).sqrt(), 1.0, "speed at the edge");
    }
}
