//! Fixed obstacles: segments with two ends.

use carom_num::Vec2;

/// A fixed straight segment of no thickness, with friction and restitution against the body. Both sides and both ends can be struck.
///
/// # Example
/// A plate of 5 m that rises by 4 m over 3 m: its upper side is on the left of the direction upwards.
/// ```
/// use carom_motion::planar::Obstacle;
/// use carom_num::Vec2;
/// let plate = Obstacle::new(Vec2::ZERO, Vec2::new(3.0, 4.0), 0.3, 0.5);
/// assert_eq!((plate.length(), plate.direction()), (5.0, Vec2::new(0.6, 0.8)));
/// assert_eq!(plate.normal(Obstacle::LEFT), Vec2::new(-0.8, 0.6));
/// ```
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
    ///
    /// # Example
    /// ```
    /// use carom_motion::planar::Obstacle;
    /// use carom_num::Vec2;
    /// let plate = Obstacle::new(Vec2::ZERO, Vec2::new(3.0, 4.0), 0.3, 0.5);
    /// assert_eq!(plate.end(Obstacle::FROM), Vec2::ZERO);
    /// ```
    pub const FROM: usize = 0;
    /// The end `to`, by its number among the ends.
    ///
    /// # Example
    /// ```
    /// use carom_motion::planar::Obstacle;
    /// use carom_num::Vec2;
    /// let plate = Obstacle::new(Vec2::ZERO, Vec2::new(3.0, 4.0), 0.3, 0.5);
    /// assert_eq!(plate.end(Obstacle::TO), Vec2::new(3.0, 4.0));
    /// ```
    pub const TO: usize = 1;
    /// The face on the right of the direction from → to, by its number.
    ///
    /// # Example
    /// ```
    /// use carom_motion::planar::Obstacle;
    /// use carom_num::Vec2;
    /// let floor = Obstacle::new(Vec2::ZERO, Vec2::new(2.0, 0.0), 0.3, 0.5);
    /// assert_eq!(floor.normal(Obstacle::RIGHT), Vec2::new(0.0, -1.0));
    /// ```
    pub const RIGHT: usize = 0;
    /// The face on the left of the direction from → to, by its number.
    ///
    /// # Example
    /// ```
    /// use carom_motion::planar::Obstacle;
    /// use carom_num::Vec2;
    /// let floor = Obstacle::new(Vec2::ZERO, Vec2::new(2.0, 0.0), 0.3, 0.5);
    /// assert_eq!(floor.normal(Obstacle::LEFT), Vec2::new(0.0, 1.0));
    /// ```
    pub const LEFT: usize = 1;

    /// A segment between two different points [m, world frame].
    ///
    /// # Example
    /// ```
    /// use carom_motion::planar::Obstacle;
    /// use carom_num::Vec2;
    /// let plate = Obstacle::new(Vec2::ZERO, Vec2::new(3.0, 4.0), 0.3, 0.5);
    /// assert_eq!((plate.friction, plate.restitution, plate.length()), (0.3, 0.5, 5.0));
    /// ```
    pub fn new(from: Vec2, to: Vec2, friction: f64, restitution: f64) -> Self {
        let length = (to - from).norm();
        Self { from, to, friction, restitution, length, direction: (to - from) / length }
    }

    /// One end [m].
    ///
    /// # Example
    /// ```
    /// use carom_motion::planar::Obstacle;
    /// use carom_num::Vec2;
    /// let plate = Obstacle::new(Vec2::new(1.0, 2.0), Vec2::new(4.0, 6.0), 0.3, 0.5);
    /// assert_eq!(plate.from(), Vec2::new(1.0, 2.0));
    /// ```
    pub fn from(&self) -> Vec2 {
        self.from
    }

    /// Other end [m].
    ///
    /// # Example
    /// The other end is the first one and the length along the direction.
    /// ```
    /// use carom_motion::planar::Obstacle;
    /// use carom_num::Vec2;
    /// let plate = Obstacle::new(Vec2::new(1.0, 2.0), Vec2::new(4.0, 6.0), 0.3, 0.5);
    /// assert_eq!(plate.to(), plate.from() + plate.direction() * plate.length());
    /// ```
    pub fn to(&self) -> Vec2 {
        self.to
    }

    /// One of the two ends, by its number [m].
    ///
    /// # Example
    /// ```
    /// use carom_motion::planar::Obstacle;
    /// use carom_num::Vec2;
    /// let plate = Obstacle::new(Vec2::new(1.0, 2.0), Vec2::new(4.0, 6.0), 0.3, 0.5);
    /// assert_eq!((plate.end(0), plate.end(1)), (plate.from(), plate.to()));
    /// ```
    pub fn end(&self, end: usize) -> Vec2 {
        if end == Self::TO { self.to } else { self.from }
    }

    /// Unit normal out of one of the two faces, by its number.
    ///
    /// # Example
    /// The two normals are opposed, and at right angles to the segment.
    /// ```
    /// use carom_motion::planar::Obstacle;
    /// use carom_num::Vec2;
    /// let plate = Obstacle::new(Vec2::ZERO, Vec2::new(3.0, 4.0), 0.3, 0.5);
    /// assert_eq!(plate.normal(Obstacle::RIGHT), Vec2::new(0.8, -0.6));
    /// assert_eq!(plate.normal(Obstacle::LEFT), -plate.normal(Obstacle::RIGHT));
    /// ```
    pub fn normal(&self, face: usize) -> Vec2 {
        if face == Self::LEFT { self.direction.turned_left() } else { self.direction.turned_right() }
    }

    /// Length [m].
    ///
    /// # Example
    /// ```
    /// use carom_motion::planar::Obstacle;
    /// use carom_num::Vec2;
    /// assert_eq!(Obstacle::new(Vec2::new(1.0, 2.0), Vec2::new(4.0, 6.0), 0.3, 0.5).length(), 5.0);
    /// ```
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Unit direction from one end to the other.
    ///
    /// # Example
    /// ```
    /// use carom_motion::planar::Obstacle;
    /// use carom_num::Vec2;
    /// let plate = Obstacle::new(Vec2::new(1.0, 2.0), Vec2::new(4.0, 6.0), 0.3, 0.5);
    /// assert_eq!(plate.direction(), Vec2::new(0.6, 0.8));
    /// ```
    pub fn direction(&self) -> Vec2 {
        self.direction
    }
}

/// How two bodies that touch each other rub and rebound.
///
/// # Example
/// Two balls of the same mass with e = 1 exchange their velocities.
/// ```
/// use carom_motion::planar::{Crowd, Options, Surface, World, examples};
/// let balls = vec![examples::disc(0.1, 1.0, 0.005); 2];
/// let between = Surface { friction: 0.2, restitution: 1.0 };
/// let world = World { bodies: balls, between, ..examples::two_balls() };
/// let at = examples::on_the_axis;
/// let mut crowd = Crowd::new(&world, Options::default());
/// crowd.enter(0, at(0.0, 2.0), vec![])?;
/// crowd.enter(1, at(1.2, 0.0), vec![])?;
/// crowd.advance(9.0, &mut [(), ()])?;
/// let speed = |body| crowd.member(body).map(|m| m.state().twist.velocity.x);
/// assert_eq!((speed(0), speed(1)), (Some(0.0), Some(2.0)));
/// # Ok::<(), carom_motion::planar::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// Coulomb friction coefficient, ≥ 0.
    pub friction: f64,
    /// Coefficient of restitution, in [0, 1].
    pub restitution: f64,
}
