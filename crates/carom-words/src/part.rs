//! Names of plates and walls, and of the features of a part.

use carom_feeder::{Feeder, PartKind};
use carom_motion::planar::Feature;
use carom_num::Vec2;

/// The name of an obstacle for a person: `plate 1`, `wall 2`, counted from 1, where it has no name of its own but its number.
pub fn obstacle(feeder: &Feeder, obstacle: usize) -> String {
    let name = feeder.obstacle_name(obstacle);
    let (kind, number) = match obstacle.checked_sub(feeder.plates.len()) {
        None => ("plate", obstacle),
        Some(wall) => ("wall", wall),
    };
    if name == number.to_string() { format!("{kind} {}", number + 1) } else { name.to_owned() }
}

/// The name of the body's part of a pair of features, as it lay at the start: `front`, `rear`, `front top`, `corner 2`, `face 0`, `rim`.
///
/// A rod has a front, its downhill end, and a rear; a box has two corners at each, those of the face that was down and `top` ones. A
/// polygon's corners and every part's faces go by number.
pub fn feature(feeder: &Feeder, feature: Feature) -> String {
    match (feeder.part.kind, feature) {
        (PartKind::Disc, _) => "rim".to_owned(),
        (_, Feature::FaceOnEnd { face, .. }) => format!("face {face}"),
        (_, Feature::VertexOnFace { vertex, .. } | Feature::VertexOnEnd { vertex, .. }) => {
            corner(feeder, vertex)
        }
    }
}

fn corner(feeder: &Feeder, vertex: usize) -> String {
    let shape = &feeder.part.body.shape;
    let number = || format!("corner {vertex}");
    let named = matches!(feeder.part.kind, PartKind::Rod | PartKind::Box);
    let (Some((_, downhill)), Some(corner)) = (feeder.start_place(), shape.vertices().get(vertex)) else {
        return number();
    };
    if !named || feeder.start.face >= shape.faces() {
        return number();
    }
    let turn = Vec2::at_angle(feeder.start_state().pose.angle);
    let ahead = corner.rotated(turn.x, turn.y).dot(downhill) > 0.0;
    let end = if ahead { "front" } else { "rear" };
    let down = shape.face_normal(feeder.start.face);
    let top = feeder.part.kind == PartKind::Box && corner.dot(down) < 0.0;
    if top { format!("{end} top") } else { end.to_owned() }
}
