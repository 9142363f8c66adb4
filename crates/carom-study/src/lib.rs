//! Studies: what many impacts or runs have in common.
//!
//! - [`regions`]: the regions of a plane of two quantities in which the same thing happens, and the curves between them.

pub mod regions;
