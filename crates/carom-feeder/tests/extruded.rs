//! Feeders of the plane, in space.

use carom_feeder::{Feeder, Plate, Start, spatial};

/// The same plates, as wide as needed, for a solid part that starts on its lower face.
pub(crate) fn in_space(feeder: &Feeder, part: spatial::Part) -> spatial::Feeder {
    let plate = |plate: &Plate| spatial::Plate {
        name: plate.name.clone(),
        uphill: plate.uphill,
        edge: plate.edge,
        width: None,
        roll: 0.0,
        cross_section: spatial::CrossSection::Flat,
        edge_radius: plate.form.edge_radius,
        friction: plate.friction,
        restitution: plate.restitution,
        unbounded: plate.unbounded,
    };
    let Start { to_edge, speed, .. } = feeder.start;
    spatial::Feeder {
        gravity: feeder.gravity,
        stop: feeder.stop,
        law: feeder.law,
        part,
        start: spatial::Start { to_edge, aside: 0.0, turn: 0.0, speed, face: 0 },
        plates: feeder.plates.iter().map(plate).collect(),
        walls: vec![],
    }
}
