//! Joints: where an end of an obstacle lies on another one, the two are one corner.
//!
//! Into such a corner the face of each goes on to the other, and no further: lengthened by a hair behind the other, it would be the same to
//! whatever lies in the corner. So the end of one is no end there that a point runs off, and no point that a face of a body can lie on.

use super::World;
use super::kinematics::{Kinematics, Pairing};
use crate::planar::geometry::{Feature, Obstacle, Shape};
use crate::tolerance::{IN_LINE_SINE, JOINED_ENDS};
use carom_num::Vec2;

/// Where an obstacle lies that is joined to another, seen from a line through the joint.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Lie {
    /// Some of it above.
    Above,
    /// Along the line.
    Along,
    /// Below.
    Below,
}

impl Obstacle {
    /// True where a point lies on one of its faces, up to `slack` [m].
    fn carries(&self, point: Vec2, slack: f64) -> bool {
        if self.is_segment() {
            // Both of its faces are one line.
            let from_start = point - self.from();
            let along = self.direction().dot(from_start);
            return self.direction().cross(from_start).abs() <= slack
                && along >= -slack
                && along <= self.length() + slack;
        }
        let shape = self.shape();
        (0..shape.faces()).any(|face| {
            let (normal, from_start) = (shape.face_normal(face), point - shape.vertices()[face]);
            let along = normal.turned_left().dot(from_start);
            (normal.dot(from_start) - shape.radius_of(face)).abs() <= slack
                && along >= -slack
                && along <= shape.face_length(face) + slack
        })
    }
}

impl World {
    /// How far beyond a joint a face counts as going on [m].
    pub(in crate::planar) fn hair(&self, pair: Pairing) -> f64 {
        JOINED_ENDS * self.body_of(pair).shape.size()
    }

    /// How an obstacle lies to the line through an end of a pair's obstacle at right angles to `normal`; directions are known up to `sine`.
    fn lie(&self, pair: Pairing, of: &Obstacle, at: Vec2, (normal, sine): (Vec2, f64)) -> Lie {
        let most = self.hair(pair) + sine.max(IN_LINE_SINE) * (self.body_of(pair).shape.size() + of.length());
        let shape = of.shape();
        let along = || shape.vertices().iter().map(|end| normal.dot(*end - at));
        let reach = |v: usize| shape.radius_of(v).max(0.0);
        let highest = along().enumerate().map(|(v, s)| s + reach(v)).fold(f64::NEG_INFINITY, f64::max);
        let lowest = along().enumerate().map(|(v, s)| s - reach(v)).fold(f64::INFINITY, f64::min);
        if highest > most {
            Lie::Above
        } else if lowest < -most {
            Lie::Below
        } else {
            Lie::Along
        }
    }

    /// The obstacles on which this end of a pair's obstacle lies.
    fn joined(&self, pair: Pairing, at: Vec2) -> impl Iterator<Item = &Obstacle> {
        let hair = self.hair(pair);
        let others = self.obstacles.iter().enumerate().filter(move |(i, _)| *i != pair.obstacle);
        others.map(|(_, o)| o).filter(move |o| o.carries(at, hair))
    }

    /// True where a pair does not run off this end of its features' extents (by its place among [`World::extents`]), as a face ends there in a
    /// corner that turns towards what touches it, or what it would run into is joined there.
    #[inline]
    pub(in crate::planar) fn goes_on(&self, pair: Pairing, slot: usize) -> bool {
        let own = self.obstacles.get(pair.obstacle);
        let (shape, face, fixed) = match pair.feature {
            _ if slot > 1 => return false,
            Feature::VertexOnFace { face, .. } => (self.met(pair), face, own),
            Feature::FaceOnEnd { face, .. } => (&self.body_of(pair).shape, face, None),
            Feature::VertexOnEnd { .. } => return false,
        };
        let next = face + slot;
        let end = if next == shape.vertices().len() { 0 } else { next };
        shape.is_hollow(end) && shape.radius_of(end) == 0.0
            || fixed.is_some_and(|own| self.rises_above(pair, own.normal(face), shape.vertices()[end]))
    }

    /// True where what is joined to a pair's obstacle at its end there rises above this face of it.
    fn rises_above(&self, pair: Pairing, normal: Vec2, end: Vec2) -> bool {
        self.joined(pair, end).any(|o| self.lie(pair, o, end, (normal, IN_LINE_SINE)) == Lie::Above)
    }

    /// True where two pairs at one point are two faces that meet in an inner corner, with a vertex in it: each keeps it from another side.
    pub(in crate::planar) fn are_inner_corner(&self, a: Pairing, b: Pairing) -> bool {
        let (shape, f, g) = match (a.feature, b.feature) {
            (Feature::VertexOnFace { vertex: v, face: f }, Feature::VertexOnFace { vertex: w, face: g })
                if v == w =>
            {
                (self.met(a), f, g)
            }
            (Feature::FaceOnEnd { face: f, end: v }, Feature::FaceOnEnd { face: g, end: w }) if v == w => {
                (&self.body_of(a).shape, f, g)
            }
            _ => return false,
        };
        let k = shape.vertices().len();
        let inner = |end: usize| shape.is_hollow(end) && shape.radius_of(end) == 0.0;
        a.meeting() == b.meeting() && (inner(g) && (f + 1) % k == g || inner(f) && (g + 1) % k == f)
    }

    /// True where two pairs are the two faces of an inner corner with a sharp vertex in it: where both are held, or one of them sticks, it stays there.
    pub(in crate::planar) fn pins(&self, a: Pairing, b: Pairing) -> bool {
        let (shape, vertex) = match a.feature {
            Feature::VertexOnFace { vertex, .. } => (&self.body_of(a).shape, vertex),
            Feature::FaceOnEnd { end, .. } => (self.met(a), end),
            Feature::VertexOnEnd { .. } => return false,
        };
        let radius = if self.other_body(a).is_some() { Shape::skin } else { Shape::radius_of };
        radius(shape, vertex) == 0.0 && self.are_inner_corner(a, b)
    }

    /// True where a pair is a body's face or rounded vertex on an end that nothing of a body can reach: the corner of a joint. Directions are
    /// known up to `sine`.
    pub(in crate::planar) fn is_in_corner(&self, pair: Pairing, k: &Kinematics, sine: f64) -> bool {
        let (Feature::FaceOnEnd { end, .. } | Feature::VertexOnEnd { end, .. }, Some(own)) =
            (pair.feature, self.obstacles.get(pair.obstacle))
        else {
            return false;
        };
        let shape = &self.body_of(pair).shape;
        let thin = shape.is_thin_rod();
        let (at, line) = (own.end(end), (k.normal, sine));
        self.joined(pair, at).any(|o| match self.lie(pair, o, at, line) {
            Lie::Above => true,
            // A rod in line with what is joined lies on that, on either side of it: the end of the other is not under it but before it.
            Lie::Along => thin && self.lie(pair, own, at, line) == Lie::Below,
            Lie::Below => false,
        })
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use super::*;
    use crate::planar::geometry::Body;
    use carom_impact::Law;

    /// Obstacles given by their ends, around a disc of 1 m.
    fn world(ends: &[[(f64, f64); 2]]) -> World {
        let body = Body { shape: Shape::new(vec![Vec2::ZERO], 1.0).unwrap(), mass: 1.0, inertia: 0.5 };
        let point = |(x, y): (f64, f64)| Vec2::new(x, y);
        let obstacles = ends.iter().map(|[a, b]| Obstacle::new(point(*a), point(*b), 0.2, 0.5)).collect();
        World::of_one(Vec2::new(0.0, -9.81), body, obstacles, Law::Poisson)
    }

    /// Whether the upper side of a floor from (−1, 0) to the origin goes on at its end there, where the second obstacle is this one.
    fn goes_on(second: [(f64, f64); 2]) -> bool {
        let feature = Feature::VertexOnFace { vertex: 0, face: Obstacle::LEFT };
        let pair = Pairing { body: 0, obstacle: 0, feature };
        // The left face runs from the origin back.
        world(&[[(-1.0, 0.0), (0.0, 0.0)], second]).goes_on(pair, 0)
    }

    #[test]
    fn a_face_goes_on_where_what_is_joined_rises_on_its_own_side() {
        for (name, second, expected) in [
            ("a wall up from the end", [(0.0, 0.0), (0.0, 1.0)], true),
            ("the same wall, drawn downwards", [(0.0, 1.0), (0.0, 0.0)], true),
            ("a wall that leans over the floor", [(0.0, 0.0), (-1.0, 1.0)], true),
            ("a ramp on which the floor ends midway", [(-1.0, -0.5), (1.0, 0.5)], true),
            ("a wall down from the end", [(0.0, 0.0), (0.0, -1.0)], false),
            ("a floor in line", [(0.0, 0.0), (1.0, 0.0)], false),
            ("a wall beyond a gap", [(1e-6, 0.0), (1e-6, 1.0)], false),
            ("a wall at the other end", [(-1.0, 0.0), (-1.0, 1.0)], false),
        ] {
            assert_eq!(goes_on(second), expected, "{name}");
        }
    }
}
