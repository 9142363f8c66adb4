//! Motion to and fro that nothing takes energy from and nothing ends.

use super::events::Event;
use super::walker::Walker;
use crate::planar::geometry::{State, Twist};
use crate::planar::modes::{mode::Held, watch::Watch};
use crate::tolerance::STILL_SPEED;
use carom_impact::planar::Slip;

/// Turning points after which a body has been wherever its swing leads: as it loses no energy, it does the same for ever.
const TURNING_POINTS: u32 = 2;

/// What is seen of a piece of motion that can only go forth and back on one path.
pub(super) struct Swing {
    /// The body only slides: it turns round where a slip stops, which is an event of its own.
    slides: bool,
    /// Nothing turns the body: its spin stays what it is, and says nothing.
    spins_freely: bool,
    last: Twist,
}

impl Swing {
    /// True where a body that rolls has turned round since it was last seen: in its spin, and on a bent plate in its velocity.
    fn turned(&mut self, twist: Twist) -> bool {
        let was = self.last;
        if twist != Twist::default() {
            self.last = twist;
        }
        !self.slides && was.velocity.dot(twist.velocity) < 0.0 && was.spin * twist.spin <= 0.0
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
        // A disc that only slides, without friction, is pushed through its centre.
        let slides = self.held.iter().all(|h| h.slip != Slip::Sticks);
        let spins_freely = slides && self.world.bodies[0].shape.is_disc();
        let one_path = constraints >= if spins_freely { 1 } else { 2 } && self.held.iter().all(lossless);
        one_path.then(|| Swing { slides, spins_freely, last: self.states[0].twist })
    }

    /// True where the body has come back after this step: it has turned round at both ends of its path, and no other event was on the way.
    pub(super) fn comes_back(&mut self, swing: Option<&mut Swing>, state: &State) -> bool {
        self.turning_points += u32::from(swing.is_some_and(|swing| swing.turned(state.twist)));
        self.turning_points >= TURNING_POINTS
    }

    /// The same at an event: a slip without friction that stops, and with it the body, is a turning point. Any other event begins anew.
    pub(super) fn comes_back_at(&mut self, event: &Event) -> bool {
        let slip_stops = matches!(event, Event::Watched(watched) if matches!(watched.what, Watch::Slip(_)));
        let Twist { velocity, spin } = self.states[0].twist;
        let still = |v: f64| v.abs() <= STILL_SPEED * self.scales.speed;
        let stops = |swing: Swing| {
            swing.slides && still(velocity.norm()) && (swing.spins_freely || still(spin * self.scales.length))
        };
        let turns = slip_stops && self.swing().is_some_and(stops);
        self.turning_points = if turns { self.turning_points + 1 } else { 0 };
        self.turning_points >= TURNING_POINTS
    }
}
