//! All tests of this crate in one program: it is linked once.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod bodies;
mod certainty;
mod chains;
mod contacts;
mod derived;
mod form;
mod held;
mod hollows;
mod impact;
mod impact_space;
mod layout;
mod library;
mod mass_centre;
mod outline;
mod poses;
mod problems;
mod random_layouts;
mod refusals;
mod roll;
mod run_report;
mod solid_faces;
mod solid_hollows;
mod space;
mod starts;
mod truncated;
mod typed;
mod work_counts;
