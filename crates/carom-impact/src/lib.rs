//! Contacts of rigid bodies at one instant: the rate problem and the staged impact.
//!
//! [`planar`] holds bodies that move in a plane, [`spatial`] bodies in space.

mod error;
mod faults;
mod law;
mod load;
pub mod planar;
pub mod spatial;
mod subsets;
mod tolerance;

pub use error::ImpactError;
pub use faults::Faults;
pub use law::{Law, Phase};
pub use load::Load;
