//! One pair of features of two bodies that both move: the same as on an obstacle, with both sides' motions. Where a pair lies within its features'
//! extents, of bodies and obstacles alike.

use super::World;
use super::kinematics::{Kinematics, Pairing, Turn};
use crate::evaluated::{Quantity, evaluated};
use crate::planar::geometry::{Feature, Pose, Shape, State, Twist};
use crate::tolerance::COINCIDENT_POINTS;
use carom_num::Vec2;

/// One of the two bodies in an instant.
#[derive(Clone, Copy)]
struct Side<'a> {
    shape: &'a Shape,
    state: &'a State,
    turn: Turn,
}

impl Side<'_> {
    fn spin(&self) -> f64 {
        self.state.twist.spin
    }

    /// Signed radius of the arc about a vertex, against another body.
    fn radius(&self, vertex: usize) -> f64 {
        self.shape.skin(vertex)
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
    let radius = a.radius(vertex);
    let depth = b.shape.face_normal(face).dot(b.shape.vertices()[face]) + b.radius(face) + radius;
    let (arm, other_arm) = (point.own - normal * radius, point.place - normal * radius);
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
    let (r, s) = (a.radius(vertex), b.radius(end));
    // Within a hollow the normal points back to the hollow's centre.
    let sign = if r + s < 0.0 { -1.0 } else { 1.0 };
    let normal = if apart { d * (sign / distance) } else { moving() };
    let tangent = normal.turned_right();
    let across = tangent.dot(rate);
    // The normal turns clockwise, towards t, at this rate.
    let swing = if apart { sign * across / distance } else { 0.0 };
    let (wa, wb) = (a.spin(), b.spin());
    let pull = other * (wb * wb) - own * (wa * wa);
    let mut k = Kinematics {
        gap: sign * distance - r - s,
        arm: own - normal * r,
        other_arm: other + normal * s,
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

/// Rooms beyond which a pair of features is none, with their rates [m, m/s].
pub(super) type Rooms = [Option<(f64, f64)>; 2];

/// Everything that a pair needs to touch besides its gap: room on the face, and in the directions of the two vertices that take part [m, m/s].
pub(super) struct AllRooms {
    pub(super) face: Rooms,
    pub(super) own: [Option<(f64, f64)>; 3],
    pub(super) met: [Option<(f64, f64)>; 3],
}

/// Room of a vertex of `a` between the ends of a face of `b`.
fn room_on_face(a: &Side<'_>, vertex: usize, b: &Side<'_>, face: usize) -> Rooms {
    let direction = b.outward(face).turned_left();
    let point = seen(a, vertex, b);
    let s =
        direction.dot(point.place) - b.shape.face_normal(face).turned_left().dot(b.shape.vertices()[face]);
    let rate = direction.dot(point.rate) + b.spin() * direction.turned_left().dot(point.place);
    [Some((s, rate)), Some((b.shape.face_length(face) - s, -rate))]
}

/// Room of `out`, which points out of a side where it touches at a vertex, before the faces that meet there; `out` changes at `rate`.
fn room_at_vertex(side: &Side<'_>, vertex: usize, (out, rate): (Vec2, Vec2)) -> Rooms {
    let shape = side.shape;
    if shape.faces() == 0 {
        return [None, None];
    }
    let turns = if shape.is_hollow(vertex) { -1.0 } else { 1.0 };
    [(shape.face_before(vertex), turns), (vertex, -turns)].map(|(face, sign)| {
        let direction = side.outward(face).turned_left();
        let turning = side.spin() * direction.turned_left().dot(out);
        Some((sign * direction.dot(out), sign * (direction.dot(rate) + turning)))
    })
}

/// Room of `out` on the side to which a vertex looks whose two faces are almost in line: the way back from such a vertex is almost before its faces too.
fn room_ahead(side: &Side<'_>, vertex: usize, (out, rate): (Vec2, Vec2)) -> Rooms {
    if side.shape.faces() == 0 {
        return [None, None];
    }
    let [before, after] = [side.shape.face_before(vertex), vertex].map(|face| side.outward(face));
    let ahead = before + after;
    let turning = side.spin() * ahead.turned_left().dot(out);
    [(before.dot(after) > 0.0).then(|| (ahead.dot(out), ahead.dot(rate) + turning)), None]
}

/// Those rooms of a vertex that end where one arc goes on in another: what a contact on a face runs off there, it does not lie down on.
fn room_before_joints(side: &Side<'_>, vertex: usize, out: (Vec2, Vec2)) -> Rooms {
    let shape = side.shape;
    if shape.is_hull() {
        return [None, None];
    }
    let [before, after] = room_at_vertex(side, vertex, out);
    let joins = |face: usize| shape.face_length(face) == 0.0;
    [before.filter(|_| joins(shape.face_before(vertex))), after.filter(|_| joins(vertex))]
}

/// The normal out of a face of `b`, towards a vertex of the other side, as long as that side is large, and its rate.
fn outward_of(b: &Side<'_>, face: usize, size: f64) -> (Vec2, Vec2) {
    let out = b.outward(face) * size;
    (out, out.turned_left() * b.spin())
}

/// The two sides of a pair, as it sees them.
struct Pair<'a> {
    a: Side<'a>,
    b: Side<'a>,
}

impl Pair<'_> {
    /// Rooms of the vertices that take part in a pair of features: of the body's, and of what it meets.
    fn cones(&self, feature: Feature, rooms: impl Fn(&Side<'_>, usize, (Vec2, Vec2)) -> Rooms) -> [Rooms; 2] {
        let (a, b) = (&self.a, &self.b);
        let size = a.shape.size();
        let back = |(out, rate): (Vec2, Vec2)| (-out, -rate);
        match feature {
            Feature::VertexOnFace { vertex, face } => {
                [rooms(a, vertex, back(outward_of(b, face, size))), [None; 2]]
            }
            Feature::FaceOnEnd { face, end } => [[None; 2], rooms(b, end, back(outward_of(a, face, size)))],
            Feature::VertexOnEnd { vertex, end } => {
                let (point, other) = (seen(a, vertex, b), b.vertex(end));
                let (d, rate) = (point.place - other, point.rate - other.turned_left() * b.spin());
                let within = a.radius(vertex) + b.radius(end) < 0.0;
                let out = if within { back((d, rate)) } else { (d, rate) };
                [rooms(a, vertex, back(out)), rooms(b, end, out)]
            }
        }
    }

    /// Rooms of a vertex on the face that it touches.
    fn on_face(&self, feature: Feature) -> Rooms {
        match feature {
            Feature::VertexOnFace { vertex, face } => room_on_face(&self.a, vertex, &self.b, face),
            Feature::FaceOnEnd { face, end } => room_on_face(&self.b, end, &self.a, face),
            Feature::VertexOnEnd { .. } => [None, None],
        }
    }
}

/// What stands still.
static STANDS: State =
    State { pose: Pose { centre: Vec2::ZERO, angle: 0.0 }, twist: Twist { velocity: Vec2::ZERO, spin: 0.0 } };

impl World {
    fn sides<'a>(&'a self, states: &'a [State], turns: &[Turn], pair: Pairing) -> Pair<'a> {
        let side = |b: usize| Side { shape: &self.bodies[b].shape, state: &states[b], turn: turns[b] };
        let b = match self.obstacles.get(pair.obstacle) {
            Some(o) => Side { shape: o.shape(), state: &STANDS, turn: Turn::NONE },
            None => side(pair.obstacle - self.obstacles.len()),
        };
        Pair { a: side(pair.body), b }
    }

    /// Kinematics of a pair of features of two bodies.
    ///
    /// # Source
    /// The gap and the velocities of the two points that touch, differentiated in time: the normal turns with the body whose face it is
    /// normal to, or with the line between two vertices.
    pub(super) fn between_bodies(&self, states: &[State], turns: &[Turn], pair: Pairing) -> Kinematics {
        let Pair { a, b } = self.sides(states, turns, pair);
        let k = match pair.feature {
            Feature::VertexOnFace { vertex, face } => vertex_on_face(&a, vertex, &b, face),
            Feature::FaceOnEnd { face, end } => from_the_other_side(vertex_on_face(&b, end, &a, face)),
            Feature::VertexOnEnd { vertex, end } => vertex_on_vertex(&a, vertex, &b, end),
        };
        Kinematics { gap: evaluated(Quantity::Gap, k.gap), ..k }
    }

    /// How far inside its features' extents a pair lies [m], and the rates of these distances [m/s]: negative where the contact point has run
    /// off. First come the ends of the face, of a contact on one; of two vertices the directions in which either can touch. Then come the directions of
    /// the vertex on a face, where one arc goes on in another. The others are `None`.
    pub(in crate::planar) fn extents(
        &self,
        states: &[State],
        turns: &[Turn],
        pair: Pairing,
    ) -> [Option<(f64, f64)>; 4] {
        if let Some(o) = self.obstacles.get(pair.obstacle)
            && self.body_of(pair).shape.is_hull()
            && o.shape().is_hull()
            && let Some([p, q]) = self.room_on_obstacle(&states[pair.body], turns[pair.body], pair, o)
        {
            return [Some(p), Some(q), None, None];
        }
        let of = self.sides(states, turns, pair);
        let ([p, q], [r, s]) = match pair.feature {
            Feature::VertexOnEnd { .. } => {
                let [own, met] = of.cones(pair.feature, room_at_vertex);
                (own, met)
            }
            _ => {
                let [own, met] = of.cones(pair.feature, room_before_joints);
                let joints = [0, 1].map(|i| own[i].or(met[i]));
                (of.on_face(pair.feature), joints)
            }
        };
        [p, q, r, s]
    }

    /// Everything that a pair of features needs to touch besides its gap, as rooms and their rates [m, m/s].
    pub(super) fn rooms(&self, states: &[State], turns: &[Turn], pair: Pairing) -> AllRooms {
        let of = self.sides(states, turns, pair);
        let [own, met] = of.cones(pair.feature, room_at_vertex);
        let [own_ahead, met_ahead] = of.cones(pair.feature, room_ahead);
        let with = |[a, b]: Rooms, [ahead, _]: Rooms| [a, b, ahead];
        AllRooms { face: of.on_face(pair.feature), own: with(own, own_ahead), met: with(met, met_ahead) }
    }
}
