//! All tests of this crate in one program: it is linked once.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod cells;
mod corner;
#[path = "../../carom-feeder/tests/extruded.rs"]
mod extruded;
mod feeds;
mod feeds_solid;
mod fits;
mod located;
mod paper;
mod poses;
mod poses_planar;
#[path = "../../carom-feeder/tests/random/mod.rs"]
mod random;
mod regions;
mod rocking;
mod walls;
mod yields;
