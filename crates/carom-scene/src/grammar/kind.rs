//! Kinds of quantities that files hold: what each measures, and what values it may have.

use crate::quantity::{Allowed, Kind};
use crate::unit::Dimension;

pub(crate) const LENGTH: Kind = Kind::new(Dimension::Length, Allowed::Positive);
pub(crate) const LENGTH_OR_NONE: Kind = Kind::new(Dimension::Length, Allowed::NotNegative);
pub(crate) const COORDINATE: Kind = Kind::new(Dimension::Length, Allowed::Any);
pub(crate) const SLOPE: Kind = Kind::new(Dimension::Angle, Allowed::Slope);
/// Angle between a chamfer and an axis: below a right angle.
pub(crate) const CHAMFER: Kind = Kind::new(Dimension::Angle, Allowed::Slope);
pub(crate) const TURN: Kind = Kind::new(Dimension::Angle, Allowed::Any);
pub(crate) const MASS: Kind = Kind::new(Dimension::Mass, Allowed::Positive);
pub(crate) const INERTIA: Kind = Kind::new(Dimension::Inertia, Allowed::Positive);
/// A product of inertia may have either sign.
pub(crate) const PRODUCT: Kind = Kind::new(Dimension::Inertia, Allowed::Any);
pub(crate) const DENSITY: Kind = Kind::new(Dimension::Density, Allowed::Positive);
pub(crate) const GRAVITY: Kind = Kind::new(Dimension::Acceleration, Allowed::Positive);
pub(crate) const ACCELERATION: Kind = Kind::new(Dimension::Acceleration, Allowed::Any);
pub(crate) const SPEED: Kind = Kind::new(Dimension::Speed, Allowed::NotNegative);
pub(crate) const MAX_SPEED: Kind = Kind::new(Dimension::Speed, Allowed::Positive);
/// A component of a velocity.
pub(crate) const VELOCITY: Kind = Kind::new(Dimension::Speed, Allowed::Any);
/// A normal velocity before an impact.
pub(crate) const APPROACH: Kind = Kind::new(Dimension::Speed, Allowed::Negative);
pub(crate) const SPIN: Kind = Kind::new(Dimension::Spin, Allowed::Any);
pub(crate) const SPIN_RATE: Kind = Kind::new(Dimension::Spin, Allowed::NotNegative);
pub(crate) const TIME: Kind = Kind::new(Dimension::Time, Allowed::Positive);
pub(crate) const FORCE: Kind = Kind::new(Dimension::Force, Allowed::Any);
pub(crate) const TORQUE: Kind = Kind::new(Dimension::Torque, Allowed::Any);
pub(crate) const FRICTION: Kind = Kind::new(Dimension::Number, Allowed::Coefficient);
pub(crate) const RESTITUTION: Kind = Kind::new(Dimension::Number, Allowed::Fraction);
/// A ratio, a factor, a stiffness beside others.
pub(crate) const SCALE: Kind = Kind::new(Dimension::Number, Allowed::Positive);
/// A component of a direction, an entry of a matrix.
pub(crate) const NUMBER: Kind = Kind::new(Dimension::Number, Allowed::Any);
pub(crate) const COUNT: Kind = Kind::new(Dimension::Count, Allowed::Whole(1, 1000));
/// Strikes that are followed: a tile on its edges keeps 0.996 of its speed at each.
pub(crate) const STRIKES: Kind = Kind::new(Dimension::Count, Allowed::Whole(1, 10_000));
pub(crate) const PARTS: Kind = Kind::new(Dimension::Count, Allowed::Whole(1, 100));
pub(crate) const FACE: Kind = Kind::new(Dimension::Count, Allowed::Face);
/// Corners of a pyramid's base, supports of a stool.
pub(crate) const POINTS: Kind = Kind::new(Dimension::Count, Allowed::Whole(3, 12));
