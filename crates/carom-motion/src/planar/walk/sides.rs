//! On which side of each segment a body is: a rod without thickness in line with it is on both.

use super::walker::Walker;
use crate::tolerance::OFF_THE_LINE;

impl<const B: usize> Walker<'_, B> {
    /// Remembers on which side of each segment every body is, where that can be told.
    pub(in crate::planar) fn note_sides(&mut self) {
        let turns = self.turns();
        for (body, obstacle) in self.world.each_meeting() {
            let Some(o) = self.world.obstacles.get(obstacle).filter(|o| o.is_segment()) else { continue };
            let off = o.off_to_left(self.states[body].pose.centre);
            if off.abs() > OFF_THE_LINE * self.scales.length {
                self.sides[self.world.place(body, obstacle)] = off > 0.0;
            }
        }
        // The part of a rod that touches counts, not its centre beyond an end.
        for h in self.held.iter() {
            if let Some(left) = self.world.side_touched(turns[h.pair.body], h.pair) {
                self.sides[self.world.place(h.pair.body, h.pair.obstacle)] = left;
            }
        }
    }
}
