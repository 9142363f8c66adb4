//! The world, and where its bodies and obstacles touch: gaps, distances, overlaps.

mod across;
mod between;
pub(in crate::planar) mod bounds;
pub(in crate::planar) mod clearance;
mod joint;
pub(in crate::planar) mod kinematics;
mod nearest;
mod overlap;
pub(in crate::planar) mod separation;
pub(in crate::planar) mod touching;
pub(in crate::planar) mod world;

pub use kinematics::{Kinematics, Pairing};
pub use world::{Scales, World};
