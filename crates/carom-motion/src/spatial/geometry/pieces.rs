//! Convex pieces that are fixed to each other: which of their faces, edges and corners are outside.
//!
//! Where pieces lie along each other, an edge of one may be hidden in another one, or lie in a face that two of them share. Nothing may touch it there: all directions
//! in which it could be touched are inside. What is left is an edge about which the pieces together take less than half a turn, and a corner at which their edges lie to one side of a plane.

use super::polyhedron::Polyhedron;
use super::surface::{Edge, Facet, Surface};
use crate::tolerance::{HALF_TURN, POINTED};
use carom_num::Vec3;
use carom_num::elementary::atan2;
use carom_num::slack::Slacks;
use std::f64::consts::{PI, TAU};

/// Pieces, and what counts as one place \[m\].
struct Joined<'p> {
    each: &'p [Surface],
    near: f64,
}

/// Pieces and what of them is outside.
pub(super) struct Outside {
    /// Each piece, whole.
    pub(super) each: Vec<Surface>,
    /// All that may touch.
    pub(super) surface: Surface,
    /// The corners of each face of that, counter-clockwise as seen from outside.
    pub(super) polygons: Vec<Vec<Vec3>>,
}

/// What of pieces is outside; places no farther than `near` \[m\] from each other are one.
pub(super) fn outside(pieces: &[Polyhedron], near: f64) -> Outside {
    let each: Vec<Surface> = pieces.iter().map(|piece| Surface::of(piece, piece.vertices())).collect();
    let joined = Joined { each: &each, near };
    let (mut surface, mut polygons) = (Surface::default(), vec![]);
    for (number, (piece, own)) in pieces.iter().zip(&each).enumerate() {
        for (face, drawn) in own.faces.iter().zip(piece.faces()) {
            let polygon: Vec<Vec3> = drawn.corners.iter().map(|i| piece.vertices()[*i]).collect();
            for part in joined.seen_parts(number, polygon, face) {
                surface.faces.push(Facet { plane: face.plane, ..Facet::of(drawn.normal, &part) });
                polygons.push(part);
            }
        }
        surface.edges.extend(own.edges.iter().flat_map(|edge| joined.seen_of(number, edge)));
        for (place, inner) in own.corners.iter().zip(&own.spokes) {
            if let Some(inner) = joined.spokes(number, *place, inner) {
                surface.corners.push(*place);
                surface.spokes.push(inner);
            }
        }
    }
    let Surface { edges, corners, .. } = &mut surface;
    for edge in edges {
        edge.corners = edge.ends().map(|end| corners.iter().any(|corner| (*corner - end).norm() <= near));
    }
    Outside { each, surface, polygons }
}

impl Joined<'_> {
    fn others(&self, number: usize) -> impl Iterator<Item = (usize, &Surface)> {
        self.each.iter().enumerate().filter(move |(other, _)| *other != number)
    }

    /// The convex parts of a face of a piece that no other piece hides. Where two have one face the first of them tells it.
    fn seen_parts(&self, number: usize, polygon: Vec<Vec3>, face: &Facet) -> Vec<Vec<Vec3>> {
        let is_one = |other: &Facet| {
            let level = polygon.iter().all(|r| other.plane.height(*r).abs() <= self.near);
            level && other.plane.normal().dot(face.plane.normal()) > 0.0
        };
        let hides = |(other, piece): &(usize, &Surface)| *other < number || !piece.faces.iter().any(is_one);
        let hiding: Vec<&Surface> = self.others(number).filter(hides).map(|(_, piece)| piece).collect();
        hiding.into_iter().fold(vec![polygon], |parts, piece| {
            parts.into_iter().flat_map(|part| self.beside(piece, part)).collect()
        })
    }

    /// The parts of a polygon that are not in a piece, nor on it; all of it where the piece has no area of it.
    fn beside(&self, piece: &Surface, polygon: Vec<Vec3>) -> Vec<Vec<Vec3>> {
        let (mut parts, mut rest) = (vec![], polygon.clone());
        for Facet { plane, .. } in &piece.faces {
            let heights = || rest.iter().map(|r| plane.height(*r));
            if heights().all(|height| height >= -self.near) && heights().any(|height| height > self.near) {
                return vec![polygon];
            }
            if heights().any(|height| height > self.near) {
                parts.push(self.without_slivers(&plane.flipped().behind(&rest)));
                rest = self.without_slivers(&plane.behind(&rest));
            }
        }
        parts.retain(|part| part.len() > 2);
        parts
    }

    /// A polygon without sides shorter than what counts as one place.
    fn without_slivers(&self, polygon: &[Vec3]) -> Vec<Vec3> {
        let before = |k: usize| polygon[(k + polygon.len() - 1) % polygon.len()];
        let apart = |k: &usize| (polygon[*k] - before(*k)).norm() > self.near;
        (0..polygon.len()).filter(apart).map(|k| polygon[k]).collect()
    }

    fn has(&self, piece: &Surface, place: Vec3) -> bool {
        piece.faces.iter().all(|face| face.plane.height(place) <= self.near)
    }

    /// The parts of an edge of a piece that are edges of all of them.
    fn seen_of(&self, number: usize, edge: &Edge) -> Vec<Edge> {
        let mut cuts = vec![0.0, edge.length];
        cuts.extend(self.others(number).filter_map(|(_, other)| self.along(other, edge)).flatten());
        cuts.sort_by(f64::total_cmp);
        let spans = cuts.windows(2).filter(|span| span[1] - span[0] > self.near);
        spans.filter_map(|span| self.span(number, edge, span[0], span[1])).collect()
    }

    /// From where to where along it an edge is in a piece, or on it \[m\].
    fn along(&self, piece: &Surface, edge: &Edge) -> Option<[f64; 2]> {
        let [mut from, mut to] = [0.0, edge.length];
        for face in &piece.faces {
            let [first, last] = edge.ends().map(|end| face.plane.height(end));
            let crosses = edge.length * first / (first - last);
            match (first <= self.near, last <= self.near) {
                (true, true) => {}
                (true, false) => to = crosses.clamp(from, to),
                (false, true) => from = crosses.clamp(from, to),
                (false, false) => return None,
            }
        }
        (to - from > self.near).then_some([from, to])
    }

    /// A part of an edge along which the same pieces have it; `None` where they hide it, or where it is told of a piece before.
    fn span(&self, number: usize, edge: &Edge, from: f64, to: f64) -> Option<Edge> {
        let middle = edge.from + edge.along * (0.5 * (from + to));
        let mut sides = edge.sides.to_vec();
        for (other, piece) in self.others(number).filter(|(_, piece)| self.has(piece, middle)) {
            let normals: Vec<Vec3> = piece
                .faces
                .iter()
                .map(|face| &face.plane)
                .filter(|plane| plane.height(middle) >= -self.near)
                .map(|plane| plane.normal())
                .collect();
            // Inside, or within one face of it, it takes half a turn or more.
            let [first, second] = normals[..] else { return None };
            if other < number {
                return None;
            }
            let into = |normal: Vec3, beside: Vec3| {
                let across = normal.cross(edge.along).unit()?;
                Some(if across.dot(beside) < 0.0 { across } else { -across })
            };
            sides.extend([into(first, second)?, into(second, first)?]);
        }
        let sides = if sides.len() > 2 { outermost(edge, &sides)? } else { edge.sides };
        let outward = if sides == edge.sides { edge.outward } else { -(sides[0] + sides[1]) };
        Some(Edge { from: edge.from + edge.along * from, length: to - from, sides, outward, ..*edge })
    }

    /// Unit vectors from a corner of a piece along edges of all pieces that have it; `None` where they hide it, or where it is told of a piece before.
    fn spokes(&self, number: usize, place: Vec3, own: &[Vec3]) -> Option<Vec<Vec3>> {
        let mut spokes = own.to_vec();
        for (other, piece) in self.others(number).filter(|(_, piece)| self.has(piece, place)) {
            // Within an edge or a face of another piece it is no corner.
            let corner = piece.corners.iter().position(|corner| (*corner - place).norm() <= self.near)?;
            if other < number {
                return None;
            }
            spokes.extend(&piece.spokes[corner]);
        }
        (spokes.len() == own.len() || is_pointed(&spokes)).then_some(spokes)
    }
}

/// Of directions across an edge the two between which all others are, less than half a turn; `None` where there are no such two.
fn outermost(edge: &Edge, sides: &[Vec3]) -> Option<[Vec3; 2]> {
    let (x, y) = (sides[0], edge.along.cross(sides[0]));
    let angle = |side: &Vec3| atan2(side.dot(y), side.dot(x));
    let mut turned: Vec<(f64, Vec3)> = sides.iter().map(|side| (angle(side), *side)).collect();
    turned.sort_by(|a, b| a.0.total_cmp(&b.0));
    // Behind the last of them, seen along the edge, there is nothing for half a turn and more.
    let free = |k: usize| {
        let next = (k + 1) % turned.len();
        let gap = turned[next].0 - turned[k].0 + if next == 0 { TAU } else { 0.0 };
        (gap > PI + HALF_TURN).then(|| [turned[k].1, turned[next].1])
    };
    let [last, first] = (0..turned.len()).find_map(free)?;
    // The first face of an edge lies to the left of its direction.
    Some(if edge.along.cross(last).dot(edge.sides[0]) > 0.0 { [first, last] } else { [last, first] })
}

/// There is a direction in which all of these have a positive share; of more than there is room for it is taken to be there, as a corner too many takes nothing away from the others.
fn is_pointed(spokes: &[Vec3]) -> bool {
    let mut slacks = Slacks::<ROOM>::of(3);
    for bound in [-1.0, 1.0] {
        (0..3).for_each(|k| slacks.push(1.0, |j| if j == k { bound } else { 0.0 }));
    }
    spokes.iter().for_each(|spoke| slacks.push(0.0, |j| spoke.to_array()[j]));
    slacks.largest_smallest(1.0).is_none_or(|(_, least)| least > POINTED)
}

/// Half the room for edges at one corner, of all pieces.
const ROOM: usize = 64;
