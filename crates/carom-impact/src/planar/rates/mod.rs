//! The rate problem: which contacts separate, stick or slip under a drive, every hypothesis examined.

pub(in crate::planar) mod answer;
pub(in crate::planar) mod complementarity;
pub(in crate::planar) mod equations;
pub(in crate::planar) mod family;
pub mod forces;
pub(in crate::planar) mod pair;
pub mod rate;
mod standstill;
pub(in crate::planar) mod verify;
