//! Bodies in space: velocities, impulses and frictions are vectors in the contact's tangent plane and along its normal.
//!
//! A contact frame is (t₁, t₂, n), right-handed: `n` points out of what is touched into the body.
//!
//! - [`ContactSet`]: the contacts of a body, or of several that meet, and their operator W;
//! - [`RateProblem`]: which contacts separate, stick or slip, under the round friction cone;
//! - [`Contact`]: one contact, by Routh's walk;
//! - [`staged`]: several contacts, by the walk whose slips turn;
//! - [`ContactSet::states_of_keeping`]: every state of the law under which nothing slides.

mod contacts;
mod ends;
mod rates;
mod stages;

pub use stages::staged;

pub use contacts::bodies::{Meeting, struck};
pub use contacts::set::{ContactSet, MOST_EXAMINED, RigidBody, Touch};
pub use contacts::single::{Contact, Outcome, Slip, Stage, StageEnd};
pub use ends::non_sliding::{Conclusion, KeptState, Refusal, Refused, StatesOfKeeping};
pub use rates::answer::{Answer, Condition, Freedom, Guess, Mode, Preference, Solution};
pub use rates::rate::RateProblem;
pub use stages::leg::StageEvent;
pub use stages::staged::{Ground, StagedOutcome, Station};
