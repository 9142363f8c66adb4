//! Several bodies: they meet, push, part and go on, as closed forms say.

#![allow(clippy::unwrap_used, missing_docs)]

use carom_impact::planar::Law;
use carom_motion::planar::trace::Trace;
use carom_motion::planar::{
    Body, Crowd, Happening, MassProperties, Obstacle, Options, Pose, Recorder, Shape, State, Surface, Twist,
    Walker, World,
};
use carom_num::Vec2;
use carom_num::elementary::{cos, sin};

const G: f64 = 9.81;

fn disc(radius: f64, mass: f64) -> Body {
    Body { shape: Shape::new(vec![Vec2::ZERO], radius).unwrap(), mass, inertia: 0.5 * mass * radius * radius }
}

fn rectangle(width: f64, height: f64, mass: f64) -> Body {
    let (x, y) = (0.5 * width, 0.5 * height);
    let corners = [(-x, -y), (x, -y), (x, y), (-x, y)].map(|(x, y)| Vec2::new(x, y));
    let shape = Shape::new(corners.to_vec(), 0.0).unwrap();
    Body { shape, mass, inertia: mass * (width * width + height * height) / 12.0 }
}

fn world(gravity: f64, bodies: Vec<Body>, obstacles: Vec<Obstacle>, between: (f64, f64)) -> World {
    let between = Surface { friction: between.0, restitution: between.1 };
    World { gravity: Vec2::new(0.0, -gravity), bodies, obstacles, between, law: Law::Poisson }
}

fn state(centre: Vec2, angle: f64, velocity: Vec2, spin: f64) -> State {
    State { pose: Pose { centre, angle }, twist: Twist { velocity, spin } }
}

/// Walks all bodies up to a time; their states there, and what was recorded.
fn walk(world: &World, starts: &[State], until: f64) -> (Vec<State>, Vec<Trace>) {
    let options = Options::default();
    let mut crowd = Crowd::new(world, options);
    for (body, start) in starts.iter().enumerate() {
        crowd.enter(body, *start, vec![true; world.obstacles.len()]).unwrap();
    }
    let mut recorders = vec![Recorder::default(); starts.len()];
    while crowd.time() < until {
        let step = crowd.advance(until, &mut recorders).unwrap();
        assert_ne!(step.happening, Happening::BudgetSpent);
    }
    crowd.pause(&mut recorders).unwrap();
    let at_end = (0..starts.len()).map(|body| *crowd.member(body).unwrap().state()).collect();
    (at_end, recorders.into_iter().map(Recorder::into_trace).collect())
}

#[test]
fn two_discs_meet_head_on() {
    let world = world(0.0, vec![disc(0.1, 1.0), disc(0.2, 3.0)], vec![], (0.3, 0.5));
    let starts = [
        state(Vec2::ZERO, 0.0, Vec2::new(2.0, 0.0), 0.0),
        state(Vec2::new(1.3, 0.0), 0.0, Vec2::new(0.0, 0.0), 0.0),
    ];
    let (end, traces) = walk(&world, &starts, 1.0);
    // They meet after 1 m at 2 m/s; 2 m/s before, half of it after, the mass centre at 0.5 m/s.
    assert_eq!(traces[0].impacts.len(), 1);
    assert!((traces[0].impacts[0].time - 0.5).abs() < 1e-14);
    let after = [end[0].twist.velocity.x, end[1].twist.velocity.x];
    assert!((after[0] + 0.25).abs() < 1e-14 && (after[1] - 0.75).abs() < 1e-14, "{after:?}");
    assert!((end[1].pose.centre.x - 1.3 - 0.375).abs() < 1e-13);
}

/// A slope that descends to the right from the origin.
fn slope(angle: f64, friction: f64, restitution: f64) -> Obstacle {
    Obstacle::new(Vec2::at_angle(-angle) * -3.0, Vec2::at_angle(-angle) * 20.0, friction, restitution)
}

/// A body whose lowest point is `height` below its centre, on that slope.
fn on_slope(angle: f64, along: f64, height: f64, speed: f64, spin: f64) -> State {
    let down = Vec2::at_angle(-angle);
    state(down * along + down.turned_left() * height, -angle, down * speed, spin)
}

#[test]
fn a_disc_that_rolls_into_a_box_pushes_it() {
    let (angle, friction, radius) = (0.5, 0.3, 0.05);
    let bodies = vec![disc(radius, 2.0), rectangle(0.2, 0.1, 1.0)];
    let world = world(G, bodies, vec![slope(angle, friction, 0.0)], (0.0, 0.0));
    let starts = [on_slope(angle, 0.0, 0.05, 0.5, -10.0), on_slope(angle, 0.3, 0.05, 0.2, 0.0)];
    let (_, traces) = walk(&world, &starts, 1.0);
    // Together: the disc rolls (its inertia counts half as much again), the box slides.
    let (pull, held) = (G * sin(angle), friction * G * cos(angle));
    let together = (2.0 * pull + (pull - held)) / (1.5 * 2.0 + 1.0);
    let push = together - (pull - held);
    let piece = traces[1].pieces.last().unwrap();
    assert_eq!(piece.held.len(), 3, "{piece:?}");
    for sample in &piece.samples {
        let contact = sample.contacts.iter().find(|c| c.obstacle == 1).unwrap();
        assert!((contact.normal_force - push).abs() < 1e-9, "{} {push}", contact.normal_force);
    }
    let gained = (piece.end.twist.velocity.norm() - piece.start.twist.velocity.norm())
        / (piece.end_time - piece.start_time);
    assert!((gained - together).abs() < 1e-9, "{gained} {together}");
    // Before they met, both moved alone: from 5 cm apart at 0.3 m/s, one as a rolling disc, the other as a sliding box.
    let (met, gap) = (traces[1].impacts[0].time, 0.3 - 0.1 - radius);
    let closed = gap - 0.3 * met - 0.5 * (pull / 1.5 - (pull - held)) * met * met;
    assert!(closed.abs() < 1e-11, "{closed}");
}
