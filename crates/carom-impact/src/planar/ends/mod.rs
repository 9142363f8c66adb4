//! End states, judged at the end and not along the way.

pub mod end_states;
pub mod pivoting;
