//! What event functions begin with.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use super::*;
use crate::planar::geometry::{Body, Feature, Obstacle, Pose, Shape, State, Twist};
use crate::planar::modes::mode::Acceleration;
use carom_impact::Law;
use carom_num::Vec2;

/// A ball of 0.1 m that leaves a floor with 2 m/s at g = 10 m/s²: its gap is `2 t − 10 t²/2`. In the world's own units, 0.1 m and 0.1 s, the
/// rates are 2 and −1.
#[test]
fn a_gap_begins_with_its_rate_and_its_whole_second_rate() {
    let ball = Body { shape: Shape::new(vec![Vec2::ZERO], 0.1).unwrap(), mass: 1.0, inertia: 0.005 };
    let floor = Obstacle::new(Vec2::new(-1.0, 0.0), Vec2::new(1.0, 0.0), 0.3, 0.5);
    let gravity = Vec2::new(0.0, -10.0);
    let world = World::of_one(gravity, ball, vec![floor], Law::Poisson);
    let pair =
        Pairing { body: 0, obstacle: 0, feature: Feature::VertexOnFace { vertex: 0, face: Obstacle::LEFT } };
    let start = State {
        pose: Pose { centre: Vec2::new(0.0, 0.1), angle: 0.0 },
        twist: Twist { velocity: Vec2::new(0.0, 2.0), spin: 0.0 },
    };
    let acceleration = [Acceleration { linear: gravity, angular: 0.0 }];
    let forces: Forces<1> = Forces { acceleration, ..Forces::default() };
    let Beginning { value, rates } = world.gap_beginning(&[start], &forces, pair);
    assert_eq!(value, 0.0, "it touches");
    assert!((rates[0] - 2.0).abs() < 1e-14 && (rates[1] + 1.0).abs() < 1e-14, "{rates:?}");
}
