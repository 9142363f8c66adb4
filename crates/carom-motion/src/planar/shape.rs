//! The one shape: the convex hull of k vertices, rounded by a radius.

use crate::tolerance::{COINCIDENT_VERTICES, ROD_SKIN, STRAIGHT_CORNER_SINE};
use carom_num::Vec2;
use std::fmt;

/// The convex hull of k vertices, rounded by a radius ≥ 0, drawn about the mass centre.
///
/// k = 1 with a radius is a disc; k = 2 a rod, whose two opposed faces are 0 (from vertex 0 to vertex 1) and 1; k ≥ 3 a polygon.
/// Vertices run counter-clockwise; face i goes from vertex i to vertex i + 1 and its outward normal is that direction turned right.
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
    radius: f64,
    /// Largest distance of a vertex from the mass centre, without the radius [m].
    reach: f64,
    /// Outward unit normals of the faces.
    normals: Vec<Vec2>,
    /// Lengths of the faces [m].
    lengths: Vec<f64>,
}

/// Why vertices and a radius are not a shape.
///
/// # Example
/// Three corners that run clockwise turn the wrong way at each.
/// ```
/// use carom_motion::planar::{Shape, ShapeProblem};
/// use carom_num::Vec2;
/// let clockwise = [(0.0, 0.0), (0.0, 1.0), (1.0, 0.0)].map(|(x, y)| Vec2::new(x, y)).to_vec();
/// let problems = Shape::new(clockwise, 0.0).unwrap_err();
/// assert_eq!(problems, [1, 2, 0].map(ShapeProblem::NotConvex));
/// assert_eq!(ShapeProblem::Coincide(0, 1).to_string(), "vertices 0 and 1 coincide");
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum ShapeProblem {
    /// No vertex at all.
    Empty,
    /// One vertex needs a radius above zero.
    PointWithoutRadius,
    /// A number that is not finite, or a negative radius.
    NotANumber,
    /// Two neighbouring vertices coincide.
    Coincide(usize, usize),
    /// The corner at this vertex turns clockwise or not at all.
    NotConvex(usize),
    /// Edges cross, although every corner turns counter-clockwise.
    Crosses,
}

impl fmt::Display for ShapeProblem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => write!(f, "no vertices: give at least one"),
            Self::PointWithoutRadius => write!(f, "a single vertex needs a radius above 0"),
            Self::NotANumber => {
                write!(f, "a coordinate or the radius is not a finite number, or the radius is negative")
            }
            Self::Coincide(i, j) => write!(f, "vertices {i} and {j} coincide"),
            Self::NotConvex(i) => write!(
                f,
                "not convex at vertex {i} (vertices must run counter-clockwise, each corner turning left)"
            ),
            Self::Crosses => write!(f, "the outline crosses itself"),
        }
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
    pub(super) fn of_checked(vertices: Vec<Vec2>, radius: f64) -> Self {
        let reach = vertices.iter().map(|v| v.norm()).fold(0.0, f64::max);
        let mut shape = Self { vertices, radius, reach, normals: vec![], lengths: vec![] };
        for face in 0..shape.faces() {
            let (a, b) = shape.face(face);
            let length = (b - a).norm();
            shape.normals.push((b - a).turned_right() / length);
            shape.lengths.push(length);
        }
        shape
    }

    /// The vertices, about the mass centre, in the body's frame [m].
    pub fn vertices(&self) -> &[Vec2] {
        &self.vertices
    }

    /// The radius that rounds the hull [m].
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The radius that counts where two bodies touch [m]: that of the shape, but for a rod without thickness a millionth of its size, so that
    /// the end of one can push the end of another.
    ///
    /// # Example
    /// A rod of 1 m without thickness reaches half a metre from its centre and has a skin of a millionth of
    /// that.
    /// ```
    /// use carom_motion::planar::Shape;
    /// use carom_num::Vec2;
    /// let rod = Shape::new(vec![Vec2::new(-0.5, 0.0), Vec2::new(0.5, 0.0)], 0.0).unwrap();
    /// assert_eq!((rod.radius(), rod.skin()), (0.0, 0.5e-6));
    /// ```
    pub fn skin(&self) -> f64 {
        let thin = self.radius == 0.0 && self.vertices.len() == 2;
        if thin { ROD_SKIN * self.size() } else { self.radius }
    }

    /// Number of flat faces: 0 for a disc, 2 for a rod, else the number of vertices.
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
        self.normals[i % self.normals.len().max(1)]
    }

    /// Length of face `i`, without the radius [m].
    pub(super) fn face_length(&self, i: usize) -> f64 {
        self.lengths[i % self.lengths.len().max(1)]
    }

    /// Largest distance of a vertex from the mass centre [m], the radius not counted.
    pub fn reach(&self) -> f64 {
        self.reach
    }

    /// The part's size [m]: largest distance of a point from the mass centre.
    pub fn size(&self) -> f64 {
        self.reach + self.radius
    }
}

fn problems_of(vertices: &[Vec2], radius: f64) -> Vec<ShapeProblem> {
    if vertices.is_empty() {
        return vec![ShapeProblem::Empty];
    }
    if !radius.is_finite() || radius < 0.0 || vertices.iter().any(|v| !v.is_finite()) {
        return vec![ShapeProblem::NotANumber];
    }
    let k = vertices.len();
    if k == 1 {
        return if radius > 0.0 { vec![] } else { vec![ShapeProblem::PointWithoutRadius] };
    }
    let size = vertices.iter().map(|v| v.norm()).fold(0.0, f64::max);
    let mut found = vec![];
    let pairs = if k == 2 { 1 } else { k };
    for i in 0..pairs {
        let j = (i + 1) % k;
        if (vertices[j] - vertices[i]).norm() <= COINCIDENT_VERTICES * size {
            found.push(ShapeProblem::Coincide(i, j));
        }
    }
    if k == 2 || !found.is_empty() {
        return found;
    }
    let mut turned = 0.0;
    for i in 0..k {
        let (a, b) = (vertices[(i + 1) % k] - vertices[i], vertices[(i + 2) % k] - vertices[(i + 1) % k]);
        if a.cross(b) <= STRAIGHT_CORNER_SINE * a.norm() * b.norm() {
            found.push(ShapeProblem::NotConvex((i + 1) % k));
        }
        turned += carom_num::elementary::atan2(a.cross(b), a.dot(b));
    }
    // A star turns left at every corner too, but more than once round: one turn is 2π.
    if found.is_empty() && turned > 7.0 {
        found.push(ShapeProblem::Crosses);
    }
    found
}
