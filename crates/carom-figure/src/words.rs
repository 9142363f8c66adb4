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
///
/// # Example
/// On a plate that falls to the right, forward is clockwise.
/// ```
/// # use {carom_feeder::{Feeder, Part, Plate, Start, Stop}, carom_impact::planar::Law, carom_num::Vec2};
/// # let (friction, restitution, unbounded) = (0.5, 0.0, false);
/// # let (uphill, edge) = (Vec2::new(-0.8, 0.6), Vec2::ZERO);
/// # let plates = vec![Plate { name: "upper".to_owned(), uphill, edge, friction, restitution, unbounded }];
/// # let start = Start { to_edge: 0.1, speed: 0.0, face: 0 };
/// # let (part, law, stop) = (Part::rod(0.1, 0.3, 2.5e-4).unwrap(), Law::Poisson, Stop::Landed);
/// # let feeder = Feeder { gravity: 10.0, stop, law, part, start, plates, walls: vec![] };
/// use carom_figure::words::forward_sense;
/// assert_eq!(forward_sense(&feeder), -1.0);
/// let mut left = feeder.clone();
/// left.plates[0].uphill.x = 0.8;
/// assert_eq!(forward_sense(&left), 1.0);
/// ```
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
///
/// # Example
/// On a plate that falls 3 in 4 to the right; turned by a further 0.1 rad clockwise.
/// ```
/// # use {carom_feeder::{Feeder, Part, Plate, Start, Stop}, carom_impact::planar::Law, carom_num::Vec2};
/// # let (friction, restitution, unbounded) = (0.5, 0.0, false);
/// # let (uphill, edge) = (Vec2::new(-0.8, 0.6), Vec2::ZERO);
/// # let plates = vec![Plate { name: "upper".to_owned(), uphill, edge, friction, restitution, unbounded }];
/// # let start = Start { to_edge: 0.1, speed: 0.0, face: 0 };
/// # let (part, law, stop) = (Part::rod(0.1, 0.3, 2.5e-4).unwrap(), Law::Poisson, Stop::Landed);
/// # let feeder = Feeder { gravity: 10.0, stop, law, part, start, plates, walls: vec![] };
/// use carom_figure::words::tilt;
/// let flat = feeder.start_state().pose;
/// let turned = carom_motion::planar::Pose { angle: flat.angle - 0.1, ..flat };
/// assert!((tilt(&feeder, flat) - 0.75_f64.atan()).abs() < 1e-15);
/// assert!((tilt(&feeder, turned) - (0.75_f64.atan() + 0.1)).abs() < 1e-15);
/// ```
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
///
/// # Example
/// A part that friction holds where it starts.
/// ```
/// # use {carom_feeder::{Feeder, Part, Plate, Start, Stop}, carom_impact::planar::Law, carom_num::Vec2};
/// # let (friction, restitution, unbounded) = (0.9, 0.0, false);
/// # let (uphill, edge) = (Vec2::new(-0.8, 0.6), Vec2::ZERO);
/// # let plates = vec![Plate { name: "upper".to_owned(), uphill, edge, friction, restitution, unbounded }];
/// # let start = Start { to_edge: 0.1, speed: 0.0, face: 0 };
/// # let (part, law, stop) = (Part::rod(0.1, 0.3, 2.5e-4).unwrap(), Law::Poisson, Stop::Landed);
/// # let feeder = Feeder { gravity: 10.0, stop, law, part, start, plates, walls: vec![] };
/// use carom_figure::words::because;
/// assert_eq!(because(&feeder, &feeder.run().unwrap()), "friction holds it");
/// ```
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
