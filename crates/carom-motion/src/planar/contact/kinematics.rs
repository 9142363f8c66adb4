//! One pair of features: gap, frame, velocities, and the accelerations that turning alone causes.

use super::World;
use crate::evaluated::{Quantity, evaluated};
use crate::planar::geometry::{Feature, Obstacle, State};
use crate::tolerance::{COINCIDENT_POINTS, TINY_TURN};
use carom_num::Vec2;
use carom_num::elementary::sin_cos;
use std::cell::Cell;

/// The cosine and sine of a pose's angle: computed once per state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::planar) struct Turn {
    pub(in crate::planar) cos: f64,
    pub(in crate::planar) sin: f64,
}

impl Turn {
    /// What is not turned.
    pub(super) const NONE: Self = Self { cos: 1.0, sin: 0.0 };

    pub(in crate::planar) fn of(state: &State) -> Self {
        let (sin, cos) = sin_cos(state.pose.angle);
        Self { cos, sin: evaluated(Quantity::Turn, sin) }
    }

    pub(in crate::planar) fn apply(self, v: Vec2) -> Vec2 {
        v.rotated(self.cos, self.sin)
    }

    /// After a turn by a further angle [rad].
    pub(in crate::planar) fn turned(self, state: &State, by: f64) -> Self {
        if by.abs() > TINY_TURN {
            return Self::of(state);
        }
        Self { cos: self.cos - by * self.sin, sin: self.sin + by * self.cos }
    }

    /// The same direction as the body sees it.
    pub(in crate::planar) fn undo(self, v: Vec2) -> Vec2 {
        v.rotated(self.cos, -self.sin)
    }
}

/// The turns of the states that were asked about last: most questions are about the states of the question before.
#[derive(Clone, Debug)]
pub(in crate::planar) struct Turned<const B: usize>(Cell<[(f64, Turn); B]>);

impl<const B: usize> Default for Turned<B> {
    fn default() -> Self {
        // No angle equals this one.
        Self(Cell::new([(f64::NAN, Turn { cos: f64::NAN, sin: f64::NAN }); B]))
    }
}

impl<const B: usize> Turned<B> {
    /// As [`turns`].
    #[inline]
    pub(in crate::planar) fn of(&self, states: &[State; B]) -> [Turn; B] {
        let mut known = self.0.get();
        for ((angle, turn), state) in known.iter_mut().zip(states) {
            if *angle != state.pose.angle {
                (*angle, *turn) = (state.pose.angle, Turn::of(state));
            }
        }
        self.0.set(known);
        known.map(|(_, turn)| turn)
    }
}

/// The turns of several bodies.
pub(in crate::planar) fn turns<const B: usize>(states: &[State; B]) -> [Turn; B] {
    std::array::from_fn(|b| Turn::of(&states[b]))
}

/// A pair of features of a body and of what it meets.
///
/// # Example
/// Two balls of radius 0.1 m, 1.2 m apart, in a world without obstacles, where the second one has the number
/// 1.
/// ```
/// use carom_motion::planar::{Feature, Pairing, examples};
/// let (world, at) = (examples::two_balls(), examples::on_the_axis);
/// let feature = Feature::VertexOnEnd { vertex: 0, end: 0 };
/// let pair = Pairing { body: 0, obstacle: 1, feature };
/// assert_eq!(world.other_body(pair), Some(1));
/// assert!((world.kinematics(&[at(0.0, 0.0), at(1.2, 0.0)], pair).gap - 1.0).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Pairing {
    /// Number of the body.
    pub body: usize,
    /// Number of the obstacle; another body's number counts on after the obstacles.
    pub obstacle: usize,
    /// The features.
    pub feature: Feature,
}

impl Pairing {
    /// The body and what it meets.
    pub(in crate::planar) fn meeting(self) -> (usize, usize) {
        (self.body, self.obstacle)
    }
}

/// Kinematics of a pair of features in one state; the contact frame as in `carom_impact::planar`.
///
/// The velocity of the body's contact point is `u = v + ω × arm`, less that of the other body's point; its rates are the accelerations of
/// these points along n and t, plus `normal_bias` and `slip_bias`.
///
/// # Example
/// A ball of radius 0.1 m with its centre 0.3 m over a floor has a gap of 0.2 m, its lowest point moves with
/// `v + ω r`.
/// ```
/// use carom_motion::planar::{Feature, Obstacle, Pairing, State, Twist, examples};
/// use carom_num::Vec2;
/// let (world, start) = examples::falling_ball();
/// let turning = State { twist: Twist { velocity: Vec2::new(1.0, -2.0), spin: 5.0 }, ..start };
/// let feature = Feature::VertexOnFace { vertex: 0, face: Obstacle::LEFT };
/// let k = world.kinematics(&[turning], Pairing { body: 0, obstacle: 0, feature });
/// assert!((k.gap - 0.2).abs() < 1e-15);
/// assert_eq!((k.slip, k.approach), (1.5, -2.0));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Kinematics {
    /// Distance of the features [m]; negative where they overlap.
    pub gap: f64,
    /// Contact point from the mass centre [m], world axes.
    pub arm: Vec2,
    /// Contact point from the mass centre of the other body [m], world axes; zero on an obstacle.
    pub other_arm: Vec2,
    /// Unit normal out of the obstacle (the other body) into the body.
    pub normal: Vec2,
    /// Slip velocity along t [m/s].
    pub slip: f64,
    /// Rate of the gap [m/s].
    pub approach: f64,
    /// Part of the gap's second rate that the accelerations do not cause [m/s²].
    pub normal_bias: f64,
    /// Part of the slip's rate that the accelerations do not cause [m/s²].
    pub slip_bias: f64,
}

impl Kinematics {
    /// Unit tangent: the normal turned clockwise.
    ///
    /// # Example
    /// Over a floor the normal points up and the tangent to the right.
    /// ```
    /// use carom_motion::planar::Kinematics;
    /// use carom_num::Vec2;
    /// let k = Kinematics { normal: Vec2::new(0.0, 1.0), ..Kinematics::default() };
    /// assert_eq!(k.tangent(), Vec2::new(1.0, 0.0));
    /// ```
    pub fn tangent(&self) -> Vec2 {
        self.normal.turned_right()
    }
}

impl World {
    /// Kinematics of one pair of features, the bodies being in these states.
    ///
    /// # Example
    /// The corner of a block that turns with ω has the acceleration `−ω² y` towards the centre, however its
    /// centre moves.
    /// ```
    /// use carom_motion::planar::{Feature, Obstacle, Pairing, State, Twist, examples};
    /// use carom_num::Vec2;
    /// let (world, start) = examples::lying_block(Vec2::new(0.0, -10.0), 0.3);
    /// let turning = State { twist: Twist { velocity: Vec2::ZERO, spin: 3.0 }, ..start };
    /// let feature = Feature::VertexOnFace { vertex: 1, face: Obstacle::LEFT };
    /// let k = world.kinematics(&[turning], Pairing { body: 0, obstacle: 0, feature });
    /// assert_eq!((k.gap, k.arm), (0.0, Vec2::new(0.2, -0.1)));
    /// assert!((k.normal_bias - 0.9).abs() < 1e-15 && (k.slip_bias + 1.8).abs() < 1e-15);
    /// ```
    pub fn kinematics<const B: usize>(&self, states: &[State; B], pair: Pairing) -> Kinematics {
        self.kinematics_turned(states, &turns(states), pair)
    }

    pub(in crate::planar) fn kinematics_turned(
        &self,
        states: &[State],
        turns: &[Turn],
        pair: Pairing,
    ) -> Kinematics {
        match self.obstacles.get(pair.obstacle) {
            Some(obstacle) => self.on_obstacle(&states[pair.body], turns[pair.body], pair, obstacle),
            None => self.between_bodies(states, turns, pair),
        }
    }

    #[inline(always)]
    pub(in crate::planar) fn on_obstacle(
        &self,
        state: &State,
        turn: Turn,
        pair: Pairing,
        obstacle: &Obstacle,
    ) -> Kinematics {
        let (shape, met) = (&self.body_of(pair).shape, obstacle.shape());
        let (c, v, w) = (state.pose.centre, state.twist.velocity, state.twist.spin);
        match pair.feature {
            Feature::VertexOnFace { vertex, face } => {
                let (normal, radius) = (met.face_normal(face), shape.radius_of(vertex));
                let r = turn.apply(shape.vertices()[vertex]);
                let arm = r - normal * radius;
                let gap = normal.dot(c + r - met.vertices()[face]) - (radius + met.radius_of(face));
                let (slip_bias, normal_bias) =
                    (-w * w * normal.turned_right().dot(r), -w * w * normal.dot(r));
                frame(gap, arm, normal, (slip_bias, normal_bias), (v, w))
            }
            Feature::FaceOnEnd { face, end } => {
                let (end, radius) = (met.vertices()[end] - c, met.radius_of(end));
                let outward = shape.face_normal(face);
                let normal = -turn.apply(outward);
                let depth = outward.dot(shape.vertices()[face]) + shape.radius_of(face) + radius;
                let gap = -normal.dot(end) - depth;
                let mut k = frame(gap, end + normal * radius, normal, (0.0, 0.0), (v, w));
                k.normal_bias = -2.0 * w * normal.turned_right().dot(v) + w * w * normal.dot(end);
                k.slip_bias = w * (k.approach + normal.dot(v));
                k
            }
            Feature::VertexOnEnd { vertex, end } => {
                let (radius, other) = (shape.radius_of(vertex), met.radius_of(end));
                let r = turn.apply(shape.vertices()[vertex]);
                let d = c + r - met.vertices()[end];
                let (distance, u) = (d.norm(), v + r.turned_left() * w);
                let apart = distance > COINCIDENT_POINTS * shape.size();
                // Within a hollow the normal points back to the hollow's centre.
                let sign = if radius + other < 0.0 { -1.0 } else { 1.0 };
                // Two points that coincide move apart along their velocity.
                let moving = || u.unit().unwrap_or(obstacle.direction().turned_left());
                let normal = if apart { d * (sign / distance) } else { moving() };
                let arm = r - normal * radius;
                let across = normal.turned_right().dot(u);
                let swing = if apart { sign * across / distance } else { 0.0 };
                let gap = sign * distance - (radius + other);
                let mut k = frame(gap, arm, normal, (0.0, 0.0), (v, w));
                k.normal_bias = -w * w * normal.dot(r) + across * swing;
                k.slip_bias = -w * w * normal.turned_right().dot(r) - swing * k.approach;
                k
            }
        }
    }

    /// [`Kinematics::gap`] alone.
    pub(in crate::planar) fn gap(&self, states: &[State], turns: &[Turn], pair: Pairing) -> f64 {
        match self.obstacles.get(pair.obstacle) {
            Some(obstacle) => self.on_obstacle(&states[pair.body], turns[pair.body], pair, obstacle).gap,
            None => self.between_bodies(states, turns, pair).gap,
        }
    }

    /// Rooms of a vertex on a face, one of them an obstacle's, and their rates [m, m/s].
    #[inline(always)]
    pub(super) fn room_on_obstacle(
        &self,
        state: &State,
        turn: Turn,
        pair: Pairing,
        obstacle: &Obstacle,
    ) -> Option<[(f64, f64); 2]> {
        let (shape, met) = (&self.body_of(pair).shape, obstacle.shape());
        let (c, v, w) = (state.pose.centre, state.twist.velocity, state.twist.spin);
        let (s, rate, length) = match pair.feature {
            Feature::VertexOnFace { vertex, face } => {
                let along = met.face_normal(face).turned_left();
                let r = turn.apply(shape.vertices()[vertex]);
                let s = along.dot(c + r - met.vertices()[face]);
                (s, along.dot(v + r.turned_left() * w), met.face_length(face))
            }
            Feature::FaceOnEnd { face, end } => {
                let end = met.vertices()[end];
                let direction = turn.apply(shape.face_normal(face).turned_left());
                // The end seen from the body moves with minus the velocity of the body's point there.
                let s = direction.dot(end - c - turn.apply(shape.vertices()[face]));
                let rate = -direction.dot(v) + w * direction.turned_left().dot(end - c);
                (s, rate, shape.face_length(face))
            }
            Feature::VertexOnEnd { .. } => return None,
        };
        Some([(s, rate), (length - s, -rate)])
    }

    /// One of the distances of [`World::extents`], without its rate.
    pub(in crate::planar) fn room(
        &self,
        states: &[State],
        turns: &[Turn],
        pair: Pairing,
        slot: usize,
    ) -> Option<f64> {
        let of_all = || self.extents(states, turns, pair)[slot].map(|(room, _)| room);
        let Some(obstacle) = self.obstacles.get(pair.obstacle).filter(|_| slot < 2) else { return of_all() };
        let (shape, c, turn) = (&self.body_of(pair).shape, states[pair.body].pose.centre, turns[pair.body]);
        let met = obstacle.shape();
        let (from_start, length) = match pair.feature {
            Feature::VertexOnFace { vertex, face } => {
                let point = c + turn.apply(shape.vertices()[vertex]) - met.vertices()[face];
                (met.face_normal(face).turned_left().dot(point), met.face_length(face))
            }
            Feature::FaceOnEnd { face, end } => {
                let along = shape.face_normal(face).turned_left();
                let start = along.dot(shape.vertices()[face]);
                (turn.apply(along).dot(met.vertices()[end] - c) - start, shape.face_length(face))
            }
            Feature::VertexOnEnd { .. } => return of_all(),
        };
        Some(if slot == 0 { from_start } else { length - from_start })
    }

    /// [`World::room`] of a pair on an obstacle whose kinematics are known.
    pub(in crate::planar) fn room_of(
        &self,
        state: &State,
        pair: Pairing,
        k: &Kinematics,
        slot: usize,
    ) -> Option<f64> {
        let (shape, met) =
            (&self.body_of(pair).shape, self.obstacles.get(pair.obstacle).filter(|_| slot < 2)?.shape());
        let (from_start, length) = match pair.feature {
            Feature::VertexOnFace { face, .. } => {
                let point = state.pose.centre + k.arm - met.vertices()[face];
                (k.normal.turned_left().dot(point), met.face_length(face))
            }
            Feature::FaceOnEnd { face, .. } => {
                // The face runs along the tangent.
                let start = shape.face_normal(face).turned_left().dot(shape.vertices()[face]);
                (k.tangent().dot(k.arm) - start, shape.face_length(face))
            }
            Feature::VertexOnEnd { .. } => return None,
        };
        Some(if slot == 0 { from_start } else { length - from_start })
    }
}

#[inline(always)]
fn frame(
    gap: f64,
    arm: Vec2,
    normal: Vec2,
    (slip_bias, normal_bias): (f64, f64),
    (v, w): (Vec2, f64),
) -> Kinematics {
    let u = v + arm.turned_left() * w;
    Kinematics {
        gap: evaluated(Quantity::Gap, gap),
        arm,
        other_arm: Vec2::ZERO,
        normal,
        slip: normal.turned_right().dot(u),
        approach: normal.dot(u),
        normal_bias,
        slip_bias,
    }
}
