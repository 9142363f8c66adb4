//! Contacts of a body anywhere, with obstacles that may move against each other.

use carom_impact::planar::{ContactSet6, Touch};
use carom_num::Vec2;
use rand::RngExt;
use rand_pcg::Pcg64;

/// Two to four contacts at any place, in any direction.
pub(crate) fn touches(rng: &mut Pcg64) -> Vec<Touch> {
    (0..rng.random_range(2..5))
        .map(|_| Touch {
            arm: Vec2::new(rng.random_range(-1.0..1.0), rng.random_range(-1.0..1.0)),
            normal: Vec2::at_angle(rng.random_range(-3.2..3.2)),
            friction: rng.random_range(0.0..2.0),
            restitution: rng.random_range(0.0..1.0),
        })
        .collect()
}

/// Gives every obstacle a velocity of its own; one of four moves with the body's point, and only touches it.
pub(crate) fn let_move(rng: &mut Pcg64, set: &mut ContactSet6) {
    for i in 0..set.count {
        set.normal[i] = if rng.random_bool(0.25) { 0.0 } else { set.normal[i] + rng.random_range(-0.5..0.5) };
        set.slip[i] += rng.random_range(-0.5..0.5);
    }
}
