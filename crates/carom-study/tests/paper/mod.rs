//! The paper's part on two plates: a rod that turns over on the second one or does not.

#![allow(dead_code, reason = "an example uses a part of it")]

use carom_feeder::{Feeder, Part, Plate, Run, Start, Stop, Verdict};
use carom_impact::Law;
use carom_motion::planar::Options;
use carom_num::Vec2;
use carom_study::{Dropped, Ending};

/// Where the lower plate's line meets the upper one's normal and its axis, friction, the upper slope, and the way to the edge.
pub(crate) fn layout(normal: f64, along: f64, friction: f64, slope: f64, to_edge: f64) -> Option<Feeder> {
    let x = Vec2::at_angle(-slope);
    let (high, low) = (x * along, x.turned_right() * normal);
    let down = (low - high).unit()?;
    let plate = |name: &str, uphill: Vec2, edge: Vec2| Plate {
        name: name.into(),
        uphill,
        edge,
        friction,
        restitution: 0.0,
        unbounded: true,
        form: Default::default(),
    };
    Some(Feeder {
        gravity: 9.81,
        stop: Stop::Landed,
        law: Law::Poisson,
        part: Part::rod(0.1, 0.3, 2.5e-4)?,
        start: Start { to_edge, speed: 0.0, face: 0 },
        plates: vec![
            plate("upper", x * -0.5, Vec2::ZERO),
            plate("lower", high - down * 3.0, low + down * 3.0),
        ],
        walls: vec![],
    })
}

/// Five quantities that vary around a place near the boundary.
pub(crate) fn feeder(point: &[f64]) -> Option<Feeder> {
    let at = |k: usize, low: f64, high: f64| low + point.get(k).copied().unwrap_or(0.5) * (high - low);
    layout(at(0, 0.31, 0.37), at(1, 0.33, 0.37), at(2, 0.145, 0.155), at(3, 0.25, 0.27), at(4, 0.09, 0.11))
}

/// How a drop ends on the lower plate.
pub(crate) fn ending(feeder: Option<&Feeder>) -> Ending {
    Dropped::of(feeder, 1, &Options::default()).ending
}

pub(crate) fn turns(run: &Run) -> bool {
    Ending::of(run, 1) == Ending::Lies(Verdict::Turned)
}
