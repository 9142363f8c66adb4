//! All tests of this crate in one program: it is linked once.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

#[macro_use]
mod command;

mod boundary;
mod broken_writes;
mod cli;
mod closed;
mod contact;
mod fits;
mod impact_in_space;
mod judge;
mod labels;
mod lines;
mod poses;
mod programs;
mod regions;
mod regions_in_space;
mod rolls_in_space;
mod schemas;
mod simulators;
mod solids;
mod studies;
mod thin;
mod thrown;
mod tree;
mod unreadable;
mod validate;
