//! On which side of each segment a body is: a rod without thickness in line with it is on both.

use super::walker::Walker;
use crate::planar::contact::kinematics::Turn;
use crate::planar::geometry::{Obstacle, Shape, State};
use crate::tolerance::OFF_THE_LINE;
use carom_num::Vec2;

/// The point of a body by which it is told on which side of a segment it is. Of a rod without thickness it is the middle of what lies beside the segment:
/// beyond an end the rod may reach to the other side of the line.
fn beside(shape: &Shape, (state, turn): (&State, Turn), segment: &Obstacle) -> Vec2 {
    let centre = state.pose.centre;
    if !shape.is_thin_rod() {
        return centre;
    }
    let [rear, front] = [0, 1].map(|vertex| centre + turn.apply(shape.vertices()[vertex]));
    let along = |point: Vec2| segment.direction().dot(point - segment.from());
    let (from, until) = (along(rear), along(front));
    let clamped = |at: f64| at.clamp(0.0, segment.length());
    let (first, last) = (clamped(from), clamped(until));
    if first == last {
        return centre;
    }
    let middle = (0.5 * (first + last) - from) / (until - from);
    rear + (front - rear) * middle
}

impl<const B: usize> Walker<'_, B> {
    /// Remembers on which side of each segment every body is, where that can be told.
    pub(in crate::planar) fn note_sides(&mut self) {
        let turns = self.turns();
        for (body, obstacle) in self.world.each_meeting() {
            let Some(o) = self.world.obstacles.get(obstacle).filter(|o| o.is_segment()) else { continue };
            let posed = (&self.states[body], turns[body]);
            let off = o.off_to_left(beside(&self.world.bodies[body].shape, posed, o));
            if off.abs() > OFF_THE_LINE * self.scales.length {
                self.sides[self.world.place(body, obstacle)] = off > 0.0;
            }
        }
        // Where a rod touches from is known better than any distance.
        for h in self.held.iter() {
            if let Some(left) = self.world.side_touched(turns[h.pair.body], h.pair) {
                self.sides[self.world.place(h.pair.body, h.pair.obstacle)] = left;
            }
        }
    }
}
