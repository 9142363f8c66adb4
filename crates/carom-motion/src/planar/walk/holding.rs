//! What a walk holds: the contacts, as each body sees them, the face that lies on an obstacle, and what does not move.

use super::walker::Walker;
use crate::planar::contact::{
    kinematics::{Kinematics, Pairing},
    touching::{Few, Search},
};
use crate::planar::geometry::{Feature, Twist};
use crate::planar::modes::{mode::Held, question::Asked};
use crate::planar::record::trace::HeldContact;
use crate::tolerance::{
    RESTING_ACCELERATION, SAME_DIRECTION_COSINE, SAME_POINT, STILL_SPEED, TOUCHING_GAP, WEDGED_ACCELERATION,
};
use carom_impact::planar::Slip;
use carom_num::Vec2;

impl Walker<'_> {
    /// Obstacle and features of every contact in touch, held or not.
    ///
    /// # Example
    /// A ball that falls is in touch with the floor after its first event, though it bounces and is not held.
    /// ```
    /// use carom_motion::planar::{Feature, Obstacle, Options, Walker, examples};
    /// let (world, start) = examples::falling_ball();
    /// let mut walker = Walker::new(&world, start, vec![], Options::default())?;
    /// walker.advance(&mut ())?;
    /// let on_floor = Feature::VertexOnFace { vertex: 0, face: Obstacle::LEFT };
    /// assert_eq!((walker.held().count(), walker.in_touch()), (0, vec![(0, on_floor)]));
    /// # Ok::<(), carom_motion::MotionError>(())
    /// ```
    pub fn in_touch(&self) -> Vec<(usize, Feature)> {
        self.touching(0.0).iter().map(|pair| (pair.obstacle, pair.feature)).collect()
    }
}

impl<const B: usize> Walker<'_, B> {
    /// What a pair is for one of the bodies: the number of the thing that it touches, and the features. `None` where the body is not part of the
    /// pair.
    pub(super) fn seen_by(&self, body: usize, pair: Pairing) -> Option<(usize, Feature)> {
        let named = |b: usize| self.world.obstacles.len() + self.names[b];
        let other = self.world.other_body(pair);
        if pair.body == body {
            Some((other.map_or(pair.obstacle, named), pair.feature))
        } else {
            (other == Some(body)).then(|| (named(pair.body), pair.feature.from_the_other_side()))
        }
    }

    /// The contacts that one of the bodies holds at present.
    pub(in crate::planar) fn held_of(&self, body: usize) -> impl Iterator<Item = HeldContact> + '_ {
        self.held.iter().filter_map(move |h| {
            let (obstacle, feature) = self.seen_by(body, h.pair)?;
            Some(HeldContact { obstacle, feature, slip: h.slip })
        })
    }

    /// The face of a body that lies on an obstacle, by its number among [`Shape::rests`](crate::planar::Shape::rests), kept there by a second contact on it or on one in line with it.
    pub(in crate::planar) fn lies_flat(&self, body: usize, obstacle: usize) -> Option<usize> {
        let turns = self.turns();
        let of = |h: &Held| self.world.kinematics_turned(&self.states, &turns, h.pair);
        let own = || self.held.iter().filter(|h| h.pair.body == body);
        let first = of(own().find(|h| h.pair.obstacle == obstacle)?);
        let beside = |k: Kinematics| {
            let apart = (k.arm - first.arm).dot(first.tangent()).abs();
            k.normal.dot(first.normal) > SAME_DIRECTION_COSINE && apart > SAME_POINT * self.scales.length
        };
        // The contacts push against a face of the obstacle, not against its end.
        let met = self.world.obstacles[obstacle].shape();
        let faces = |f: usize| met.face_normal(f).dot(first.normal) > SAME_DIRECTION_COSINE;
        if !own().any(|h| beside(of(h))) || !(0..met.faces()).any(faces) {
            return None;
        }
        let shape = &self.world.bodies[body].shape;
        let lies = |normal: Vec2| turns[body].apply(normal).dot(first.normal) < -SAME_DIRECTION_COSINE;
        if shape.is_hull() {
            return (0..shape.faces()).find(|&f| lies(shape.face_normal(f)));
        }
        shape.rests().iter().position(|rest| lies(rest.normal))
    }

    /// True where every velocity and acceleration of the present mode is rounding.
    pub(super) fn rests(&mut self) -> bool {
        if self.held.is_empty() {
            return false;
        }
        let (still, l) = (STILL_SPEED * self.scales.speed, self.scales.length);
        if self.states.iter().any(|s| s.twist.velocity.norm() > still || s.twist.spin.abs() * l > still) {
            return false;
        }
        self.effort.evaluations += 1;
        let forces = self.world.forces(&self.held, &self.states);
        let g = RESTING_ACCELERATION * self.world.gravity.norm();
        // Where contacts wedge a body, rounding of their forces on it may be more than that.
        let pressing = |b: usize| -> f64 {
            let on = |pair: Pairing| pair.body == b || self.world.other_body(pair) == Some(b);
            let own = self.held.iter().zip(forces.contacts.iter()).filter(|(h, _)| on(h.pair));
            own.map(|(_, c)| c.normal_force.abs() + c.tangential_force.abs()).sum()
        };
        let fixed = self.fixed();
        self.world.bodies.iter().enumerate().all(|(b, body)| {
            let (a, rounding) = (forces.acceleration[b], WEDGED_ACCELERATION * pressing(b));
            let (linear, angular) = (rounding / body.mass, rounding * l * l / body.inertia);
            fixed[b] || (a.linear.norm() <= g.max(linear) && a.angular.abs() * l <= g.max(angular))
        })
    }

    /// Two contacts that stick fix a body: what velocity is left is rounding.
    pub(super) fn hold_still(&mut self) {
        if self.held.iter().filter(|h| h.slip == Slip::Sticks).count() < 2 {
            return;
        }
        let fixed = self.fixed();
        for (state, fixed) in self.states.iter_mut().zip(fixed) {
            if fixed {
                state.twist = Twist { velocity: Vec2::ZERO, spin: 0.0 };
            }
        }
    }

    /// Which bodies cannot move: a body is fixed by two contacts that stick at different points, on obstacles or on bodies that are fixed themselves.
    fn fixed(&self) -> [bool; B] {
        let turns = self.turns();
        let mut fixed = [false; B];
        for _ in 0..B {
            let known = fixed;
            for (body, fixed) in fixed.iter_mut().enumerate() {
                let arms = self.held.iter().filter(|h| h.slip == Slip::Sticks).filter_map(|h| {
                    let k = self.world.kinematics_turned(&self.states, &turns, h.pair);
                    let other = self.world.other_body(h.pair);
                    if h.pair.body == body {
                        other.is_none_or(|b| known[b]).then_some(k.arm)
                    } else {
                        (other == Some(body) && known[h.pair.body]).then_some(k.other_arm)
                    }
                });
                let mut first = None;
                for arm in arms {
                    let one = *first.get_or_insert(arm);
                    *fixed |= (arm - one).norm() > SAME_POINT * self.scales.length;
                }
            }
        }
        fixed
    }

    /// The contacts of the present mode, as the rate problem is asked about them.
    pub(super) fn asked(&self) -> Few<Asked> {
        let turns = self.turns();
        let mut out = Few::default();
        for h in self.held.iter() {
            let k = self.world.kinematics_turned(&self.states, &turns, h.pair);
            let slip = if h.slip == Slip::Sticks || k.slip.abs() <= STILL_SPEED * self.scales.speed {
                0.0
            } else {
                k.slip
            };
            out.push(Asked { pair: h.pair, slip, known: None, present: h.slip });
        }
        out
    }

    /// The pairs in touch; where a face is parallel to an obstacle up to `sine`, those it touches with.
    pub(super) fn touching(&self, sine: f64) -> Few<Pairing> {
        let reach = TOUCHING_GAP.max(4.0 * sine) * self.scales.length;
        self.world.touching(
            (&self.states, &self.turns()),
            &Search {
                reach,
                deepest: reach,
                sides: &self.sides,
                still: STILL_SPEED * self.scales.speed,
                except: None,
            },
        )
    }
}
