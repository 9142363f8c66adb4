//! All tests of this crate in one program: it is linked once.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod borders;
mod bridged_hollow;
mod circular_chute;
mod disc_on_disc;
mod errata;
mod integrate;
mod motion;
mod oracle;
mod printed_tables;
mod rocking;
mod round_edge;
mod single_contact;
mod single_contact_laws;
mod tables;
mod wedging;
