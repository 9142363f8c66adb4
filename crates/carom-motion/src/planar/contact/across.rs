//! On which side of an obstacle without thickness a rod lies that has none either: in line with it, it is on both at once. Memory decides, not rounding.

use super::World;
use super::kinematics::{Pairing, Turn};
use crate::planar::geometry::{Behind, Feature, Obstacle, State};
use crate::tolerance::CLEAR_GAP;
use carom_num::Vec2;

/// Rods whose ends are this many times as far from a line as counts as touching are in line with it.
const IN_LINE: f64 = 4.0;

impl Obstacle {
    /// True for a face on the left of the direction from → to of what has no thickness.
    fn is_left(&self, face: usize) -> bool {
        face >= self.shape().faces() / 2
    }

    /// True where a point lies on the left of what has no thickness, by the nearest stretch of it; of anything else true.
    ///
    /// # Example
    /// A hook: its first stretch runs to the left, so that its left is below.
    /// ```
    /// use carom_motion::planar::{ChainPoint, Obstacle, Shape};
    /// use carom_num::Vec2;
    /// let at = |x, y| ChainPoint::straight(Vec2::new(x, y));
    /// let hook = Shape::of_open_chain(&[at(1.0, 1.0), at(-1.0, 1.0), at(-1.0, 0.0), at(3.0, 0.0)]).unwrap();
    /// let hook = Obstacle::of_shape(hook, 0.3, 0.0);
    /// assert!(hook.is_left_of(Vec2::new(0.0, 0.9)) && !hook.is_left_of(Vec2::new(0.0, 1.1)));
    /// ```
    pub fn is_left_of(&self, point: Vec2) -> bool {
        !self.is_thin() || self.off_to_left(point) > 0.0
    }

    /// How far a point lies to the left of the nearest stretch of what has no thickness [m], negative to the right; 0 where that cannot be told. Beyond
    /// its ends a straight stretch counts as going on.
    pub(in crate::planar) fn off_to_left(&self, point: Vec2) -> f64 {
        let shape = self.shape();
        let (first, count) = (shape.faces() / 2, shape.faces());
        let (mut nearest, mut off) = (f64::INFINITY, 0.0);
        let mut take = |distance: f64, to_left: f64| {
            if distance < nearest {
                (nearest, off) = (distance, to_left);
            }
        };
        shape.each_depth(point, |piece, depth, _| {
            let on_left = match piece {
                Behind::Face(face) => face >= first,
                Behind::Vertex(vertex) => vertex > first,
            };
            if on_left {
                take(depth.abs(), -depth);
            }
        });
        for (face, from_start) in [(first, true), (count - 1, false)] {
            let (normal, length, from) =
                (shape.face_normal(face), shape.face_length(face), point - shape.vertices()[face]);
            let along = normal.turned_left().dot(from);
            let beyond = if from_start { -along } else { along - length };
            if length > 0.0 && beyond > 0.0 {
                let to_left = normal.dot(from) - shape.radius_of(face);
                take(Vec2::new(beyond, to_left).norm(), to_left);
            }
        }
        off
    }
}

impl World {
    /// The side of an obstacle on which a body is known to be, by a list of all sides: left of its direction or not.
    pub(in crate::planar) fn side(&self, sides: &[bool], (body, obstacle): (usize, usize)) -> Option<bool> {
        sides.get(self.place(body, obstacle)).copied()
    }

    /// The normal of a segment on the side on which a rod in line with it is known to be; `None` where the rod has left the line, or there is no such pair.
    pub(super) fn side_in_line(
        &self,
        (state, turn): (&State, Turn),
        (body, obstacle): (usize, usize),
        left: bool,
    ) -> Option<Vec2> {
        let (o, rod) = (&self.obstacles[obstacle], &self.bodies[body].shape);
        if !(o.is_segment() && rod.is_thin_rod()) {
            return None;
        }
        let normal = o.direction().turned_left();
        let (height, seen) = (normal.dot(state.pose.centre - o.from()), turn.undo(normal));
        let off = |vertex: &Vec2| (height + seen.dot(*vertex)).abs();
        let in_line = rod.vertices().iter().all(|vertex| off(vertex) <= CLEAR_GAP * rod.size());
        in_line.then_some(if left { normal } else { -normal })
    }

    /// The side of a pair's obstacle that the pair touches it from, left or not; `None` where it has a thickness, or the pair does not tell.
    pub(in crate::planar) fn side_touched(&self, turn: Turn, pair: Pairing) -> Option<bool> {
        let o = self.obstacles.get(pair.obstacle).filter(|o| o.is_thin())?;
        let (met, to) = (o.shape(), o.shape().faces() / 2);
        match pair.feature {
            Feature::VertexOnFace { face, .. } => Some(o.is_left(face)),
            // At an end both sides meet: the one counts that the rod's own face looks at.
            Feature::FaceOnEnd { face, end } if end == 0 || end == to => {
                let left = if end == to { end } else { met.face_before(end) };
                let outward = turn.apply(self.body_of(pair).shape.face_normal(face));
                Some(met.face_normal(left).dot(outward) < 0.0)
            }
            Feature::VertexOnEnd { end, .. } if end == 0 || end == to => None,
            Feature::FaceOnEnd { end, .. } | Feature::VertexOnEnd { end, .. } => Some(end > to),
        }
    }

    /// True for a pair that touches from the other side than the one on which a rod is known to lie, at a place of a stretch with which the rod is in line up to `reach` [m].
    pub(in crate::planar) fn is_across(
        &self,
        (states, turns): (&[State], &[Turn]),
        pair: Pairing,
        left: Option<bool>,
        reach: f64,
    ) -> bool {
        let rod = &self.body_of(pair).shape;
        let (turn, centre) = (turns[pair.body], states[pair.body].pose.centre);
        let touched = if rod.is_thin_rod() { self.side_touched(turn, pair) } else { None };
        if touched.is_none() || left.is_none() || touched == left {
            return false;
        }
        let met = self.obstacles[pair.obstacle].shape();
        let at = |vertex: usize| centre + turn.apply(rod.vertices()[vertex]);
        let place = match pair.feature {
            Feature::VertexOnFace { vertex, .. } | Feature::VertexOnEnd { vertex, .. } => at(vertex),
            Feature::FaceOnEnd { face, end } => {
                met.vertices()[end] - turn.apply(rod.face_normal(face)) * met.radius_of(end)
            }
        };
        let slack = IN_LINE * reach;
        let mut stretches = (met.faces() / 2..met.faces()).filter(|face| met.face_length(*face) > 0.0);
        stretches.any(|face| {
            let (normal, from) = (met.face_normal(face), met.vertices()[face]);
            let off = |point: Vec2| (normal.dot(point - from) - met.radius_of(face)).abs();
            let along = normal.turned_left().dot(place - from);
            let in_line = (0..rod.vertices().len()).all(|vertex| off(at(vertex)) <= slack);
            in_line && along >= -slack && along <= met.face_length(face) + slack
        })
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use super::*;
    use crate::planar::{ChainPoint, Shape};

    /// A straight stretch to the right, an arc of a quarter turn upwards about (1, 1), and a straight stretch up; then to the left and down round a corner.
    fn bent() -> Obstacle {
        let quarter = 0.5 * std::f64::consts::PI;
        let there = [
            ChainPoint::straight(Vec2::new(0.0, 0.0)),
            ChainPoint { at: Vec2::new(1.0, 0.0), sweep: quarter },
            ChainPoint::straight(Vec2::new(2.0, 1.0)),
            ChainPoint::straight(Vec2::new(2.0, 2.0)),
            ChainPoint::straight(Vec2::new(1.0, 3.0)),
        ];
        Obstacle::of_shape(Shape::of_open_chain(&there).unwrap(), 0.3, 0.0)
    }

    #[test]
    fn sides_are_told_along_stretches_arcs_corners_and_beyond_ends() {
        let o = bent();
        assert!(o.is_thin());
        let off = |x: f64, y: f64| o.off_to_left(Vec2::new(x, y));
        let near =
            |found: f64, expected: f64| assert!((found - expected).abs() < 1e-14, "{found}, not {expected}");
        near(off(0.5, 0.25), 0.25);
        near(off(0.5, -0.25), -0.25);
        near(off(-1.0, -0.25), -0.25);
        // Inside and outside of the arc: 1 from its centre is on it.
        near(off(1.0 + 0.3, 1.0 - 0.4), 0.5);
        near(off(1.0 + 0.9, 1.0 - 1.2), -0.5);
        near(off(1.75, 1.5), 0.25);
        // Around the corner at (2, 2), which the left does not see.
        near(off(2.3, 2.1), -(0.3_f64 * 0.3 + 0.1 * 0.1).sqrt());
        near(off(1.3, 1.9), 0.8 * 0.5_f64.sqrt());
    }
}
