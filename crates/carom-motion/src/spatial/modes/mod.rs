//! What the supports of a body do: which are held, how it moves then, and what the law says of those that touch.

pub(in crate::spatial) mod bounds;
pub(in crate::spatial) mod capacity;
pub(in crate::spatial) mod contacts;
pub(in crate::spatial) mod frictional;
pub(in crate::spatial) mod grip;
pub(in crate::spatial) mod mode;
pub(in crate::spatial) mod settle;
pub(in crate::spatial) mod stretch;
