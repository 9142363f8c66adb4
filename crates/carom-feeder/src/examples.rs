//! Small feeders that examples share: every number in them is round, so that a result can be checked by hand. g = 10 m/s².

use crate::{Feeder, Part, PartKind, Plate, Start, Stop};
use carom_impact::Law;
use carom_motion::planar::examples::{disc, rod};
use carom_num::Vec2;

/// A rod of 0.1 m that starts from rest 2 m before the edge of a slope of 3 in 4 with this friction. It is held from μ = 3/4 on, and else it is
/// delivered over the edge, the only one that there is.
pub fn rod_on_a_slope(friction: f64) -> Feeder {
    let part = Part { kind: PartKind::Rod, body: rod(0.1, 0.3, 0.000_25) };
    feeder(Stop::Delivered, part, vec![slope(friction)])
}

/// A disc of radius 0.06 m and 1 kg that slides from rest, without friction, 2 m down to the edge of a slope of 3 in 4, at 6 m/s².
pub fn disc_on_a_slope() -> Feeder {
    feeder(Stop::Delivered, part_disc(), vec![slope(0.0)])
}

/// The disc of [`disc_on_a_slope`], which leaves the slope and then falls 1.25 m on a level tray without friction: it strikes
/// with `√(2·6·2 + 2·10·1.25)`, 7 m/s.
pub fn disc_above_a_tray() -> Feeder {
    let tray = plate("tray", Vec2::new(-1.0, -1.262), Vec2::new(9.0, -1.262), 0.0);
    feeder(Stop::Landed, part_disc(), vec![slope(0.0), tray])
}

fn feeder(stop: Stop, part: Part, plates: Vec<Plate>) -> Feeder {
    let start = Start { to_edge: 2.0, speed: 0.0, face: 0 };
    Feeder { gravity: 10.0, stop, law: Law::Poisson, part, start, plates, walls: vec![] }
}

fn part_disc() -> Part {
    Part { kind: PartKind::Disc, body: disc(0.06, 1.0, 0.0018) }
}

fn slope(friction: f64) -> Plate {
    plate("slope", Vec2::new(-4.0, 3.0), Vec2::ZERO, friction)
}

fn plate(name: &str, uphill: Vec2, edge: Vec2, friction: f64) -> Plate {
    Plate {
        name: name.into(),
        uphill,
        edge,
        friction,
        restitution: 0.0,
        unbounded: false,
        form: Default::default(),
    }
}
