//! The paper's feeder: a rod or box of 0.1 m, and a second plate placed by its line in the axes of the first.

use carom_feeder::{Feeder, Part, Plate, Start, Stop, Verdict};
use carom_impact::Law;
use carom_motion::planar::Options;
use carom_num::Vec2;

/// A design: the upper plate's slope [deg]; the line x/along + y/normal = 1 [m] of the lower plate.
#[derive(Clone, Copy)]
pub struct Design {
    pub slope_deg: f64,
    pub along: f64,
    pub normal: f64,
}

/// Thickness [m] of the box that stands for the rod in engines that need volume.
pub const THICKNESS: f64 = 0.001;

/// The feeder of a design; a thickness of 0 makes a rod. `None` where the numbers are no part.
pub fn feeder(design: Design, thickness: f64) -> Option<Feeder> {
    let x = Vec2::at_angle(-design.slope_deg.to_radians());
    let y = x.turned_right();
    let plate = |name: &str, uphill: Vec2, edge: Vec2| Plate {
        name: name.into(),
        uphill,
        edge,
        friction: 0.15,
        restitution: 0.0,
        unbounded: true,
        form: Default::default(),
    };
    let (high, low) = (x * design.along, y * design.normal);
    let down = (low - high).unit()?;
    let part = if thickness > 0.0 {
        Part::rectangle(0.1, thickness, 0.3, 2.5e-4)
    } else {
        Part::rod(0.1, 0.3, 2.5e-4)
    };
    Some(Feeder {
        gravity: 9.81,
        stop: Stop::Landed,
        law: Law::Poisson,
        part: part?,
        start: Start { to_edge: 0.1, speed: 0.0, face: 0 },
        plates: vec![
            plate("upper", x * -0.5, Vec2::ZERO),
            plate("lower", high - down * 3.0, low + down * 3.0),
        ],
        walls: vec![],
    })
}

/// The verdict's word; "none" where the part does not come to lie on the lower plate.
pub fn verdict(feeder: &Feeder, options: Options) -> &'static str {
    let run = feeder.prepare(options).and_then(|prepared| prepared.run_untraced());
    let landing = run.as_ref().ok().and_then(|run| run.landings.last());
    match landing.filter(|landing| landing.plate == 1).and_then(|landing| landing.verdict) {
        Some(Verdict::Same) => "same",
        Some(Verdict::Turned) => "turned",
        _ => "none",
    }
}
