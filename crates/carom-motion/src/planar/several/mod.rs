//! Several bodies, one after the other and against each other.

mod ahead;
mod crowd;
mod encounter;
mod island;
mod meeting;
mod member;
mod outlook;

pub use crowd::{Advance, Crowd};
pub use member::Member;
pub use outlook::Outlook;
