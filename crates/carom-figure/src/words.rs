//! Senses, slopes and tilts of the pictures. The names of what happens are the feeder's own.
//!
//! Pictures count tilt and spin *forward*: positive the way the part tips over the free edge of the first plate. That is clockwise where
//! the first plate descends to the right. Files keep the counter-clockwise sense of the engine.

use crate::text::significant;
pub use carom_feeder::words::{decided, stage_end};
use carom_feeder::{Feeder, Jam, JamKind, Run, Touch};
use carom_motion::planar::{Pose, trace::PieceEnd};
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
    forward_sense(feeder) * (pose.angle - feeder.start_state().pose.angle) + start_slope(feeder)
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
///
/// # Example
/// ```
/// use {carom_figure::words::slope, carom_num::Vec2};
/// assert_eq!(slope(Vec2::new(-2.0, 2.0), Vec2::ZERO).to_degrees(), 45.0);
/// assert_eq!(slope(Vec2::new(2.0, 2.0), Vec2::ZERO).to_degrees(), 45.0, "to either side");
/// ```
pub fn slope(uphill: Vec2, edge: Vec2) -> f64 {
    let along = edge - uphill;
    atan2(-along.y, along.x.abs())
}

/// The unit normal of a direction that looks up; to the left of a vertical one.
pub(crate) fn upward(along: Vec2) -> Vec2 {
    let left = along.turned_left();
    if left.y < 0.0 { -left } else { left }
}

/// The two ends of an obstacle [m]: uphill and free edge of a plate, from and to of a wall.
pub(crate) fn obstacle_ends(feeder: &Feeder, obstacle: usize) -> Option<(Vec2, Vec2)> {
    let plates = feeder.plates.len();
    match feeder.plates.get(obstacle) {
        Some(plate) => Some((plate.uphill, plate.edge)),
        None => feeder.walls.get(obstacle.checked_sub(plates)?).map(|wall| (wall.from, wall.to)),
    }
}

/// What a failure means, in a few words: between what a part jammed, by how much it missed. Empty for what did not fail.
pub fn because(feeder: &Feeder, run: &Run) -> String {
    match (&run.jam, run.missed_by) {
        (Some(jam), _) => jammed(feeder, jam),
        (_, Some(by)) => {
            format!("it fell past the last plate, {} mm from it at the nearest", significant(1e3 * by, 3))
        }
        (None, None) => feeder.headline(run).because.to_owned(),
    }
}

fn jammed(feeder: &Feeder, jam: &Jam) -> String {
    let on = |touch: &Touch| {
        let (feature, obstacle) = (feeder.feature_name(touch.feature), feeder.obstacle_label(touch.obstacle));
        format!("{feature} on “{obstacle}”")
    };
    let contacts = jam.contacts.iter().map(on).collect::<Vec<_>>();
    let listed = match contacts.as_slice() {
        [] => "its contacts".to_owned(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    };
    match jam.kind {
        JamKind::Wedged => format!("it rests wedged, held by {listed}"),
        JamKind::Unresolved => format!("no impact resolves {listed}"),
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
        PieceEnd::Elsewhere => "the other part",
        PieceEnd::TimeUp => "time is up",
    }
}
