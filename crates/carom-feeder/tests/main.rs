//! All tests of this crate in one program: it is linked once.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod bent;
mod budgets;
mod delivered;
mod exact;
mod extruded;
mod feed;
mod grid;
mod invariance;
mod names;
mod paper;
mod random;
mod random_feeders;
mod spatial;
mod spatial_discs;
mod spatial_grooves;
mod spatial_hollows;
mod strikes;
