//! Contacts: one, several of a body or of bodies, and the names of what they do.

pub(in crate::planar) mod bodies;
pub(in crate::planar) mod names;
pub(in crate::planar) mod set;
pub mod single;
