//! The event functions of a mode as series, and where one of them falls first.

use super::expansion::{Expansion, Spreads};
use crate::planar::contact::{
    World,
    kinematics::{Pairing, Turn},
    world::Scales,
};
use crate::planar::geometry::Feature;
use crate::planar::modes::watch::{Watch, Watched};
use crate::tolerance::LEAVES_DOWNWARD;
use carom_impact::planar::Slip;
use carom_num::Vec2;
use carom_num::taylor::{INVERSE, first_fall, spread};

impl<const P: usize> Expansion<P> {
    /// True where an event function stays above zero, as the spreads of what it is made of show at once.
    pub(super) fn stays(&self, world: &World, watched: &Watched, spreads: &Spreads) -> bool {
        if watched.leaving.is_some() || watched.slack != 0.0 {
            return false;
        }
        let given = &self.given;
        let (value, change) = match watched.what {
            Watch::Force(_) => (self.force[0], spreads.force),
            Watch::Slip(_) => (self.slip[0].abs(), spreads.slip),
            Watch::Cone(_, forward) => {
                let friction = world.surface(given.held.pair).friction;
                let sign = if forward { -1.0 } else { 1.0 };
                let change = friction * spreads.force + spreads.friction;
                (friction * self.force[0] + sign * self.friction[0], change)
            }
            Watch::Extent(_, slot) => {
                match world.room(&[given.start], &[given.turn], given.held.pair, slot) {
                    Some(room) => (room, spreads.way),
                    None => return false,
                }
            }
            Watch::Parallel(_, slot) => {
                let (here, quarter) = self.stand_off(world, slot);
                (here, here.abs() * spreads.cos + quarter.abs() * spreads.sin)
            }
            Watch::Regular => self.response_at_start(spreads),
            Watch::Gap(_) | Watch::Holds => return false,
        };
        value > change
    }

    /// Normal acceleration per normal force of a contact that slides, and a bound on how far it changes.
    fn response_at_start(&self, spreads: &Spreads) -> (f64, f64) {
        let given = &self.given;
        let (along, across) = if given.by_vertex() {
            let turned = |a: f64, b: f64| a.abs() * spreads.cos + b.abs() * spreads.sin;
            (turned(given.arm.x, given.arm.y), turned(given.arm.y, given.arm.x))
        } else {
            (spreads.way, 0.0)
        };
        let lever = given.per_inertia * (along + given.pull.abs() * across);
        let change = self.along[0].abs() * lever + (self.lever[0].abs() + lever) * along;
        (given.per_mass + self.along[0] * self.lever[0], change)
    }

    /// Sine of the angle between a face and what is touched: its parts that go with the cosine and with the sine of the turn.
    fn stand_off(&self, world: &World, slot: usize) -> (f64, f64) {
        // It is linear in the direction of the body: a value here, one a quarter turn on.
        let Turn { cos, sin } = self.given.turn;
        let of = |turn| world.parallel(&[turn], self.given.held.pair, slot);
        (of(self.given.turn), of(Turn { cos: -sin, sin: cos }))
    }

    /// Where an event function falls through zero first, within `length` [s] of the step that starts now.
    pub(super) fn fall(
        &self,
        (world, scales): (&World, &Scales),
        watched: &Watched,
        (now, length): (f64, f64),
    ) -> Option<f64> {
        let mut a = self.quantity(world, scales, &watched.what)?;
        let Some(leaving) = watched.leaving else {
            a[0] += watched.slack;
            return first_fall(&a, length);
        };
        a[0] -= leaving.offset;
        if now > leaving.since {
            return first_fall(&a, length);
        }
        // It leaves zero here: the orders that vanish are divided out.
        let order = usize::try_from(leaving.order).unwrap_or(0).min(P - 1);
        a.rotate_left(order);
        a[P - order..].fill(0.0);
        if a[0] < 0.0 {
            if a[0] < -LEAVES_DOWNWARD * (spread(&a, length) - a[0]) {
                return Some(0.0);
            }
            a[0] = 0.0;
        }
        first_fall(&a, length)
    }

    /// An event function in the world's own units; `None` where it is not one of a lone contact.
    pub(super) fn quantity(&self, world: &World, scales: &Scales, what: &Watch) -> Option<[f64; P]> {
        let given = &self.given;
        let weight = given.mass * scales.speed * scales.speed / scales.length;
        Some(match *what {
            Watch::Force(_) => self.force.map(|n| n / weight),
            Watch::Slip(_) if self.given.held.slip == Slip::Backward => self.slip.map(|u| -u / scales.speed),
            Watch::Slip(_) => self.slip.map(|u| u / scales.speed),
            Watch::Cone(_, forward) => {
                let friction = world.surface(self.given.held.pair).friction;
                let sign = if forward { -1.0 } else { 1.0 };
                std::array::from_fn(|i| (friction * self.force[i] + sign * self.friction[i]) / weight)
            }
            Watch::Extent(_, slot) => self.room(world, slot)?.map(|room| room / scales.length),
            Watch::Parallel(_, slot) => {
                let (here, quarter) = self.stand_off(world, slot);
                std::array::from_fn(|i| here * self.cos[i] + quarter * self.sin[i])
            }
            Watch::Gap(pair) => self.gap(world, pair)?.map(|gap| gap / scales.length),
            Watch::Regular => {
                let mut response = product(&self.along, &self.lever).map(|r| given.mass * r);
                response[0] += 1.0;
                response
            }
            Watch::Holds => return None,
        })
    }

    /// Distance inside one end of the features' extent [m].
    fn room(&self, world: &World, slot: usize) -> Option<[f64; P]> {
        let (pair, given) = (self.given.held.pair, &self.given);
        let from_start = world.room(&[given.start], &[given.turn], pair, 0)?;
        let whole = from_start + world.room(&[given.start], &[given.turn], pair, 1)?;
        let mut room = if given.by_vertex() {
            // A face runs against the tangent of what touches it.
            self.vertex_way().map(|way| -way)
        } else {
            self.along
        };
        room[0] = from_start;
        match slot {
            0 => {}
            1 => {
                room = room.map(|s| -s);
                room[0] += whole;
            }
            _ => return None,
        }
        Some(room)
    }

    /// How far the vertex in touch has come along the tangent since the start [m].
    fn vertex_way(&self) -> [f64; P] {
        let radius = self.given.radius;
        std::array::from_fn(|i| match i {
            0 => 0.0,
            _ => (self.slip[i - 1] - radius * self.spin[i - 1]) * INVERSE[i - 1],
        })
    }

    /// How far the mass centre has come since the start, in the contact's frame there [m].
    fn centre_way(&self) -> ([f64; P], [f64; P]) {
        let arm = self.given.arm;
        let (mut along, mut across) = ([0.0; P], [0.0; P]);
        if self.given.by_vertex() {
            let way = self.vertex_way();
            for i in 1..P {
                let vertex = self.turned(arm, i);
                (along[i], across[i]) = (way[i] - vertex.0, -vertex.1);
            }
        } else {
            // The end rests: the centre is where the turned arm leaves it.
            let (of_cos, of_sin) = (product(&self.along, &self.cos), product(&self.along, &self.sin));
            for i in 1..P {
                along[i] = arm.y * self.sin[i] - of_cos[i];
                across[i] = -arm.y * self.cos[i] - of_sin[i];
            }
        }
        (along, across)
    }

    /// Gap of another pair of the body and an obstacle [m].
    fn gap(&self, world: &World, pair: Pairing) -> Option<[f64; P]> {
        let obstacle = world.obstacles.get(pair.obstacle)?;
        let (given, shape) = (&self.given, &world.body_of(pair).shape);
        let seen = |v: Vec2| Vec2::new(given.tangent.dot(v), given.normal.dot(v));
        let (along, across) = self.centre_way();
        let mut gap = match pair.feature {
            Feature::VertexOnFace { vertex, face } => {
                let normal = seen(obstacle.normal(face));
                let arm = seen(given.turn.apply(shape.vertices()[vertex]));
                std::array::from_fn(|i| {
                    let vertex = self.turned(arm, i);
                    normal.x * (along[i] + vertex.0) + normal.y * (across[i] + vertex.1)
                })
            }
            Feature::FaceOnEnd { face, end } => {
                let outward = seen(given.turn.apply(shape.face_normal(face)));
                let (mut x, mut y) = (along.map(|s| -s), across.map(|s| -s));
                let end = seen(obstacle.end(end) - given.start.pose.centre);
                (x[0], y[0]) = (end.x, end.y);
                let axis: [(f64, f64); P] = std::array::from_fn(|i| self.turned(outward, i));
                let (x, y) = (product(&axis.map(|a| a.0), &x), product(&axis.map(|a| a.1), &y));
                std::array::from_fn(|i| x[i] + y[i])
            }
            Feature::VertexOnEnd { .. } => return None,
        };
        gap[0] = world.gap(&[given.start], &[given.turn], pair);
        Some(gap)
    }
}

/// The product of two series.
fn product<const P: usize>(a: &[f64; P], b: &[f64; P]) -> [f64; P] {
    std::array::from_fn(|i| (0..=i).map(|j| a[j] * b[i - j]).sum())
}
