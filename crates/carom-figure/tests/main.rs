//! All tests of this crate in one program: it is linked once.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod claims;
mod fixture;
mod joint;
mod many_corners;
mod regions;
mod report;
mod space;
mod yields;
