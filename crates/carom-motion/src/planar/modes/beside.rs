//! Faces beside a contact's vertex: which of them can come to lie on what the vertex touches, and how far they stand off it.

use super::mode::Loaded;
use crate::planar::contact::{
    World,
    kinematics::{Pairing, Turn},
    touching::Few,
};
use crate::planar::geometry::{Feature, Shape};
use crate::tolerance::FLAT_SINE;
use carom_num::Vec2;

/// How many faces beside a vertex of `shape` can close on what it touches by turning about it.
fn faces_beside_vertex(shape: &Shape) -> usize {
    match shape.vertices().len() {
        1 => 0,
        2 if shape.is_hull() => 1,
        _ => 2,
    }
}

/// True where the face before (slot 0) or after (slot 1) a vertex can lie on another face: it has a length, and no end in a hollow.
fn lies_down(shape: &Shape, vertex: usize, slot: usize) -> bool {
    let before = shape.face_before(vertex);
    // The face before a vertex starts at the vertex that has its number.
    let (face, far) =
        if slot == 0 { (before, before) } else { (vertex, (vertex + 1) % shape.vertices().len()) };
    shape.is_hull() || shape.face_length(face) > 0.0 && !shape.is_hollow(far)
}

/// Sine of the angle by which the face before (slot 0) or after (slot 1) a vertex stands off a face with this normal.
fn stands_off(shape: &Shape, turn: Turn, vertex: usize, slot: usize, normal: Vec2) -> f64 {
    turn.undo(normal).dot(away_from(shape, vertex, slot))
}

/// Away from a vertex: along the face after it (slot 1), back along the one before.
fn away_from(shape: &Shape, vertex: usize, slot: usize) -> Vec2 {
    if slot == 0 {
        shape.face_normal(shape.face_before(vertex)).turned_right()
    } else {
        shape.face_normal(vertex).turned_left()
    }
}

impl World {
    /// The vertex of a pair that touches a face, and the shape that it belongs to.
    fn vertex_on_face(&self, pair: Pairing) -> Option<(&Shape, usize)> {
        match pair.feature {
            Feature::VertexOnFace { vertex, .. } => Some((&self.body_of(pair).shape, vertex)),
            Feature::FaceOnEnd { end, .. } => Some((self.met(pair), end)),
            Feature::VertexOnEnd { .. } => None,
        }
    }

    /// How many faces can close on what is touched by turning about this contact.
    pub(super) fn parallel_slots(&self, pair: Pairing) -> usize {
        self.vertex_on_face(pair).map_or(0, |(shape, _)| faces_beside_vertex(shape))
    }

    /// True where a vertex and a face touch in such a way that their frame rests or turns with the body alone, and their extents are those of the face.
    pub(in crate::planar) fn is_plain(&self, pair: Pairing) -> bool {
        let Some((shape, vertex)) = self.vertex_on_face(pair) else { return false };
        let joins = |face: usize| shape.face_length(face) == 0.0;
        let by_end = matches!(pair.feature, Feature::FaceOnEnd { .. });
        (shape.is_hull() || !joins(vertex) && !joins(shape.face_before(vertex)))
            && !(by_end && shape.radius_of(vertex) != 0.0)
    }

    /// True where face `slot` beside a pair's vertex can come to lie on the face that the vertex touches.
    pub(super) fn can_lie_down(&self, pair: Pairing, slot: usize) -> bool {
        self.vertex_on_face(pair).is_some_and(|(shape, vertex)| lies_down(shape, vertex, slot))
    }

    /// True where another held contact, on the same obstacle or on one in line with it, keeps face `slot` of this one on its obstacle.
    pub(super) fn lies_on(&self, turns: &[Turn], held: &Few<Loaded>, c: &Loaded, slot: usize) -> bool {
        let k = &c.kinematics;
        let keeps = |o: &Loaded| {
            let apart = (o.kinematics.arm - k.arm).dot(k.tangent()).abs();
            // Obstacles do not move against each other; bodies do.
            let together = |pair: Pairing| self.other_body(pair).is_none() && pair.body == c.held.pair.body;
            let same = o.held.pair.meeting() == c.held.pair.meeting();
            (same || (together(o.held.pair) && together(c.held.pair)))
                && o.kinematics.normal.cross(k.normal).abs() < FLAT_SINE
                && apart > FLAT_SINE * self.body_of(c.held.pair).shape.size()
        };
        held.iter().any(keeps) && self.parallel(turns, c.held.pair, slot).abs() < FLAT_SINE
    }

    /// Sine of the angle by which face `slot` (0: before the vertex, 1: after) stands off what is touched.
    pub(in crate::planar) fn parallel(&self, turns: &[Turn], pair: Pairing, slot: usize) -> f64 {
        let (shape, turn) = (&self.body_of(pair).shape, turns[pair.body]);
        let other = self.other_body(pair).map(|b| (&self.bodies[b].shape, turns[b]));
        match (pair.feature, other) {
            (Feature::VertexOnFace { vertex, face }, None) => {
                stands_off(shape, turn, vertex, slot, self.obstacles[pair.obstacle].normal(face))
            }
            (Feature::VertexOnFace { vertex, face }, Some((met, at))) => {
                stands_off(shape, turn, vertex, slot, at.apply(met.face_normal(face)))
            }
            (Feature::FaceOnEnd { face, end }, None) => {
                let met = self.obstacles[pair.obstacle].shape();
                let away = away_from(met, end, slot);
                turn.apply(shape.face_normal(face)).dot(away)
            }
            (Feature::FaceOnEnd { face, end }, Some((met, at))) => {
                stands_off(met, at, end, slot, turn.apply(shape.face_normal(face)))
            }
            (Feature::VertexOnEnd { .. }, _) => 1.0,
        }
    }
}
