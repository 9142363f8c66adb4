//! How far two moving bodies are apart, for how long they certainly stay so, and when they meet.
//!
//! The same march as towards an obstacle: two convex sets are apart where some axis separates them, and along each axis a parabola bounds
//! the gap from below. Axes turn with the bodies' faces, or stand in the line between two vertices.

use crate::evaluated::{Quantity, evaluated};
use crate::planar::contact::{
    World,
    clearance::{Exactness, Moves},
    kinematics::{Pairing, Turn},
    touching::Few,
    world::Scales,
};
use crate::planar::geometry::{Shape, State};
use crate::planar::walk::flight::{Known, MOST_STEPS, falling_root, growth};
use crate::tolerance::{
    INSTANT, LEAST_ACCELERATION, MET_GAP, MOMENT, NEWTON_ASTRAY, NEWTON_DONE, SIGNIFICANT_RATE,
    STEP_PAST_TOUCH,
};
use carom_num::Vec2;
use carom_num::poly::NODES;
use carom_num::poly::first_root;

/// The two bodies in an instant.
struct Two<'a> {
    world: &'a World,
    /// Convex shapes around them.
    shapes: [&'a Shape; 2],
    states: [State; 2],
    turns: [Turn; 2],
}

/// Distance along the best axis [m], and a time for which no overlap becomes deeper than is allowed [s].
#[derive(Clone, Copy, Debug)]
struct Apart {
    pub(in crate::planar) distance: f64,
    pub(in crate::planar) safe: f64,
}

impl Apart {
    fn take(&mut self, axis: Apart, allowance: f64) {
        self.distance = self.distance.max(axis.distance);
        if axis.distance > -allowance {
            self.safe = self.safe.max(axis.safe);
        }
    }
}

impl Two<'_> {
    fn vertices(&self, side: usize) -> impl Iterator<Item = Vec2> {
        let turn = self.turns[side];
        self.shapes[side].vertices().iter().map(move |v| turn.apply(*v))
    }

    /// From the mass centre of `from` to that of the other.
    fn between(&self, from: usize) -> Vec2 {
        self.states[1 - from].pose.centre - self.states[from].pose.centre
    }

    fn closing(&self, from: usize) -> Vec2 {
        self.states[1 - from].twist.velocity - self.states[from].twist.velocity
    }

    fn radii(&self) -> f64 {
        self.shapes[0].skin(0) + self.shapes[1].skin(0)
    }

    fn apart(&self, bounds: &Moves, allowance: f64) -> Apart {
        let mut best = Apart { distance: f64::NEG_INFINITY, safe: 0.0 };
        for side in [0, 1] {
            for face in 0..self.shapes[side].faces() {
                best.take(self.along_face(side, face, bounds, allowance), allowance);
            }
        }
        if best.distance <= 0.0 || self.radii() > 0.0 {
            for a in self.vertices(0) {
                for b in self.vertices(1) {
                    if let Some(axis) = (self.between(0) + b - a).unit() {
                        best.take(self.along_line(axis, bounds, allowance), allowance);
                    }
                }
            }
        }
        let meeting = (0, self.world.obstacles.len() + 1);
        if !self.world.are_hulls(meeting) && best.safe < bounds.horizon.max(f64::MIN_POSITIVE) {
            best.take(self.by_features(meeting, bounds, allowance), allowance);
        }
        Apart { safe: best.safe.min(bounds.horizon), distance: evaluated(Quantity::Distance, best.distance) }
    }

    /// By the features themselves, one pair after the other: no axis parts what lies in a hollow.
    fn by_features(&self, meeting: (usize, usize), bounds: &Moves, allowance: f64) -> Apart {
        let exact = MET_GAP * self.shapes[0].size();
        let mut out = Apart { distance: f64::INFINITY, safe: bounds.horizon };
        self.world.each_pair(meeting, |pair| {
            let posed = (&self.states[..], &self.turns[..]);
            let clear = self.world.clearance_of(posed, pair, bounds, Exactness { allowance, exact });
            (out.distance, out.safe) = (out.distance.min(clear.distance), out.safe.min(clear.safe));
        });
        Apart { distance: out.distance - allowance, ..out }
    }

    /// Along the normal of a face, which turns with its body.
    fn along_face(&self, side: usize, face: usize, bounds: &Moves, allowance: f64) -> Apart {
        let (shape, other) = (self.shapes[side], 1 - side);
        let support = shape.face_normal(face).dot(shape.vertices()[face]) + self.radii();
        let axis = self.turns[side].apply(shape.face_normal(face));
        let (spin, turning) = (self.states[side].twist.spin, self.states[other].twist.spin);
        let (mut distance, mut safe) = (f64::INFINITY, f64::INFINITY);
        for q in self.vertices(other) {
            let d = self.between(side) + q;
            let gap = axis.dot(d) - support;
            distance = distance.min(gap);
            let rate =
                axis.dot(self.closing(side) + q.turned_left() * turning) + spin * axis.turned_left().dot(d);
            let (w, speed) = (bounds.spin[side], bounds.speed + bounds.spin[other] * q.norm());
            let reach = d.norm() + speed * bounds.horizon;
            let bend = bounds.acceleration
                + (bounds.angular[other] + bounds.spin[other] * bounds.spin[other]) * q.norm()
                + (bounds.angular[side] + w * w) * reach
                + 2.0 * w * speed;
            safe = safe.min(first_root((gap + allowance).max(0.0), rate, bend));
        }
        Apart { distance, safe }
    }

    /// Along an axis that stands still, from the first body to the second.
    fn along_line(&self, axis: Vec2, bounds: &Moves, allowance: f64) -> Apart {
        let (mut distance, mut safe) = (f64::INFINITY, f64::INFINITY);
        let [wa, wb] = [self.states[0].twist.spin, self.states[1].twist.spin];
        for a in self.vertices(0) {
            for b in self.vertices(1) {
                let gap = axis.dot(self.between(0) + b - a) - self.radii();
                distance = distance.min(gap);
                let rate = axis.dot(self.closing(0) + b.turned_left() * wb - a.turned_left() * wa);
                let swing = |side: usize, r: Vec2| {
                    (bounds.angular[side] + bounds.spin[side] * bounds.spin[side]) * r.norm()
                };
                let bend = bounds.acceleration + swing(0, a) + swing(1, b);
                safe = safe.min(first_root((gap + allowance).max(0.0), rate, bend));
            }
        }
        Apart { distance, safe }
    }
}

/// Two bodies of a world and where they are at any time of a stretch.
pub(super) struct Approach<'a, F: Fn(f64) -> [State; 2]> {
    /// A world of these two bodies alone.
    pub(super) world: &'a World,
    pub(super) scales: Scales,
    pub(super) at: F,
    /// They have just parted: what touches at the start has opened.
    pub(super) parting: bool,
}

impl<F: Fn(f64) -> [State; 2]> Approach<'_, F> {
    /// When they meet between two times, and with which features, first body first; the motion between is smooth.
    pub(super) fn first_meeting(&self, (from, until): (f64, f64)) -> Option<(f64, Pairing)> {
        let (met, meeting) = (MET_GAP * self.scales.length, (0, self.world.obstacles.len() + 1));
        let known = Known {
            departing: &Few::default(),
            sides: &[],
            scales: self.scales,
            significant: SIGNIFICANT_RATE,
        };
        let mut bounds = self.bounds(from, until);
        let mut t = from;
        for steps in 0.. {
            if t >= until {
                return None;
            }
            let lengthened = self.scales.time * growth(steps);
            bounds.horizon = until - t;
            let two = self.two(t);
            let apart = two.apart(&bounds, 0.0);
            if apart.distance > met {
                t += apart.safe.max(INSTANT * lengthened);
                continue;
            }
            if steps > MOST_STEPS
                && let Some(pair) = self.world.nearest(&two.states, meeting, None)
            {
                return Some((t, pair));
            }
            if !(self.parting && steps == 0) {
                let closing = self.world.closing(&two.states, meeting, &known);
                if let Some(pair) = closing.iter().next() {
                    return Some((self.polished(*pair, t, from), *pair));
                }
            }
            // What opens, or grazes, is left alone for as long as nothing overlaps by more than counts as met.
            let free = two.apart(&bounds, 2.0 * met + (-apart.distance).max(0.0));
            t += free.safe.max(STEP_PAST_TOUCH * lengthened);
        }
        None
    }

    /// Newton on the pair's own gap, with its second rate from a difference: near the top of a short hop the first alone overshoots.
    fn polished(&self, pair: Pairing, near: f64, from: f64) -> f64 {
        let of = |t: f64| self.world.kinematics(&(self.at)(t), pair);
        let mut t = near;
        for _ in 0..8 {
            let (k, h) = (of(t), MOMENT * self.scales.time);
            let step = falling_root(k.gap, k.approach, (k.approach - of(t - h).approach) / h);
            if !step.is_finite() || step.abs() > NEWTON_ASTRAY * self.scales.time {
                break;
            }
            t += step;
            if step.abs() <= NEWTON_DONE * self.scales.time {
                break;
            }
        }
        // Of a hop so short that rounding is as long, the end counts, not the start.
        if t >= from && of(t).approach < 0.0 { t } else { near }
    }

    /// How far apart they are [m]; negative where they overlap.
    pub(super) fn distance(&self, time: f64) -> f64 {
        self.two(time).apart(&Moves::default(), 0.0).distance
    }

    fn two(&self, time: f64) -> Two<'_> {
        let states = (self.at)(time);
        let shapes = [0, 1].map(|b: usize| self.world.bodies[b].shape.hull());
        Two { world: self.world, shapes, states, turns: [Turn::of(&states[0]), Turn::of(&states[1])] }
    }

    /// Bounds from the velocities at nodes of the stretch: what lies between the nodes is taken to differ from them at most as much as they
    /// differ from each other.
    fn bounds(&self, from: f64, until: f64) -> Moves {
        let length = until - from;
        let nodes = NODES.map(|x| (self.at)(from + x * length));
        let mut out = Moves { horizon: length, ..Moves::default() };
        let (mut linear, mut angular) = ([Vec2::ZERO; 4], [[0.0; 2]; 4]);
        for i in 0..4 {
            let span = (NODES[i + 1] - NODES[i]) * length;
            let (a, b) = (&nodes[i], &nodes[i + 1]);
            let gained = |side: usize| b[side].twist.velocity - a[side].twist.velocity;
            linear[i] = (gained(1) - gained(0)) / span;
            angular[i] = [0, 1].map(|side| (b[side].twist.spin - a[side].twist.spin) / span);
        }
        let steepest = |of: &dyn Fn(usize) -> f64, between: &dyn Fn(usize) -> f64| {
            let most = (0..4).map(of).fold(0.0, f64::max);
            most + 2.0 * (0..3).map(between).fold(0.0, f64::max)
        };
        let floor = LEAST_ACCELERATION * self.scales.length / (self.scales.time * self.scales.time);
        out.acceleration = floor + steepest(&|i| linear[i].norm(), &|i| (linear[i + 1] - linear[i]).norm());
        for side in [0, 1] {
            out.angular[side] = floor / self.scales.length
                + steepest(&|i| angular[i][side].abs(), &|i| (angular[i + 1][side] - angular[i][side]).abs());
            let spin = nodes.iter().map(|n| n[side].twist.spin.abs()).fold(0.0, f64::max);
            out.spin[side] = spin + out.angular[side] * 0.5 * length;
        }
        let speed = nodes.iter().map(|n| (n[1].twist.velocity - n[0].twist.velocity).norm());
        out.speed = speed.fold(0.0, f64::max) + out.acceleration * 0.5 * length;
        out
    }
}
