//! What a shape can lie on: the lines that touch it at two points and leave all of it on one side.

use super::Shape;
use crate::tolerance::{COINCIDENT_VERTICES, SMOOTH_JOINT};
use carom_num::Vec2;
use carom_num::elementary::atan2;
use std::f64::consts::TAU;

/// A side on which a shape can lie, in its own frame: one of its faces, or a line across a hollow.
///
/// # Example
/// See [`Shape::rests`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rest {
    /// Unit normal out of the shape.
    pub normal: Vec2,
    /// Distance of the line from the mass centre [m].
    pub depth: f64,
    /// The two outermost points that touch the line, counter-clockwise [m].
    pub from: Vec2,
    /// The other one.
    pub to: Vec2,
    /// The first point belongs to this vertex.
    pub vertex: usize,
    /// The line runs along a face all the way, not across a hollow.
    pub is_face: bool,
}

impl Rest {
    /// By how much the mass centre lies inside the two points, along the line [m]: negative on either side where the shape tips over at once.
    ///
    /// # Example
    /// A square of 2 m tips over after 1 m either way.
    /// ```
    /// use carom_motion::planar::Shape;
    /// use carom_num::Vec2;
    /// let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Vec2::new(x, y));
    /// let square = Shape::new(corners.to_vec(), 0.0).unwrap();
    /// assert_eq!(square.rests()[0].inside(), [1.0, 1.0]);
    /// ```
    pub fn inside(&self) -> [f64; 2] {
        let along = self.normal.turned_left();
        [-along.dot(self.from), along.dot(self.to)]
    }
}

/// What an element of the outline is.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    /// An arc with the normals at its ends.
    Arc([Vec2; 2]),
    /// Where an arc starts, and where it ends.
    Start,
    End,
    Corner,
}

/// A part of the outline that may lie on the hull: a point, or an arc.
#[derive(Clone, Copy)]
struct Element {
    centre: Vec2,
    radius: f64,
    kind: Kind,
    vertex: usize,
}

/// Angle from one direction counter-clockwise to another, 0 to 2π; what is hardly before is none.
fn turn(from: Vec2, to: Vec2) -> f64 {
    let angle = atan2(from.cross(to), from.dot(to));
    if angle < -SMOOTH_JOINT { angle + TAU } else { angle.max(0.0) }
}

impl Element {
    fn faces(&self, normal: Vec2) -> bool {
        let Kind::Arc([from, to]) = self.kind else { return true };
        turn(from, normal) <= turn(from, to) + SMOOTH_JOINT
    }

    /// True where the next element is of the same arc and lies behind.
    fn is_past(&self, next: &Self) -> bool {
        self.vertex == next.vertex
            && matches!((self.kind, next.kind), (Kind::Arc(_), Kind::Start) | (Kind::End, Kind::Arc(_)))
    }

    /// The normal of the line that touches this element and then another one, and the distance of the two points.
    fn tangent(&self, next: &Self) -> Option<(Vec2, f64)> {
        let (chord, narrows) = (next.centre - self.centre, self.radius - next.radius);
        let squared = chord.dot(chord);
        // The end of an arc lies on it: what is left of the way there is rounding.
        let left = squared - narrows * narrows;
        let length = if left <= COINCIDENT_VERTICES * squared { 0.0 } else { left.sqrt() };
        if squared == 0.0 || narrows.abs() > chord.norm() * (1.0 + SMOOTH_JOINT) {
            return None;
        }
        let along = (chord * length + chord.turned_left() * narrows) / squared;
        let normal = along.turned_right();
        (self.faces(normal) && next.faces(normal)).then_some((normal, length))
    }

    fn touch(&self, normal: Vec2) -> Vec2 {
        self.centre + normal * self.radius
    }
}

impl Shape {
    /// The sides on which it can lie, counter-clockwise: of an evenly rounded hull its faces, by their numbers. Of any other shape they are
    /// numbered from that which starts at the lowest vertex; a line across a hollow is one of them, a face in a hollow is none.
    ///
    /// # Example
    /// An L lies on its two long sides, its two short ones, and across its hollow.
    /// ```
    /// use carom_motion::planar::{ChainPoint, Shape};
    /// use carom_num::Vec2;
    /// let corners = [(-1.0, -1.0), (2.0, -1.0), (2.0, 0.0), (0.0, 0.0), (0.0, 1.0), (-1.0, 1.0)];
    /// let l = Shape::of_chain(&corners.map(|(x, y)| ChainPoint::straight(Vec2::new(x, y)))).unwrap();
    /// let rests = l.rests();
    /// assert_eq!(rests.iter().map(|rest| rest.is_face).collect::<Vec<_>>(), [true, true, false, true, true]);
    /// assert_eq!((rests[2].from, rests[2].to), (Vec2::new(2.0, 0.0), Vec2::new(0.0, 1.0)));
    /// ```
    pub fn rests(&self) -> Vec<Rest> {
        if self.is_hull() {
            return (0..self.faces()).map(|face| self.rest_on(face)).collect();
        }
        let mut found = self.wrapped();
        let first = (0..found.len()).min_by_key(|i| found[*i].vertex).unwrap_or(0);
        found.rotate_left(first);
        found
    }

    /// How deep a point lies within the shape, in its own frame [m]: the distance from the outline, negative outside. A shape without thickness has
    /// no inside.
    ///
    /// # Example
    /// In the hollow of an L, and in its leg.
    /// ```
    /// use carom_motion::planar::{ChainPoint, Shape};
    /// use carom_num::Vec2;
    /// let corners = [(-1.0, -1.0), (2.0, -1.0), (2.0, 0.0), (0.0, 0.0), (0.0, 1.0), (-1.0, 1.0)];
    /// let l = Shape::of_chain(&corners.map(|(x, y)| ChainPoint::straight(Vec2::new(x, y)))).unwrap();
    /// assert_eq!(l.depth_of(Vec2::new(0.75, 0.25)), -0.25);
    /// assert_eq!(l.depth_of(Vec2::new(1.25, -0.25)), 0.25);
    /// ```
    pub fn depth_of(&self, point: Vec2) -> f64 {
        let mut nearest = f64::NEG_INFINITY;
        let mut take = |depth: f64| {
            if depth.abs() < nearest.abs() {
                nearest = depth;
            }
        };
        for face in 0..self.faces() {
            let (normal, from) = (self.face_normal(face), point - self.vertices()[face]);
            let along = normal.turned_left().dot(from);
            if along >= 0.0 && along <= self.face_length(face) && self.face_length(face) > 0.0 {
                take(self.radius_of(face) - normal.dot(from));
            }
        }
        for vertex in 0..self.vertices().len() {
            let (from, radius) = (point - self.vertices()[vertex], self.radius_of(vertex));
            let distance = from.norm();
            if radius == 0.0 {
                // What is nearest to a corner lies outside it, but in a hollow.
                take(if self.is_hollow(vertex) { distance } else { -distance });
            } else if self.normals_hold(vertex, from * radius.signum()) {
                take(radius - radius.signum() * distance);
            }
        }
        nearest
    }

    /// Where the segment between two points meets the outline's lines and circles, as shares of it; arcs count all round.
    pub fn cuts(&self, from: Vec2, to: Vec2) -> Vec<f64> {
        let run = to - from;
        let mut out = vec![];
        for face in 0..self.faces() {
            let (normal, start) = (self.face_normal(face), from - self.vertices()[face]);
            out.push((self.radius_of(face) - normal.dot(start)) / normal.dot(run));
        }
        for vertex in 0..self.vertices().len() {
            let (start, radius) = (from - self.vertices()[vertex], self.radius_of(vertex));
            // |start + s run| = r.
            let (a, b) = (run.dot(run), run.dot(start));
            let inside = b * b - a * (start.dot(start) - radius * radius);
            if inside >= 0.0 {
                out.extend([(-b - inside.sqrt()) / a, (-b + inside.sqrt()) / a]);
            }
        }
        out.retain(|share| *share > 0.0 && *share < 1.0);
        out.sort_by(f64::total_cmp);
        out
    }

    fn rest_on(&self, face: usize) -> Rest {
        let (normal, k) = (self.face_normal(face), self.vertices().len());
        let end = |v: usize| self.vertices()[v] + normal * self.radius_of(v);
        let (from, to) = (end(face), end((face + 1) % k));
        Rest { normal, depth: normal.dot(from), from, to, vertex: face, is_face: true }
    }

    /// Corners, arcs that are not hollow, and the ends of these.
    fn elements(&self) -> Vec<Element> {
        let mut out = vec![];
        for vertex in (0..self.vertices().len()).filter(|v| !self.is_hollow(*v)) {
            let (centre, radius) = (self.vertices()[vertex], self.radius_of(vertex));
            let point = |centre, kind| Element { centre, radius: 0.0, kind, vertex };
            if radius == 0.0 {
                out.push(point(centre, Kind::Corner));
                continue;
            }
            let ends = [self.face_normal(self.face_before(vertex)), self.face_normal(vertex)];
            out.push(Element { centre, radius, kind: Kind::Arc(ends), vertex });
            let end = |normal: Vec2, kind| point(centre + normal * radius, kind);
            out.extend([end(ends[0], Kind::Start), end(ends[1], Kind::End)]);
        }
        out
    }

    /// Goes round the shape with a line, from one element that it touches to the next.
    fn wrapped(&self) -> Vec<Rest> {
        let elements = self.elements();
        let down = Vec2::new(0.0, -1.0);
        let reach = |e: &Element| if e.faces(down) { down.dot(e.touch(down)) } else { f64::NEG_INFINITY };
        let Some(mut at) =
            (0..elements.len()).max_by(|i, j| reach(&elements[*i]).total_cmp(&reach(&elements[*j])))
        else {
            return vec![];
        };
        let (mut normal, mut turned, mut found) = (down, 0.0, Vec::<Rest>::new());
        // Each element is left at most a few times; a line that comes round is done.
        for _ in 0..4 * elements.len() {
            let others = (0..elements.len()).filter(|i| *i != at && !elements[at].is_past(&elements[*i]));
            let next = others.filter_map(|i| {
                let (to, length) = elements[at].tangent(&elements[i])?;
                Some((turn(normal, to), length, to, i))
            });
            // The least turn; of several, which are rounding, the farthest.
            let best = next.reduce(|a, b| {
                let same = (a.0 - b.0).abs() <= SMOOTH_JOINT;
                if same && b.1 > a.1 || !same && b.0 < a.0 { b } else { a }
            });
            let Some((angle, length, to, i)) = best else { return found };
            turned += angle;
            if turned > TAU + SMOOTH_JOINT {
                break;
            }
            // What it touches at the start it touches again at the end.
            if turned > SMOOTH_JOINT && length > COINCIDENT_VERTICES * self.size() {
                self.note(&mut found, (&elements[at], &elements[i]), to);
            }
            (at, normal) = (i, to);
        }
        found
    }

    fn note(&self, found: &mut Vec<Rest>, (a, b): (&Element, &Element), normal: Vec2) {
        let (from, to) = (a.touch(normal), b.touch(normal));
        let between = |face: usize| {
            let (normal_there, start) = (self.face_normal(face), self.vertices()[face]);
            let along = normal.turned_left();
            let reach = self.face_length(face) - (to - from).norm();
            normal_there.cross(normal).abs() <= SMOOTH_JOINT
                && normal_there.dot(normal) > 0.0
                && reach.abs() <= SMOOTH_JOINT * self.size()
                && along.dot(start - from).abs() <= SMOOTH_JOINT * self.size()
        };
        let is_face = (0..self.faces()).any(between);
        found.push(Rest { normal, depth: normal.dot(from), from, to, vertex: a.vertex, is_face });
    }
}
