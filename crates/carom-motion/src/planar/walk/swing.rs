//! Motion to and fro that nothing takes energy from and nothing ends.

use super::walker::Walker;
use crate::planar::geometry::{State, Twist};
use crate::planar::modes::mode::Held;
use carom_impact::planar::Slip;

/// Turning points after which a body has been wherever its swing leads.
const TURNING_POINTS: u32 = 2;

/// What is seen of a piece of motion that can only go forth and back on one path.
pub(super) struct Swing {
    last: Twist,
    turning_points: u32,
}

impl Swing {
    /// True where the body has come back: it has turned round at both ends of its path, and no event was on the way. As it
    /// loses no energy, it does the same for ever.
    pub(super) fn comes_back(&mut self, state: &State) -> bool {
        let (was, is) = (self.last, state.twist);
        // A body that rolls turns round in its spin, one that slides on a bent plate in its velocity.
        let turns = was.velocity.dot(is.velocity) < 0.0 && was.spin * is.spin <= 0.0;
        self.turning_points += u32::from(turns);
        if is != Twist::default() {
            self.last = is;
        }
        self.turning_points >= TURNING_POINTS
    }
}

impl<const B: usize> Walker<'_, B> {
    /// What to see of the present piece, where a swing is to end the walk and the present mode leaves one path to a lone body, without loss.
    pub(super) fn swing(&self) -> Option<Swing> {
        if B > 1 || !self.ends_at_swings {
            return None;
        }
        let lossless = |h: &Held| h.slip == Slip::Sticks || self.world.surface(h.pair).friction == 0.0;
        let constraints: u32 = self.held.iter().map(|h| if h.slip == Slip::Sticks { 2 } else { 1 }).sum();
        let one_path = constraints >= 2 && self.held.iter().all(lossless);
        one_path.then(|| Swing { last: self.states[0].twist, turning_points: 0 })
    }
}
