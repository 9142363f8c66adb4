//! Bodies in space: velocities, impulses and frictions are vectors in the contact's tangent plane and along its normal.
//!
//! A contact frame is (t₁, t₂, n), right-handed: `n` points out of what is touched into the body.
//!
//! - [`ContactSet`]: the contacts of a body, or of several that meet, and their operator W;
//! - [`RateProblem`]: which contacts separate, stick or slip, under the round friction cone;
//! - [`Contact`]: one contact, by Routh's walk;
//! - [`staged`]: several contacts, by the walk whose slips turn;
//! - [`ContactSet::states_of_keeping`]: every state of the law under which nothing slides.

mod account;
mod answer;
mod bodies;
mod curve;
mod debt;
mod equations;
mod forces;
mod hodograph;
mod leg;
mod motions;
mod non_sliding;
mod onset;
mod paradox;
mod rate;
mod reduced;
mod set;
mod settled;
mod single;
pub mod staged;
mod starts;
mod walk;
mod watch;

pub use answer::{Answer, Condition, Freedom, Guess, Mode, Preference, Solution};
pub use bodies::{Meeting, struck};
pub use leg::StageEvent;
pub use non_sliding::{Conclusion, KeptState, Refusal, Refused, StatesOfKeeping};
pub use rate::{MOST_EXAMINED, RateProblem};
pub use set::{ContactSet, RigidBody, Touch};
pub use single::{Contact, Outcome, Slip, Stage, StageEnd};
pub use staged::{Ground, StagedOutcome, Station};
