//! The two angles at which a corner strikes a plate, in the words of the gravity-impact feeder.

use carom_feeder::{Feeder, PartKind};
use carom_motion::planar::{Feature, trace::Impact};
use carom_num::{Vec2, elementary::atan2};

/// Unit direction down the plate that an impact's striking contact is on; `None` for a wall.
fn downhill(feeder: &Feeder, impact: &Impact) -> Option<Vec2> {
    let contact = impact.contacts.first()?;
    let plate = feeder.plates.get(contact.obstacle)?;
    let along = (plate.edge - plate.uphill).unit()?;
    // A bent plate slopes as it does where it is struck.
    let tangent = contact.normal.turned_right();
    Some(if tangent.dot(along) < 0.0 { -tangent } else { tangent })
}

/// From the struck plate's normal to the part's axis [rad]: the paper's φ_K. It is positive where the mass centre is uphill of the
/// striking corner.
///
/// The axis of a rod or box is its length, of another part the line from the striking corner to the mass centre. `None` where a wall or
/// a plate's edge is struck.
pub fn angle_to_normal(feeder: &Feeder, impact: &Impact) -> Option<f64> {
    let (along, contact) = (downhill(feeder, impact)?, impact.contacts.first()?);
    let Feature::VertexOnFace { vertex, .. } = contact.feature else { return None };
    let corner = *feeder.part.body.shape.vertices().get(vertex)?;
    let axis = match feeder.part.kind {
        PartKind::Rod | PartKind::Box => Vec2::at_angle(impact.pose.angle) * -corner.x.signum(),
        PartKind::Polygon | PartKind::Disc => impact.pose.centre - contact.point,
    };
    Some(atan2(-axis.dot(along), axis.dot(contact.normal)))
}

/// From the struck plate's inward normal to the striking corner's velocity [rad], positive where it moves downhill; `None` where a wall
/// is struck.
pub fn incidence(feeder: &Feeder, impact: &Impact) -> Option<f64> {
    let (along, contact) = (downhill(feeder, impact)?, impact.contacts.first()?);
    let slip_downhill = contact.before.slip * contact.normal.turned_right().dot(along);
    Some(atan2(slip_downhill, -contact.before.normal))
}
