//! Generalised forces at contacts, and what they do to the bodies.

use super::mode::Acceleration;
use crate::planar::contact::{
    World,
    kinematics::{Kinematics, Pairing},
};
use crate::planar::geometry::Body;
use carom_num::Vec2;

/// A direction at a contact, for a unit force along it or a velocity along it: the body has the force as it is, and the other one its reaction.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::planar) struct Line {
    pub(in crate::planar) direction: Vec2,
    /// Moment about the body's mass centre.
    pub(in crate::planar) moment: f64,
    body: usize,
    /// The other body, and the moment about its mass centre of what it takes.
    other: Option<(usize, f64)>,
}

impl Line {
    /// On a lone body.
    pub(in crate::planar) fn alone(k: &Kinematics, direction: Vec2) -> Self {
        Self { direction, moment: k.arm.cross(direction), body: 0, other: None }
    }

    /// The bodies it acts on: number, sign of the direction, moment.
    fn ends(&self) -> impl Iterator<Item = (usize, f64, f64)> {
        let other = self.other.map(|(body, moment)| (body, -1.0, moment));
        std::iter::once((self.body, 1.0, self.moment)).chain(other)
    }
}

/// What a unit force and a unit moment about the mass centre do to a body [1/kg, 1/(kg m²)].
#[derive(Clone, Copy)]
pub(in crate::planar) struct Mobility {
    pub(in crate::planar) linear: f64,
    pub(in crate::planar) angular: f64,
}

impl Mobility {
    pub(in crate::planar) fn of(body: &Body) -> Self {
        Self { linear: 1.0 / body.mass, angular: 1.0 / body.inertia }
    }

    /// Acceleration along `row` that a unit force along `force` causes, both on this body.
    pub(super) fn response(self, row: &Line, force: &Line) -> f64 {
        row.direction.dot(force.direction) * self.linear + row.moment * force.moment * self.angular
    }
}

impl World {
    /// A line through a pair's contact.
    pub(in crate::planar) fn line(&self, k: &Kinematics, pair: Pairing, direction: Vec2) -> Line {
        let other = self.other_body(pair).map(|b| (b, -k.other_arm.cross(direction)));
        Line { direction, moment: k.arm.cross(direction), body: pair.body, other }
    }

    /// Acceleration along `row` that a unit force along `force` causes.
    pub(in crate::planar) fn response(&self, row: &Line, force: &Line) -> f64 {
        if let [body] = &self.bodies[..] {
            return Mobility::of(body).response(row, force);
        }
        let mut sum = 0.0;
        for (i, sign, moment) in row.ends() {
            for (j, against, lever) in force.ends().filter(|f| f.0 == i) {
                let mobility = Mobility::of(&self.bodies[j]);
                sum += sign * against * row.direction.dot(force.direction) * mobility.linear
                    + moment * lever * mobility.angular;
            }
        }
        sum
    }

    /// The motions that a unit force along `line` makes: for each body that it acts on, its number and the change of its velocity and of its spin.
    pub(in crate::planar) fn motion_along(&self, line: &Line) -> impl Iterator<Item = (usize, Vec2, f64)> {
        line.ends().map(|(b, sign, moment)| {
            let body = &self.bodies[b];
            (b, line.direction * (sign / body.mass), moment / body.inertia)
        })
    }

    /// The rate along `line` of bodies that move so.
    pub(in crate::planar) fn rate_along(&self, line: &Line, motion: &[(Vec2, f64)]) -> f64 {
        let of = |(b, sign, moment): (usize, f64, f64)| {
            sign * line.direction.dot(motion[b].0) + moment * motion[b].1
        };
        line.ends().map(of).sum()
    }

    /// The bodies that a force at a pair's contact acts on: number, arm, force.
    pub(super) fn acts_on(
        &self,
        pair: Pairing,
        k: &Kinematics,
        force: Vec2,
    ) -> impl Iterator<Item = (usize, Vec2, Vec2)> + use<> {
        let other = self.other_body(pair).map(|b| (b, k.other_arm, -force));
        std::iter::once((pair.body, k.arm, force)).chain(other)
    }

    /// Second rate of a pair's gap under these accelerations [m/s²].
    pub(in crate::planar) fn gap_bend(
        &self,
        k: &Kinematics,
        pair: Pairing,
        accelerations: &[Acceleration],
    ) -> f64 {
        k.normal_bias + self.acceleration_along(k, pair, k.normal, accelerations)
    }

    /// Acceleration of a pair's contact point along a direction, relative to what it touches [m/s²]; the turning terms are not in it.
    pub(super) fn acceleration_along(
        &self,
        k: &Kinematics,
        pair: Pairing,
        direction: Vec2,
        accelerations: &[Acceleration],
    ) -> f64 {
        let of = |a: &Acceleration, arm: Vec2| direction.dot(a.linear) + arm.cross(direction) * a.angular;
        let other = self.other_body(pair).map_or(0.0, |b| of(&accelerations[b], k.other_arm));
        of(&accelerations[pair.body], k.arm) - other
    }
}
