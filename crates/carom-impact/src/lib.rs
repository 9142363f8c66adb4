//! Contacts of rigid bodies at one instant: the rate problem and the staged impact.
//!
//! [`planar`] holds bodies that move in a plane.

pub mod planar;
