//! The rate problem: which contacts separate, stick or slip under a drive, under the round cone of friction.

pub(in crate::spatial) mod answer;
pub(in crate::spatial) mod closed;
pub(in crate::spatial) mod equations;
pub(in crate::spatial) mod forces;
pub(in crate::spatial) mod motions;
pub(in crate::spatial) mod rate;
pub(in crate::spatial) mod reduced;
mod springs;
pub(in crate::spatial) mod starts;
