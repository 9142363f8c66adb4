//! Rigid bodies in time: shapes, gaps, flight, contact modes, events.
//!
//! [`planar`] holds bodies that move in a plane. World frame: x right, y up, angles and spins counter-clockwise, SI units.
//! [`spatial`] holds a body that moves over a plane in space without sliding.

mod evaluated;
pub mod planar;
pub mod spatial;
