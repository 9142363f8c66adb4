//! The words of results: plates, features, outcomes, stages.

use crate::start::start_pose;
use carom_feeder::{Feeder, Outcome, PartKind, StageName};
use carom_motion::planar::Feature;
use carom_num::Vec2;

/// Name of an obstacle: plates first, then walls.
pub fn obstacle_name(feeder: &Feeder, obstacle: usize) -> &str {
    let plates = feeder.plates.len();
    let plate = feeder.plates.get(obstacle).map(|plate| plate.name.as_str());
    let wall = || obstacle.checked_sub(plates).and_then(|wall| feeder.walls.get(wall));
    plate.or_else(|| wall().map(|wall| wall.name.as_str())).unwrap_or("?")
}

/// Name of the part's feature that touches, as it lay at the start.
///
/// A rod has a `front` (the downhill end at the start) and a `rear`; a box has two corners at each, `front` and `rear` on the face that
/// was down and `front top` and `rear top` on the other. A polygon's corners and faces go by number; a disc has its `rim`.
pub fn feature_name(feeder: &Feeder, feature: Feature) -> String {
    match feature {
        Feature::VertexOnFace { vertex, .. } => vertex_name(feeder, vertex),
        Feature::VertexOnEnd { vertex, .. } => format!("{} on an edge", vertex_name(feeder, vertex)),
        Feature::FaceOnEnd { face, .. } => format!("face {face} on an edge"),
    }
}

fn vertex_name(feeder: &Feeder, vertex: usize) -> String {
    let shape = &feeder.part.body.shape;
    let number = || format!("corner {vertex}");
    if feeder.part.kind == PartKind::Disc {
        return "rim".to_owned();
    }
    let (Some(pose), Some(plate), Some(corner)) =
        (start_pose(feeder), feeder.plates.first(), shape.vertices().get(vertex))
    else {
        return number();
    };
    let Some(downhill) = (plate.edge - plate.uphill).unit() else { return number() };
    let direction = Vec2::at_angle(pose.angle);
    let place = corner.rotated(direction.x, direction.y);
    let end = if place.dot(downhill) > 0.0 { "front" } else { "rear" };
    match feeder.part.kind {
        PartKind::Rod => end.to_owned(),
        PartKind::Box => {
            let up = if downhill.x < 0.0 { downhill.turned_right() } else { downhill.turned_left() };
            if place.dot(up) > 0.0 { format!("{end} top") } else { end.to_owned() }
        }
        PartKind::Polygon | PartKind::Disc => number(),
    }
}

/// The word of an outcome, as JSON has it.
pub fn outcome_word(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Landed => "landed",
        Outcome::Delivered => "delivered",
        Outcome::Stuck => "stuck",
        Outcome::OnEnd => "on_end",
        Outcome::Jammed => "jammed",
        Outcome::Missed => "missed",
        Outcome::Escaped => "escaped",
        Outcome::NeverFlat => "never_flat",
    }
}

/// The word of a stage, as JSON has it.
pub fn stage_word(name: StageName) -> &'static str {
    match name {
        StageName::Slide => "slide",
        StageName::Tip => "tip",
        StageName::Flight => "flight",
        StageName::Swing => "swing",
        StageName::Stick => "stick",
        StageName::Roll => "roll",
        StageName::Wedge => "wedge",
        StageName::Rest => "rest",
        StageName::Clatter => "clatter",
    }
}
