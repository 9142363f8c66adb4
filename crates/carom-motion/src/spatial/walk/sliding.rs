//! A body some of whose supports slide: its equations.
//!
//! The *foot* is the support that sticks or, where none does, the slowest. What is integrated is the turn since the stretch began, the spin (body axes), how far
//! the foot has gone and its slip (along the tangents of its plane), the work of friction, and the spin about that plane's normal once more. The slip and that
//! spin are what all slips on that plane are made of: integrated by themselves they keep their digits where slips come to zero, and where they start.
//!
//! Where edges cross, or a face is on a corner, the normal of the foot turns: its slip is then one of three dimensions along the world's axes, and the way is that of the mass centre.

use crate::tolerance::{SHORTEST_SPATIAL_STEP, SLIP_GROWN, SLIP_STOPPED};
pub(in crate::spatial) mod carriers;
mod events;
mod load;
pub(in crate::spatial) mod moment;
mod projection;
mod start;

use self::carriers::Carrier;
use self::moment::Moment;
use super::motion::{Event, Motion};
use crate::spatial::geometry::body::Body;
use crate::spatial::geometry::feature::Feature;
use crate::spatial::geometry::posture::{Bend, Height, Most, Moving, Posture, Upright};
use crate::spatial::geometry::state::{Pose, State};
use crate::spatial::geometry::supports::Supports;
use crate::spatial::geometry::world::{Scales, Support, World};
use crate::spatial::modes::grip::Reactions;
use crate::spatial::modes::stretch::Heights;
use carom_num::ode8::Step;
use carom_num::{Rotation, Vec3};
use std::cell::OnceCell;

/// Turn (4), spin (3), the foot's way and slip (3 each), work of friction, spin about the plane's normal.
pub(in crate::spatial) type Vector = [f64; DIMENSIONS];
pub(super) const DIMENSIONS: usize = 15;
/// Where in it the way, the slip, the work and the spin about the normal are.
pub(super) const WAY: usize = 7;
pub(super) const SLIP: usize = 10;
pub(super) const WORK: usize = 13;
pub(super) const YAW: usize = 14;

/// A step towards the stop of a slip goes this part of the way to where it is foreseen.
const TOWARDS_STOP: f64 = 0.8;
/// Between the nodes of a step angular accelerations are at most this many times those at nodes, and this much more in the world's own units.
const BETWEEN: (f64, f64) = (1.5, 0.1);

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
    /// The direction across it along the plane, and where its support is from the foot, body axes.
    pub(super) aside: Vec3,
    pub(super) from_foot: Vec3,
}

/// A stretch of motion in which supports slide.
#[derive(Clone, Debug)]
pub(in crate::spatial) struct Sliding<'w> {
    world: &'w World,
    pub(super) body: &'w Body,
    scales: Scales,
    /// Gravity along the tangents and the normal of the foot's plane.
    gravity: Vec3,
    pub(in crate::spatial) attitude: Rotation,
    heights: Heights,
    planes: Vec<Upright>,
    pub(super) carriers: Vec<Carrier>,
    pub(in crate::spatial) foot: Feature,
    /// The foot's plane; none where it is no point of the body on a face.
    plane: Option<usize>,
    /// The foot, where it is one of those.
    pair: Option<usize>,
    /// One of the carriers is.
    paired: bool,
    /// Directions in which the foot may move: two along its plane, or three.
    ways: usize,
    /// Where the foot starts, world axes.
    place: Vec3,
    /// The tangents and the normal of the foot's plane: world axes, and in body axes as they were at the start.
    pub(super) frame: [Vec3; 3],
    axes: [Vec3; 3],
    /// The carriers are on several planes.
    pub(super) apart: bool,
    /// They are, and forces of theirs can balance each other.
    redundant: bool,
    /// Their places move against each other: supports that hold more than they must agree only as far as the integration is exact.
    loose: bool,
    /// What the normal of the one plane must keep to, body axes: that of the plane through three supports, or none.
    normal: Option<Vec3>,
    /// The other end of an edge from the foot, body axes.
    edge: Option<Vec3>,
    /// A slip that starts is zero below this \[m/s\].
    pub(super) speck: f64,
    /// Slips that have been fast enough to be told from those that start.
    grown: Supports,
    /// The largest angular acceleration, spin and acceleration of the foot at the nodes of the present step.
    most: [f64; 3],
}

/// The body at an instant, the forces on it, and where it is once that is asked.
pub(in crate::spatial) struct Known {
    pub(super) now: Moment,
    pub(super) reactions: Option<Reactions>,
    pub(super) pose: OnceCell<Pose>,
}

impl Sliding<'_> {
    /// The same, where the slip of a support has come to its end: it is zero. The slower a slip is, the faster friction turns it, so that on its last
    /// way no straight step knows its direction. What such a step leaves across the slip is the error of the integration, however large it is beside
    /// the slip.
    fn stopped(&self, y: &Vector, support: usize) -> Vector {
        if self.apart {
            return self.projected(y, Supports::one(support));
        }
        let mut out = *y;
        let point =
            self.carriers.iter().find(|c| c.support == support).map_or(self.foot.point, |c| c.feature.point);
        if self.carriers.iter().any(|c| c.sticks) {
            out[YAW] = 0.0;
        } else {
            let [east, north, up] = self.moment(y).axes;
            let slip = up.cross(self.foot.point - point) * y[YAW];
            (out[SLIP], out[SLIP + 1]) = (slip.dot(east), slip.dot(north));
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

impl Motion for Sliding<'_> {
    type Y = Vector;
    type Known = Known;

    fn rate(&self, y: &Vector) -> Vector {
        let now = self.moment(y);
        let Some(reactions) = self.reactions(&now) else { return [f64::NAN; DIMENSIONS] };
        let turning = self.turning(&now, Some(&reactions));
        let foot = self.foot_acceleration(&now, &reactions);
        let power: f64 = self.carriers.iter().enumerate().fold(0.0, |sum, (k, c)| {
            sum - if c.sticks { 0.0 } else { c.friction * reactions.normals[k] * now.speeds[k] }
        });
        let turned = Rotation { w: y[0], v: Vec3::new(y[1], y[2], y[3]) };
        let [a, b, c, d] = turned.rate(now.spin);
        let Vec3 { x: p, y: q, z: r } = turning;
        let rolled = self.rolled(&now);
        let mut rates = [0.0; DIMENSIONS];
        rates[..WAY].copy_from_slice(&[a, b, c, d, p, q, r]);
        for k in 0..self.ways {
            rates[WAY + k] = y[SLIP + k] + rolled.dot(now.axes[k]);
            rates[SLIP + k] = foot.dot(now.axes[k]);
        }
        (rates[WORK], rates[YAW]) = (power, turning.dot(now.axes[2]));
        rates
    }

    fn tidied(&self, y: &Vector) -> Vector {
        if self.apart {
            return self.projected(y, Supports::NONE);
        }
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
        let fast = self.in_world(y, SLIP).norm().max(speed);
        let sizes = [1.0, spin, length, fast, energy * (fast / speed) * (fast / speed)];
        let of = [0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 1];
        std::array::from_fn(|i| relative * sizes[of[i]])
    }

    fn longest(&self, y: &Vector, rate: &Vector) -> f64 {
        let stop = |s: Slowing| if s.change < 0.0 { s.speed / -s.change } else { f64::INFINITY };
        let stop = self.slowing(y, rate).map(stop).filter(|t| *t > 0.0).fold(f64::INFINITY, f64::min);
        TOWARDS_STOP * stop.min(self.flat_in(y))
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
        // A force without bound stops it sooner than a step can be made.
        let soon = SHORTEST_SPATIAL_STEP * self.scales.time / (1.0 - TOWARDS_STOP);
        let stopping = |s: Slowing| {
            let comes = s.speed <= small || s.speed <= -s.change * soon;
            let stops = comes && s.change < 0.0 && self.grown.contains(s.support);
            stops.then(|| (s.speed / -s.change, s.support))
        };
        let (rest, support) =
            self.slowing(y, rate).filter_map(stopping).min_by(|a, b| a.0.total_cmp(&b.0))?;
        Some((rest, self.stopped(&std::array::from_fn(|i| y[i] + rest * rate[i]), support)))
    }

    const LOOKED_AT: &'static [f64] = &[0.0, 0.25, 0.5, 0.75, 1.0];

    fn look(&mut self, step: &Step<Vector>, at: &[Posture]) {
        let grown = |y: &Vector| {
            let fast = |s: &Slowing| s.speed > SLIP_GROWN * self.scales.speed;
            self.slowing(y, &step.end_rate).filter(fast).map(|s| s.support).collect::<Supports>()
        };
        self.grown = self.grown.union(grown(&step.start)).union(grown(&step.end));
        self.most = [0.0; 3];
        for at in at {
            for (most, v) in self.most.iter_mut().zip([at.turning, at.spin, at.base[2]]) {
                *most = most.max(v.norm());
            }
        }
    }

    fn known(&self, y: &Vector) -> Known {
        let now = self.moment(y);
        let reactions = self.reactions(&now);
        Known { now, reactions, pose: OnceCell::new() }
    }

    fn posture_at(&self, y: &Vector, _: f64, Known { now, reactions, .. }: &Known) -> Posture {
        self.posture_of(y, now, reactions.as_ref())
    }

    fn state(&self, y: &Vector, _: f64) -> State {
        let now = self.moment(y);
        let Pose { centre, attitude } = self.pose(y, now.turned, now.spin);
        let velocity = self.in_world(y, SLIP) + attitude.apply(now.foot.cross(now.spin));
        State { centre, attitude, velocity, spin: now.spin }
    }

    fn moving(&self, at: &Posture) -> Moving {
        at.moving(self.attitude, self.place)
    }

    fn most(&self, _: &Posture, _: f64) -> Most {
        let (times, more) = BETWEEN;
        let unit = self.scales.time;
        let turning = times * self.most[0] + more / (unit * unit);
        let spin = times * self.most[1] + more / unit;
        let foot = times * self.most[2] + more * self.scales.length / (unit * unit);
        Most { spin, turning, acceleration: foot + self.foot.point.norm() * (turning + spin * spin) }
    }

    fn height(&self, world: &World, support: usize, at: &Posture) -> Height {
        let (plane, start) = (world.plane_of(support), self.heights[support]);
        let feature = world.support(support).feature;
        if Some(plane) == self.plane {
            // The foot goes along it.
            let base = self.raised(at.turned, at.spin, at.turning);
            return Posture { base, ..*at }.height(&self.planes[plane], feature, start);
        }
        at.height(&self.planes[plane], feature, start)
    }

    fn bend(&self, world: &World, support: usize, at: &Posture, time: f64) -> Bend {
        let Support { feature, plane } = world.support(support);
        let (times, more) = BETWEEN;
        let unit = self.scales.time;
        let Most { spin, turning, .. } = self.most(at, time);
        let own = if plane.normal() == self.frame[2] {
            0.0
        } else {
            times * self.most[2] + more * self.scales.length / (unit * unit)
        };
        let own = own + (feature.point - self.foot.point).norm() * (turning + spin * spin);
        // The foot's centre rises by as much as a circle of it is lifted.
        let of = |feature: &Feature, up: Vec3| feature.bend([up, at.spin], [spin, turning], time);
        let (foot, other) =
            (of(&self.foot, at.up), of(feature, at.turned.undo(self.planes[world.plane_of(support)].then)));
        Bend::own(own).and(foot).and(other)
    }

    fn smooth_events(&self) -> Vec<Event> {
        self.events()
    }

    fn value(&self, event: &Event, y: &Vector, _: &Posture, known: &Known) -> f64 {
        self.event_value(event, y, known)
    }

    fn leans_over(&self) -> Option<Vec3> {
        match (self.normal, self.edge) {
            _ if self.apart => None,
            (Some(_), _) => None,
            (None, edge) => Some(edge.and_then(Vec3::unit).unwrap_or(Vec3::ZERO)),
        }
    }

    fn work(&self, y: &Vector) -> f64 {
        y[WORK]
    }
}
