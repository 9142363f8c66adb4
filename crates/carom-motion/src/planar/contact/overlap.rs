//! How far a body and an obstacle of any outline reach into each other.

use super::World;
use crate::planar::geometry::{Pose, Shape, State};
use crate::tolerance::COINCIDENT_VERTICES;
use carom_num::Vec2;
use carom_num::elementary::{atan2, sin_cos};
use std::f64::consts::TAU;

impl Shape {
    /// How deep the outline of another shape reaches into this one where this one has a pose in the other's frame [m]; negative where it stays outside.
    /// The sign is exact: segments and arcs are cut where they meet this outline, and looked at in the middle between two cuts. There may be points
    /// deeper than that.
    fn reached_by(&self, other: &Self, pose: Pose) -> f64 {
        let (sin, cos) = sin_cos(pose.angle);
        let here = |p: Vec2| (p - pose.centre).rotated(cos, -sin);
        let mut deepest = f64::NEG_INFINITY;
        let mut look = |p: Vec2| deepest = deepest.max(self.depth_of(p));
        for face in 0..other.faces() {
            let next = (face + 1) % other.vertices().len();
            let end = |v: usize| here(other.vertices()[v] + other.face_normal(face) * other.radius_of(v));
            let (from, to) = (end(face), end(next));
            for share in between(self.cuts(from, to)) {
                look(from + (to - from) * share);
            }
        }
        for vertex in (0..other.vertices().len()).filter(|v| other.radius_of(*v) != 0.0) {
            let (first, sweep) = other.directions_of(vertex);
            let (centre, radius) = (other.vertices()[vertex], other.radius_of(vertex));
            let on = |angle: f64| {
                let (sin, cos) = sin_cos(angle);
                here(centre + first.rotated(cos, sin) * radius)
            };
            let (middle, start) = (here(centre), (on(0.0) - here(centre)) / radius);
            let share = |out: Vec2| {
                let angle = atan2(start.cross(out), start.dot(out)) / sweep;
                // A direction that the arc reaches the other way round.
                if angle < 0.0 { angle + TAU / sweep.abs() } else { angle }
            };
            let cuts = self.directions_of_cuts(middle, radius).into_iter().map(share);
            for share in between(cuts.collect()) {
                look(on(sweep * share));
            }
        }
        deepest
    }

    /// Least distance of a vertex or an outward arc of another shape, whose pose in this one's frame is `pose`, from this one, where they do not
    /// overlap [m]. An inward arc is nearest with one of its ends, or to a vertex of this one.
    fn missed_by(&self, other: &Self, pose: Pose) -> f64 {
        let (sin, cos) = sin_cos(pose.angle);
        let here = |p: Vec2| pose.centre + p.rotated(cos, sin);
        let mut least = f64::INFINITY;
        for vertex in 0..other.vertices().len() {
            let (centre, radius) = (other.vertices()[vertex], other.radius_of(vertex));
            if radius == 0.0 {
                least = least.min(-self.depth_of(here(centre)));
            } else if radius > 0.0 {
                // Of a circle only the arc counts, and only what lies before it.
                let behind = (1.0 - COINCIDENT_VERTICES) * radius;
                let faces = |depth: f64, way: Vec2| {
                    depth < -behind && other.normals_hold(vertex, way.rotated(cos, -sin))
                };
                least = least.min(-self.depth_by(here(centre), faces) - radius);
            }
            if radius != 0.0 && other.faces() > 0 {
                let ends = [other.face_before(vertex), vertex];
                let of_end = |face: usize| -self.depth_of(here(centre + other.face_normal(face) * radius));
                least = ends.into_iter().map(of_end).fold(least, f64::min);
            }
        }
        least
    }

    /// The unit directions, from the centre of a circle, in which it meets the outline's lines and circles; turned round for a negative radius.
    fn directions_of_cuts(&self, centre: Vec2, radius: f64) -> Vec<Vec2> {
        let mut out = vec![];
        // Directions whose share along `axis` has this cosine.
        let mut take = |axis: Vec2, cosine: f64| {
            if cosine.abs() <= 1.0 {
                let sine = (1.0 - cosine * cosine).sqrt();
                out.extend([axis.rotated(cosine, sine), axis.rotated(cosine, -sine)]);
            }
        };
        for face in 0..self.faces() {
            let normal = self.face_normal(face);
            let height = self.radius_of(face) - normal.dot(centre - self.vertices()[face]);
            take(normal, height / radius);
        }
        for vertex in 0..self.vertices().len() {
            let (to, own) = (self.vertices()[vertex] - centre, self.radius_of(vertex));
            let distance = to.norm();
            if distance > 0.0 {
                take(
                    to / distance,
                    (distance * distance + radius * radius - own * own) / (2.0 * distance * radius),
                );
            }
        }
        out
    }

    /// The outward normal at which an arc begins, and the angle by which it turns on from there [rad].
    fn directions_of(&self, vertex: usize) -> (Vec2, f64) {
        if self.faces() == 0 {
            return (Vec2::new(1.0, 0.0), TAU);
        }
        let (before, after) = (self.face_normal(self.face_before(vertex)), self.face_normal(vertex));
        let turn = atan2(before.cross(after), before.dot(after));
        let backwards = if self.is_hollow(vertex) { turn > 0.0 } else { turn < 0.0 };
        (before, if backwards { turn - TAU * turn.signum() } else { turn })
    }
}

/// Shares between which lie cuts, and their middles: of 0 to 1.
fn between(mut cuts: Vec<f64>) -> Vec<f64> {
    cuts.retain(|share| *share > 0.0 && *share < 1.0);
    cuts.extend([0.0, 1.0]);
    cuts.sort_by(f64::total_cmp);
    let middles: Vec<f64> = cuts.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
    cuts.extend(middles);
    cuts
}

impl World {
    /// Distance of a body in this state and an obstacle that do not overlap [m].
    ///
    /// # Example
    /// A ball of radius 0.1 m, its centre 0.3 m above the floor; and beyond the end of a floor that reaches to x = 4 m, at the corner of a triangle of 3,
    /// 4 and 5.
    /// ```
    /// use carom_impact::Law;
    /// use carom_motion::planar::{Obstacle, Pose, State, World, examples};
    /// use carom_num::Vec2;
    /// let (world, start) = examples::falling_ball();
    /// assert!((world.distance(0, &start, 0) - 0.2).abs() < 1e-15);
    /// let ground = Obstacle::new(Vec2::ZERO, Vec2::new(4.0, 0.0), 0.0, 0.0);
    /// let ends = World { obstacles: vec![ground], ..world };
    /// let beside = State { pose: Pose { centre: Vec2::new(4.3, 0.4), angle: 0.0 }, ..start };
    /// assert!((ends.distance(0, &beside, 0) - 0.4).abs() < 1e-15);
    /// ```
    pub fn distance(&self, body: usize, state: &State, obstacle: usize) -> f64 {
        let (body, obstacle) = (&self.bodies[body].shape, self.obstacles[obstacle].shape());
        let (out, back) = poses(state.pose);
        body.missed_by(obstacle, back).min(obstacle.missed_by(body, out)).max(0.0)
    }

    /// How deep a body in this state and an obstacle reach into each other [m]; negative where they are apart. It holds for outlines of any form, where
    /// [`World::clearance`] takes for granted that they did not overlap before.
    ///
    /// # Example
    /// A ball of radius 0.1 m, its centre 0.06 m above a floor without thickness.
    /// ```
    /// use carom_motion::planar::{Pose, State, examples};
    /// use carom_num::Vec2;
    /// let (world, start) = examples::falling_ball();
    /// let sunk = State { pose: Pose { centre: Vec2::new(0.0, 0.06), angle: 0.0 }, ..start };
    /// assert!((world.overlap(0, &sunk, 0) - 0.04).abs() < 1e-15);
    /// assert!(world.overlap(0, &start, 0) < 0.0);
    /// ```
    pub fn overlap(&self, body: usize, state: &State, obstacle: usize) -> f64 {
        let of = (&self.bodies[body].shape, self.obstacles[obstacle].shape());
        if of.0.is_hull() && of.1.is_hull() {
            // Some axis parts them, or tells how deep.
            return -self.clearance(body, state, obstacle);
        }
        let (body, obstacle) = of;
        let (out, back) = poses(state.pose);
        body.reached_by(obstacle, out).max(obstacle.reached_by(body, back))
    }
}

/// The pose of a body in the world, and that of the world as the body sees it.
fn poses(pose: Pose) -> (Pose, Pose) {
    let (sin, cos) = sin_cos(pose.angle);
    (pose, Pose { centre: -pose.centre.rotated(cos, -sin), angle: -pose.angle })
}
