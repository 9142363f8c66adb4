//! Fixed obstacles: segments with two ends.

use carom_num::Vec2;

/// A fixed straight segment of no thickness, with friction and restitution against the body. Both sides and both ends can be struck.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Obstacle {
    from: Vec2,
    to: Vec2,
    /// Coulomb friction coefficient, ≥ 0.
    pub friction: f64,
    /// Coefficient of restitution, in [0, 1].
    pub restitution: f64,
    // Asked for in every state of every motion.
    length: f64,
    direction: Vec2,
}

impl Obstacle {
    /// The end `from`, by its number among the ends.
    pub const FROM: usize = 0;
    /// The end `to`, by its number among the ends.
    pub const TO: usize = 1;
    /// The face on the right of the direction from → to, by its number.
    pub const RIGHT: usize = 0;
    /// The face on the left of the direction from → to, by its number.
    pub const LEFT: usize = 1;

    /// A segment between two different points [m, world frame].
    pub fn new(from: Vec2, to: Vec2, friction: f64, restitution: f64) -> Self {
        let length = (to - from).norm();
        Self { from, to, friction, restitution, length, direction: (to - from) / length }
    }

    /// One end [m].
    pub fn from(&self) -> Vec2 {
        self.from
    }

    /// Other end [m].
    pub fn to(&self) -> Vec2 {
        self.to
    }

    /// One of the two ends, by its number [m].
    pub fn end(&self, end: usize) -> Vec2 {
        if end == Self::TO { self.to } else { self.from }
    }

    /// Unit normal out of one of the two faces, by its number.
    pub fn normal(&self, face: usize) -> Vec2 {
        if face == Self::LEFT { self.direction.turned_left() } else { self.direction.turned_right() }
    }

    /// Length [m].
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Unit direction from one end to the other.
    pub fn direction(&self) -> Vec2 {
        self.direction
    }
}

/// How two bodies that touch each other rub and rebound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// Coulomb friction coefficient, ≥ 0.
    pub friction: f64,
    /// Coefficient of restitution, in [0, 1].
    pub restitution: f64,
}
