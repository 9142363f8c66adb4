//! Fixed obstacles: segments with two ends.

use carom_num::Vec2;

/// A fixed straight segment of no thickness, with friction and restitution against the body. Both sides and both ends can be struck.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Obstacle {
    /// One end [m].
    pub from: Vec2,
    /// Other end [m].
    pub to: Vec2,
    /// Coulomb friction coefficient, ≥ 0.
    pub friction: f64,
    /// Coefficient of restitution, in [0, 1].
    pub restitution: f64,
}

impl Obstacle {
    /// Length [m].
    pub fn length(&self) -> f64 {
        (self.to - self.from).norm()
    }

    /// Unit direction from `from` to `to`.
    pub fn direction(&self) -> Vec2 {
        (self.to - self.from) / self.length()
    }
}
