//! A line that goes once round a shape: which corner or arc it touches in which directions.

use super::Shape;
use crate::tolerance::{SHORTEST_SIDE, SMOOTH_JOINT};
use carom_num::Vec2;
use carom_num::elementary::atan2;
use std::f64::consts::TAU;

/// A corner or an arc that a line round the shape touches, and the normals out of the shape between which it does.
#[derive(Clone, Copy, Debug)]
pub(super) struct Support {
    pub(super) centre: Vec2,
    pub(super) radius: f64,
    pub(super) from: Vec2,
    pub(super) to: Vec2,
    pub(super) vertex: usize,
    /// It is all that is touched.
    pub(super) alone: bool,
}

impl Support {
    pub(super) fn touch(&self, normal: Vec2) -> Vec2 {
        self.centre + normal * self.radius
    }

    /// True where a normal lies between its ends, and not at one of them.
    pub(super) fn has_within(&self, normal: Vec2) -> bool {
        self.alone || {
            let at = turn(self.from, normal);
            at > SMOOTH_JOINT && at < turn(self.from, self.to) - SMOOTH_JOINT
        }
    }

    /// The normal with which the mass centre is highest above it; none where it does not touch so.
    pub(super) fn highest(&self) -> Option<Vec2> {
        let out = self.centre.unit()?;
        (self.alone || turn(self.from, out) <= turn(self.from, self.to) + SMOOTH_JOINT).then_some(out)
    }
}

/// Angle from one direction counter-clockwise to another, 0 to 2π; what is hardly before is none.
pub(super) fn turn(from: Vec2, to: Vec2) -> f64 {
    let angle = atan2(from.cross(to), from.dot(to));
    if angle < -SMOOTH_JOINT { angle + TAU } else { angle.max(0.0) }
}

/// What may lie on the hull: a point, or an arc with its normals at both ends and the points there.
#[derive(Clone, Copy)]
struct Element {
    centre: Vec2,
    radius: f64,
    ends: Option<([Vec2; 2], [usize; 2])>,
    vertex: usize,
}

impl Element {
    fn faces(&self, normal: Vec2) -> bool {
        self.ends.is_none_or(|([from, to], _)| turn(from, normal) <= turn(from, to) + SMOOTH_JOINT)
    }

    fn reach(&self, normal: Vec2) -> f64 {
        if self.faces(normal) { normal.dot(self.centre) + self.radius } else { f64::NEG_INFINITY }
    }

    /// The normal of the line that touches this element and then another one, and the distance of the two points.
    fn tangent(&self, next: &Self, size: f64) -> Option<(Vec2, f64)> {
        let (chord, narrows) = (next.centre - self.centre, self.radius - next.radius);
        let squared = chord.dot(chord);
        let left = squared - narrows * narrows;
        // What lies on an arc has no line of its own with it.
        if left <= (SHORTEST_SIDE * size) * (SHORTEST_SIDE * size) {
            return None;
        }
        let length = left.sqrt();
        let along = (chord * length + chord.turned_left() * narrows) / squared;
        let normal = along.turned_right();
        (self.faces(normal) && next.faces(normal)).then_some((normal, length))
    }
}

/// Points and arcs of a shape, each place once.
struct Elements {
    all: Vec<Element>,
    size: f64,
}

impl Elements {
    fn of(shape: &Shape) -> Self {
        let mut out = Self { all: vec![], size: shape.size() };
        for vertex in (0..shape.vertices().len()).filter(|v| !shape.is_hollow(*v)) {
            let (centre, radius) = (shape.vertices()[vertex], shape.radius_of(vertex));
            if radius == 0.0 {
                out.point(centre, vertex);
                continue;
            }
            if shape.faces() == 0 {
                out.all.push(Element { centre, radius, ends: None, vertex });
                continue;
            }
            let normals = [shape.face_normal(shape.face_before(vertex)), shape.face_normal(vertex)];
            let points = normals.map(|normal| out.point(centre + normal * radius, vertex));
            out.all.push(Element { centre, radius, ends: Some((normals, points)), vertex });
        }
        out
    }

    /// The number of a point, which may be there already.
    fn point(&mut self, at: Vec2, vertex: usize) -> usize {
        let near = SHORTEST_SIDE * self.size;
        let same = |e: &Element| e.radius == 0.0 && (e.centre - at).norm() <= near;
        self.all.iter().position(same).unwrap_or_else(|| {
            self.all.push(Element { centre: at, radius: 0.0, ends: None, vertex });
            self.all.len() - 1
        })
    }

    /// The element that the line touches next, by how far it turns until then and how far away it is.
    fn next(&self, at: usize, normal: Vec2) -> Option<(f64, f64, Vec2, usize)> {
        let here = &self.all[at];
        let to = |i: usize| {
            let there = &self.all[i];
            // From an arc to the point where it ends, and from a point to the arc that starts there, the line only turns.
            let joint = match (here.ends, there.ends) {
                (Some(([_, last], [_, end])), None) if end == i => Some(last),
                (None, Some(([first, _], [start, _]))) if start == at => Some(first),
                (Some((_, [start, end])), None) if start == i || end == i => return None,
                (None, Some((_, [start, end]))) if start == at || end == at => return None,
                _ => None,
            };
            let (to, length) = match joint {
                Some(normal) => (normal, 0.0),
                None => here.tangent(there, self.size)?,
            };
            Some((turn(normal, to), length, to, i))
        };
        let each = (0..self.all.len()).filter(|i| *i != at).filter_map(to);
        // The least turn; of several, which are rounding, the farthest.
        each.reduce(|a, b| {
            let same = (a.0 - b.0).abs() <= SMOOTH_JOINT;
            if same && b.1 > a.1 || !same && b.0 < a.0 { b } else { a }
        })
    }
}

impl Shape {
    /// What a line that goes round the shape touches, counter-clockwise.
    pub(super) fn supports(&self) -> Vec<Support> {
        let elements = Elements::of(self);
        let down = Vec2::new(0.0, -1.0);
        let lowest = |i: &usize| elements.all[*i].reach(down);
        let Some(mut at) = (0..elements.all.len()).max_by(|i, j| lowest(i).total_cmp(&lowest(j))) else {
            return vec![];
        };
        // Of several points on one line it begins with the last: what lies between is none of its own.
        if let Some((angle, _, _, next)) = elements.next(at, down)
            && angle <= SMOOTH_JOINT
        {
            at = next;
        }
        let (mut normal, mut turned) = (down, 0.0);
        let mut found: Vec<Support> = vec![];
        // Each element is left at most a few times; a line that comes round is done.
        for _ in 0..4 * elements.all.len() {
            let Element { centre, radius, vertex, .. } = elements.all[at];
            let Some((angle, _, to, next)) = elements.next(at, normal) else { break };
            turned += angle;
            if turned > TAU + SMOOTH_JOINT {
                break;
            }
            found.push(Support { centre, radius, from: normal, to, vertex, alone: false });
            (at, normal) = (next, to);
        }
        let Some(first) = found.first().copied() else {
            // A single corner or disc is touched all round.
            let Element { centre, radius, vertex, .. } = elements.all[at];
            return vec![Support { centre, radius, from: down, to: down, vertex, alone: true }];
        };
        // The line began in the middle of what it touched first: that is where it ends as well.
        let Element { vertex, centre, .. } = elements.all[at];
        if (vertex, centre) == (first.vertex, first.centre) {
            found[0].from = normal;
        }
        found
    }
}
