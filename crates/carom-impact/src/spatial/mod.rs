//! Bodies in space: velocities, impulses and frictions are vectors in the contact's tangent plane and along its normal.
//!
//! A contact frame is (t₁, t₂, n), right-handed: `n` points out of what is touched into the body.

mod bodies;
mod hodograph;
mod non_sliding;
mod set;
mod single;

pub use bodies::{Meeting, struck};
pub use non_sliding::{Conclusion, KeptState, Refusal, Refused, StatesOfKeeping};
pub use set::{ContactSet, RigidBody, Touch};
pub use single::{Contact, Outcome, Slip, Stage, StageEnd};
