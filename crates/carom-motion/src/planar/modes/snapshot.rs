//! Values of the event functions in one state of a mode.

use super::mode::{Forces, Held, Loaded};
use super::watch::{Watch, Watched};
use crate::evaluated::{Quantity, evaluated};
use crate::planar::contact::{World, kinematics::Turn, touching::Few, world::Scales};
use crate::planar::geometry::State;
use crate::tolerance::OPEN_FORCES_ROUNDING;
use carom_impact::planar::Slip;

/// A contact that is about to give way, and the room that is left, in units of the weight.
#[derive(Clone, Copy, Debug)]
pub(in crate::planar) struct Scarcest {
    room: f64,
    pub(in crate::planar) contact: usize,
    /// It would slide, not open.
    pub(in crate::planar) slides: bool,
}

/// A state of a mode with what all its event functions need.
pub(in crate::planar) struct Snapshot<'a, const B: usize> {
    pub(in crate::planar) world: &'a World,
    pub(in crate::planar) scales: &'a Scales,
    pub(in crate::planar) held: &'a Few<Held>,
    pub(in crate::planar) time: f64,
    pub(in crate::planar) states: &'a [State; B],
    pub(in crate::planar) turns: &'a [Turn; B],
    /// Those here, where they are known: event functions that ask for none ([`Watch::asks_forces`]) do without.
    pub(in crate::planar) forces: Option<&'a Forces<B>>,
    /// The world's unit of force [N].
    pub(in crate::planar) weight: f64,
}

impl Watch {
    /// True where its value is one of the forces, not of the pose and the velocities alone.
    pub(in crate::planar) fn asks_forces(&self) -> bool {
        matches!(self, Self::Force(_) | Self::Holds | Self::Cone(..) | Self::Regular)
    }
}

impl<const B: usize> Snapshot<'_, B> {
    /// Value of one event function, in the world's own units.
    pub(in crate::planar) fn value(&self, w: &Watched) -> f64 {
        let value = evaluated(Quantity::Event, self.plain(&w.what).unwrap_or(1.0));
        match w.leaving {
            // 0/0: whoever looks at the very start must know that nothing is known there.
            Some(l) if self.time <= l.since => f64::NAN,
            Some(l) => (value - l.offset) / ((self.time - l.since) / self.scales.time).powi(l.order),
            None => value + w.slack,
        }
    }

    fn room_in_cone(&self, c: &Loaded, forward: bool) -> f64 {
        let room = self.world.surface(c.held.pair).friction * c.normal_force;
        (room + if forward { -c.tangential_force } else { c.tangential_force }) / self.weight
    }

    /// The contact that is nearest to giving way.
    pub(in crate::planar) fn scarcest(&self) -> Option<Scarcest> {
        let mut least: Option<Scarcest> = None;
        let mut take = |room: f64, contact: usize, slides: bool| {
            if least.is_none_or(|l| room < l.room) {
                least = Some(Scarcest { room, contact, slides });
            }
        };
        for (i, c) in self.forces?.contacts.iter().enumerate() {
            take(c.normal_force / self.weight, i, false);
            if c.held.slip == Slip::Sticks {
                take(self.room_in_cone(c, true).min(self.room_in_cone(c, false)), i, true);
            }
        }
        least
    }

    #[inline]
    fn plain(&self, what: &Watch) -> Option<f64> {
        let contact = |i: usize| self.forces?.contacts.get(i);
        let pair = |i: usize| self.held.get(i).map(|h| h.pair);
        Some(match *what {
            Watch::Force(i) => contact(i)?.normal_force / self.weight,
            Watch::Holds => self.scarcest()?.room + OPEN_FORCES_ROUNDING,
            Watch::Slip(i) => {
                let h = self.held.get(i)?;
                let here = || self.world.kinematics_turned(self.states, self.turns, h.pair).slip;
                let u = contact(i).map_or_else(here, |c| c.kinematics.slip) / self.scales.speed;
                if h.slip == Slip::Backward { -u } else { u }
            }
            Watch::Cone(i, forward) => self.room_in_cone(contact(i)?, forward),
            Watch::Extent(i, slot) => {
                let pair = pair(i)?;
                let known = contact(i)
                    .and_then(|c| self.world.room_of(&self.states[pair.body], pair, &c.kinematics, slot));
                let room = known.or_else(|| self.world.room(self.states, self.turns, pair, slot));
                room? / self.scales.length
            }
            Watch::Parallel(i, slot) => self.world.parallel(self.turns, pair(i)?, slot),
            Watch::Gap(pair) => self.world.gap(self.states, self.turns, pair) / self.scales.length,
            Watch::Regular => self.forces?.regularity,
        })
    }
}
