//! The event functions of a mode: positive while the mode holds.

use super::mode::{Forces, Loaded};
use crate::planar::contact::{
    World,
    kinematics::{Kinematics, Pairing, Turn, turns},
    touching::Few,
    world::Scales,
};
use crate::planar::geometry::State;
use crate::tolerance::{MOMENT, NOT_YET_LEFT, STILL_SPEED};
use carom_impact::planar::Slip;

/// Most event functions of one contact: force, slip (or both sides of its cone), ends of its features, faces that close by turning.
pub(in crate::planar) const MOST_OF_CONTACT: usize = 7;
/// Most event functions of one mode.
pub(in crate::planar) const MOST_WATCHED: usize = 96;
/// Event functions for which there is room at first: those of two contacts, with some to spare.
pub(in crate::planar) const FEW_WATCHED: usize = 20;

/// What an event function watches. The number is that of the held contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::planar) enum Watch {
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
pub(in crate::planar) struct Watched {
    pub(in crate::planar) what: Watch,
    pub(in crate::planar) leaving: Option<Leaving>,
    /// Overlap that is passed over, in the world's own units.
    pub(in crate::planar) slack: f64,
}

impl Watched {
    pub(in crate::planar) fn plain(what: Watch) -> Self {
        Self { what, leaving: None, slack: 0.0 }
    }
}

/// A quantity that leaves zero: since when, the order of its first derivative that is not zero, and what rounding has left of the zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::planar) struct Leaving {
    pub(in crate::planar) since: f64,
    pub(in crate::planar) order: i32,
    pub(in crate::planar) offset: f64,
    /// What the quotient begins with, where the rate is known.
    pub(in crate::planar) first: Option<f64>,
}

/// An event function and its values at the five nodes of the step that is looked at.
#[derive(Clone, Copy, Debug)]
pub(in crate::planar) struct Row {
    pub(in crate::planar) watched: Watched,
    pub(in crate::planar) values: [f64; 5],
}

/// The list of a mode's event functions.
pub(in crate::planar) struct WatchList<'r> {
    list: &'r mut [Option<Row>],
    len: usize,
    /// Three nodes show that nothing comes near zero: the other two were not looked at.
    pub(in crate::planar) clear: bool,
    now: f64,
    /// Rounding cannot tell whether a quantity leaves zero: it may fall a little before that is an event.
    stalled: bool,
    /// A rate below this, in the world's own units, counts as none.
    significant: f64,
    /// When the first of the quantities that leave zero is back there, were its rates to stay [units of the world's time].
    pub(in crate::planar) returns: f64,
}

/// The order of the first of a quantity's rates that counts, by these rates in the world's own units: more than `significant`, or, of what `opens` where
/// a strike says so, more than what a strike takes for none. What was said to open falls back later, never at once, where it would be said again.
pub(in crate::planar) fn leading(rates: &[f64], significant: f64, opens: bool) -> Option<i32> {
    let counts = |(order, rate): (i32, &f64)| {
        let leaves = opens && order == 1 && *rate > STILL_SPEED;
        (leaves || rate.abs() > significant).then_some(order)
    };
    (1..).zip(rates).find_map(counts)
}

/// A quantity that is watched, at the start of a piece: value and first two rates, in the world's own units.
struct Beginning {
    value: f64,
    rates: [f64; 2],
}

impl<'r> WatchList<'r> {
    /// A list with nothing on it.
    pub(in crate::planar) fn on(list: &'r mut [Option<Row>]) -> Self {
        let returns = f64::INFINITY;
        Self { list, len: 0, clear: false, now: 0.0, stalled: false, significant: 0.0, returns }
    }

    /// Clears the list: what is noted from now on begins at this time.
    pub(in crate::planar) fn begin(&mut self, now: f64, (stalled, significant): (bool, f64)) {
        (self.len, self.returns, self.now) = (0, f64::INFINITY, now);
        (self.stalled, self.significant) = (stalled, significant);
    }

    /// Notes the event functions of the mode whose forces in `states` are `forces`. `departing` are pairs of obstacles without a held
    /// contact that have just opened.
    pub(in crate::planar) fn note<const B: usize>(
        &mut self,
        world: &World,
        (states, turns): (&[State; B], &[Turn; B]),
        forces: &Forces<B>,
        departing: &Few<Pairing>,
    ) {
        let out = self;
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
            } else if forces.contacts.len() == 1
                || !forces.contacts.iter().any(|o| world.pins(o.held.pair, c.held.pair))
            {
                // Of what another contact pins only the rounding would slip.
                let start = world.slip_beginning((states, c), forces, (&scales, out.significant));
                out.push_leaving(Watch::Slip(i), &start);
            }
            // What sticks and does not roll stays where it is on both features.
            if c.held.slip != Slip::Sticks || world.is_round(c.held.pair.meeting()) {
                let mut extents = world.extents(states, turns, c.held.pair);
                for (slot, extent) in extents.iter_mut().enumerate() {
                    // Into the corner of a joint nothing runs off: it meets what is joined there.
                    *extent = extent.filter(|_| !world.goes_on(c.held.pair, slot));
                }
                out.push_extents(i, &extents, scales.length);
            }
            for slot in 0..world.parallel_slots(c.held.pair) {
                if world.can_lie_down(c.held.pair, slot) && !world.lies_on(turns, &forces.contacts, c, slot) {
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
            // Two hulls that hold each other touch elsewhere only by turning until a face is parallel.
            let holds = forces.contacts.iter().any(|c| c.held.pair.meeting() == pair.meeting());
            let pinned = |c: &Loaded| c.held.slip == Slip::Sticks && world.pins(c.held.pair, *pair);
            if !(holds && world.are_hulls(pair.meeting()) || forces.contacts.iter().any(pinned)) {
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

    /// Notes the ends of the features of held contact `i`, at these distances [m] and rates.
    fn push_extents(&mut self, i: usize, extents: &[Option<(f64, f64)>], length: f64) {
        for (slot, extent) in extents.iter().enumerate() {
            if let Some((room, _)) = extent {
                let short = NOT_YET_LEFT - room / length;
                let slack = if self.stalled { short.max(0.0) } else { 0.0 };
                self.add(Watched { what: Watch::Extent(i, slot), leaving: None, slack });
            }
        }
    }

    fn push_leaving(&mut self, what: Watch, start: &Beginning) {
        let [rate, bend] = start.rates;
        let order = leading(&start.rates, self.significant, !matches!(what, Watch::Slip(_))).unwrap_or(3);
        if start.value < NOT_YET_LEFT && order == 1 && rate > 0.0 && bend < 0.0 {
            self.returns = self.returns.min(-2.0 * rate / bend);
        }
        if start.value >= NOT_YET_LEFT {
            self.push(what);
        } else if self.stalled {
            self.add(Watched { what, leaving: None, slack: NOT_YET_LEFT - start.value });
        } else {
            let first = match order {
                1 => Some(rate),
                2 => Some(0.5 * bend),
                _ => None,
            }
            .filter(|_| matches!(what, Watch::Slip(_)));
            let leaving = Some(Leaving { since: self.now, order, offset: start.value, first });
            self.add(Watched { what, leaving, slack: 0.0 });
        }
    }

    fn add(&mut self, watched: Watched) {
        if let Some(place) = self.list.get_mut(self.len) {
            *place = Some(Row { watched, values: [1.0; 5] });
            self.len += 1;
        }
    }

    /// Takes an event function off the list.
    pub(in crate::planar) fn strike(&mut self, what: Watch) {
        let listed = |row: &Option<Row>| row.is_some_and(|row| row.watched.what == what);
        if let Some(place) = self.list[..self.len].iter().position(listed) {
            self.list[place..self.len].rotate_left(1);
            self.len -= 1;
        }
    }

    pub(in crate::planar) fn iter(&self) -> impl Iterator<Item = &Row> {
        self.list[..self.len].iter().flatten()
    }

    pub(in crate::planar) fn iter_mut(&mut self) -> impl Iterator<Item = &mut Row> {
        self.list[..self.len].iter_mut().flatten()
    }

    pub(in crate::planar) fn rows_mut(&mut self) -> &mut [Option<Row>] {
        &mut self.list[..self.len]
    }
}

impl World {
    fn slip_beginning<const B: usize>(
        &self,
        (states, c): (&[State; B], &Loaded),
        forces: &Forces<B>,
        (scales, significant): (&Scales, f64),
    ) -> Beginning {
        let sign = if c.held.slip == Slip::Backward { -1.0 } else { 1.0 };
        let unit = sign * scales.time / scales.speed;
        let rate = self.slip_rate(&c.kinematics, c.held.pair, forces);
        // Where friction has just given way the slip begins at second order: a difference tells which way.
        let bend = if (unit * rate).abs() > significant {
            0.0
        } else {
            let after = scales.time * MOMENT;
            let soon = self.slip_rate_soon(states, c.held.pair, forces, after);
            (soon - rate) / after
        };
        Beginning {
            value: sign * c.kinematics.slip / scales.speed,
            rates: [unit * rate, unit * scales.time * bend],
        }
    }

    /// How the slip of a contact grows [m/s²].
    fn slip_rate<const B: usize>(&self, k: &Kinematics, pair: Pairing, forces: &Forces<B>) -> f64 {
        k.slip_bias + self.acceleration_along(k, pair, k.tangent(), &forces.acceleration)
    }

    /// The same a moment later in the same mode.
    fn slip_rate_soon<const B: usize>(
        &self,
        states: &[State; B],
        pair: Pairing,
        forces: &Forces<B>,
        after: f64,
    ) -> f64 {
        let mut soon = *states;
        for (state, a) in soon.iter_mut().zip(&forces.acceleration) {
            *state = a.over(state, after);
        }
        let mut held = Few::default();
        for c in forces.contacts.iter() {
            held.push(c.held);
        }
        let (turns, mut then) = (turns(&soon), Forces::default());
        self.forces_into(&held, &soon, &turns, &mut then);
        self.slip_rate(&self.kinematics_turned(&soon, &turns, pair), pair, &then)
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
}

#[cfg(test)]
mod beginnings;
