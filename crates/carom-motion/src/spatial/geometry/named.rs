//! What the supports of a body are called: what touches what.

use super::crossing::Crossing;
use super::nearest::Nearest;
use super::pair::Pair;
use super::world::World;
use carom_num::Vec3;

/// What of a body may touch what of an obstacle.
///
/// # Example
/// A cube of eight corners, twelve edges and six faces above a plate: its corners may touch either side of the plate, its faces the plate's four corners, its edges the four edges.
/// ```
/// use carom_motion::spatial::{Friction, Obstacle, Touch, World, examples};
/// use carom_num::Vec3;
/// let outline = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Vec3::new(x, y, -2.0));
/// let world = World::new(examples::block(), Vec3::Z * -10.0).unwrap().with_friction(Friction::new(0.1)).unwrap();
/// let world = world.among(vec![Obstacle::plate(&outline).unwrap()]).unwrap();
/// assert_eq!(world.touch(9), Some(Touch::Point { point: 1, face: 1 }));
/// assert_eq!(world.touch(16), Some(Touch::Face { face: 0, corner: 0 }));
/// assert!(matches!(world.touch(40), Some(Touch::Edge { other: 0, .. })));
/// assert_eq!(world.touch(16 + 24 + 48), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Touch {
    /// A point of the body, a ball or a circle of it, on a face of the obstacle.
    Point {
        /// Its number among [`super::body::Body::supports`].
        point: usize,
        /// The obstacle's face. Of a plate 0 is the side on which its corners turn counter-clockwise.
        face: usize,
    },
    /// A face of the body on a corner of the obstacle.
    Face {
        /// Its number among the faces of the hull of the body's points ([`super::polyhedron::Polyhedron::of_points`]); of a body of several pieces among those faces of all of them that are not hidden.
        face: usize,
        /// The obstacle's corner.
        corner: usize,
    },
    /// An edge of the body across an edge of the obstacle.
    Edge {
        /// The points of the body at its ends.
        ends: [usize; 2],
        /// The obstacle's edge.
        other: usize,
    },
    /// A ball at a point of the body on an edge of the obstacle.
    PointOnEdge {
        /// Its number among [`super::body::Body::supports`].
        point: usize,
        /// The obstacle's edge.
        other: usize,
    },
    /// A rounded edge of the body on a corner of the obstacle.
    EdgeOnCorner {
        /// The points of the body at its ends.
        ends: [usize; 2],
        /// The obstacle's corner.
        corner: usize,
    },
    /// A ball at a point of the body on a corner of the obstacle.
    PointOnCorner {
        /// Its number among [`super::body::Body::supports`].
        point: usize,
        /// The obstacle's corner.
        corner: usize,
    },
}

impl World {
    /// What a support is, by its number; of which obstacle says [`World::obstacle_of`]. `None` where there is no such support.
    pub fn touch(&self, support: usize) -> Option<Touch> {
        let points = self.body().supports().len();
        let share = (support < self.count()).then(|| &self.shares[self.obstacle_of(support)])?;
        let Some(pair) = support.checked_sub(self.of_faces()) else {
            let face = support / points - share.planes.start;
            return Some(Touch::Point { point: support % points, face });
        };
        let obstacle = &self.obstacles[self.obstacle_of(support)];
        let place = pair - share.pairs.start;
        let ends = |edge: [Vec3; 2]| edge.map(|end| self.point_at(end));
        let edge = |from: Vec3| obstacle.edges.iter().position(|edge| edge.from == from).unwrap_or_default();
        let corner = |r: Vec3| obstacle.corners.iter().position(|own| *own == r).unwrap_or_default();
        Some(match &self.pairs[pair] {
            Pair::Corner { .. } => {
                let corners = obstacle.corners.len();
                Touch::Face { face: place / corners, corner: place % corners }
            }
            Pair::Cross(Crossing { own, other, .. }) => {
                Touch::Edge { ends: ends(own.ends()), other: edge(other.from) }
            }
            Pair::Round(Nearest { own, other, .. }) => match (own.is_edge(), other.is_edge()) {
                (true, _) => Touch::EdgeOnCorner { ends: ends(own.ends()), corner: corner(other.from) },
                (_, true) => Touch::PointOnEdge { point: self.point_at(own.from), other: edge(other.from) },
                _ => Touch::PointOnCorner { point: self.point_at(own.from), corner: corner(other.from) },
            },
        })
    }

    /// The unit normal of a face of the body, outwards, body axes; `None` where there is no such face, or no obstacle that faces could touch.
    pub fn face_normal(&self, face: usize) -> Option<Vec3> {
        self.form.outside().faces.get(face).map(|face| face.plane.normal())
    }

    /// The point of the body that is nearest to a place, body axes.
    fn point_at(&self, place: Vec3) -> usize {
        let distance = |r: &Vec3| (*r - place).norm();
        let points = self.body().supports().iter().enumerate();
        points.min_by(|(_, a), (_, b)| distance(a).total_cmp(&distance(b))).map_or(0, |(i, _)| i)
    }
}
