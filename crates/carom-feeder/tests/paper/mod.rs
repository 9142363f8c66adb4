//! The paper's feeder: two plates, the second placed by its line in the axes of the first.

use carom_feeder::{Feeder, Part, Plate, Start, Stop};
use carom_impact::Law;
use carom_num::Vec2;

/// The axes of a plate of this slope that descends to the right: x along it, y down through it.
pub(crate) fn axes(slope_deg: f64) -> (Vec2, Vec2) {
    let slope = slope_deg.to_radians();
    let x = Vec2::at_angle(-slope);
    (x, x.turned_right())
}

/// The paper's feeder; `line` is (along, normal) of x/d + y/b = 1 in the upper plate's axes; a thickness of 0 makes a rod.
pub(crate) fn feeder(slope_deg: f64, line: (f64, f64), thickness: f64) -> Feeder {
    let (x, y) = axes(slope_deg);
    let plate = |name: &str, uphill: Vec2, edge: Vec2| Plate {
        name: name.into(),
        uphill,
        edge,
        friction: 0.15,
        restitution: 0.0,
        unbounded: true,
        form: Default::default(),
    };
    let (high, low) = (x * line.0, y * line.1);
    let down = (low - high).unit().unwrap();
    let part = if thickness > 0.0 {
        Part::rectangle(0.1, thickness, 0.3, 2.5e-4)
    } else {
        Part::rod(0.1, 0.3, 2.5e-4)
    };
    Feeder {
        gravity: 9.81,
        stop: Stop::Landed,
        law: Law::Poisson,
        part: part.unwrap(),
        start: Start { to_edge: 0.1, speed: 0.0, face: 0 },
        plates: vec![
            plate("upper", x * -0.5, Vec2::ZERO),
            plate("lower", high - down * 3.0, low + down * 3.0),
        ],
        walls: vec![],
    }
}
