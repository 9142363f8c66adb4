//! The event functions of a mode: positive while the mode holds.

use super::kinematics::{Pairing, Turn};
use super::mode::{Forces, Held};
use super::touching::Few;
use super::world::Scales;
use super::{Feature, State, World};
use carom_impact::planar::Slip;

/// Most event functions of one mode.
pub(super) const MOST_WATCHED: usize = 48;

/// What an event function watches. The number is that of the held contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Watch {
    /// Normal force.
    Force(usize),
    /// Slip in its present direction.
    Slip(usize),
    /// Room in the friction cone against a force along +t (true) or −t.
    Cone(usize, bool),
    /// Distance inside one end of the features' extent.
    Extent(usize, usize),
    /// Sine of the angle between a face of the body and the obstacle: zero where they become parallel.
    Parallel(usize, usize),
    /// Gap of a pair that has just opened.
    Gap(Pairing),
    /// The mode's equations.
    Regular,
}

/// An event function, divided by a power of the time since it left zero where it has just done so.
#[derive(Clone, Copy, Debug)]
pub(super) struct Watched {
    pub(super) what: Watch,
    pub(super) leaving: Option<Leaving>,
}

/// A quantity that has just left zero: since when, and the order of its first derivative that is not zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Leaving {
    pub(super) since: f64,
    pub(super) order: i32,
}

/// A pair that has just opened.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Departing {
    pub(super) pair: Pairing,
    pub(super) leaving: Leaving,
}

/// A contact that has just started to slip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Starting {
    pub(super) pair: Pairing,
    pub(super) leaving: Leaving,
}

/// The list of a mode's event functions.
pub(super) struct WatchList {
    pub(super) list: [Option<Watched>; MOST_WATCHED],
    pub(super) len: usize,
}

/// What has just left zero.
pub(super) struct Fresh<'a> {
    pub(super) departing: &'a Few<Departing>,
    pub(super) starting: &'a Few<Starting>,
}

/// A sine below this is that of a face that lies on the obstacle.
const FLAT: f64 = 1e-6;

impl WatchList {
    fn push(&mut self, what: Watch, leaving: Option<Leaving>) {
        if let Some(place) = self.list.get_mut(self.len) {
            *place = Some(Watched { what, leaving });
            self.len += 1;
        }
    }

    /// The event functions of the mode `held`.
    pub(super) fn of(world: &World, state: &State, held: &Few<Held>, fresh: &Fresh<'_>) -> Self {
        let mut out = Self { list: [None; MOST_WATCHED], len: 0 };
        let turn = Turn::of(state);
        for (i, h) in held.iter().enumerate() {
            out.push(Watch::Force(i), None);
            if h.slip == Slip::Sticks {
                out.push(Watch::Cone(i, true), None);
                out.push(Watch::Cone(i, false), None);
            } else {
                let start = fresh.starting.iter().find(|s| s.pair == h.pair);
                out.push(Watch::Slip(i), start.map(|s| s.leaving));
            }
            for (slot, extent) in world.extents(state, turn, h.pair).iter().enumerate() {
                if extent.is_some() {
                    out.push(Watch::Extent(i, slot), None);
                }
            }
            for slot in 0..parallel_slots(world, h.pair) {
                let sine = world.parallel(turn, h.pair, slot);
                let departing = fresh.departing.iter().find(|d| d.pair.obstacle == h.pair.obstacle);
                if sine.abs() > FLAT {
                    out.push(Watch::Parallel(i, slot), None);
                } else if let (Some(d), false) = (departing, lies_flat(held, h)) {
                    out.push(Watch::Parallel(i, slot), Some(d.leaving));
                }
            }
        }
        for d in fresh.departing.iter() {
            if !held.iter().any(|h| h.pair.obstacle == d.pair.obstacle) {
                out.push(Watch::Gap(d.pair), Some(d.leaving));
            }
        }
        if held.iter().any(|h| h.slip != Slip::Sticks) {
            out.push(Watch::Regular, None);
        }
        out
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = &Watched> {
        self.list[..self.len].iter().flatten()
    }
}

/// True where another held contact of the same obstacle keeps the body's face on it.
pub(super) fn lies_flat(held: &Few<Held>, h: &Held) -> bool {
    held.iter().any(|o| o.pair != h.pair && o.pair.obstacle == h.pair.obstacle)
}

/// How many faces can close on the obstacle by turning about this contact.
fn parallel_slots(world: &World, pair: Pairing) -> usize {
    match pair.feature {
        Feature::VertexOnFace { .. } => match world.body.shape.vertices().len() {
            1 => 0,
            2 => 1,
            _ => 2,
        },
        Feature::FaceOnEnd { .. } => 1,
        Feature::VertexOnEnd { .. } => 0,
    }
}

impl World {
    /// Sine of the angle by which face `slot` (0: before the vertex, 1: after) stands off the obstacle.
    pub(super) fn parallel(&self, turn: Turn, pair: Pairing, slot: usize) -> f64 {
        let (shape, o) = (&self.body.shape, &self.obstacles[pair.obstacle]);
        match pair.feature {
            Feature::VertexOnFace { vertex, left } => {
                let along = o.direction();
                let normal = if left { along.turned_left() } else { along.turned_right() };
                let k = shape.vertices().len();
                let neighbour = if slot == 0 { (vertex + k - 1) % k } else { (vertex + 1) % k };
                let d = shape.vertices()[neighbour] - shape.vertices()[vertex];
                normal.dot(turn.apply(d)) / d.norm()
            }
            Feature::FaceOnEnd { face, at_to } => {
                let inward = if at_to { -o.direction() } else { o.direction() };
                turn.apply(shape.face_normal(face)).dot(inward)
            }
            Feature::VertexOnEnd { .. } => 1.0,
        }
    }

    /// Value of one event function, in the world's own units.
    pub(super) fn watch(
        &self,
        w: &Watched,
        time: f64,
        state: &State,
        forces: &Forces,
        scales: &Scales,
    ) -> f64 {
        let weight = self.body.mass * (self.gravity.norm() + f64::MIN_POSITIVE);
        let contact = |i: usize| forces.contacts.iter().nth(i);
        let value = match w.what {
            Watch::Force(i) => contact(i).map_or(1.0, |c| c.normal_force / weight),
            Watch::Slip(i) => contact(i).map_or(1.0, |c| {
                let u = c.kinematics.slip / scales.speed;
                if c.held.slip == Slip::Backward { -u } else { u }
            }),
            Watch::Cone(i, forward) => contact(i).map_or(1.0, |c| {
                let room = self.obstacles[c.held.pair.obstacle].friction * c.normal_force;
                (room + if forward { -c.tangential_force } else { c.tangential_force }) / weight
            }),
            Watch::Extent(i, slot) => contact(i).map_or(1.0, |c| {
                let extents = self.extents(state, Turn::of(state), c.held.pair);
                extents[slot].map_or(1.0, |(s, _)| s / scales.length)
            }),
            Watch::Parallel(i, slot) => {
                contact(i).map_or(1.0, |c| self.parallel(Turn::of(state), c.held.pair, slot))
            }
            Watch::Gap(pair) => self.kinematics(state, pair).gap / scales.length,
            Watch::Regular => forces.regularity,
        };
        match w.leaving {
            Some(l) => value / ((time - l.since) / scales.time).powi(l.order),
            None => value,
        }
    }
}
