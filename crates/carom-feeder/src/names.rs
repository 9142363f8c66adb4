//! What features and faces are called.

use crate::feeder::{Feeder, PartKind};
use carom_motion::planar::Feature;
use carom_num::Vec2;

impl Feeder {
    /// The name of the body's part of a pair of features, as it lay at the start: `front`, `rear`, `front top`, `corner 2`, `face 0`, `rim`.
    ///
    /// A rod has a front, its downhill end, and a rear; a box has two corners at each, those of the face that was down and `top` ones. A
    /// polygon's corners and every part's faces go by number.
    pub fn feature_name(&self, feature: Feature) -> String {
        match (self.part.kind, feature) {
            (PartKind::Disc, _) => "rim".to_owned(),
            (_, Feature::FaceOnEnd { face, .. }) => format!("face {face}"),
            (_, Feature::VertexOnFace { vertex, .. } | Feature::VertexOnEnd { vertex, .. }) => {
                self.vertex_name(vertex)
            }
        }
    }

    fn vertex_name(&self, vertex: usize) -> String {
        let shape = &self.part.body.shape;
        let number = || format!("corner {vertex}");
        let named = matches!(self.part.kind, PartKind::Rod | PartKind::Box);
        let (Some(plate), Some(corner)) = (self.plates.first(), shape.vertices().get(vertex)) else {
            return number();
        };
        if !named || self.start.face >= shape.faces() {
            return number();
        }
        let turn = Vec2::at_angle(self.start_state().pose.angle);
        let end = if corner.rotated(turn.x, turn.y).dot(plate.edge - plate.uphill) > 0.0 {
            "front"
        } else {
            "rear"
        };
        let down = shape.face_normal(self.start.face);
        let top = self.part.kind == PartKind::Box && corner.dot(down) < 0.0;
        if top { format!("{end} top") } else { end.to_owned() }
    }
}
