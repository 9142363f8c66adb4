//! Motion to and fro that nothing takes energy from and nothing ends.

use super::events::Event;
use super::walker::Walker;
use crate::planar::geometry::Twist;
use crate::planar::modes::{mode::Held, watch::Watch};
use crate::tolerance::STILL_SPEED;
use carom_impact::planar::Slip;

/// Turning points after which a body has been wherever its swing leads: as it loses no energy, it does the same for ever.
const TURNING_POINTS: u32 = 2;

/// What is seen of a piece of motion that can only go forth and back on one path.
#[derive(Clone, Copy)]
pub(super) enum Swing {
    /// It rolls: seen by how it moved last.
    Rolls(Twist),
    /// A disc that slides, pushed through its centre: it spins on, and is seen by the speed of its centre along what it slides on [m/s].
    SpinsOn(f64),
    /// Anything else that only slides: it turns round where its slip stops, which is an event.
    Slides,
}

impl<const B: usize> Walker<'_, B> {
    /// What to see of the present piece, where a swing is to end the walk and the present mode leaves one path to a lone body, without loss.
    pub(super) fn swing(&self) -> Option<Swing> {
        if B > 1 || !self.ends_at_swings {
            return None;
        }
        let lossless = |h: &Held| h.slip == Slip::Sticks || self.world.surface(h.pair).friction == 0.0;
        if self.held.is_empty() || !self.held.iter().all(lossless) {
            return None;
        }
        let constraints: u32 = self.held.iter().map(|h| if h.slip == Slip::Sticks { 2 } else { 1 }).sum();
        if self.held.iter().any(|h| h.slip == Slip::Sticks) {
            Some(Swing::Rolls(self.states[0].twist))
        } else if self.world.bodies[0].shape.is_disc() {
            Some(Swing::SpinsOn(self.speed_along().unwrap_or_default()))
        } else {
            (constraints >= 2).then_some(Swing::Slides)
        }
    }

    /// The speed of the centre along what the first contact slides on [m/s], unless it is rounding.
    fn speed_along(&self) -> Option<f64> {
        let pair = self.held.get(0)?.pair;
        let speed = self.kinematics(pair).normal.turned_right().dot(self.states[0].twist.velocity);
        (!self.is_still(speed)).then_some(speed)
    }

    fn is_still(&self, speed: f64) -> bool {
        speed.abs() <= STILL_SPEED * self.scales.speed
    }

    /// True where the body has come back after this step: it has turned round at both ends of its path, and no other event was on the way.
    pub(super) fn comes_back(&mut self, swing: Option<&mut Swing>) -> bool {
        let turned = match swing {
            Some(Swing::Rolls(last)) => {
                let (was, is) = (*last, self.states[0].twist);
                if is != Twist::default() {
                    *last = is;
                }
                // In its spin, and on a bent plate in its velocity.
                was.velocity.dot(is.velocity) < 0.0 && was.spin * is.spin <= 0.0
            }
            Some(Swing::SpinsOn(last)) => self.speed_along().is_some_and(|is| {
                let was = std::mem::replace(last, is);
                was * is < 0.0
            }),
            Some(Swing::Slides) | None => false,
        };
        self.turning_points += u32::from(turned);
        self.turning_points >= TURNING_POINTS
    }

    /// The same at an event: a slip without friction that stops, and with it the body, is a turning point. Any other event begins anew, but the slip of a
    /// disc that spins.
    pub(super) fn comes_back_at(&mut self, event: &Event) -> bool {
        let slip_stops = matches!(event, Event::Watched(watched) if matches!(watched.what, Watch::Slip(_)));
        let Twist { velocity, spin } = self.states[0].twist;
        let stops = self.is_still(velocity.norm());
        self.turning_points = match slip_stops.then(|| self.swing()).flatten() {
            Some(Swing::SpinsOn(_)) => self.turning_points + u32::from(stops),
            Some(Swing::Slides) if stops && self.is_still(spin * self.scales.length) => {
                self.turning_points + 1
            }
            _ => 0,
        };
        self.turning_points >= TURNING_POINTS
    }
}
