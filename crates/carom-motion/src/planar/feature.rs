//! Which feature of the body touches which feature of an obstacle.

use super::Shape;

/// A pair of features that touch: the body's and the obstacle's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Feature {
    /// Vertex `vertex` of the body on the face of the obstacle. `left` is true on the side to the left of the direction from → to.
    VertexOnFace {
        /// Vertex of the body.
        vertex: usize,
        /// Side of the obstacle.
        left: bool,
    },
    /// Face `face` of the body on an end of the obstacle.
    FaceOnEnd {
        /// Face of the body.
        face: usize,
        /// True: the obstacle's end `to`; false: `from`.
        at_to: bool,
    },
    /// Rounded vertex `vertex` of the body on an end of the obstacle.
    VertexOnEnd {
        /// Vertex of the body.
        vertex: usize,
        /// True: the obstacle's end `to`; false: `from`.
        at_to: bool,
    },
}

impl Shape {
    /// Every pair of features that this shape and an obstacle can touch with; a sharp vertex does not touch a sharp end.
    pub(super) fn each_feature(&self, mut offer: impl FnMut(Feature)) {
        for vertex in 0..self.vertices().len() {
            offer(Feature::VertexOnFace { vertex, left: true });
            offer(Feature::VertexOnFace { vertex, left: false });
        }
        for at_to in [false, true] {
            for face in 0..self.faces() {
                offer(Feature::FaceOnEnd { face, at_to });
            }
            if self.radius() > 0.0 {
                for vertex in 0..self.vertices().len() {
                    offer(Feature::VertexOnEnd { vertex, at_to });
                }
            }
        }
    }
}
