//! Which feature of the body touches which feature of an obstacle.

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
