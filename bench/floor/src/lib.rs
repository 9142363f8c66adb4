//! What a two-plate drop costs at least.
//!
//! A straight-line program of the feeder paper's drop: one thin rod, two plates, no restitution, and nothing else.
//! It asks no rate problem, tries no hypotheses, keeps no list of what may touch; every stage is followed by the Taylor series of its own equations,
//! whose event quantities are series too.
//! Carom does the same drop with one walk for any part among any plates; the ratio of the two is what that costs.

mod answer;
mod carom;
mod designs;
mod drop;
mod flight;
mod plate;
mod series;
mod strike;
mod tip;
mod tolerance;
mod upper;

pub use answer::{Answer, Design, GRAVITY, HALF_LENGTH, KAPPA, Landing, Prepared, Uncovered};
pub use carom::{answer, options};
pub use designs::grid;
pub use drop::{coarse, fine};
