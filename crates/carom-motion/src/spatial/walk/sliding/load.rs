//! What each carrier of a body on several planes takes of its load.

use super::moment::Moment;
use super::{Sliding, Vector};
use crate::spatial::modes::capacity::{balanced, left_of};
use crate::spatial::modes::grip::Bearing;
use crate::tolerance::WEIGHTLESS;

impl Sliding<'_> {
    /// Marks the carriers that carry nothing where the stretch starts.
    pub(super) fn note_idle(&mut self, first: &Vector) {
        // On one plane a body that rolls on an edge holds along it with both ends.
        if !self.apart && self.carriers.iter().filter(|c| c.sticks).count() < 2 {
            return;
        }
        let now = self.moment(first);
        let Some(reactions) = self.reactions(&now) else { return };
        let nothing = WEIGHTLESS * self.body.mass() * self.gravity.norm();
        for (c, normal) in self.carriers.iter_mut().zip(reactions.normals) {
            c.spare = if normal.abs() <= nothing { nothing } else { 0.0 };
        }
        self.redundant = !balanced(&self.loaded(&now)).is_empty();
    }

    /// The carriers that carry something.
    fn loaded(&self, now: &Moment) -> Vec<Bearing> {
        let all = self.carriers.iter().zip(&now.bearings);
        all.filter(|(c, _)| c.spare == 0.0).map(|(_, b)| *b).collect()
    }

    /// What is left of the cones of those that stick, where those that slip do not pull.
    pub(super) fn left(&self, now: &Moment) -> f64 {
        left_of(self.body, &self.loaded(now))
    }
}
