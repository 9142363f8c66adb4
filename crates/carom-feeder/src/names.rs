//! What features and faces are called.

use crate::feeder::{Feeder, PartKind};
use carom_motion::planar::Feature;

impl Feeder {
    /// The vertex of a rod that is downhill at the start: its front.
    fn front(&self) -> usize {
        let heading_right = self.plates.first().is_some_and(|p| p.edge.x >= p.uphill.x);
        usize::from(heading_right == (self.start.face == 0))
    }

    /// The name of the body's part of a pair of features: `front`, `rear`, `corner 2`, `face 0`, `rim`.
    pub fn feature_name(&self, feature: Feature) -> String {
        match (self.part.kind, feature) {
            (PartKind::Disc, _) => "rim".to_owned(),
            (PartKind::Rod, Feature::VertexOnFace { vertex, .. } | Feature::VertexOnEnd { vertex, .. }) => {
                (if vertex == self.front() { "front" } else { "rear" }).to_owned()
            }
            (_, Feature::VertexOnFace { vertex, .. } | Feature::VertexOnEnd { vertex, .. }) => {
                format!("corner {vertex}")
            }
            (_, Feature::FaceOnEnd { face, .. }) => format!("face {face}"),
        }
    }
}
