//! How a part in the plane stands between two samples, and how far two of it are apart.

use super::path::{Leg, Passes};
use carom_motion::planar::{Pose, Shape, State};
use carom_num::Vec2;

impl Passes for Shape {
    type State = State;
    type Pose = Pose;

    fn size(&self) -> f64 {
        self.size()
    }

    fn pose(&self, leg: &Leg<State>, u: f64) -> Pose {
        let dt = leg.lasts();
        let [a, b] = &leg.ends;
        let cubic = |p: f64, q: f64, m: f64, n: f64| {
            let (m, n) = (m * dt, n * dt);
            (((2.0 * p + m - 2.0 * q + n) * u + 3.0 * (q - p) - 2.0 * m - n) * u + m) * u + p
        };
        let along = |of: fn(Vec2) -> f64| {
            cubic(of(a.pose.centre), of(b.pose.centre), of(a.twist.velocity), of(b.twist.velocity))
        };
        Pose {
            centre: Vec2::new(along(|v| v.x), along(|v| v.y)),
            angle: cubic(a.pose.angle, b.pose.angle, a.twist.spin, b.twist.spin),
        }
    }

    fn speed(&self, [a, b]: &[State; 2], dt: f64) -> f64 {
        // A cubic's rate is a quadratic, and lies among these three.
        let mean = (b.pose.centre - a.pose.centre) * (3.0 / dt) - a.twist.velocity - b.twist.velocity;
        let turn = (b.pose.angle - a.pose.angle) * (3.0 / dt) - a.twist.spin - b.twist.spin;
        let speed = [a.twist.velocity, mean, b.twist.velocity].iter().map(|v| v.norm()).fold(0.0, f64::max);
        let spin = [a.twist.spin, turn, b.twist.spin].iter().map(|w| w.abs()).fold(0.0, f64::max);
        speed + spin * self.size()
    }

    fn distance(&self, a: &Pose, b: &Pose) -> f64 {
        distance(self, *a, *b)
    }
}

/// How far apart two poses of a shape are [m]; negative, or zero, where they overlap.
fn distance(shape: &Shape, a: Pose, b: Pose) -> f64 {
    let size = shape.size();
    let between = (b.centre - a.centre).norm();
    // Far apart their circles tell enough: it is no more than the distance.
    if between > 4.0 * size {
        return between - 2.0 * size;
    }
    let corners = |pose: Pose| {
        let turn = Vec2::at_angle(pose.angle);
        move |v: &Vec2| pose.centre + v.rotated(turn.x, turn.y)
    };
    let of_a: Vec<Vec2> = shape.vertices().iter().map(corners(a)).collect();
    let of_b: Vec<Vec2> = shape.vertices().iter().map(corners(b)).collect();
    let mut apart = f64::NEG_INFINITY;
    let mut take = |axis: Vec2| {
        let high = of_a.iter().map(|v| axis.dot(*v)).fold(f64::NEG_INFINITY, f64::max);
        let low = of_b.iter().map(|v| axis.dot(*v)).fold(f64::INFINITY, f64::min);
        apart = apart.max(low - high - 2.0 * shape.skin(0));
    };
    for (pose, sign) in [(a, 1.0), (b, -1.0)] {
        let turn = Vec2::at_angle(pose.angle);
        for face in 0..shape.faces() {
            take(shape.face_normal(face).rotated(turn.x, turn.y) * sign);
        }
    }
    for p in &of_a {
        for q in &of_b {
            take((*q - *p).unit().unwrap_or_default());
        }
    }
    apart
}
