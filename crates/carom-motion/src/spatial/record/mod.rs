//! What happens on the way, for those who look on.

pub mod observer;
pub(in crate::spatial) mod run;
