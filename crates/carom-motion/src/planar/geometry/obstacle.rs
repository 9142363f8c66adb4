//! Fixed obstacles: segments with two ends, and any other shape.

use super::Shape;
use carom_num::Vec2;

/// A fixed shape with friction and restitution against the body: most often a straight segment of no thickness, of which both sides and both ends
/// can be struck.
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
#[derive(Clone, Debug, PartialEq)]
pub struct Obstacle {
    from: Vec2,
    to: Vec2,
    shape: Shape,
    /// Coulomb friction coefficient, ≥ 0.
    pub friction: f64,
    /// Coefficient of restitution, in [0, 1].
    pub restitution: f64,
    // Asked for in every state of every motion.
    length: f64,
    direction: Vec2,
    /// A circle around it: centre and radius [m].
    middle: Vec2,
    half: f64,
    segment: bool,
    /// Bent, and without thickness: its outline runs there and back on one line.
    bent_thin: bool,
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
        Self::of_shape(Shape::of_checked(vec![from, to], 0.0), friction, restitution)
    }

    /// A fixed shape, drawn about the world's origin. It counts as running from its first vertex, `from`, to its last one on the way there, `to`: of a
    /// shape without thickness these are its ends.
    ///
    /// # Example
    /// A round pin of 2 m.
    /// ```
    /// use carom_motion::planar::{Obstacle, Shape};
    /// use carom_num::Vec2;
    /// let pin = Obstacle::of_shape(Shape::new(vec![Vec2::new(3.0, 4.0)], 2.0).unwrap(), 0.3, 0.5);
    /// assert_eq!((pin.from(), pin.length()), (Vec2::new(3.0, 4.0), 0.0));
    /// ```
    pub fn of_shape(shape: Shape, friction: f64, restitution: f64) -> Self {
        let vertices = shape.vertices();
        let (from, to) = (vertices[0], vertices[vertices.len() / 2]);
        let length = (to - from).norm();
        let direction = if length > 0.0 { (to - from) / length } else { Vec2::new(1.0, 0.0) };
        let segment = shape.is_thin_rod();
        let hull = shape.hull();
        let middle =
            hull.vertices().iter().fold(Vec2::ZERO, |sum, v| sum + *v) / hull.vertices().len() as f64;
        let half = hull.vertices().iter().map(|v| (*v - middle).norm()).fold(0.0, f64::max) + hull.radius();
        let bent_thin = !segment && shape.runs_there_and_back();
        Self { from, to, shape, friction, restitution, length, direction, middle, half, segment, bent_thin }
    }

    /// What it looks like, in the world's frame.
    ///
    /// # Example
    /// A segment has the two vertices and two faces of a rod.
    /// ```
    /// use carom_motion::planar::Obstacle;
    /// use carom_num::Vec2;
    /// let plate = Obstacle::new(Vec2::ZERO, Vec2::new(3.0, 4.0), 0.3, 0.5);
    /// assert_eq!(plate.shape().faces(), 2);
    /// assert_eq!(plate.shape().face_normal(Obstacle::LEFT), plate.normal(Obstacle::LEFT));
    /// ```
    pub fn shape(&self) -> &Shape {
        &self.shape
    }

    /// False where a point is farther from it than `reach` [m] for certain.
    pub(in crate::planar) fn is_within(&self, point: Vec2, reach: f64) -> bool {
        let d = point - self.from;
        if self.is_segment() {
            let s = self.direction.dot(d);
            return self.direction.cross(d).abs() <= reach && s >= -reach && s <= self.length + reach;
        }
        (point - self.middle).norm() <= self.half + reach
    }

    /// True for a straight segment of no thickness.
    #[inline]
    pub(in crate::planar) fn is_segment(&self) -> bool {
        self.segment
    }

    /// True for what is bent and has no thickness.
    pub(in crate::planar) fn is_bent_thin(&self) -> bool {
        self.bent_thin
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

    /// One of the two ends, or of the vertices, by its number [m].
    ///
    /// # Example
    /// ```
    /// use carom_motion::planar::Obstacle;
    /// use carom_num::Vec2;
    /// let plate = Obstacle::new(Vec2::new(1.0, 2.0), Vec2::new(4.0, 6.0), 0.3, 0.5);
    /// assert_eq!((plate.end(0), plate.end(1)), (plate.from(), plate.to()));
    /// ```
    pub fn end(&self, end: usize) -> Vec2 {
        self.shape.vertices()[end]
    }

    /// Unit normal out of one of the faces, by its number.
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
        self.shape.face_normal(face)
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
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// Coulomb friction coefficient, ≥ 0.
    pub friction: f64,
    /// Coefficient of restitution, in [0, 1].
    pub restitution: f64,
}
