//! The one shape: a closed chain of arcs and segments.

use super::rest::FoundRests;
use super::shape_problem::{ShapeProblem, problems_of};
use crate::tolerance::{COINCIDENT_VERTICES, ROD_SKIN};
use carom_num::Vec2;

/// The region within a closed chain of arcs and segments, drawn about the mass centre.
///
/// Its *vertices* are the centres of the arcs, each with a signed radius: 0 for a corner, negative where the outline is hollow. Its *faces* are the
/// segments between them, which touch both arcs; where one arc goes on in another there is a face without length. Vertices and faces run
/// counter-clockwise in turn: face i goes from vertex i to vertex i + 1, and its outward normal is that direction turned right.
///
/// The hull of k points, rounded evenly ([`Shape::new`]), is the common case: a disc is k = 1, a rod k = 2, whose two opposed faces are 0 (from
/// vertex 0 to vertex 1) and 1, a convex polygon k ≥ 3. Any other outline is made [from a chain](Shape::of_chain).
///
/// # Example
/// A square of 2 m, rounded by 0.1 m: its corners reach `√2 + 0.1` m from the centre.
/// ```
/// use carom_motion::planar::Shape;
/// use carom_num::Vec2;
/// let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Vec2::new(x, y));
/// let square = Shape::new(corners.to_vec(), 0.1).unwrap();
/// assert_eq!(square.face_normal(0), Vec2::new(0.0, -1.0));
/// assert_eq!(square.size(), 2f64.sqrt() + 0.1);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    vertices: Vec<Vec2>,
    /// Signed radii of the arcs about the vertices [m].
    radii: Vec<f64>,
    /// Where the outline turns right: about an arc of negative radius, or in a corner.
    hollow: Vec<bool>,
    /// Outward unit normals of the faces.
    normals: Vec<Vec2>,
    /// Lengths of the faces [m].
    lengths: Vec<f64>,
    /// Largest distance of a vertex from the mass centre, without the radius [m].
    reach: f64,
    /// Largest distance of a point of the outline from the mass centre [m].
    size: f64,
    /// A convex polygon around it, of a shape that is no evenly rounded hull itself.
    hull: Option<Box<Shape>>,
    pub(super) rests: FoundRests,
}

/// Arcs and faces of a chain, in turn, while they are put together.
#[derive(Default)]
pub(super) struct Parts {
    /// Centre and signed radius of each arc, and whether the outline turns right there.
    arcs: Vec<(Vec2, f64, bool)>,
    /// Direction of the face before each arc, and whether there is a straight edge there.
    before: Vec<(Vec2, bool)>,
    along: Vec2,
    straight: bool,
}

impl Parts {
    /// The outline runs in this direction here: what comes next begins, or what was last ended.
    pub(super) fn runs(&mut self, along: Vec2) {
        self.along = along;
    }

    /// A straight edge follows, in this direction.
    pub(super) fn edge(&mut self, along: Vec2) {
        (self.along, self.straight) = (along, true);
    }

    /// An arc follows.
    pub(super) fn arc(&mut self, centre: Vec2, radius: f64, hollow: bool) {
        self.arcs.push((centre, radius, hollow));
        self.before.push((self.along, std::mem::take(&mut self.straight)));
    }

    /// Directions and lengths of the faces, each from one arc to the next.
    fn faces(&self) -> impl Iterator<Item = (Vec2, f64)> {
        let k = self.arcs.len();
        let faces = if k == 1 { 0 } else { k };
        (0..faces).map(move |i| {
            let ((from, r, _), (to, s, _)) = (self.arcs[i], self.arcs[(i + 1) % k]);
            // The edges before the first arc may have been the last of the chain.
            let (along, straight) = self.before[(i + 1) % k];
            if !(straight || (i + 1) % k == 0 && self.straight) {
                return (along, 0.0);
            }
            // The segment that touches both arcs.
            let (chord, narrows) = (to - from, r - s);
            let length = (chord.dot(chord) - narrows * narrows).sqrt();
            ((chord * length + chord.turned_left() * narrows) / chord.dot(chord), length)
        })
    }
}

impl Shape {
    /// A shape from vertices about the mass centre [m], counter-clockwise, and a radius [m].
    ///
    /// # Errors
    /// Every [`ShapeProblem`] found.
    ///
    /// # Example
    /// A point is no shape, a disc is.
    /// ```
    /// use carom_motion::planar::{Shape, ShapeProblem};
    /// use carom_num::Vec2;
    /// assert_eq!(Shape::new(vec![Vec2::ZERO], 0.0), Err(vec![ShapeProblem::PointWithoutRadius]));
    /// assert_eq!(Shape::new(vec![Vec2::ZERO], 0.5).unwrap().size(), 0.5);
    /// ```
    pub fn new(vertices: Vec<Vec2>, radius: f64) -> Result<Self, Vec<ShapeProblem>> {
        let problems = problems_of(&vertices, radius);
        if !problems.is_empty() {
            return Err(problems);
        }
        Ok(Self::of_checked(vertices, radius))
    }

    /// A shape from vertices and a radius that [`Shape::new`] would accept.
    pub(in crate::planar) fn of_checked(vertices: Vec<Vec2>, radius: f64) -> Self {
        let reach = vertices.iter().map(|v| v.norm()).fold(0.0, f64::max);
        let k = vertices.len();
        let (radii, hollow) = (vec![radius; k], vec![false; k]);
        let (size, normals, lengths) = (reach + radius, vec![], vec![]);
        let rests = FoundRests::default();
        let mut shape = Self { vertices, radii, hollow, reach, size, normals, lengths, hull: None, rests };
        for face in 0..shape.faces() {
            let (a, b) = shape.face(face);
            let length = (b - a).norm();
            shape.normals.push((b - a).turned_right() / length);
            shape.lengths.push(length);
        }
        shape
    }

    /// A shape of arcs and faces in turn.
    pub(super) fn of_parts(parts: &Parts) -> Self {
        let vertices: Vec<Vec2> = parts.arcs.iter().map(|arc| arc.0).collect();
        let radii: Vec<f64> = parts.arcs.iter().map(|arc| arc.1).collect();
        let hollow: Vec<bool> = parts.arcs.iter().map(|arc| arc.2).collect();
        let reach = vertices.iter().map(|v| v.norm()).fold(0.0, f64::max);
        let faces: Vec<(Vec2, f64)> = parts.faces().collect();
        let normals = faces.iter().map(|face| face.0.turned_right()).collect();
        let lengths: Vec<f64> = faces.iter().map(|face| face.1).collect();
        // Radii that differ by rounding are one.
        let slack = COINCIDENT_VERTICES * reach;
        let even =
            radii.iter().all(|r| (*r - radii[0]).abs() <= slack && *r >= 0.0) && !hollow.contains(&true);
        if even && lengths.iter().all(|l| *l > 0.0) {
            return Self::of_checked(vertices, radii[0]);
        }
        let rests = FoundRests::default();
        let mut shape =
            Self { vertices, radii, hollow, normals, lengths, reach, size: reach, hull: None, rests };
        shape.size = shape.farthest();
        shape.hull = Some(Box::new(Self::of_checked(shape.cover(), 0.0)));
        shape
    }

    /// The farthest point of the outline from the mass centre [m].
    fn farthest(&self) -> f64 {
        let of_arc = |i: usize| {
            let (centre, radius) = (self.vertices[i], self.radii[i]);
            // Straight out from the centre where the arc goes through there, else at one of its ends.
            if self.normals.is_empty() || radius > 0.0 && self.normals_hold(i, centre) {
                return centre.norm() + radius;
            }
            let end = |face: usize| (centre + self.normals[face] * radius).norm();
            end(self.face_before(i)).max(end(i))
        };
        (0..self.vertices.len()).map(of_arc).fold(0.0, f64::max)
    }

    /// True where a direction out of the arc about a vertex is one of the arc's.
    pub(in crate::planar) fn normals_hold(&self, vertex: usize, out: Vec2) -> bool {
        if self.faces() == 0 {
            return true;
        }
        let (before, after) = (self.normals[self.face_before(vertex)], self.normals[vertex]);
        let side = if self.hollow[vertex] { -1.0 } else { 1.0 };
        side * before.cross(out) >= 0.0 && side * out.cross(after) >= 0.0
    }

    /// Corners of a convex polygon around the outline, counter-clockwise: an arc lies within the tangents at its ends.
    fn cover(&self) -> Vec<Vec2> {
        let mut points = vec![];
        for (i, (centre, radius)) in self.vertices.iter().zip(&self.radii).enumerate() {
            let (a, b) = (self.normals[self.face_before(i)], self.normals[i]);
            points.extend([*centre + a * *radius, *centre + b * *radius]);
            if *radius > 0.0 {
                // Between the normals at its ends, the way that it turns: after half a turn their sum has no direction.
                let middle = (b - a).turned_right().unit().unwrap_or(a);
                let corner = |n: Vec2| *centre + (n + middle) * (*radius / (1.0 + n.dot(middle)));
                points.extend([corner(a), corner(b)]);
            }
        }
        convex_hull(points, COINCIDENT_VERTICES * self.size)
    }

    /// The same shape, about a mass centre that lies elsewhere: all of its points move by `by` [m].
    ///
    /// # Example
    /// ```
    /// use carom_motion::planar::Shape;
    /// use carom_num::Vec2;
    /// let disc = Shape::new(vec![Vec2::ZERO], 0.5).unwrap();
    /// assert_eq!(disc.shifted(Vec2::new(0.1, 0.0)).size(), 0.6);
    /// ```
    #[must_use]
    pub fn shifted(&self, by: Vec2) -> Self {
        let hull = self.hull.as_ref().map(|hull| Box::new(hull.shifted(by)));
        let vertices: Vec<Vec2> = self.vertices.iter().map(|v| *v + by).collect();
        let reach = vertices.iter().map(|v| v.norm()).fold(0.0, f64::max);
        // What it can lie on depends on where its mass centre is.
        let mut out = Self { vertices, reach, hull, rests: FoundRests::default(), ..self.clone() };
        out.size = out.farthest();
        out
    }

    /// The vertices, about the mass centre, in the body's frame [m].
    pub fn vertices(&self) -> &[Vec2] {
        &self.vertices
    }

    /// The signed radius of the arc about a vertex [m]: 0 for a corner, negative where the outline is hollow.
    pub fn radius_of(&self, vertex: usize) -> f64 {
        self.radii[vertex]
    }

    /// True where the outline turns right about a vertex: in a corner, or along an arc of negative radius.
    pub fn is_hollow(&self, vertex: usize) -> bool {
        self.hollow[vertex]
    }

    /// A convex shape around this one, with all of its arcs of one radius: itself, where it is such a shape.
    ///
    /// # Example
    /// ```
    /// use carom_motion::planar::Shape;
    /// use carom_num::Vec2;
    /// let disc = Shape::new(vec![Vec2::ZERO], 0.5).unwrap();
    /// assert!(disc.is_hull() && std::ptr::eq(disc.hull(), &disc));
    /// ```
    pub fn hull(&self) -> &Self {
        self.hull.as_deref().unwrap_or(self)
    }

    /// True where the shape is the hull of its vertices, rounded evenly.
    pub fn is_hull(&self) -> bool {
        self.hull.is_none()
    }

    /// The radius that rounds the hull of the vertices evenly [m]; of any other shape that of its [`Shape::hull`], 0.
    pub fn radius(&self) -> f64 {
        self.hull().radii[0]
    }

    /// The radius that counts where two bodies touch [m]: that of the arc about a vertex, but for a rod without thickness a millionth of its size, so
    /// that the end of one can push the end of another.
    ///
    /// # Example
    /// A rod of 1 m without thickness reaches half a metre from its centre and has a skin of a millionth of
    /// that.
    /// ```
    /// use carom_motion::planar::Shape;
    /// use carom_num::Vec2;
    /// let rod = Shape::new(vec![Vec2::new(-0.5, 0.0), Vec2::new(0.5, 0.0)], 0.0).unwrap();
    /// assert_eq!((rod.radius(), rod.skin(0)), (0.0, 0.5e-6));
    /// ```
    pub fn skin(&self, vertex: usize) -> f64 {
        if self.is_thin_rod() { ROD_SKIN * self.size() } else { self.radii[vertex] }
    }

    /// True where any of its arcs has a radius.
    pub(in crate::planar) fn is_round(&self) -> bool {
        self.radii.iter().any(|r| *r != 0.0)
    }

    /// True for a disc about its mass centre.
    pub(in crate::planar) fn is_disc(&self) -> bool {
        self.vertices.iter().all(|v| *v == Vec2::ZERO)
    }

    /// True for a straight rod without thickness.
    pub(in crate::planar) fn is_thin_rod(&self) -> bool {
        self.radii[0] == 0.0 && self.vertices.len() == 2
    }

    /// True for an outline without thickness: it runs from its first vertex to the one in the middle of the list, and back on the same line.
    pub(in crate::planar) fn runs_there_and_back(&self) -> bool {
        let (count, last) = (self.vertices.len(), self.vertices.len() / 2);
        let back = |v: usize| {
            let same = self.vertices[v] == self.vertices[count - v];
            same && self.radii[v] == -self.radii[count - v]
        };
        last > 0
            && count == 2 * last
            && self.radii[0] == 0.0
            && self.radii[last] == 0.0
            && (1..last).all(back)
    }

    /// The face that ends at a vertex.
    pub(in crate::planar) fn face_before(&self, vertex: usize) -> usize {
        if vertex == 0 { self.vertices.len() - 1 } else { vertex - 1 }
    }

    /// Number of faces: 0 for a disc, 2 for a rod, else the number of vertices.
    pub fn faces(&self) -> usize {
        if self.vertices.len() == 1 { 0 } else { self.vertices.len() }
    }

    /// The two ends of face `i` (from, to) in the body's frame, without the radius.
    pub fn face(&self, i: usize) -> (Vec2, Vec2) {
        let k = self.vertices.len();
        (self.vertices[i % k], self.vertices[(i + 1) % k])
    }

    /// Outward unit normal of face `i` in the body's frame.
    pub fn face_normal(&self, i: usize) -> Vec2 {
        self.normals[i]
    }

    /// Length of face `i`, without the radius [m]: 0 where one arc goes on in another.
    pub fn face_length(&self, i: usize) -> f64 {
        self.lengths[i]
    }

    /// Largest distance of a vertex from the mass centre [m], the radius not counted.
    pub fn reach(&self) -> f64 {
        self.reach
    }

    /// The part's size [m]: largest distance of a point from the mass centre.
    pub fn size(&self) -> f64 {
        self.size
    }
}

/// The convex hull of points, counter-clockwise; what stands out by less than `slack` [m] is no corner of it.
fn convex_hull(mut points: Vec<Vec2>, slack: f64) -> Vec<Vec2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    let mut hull: Vec<Vec2> = vec![];
    for side in 0..2 {
        let start = hull.len();
        for p in points.iter().copied() {
            while let [.., a, b] = hull[start..] {
                let along = p - a;
                if along.cross(b - a) < -slack * along.norm() {
                    break;
                }
                hull.pop();
            }
            hull.push(p);
        }
        hull.pop();
        if side == 0 {
            points.reverse();
        }
    }
    hull
}
