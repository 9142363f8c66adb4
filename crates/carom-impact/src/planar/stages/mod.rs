//! The walk in impulse: stages of an impact, and how contacts share it.

pub(in crate::planar) mod accumulation;
pub(in crate::planar) mod circle;
pub(in crate::planar) mod clock;
pub(in crate::planar) mod paradox;
pub mod share;
pub mod sharing;
pub(in crate::planar) mod stage;
pub mod staged;
pub mod stiffness;
pub(in crate::planar) mod walk;
