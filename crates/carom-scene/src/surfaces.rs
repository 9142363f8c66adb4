//! What plates and walls are like to the touch: their own friction and restitution, or those of all.

use crate::drawing::{Drawing, Surface};

/// What is taken for contacts that are known by the names of their materials.
pub(crate) fn contact_notes(drawing: &Drawing) -> Vec<String> {
    let Drawing { contact, channel, groove, plates, zigzag, walls, pins, feed, .. } = drawing;
    let mut found: Vec<String> = contact.named.iter().map(|named| named.told("contact")).collect();
    let mut tell = |path: String, surface: &Surface| {
        found.extend(surface.named.map(|named| named.told(&format!("{path}.contact"))));
    };
    channel.iter().for_each(|channel| tell("channel".into(), &channel.surface));
    groove.iter().for_each(|groove| tell("groove".into(), &groove.surface));
    plates.iter().for_each(|plate| tell(format!("plate.{}", plate.name), &plate.surface));
    zigzag.iter().for_each(|zigzag| tell("zigzag".into(), &zigzag.surface));
    walls.iter().for_each(|wall| tell(format!("wall.{}", wall.name), &wall.surface));
    pins.iter().for_each(|pin| tell(format!("pin.{}", pin.name), &pin.surface));
    feed.iter().for_each(|feed| tell("feed".into(), &feed.surface));
    found
}

/// Friction and restitution of a surface: its own, else the contact's.
pub(crate) fn surface_of(drawing: &Drawing, surface: &Surface) -> (f64, f64) {
    let friction = surface.friction.as_ref().or(drawing.contact.friction.as_ref());
    let restitution = surface.restitution.as_ref().unwrap_or(&drawing.contact.restitution);
    (friction.map_or(0.0, |friction| friction.value), restitution.value)
}
