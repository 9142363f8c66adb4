//! What the events of a mode bring.

use super::collide::Closed;
use super::events::Event;
use super::kinematics::{Pairing, Turn};
use super::observer::Observer;
use super::question::Asked;
use super::terms::{Happening, MotionError};
use super::touching::Few;
use super::trace::{HeldContact, PieceEnd};
use super::walker::{STILL, Walker};
use super::watch::Watch;
use carom_impact::planar::Slip;

impl Walker<'_> {
    pub(super) fn piece_end(&self, event: &Event) -> PieceEnd {
        let held = |i: usize| {
            self.held.iter().nth(i).map(|h| HeldContact {
                obstacle: h.pair.obstacle,
                feature: h.pair.feature,
                slip: h.slip,
            })
        };
        let closes = |pair: Pairing| PieceEnd::Closes { obstacle: pair.obstacle, feature: pair.feature };
        match event {
            Event::Meets(pair) => closes(*pair),
            Event::Watched(w) => match w.what {
                Watch::Force(i) => held(i).map_or(PieceEnd::TimeUp, PieceEnd::ForceZero),
                Watch::Slip(i) => held(i).map_or(PieceEnd::TimeUp, PieceEnd::SlipZero),
                Watch::Cone(i, _) => held(i).map_or(PieceEnd::TimeUp, PieceEnd::StickLimit),
                Watch::Extent(i, _) => held(i).map_or(PieceEnd::TimeUp, PieceEnd::RunsOff),
                Watch::Parallel(i, _) => held(i).map_or(PieceEnd::TimeUp, |h| PieceEnd::Closes {
                    obstacle: h.obstacle,
                    feature: h.feature,
                }),
                Watch::Gap(pair) => closes(pair),
                Watch::Regular => held(0).map_or(PieceEnd::TimeUp, PieceEnd::PainleveEdge),
            },
        }
    }

    /// What an event brings.
    pub(super) fn resolve<O: Observer>(
        &mut self,
        event: &Event,
        observer: &mut O,
    ) -> Result<Happening, MotionError> {
        let mut asked = self.asked();
        let watched = match event {
            Event::Meets(pair) => {
                return self.collide_here(&Closed { named: Some(*pair), ..Closed::default() }, observer);
            }
            Event::Watched(w) => w,
        };
        let nth = |asked: &Few<Asked>, i: usize| asked.iter().nth(i).map(|a| a.pair);
        match watched.what {
            Watch::Force(i) => {
                if let Some(pair) = nth(&asked, i) {
                    asked.retain(|a| a.pair != pair);
                    self.depart(pair);
                }
                self.settle(&asked, observer)
            }
            Watch::Slip(i) => {
                for (j, a) in asked.iter_mut().enumerate() {
                    if i == j || a.slip.abs() <= 10.0 * STILL * self.scales.speed {
                        a.slip = 0.0;
                    }
                }
                self.settle(&asked, observer)
            }
            Watch::Cone(i, forward) => {
                if let Some(a) = asked.iter_mut().nth(i) {
                    // Friction along +t is used up: the contact slips along −t.
                    a.known = Some(if forward { Slip::Backward } else { Slip::Forward });
                }
                self.settle(&asked, observer)
            }
            Watch::Extent(i, _) => self.hand_over(nth(&asked, i), observer),
            Watch::Parallel(i, slot) => {
                let turn = Turn::of(&self.state);
                let sine = nth(&asked, i).map_or(0.0, |pair| self.world.parallel(turn, pair, slot));
                self.collide_here(&Closed { sine: sine.abs(), ..Closed::default() }, observer)
            }
            Watch::Gap(pair) => {
                self.collide_here(&Closed { named: Some(pair), ..Closed::default() }, observer)
            }
            Watch::Regular => self.force(&asked, observer),
        }
    }
}
