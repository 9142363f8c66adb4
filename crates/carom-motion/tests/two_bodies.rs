//! The geometry of two bodies that both move: against a fixed obstacle, and against its own time derivatives.

use carom_impact::Law;
use carom_motion::planar::{
    Body, Feature, Kinematics, Obstacle, Pairing, Pose, Shape, State, Surface, Twist, World,
};
use carom_num::Vec2;

const ROUNDED: f64 = 0.02;

fn body(vertices: &[(f64, f64)], radius: f64) -> Body {
    let vertices = vertices.iter().map(|&(x, y)| Vec2::new(x, y)).collect();
    Body { shape: Shape::new(vertices, radius).unwrap(), mass: 0.3, inertia: 2e-4 }
}

fn world(bodies: Vec<Body>, obstacles: Vec<Obstacle>) -> World {
    let between = Surface { friction: 0.2, restitution: 0.5 };
    World { gravity: Vec2::new(0.0, -9.81), bodies, obstacles, between, law: Law::Poisson }
}

fn state(x: f64, y: f64, angle: f64, velocity: (f64, f64), spin: f64) -> State {
    State {
        pose: Pose { centre: Vec2::new(x, y), angle },
        twist: Twist { velocity: Vec2::new(velocity.0, velocity.1), spin },
    }
}

/// A rectangle, a triangle and a rod, rounded or not, in motion.
fn shapes() -> [Body; 3] {
    [
        body(&[(-0.1, -0.05), (0.1, -0.05), (0.1, 0.05), (-0.1, 0.05)], ROUNDED),
        body(&[(-0.06, -0.04), (0.08, -0.03), (-0.01, 0.07)], 0.0),
        body(&[(-0.07, 0.0), (0.07, 0.0)], ROUNDED),
    ]
}

/// Every pair of features of two bodies.
fn features(a: &Shape, b: &Shape) -> Vec<Feature> {
    let mut out = vec![];
    for vertex in 0..a.vertices().len() {
        out.extend((0..b.faces()).map(|face| Feature::VertexOnFace { vertex, face }));
        out.extend((0..b.vertices().len()).map(|end| Feature::VertexOnEnd { vertex, end }));
    }
    for face in 0..a.faces() {
        out.extend((0..b.vertices().len()).map(|end| Feature::FaceOnEnd { face, end }));
    }
    out
}

fn worst(a: &Kinematics, b: &Kinematics) -> f64 {
    let numbers = |k: &Kinematics| {
        [k.gap, k.arm.x, k.arm.y, k.normal.x, k.normal.y, k.slip, k.approach, k.normal_bias, k.slip_bias]
    };
    numbers(a).into_iter().zip(numbers(b)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[test]
fn a_rod_that_nothing_moves_is_an_obstacle() {
    let (from, to) = (Vec2::new(-0.3, -0.2), Vec2::new(0.4, 0.1));
    let (centre, half) = ((from + to) * 0.5, (to - from) * 0.5);
    let rod = Body { shape: Shape::new(vec![-half, half], 0.0).unwrap(), mass: 1.0, inertia: 1.0 };
    let at = State { pose: Pose { centre, angle: 0.0 }, twist: Twist::default() };
    for moving in shapes() {
        let world = world(vec![moving, rod.clone()], vec![Obstacle::new(from, to, 0.2, 0.5)]);
        let here = state(0.11, 0.23, 0.7, (0.3, -1.1), 2.3);
        for feature in features(&world.bodies[0].shape, &rod.shape) {
            let of = |obstacle| world.kinematics(&[here, at], Pairing { body: 0, obstacle, feature });
            let mut other = of(2);
            // Against another body a rod without thickness has a skin; what it touches with its end touches that.
            other.gap += rod.shape.skin(0);
            let on_end = matches!(feature, Feature::FaceOnEnd { .. });
            let k = of(0);
            if on_end {
                other.arm += other.normal * -rod.shape.skin(0);
            }
            let difference = if on_end {
                (other.gap - k.gap).abs().max((other.arm - k.arm).norm())
            } else {
                worst(&k, &other)
            };
            assert!(difference < 1e-14, "{feature:?}: {difference:e}");
        }
    }
}

/// The states after a time under accelerations that stay.
fn moved(states: &[State; 2], accelerations: &[(Vec2, f64); 2], t: f64) -> [State; 2] {
    std::array::from_fn(|i| {
        let (s, (a, angular)) = (states[i], accelerations[i]);
        State {
            pose: Pose {
                centre: s.pose.centre + s.twist.velocity * t + a * (0.5 * t * t),
                angle: s.pose.angle + s.twist.spin * t + 0.5 * angular * t * t,
            },
            twist: Twist { velocity: s.twist.velocity + a * t, spin: s.twist.spin + angular * t },
        }
    })
}

/// The acceleration of the two contact points against each other along a direction.
fn relative(k: &Kinematics, direction: Vec2, accelerations: &[(Vec2, f64); 2]) -> f64 {
    let of = |(a, angular): (Vec2, f64), arm: Vec2| direction.dot(a + arm.turned_left() * angular);
    of(accelerations[0], k.arm) - of(accelerations[1], k.other_arm)
}

#[test]
fn rates_are_the_derivatives_of_gap_and_slip() {
    let accelerations = [(Vec2::new(0.7, -9.0), 31.0), (Vec2::new(-2.0, 3.0), -12.0)];
    let states = [state(0.11, 0.23, 0.7, (0.3, -1.1), 2.3), state(-0.05, 0.02, -0.4, (-0.6, 0.4), -5.1)];
    let h = 1e-5;
    for first in shapes() {
        for second in shapes() {
            let world = world(vec![first.clone(), second], vec![]);
            for feature in features(&world.bodies[0].shape, &world.bodies[1].shape) {
                let pair = Pairing { body: 0, obstacle: 1, feature };
                let at = |t: f64| world.kinematics(&moved(&states, &accelerations, t), pair);
                let (k, late, early) = (at(0.0), at(h), at(-h));
                let closing = (late.gap - early.gap) / (2.0 * h);
                assert!((closing - k.approach).abs() < 1e-6, "{feature:?}: {closing} {}", k.approach);
                let bend = (late.approach - early.approach) / (2.0 * h);
                let expected = k.normal_bias + relative(&k, k.normal, &accelerations);
                assert!(
                    (bend - expected).abs() < 1e-5 * expected.abs().max(1.0),
                    "{feature:?}: {bend} {expected}"
                );
                // Slip is that of the two points that touch: its rate is meant where the gap is zero.
                let change = (late.slip - early.slip) / (2.0 * h);
                let expected = k.slip_bias + relative(&k, k.tangent(), &accelerations);
                assert!(
                    (change - expected).abs() < 1e-5 * expected.abs().max(1.0),
                    "{feature:?}: {change} {expected}"
                );
            }
        }
    }
}

#[test]
fn either_side_sees_the_same_contact() {
    let states = [state(0.11, 0.23, 0.7, (0.3, -1.1), 2.3), state(-0.05, 0.02, -0.4, (-0.6, 0.4), -5.1)];
    for first in shapes() {
        for second in shapes() {
            let there = world(vec![first.clone(), second.clone()], vec![]);
            let back = world(vec![second.clone(), first.clone()], vec![]);
            for feature in features(&first.shape, &second.shape) {
                let k = there.kinematics(&states, Pairing { body: 0, obstacle: 1, feature });
                let seen = Pairing { body: 0, obstacle: 1, feature: feature.from_the_other_side() };
                let other = back.kinematics(&[states[1], states[0]], seen);
                let turned = Kinematics { arm: k.other_arm, other_arm: k.arm, normal: -k.normal, ..k };
                assert!(worst(&turned, &other) < 1e-12, "{feature:?}: {turned:?} {other:?}");
            }
        }
    }
}
