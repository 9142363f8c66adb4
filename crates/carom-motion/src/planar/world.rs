//! One body among fixed obstacles under gravity.

use super::{Body, Obstacle};
use carom_impact::planar::Law;
use carom_num::Vec2;

/// One free body among fixed obstacles under uniform gravity.
#[derive(Clone, Debug, PartialEq)]
pub struct World {
    /// Gravity [m/s²].
    pub gravity: Vec2,
    /// The body.
    pub body: Body,
    /// The obstacles.
    pub obstacles: Vec<Obstacle>,
    /// How restitution is measured.
    pub law: Law,
}

/// The world's own units: nothing is decided by an absolute tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scales {
    /// The body's size [m].
    pub length: f64,
    /// Speed of a fall through the body's size [m/s], or 1 where there is no gravity.
    pub speed: f64,
    /// Length / speed [s].
    pub time: f64,
}

impl World {
    /// The world's own units.
    pub fn scales(&self) -> Scales {
        let length = self.body.shape.size();
        let fall = self.gravity.norm() * length;
        let speed = if fall > 0.0 { fall.sqrt() } else { 1.0 };
        Scales { length, speed, time: length / speed }
    }

    /// Kinetic and potential energy of a state [J].
    pub fn energy(&self, state: &super::State) -> f64 {
        let (v, w) = (state.twist.velocity, state.twist.spin);
        0.5 * self.body.mass * v.dot(v) + 0.5 * self.body.inertia * w * w
            - self.body.mass * self.gravity.dot(state.pose.centre)
    }
}
