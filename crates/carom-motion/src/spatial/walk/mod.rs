//! The walk in time: motion in a mode, its events, and what follows them.

pub(in crate::spatial) mod blow;
pub(in crate::spatial) mod closing;
pub(in crate::spatial) mod events;
pub(in crate::spatial) mod few;
pub(in crate::spatial) mod flush;
pub(in crate::spatial) mod forces;
pub(in crate::spatial) mod glide;
pub(in crate::spatial) mod gliding;
pub(in crate::spatial) mod march;
pub(in crate::spatial) mod motion;
pub(in crate::spatial) mod onset;
pub(in crate::spatial) mod put_down;
pub(in crate::spatial) mod question;
pub(in crate::spatial) mod rough;
pub(in crate::spatial) mod series;
pub(in crate::spatial) mod sliding;
pub(in crate::spatial) mod slips;
pub(in crate::spatial) mod strike;
pub(in crate::spatial) mod walker;
