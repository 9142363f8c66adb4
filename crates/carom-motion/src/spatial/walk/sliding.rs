//! A body some of whose supports slide: its equations.
//!
//! The *foot* is the support that sticks or, where none does, the slowest. What is integrated is the turn since the stretch began, the spin (body axes), how far
//! the foot has gone and its slip (world axes), the work of friction, and the spin about the plane's normal once more. The slip and that spin are what all slips
//! are made of: integrated by themselves they keep their digits where slips come to zero, and where they start.

use crate::tolerance::{SLIP_GROWN, SLIP_SPECK, SLIP_STOPPED};
mod moment;

use super::motion::{Event, Motion};
use crate::spatial::geometry::body::Body;
use crate::spatial::geometry::posture::{Height, Posture};
use crate::spatial::geometry::state::State;
use crate::spatial::geometry::supports::Supports;
use crate::spatial::geometry::world::Scales;
use crate::spatial::geometry::world::World;
use crate::spatial::modes::grip::MOST_BEARING;
use crate::spatial::modes::mode::{Mode, normal_of};
use crate::spatial::modes::stretch::Heights;
use carom_num::ode8::Step;
use carom_num::{Rotation, Vec3};

/// Turn (4), spin (3), the foot's way and slip (2 each), work of friction, spin about the plane's normal.
pub(in crate::spatial) type Vector = [f64; DIMENSIONS];
pub(super) const DIMENSIONS: usize = 13;

/// A step towards the stop of a slip goes this part of the way to where it is foreseen.
const TOWARDS_STOP: f64 = 0.8;
/// Between the nodes of a step angular accelerations are at most this many times those at nodes, and this much more in the world's own units.
const BETWEEN: (f64, f64) = (1.5, 0.1);
/// Places of a step at which angular accelerations are looked at.
const LOOKED_AT: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// A support that carries a sliding body.
#[derive(Clone, Copy, Debug)]
pub(super) struct Carrier {
    pub(in crate::spatial) support: usize,
    pub(in crate::spatial) arm: Vec3,
    pub(in crate::spatial) friction: f64,
    pub(in crate::spatial) sticks: bool,
    /// Where it starts to slip from rest: the direction, world axes.
    pub(super) lead: Vec3,
}

/// A slip, and what friction does to it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slowing {
    pub(in crate::spatial) support: usize,
    pub(in crate::spatial) speed: f64,
    /// Rate of the speed.
    pub(in crate::spatial) change: f64,
    pub(in crate::spatial) friction: f64,
    /// Normal force \[N\].
    pub(in crate::spatial) normal: f64,
    /// The direction across it along the plane, and where its support is from the foot, world axes.
    pub(super) aside: Vec3,
    pub(super) from_foot: Vec3,
}

/// A stretch of motion in which supports slide.
#[derive(Clone, Debug)]
pub(in crate::spatial) struct Sliding {
    body: Body,
    scales: Scales,
    gravity: Vec3,
    pub(in crate::spatial) attitude: Rotation,
    heights: Heights,
    pub(super) carriers: Vec<Carrier>,
    pub(in crate::spatial) foot: Vec3,
    /// Where the foot starts, world axes.
    place: Vec3,
    /// World axes x, y, z in body axes as they were at the start.
    axes: [Vec3; 3],
    /// What the body's normal must keep to, body axes: that of the plane through three supports, or none.
    normal: Option<Vec3>,
    /// The other end of an edge from the foot, body axes.
    edge: Option<Vec3>,
    /// Slips that have been fast enough to be told from those that start.
    grown: Supports,
    /// The largest angular acceleration and spin at the nodes of the present step.
    most: [f64; 2],
}

/// What carries a sliding body, and where slips that are zero start.
#[derive(Clone, Copy, Debug)]
pub(super) struct Carried<'a> {
    pub(in crate::spatial) sticking: Supports,
    pub(in crate::spatial) slipping: Supports,
    pub(super) leads: &'a [(usize, Vec3)],
}

impl Sliding {
    /// The stretch that starts from a state. `None` without friction, and where no support carries the body or more do than [`MOST_BEARING`].
    pub(super) fn from(
        world: &World,
        carried: &Carried<'_>,
        state: &State,
        heights: &Heights,
    ) -> Option<(Self, Vector)> {
        let (body, friction) = (world.body(), world.friction()?);
        let bearing = carried.sticking.union(carried.slipping);
        if bearing.is_empty() || bearing.len() > MOST_BEARING {
            return None;
        }
        let lead = |i: usize| carried.leads.iter().find(|(k, _)| *k == i).map_or(Vec3::ZERO, |(_, e)| *e);
        let carriers: Vec<Carrier> = bearing
            .iter()
            .map(|support| Carrier {
                support,
                arm: body.supports()[support],
                friction: friction.coefficient(support),
                sticks: carried.sticking.contains(support),
                lead: lead(support),
            })
            .collect();
        let velocity = |arm: Vec3| state.velocity + state.attitude.apply(state.spin.cross(arm));
        let speed = |i: &usize| velocity(body.supports()[*i]).norm();
        let speck = SLIP_SPECK * world.scales().speed;
        let slowest = || carried.slipping.iter().min_by(|a, b| speed(a).total_cmp(&speed(b)));
        let foot = body.supports()[carried.sticking.iter().next().or_else(slowest)?];
        let starts = |c: &Carrier| c.lead != Vec3::ZERO && velocity(c.arm).norm() <= speck;
        let grown = carriers.iter().filter(|c| !c.sticks && !starts(c)).map(|c| c.support).collect();
        let rests = carriers.iter().filter(|c| c.sticks || starts(c));
        let (rests, at_rest) = (rests.clone().count(), rests.clone().any(|c| c.arm == foot));
        let slip = if at_rest { Vec3::ZERO } else { velocity(foot) };
        let mode = Mode::holding(body, bearing);
        let edge = match mode {
            Mode::Edge { ends, .. } => {
                let from = |end: usize| body.supports()[end] - foot;
                let [a, b] = ends.map(from);
                Some(if a.norm() > b.norm() { a } else { b })
            }
            _ => None,
        };
        let normal = matches!(mode, Mode::Rest { .. }).then(|| normal_of(body, bearing)).flatten();
        let up = state.up();
        let at = state.place(foot);
        let motion = Self {
            body: body.clone(),
            scales: world.scales(),
            gravity: world.gravity(),
            attitude: state.attitude,
            heights: *heights,
            carriers,
            foot,
            place: Vec3::new(at.x, at.y, 0.0),
            axes: [state.attitude.undo(Vec3::X), state.attitude.undo(Vec3::Y), up],
            normal: normal.map(|n| if n.dot(up) < 0.0 { -n } else { n }),
            edge,
            grown,
            most: [0.0; 2],
        };
        let spin = state.spin;
        // Two points at rest: nothing turns about the normal.
        let yaw = if rests > 1 { 0.0 } else { spin.dot(up) };
        let first = [1.0, 0.0, 0.0, 0.0, spin.x, spin.y, spin.z, 0.0, 0.0, slip.x, slip.y, 0.0, yaw];
        let first = motion.tidied(&first);
        Some((motion, first))
    }

    /// The same, where the slip of a support has come to its end: it is zero. The slower a slip is, the faster friction turns it, so that on its last
    /// way no straight step knows its direction. What such a step leaves across the slip is the error of the integration, however large it is beside
    /// the slip.
    fn stopped(&self, y: &Vector, support: usize) -> Vector {
        let mut out = *y;
        let arm = self.body.supports()[support];
        if self.carriers.iter().any(|c| c.sticks) {
            out[12] = 0.0;
        } else {
            let [east, north, up] = self.moment(y).axes;
            let slip = up.cross(self.foot - arm) * y[12];
            (out[9], out[10]) = (slip.dot(east), slip.dot(north));
        }
        out
    }

    pub(in crate::spatial) fn scales(&self) -> Scales {
        self.scales
    }

    pub(in crate::spatial) fn mass(&self) -> f64 {
        self.body.mass()
    }

    pub(super) fn gravity_size(&self) -> f64 {
        self.gravity.norm()
    }
}

impl Motion for Sliding {
    type Y = Vector;

    fn rate(&self, y: &Vector) -> Vector {
        let now = self.moment(y);
        let Some(reactions) = self.reactions(&now) else { return [f64::NAN; DIMENSIONS] };
        let turning = self.turning(&now, Some(&reactions));
        let [east, north, up] = now.axes;
        let foot = if self.carriers.iter().any(|c| c.sticks) {
            Vec3::ZERO
        } else {
            self.acceleration(&now, &reactions, self.foot)
        };
        let power: f64 = self.carriers.iter().enumerate().fold(0.0, |sum, (k, c)| {
            sum - if c.sticks { 0.0 } else { c.friction * reactions.normals[k] * now.speeds[k] }
        });
        let turned = Rotation { w: y[0], v: Vec3::new(y[1], y[2], y[3]) };
        let [a, b, c, d] = turned.rate(now.spin);
        let Vec3 { x: p, y: q, z: r } = turning;
        [a, b, c, d, p, q, r, y[9], y[10], foot.dot(east), foot.dot(north), power, turning.dot(up)]
    }

    fn tidied(&self, y: &Vector) -> Vector {
        let turned = Rotation { w: y[0], v: Vec3::new(y[1], y[2], y[3]) };
        let mut turned = Rotation::of(turned.to_array()).unwrap_or(turned);
        let mut spin = Vec3::new(y[4], y[5], y[6]);
        let up = turned.undo(self.axes[2]);
        let wanted = match (self.normal, self.edge) {
            (Some(normal), _) => Some(normal),
            (None, Some(edge)) => (up - edge * (up.dot(edge) / edge.dot(edge))).unit(),
            _ => None,
        };
        if let Some(wanted) = wanted {
            let leaned = turned.after(Rotation::by(wanted.cross(up)));
            turned = Rotation::of(leaned.to_array()).unwrap_or(leaned);
            spin = match self.edge {
                Some(edge) => {
                    let rolls = edge.cross(wanted);
                    spin - rolls * (rolls.dot(spin) / rolls.dot(rolls))
                }
                None => wanted * wanted.dot(spin),
            };
        }
        let [w, x, y_, z] = turned.to_array();
        let mut out = *y;
        out[..7].copy_from_slice(&[w, x, y_, z, spin.x, spin.y, spin.z]);
        out
    }

    fn tolerance(&self, y: &Vector, relative: f64, spin: f64) -> Vector {
        let Scales { length, speed, energy, .. } = self.scales;
        let spin = (y[4] * y[4] + y[5] * y[5] + y[6] * y[6]).sqrt().max(spin);
        let fast = (y[9] * y[9] + y[10] * y[10]).sqrt().max(speed);
        let sizes = [1.0, spin, length, fast, energy * (fast / speed) * (fast / speed)];
        let of = [0, 0, 0, 0, 1, 1, 1, 2, 2, 3, 3, 4, 1];
        std::array::from_fn(|i| relative * sizes[of[i]])
    }

    fn longest(&self, y: &Vector, rate: &Vector) -> f64 {
        let stop = |s: Slowing| if s.change < 0.0 { s.speed / -s.change } else { f64::INFINITY };
        TOWARDS_STOP * self.slowing(y, rate).map(stop).filter(|t| *t > 0.0).fold(f64::INFINITY, f64::min)
    }

    fn is_stiff(&self, y: &Vector, rate: &Vector) -> bool {
        self.turns_at_once(y, rate)
    }

    fn stiff_step(
        &self,
        (y, rate): (&Vector, &Vector),
        lengths: (f64, f64),
        tolerance: &Vector,
    ) -> Option<(Step<Vector>, f64)> {
        if self.is_stiff(y, rate) { self.implicit_step((y, rate), lengths, tolerance) } else { None }
    }

    fn stiff_end(&self, step: &Step<Vector>, length: f64) -> Option<Vector> {
        let stiff = self.is_stiff(&step.start, &step.start_rate);
        if stiff { self.implicit_end(&step.start, &step.start_rate, length) } else { None }
    }

    fn stops(&self, y: &Vector, rate: &Vector) -> Option<(f64, Vector)> {
        let small = SLIP_STOPPED * self.scales.speed;
        let stopping = |s: Slowing| {
            let stops = s.speed <= small && s.change < 0.0 && self.grown.contains(s.support);
            stops.then(|| (s.speed / -s.change, s.support))
        };
        let (rest, support) =
            self.slowing(y, rate).filter_map(stopping).min_by(|a, b| a.0.total_cmp(&b.0))?;
        Some((rest, self.stopped(&std::array::from_fn(|i| y[i] + rest * rate[i]), support)))
    }

    fn look(&mut self, step: &Step<Vector>) {
        let grown = |y: &Vector| {
            let fast = |s: &Slowing| s.speed > SLIP_GROWN * self.scales.speed;
            self.slowing(y, &step.end_rate).filter(fast).map(|s| s.support).collect::<Supports>()
        };
        self.grown = self.grown.union(grown(&step.start)).union(grown(&step.end));
        self.most = [0.0; 2];
        for x in LOOKED_AT {
            let at = self.posture(&step.at(x), 0.0);
            self.most = [self.most[0].max(at.turning.norm()), self.most[1].max(at.spin.norm())];
        }
    }

    fn posture(&self, y: &Vector, _: f64) -> Posture {
        let now = self.moment(y);
        let reactions = self.reactions(&now);
        let turning = self.turning(&now, reactions.as_ref());
        let (up_then, up, base) = (self.axes[2], now.axes[2], Height::default());
        Posture { turned: now.turned, up_then, up, spin: now.spin, turning, from: self.foot, base }
    }

    fn state(&self, y: &Vector, _: f64) -> State {
        let now = self.moment(y);
        let whole = self.attitude.after(now.turned);
        let attitude = Rotation::of(whole.to_array()).unwrap_or(whole);
        let slip = Vec3::new(y[9], y[10], 0.0);
        State {
            centre: self.place + Vec3::new(y[7], y[8], 0.0) - attitude.apply(self.foot),
            attitude,
            velocity: slip + attitude.apply(self.foot.cross(now.spin)),
            spin: now.spin,
        }
    }

    fn height(&self, world: &World, support: usize, at: &Posture) -> Height {
        at.height(world.body().supports()[support], self.heights[support])
    }

    fn bend(&self, _: &Posture, arm: Vec3, _: f64) -> f64 {
        let (times, more) = BETWEEN;
        let unit = self.scales.time;
        let turning = times * self.most[0] + more / (unit * unit);
        let spin = times * self.most[1] + more / unit;
        (arm - self.foot).norm() * (turning + spin * spin)
    }

    fn smooth_events(&self) -> Vec<Event> {
        let lets = self.carriers.iter().enumerate();
        let mut events: Vec<Event> =
            lets.map(|(place, c)| Event::Lets { support: c.support, place }).collect();
        let slips = self.carriers.iter().filter(|c| c.sticks).map(|c| Event::Slips(c.support));
        events.extend(slips);
        if self.carriers.len() == 1 {
            events.push(Event::Jams);
        }
        events
    }

    fn value(&self, event: &Event, y: &Vector, _: &Posture) -> f64 {
        let now = self.moment(y);
        let Some(reactions) = self.reactions(&now) else { return f64::NAN };
        match *event {
            // One support that slides is left to itself where its force turns; where it grows without bound instead, the force has the sign of its regularity.
            Event::Lets { place, .. } if self.carriers.len() == 1 => {
                reactions.normals[place] * reactions.regularity
            }
            Event::Lets { place, .. } => reactions.normals[place],
            Event::Slips(support) => {
                let Some(k) = self.carriers.iter().position(|c| c.support == support) else {
                    return f64::INFINITY;
                };
                let normal = reactions.normals[k];
                let across = reactions.forces[k] - now.axes[2] * normal;
                let most = self.carriers[k].friction * normal;
                most * most - across.dot(across)
            }
            Event::Jams => reactions.regularity,
            _ => f64::INFINITY,
        }
    }

    fn leans_over(&self) -> Option<Vec3> {
        match (self.normal, self.edge) {
            (Some(_), _) => None,
            (None, edge) => Some(edge.and_then(Vec3::unit).unwrap_or(Vec3::ZERO)),
        }
    }

    fn work(&self, y: &Vector) -> f64 {
        y[11]
    }
}
