//! The event functions of a mode: positive while the mode holds.

use super::kinematics::{Kinematics, Pairing, Turn};
use super::mode::{Forces, Held, Loaded};
use super::touching::Few;
use super::world::Scales;
use super::{Feature, State, World};
use carom_impact::planar::Slip;

/// Most event functions of one mode.
pub(super) const MOST_WATCHED: usize = 64;

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
    /// Overlap that is passed over, in the world's own units.
    slack: f64,
}

impl Watched {
    pub(super) fn plain(what: Watch) -> Self {
        Self { what, leaving: None, slack: 0.0 }
    }
}

/// A quantity that leaves zero: since when, the order of its first derivative that is not zero, and what rounding has left of the zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Leaving {
    pub(super) since: f64,
    order: i32,
    offset: f64,
}

/// The list of a mode's event functions.
pub(super) struct WatchList {
    list: [Option<Watched>; MOST_WATCHED],
    len: usize,
    now: f64,
    /// Rounding cannot tell whether a quantity leaves zero: it may fall a little before that is an event.
    stalled: bool,
    /// When the first of the quantities that leave zero is back there, were its rates to stay [units of the world's time].
    pub(super) returns: f64,
}

/// A quantity below this, in the world's own units, has not yet left zero.
const ZERO: f64 = 1e-10;
/// A rate below this, in the world's own units, counts as none.
const SIGNIFICANT: f64 = 1e-9;
/// Below this sine a face that another contact keeps on the obstacle lies on it.
const FLAT: f64 = 1e-5;

/// A quantity that is watched, at the start of a piece: value and first two rates, in the world's own units.
struct Beginning {
    value: f64,
    rates: [f64; 2],
}

impl WatchList {
    /// The event functions of the mode `held` whose forces in `state` are `forces`. `departing` are pairs of obstacles without a held
    /// contact that have just opened.
    pub(super) fn of(
        world: &World,
        now: f64,
        state: &State,
        forces: &Forces,
        departing: &Few<Pairing>,
        stalled: bool,
    ) -> Self {
        let mut out = Self { list: [None; MOST_WATCHED], len: 0, now, returns: f64::INFINITY, stalled };
        let scales = world.scales();
        for (i, c) in forces.contacts.iter().enumerate() {
            out.push(Watch::Force(i));
            if c.held.slip == Slip::Sticks {
                out.push(Watch::Cone(i, true));
                out.push(Watch::Cone(i, false));
            } else {
                out.push_leaving(Watch::Slip(i), &world.slip_beginning(c, forces, &scales));
            }
            for (slot, extent) in world.extents(state, Turn::of(state), c.held.pair).iter().enumerate() {
                if extent.is_some() {
                    out.push(Watch::Extent(i, slot));
                }
            }
            for slot in 0..parallel_slots(world, c.held.pair) {
                if !world.lies_on(state, &forces.contacts, c, slot) {
                    out.push_leaving(
                        Watch::Parallel(i, slot),
                        &world.parallel_beginning(state, forces, c.held.pair, slot),
                    );
                }
            }
        }
        for pair in departing.iter() {
            if !forces.contacts.iter().any(|c| c.held.pair.obstacle == pair.obstacle) {
                out.push_leaving(Watch::Gap(*pair), &world.gap_beginning(state, forces, *pair));
            }
        }
        if forces.contacts.iter().any(|c| c.held.slip != Slip::Sticks) {
            out.push(Watch::Regular);
        }
        out
    }

    fn push(&mut self, what: Watch) {
        self.add(Watched::plain(what));
    }

    fn push_leaving(&mut self, what: Watch, start: &Beginning) {
        let order =
            start.rates.iter().position(|r| r.abs() > SIGNIFICANT).map_or(3, |i| if i == 0 { 1 } else { 2 });
        let [rate, bend] = start.rates;
        if start.value < ZERO && rate > SIGNIFICANT && bend < 0.0 {
            self.returns = self.returns.min(-2.0 * rate / bend);
        }
        if start.value >= ZERO {
            self.push(what);
        } else if self.stalled {
            self.add(Watched { what, leaving: None, slack: ZERO - start.value });
        } else {
            let leaving = Some(Leaving { since: self.now, order, offset: start.value });
            self.add(Watched { what, leaving, slack: 0.0 });
        }
    }

    fn add(&mut self, watched: Watched) {
        if let Some(place) = self.list.get_mut(self.len) {
            *place = Some(watched);
            self.len += 1;
        }
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = &Watched> {
        self.list[..self.len].iter().flatten()
    }
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
    /// True where another held contact, on the same obstacle or on one in line with it, keeps face `slot` of this one on its obstacle.
    fn lies_on(&self, state: &State, held: &Few<Loaded>, c: &Loaded, slot: usize) -> bool {
        let k = &c.kinematics;
        let keeps = |o: &Kinematics| {
            let apart = (o.arm - k.arm).dot(k.tangent()).abs();
            o.normal.cross(k.normal).abs() < FLAT && apart > FLAT * self.body.shape.size()
        };
        held.iter().any(|o| keeps(&o.kinematics))
            && self.parallel(Turn::of(state), c.held.pair, slot).abs() < FLAT
    }

    fn slip_beginning(&self, c: &Loaded, forces: &Forces, scales: &Scales) -> Beginning {
        let sign = if c.held.slip == Slip::Backward { -1.0 } else { 1.0 };
        let (k, a) = (&c.kinematics, forces.acceleration);
        let rate = k.slip_bias + k.tangent().dot(a.linear) + k.arm.cross(k.tangent()) * a.angular;
        Beginning {
            value: sign * k.slip / scales.speed,
            rates: [sign * rate * scales.time / scales.speed, 0.0],
        }
    }

    fn parallel_beginning(&self, state: &State, forces: &Forces, pair: Pairing, slot: usize) -> Beginning {
        let turn = Turn::of(state);
        let quarter = Turn { cos: -turn.sin, sin: turn.cos };
        // The sine's rate with the angle is its value a quarter turn on.
        let with_angle = self.parallel(quarter, pair, slot);
        let (w, a, t) = (state.twist.spin, forces.acceleration.angular, self.scales().time);
        let rates = [with_angle * w * t, with_angle * a * t * t];
        Beginning { value: self.parallel(turn, pair, slot), rates }
    }

    fn gap_beginning(&self, state: &State, forces: &Forces, pair: Pairing) -> Beginning {
        let (k, a, scales) = (self.kinematics(state, pair), forces.acceleration, self.scales());
        let second = k.gap_bend(a.linear, a.angular);
        let (t, l) = (scales.time, scales.length);
        Beginning { value: k.gap / l, rates: [k.approach * t / l, second * t * t / l] }
    }

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
}

/// A state of a mode with what all its event functions need.
pub(super) struct Snapshot<'a> {
    world: &'a World,
    scales: &'a Scales,
    time: f64,
    state: &'a State,
    turn: Turn,
    pub(super) forces: Forces,
    weight: f64,
}

impl<'a> Snapshot<'a> {
    pub(super) fn new(
        world: &'a World,
        scales: &'a Scales,
        held: &Few<Held>,
        time: f64,
        state: &'a State,
    ) -> Self {
        Self::of_forces(world, scales, world.forces(held, state), time, state)
    }

    /// As [`Snapshot::new`], where the forces are known.
    pub(super) fn of_forces(
        world: &'a World,
        scales: &'a Scales,
        forces: Forces,
        time: f64,
        state: &'a State,
    ) -> Self {
        let weight = world.body.mass * scales.speed * scales.speed / scales.length;
        Self { world, scales, time, state, turn: Turn::of(state), forces, weight }
    }

    /// Value of one event function, in the world's own units.
    pub(super) fn value(&self, w: &Watched) -> f64 {
        let value = self.plain(w.what).unwrap_or(1.0);
        match w.leaving {
            Some(l) => (value - l.offset) / ((self.time - l.since) / self.scales.time).powi(l.order),
            None => value + w.slack,
        }
    }

    fn plain(&self, what: Watch) -> Option<f64> {
        let contact = |i: usize| self.forces.contacts.get(i);
        Some(match what {
            Watch::Force(i) => contact(i)?.normal_force / self.weight,
            Watch::Slip(i) => {
                let c = contact(i)?;
                let u = c.kinematics.slip / self.scales.speed;
                if c.held.slip == Slip::Backward { -u } else { u }
            }
            Watch::Cone(i, forward) => {
                let c = contact(i)?;
                let room = self.world.obstacles[c.held.pair.obstacle].friction * c.normal_force;
                (room + if forward { -c.tangential_force } else { c.tangential_force }) / self.weight
            }
            Watch::Extent(i, slot) => {
                let pair = contact(i)?.held.pair;
                self.world.extents(self.state, self.turn, pair)[slot]?.0 / self.scales.length
            }
            Watch::Parallel(i, slot) => self.world.parallel(self.turn, contact(i)?.held.pair, slot),
            Watch::Gap(pair) => {
                self.world.kinematics_turned(self.state, self.turn, pair).gap / self.scales.length
            }
            Watch::Regular => self.forces.regularity,
        })
    }
}
