//! For how long a pair of features certainly does not touch.
//!
//! Two features touch where their gap falls to zero while the contact lies within the extents of both. So a pair does not touch as long as any one of
//! these fails: while the gap is positive, while it is negative (the one lies behind the other, and would have to come out first), or while the contact
//! lies beyond an extent. Each is a quantity with a rate and a bound on its second rate, which gives it a time.

use super::World;
use super::kinematics::{Pairing, Turn};
use crate::planar::geometry::{Feature, State};
use crate::tolerance::CLEAR_GAP;
use carom_num::Vec2;
use carom_num::poly::first_root;

/// Bounds on how one side of a pair moves against the other over a stretch of time.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::planar) struct Moves {
    /// How long they hold [s].
    pub(in crate::planar) horizon: f64,
    /// Acceleration of one mass centre against the other [m/s²].
    pub(in crate::planar) acceleration: f64,
    /// That acceleration itself, where it is constant: in flight.
    pub(in crate::planar) steady: Option<Vec2>,
    /// Speed of one mass centre against the other [m/s].
    pub(in crate::planar) speed: f64,
    /// Angular acceleration [rad/s²] and spin [rad/s] of the body, and of what it meets.
    pub(in crate::planar) angular: [f64; 2],
    pub(in crate::planar) spin: [f64; 2],
}

/// How exactly a pair is asked about.
#[derive(Clone, Copy, Debug)]
pub(in crate::planar) struct Exactness {
    /// Overlap up to this depth counts as apart [m].
    pub(in crate::planar) allowance: f64,
    /// How well places are known [m].
    pub(in crate::planar) exact: f64,
}

/// How far a pair of features is from touching [m], and a time for which it certainly does not touch [s].
#[derive(Clone, Copy, Debug)]
pub(in crate::planar) struct Clearance {
    pub(in crate::planar) distance: f64,
    pub(in crate::planar) safe: f64,
}

impl Clearance {
    /// One condition of a touch that fails by `value`, which changes at `rate` and bends by `bend` at most, for a time `until`.
    fn fails(&mut self, value: f64, rate: f64, (bend, until): (f64, f64)) {
        self.distance = self.distance.max(value);
        if value > 0.0 {
            self.safe = self.safe.max(first_root(value, rate, bend).min(until));
        }
    }
}

impl World {
    /// The clearance of a pair of features.
    pub(in crate::planar) fn clearance_of(
        &self,
        (states, turns): (&[State], &[Turn]),
        pair: Pairing,
        moves: &Moves,
        Exactness { allowance, exact }: Exactness,
    ) -> Clearance {
        let k = self.kinematics_turned(states, turns, pair);
        let mut out = Clearance { distance: f64::NEG_INFINITY, safe: 0.0 };
        let bends = self.bends((states, turns), (pair, k.normal), moves);
        let gap = k.gap + allowance;
        // What is hardly behind has come there by rounding: it touches.
        if gap > -CLEAR_GAP * self.body_of(pair).shape.size() {
            out.fails(gap, k.approach, bends.opening);
        } else {
            out.fails(-gap, -k.approach, bends.closing);
        }
        let of = self.rooms(states, turns, pair);
        let rooms = of.face.iter().chain(&of.own).chain(&of.met).flatten();
        rooms.for_each(|(room, rate)| out.fails(-room - exact, -rate, (bends.rooms, moves.horizon)));
        out.safe = out.safe.min(moves.horizon);
        out
    }

    /// Bounds on the second rates of what a clearance is made of.
    fn bends(
        &self,
        (states, turns): (&[State], &[Turn]),
        (pair, normal): (Pairing, Vec2),
        moves: &Moves,
    ) -> Bends {
        let (shape, met) = (&self.body_of(pair).shape, self.met(pair));
        let other = self.other_body(pair);
        let at = other.map_or(Vec2::ZERO, |b| states[b].pose.centre);
        let between = states[pair.body].pose.centre - at;
        // A vertex of what is met lies at its place in the world where that stands still.
        let (own, theirs) = match pair.feature {
            Feature::VertexOnFace { vertex, .. } => (shape.vertices()[vertex].norm(), 0.0),
            Feature::FaceOnEnd { end, .. } => (0.0, met.vertices()[end].norm()),
            Feature::VertexOnEnd { vertex, end } => {
                (shape.vertices()[vertex].norm(), met.vertices()[end].norm())
            }
        };
        let turning = |side: usize| moves.angular[side] + moves.spin[side] * moves.spin[side];
        let speed = moves.speed + moves.spin[0] * own + moves.spin[1] * theirs;
        let of_points = moves.acceleration + turning(0) * own + turning(1) * theirs;
        // What an axis that turns with one side adds: its own turning, and that of what moves along it.
        let far = match (pair.feature, other) {
            (Feature::FaceOnEnd { end, .. } | Feature::VertexOnEnd { end, .. }, None) => {
                (between - met.vertices()[end]).norm() + own
            }
            _ => between.norm() + own + theirs,
        } + speed * moves.horizon;
        let of_axis = |side: usize| turning(side) * far + 2.0 * moves.spin[side] * speed;
        let size = (turning(0) + turning(1)) * shape.size();
        let rooms = of_points + of_axis(0) + of_axis(1) + size;
        let lasting = |bend: f64| (bend, moves.horizon);
        let all = |bend: f64| Bends { opening: lasting(bend), closing: lasting(bend), rooms };
        match pair.feature {
            Feature::VertexOnFace { .. } => {
                // Along a face that stands still only a part of what is constant counts.
                let still = moves.steady.filter(|_| other.is_none());
                let along = |a: Vec2| of_points - moves.acceleration - normal.dot(a);
                let [opening, closing] = match still {
                    Some(a) => [along(a), along(-a)],
                    None => [of_points + of_axis(1); 2],
                };
                Bends { opening: lasting(opening), closing: lasting(closing), rooms }
            }
            Feature::FaceOnEnd { .. } => all(of_points + of_axis(0)),
            Feature::VertexOnEnd { vertex, end } => {
                // A distance of two points bends upwards by as much as they swing about each other, while they keep half of it.
                let distance = self.distance_of_vertices(states, turns, pair);
                let swing = (of_points + 2.0 * speed * speed / distance, 0.5 * distance / speed);
                let within = shape.radius_of(vertex) + met.radius_of(end) < 0.0;
                let straight = lasting(of_points);
                let (opening, closing) = if within { (swing, straight) } else { (straight, swing) };
                Bends { opening, closing, rooms }
            }
        }
    }

    /// Distance of the two vertices of a pair [m].
    fn distance_of_vertices(&self, states: &[State], turns: &[Turn], pair: Pairing) -> f64 {
        let Feature::VertexOnEnd { vertex, end } = pair.feature else { return f64::INFINITY };
        let own = states[pair.body].pose.centre
            + turns[pair.body].apply(self.body_of(pair).shape.vertices()[vertex]);
        let other = self.met(pair).vertices()[end];
        let at = self.other_body(pair).map_or(other, |b| states[b].pose.centre + turns[b].apply(other));
        (own - at).norm().max(f64::MIN_POSITIVE)
    }
}

/// Bounds on second rates and how long they hold [s]: of the gap while it is positive and while it is negative, and of the rooms.
struct Bends {
    opening: (f64, f64),
    closing: (f64, f64),
    rooms: f64,
}
