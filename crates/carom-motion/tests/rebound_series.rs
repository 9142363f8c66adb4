//! A ball that bounces on a plane comes to it after infinitely many rebounds, at a time that is known, and moves along it as if it had never bounced.

use crate::walk::followed;

use carom_impact::Law;
use carom_motion::planar::{Body, Obstacle, Pose, Shape, State, Twist, World};
use carom_num::Vec2;
use carom_num::elementary::sin_cos;

/// Gravity [m/s²].
const GRAVITY: f64 = 9.81;
/// How high a ball falls from, above where it touches [m].
const HEIGHT: f64 = 0.3;
/// Radius of a ball [m].
const RADIUS: f64 = 0.05;
/// How far the plane reaches from the origin: a distance from it is rounded as this length is [m].
const REACH: f64 = 50.0;
/// Long enough for all to roll or slide [s].
const UNTIL: f64 = 3.0;

/// A ball on a plane without friction that falls at this angle [rad]: how much later than it should the series ends and how long the hops take that are as
/// low as rounding of the ball's place [s], and how much too far and too fast it is at last along the plane [m, m/s].
fn astray(angle: f64, restitution: f64) -> [f64; 4] {
    let (sine, cosine) = sin_cos(angle);
    let down = Vec2::new(cosine, -sine);
    let plane = Obstacle::new(down * -REACH, down * REACH, 0.0, restitution);
    let shape = Shape::new(vec![Vec2::ZERO], RADIUS).unwrap();
    let ball = Body { shape, mass: 0.1, inertia: 0.5 * 0.1 * RADIUS * RADIUS };
    let world = World::of_one(Vec2::new(0.0, -GRAVITY), ball, vec![plane], Law::Poisson);
    let centre = down.turned_left() * (RADIUS + HEIGHT);
    let start = State { pose: Pose { centre, angle: 0.0 }, twist: Twist::default() };
    let (end, trace, _) = followed(&world, start, vec![true], UNTIL);
    // One fall, then hops of twice eⁿ falls.
    let fall = (2.0 * HEIGHT / (GRAVITY * cosine)).sqrt();
    let stops = fall * (1.0 + 2.0 * restitution / (1.0 - restitution));
    let [(_, limit)] = trace.accumulations[..] else { panic!("{:?}", trace.accumulations) };
    let along = GRAVITY * sine;
    let (x, v) = (down.dot(end.pose.centre), down.dot(end.twist.velocity));
    let rounding = f64::EPSILON * REACH;
    let hops = (8.0 * rounding / (GRAVITY * cosine)).sqrt() / (1.0 - restitution);
    [limit - stops, hops, x - 0.5 * along * UNTIL * UNTIL, v - along * UNTIL]
}

#[test]
fn a_series_of_rebounds_leaves_what_moves_along_the_plane_alone() {
    for restitution in [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8] {
        for angle in [0.0, 0.1, 0.3, 0.6] {
            let [late, hops, far, fast] = astray(angle, restitution);
            assert!(
                far.abs() < 1e-13 && fast.abs() < 1e-13,
                "e = {restitution}, {angle} rad: {far} m, {fast} m/s"
            );
            assert!(late.abs() < hops, "e = {restitution}, {angle} rad: {late} s late, {hops} s of hops");
        }
    }
}
