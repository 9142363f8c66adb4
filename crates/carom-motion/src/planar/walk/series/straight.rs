//! Two contacts that slide on one line: the body does not turn, its acceleration stays, and every event function is of second degree.
//!
//! Neither contact can stay closed while the body turns. With the levers l = a_t − p a_n of the two forces about the mass centre the normal
//! forces are those that carry the weight W and balance their moments, N₁ = W l₂/(l₂ − l₁). The acceleration stays where both forces are of
//! one direction, or where neither contact moves in the body.

use super::Expanded;
use crate::planar::contact::{
    World,
    bounds::Bounds,
    kinematics::{Kinematics, Turn},
    touching::Few,
    world::Scales,
};
use crate::planar::geometry::{Feature, State, Twist};
use crate::planar::modes::{
    mode::Held,
    watch::{Watch, Watched},
};
use crate::planar::walk::path::Stretch;
use crate::tolerance::{KEEPS_ANGLE_ARM, ONE_DIRECTION_SINE};
use carom_impact::planar::Slip;
use carom_num::Vec2;

/// One of the two contacts at the start.
#[derive(Clone, Copy, Debug)]
struct Sliding {
    held: Held,
    kinematics: Kinematics,
    pull: f64,
    lever: f64,
}

/// A body that slides without turning.
#[derive(Clone, Copy, Debug)]
pub(super) struct Straight {
    start: State,
    turn: Turn,
    contacts: [Sliding; 2],
    acceleration: Vec2,
    /// Sum of the normal forces.
    carried: f64,
    length: f64,
}

/// A quantity of second degree: value, rate and second rate.
type Parabola = (f64, f64, f64);

impl Straight {
    /// The motion from here on; `None` where the mode is another.
    pub(super) fn of(world: &World, held: &Few<Held>, start: &State, length: f64) -> Option<Self> {
        let ([body], Some(a), Some(b), 2) = (&world.bodies[..], held.get(0), held.get(1), held.len()) else {
            return None;
        };
        let (turn, size) = (Turn::of(start), body.shape.size());
        // What two contacts have left of a spin is rounding.
        let start = State { twist: Twist { spin: 0.0, ..start.twist }, ..*start };
        let of = |h: &Held| {
            let pull = h.slip.pull(world.obstacles.get(h.pair.obstacle)?.friction);
            let kinematics = world.kinematics_turned(&[start], &[turn], h.pair);
            let slides = h.slip != Slip::Sticks && !matches!(h.pair.feature, Feature::VertexOnEnd { .. });
            let arm = kinematics.arm;
            let lever = kinematics.tangent().dot(arm) - pull * kinematics.normal.dot(arm);
            slides.then_some(Sliding { held: *h, kinematics, pull, lever })
        };
        let contacts = [of(a)?, of(b)?];
        let [first, second] = &contacts;
        let (k, l) = (&first.kinematics, &second.kinematics);
        let one_line = k.normal.cross(l.normal).abs() <= ONE_DIRECTION_SINE && k.normal.dot(l.normal) > 0.0;
        let by_vertex = |c: &Sliding| matches!(c.held.pair.feature, Feature::VertexOnFace { .. });
        let stays = first.pull == second.pull || (by_vertex(first) && by_vertex(second));
        let apart = (k.arm - l.arm).dot(k.tangent()).abs().min((first.lever - second.lever).abs());
        if !one_line || !stays || apart <= KEEPS_ANGLE_ARM * size {
            return None;
        }
        let carried = -body.mass * k.normal.dot(world.gravity);
        let share = second.lever / (second.lever - first.lever);
        let pull = share * first.pull + (1.0 - share) * second.pull;
        let along = k.tangent();
        let acceleration = along * (along.dot(world.gravity) + pull * carried / body.mass);
        Some(Self { start, turn, contacts, acceleration, carried, length })
    }

    /// An event function in the world's own units; `None` where it does not change its sign before another.
    fn quantity(&self, world: &World, scales: &Scales, what: &Watch) -> Option<Parabola> {
        // Everything that is linear in the velocity: with the acceleration in its place it is the rate.
        let hurried = State { twist: Twist { velocity: self.acceleration, spin: 0.0 }, ..self.start };
        let (unit, scaled) = match *what {
            Watch::Force(i) => {
                let (own, other) = (&self.contacts[i.min(1)], &self.contacts[1 - i.min(1)]);
                let (value, rate, bend) = self.lever(other);
                let weight = self.carried / (other.lever - own.lever);
                let unit = world.bodies[0].mass * scales.speed * scales.speed / scales.length;
                (unit, (weight * value, weight * rate, weight * bend))
            }
            Watch::Slip(i) => {
                let c = self.contacts.get(i)?;
                let sign = if c.held.slip == Slip::Backward { -1.0 } else { 1.0 };
                let k = &c.kinematics;
                (sign * scales.speed, (k.slip, k.tangent().dot(self.acceleration), 0.0))
            }
            Watch::Extent(i, slot) => {
                let pair = self.contacts.get(i)?.held.pair;
                let of = |state| world.extents(&[state], &[self.turn], pair)[slot];
                let ((room, rate), (_, bend)) = (of(self.start)?, of(hurried)?);
                (scales.length, (room, rate, bend))
            }
            Watch::Gap(pair) => {
                let of = |state| world.kinematics_turned(&[state], &[self.turn], pair);
                let (k, bend) = (of(self.start), of(hurried).approach);
                (scales.length, (k.gap, k.approach, bend))
            }
            // Nothing turns; the forces stay determined while the contacts are apart.
            Watch::Parallel(..) | Watch::Cone(..) | Watch::Regular | Watch::Holds => return None,
        };
        let (value, rate, bend) = scaled;
        Some((value / unit, rate / unit, bend / unit))
    }

    /// The lever of a contact's force.
    fn lever(&self, c: &Sliding) -> Parabola {
        match c.held.pair.feature {
            Feature::FaceOnEnd { .. } => {
                let k = &c.kinematics;
                (c.lever, -k.slip, -k.tangent().dot(self.acceleration))
            }
            _ => (c.lever, 0.0, 0.0),
        }
    }
}

/// The first place from 0 on where a parabola falls through zero; a start at or below zero counts once it falls further.
fn first_fall((value, rate, bend): Parabola) -> Option<f64> {
    if value <= 0.0 && (rate < 0.0 || rate == 0.0 && bend < 0.0) {
        return Some(0.0);
    }
    let inside = rate * rate - 2.0 * bend * value;
    if inside < 0.0 {
        return None;
    }
    if rate < 0.0 {
        return Some(2.0 * value / (inside.sqrt() - rate));
    }
    (bend < 0.0).then(|| (rate + inside.sqrt()) / -bend)
}

impl<const B: usize> Stretch<B> for Straight {
    fn length(&self) -> f64 {
        self.length
    }

    fn start(&self) -> [State; B] {
        [self.start; B]
    }

    fn states(&self, fraction: f64) -> [State; B] {
        [self.start.flown(self.acceleration, fraction * self.length); B]
    }
}

impl<const B: usize> Expanded<B> for Straight {
    fn shorten(&mut self, length: f64) {
        self.length = length;
    }

    fn fall(&self, (world, scales): (&World, &Scales), watched: &Watched, now: f64) -> Option<f64> {
        let (mut value, mut rate, bend) = self.quantity(world, scales, &watched.what)?;
        match watched.leaving {
            None => value += watched.slack,
            Some(leaving) => {
                value -= leaving.offset;
                // It leaves zero here: the orders that vanish are none.
                if now <= leaving.since {
                    value = 0.0;
                    match leaving.order {
                        1 => {}
                        2 => rate = 0.0,
                        _ => return None,
                    }
                }
            }
        }
        first_fall((value, rate, bend)).filter(|t| *t <= self.length)
    }

    fn bounds(&self, _world: &World) -> Bounds {
        let end = self.start.flown(self.acceleration, self.length);
        Bounds {
            horizon: self.length,
            acceleration: self.acceleration.norm(),
            angular: 0.0,
            spin: 0.0,
            speed: self.start.twist.velocity.norm().max(end.twist.velocity.norm()),
            steady: Some(self.acceleration),
            left: None,
        }
    }

    fn slips(&self) -> f64 {
        // Nothing turns: both contacts slip as the mass centre moves.
        let end = self.start.flown(self.acceleration, self.length);
        self.contacts[0].kinematics.tangent().dot(end.twist.velocity).abs()
    }

    fn fastest_within(&self) -> Option<f64> {
        None
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use super::*;

    #[test]
    fn a_parabola_falls_where_it_falls() {
        assert_eq!(first_fall((2.0, -3.0, 2.0)), Some(1.0), "of two roots the first");
        assert_eq!(first_fall((-1.0, 3.0, -4.0)), Some(1.0), "it rises, and falls at the second");
        assert_eq!(first_fall((0.0, 2.0, -2.0)), Some(2.0), "it leaves zero and comes back");
        assert_eq!(first_fall((0.0, 0.0, -2.0)), Some(0.0), "it leaves zero downwards");
        assert_eq!(first_fall((1.0, -1.0, 1.0)), None, "it turns before");
        assert_eq!(first_fall((-1.0, 1.0, 1.0)), None, "it only rises");
        assert_eq!(first_fall((0.0, 0.0, 0.0)), None, "it stays");
    }
}
