//! All tests of this crate in one program: it is linked once.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod circles;
mod closed_forms;
mod cradles;
mod double_events;
mod driven_together;
mod exact_law;
mod labels;
mod laws;
mod obstacles;
mod random;
mod random_sets;
mod rate_problem;
mod refused_bodies;
mod rejection_shares;
mod rocking;
mod rocking_bodies;
mod rocking_boundaries;
mod rocking_laws;
mod rocking_tables;
mod spatial_account;
mod spatial_border;
mod spatial_errata;
mod spatial_faces;
mod spatial_four_feet;
mod spatial_keeping;
mod spatial_limits;
mod spatial_order;
mod spatial_paradox;
mod spatial_rates;
mod spatial_shares;
mod spatial_single;
mod spatial_staged;
mod spatial_twist;
mod spatial_unequal;
mod standstill;
mod symmetries;
#[path = "../../carom-theory/tests/tables/mod.rs"]
mod tables;
mod two_contacts;
mod unequal_feet;
mod wedged;
