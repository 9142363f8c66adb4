//! The staged walk: stages of compression and restitution at several contacts, whose slips turn on the way.

mod account;
mod curve;
mod debt;
pub(in crate::spatial) mod leg;
mod onset;
mod paradox;
mod settled;
pub mod staged;
mod walk;
mod watch;
