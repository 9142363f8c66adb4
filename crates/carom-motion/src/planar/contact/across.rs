//! On which side of a segment a rod lies that has no thickness either: in line with it, it is on both at once. Memory decides, not rounding.

use super::World;
use super::kinematics::{Pairing, Turn};
use crate::planar::geometry::{Feature, Obstacle, State};
use carom_num::Vec2;

impl Obstacle {
    /// True where a point lies on the left of a segment's line, seen along its direction; of anything else true.
    ///
    /// # Example
    /// ```
    /// use carom_motion::planar::Obstacle;
    /// use carom_num::Vec2;
    /// let floor = Obstacle::new(Vec2::ZERO, Vec2::new(2.0, 0.0), 0.3, 0.5);
    /// assert!(floor.is_left_of(Vec2::new(3.0, 0.1)) && !floor.is_left_of(Vec2::new(1.0, -0.1)));
    /// ```
    pub fn is_left_of(&self, point: Vec2) -> bool {
        !self.is_segment() || self.off_to_left(point) > 0.0
    }

    /// How far a point lies to the left of a segment's line [m], negative to the right.
    pub(in crate::planar) fn off_to_left(&self, point: Vec2) -> f64 {
        self.direction().cross(point - self.from())
    }
}

impl World {
    /// The side of an obstacle on which a body is known to be, by a list of all sides: left of its direction or not.
    pub(in crate::planar) fn side(&self, sides: &[bool], (body, obstacle): (usize, usize)) -> Option<bool> {
        sides.get(self.place(body, obstacle)).copied()
    }

    /// The normal of a segment on the side on which a rod in line with it, up to `reach` \[m\], is known to be; `None` where the rod has left the line, or
    /// there is no such pair.
    pub(super) fn side_in_line(
        &self,
        (state, turn): (&State, Turn),
        (body, obstacle): (usize, usize),
        (left, reach): (bool, f64),
    ) -> Option<Vec2> {
        let rod = &self.bodies[body].shape;
        let o = self.obstacles.get(obstacle).filter(|o| o.is_segment() && rod.is_thin_rod())?;
        let normal = o.direction().turned_left();
        let (height, seen) = (o.off_to_left(state.pose.centre), turn.undo(normal));
        let off = |vertex: &Vec2| (height + seen.dot(*vertex)).abs();
        let in_line = rod.vertices().iter().all(|vertex| off(vertex) <= reach);
        in_line.then_some(if left { normal } else { -normal })
    }

    /// The side of a pair's segment that the pair touches it from, left or not; `None` where it meets anything else, or the pair does not tell.
    pub(in crate::planar) fn side_touched(&self, turn: Turn, pair: Pairing) -> Option<bool> {
        let o = self.obstacles.get(pair.obstacle).filter(|o| o.is_segment())?;
        match pair.feature {
            Feature::VertexOnFace { face, .. } => Some(face == Obstacle::LEFT),
            // At an end both sides meet: the one counts that the rod's own face looks at.
            Feature::FaceOnEnd { face, .. } => {
                let outward = turn.apply(self.body_of(pair).shape.face_normal(face));
                Some(o.normal(Obstacle::LEFT).dot(outward) < 0.0)
            }
            Feature::VertexOnEnd { .. } => None,
        }
    }
}
