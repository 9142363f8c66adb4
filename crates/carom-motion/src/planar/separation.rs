//! How far the body is from an obstacle, and for how long it certainly stays apart.
//!
//! Two convex sets are apart where some axis separates them. Axes fixed in the world (the obstacle's normals, the line from an end to a
//! vertex) and in the body (its face normals) are tried; along each, the gap of every vertex (or end) is bounded below by a parabola, so
//! the first root of the lowest parabola is a time before which nothing can touch.

use super::kinematics::Turn;
use super::{State, World};
use carom_num::Vec2;

/// Bounds that hold over a stretch of motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bounds {
    /// How long they hold [s].
    pub(super) horizon: f64,
    /// Acceleration of the mass centre [m/s²].
    pub(super) acceleration: f64,
    /// Angular acceleration [rad/s²].
    pub(super) angular: f64,
    /// Spin [rad/s].
    pub(super) spin: f64,
    /// Speed of the mass centre [m/s].
    pub(super) speed: f64,
}

/// Distance to an obstacle and a time for which it certainly stays positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Apart {
    /// Largest separation found along an axis [m]; ≤ 0 where none separates.
    pub(super) distance: f64,
    /// Nothing touches before this long [s].
    pub(super) safe: f64,
}

/// First positive root of `gap + rate τ − bend τ² / 2`.
fn first_root(gap: f64, rate: f64, bend: f64) -> f64 {
    let root = (rate * rate + 2.0 * bend * gap).sqrt();
    if rate < 0.0 { 2.0 * gap / (root - rate) } else { (rate + root) / bend.max(f64::MIN_POSITIVE) }
}

impl World {
    /// Separation of the body and an obstacle along the best axis [m]: the distance where they are apart, negative where they overlap.
    pub fn clearance(&self, state: &State, obstacle: usize) -> f64 {
        let still = Bounds { horizon: 0.0, acceleration: 0.0, angular: 0.0, spin: 0.0, speed: 0.0 };
        self.apart(state, obstacle, &still).distance
    }

    pub(super) fn apart(&self, state: &State, obstacle: usize, bounds: &Bounds) -> Apart {
        let turn = Turn::of(state);
        let mut best = Apart { distance: f64::NEG_INFINITY, safe: 0.0 };
        let o = &self.obstacles[obstacle];
        let normal = o.direction().turned_left();
        for axis in [normal, -normal] {
            self.try_world_axis(state, turn, obstacle, axis, bounds, &mut best);
        }
        self.try_body_axes(state, turn, obstacle, bounds, &mut best);
        if best.distance <= 0.0 || self.body.shape.radius() > 0.0 {
            for end in [o.from, o.to] {
                for v in self.body.shape.vertices() {
                    let d = state.pose.centre + turn.apply(*v) - end;
                    if let Some(axis) = d.unit() {
                        self.try_world_axis(state, turn, obstacle, axis, bounds, &mut best);
                    }
                }
            }
        }
        best.safe = best.safe.min(bounds.horizon);
        best
    }

    fn try_world_axis(
        &self,
        state: &State,
        turn: Turn,
        obstacle: usize,
        axis: Vec2,
        bounds: &Bounds,
        best: &mut Apart,
    ) {
        let o = &self.obstacles[obstacle];
        let (c, v, w) = (state.pose.centre, state.twist.velocity, state.twist.spin);
        let support = axis.dot(o.from).max(axis.dot(o.to)) + self.body.shape.radius();
        let (mut distance, mut safe) = (f64::INFINITY, f64::INFINITY);
        for vertex in self.body.shape.vertices() {
            let r = turn.apply(*vertex);
            let gap = axis.dot(c + r) - support;
            distance = distance.min(gap);
            if distance <= 0.0 {
                break;
            }
            let bend = bounds.acceleration + (bounds.angular + bounds.spin * bounds.spin) * r.norm();
            safe = safe.min(first_root(gap, axis.dot(v + r.turned_left() * w), bend));
        }
        best.take(distance, safe);
    }

    fn try_body_axes(&self, state: &State, turn: Turn, obstacle: usize, bounds: &Bounds, best: &mut Apart) {
        let o = &self.obstacles[obstacle];
        let (c, v, w) = (state.pose.centre, state.twist.velocity, state.twist.spin);
        let shape = &self.body.shape;
        for face in 0..shape.faces() {
            let outward = shape.face_normal(face);
            let support = outward.dot(shape.vertices()[face]) + shape.radius();
            let axis = turn.apply(outward);
            let (mut distance, mut safe) = (f64::INFINITY, f64::INFINITY);
            for end in [o.from, o.to] {
                let d = end - c;
                let gap = axis.dot(d) - support;
                distance = distance.min(gap);
                if distance <= 0.0 {
                    break;
                }
                // The end's acceleration as seen from the body: −a, the turning terms, and Coriolis.
                let reach = d.norm() + bounds.speed * bounds.horizon;
                let turning = bounds.angular + bounds.spin * bounds.spin;
                let bend = bounds.acceleration + turning * reach + 2.0 * bounds.spin * bounds.speed;
                safe = safe.min(first_root(gap, w * axis.turned_left().dot(d) - axis.dot(v), bend));
            }
            best.take(distance, safe);
        }
    }
}

impl Apart {
    fn take(&mut self, distance: f64, safe: f64) {
        self.distance = self.distance.max(distance);
        if distance > 0.0 {
            self.safe = self.safe.max(safe);
        }
    }
}
