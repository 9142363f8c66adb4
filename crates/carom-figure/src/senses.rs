//! Senses, slopes and tilts of the pictures.
//!
//! Pictures count tilt and spin *forward*: positive the way the part tips over the free edge of the first plate. That is clockwise where
//! the first plate descends to the right. Files keep the counter-clockwise sense of the engine.

use crate::text::fixed;
use carom_feeder::{Feeder, Plate, Run};
use carom_motion::planar::Pose;
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
    feeder.start_place().map_or(0.0, |(_, downhill)| slope(Vec2::ZERO, downhill))
}

/// Slope of a plate below the horizontal, from its uphill end to its free edge \[rad\].
///
/// # Example
/// ```
/// use {carom_figure::senses::slope, carom_num::Vec2};
/// assert_eq!(slope(Vec2::new(-2.0, 2.0), Vec2::ZERO).to_degrees(), 45.0);
/// assert_eq!(slope(Vec2::new(2.0, 2.0), Vec2::ZERO).to_degrees(), 45.0, "to either side");
/// ```
pub fn slope(uphill: Vec2, edge: Vec2) -> f64 {
    let along = edge - uphill;
    atan2(-along.y, along.x.abs())
}

/// How a plate slopes, in degrees with so many digits: at its uphill end and at its free edge where it is bent.
pub(crate) fn slopes_text(plate: &Plate, digits: usize) -> String {
    let [begins, ends] = plate.slopes().map(|slope| format!("{}°", fixed(slope.to_degrees(), digits)));
    if plate.form.course.is_empty() { ends } else { format!("{begins} to {ends}") }
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
