//! What contacts that are held let a body do: constraints, their forces, what ends them.

mod beside;
pub(in crate::planar) mod line;
pub(in crate::planar) mod mode;
pub(in crate::planar) mod question;
pub(in crate::planar) mod snapshot;
pub(in crate::planar) mod strike;
pub(in crate::planar) mod watch;
