//! What a body is between its supports, and how far it is from others.

use super::body::Body;
use super::hull::HullProblem;
use super::pieces::{Outside, outside};
use super::polyhedron::Polyhedron;
use super::state::{Pose, State};
use super::surface::Surface;
use super::world::ObstaclesProblem;
use crate::tolerance::{NAMED_CORNER, ONE_CORNER, ONE_SUPPORT};
use carom_num::Vec3;

/// The form of a body: the convex hull of its supports, or several convex pieces.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Form {
    /// The pieces, each whole.
    pieces: Vec<Surface>,
    /// What of all of them is outside.
    outside: Surface,
    /// Unit vectors from each of the body's supports along its edges.
    spokes: Vec<Vec<Vec3>>,
    /// The corners of the faces of several pieces.
    polygons: Vec<Vec<Vec3>>,
    reach: f64,
}

impl Form {
    /// The hull of a body's supports, or its pieces; of one with round edges all places within the radius of it.
    ///
    /// # Errors
    /// [`ObstaclesProblem`]: supports that have no hull, or are rounded in different ways.
    pub fn of(body: &Body) -> Result<Self, ObstaclesProblem> {
        if let Some(form) = body.form() {
            return Ok(form.clone());
        }
        let radius = body.rounding().ok_or(ObstaclesProblem::Round)?;
        let (points, reach) = (body.supports(), body.reach());
        let one = |outside: Surface, spokes| Self {
            pieces: vec![outside.clone()],
            outside,
            spokes,
            polygons: vec![],
            reach,
        };
        if radius > 0.0 && points.len() <= 2 {
            let surface = Surface::of_round(points, radius);
            let spokes = surface.spokes.clone();
            return Ok(one(surface, spokes));
        }
        let flatness = ONE_SUPPORT * reach;
        let shape = Polyhedron::of_points(points, flatness).map_err(|problems| {
            let first = problems.into_iter().next();
            ObstaclesProblem::Shape(first.unwrap_or(HullProblem::Unclear { flatness }))
        })?;
        let places: Vec<Vec3> = shape.sources().iter().map(|source| points[*source]).collect();
        let surface = Surface { radius, ..Surface::of(&shape, &places) };
        let mut spokes = vec![vec![]; points.len()];
        for (source, own) in shape.sources().iter().zip(&surface.spokes) {
            spokes[*source].clone_from(own);
        }
        Ok(one(surface, spokes))
    }

    /// That of pieces, in the axes of a body from its mass centre. Corners that are near these places come first, in their order.
    pub(super) fn of_pieces(pieces: &[Polyhedron], first: &[Vec3]) -> Self {
        let far = |piece: &Polyhedron| piece.vertices().iter().map(|r| r.norm()).fold(0.0, f64::max);
        let reach = pieces.iter().map(far).fold(0.0, f64::max);
        let Outside { each, mut surface, polygons } = outside(pieces, ONE_CORNER * reach);
        let place = |corner: usize| {
            let near = |r: &Vec3| (*r - surface.corners[corner]).norm() <= NAMED_CORNER * reach;
            first.iter().position(near).unwrap_or(first.len())
        };
        let mut order: Vec<usize> = (0..surface.corners.len()).collect();
        order.sort_by_key(|corner| place(*corner));
        surface.corners = order.iter().map(|corner| surface.corners[*corner]).collect();
        surface.spokes = order.iter().map(|corner| surface.spokes[*corner].clone()).collect();
        Self { pieces: each, spokes: surface.spokes.clone(), outside: surface, polygons, reach }
    }

    /// The corners of its faces that are outside, of a body of several pieces; a piece may hide a share of another one's.
    pub(super) fn polygons(&self) -> &[Vec<Vec3>] {
        &self.polygons
    }

    /// What of it is outside.
    pub(in crate::spatial) fn outside(&self) -> &Surface {
        &self.outside
    }

    /// Unit vectors from one of the body's supports along its edges; none from one that is within a face or inside.
    pub(in crate::spatial) fn spokes(&self, support: usize) -> &[Vec3] {
        &self.spokes[support]
    }

    /// No place of it is farther from the mass centre \[m\].
    pub fn reach(&self) -> f64 {
        self.reach
    }

    /// How far it is from an obstacle, at least; negative where it is in it \[m\].
    pub(super) fn apart(&self, other: &Surface, pose: Pose) -> f64 {
        self.pieces.iter().map(|piece| piece.apart(other, pose)).fold(f64::INFINITY, f64::min)
    }

    /// How far a body of this form in one state is from one in another, at least \[m\]; 0 or negative exactly where they overlap. What they do does not matter, only where they stand.
    ///
    /// # Example
    /// Two cubes of 1 m beside each other, their centres 1.25 m apart.
    /// ```
    /// use carom_motion::spatial::{Form, State, examples};
    /// use carom_num::{Rotation, Vec3};
    /// let cube = Form::of(&examples::block()).unwrap();
    /// let (attitude, still) = (Rotation::NONE, Vec3::ZERO);
    /// let at = |x: f64| State { centre: Vec3::X * x, attitude, velocity: still, spin: still };
    /// assert_eq!(cube.clearance([&at(0.0), &at(1.25)]), 0.25);
    /// ```
    pub fn clearance(&self, [a, b]: [&State; 2]) -> f64 {
        let attitude = b.attitude.inverse().after(a.attitude);
        let centre = b.attitude.undo(a.centre - b.centre);
        let pose = Pose { centre, attitude };
        self.pieces.iter().map(|other| self.apart(other, pose)).fold(f64::INFINITY, f64::min)
    }
}
