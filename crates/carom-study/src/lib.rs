//! Studies: what many impacts or runs have in common.
//!
//! - [`regions`]: the regions of a plane of two quantities in which the same thing happens, and the curves between them.
//! - [`rocking`]: the strike of a rolling cylinder, a prism or a rod, as the engine resolves it;
//! - [`Ends`]: how sure an outcome is: the end states that the laws allow;
//! - [`corner`]: the strike of a part's corner, by the two angles that describe it.

pub mod corner;
mod ends;
pub mod regions;
pub mod rocking;

pub use ends::Ends;
