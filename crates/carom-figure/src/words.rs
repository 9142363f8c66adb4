//! The words of the pictures: features, obstacles, verdicts, senses.
//!
//! Pictures count tilt and spin *forward*: positive the way the part tips over the free edge of the first plate. That is clockwise where
//! the first plate descends to the right. Files keep the counter-clockwise sense of the engine.

use carom_feeder::{Feeder, Outcome, Part, PartKind, Run, StageName, Verdict};
use carom_motion::planar::{Feature, Pose, trace::PieceEnd};
use carom_num::{Vec2, elementary::atan2};

/// +1 where the first plate descends to the left, else −1: a counter-clockwise angle or spin times this is counted forward.
pub fn forward_sense(feeder: &Feeder) -> f64 {
    match feeder.plates.first() {
        Some(plate) if plate.edge.x < plate.uphill.x => 1.0,
        _ => -1.0,
    }
}

/// Tilt of the part \[rad\]: the angle by which the face that was down at the start is turned forward from the horizontal.
///
/// A part that lies on a plate that descends by 10° in the first plate's direction is tilted by +10°. `turns` whole turns are kept: the
/// tilt is continuous in the pose's angle.
pub fn tilt(feeder: &Feeder, pose: Pose) -> f64 {
    forward_sense(feeder) * (pose.angle - start_pose(feeder).angle) + start_slope(feeder)
}

/// Tilt within a run: [`tilt`] without the whole turns by which the run's own starting angle may differ.
pub(crate) fn tilt_in(feeder: &Feeder, run: &Run, pose: Pose) -> f64 {
    let full = 2.0 * core::f64::consts::PI;
    let start = run.stages.first().map_or(start_slope(feeder), |s| tilt(feeder, s.start.pose));
    let turns = ((start - start_slope(feeder)) / full).round();
    tilt(feeder, pose) - if turns.is_finite() { turns * full } else { 0.0 }
}

fn start_slope(feeder: &Feeder) -> f64 {
    feeder.plates.first().map_or(0.0, |plate| slope(plate.uphill, plate.edge))
}

/// Slope of a plate below the horizontal, from its uphill end to its free edge \[rad\].
pub fn slope(uphill: Vec2, edge: Vec2) -> f64 {
    let along = edge - uphill;
    atan2(-along.y, along.x.abs())
}

/// The part's pose at the start: flat on the first plate, `start.to_edge` before its free edge, on the side that looks up.
pub fn start_pose(feeder: &Feeder) -> Pose {
    let Some((plate, along)) = feeder.plates.first().and_then(|p| Some((p, (p.edge - p.uphill).unit()?)))
    else {
        return Pose::default();
    };
    let up = upward(along);
    let shape = &feeder.part.body.shape;
    let (height, angle) = if shape.faces() == 0 {
        (shape.radius(), 0.0)
    } else {
        let normal = shape.face_normal(feeder.start.face);
        let (from, _) = shape.face(feeder.start.face);
        (from.dot(normal) + shape.radius(), atan2(-up.y, -up.x) - atan2(normal.y, normal.x))
    };
    // The representative in (−π, π], so that a face that looks down needs no whole turn.
    let angle = atan2(Vec2::at_angle(angle).y, Vec2::at_angle(angle).x);
    Pose { centre: plate.edge - along * feeder.start.to_edge + up * height, angle }
}

/// The unit normal of a direction that looks up; to the left of a vertical one.
pub(crate) fn upward(along: Vec2) -> Vec2 {
    let left = along.turned_left();
    if left.y < 0.0 { -left } else { left }
}

/// The name of an obstacle by its number: plates first, then walls.
pub fn obstacle_name(feeder: &Feeder, obstacle: usize) -> String {
    let plates = feeder.plates.len();
    let name = match feeder.plates.get(obstacle) {
        Some(plate) => Some(&plate.name),
        None => feeder.walls.get(obstacle.wrapping_sub(plates)).map(|wall| &wall.name),
    };
    name.cloned().unwrap_or_else(|| format!("obstacle {obstacle}"))
}

/// The two ends of an obstacle [m]: uphill and free edge of a plate, from and to of a wall.
pub(crate) fn obstacle_ends(feeder: &Feeder, obstacle: usize) -> Option<(Vec2, Vec2)> {
    let plates = feeder.plates.len();
    match feeder.plates.get(obstacle) {
        Some(plate) => Some((plate.uphill, plate.edge)),
        None => feeder.walls.get(obstacle.checked_sub(plates)?).map(|wall| (wall.from, wall.to)),
    }
}

/// A vertex in words: a rod's front and rear end, a box's corners, else its number. Front is ahead at the start.
pub fn vertex_name(feeder: &Feeder, vertex: usize) -> String {
    let part = &feeder.part;
    let Some(place) = part.body.shape.vertices().get(vertex) else { return format!("corner {vertex}") };
    let ahead = ahead_at_start(feeder).is_some_and(|ahead| place.dot(ahead) > 0.0);
    let end = if ahead { "front" } else { "rear" };
    match part.kind {
        PartKind::Rod => format!("{end} end"),
        PartKind::Box => {
            let down = part.body.shape.face_normal(feeder.start.face);
            format!("{end} {} corner", if place.dot(down) > 0.0 { "lower" } else { "upper" })
        }
        PartKind::Polygon => format!("corner {vertex}"),
        PartKind::Disc => "rim".to_owned(),
    }
}

/// The direction of travel at the start, in the body's frame.
fn ahead_at_start(feeder: &Feeder) -> Option<Vec2> {
    let plate = feeder.plates.first()?;
    let along = (plate.edge - plate.uphill).unit()?;
    let turn = Vec2::at_angle(-start_pose(feeder).angle);
    Some(along.rotated(turn.x, turn.y))
}

/// A face in words: a rod's and a box's under side and top as they were at the start, else its number.
pub fn face_name(part: &Part, start_face: usize, face: usize) -> String {
    let faces = part.body.shape.faces();
    if matches!(part.kind, PartKind::Rod | PartKind::Box) && faces > 0 {
        if face == start_face % faces {
            return "first side".to_owned();
        }
        if face == (start_face + faces / 2) % faces {
            return "other side".to_owned();
        }
    }
    format!("face {face}")
}

/// The features that touch, in words.
pub fn feature_name(feeder: &Feeder, feature: Feature) -> String {
    match feature {
        Feature::VertexOnFace { vertex, .. } => vertex_name(feeder, vertex),
        Feature::FaceOnEnd { face, .. } => {
            format!("{} on the edge", face_name(&feeder.part, feeder.start.face, face))
        }
        Feature::VertexOnEnd { vertex, .. } => format!("{} on the edge", vertex_name(feeder, vertex)),
    }
}

/// The features that touch, short enough for a plot's legend.
pub(crate) fn short_name(feeder: &Feeder, feature: Feature) -> String {
    match feature {
        Feature::VertexOnFace { vertex, .. } => {
            let name = vertex_name(feeder, vertex);
            name.trim_end_matches(" end").trim_end_matches(" corner").to_owned()
        }
        Feature::FaceOnEnd { .. } | Feature::VertexOnEnd { .. } => "edge".to_owned(),
    }
}

/// A stage's name in lower case.
pub fn stage_name(name: StageName) -> &'static str {
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

/// An outcome in a few words.
pub fn outcome_name(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Landed => "landed",
        Outcome::Delivered => "delivered",
        Outcome::Stuck => "stuck",
        Outcome::OnEnd => "on end",
        Outcome::Jammed => "jammed",
        Outcome::Missed => "missed",
        Outcome::Escaped => "escaped",
        Outcome::NeverFlat => "never flat",
    }
}

/// A verdict in a word.
pub fn verdict_name(verdict: Verdict) -> String {
    match verdict {
        Verdict::Same => "same side".to_owned(),
        Verdict::Turned => "turned".to_owned(),
        Verdict::Face(face) => format!("face {face}"),
    }
}

/// Why a piece of motion ended, short enough for a mark in a plot.
pub(crate) fn piece_end(end: PieceEnd) -> &'static str {
    match end {
        PieceEnd::Closes { .. } => "touches",
        PieceEnd::ForceZero(_) => "N = 0",
        PieceEnd::SlipZero(_) => "slip stops",
        PieceEnd::StickLimit(_) => "begins to slip",
        PieceEnd::RunsOff(_) => "runs off",
        PieceEnd::PainleveEdge(_) => "Painlevé's edge",
        PieceEnd::Rests => "rests",
        PieceEnd::FliesAway => "flies away",
        PieceEnd::TimeUp => "time is up",
    }
}
