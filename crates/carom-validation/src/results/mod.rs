//! How the engine computes each published result.

pub(crate) mod blocks;
pub mod feeder_paper;
mod rolling;
