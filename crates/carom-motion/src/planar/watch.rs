//! The event functions of a mode: positive while the mode holds.

use super::kinematics::{Pairing, Turn};
use super::mode::{Forces, Held, Loaded};
use super::touching::Few;
use super::world::Scales;
use super::{Feature, Obstacle, Shape, State, World};
use carom_impact::planar::Slip;
use carom_num::Vec2;

/// Most event functions of one mode.
pub(super) const MOST_WATCHED: usize = 96;

/// What an event function watches. The number is that of the held contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Watch {
    /// Normal force.
    Force(usize),
    /// Whether any of the forces that the mode leaves open holds it: the smallest room of the one taken, which has most.
    Holds,
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

/// An event function and its values at the five nodes of the step that is looked at.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row {
    pub(super) watched: Watched,
    pub(super) values: [f64; 5],
}

/// The list of a mode's event functions.
pub(super) struct WatchList {
    list: [Option<Row>; MOST_WATCHED],
    len: usize,
    /// Three nodes show that nothing comes near zero: the other two were not looked at.
    pub(super) clear: bool,
    now: f64,
    /// Rounding cannot tell whether a quantity leaves zero: it may fall a little before that is an event.
    stalled: bool,
    /// A rate below this, in the world's own units, counts as none.
    significant: f64,
    /// When the first of the quantities that leave zero is back there, were its rates to stay [units of the world's time].
    pub(super) returns: f64,
}

/// A quantity below this, in the world's own units, has not yet left zero.
const ZERO: f64 = 1e-10;
/// Below this sine a face that another contact keeps on the obstacle lies on it.
const FLAT: f64 = 1e-5;

/// A quantity that is watched, at the start of a piece: value and first two rates, in the world's own units.
struct Beginning {
    value: f64,
    rates: [f64; 2],
}

impl WatchList {
    /// A list with nothing on it.
    #[inline]
    pub(super) fn empty() -> Self {
        // Written place by place: only the tags, of a list that is large and mostly empty.
        let (list, returns) = (std::array::from_fn(|_| None), f64::INFINITY);
        Self { list, len: 0, clear: false, now: 0.0, stalled: false, significant: 0.0, returns }
    }

    /// Clears the list: what is noted from now on begins at this time.
    pub(super) fn begin(&mut self, now: f64, (stalled, significant): (bool, f64)) {
        (self.len, self.returns, self.now) = (0, f64::INFINITY, now);
        (self.stalled, self.significant) = (stalled, significant);
    }

    /// Notes the event functions of the mode whose forces in `states` are `forces`. `departing` are pairs of obstacles without a held
    /// contact that have just opened.
    pub(super) fn note<const B: usize>(
        &mut self,
        world: &World,
        (states, turns): (&[State; B], &[Turn; B]),
        forces: &Forces<B>,
        departing: &Few<Pairing>,
    ) {
        let (stalled, out) = (self.stalled, self);
        let scales = world.scales();
        for (i, c) in forces.contacts.iter().enumerate() {
            if !forces.indeterminate {
                out.push(Watch::Force(i));
            }
            if c.held.slip == Slip::Sticks {
                if !forces.indeterminate {
                    out.push(Watch::Cone(i, true));
                    out.push(Watch::Cone(i, false));
                }
            } else {
                out.push_leaving(Watch::Slip(i), &world.slip_beginning(c, forces, &scales));
            }
            for (slot, extent) in world.extents(states, turns, c.held.pair).iter().enumerate() {
                if let Some((room, _)) = extent {
                    let short = ZERO - room / scales.length;
                    let slack = if stalled { short.max(0.0) } else { 0.0 };
                    out.add(Watched { what: Watch::Extent(i, slot), leaving: None, slack });
                }
            }
            for slot in 0..parallel_slots(world, c.held.pair) {
                if !world.lies_on(turns, &forces.contacts, c, slot) {
                    out.push_leaving(
                        Watch::Parallel(i, slot),
                        &world.parallel_beginning((states, turns), forces, c.held.pair, slot),
                    );
                }
            }
        }
        if forces.indeterminate {
            out.push(Watch::Holds);
        }
        for pair in departing.iter() {
            if !forces.contacts.iter().any(|c| c.held.pair.meeting() == pair.meeting()) {
                out.push_leaving(Watch::Gap(*pair), &world.gap_beginning(states, forces, *pair));
            }
        }
        if forces.contacts.iter().any(|c| c.held.slip != Slip::Sticks) {
            out.push(Watch::Regular);
        }
    }

    fn push(&mut self, what: Watch) {
        self.add(Watched::plain(what));
    }

    fn push_leaving(&mut self, what: Watch, start: &Beginning) {
        let significant = self.significant;
        let order =
            start.rates.iter().position(|r| r.abs() > significant).map_or(3, |i| if i == 0 { 1 } else { 2 });
        let [rate, bend] = start.rates;
        if start.value < ZERO && rate > significant && bend < 0.0 {
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
            *place = Some(Row { watched, values: [1.0; 5] });
            self.len += 1;
        }
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = &Row> {
        self.list[..self.len].iter().flatten()
    }

    pub(super) fn iter_mut(&mut self) -> impl Iterator<Item = &mut Row> {
        self.list[..self.len].iter_mut().flatten()
    }

    pub(super) fn rows_mut(&mut self) -> &mut [Option<Row>] {
        &mut self.list[..self.len]
    }
}

/// How many faces beside a vertex of `shape` can close on what it touches by turning about it.
fn faces_beside_vertex(shape: &Shape) -> usize {
    match shape.vertices().len() {
        1 => 0,
        2 => 1,
        _ => 2,
    }
}

/// How many faces can close on what is touched by turning about this contact.
fn parallel_slots(world: &World, pair: Pairing) -> usize {
    match (pair.feature, world.other_body(pair)) {
        (Feature::VertexOnFace { .. }, _) => faces_beside_vertex(&world.body_of(pair).shape),
        (Feature::FaceOnEnd { .. }, None) => 1,
        (Feature::FaceOnEnd { .. }, Some(other)) => faces_beside_vertex(&world.bodies[other].shape),
        (Feature::VertexOnEnd { .. }, _) => 0,
    }
}

/// Sine of the angle by which the face before (slot 0) or after (slot 1) a vertex stands off a face with this normal.
fn stands_off(shape: &Shape, turn: Turn, vertex: usize, slot: usize, normal: Vec2) -> f64 {
    let k = shape.vertices().len();
    let neighbour = if slot == 0 { (vertex + k - 1) % k } else { (vertex + 1) % k };
    let d = shape.vertices()[neighbour] - shape.vertices()[vertex];
    normal.dot(turn.apply(d)) / d.norm()
}

impl World {
    /// True where another held contact, on the same obstacle or on one in line with it, keeps face `slot` of this one on its obstacle.
    fn lies_on(&self, turns: &[Turn], held: &Few<Loaded>, c: &Loaded, slot: usize) -> bool {
        let k = &c.kinematics;
        let keeps = |o: &Loaded| {
            let apart = (o.kinematics.arm - k.arm).dot(k.tangent()).abs();
            // Obstacles do not move against each other; bodies do.
            let together = |pair: Pairing| self.other_body(pair).is_none() && pair.body == c.held.pair.body;
            let same = o.held.pair.meeting() == c.held.pair.meeting();
            (same || (together(o.held.pair) && together(c.held.pair)))
                && o.kinematics.normal.cross(k.normal).abs() < FLAT
                && apart > FLAT * self.body_of(c.held.pair).shape.size()
        };
        held.iter().any(keeps) && self.parallel(turns, c.held.pair, slot).abs() < FLAT
    }

    fn slip_beginning<const B: usize>(&self, c: &Loaded, forces: &Forces<B>, scales: &Scales) -> Beginning {
        let sign = if c.held.slip == Slip::Backward { -1.0 } else { 1.0 };
        let (k, pair) = (&c.kinematics, c.held.pair);
        let rate = k.slip_bias + self.acceleration_along(k, pair, k.tangent(), &forces.acceleration);
        Beginning {
            value: sign * k.slip / scales.speed,
            rates: [sign * rate * scales.time / scales.speed, 0.0],
        }
    }

    fn parallel_beginning<const B: usize>(
        &self,
        (states, turns): (&[State; B], &[Turn; B]),
        forces: &Forces<B>,
        pair: Pairing,
        slot: usize,
    ) -> Beginning {
        // The sine's rate with the body's angle is its value a quarter turn on; with the other's, minus that.
        let mut quarter = *turns;
        let turn = turns[pair.body];
        quarter[pair.body] = Turn { cos: -turn.sin, sin: turn.cos };
        let with_angle = self.parallel(&quarter, pair, slot);
        let relative = |of: &dyn Fn(usize) -> f64| of(pair.body) - self.other_body(pair).map_or(0.0, of);
        let (w, a) = (relative(&|b| states[b].twist.spin), relative(&|b| forces.acceleration[b].angular));
        let t = self.scales().time;
        let rates = [with_angle * w * t, with_angle * a * t * t];
        Beginning { value: self.parallel(turns, pair, slot), rates }
    }

    fn gap_beginning<const B: usize>(
        &self,
        states: &[State; B],
        forces: &Forces<B>,
        pair: Pairing,
    ) -> Beginning {
        let (k, scales) = (self.kinematics(states, pair), self.scales());
        let second = self.gap_bend(&k, pair, &forces.acceleration);
        let (t, l) = (scales.time, scales.length);
        Beginning { value: k.gap / l, rates: [k.approach * t / l, second * t * t / l] }
    }

    /// Sine of the angle by which face `slot` (0: before the vertex, 1: after) stands off what is touched.
    pub(super) fn parallel(&self, turns: &[Turn], pair: Pairing, slot: usize) -> f64 {
        let (shape, turn) = (&self.body_of(pair).shape, turns[pair.body]);
        let other = self.other_body(pair).map(|b| (&self.bodies[b].shape, turns[b]));
        match (pair.feature, other) {
            (Feature::VertexOnFace { vertex, face }, None) => {
                stands_off(shape, turn, vertex, slot, self.obstacles[pair.obstacle].normal(face))
            }
            (Feature::VertexOnFace { vertex, face }, Some((met, at))) => {
                stands_off(shape, turn, vertex, slot, at.apply(met.face_normal(face)))
            }
            (Feature::FaceOnEnd { face, end }, None) => {
                let along = self.obstacles[pair.obstacle].direction();
                let inward = if end == Obstacle::TO { -along } else { along };
                turn.apply(shape.face_normal(face)).dot(inward)
            }
            (Feature::FaceOnEnd { face, end }, Some((met, at))) => {
                stands_off(met, at, end, slot, turn.apply(shape.face_normal(face)))
            }
            (Feature::VertexOnEnd { .. }, _) => 1.0,
        }
    }
}

/// A contact that is about to give way, and the room that is left, in units of the weight.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scarcest {
    room: f64,
    pub(super) contact: usize,
    /// It would slide, not open.
    pub(super) slides: bool,
}

/// Rooms of forces that a mode leaves open are known up to this, in units of the weight: a contact that just transmits none still holds.
const ROUNDING: f64 = 1e-10;

/// A state of a mode with what all its event functions need.
pub(super) struct Snapshot<'a, const B: usize> {
    pub(super) world: &'a World,
    pub(super) scales: &'a Scales,
    pub(super) held: &'a Few<Held>,
    pub(super) time: f64,
    pub(super) states: &'a [State; B],
    pub(super) turns: &'a [Turn; B],
    /// Known where an event function asks for them: [`Watch::asks_forces`].
    pub(super) forces: &'a Forces<B>,
}

impl Watch {
    /// True where its value is one of the forces, not of the pose and the velocities alone.
    pub(super) fn asks_forces(&self) -> bool {
        matches!(self, Self::Force(_) | Self::Holds | Self::Cone(..) | Self::Regular)
    }
}

impl<const B: usize> Snapshot<'_, B> {
    fn weight(&self) -> f64 {
        let heaviest = self.world.bodies.iter().map(|b| b.mass).fold(0.0, f64::max);
        heaviest * self.scales.speed * self.scales.speed / self.scales.length
    }

    /// Value of one event function, in the world's own units.
    pub(super) fn value(&self, w: &Watched) -> f64 {
        let value = self.plain(w.what).unwrap_or(1.0);
        match w.leaving {
            // 0/0: whoever looks at the very start must know that nothing is known there.
            Some(l) if self.time <= l.since => f64::NAN,
            Some(l) => (value - l.offset) / ((self.time - l.since) / self.scales.time).powi(l.order),
            None => value + w.slack,
        }
    }

    fn room_in_cone(&self, c: &Loaded, forward: bool) -> f64 {
        let room = self.world.surface(c.held.pair).friction * c.normal_force;
        (room + if forward { -c.tangential_force } else { c.tangential_force }) / self.weight()
    }

    /// The contact that is nearest to giving way.
    pub(super) fn scarcest(&self) -> Option<Scarcest> {
        let mut least: Option<Scarcest> = None;
        let mut take = |room: f64, contact: usize, slides: bool| {
            if least.is_none_or(|l| room < l.room) {
                least = Some(Scarcest { room, contact, slides });
            }
        };
        for (i, c) in self.forces.contacts.iter().enumerate() {
            take(c.normal_force / self.weight(), i, false);
            if c.held.slip == Slip::Sticks {
                take(self.room_in_cone(c, true).min(self.room_in_cone(c, false)), i, true);
            }
        }
        least
    }

    fn plain(&self, what: Watch) -> Option<f64> {
        let contact = |i: usize| self.forces.contacts.get(i);
        let pair = |i: usize| self.held.get(i).map(|h| h.pair);
        Some(match what {
            Watch::Force(i) => contact(i)?.normal_force / self.weight(),
            Watch::Holds => self.scarcest()?.room + ROUNDING,
            Watch::Slip(i) => {
                let h = self.held.get(i)?;
                let k = self.world.kinematics_turned(self.states, self.turns, h.pair);
                let u = k.slip / self.scales.speed;
                if h.slip == Slip::Backward { -u } else { u }
            }
            Watch::Cone(i, forward) => self.room_in_cone(contact(i)?, forward),
            Watch::Extent(i, slot) => {
                self.world.extents(self.states, self.turns, pair(i)?)[slot]?.0 / self.scales.length
            }
            Watch::Parallel(i, slot) => self.world.parallel(self.turns, pair(i)?, slot),
            Watch::Gap(pair) => {
                self.world.kinematics_turned(self.states, self.turns, pair).gap / self.scales.length
            }
            Watch::Regular => self.forces.regularity,
        })
    }
}
