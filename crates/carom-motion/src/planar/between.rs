//! One pair of features of two bodies that both move: the same as on an obstacle, with both sides' motions.

use super::kinematics::{Kinematics, Pairing, Turn};
use super::{Feature, Shape, State, World};
use crate::evaluated::{Quantity, evaluated};
use crate::tolerance::COINCIDENT_POINTS;
use carom_num::Vec2;

/// One of the two bodies in an instant.
#[derive(Clone, Copy)]
struct Side<'a> {
    shape: &'a Shape,
    /// What rounds its vertices against another body.
    radius: f64,
    state: &'a State,
    turn: Turn,
}

impl Side<'_> {
    fn spin(&self) -> f64 {
        self.state.twist.spin
    }

    /// A vertex, from the mass centre [m].
    fn vertex(&self, vertex: usize) -> Vec2 {
        self.turn.apply(self.shape.vertices()[vertex])
    }

    /// Unit normal out of a face.
    fn outward(&self, face: usize) -> Vec2 {
        self.turn.apply(self.shape.face_normal(face))
    }
}

/// A point fixed in the first body, seen from the second's mass centre: place [m] and velocity of its mass centre's frame [m/s].
struct Seen {
    /// The point from its own mass centre.
    own: Vec2,
    /// From the other's mass centre.
    place: Vec2,
    /// Rate of that.
    rate: Vec2,
}

fn seen(of: &Side<'_>, vertex: usize, from: &Side<'_>) -> Seen {
    let own = of.vertex(vertex);
    let (a, b) = (of.state, from.state);
    let place = a.pose.centre + own - b.pose.centre;
    let rate = a.twist.velocity + own.turned_left() * of.spin() - b.twist.velocity;
    Seen { own, place, rate }
}

/// A vertex of `a` on a face of `b`, as `a` sees it.
fn vertex_on_face(a: &Side<'_>, vertex: usize, b: &Side<'_>, face: usize) -> Kinematics {
    let (normal, point) = (b.outward(face), seen(a, vertex, b));
    let depth = b.shape.face_normal(face).dot(b.shape.vertices()[face]) + b.radius + a.radius;
    let (arm, other_arm) = (point.own - normal * a.radius, point.place - normal * a.radius);
    let (wa, wb) = (a.spin(), b.spin());
    let tangent = normal.turned_right();
    let mut k = Kinematics {
        gap: normal.dot(point.place) - depth,
        arm,
        other_arm,
        normal,
        slip: 0.0,
        approach: 0.0,
        normal_bias: -wb * wb * normal.dot(point.place) + 2.0 * wb * normal.turned_left().dot(point.rate)
            - wa * wa * normal.dot(point.own),
        slip_bias: 0.0,
    };
    note_velocity(&mut k, a, b);
    k.slip_bias = -wa * wa * tangent.dot(point.own) + wb * (normal.dot(point.rate) + k.approach);
    k
}

/// A vertex of `a` on a vertex of `b`.
fn vertex_on_vertex(a: &Side<'_>, vertex: usize, b: &Side<'_>, end: usize) -> Kinematics {
    let (own, other) = (a.vertex(vertex), b.vertex(end));
    let point = seen(a, vertex, b);
    let (d, rate) = (point.place - other, point.rate - other.turned_left() * b.spin());
    let distance = d.norm();
    let apart = distance > COINCIDENT_POINTS * a.shape.size();
    // Two points that coincide move apart along their velocity.
    let moving = || rate.unit().unwrap_or(Vec2::new(0.0, 1.0));
    let normal = if apart { d / distance } else { moving() };
    let tangent = normal.turned_right();
    let across = tangent.dot(rate);
    // The normal turns clockwise, towards t, at this rate.
    let swing = if apart { across / distance } else { 0.0 };
    let (wa, wb) = (a.spin(), b.spin());
    let pull = other * (wb * wb) - own * (wa * wa);
    let mut k = Kinematics {
        gap: distance - a.radius - b.radius,
        arm: own - normal * a.radius,
        other_arm: other + normal * b.radius,
        normal,
        slip: 0.0,
        approach: 0.0,
        normal_bias: normal.dot(pull) + across * swing,
        slip_bias: tangent.dot(pull) - swing * normal.dot(rate),
    };
    note_velocity(&mut k, a, b);
    k
}

fn note_velocity(k: &mut Kinematics, a: &Side<'_>, b: &Side<'_>) {
    let of = |side: &Side<'_>, arm: Vec2| side.state.twist.velocity + arm.turned_left() * side.spin();
    let u = of(a, k.arm) - of(b, k.other_arm);
    (k.slip, k.approach) = (k.tangent().dot(u), k.normal.dot(u));
}

/// What one side sees, seen from the other: its normal points the other way, and so do its tangent and the velocity.
fn from_the_other_side(k: Kinematics) -> Kinematics {
    Kinematics { arm: k.other_arm, other_arm: k.arm, normal: -k.normal, ..k }
}

/// Room of a vertex of `a` between the ends of a face of `b` [m], and its rate [m/s].
fn room_on_face(a: &Side<'_>, vertex: usize, b: &Side<'_>, face: usize) -> [Option<(f64, f64)>; 4] {
    let (from, to) = b.shape.face(face);
    let direction = b.outward(face).turned_left();
    let point = seen(a, vertex, b);
    let s = direction.dot(point.place) - b.shape.face_normal(face).turned_left().dot(from);
    let rate = direction.dot(point.rate) + b.spin() * direction.turned_left().dot(point.place);
    [Some((s, rate)), Some(((to - from).norm() - s, -rate)), None, None]
}

/// Room of `d`, which points away from a vertex of a side, beyond the ends of the two faces that meet there; `d` changes at `rate`.
fn room_at_vertex(side: &Side<'_>, vertex: usize, d: Vec2, rate: Vec2) -> [Option<(f64, f64)>; 2] {
    let k = side.shape.vertices().len();
    if k == 1 {
        return [None, None];
    }
    [((vertex + k - 1) % k, 1.0), (vertex, -1.0)].map(|(face, sign)| {
        let direction = side.outward(face).turned_left();
        let turning = side.spin() * direction.turned_left().dot(d);
        Some((sign * direction.dot(d), sign * (direction.dot(rate) + turning)))
    })
}

impl World {
    fn sides<'a>(&'a self, states: &'a [State], turns: &[Turn], pair: Pairing) -> (Side<'a>, Side<'a>) {
        let side = |b: usize| {
            let shape = &self.bodies[b].shape;
            Side { shape, radius: shape.skin(), state: &states[b], turn: turns[b] }
        };
        (side(pair.body), side(self.other_body(pair).unwrap_or(pair.body)))
    }

    /// Kinematics of a pair of features of two bodies.
    ///
    /// # Source
    /// The gap and the velocities of the two points that touch, differentiated in time: the normal turns with the body whose face it is
    /// normal to, or with the line between two vertices.
    pub(super) fn between_bodies(&self, states: &[State], turns: &[Turn], pair: Pairing) -> Kinematics {
        let (a, b) = self.sides(states, turns, pair);
        let k = match pair.feature {
            Feature::VertexOnFace { vertex, face } => vertex_on_face(&a, vertex, &b, face),
            Feature::FaceOnEnd { face, end } => from_the_other_side(vertex_on_face(&b, end, &a, face)),
            Feature::VertexOnEnd { vertex, end } => vertex_on_vertex(&a, vertex, &b, end),
        };
        Kinematics { gap: evaluated(Quantity::Gap, k.gap), ..k }
    }

    /// [`World::extents`] of a pair of features of two bodies.
    pub(super) fn extents_between(
        &self,
        states: &[State],
        turns: &[Turn],
        pair: Pairing,
    ) -> [Option<(f64, f64)>; 4] {
        let (a, b) = self.sides(states, turns, pair);
        match pair.feature {
            Feature::VertexOnFace { vertex, face } => room_on_face(&a, vertex, &b, face),
            Feature::FaceOnEnd { face, end } => room_on_face(&b, end, &a, face),
            Feature::VertexOnEnd { vertex, end } => {
                let (point, other) = (seen(&a, vertex, &b), b.vertex(end));
                let (d, rate) = (point.place - other, point.rate - other.turned_left() * b.spin());
                let [p, q] = room_at_vertex(&a, vertex, -d, -rate);
                let [r, s] = room_at_vertex(&b, end, d, rate);
                [p, q, r, s]
            }
        }
    }
}
