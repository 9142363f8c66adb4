//! On which side of each obstacle a body is: a rod in line with it is on both.

use super::walker::Walker;
use crate::planar::contact::kinematics::{Pairing, Turn};
use crate::planar::geometry::{Feature, Obstacle};
use crate::tolerance::OFF_THE_LINE;

impl<const B: usize> Walker<'_, B> {
    /// Remembers on which side of each obstacle every body is, where that can be told.
    pub(in crate::planar) fn note_sides(&mut self) {
        let turns = self.turns();
        for (body, obstacle) in self.world.each_meeting() {
            let Some(o) = self.world.obstacles.get(obstacle) else { continue };
            let off = o.direction().turned_left().dot(self.states[body].pose.centre - o.from());
            if off.abs() > OFF_THE_LINE * self.scales.length {
                self.sides[self.world.place(body, obstacle)] = off > 0.0;
            }
        }
        for h in self.held.iter() {
            if let Some(left) = self.side_of_contact(&turns, h.pair) {
                self.sides[self.world.place(h.pair.body, h.pair.obstacle)] = left;
            }
        }
    }

    /// The side of an obstacle that a pair's body is on, as the pair tells it.
    fn side_of_contact(&self, turns: &[Turn; B], pair: Pairing) -> Option<bool> {
        let along = self.world.obstacles.get(pair.obstacle)?.direction();
        match pair.feature {
            Feature::VertexOnFace { face, .. } => Some(face == Obstacle::LEFT),
            // The part of a rod that turns towards the obstacle counts, not its centre beyond the end.
            Feature::FaceOnEnd { face, .. } => {
                let outward = turns[pair.body].apply(self.world.body_of(pair).shape.face_normal(face));
                Some(along.turned_left().dot(outward) < 0.0)
            }
            Feature::VertexOnEnd { .. } => None,
        }
    }
}
