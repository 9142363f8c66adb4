//! Contacts of rigid bodies at one instant: the rate problem and the staged impact.
//!
//! [`planar`] holds bodies that move in a plane, [`spatial`] bodies in space.

pub mod planar;
pub mod spatial;
mod tolerance;
