//! Rigid bodies in time: shapes, gaps, flight, contact modes, events.
//!
//! [`planar`] holds bodies that move in a plane. World frame: x right, y up, angles and spins counter-clockwise, SI units.
//! [`spatial`] holds a body over a plane in space: it flies, pivots and rests on its supports, and slides on them where the plane has friction.

mod error;
mod evaluated;
mod periods;
pub mod planar;
pub mod spatial;
mod tolerance;

pub use error::MotionError;
