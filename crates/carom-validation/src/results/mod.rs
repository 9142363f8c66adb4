//! How the engine computes each published result.

pub(crate) mod blocks;
pub(crate) mod chains;
pub(crate) mod dice;
pub(crate) mod falling;
pub mod feeder_paper;
pub(crate) mod one_contact;
pub(crate) mod polygons;
pub(crate) mod rocking_paper;
mod rolling;
pub(crate) mod spatial_paper;
pub(crate) mod turning_rule;
