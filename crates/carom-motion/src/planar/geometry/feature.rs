//! Which feature of the body touches which feature of what it meets.

use super::Shape;

/// A pair of features that touch: the body's, and that of an obstacle or of another body.
///
/// Faces and ends are numbered as those of a [`Shape`]; an obstacle is one of two vertices, `from` and `to`:
/// [`Obstacle::FROM`](super::Obstacle::FROM), [`Obstacle::TO`](super::Obstacle::TO), [`Obstacle::LEFT`](super::Obstacle::LEFT) and
/// [`Obstacle::RIGHT`](super::Obstacle::RIGHT) are their numbers.
///
/// # Example
/// A vertex on a face of an obstacle, and the same contact with the roles exchanged.
/// ```
/// use carom_motion::planar::{Feature, Obstacle};
/// let corner_on_plate = Feature::VertexOnFace { vertex: 2, face: Obstacle::LEFT };
/// let plate_end_on_side = Feature::FaceOnEnd { face: 0, end: Obstacle::TO };
/// assert_eq!(plate_end_on_side.from_the_other_side(), Feature::VertexOnFace { vertex: 1, face: 0 });
/// assert!(corner_on_plate < plate_end_on_side);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Feature {
    /// Vertex `vertex` of the body on face `face` of what it meets.
    VertexOnFace {
        /// Vertex of the body.
        vertex: usize,
        /// Face of what it meets.
        face: usize,
    },
    /// Face `face` of the body on a vertex of what it meets.
    FaceOnEnd {
        /// Face of the body.
        face: usize,
        /// Vertex of what it meets.
        end: usize,
    },
    /// Vertex `vertex` of the body on a vertex of what it meets, one of them rounded.
    VertexOnEnd {
        /// Vertex of the body.
        vertex: usize,
        /// Vertex of what it meets.
        end: usize,
    },
}

impl Feature {
    /// The same pair of features as the other side sees it.
    ///
    /// # Example
    /// Seen from the other side twice, a pair is what it was.
    /// ```
    /// use carom_motion::planar::Feature;
    /// let pair = Feature::VertexOnFace { vertex: 3, face: 1 };
    /// assert_eq!(pair.from_the_other_side(), Feature::FaceOnEnd { face: 1, end: 3 });
    /// assert_eq!(pair.from_the_other_side().from_the_other_side(), pair);
    /// ```
    pub fn from_the_other_side(self) -> Self {
        match self {
            Self::VertexOnFace { vertex, face } => Self::FaceOnEnd { face, end: vertex },
            Self::FaceOnEnd { face, end } => Self::VertexOnFace { vertex: end, face },
            Self::VertexOnEnd { vertex, end } => Self::VertexOnEnd { vertex: end, end: vertex },
        }
    }
}

impl Shape {
    /// Every pair of features that this shape and another one can touch with. A sharp vertex does not touch a sharp one, and a hollow is touched
    /// by an arc that is bent more, not by a face. How the two sides count the radius about a vertex is [`Shape::radius_of`] or [`Shape::skin`].
    #[inline]
    pub(in crate::planar) fn each_feature(
        &self,
        met: &Self,
        radius: impl Fn(&Self, usize) -> f64,
        mut offer: impl FnMut(Feature),
    ) {
        for vertex in (0..self.vertices().len()).filter(|v| !self.is_hollow(*v)) {
            for face in (0..met.faces()).rev().filter(|f| met.face_length(*f) > 0.0) {
                offer(Feature::VertexOnFace { vertex, face });
            }
        }
        for end in 0..met.vertices().len() {
            if !met.is_hollow(end) {
                for face in (0..self.faces()).filter(|f| self.face_length(*f) > 0.0) {
                    offer(Feature::FaceOnEnd { face, end });
                }
            }
            for vertex in 0..self.vertices().len() {
                let together = radius(self, vertex) + radius(met, end);
                let touch = match (self.is_hollow(vertex), met.is_hollow(end)) {
                    (false, false) => together > 0.0,
                    (true, true) => false,
                    _ => together < 0.0,
                };
                if touch {
                    offer(Feature::VertexOnEnd { vertex, end });
                }
            }
        }
    }
}
