//! From event to event: flights, glides, strikes, and the search for what comes next.

pub(in crate::planar) mod accumulation;
pub(in crate::planar) mod collide;
mod consequence;
mod dependent;
mod events;
pub(in crate::planar) mod flight;
mod glide;
mod gliding;
mod holding;
mod nodes;
mod opening;
pub(in crate::planar) mod path;
mod project;
mod reports;
mod rocking;
mod series;
mod sides;
mod steady;
mod swing;
pub(in crate::planar) mod terms;
pub(in crate::planar) mod walker;

pub use terms::{Effort, Happening, Margin, MarginOf, Options};
pub use walker::Walker;
