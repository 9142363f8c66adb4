//! Bodies in space: velocities, impulses and frictions are vectors in the contact's tangent plane and along its normal.
//!
//! A contact frame is (t₁, t₂, n), right-handed: `n` points out of what is touched into the body.

mod answer;
mod bodies;
mod equations;
mod forces;
mod hodograph;
mod non_sliding;
mod rate;
mod reduced;
mod set;
mod single;
mod starts;

pub use answer::{Answer, Condition, Freedom, Guess, Mode, Solution};
pub use bodies::{Meeting, struck};
pub use non_sliding::{Conclusion, KeptState, Refusal, Refused, StatesOfKeeping};
pub use rate::{MOST_EXAMINED, RateProblem, SLACK_TOLERANCE, Search};
pub use set::{ContactSet, RigidBody, Touch};
pub use single::{Contact, Outcome, Slip, Stage, StageEnd};
