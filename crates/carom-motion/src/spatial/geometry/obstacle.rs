//! What a body may touch.

use super::plane::Plane;
use super::polyhedron::Polyhedron;
use super::surface::{Edge, Facet, Surface};
use crate::tolerance::FLAT_PLATE;
use carom_num::Vec3;
use thiserror::Error;

/// Something convex that does not move: a plane without ends, a plate, or a solid.
///
/// # Example
/// A plate of 1 m by 2 m, level, a metre up.
/// ```
/// use carom_motion::spatial::Obstacle;
/// use carom_num::Vec3;
/// let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 2.0), (0.0, 2.0)].map(|(x, y)| Vec3::new(x, y, 1.0));
/// assert!(Obstacle::plate(&corners).is_ok());
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Obstacle(pub(in crate::spatial) Surface);

/// Corners that no plate has.
///
/// # Example
/// ```
/// use carom_motion::spatial::{Obstacle, PlateProblem};
/// use carom_num::Vec3;
/// assert_eq!(Obstacle::plate(&[Vec3::X, Vec3::Y]), Err(PlateProblem::TooFew { count: 2 }));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PlateProblem {
    /// Fewer than three.
    #[error("a plate has 3 corners or more, not {count}")]
    TooFew {
        /// How many there are.
        count: usize,
    },
    /// A corner that is not finite.
    #[error("corner {corner} of a plate is not finite")]
    NotFinite {
        /// Its number.
        corner: usize,
    },
    /// Corners on one line, or in one place.
    #[error("the corners of a plate lie on one line")]
    Line,
    /// A corner that is not on the plane of the others.
    #[error("corner {corner} of a plate is {distance} m from the plane of the others")]
    NotFlat {
        /// Its number.
        corner: usize,
        /// How far it is from the plane \[m\].
        distance: f64,
    },
    /// A corner at which the outline turns inwards, or does not turn.
    #[error("a plate turns the same way at all its corners: not at corner {corner}")]
    NotConvex {
        /// Its number.
        corner: usize,
    },
}

impl From<Plane> for Obstacle {
    fn from(plane: Plane) -> Self {
        let face = Facet { plane, limits: vec![] };
        Self(Surface { faces: vec![face], ..Surface::default() })
    }
}

impl Obstacle {
    /// A thin flat plate with these corners, in their order around it \[m\]. It is touched on both sides, along its edges and at its corners.
    ///
    /// # Errors
    /// The first problem.
    ///
    /// # Example
    /// A corner is a millimetre out of the plane.
    /// ```
    /// use carom_motion::spatial::{Obstacle, PlateProblem};
    /// use carom_num::Vec3;
    /// let corners = [Vec3::ZERO, Vec3::X, Vec3::new(1.0, 1.0, 1e-3), Vec3::Y];
    /// assert!(matches!(Obstacle::plate(&corners), Err(PlateProblem::NotFlat { .. })));
    /// ```
    pub fn plate(corners: &[Vec3]) -> Result<Self, PlateProblem> {
        let count = corners.len();
        if count < 3 {
            return Err(PlateProblem::TooFew { count });
        }
        if let Some(corner) = corners.iter().position(|r| !r.is_finite()) {
            return Err(PlateProblem::NotFinite { corner });
        }
        let normal = super::hull::newell(corners).unit().ok_or(PlateProblem::Line)?;
        let size = corners.iter().map(|r| (*r - corners[0]).norm()).fold(0.0, f64::max);
        let around = |k: usize| (corners[k], corners[(k + 1) % count], corners[(k + 2) % count]);
        for (corner, r) in corners.iter().enumerate() {
            let distance = normal.dot(*r - corners[0]).abs();
            if distance > FLAT_PLATE * size {
                return Err(PlateProblem::NotFlat { corner, distance });
            }
        }
        for k in 0..count {
            let (a, b, c) = around(k);
            if normal.dot((b - a).cross(c - b)) <= FLAT_PLATE * size * size {
                return Err(PlateProblem::NotConvex { corner: (k + 1) % count });
            }
        }
        let back: Vec<Vec3> = corners.iter().rev().copied().collect();
        let edge = |k: usize| Edge::of_plate(around(k).0, around(k).1, normal);
        Ok(Self(Surface {
            faces: vec![Facet::of(normal, corners), Facet::of(-normal, &back)],
            edges: (0..count).filter_map(edge).collect(),
            corners: corners.to_vec(),
        }))
    }

    /// A convex solid, which stands where its vertices are \[m\].
    ///
    /// # Example
    /// A cube of 1 m as a block on which other things fall.
    /// ```
    /// use carom_motion::spatial::{Obstacle, Polyhedron, examples};
    /// let block = Polyhedron::of_points(&examples::cube_corners(), 1e-9)?;
    /// assert_ne!(Obstacle::solid(&block), Obstacle::from(carom_motion::spatial::Plane::FLOOR));
    /// # Ok::<(), Vec<carom_motion::spatial::HullProblem>>(())
    /// ```
    pub fn solid(shape: &Polyhedron) -> Self {
        let mut points = vec![Vec3::ZERO; shape.sources().iter().max().map_or(0, |last| last + 1)];
        for (source, vertex) in shape.sources().iter().zip(shape.vertices()) {
            points[*source] = *vertex;
        }
        Self(Surface::of(shape, &points))
    }
}
