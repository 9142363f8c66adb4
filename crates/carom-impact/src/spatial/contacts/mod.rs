//! The contacts of a body, or of several that meet, and what one contact does by itself.

pub(in crate::spatial) mod bodies;
pub(in crate::spatial) mod hodograph;
pub(in crate::spatial) mod set;
pub(in crate::spatial) mod single;
