//! What the events of a mode bring.

use super::collide::Closed;
use super::events::Event;
use super::terms::Happening;
use super::walker::Walker;
use crate::MotionError;
use crate::planar::contact::{
    kinematics::Pairing,
    touching::{Few, Search},
};
use crate::planar::modes::{mode::Forces, question::Asked, watch::Watch};
use crate::planar::record::{
    observer::Observers,
    trace::{HeldContact, PieceEnd},
};
use crate::tolerance::{STILL_SPEED, TOUCHING_GAP};
use carom_impact::planar::Slip;

impl<const B: usize> Walker<'_, B> {
    /// Why a piece ends, as one of the bodies sees it.
    pub(super) fn piece_end(&self, event: &Event, body: usize) -> PieceEnd {
        let held = |i: usize, end: fn(HeldContact) -> PieceEnd| {
            let contact = self.held.get(i).and_then(|h| {
                let (obstacle, feature) = self.seen_by(body, h.pair)?;
                Some(HeldContact { obstacle, feature, slip: h.slip })
            });
            contact.map_or(PieceEnd::Elsewhere, end)
        };
        let closes = |pair: Pairing| {
            let seen = self.seen_by(body, pair);
            seen.map_or(PieceEnd::Elsewhere, |(obstacle, feature)| PieceEnd::Closes { obstacle, feature })
        };
        match event {
            Event::Meets(pair) => closes(*pair),
            Event::Watched(w) => match w.what {
                Watch::Force(i) => held(i, PieceEnd::ForceZero),
                // This watch says that the mode ends, not through which contact: its forces are open, and the scarcest one gives way.
                Watch::Holds => match self.scarcest() {
                    Some((i, true)) => held(i, PieceEnd::StickLimit),
                    Some((i, false)) => held(i, PieceEnd::ForceZero),
                    None => PieceEnd::Elsewhere,
                },
                Watch::Slip(i) => held(i, PieceEnd::SlipZero),
                Watch::Cone(i, _) => held(i, PieceEnd::StickLimit),
                Watch::Extent(i, _) => held(i, PieceEnd::RunsOff),
                Watch::Parallel(i, _) => {
                    held(i, |h| PieceEnd::Closes { obstacle: h.obstacle, feature: h.feature })
                }
                Watch::Gap(pair) => closes(pair),
                Watch::Regular => held(0, PieceEnd::PainleveEdge),
            },
        }
    }

    /// The contact that is nearest to giving way here, and whether it would slide.
    fn scarcest(&self) -> Option<(usize, bool)> {
        let turns = self.turns();
        let mut forces = Forces::default();
        self.world.forces_into(&self.held, &self.states, &turns, &mut forces);
        let snapshot = self.snapshot(self.time, (&self.states, &turns), Some(&forces));
        snapshot.scarcest().map(|s| (s.contact, s.slides))
    }

    /// What an event brings.
    pub(super) fn resolve(
        &mut self,
        event: &Event,
        observers: &mut Observers<'_, B>,
    ) -> Result<Happening, MotionError> {
        let mut asked = self.asked();
        let watched = match event {
            Event::Meets(pair) => {
                return self.collide_here(&Closed { named: Some(*pair), ..Closed::default() }, observers);
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
                self.settle(&asked, observers)
            }
            Watch::Holds => self.settle(&asked, observers),
            Watch::Slip(i) => {
                for (j, a) in asked.iter_mut().enumerate() {
                    if i == j && self.world.surface(a.pair).friction == 0.0 {
                        // Without friction nothing but the event tells which way it goes on where its rate is rounding.
                        a.present = if a.present == Slip::Forward { Slip::Backward } else { Slip::Forward };
                    }
                    if i == j || a.slip.abs() <= 10.0 * STILL_SPEED * self.scales.speed {
                        a.slip = 0.0;
                    }
                }
                self.settle(&asked, observers)
            }
            Watch::Cone(i, forward) => {
                if let Some(a) = asked.iter_mut().nth(i) {
                    // Friction along +t is used up: the contact slips along −t.
                    a.known = Some(if forward { Slip::Backward } else { Slip::Forward });
                }
                self.settle(&asked, observers)
            }
            Watch::Extent(i, _) => self.hand_over(nth(&asked, i), observers),
            Watch::Parallel(i, slot) => {
                let turns = self.turns();
                let sine = nth(&asked, i).map_or(0.0, |pair| self.world.parallel(&turns, pair, slot));
                self.collide_here(&Closed { sine: sine.abs(), ..Closed::default() }, observers)
            }
            Watch::Gap(pair) => {
                self.collide_here(&Closed { named: Some(pair), ..Closed::default() }, observers)
            }
            Watch::Regular => self.force(&asked, observers),
        }
    }

    /// A contact ran off its features: the neighbouring pair takes over where it goes on smoothly, meets, or lets go.
    pub(super) fn hand_over(
        &mut self,
        ran_off: Option<Pairing>,
        observers: &mut Observers<'_, B>,
    ) -> Result<Happening, MotionError> {
        let Some(ran_off) = ran_off else { return self.collide_here(&Closed::default(), observers) };
        let reach = TOUCHING_GAP * self.scales.length;
        let search = Search {
            reach,
            deepest: reach,
            sides: &self.sides,
            still: STILL_SPEED * self.scales.speed,
            except: Some(ran_off),
        };
        let found = self.world.touching((&self.states, &self.turns()), &search);
        self.held.retain(|h| h.pair != ran_off);
        let mut pairs: Few<Pairing> = Few::default();
        for pair in self.held_pairs().map(|h| h.pair) {
            pairs.push(pair);
        }
        pairs.note_overflow(found.overflows());
        for pair in found.iter().copied() {
            if !pairs.iter().any(|p| self.coincide(*p, pair)) {
                pairs.push(pair);
            }
        }
        // Nothing has taken over: what is nearest there now opens, and is watched on its own until it is clearly away.
        if !pairs.iter().any(|p| p.meeting() == ran_off.meeting())
            && let left = self.world.side(&self.sides, ran_off.meeting())
            && let Some(pair) = self.world.nearest(&self.states, ran_off.meeting(), left)
            && !self.runs_off(pair)
        {
            self.depart(pair);
        }
        self.collide(&pairs, observers)
    }

    /// True where a pair at the end of its features' extents leaves them: it is no contact any more, whatever its gap does.
    pub(super) fn runs_off(&self, pair: Pairing) -> bool {
        let (reach, still) = (TOUCHING_GAP * self.scales.length, STILL_SPEED * self.scales.speed);
        let extents = self.world.extents(&self.states, &self.turns(), pair);
        extents.iter().enumerate().any(|(slot, extent)| {
            extent
                .is_some_and(|(room, rate)| room <= reach && rate < -still && !self.world.goes_on(pair, slot))
        })
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use super::*;
    use crate::planar::{
        contact::World,
        geometry::{Body, Feature, Obstacle, Pose, Shape, State, Twist},
        walk::Options,
    };
    use carom_impact::Law;
    use carom_num::Vec2;

    /// Whether the corner of a block that stands exactly at a floor's end leaves it, when the block moves at this speed \[m/s\] outwards.
    fn runs_off(outwards: f64) -> bool {
        let corners = [(-0.1, -0.1), (0.1, -0.1), (0.1, 0.1), (-0.1, 0.1)].map(|(x, y)| Vec2::new(x, y));
        let shape = Shape::new(corners.to_vec(), 0.0).unwrap();
        let block = Body { shape, mass: 1.0, inertia: 0.01 };
        let floor = Obstacle::new(Vec2::new(-1.0, 0.0), Vec2::ZERO, 0.3, 0.5);
        let world = World::of_one(Vec2::new(0.0, -10.0), block, vec![floor], Law::Poisson);
        let start = State {
            pose: Pose { centre: Vec2::new(-0.1, 0.1), angle: 0.0 },
            twist: Twist { velocity: Vec2::new(outwards, 0.0), spin: 0.0 },
        };
        let walker = Walker::new(&world, start, vec![], Options::default()).unwrap();
        let feature = Feature::VertexOnFace { vertex: 1, face: Obstacle::LEFT };
        walker.runs_off(Pairing { body: 0, obstacle: 0, feature })
    }

    #[test]
    fn a_corner_at_an_end_runs_off_only_where_it_moves_outwards() {
        assert_eq!([-1.0, 0.0, 1.0].map(runs_off), [false, false, true], "inwards, at rest, outwards");
    }
}
