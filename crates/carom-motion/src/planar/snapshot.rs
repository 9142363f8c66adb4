//! Values of the event functions in one state of a mode.

use super::kinematics::Turn;
use super::mode::{Forces, Held, Loaded};
use super::touching::Few;
use super::watch::{Watch, Watched};
use super::world::Scales;
use super::{State, World};
use crate::evaluated::{Quantity, evaluated};
use crate::tolerance::OPEN_FORCES_ROUNDING;
use carom_impact::planar::Slip;

/// A contact that is about to give way, and the room that is left, in units of the weight.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scarcest {
    room: f64,
    pub(super) contact: usize,
    /// It would slide, not open.
    pub(super) slides: bool,
}

/// A state of a mode with what all its event functions need.
pub(super) struct Snapshot<'a, const B: usize> {
    pub(super) world: &'a World,
    pub(super) scales: &'a Scales,
    pub(super) held: &'a Few<Held>,
    pub(super) time: f64,
    pub(super) states: &'a [State; B],
    pub(super) turns: &'a [Turn; B],
    /// Those here, where they are known: event functions that ask for none ([`Watch::asks_forces`]) do without.
    pub(super) forces: Option<&'a Forces<B>>,
    /// The world's unit of force [N].
    pub(super) weight: f64,
}

impl Watch {
    /// True where its value is one of the forces, not of the pose and the velocities alone.
    pub(super) fn asks_forces(&self) -> bool {
        matches!(self, Self::Force(_) | Self::Holds | Self::Cone(..) | Self::Regular)
    }
}

impl<const B: usize> Snapshot<'_, B> {
    /// Value of one event function, in the world's own units.
    pub(super) fn value(&self, w: &Watched) -> f64 {
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
    pub(super) fn scarcest(&self) -> Option<Scarcest> {
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
