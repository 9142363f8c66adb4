//! Why vertices, or a chain, are not a shape.

use crate::tolerance::{COINCIDENT_VERTICES, STRAIGHT_CORNER_SINE};
use carom_num::Vec2;
use std::fmt;

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
    /// The outline runs clockwise.
    Clockwise,
}

impl ShapeProblem {
    /// The same problem, its vertices numbered otherwise.
    ///
    /// # Example
    /// ```
    /// use carom_motion::planar::ShapeProblem;
    /// assert_eq!(ShapeProblem::NotConvex(4).renumbered(|i| i / 2), ShapeProblem::NotConvex(2));
    /// ```
    #[must_use]
    pub fn renumbered(self, number: impl Fn(usize) -> usize) -> Self {
        match self {
            Self::Coincide(i, j) => Self::Coincide(number(i), number(j)),
            Self::NotConvex(i) => Self::NotConvex(number(i)),
            other => other,
        }
    }
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
            Self::Clockwise => write!(f, "the outline runs clockwise: give its points counter-clockwise"),
        }
    }
}

/// What is wrong with the hull of vertices and its radius.
pub(super) fn problems_of(vertices: &[Vec2], radius: f64) -> Vec<ShapeProblem> {
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
