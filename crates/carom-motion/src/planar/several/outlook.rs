//! What a body in free flight meets next.

use crate::planar::geometry::State;
use crate::planar::walk::walker::Walker;

/// What a body meets next, if nothing but gravity acts on it until then.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outlook {
    /// It flies, and meets no obstacle any more.
    Clear,
    /// It flies, and meets an obstacle in this state.
    Meets {
        /// The obstacle.
        obstacle: usize,
        /// Pose and velocity just before.
        state: State,
    },
    /// It holds a contact, or moves together with other bodies.
    Bound,
}

impl Walker<'_, 1> {
    /// What the body meets next; it does not move.
    ///
    /// # Example
    /// A ball that falls from 0.2 m above the floor meets it at 2 m/s.
    /// ```
    /// use carom_motion::planar::{Options, Outlook, Walker, examples};
    /// let (world, start) = examples::falling_ball();
    /// let walker = Walker::new(&world, start, vec![], Options::default())?;
    /// let Outlook::Meets { obstacle: 0, state } = walker.outlook() else { panic!("it falls on the floor") };
    /// assert!((state.twist.velocity.y + 2.0).abs() < 1e-12);
    /// # Ok::<(), carom_motion::MotionError>(())
    /// ```
    pub fn outlook(&self) -> Outlook {
        if self.held_of(0).next().is_some() {
            return Outlook::Bound;
        }
        let start = &self.states[0];
        match self.world.first_touch(start, &self.known(), self.world.leaves_after(start)) {
            None => Outlook::Clear,
            Some(touch) => Outlook::Meets {
                obstacle: touch.pair.obstacle,
                state: start.flown(self.world.gravity, touch.time),
            },
        }
    }
}
