//! Bounds on the motion of a body over a stretch of time, and what they make of the second rate of a distance.

use carom_num::Vec2;
use carom_num::poly::first_root;

/// How much farther than the first bound a flight is looked at more closely.
const FARTHER: f64 = 3.0;

/// Bounds that hold over a stretch of motion.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::planar) struct Bounds {
    /// How long they hold [s].
    pub(in crate::planar) horizon: f64,
    /// Acceleration of the mass centre [m/s²].
    pub(in crate::planar) acceleration: f64,
    /// Angular acceleration [rad/s²].
    pub(in crate::planar) angular: f64,
    /// Spin [rad/s].
    pub(in crate::planar) spin: f64,
    /// Speed of the mass centre [m/s].
    pub(in crate::planar) speed: f64,
    /// The acceleration itself, where it is constant: in flight.
    pub(in crate::planar) steady: Option<Vec2>,
    /// On which side of the obstacle the body is, where that is known: left of its direction or not.
    pub(in crate::planar) left: Option<bool>,
}

impl Bounds {
    /// Acceleration of the mass centre against a world axis, at most.
    pub(super) fn against(&self, axis: Vec2) -> f64 {
        self.steady.map_or(self.acceleration, |a| -axis.dot(a))
    }

    /// A time before which a point of a body that flies with spin `w` stays apart along an axis, from a time `free` for which that is known:
    /// its gap's second rate is known here, and its third is at most `|w|³ reach`. `along` is how far the point lies from the centre along
    /// the axis, `reach` how far at most.
    pub(super) fn in_flight(
        &self,
        axis: Vec2,
        (along, reach): (f64, f64),
        w: f64,
        (room, rate): (f64, f64),
        free: f64,
    ) -> f64 {
        let ahead = FARTHER * free;
        let bend = self.against(axis) + w * w * (along + w.abs() * reach * ahead / 3.0);
        first_root(room, rate, bend).min(ahead)
    }

    /// By how much less than its size an acceleration that is constant counts along an axis that turns with the body [m/s²].
    pub(super) fn spared_along(&self, axis: Vec2) -> f64 {
        self.steady.map_or(0.0, |a| {
            let turned = (self.spin * self.horizon).min(1.0);
            (self.acceleration * (1.0 - turned) - axis.dot(a)).max(0.0)
        })
    }

    /// Second rate of the distance of a fixed point at `d` from the centre along an axis that turns with the body: the acceleration, the
    /// turning terms, and Coriolis.
    pub(super) fn bend_seen_from_body(&self, d: Vec2) -> f64 {
        let reach = d.norm() + self.speed * self.horizon;
        self.acceleration + (self.angular + self.spin * self.spin) * reach + 2.0 * self.spin * self.speed
    }
}
