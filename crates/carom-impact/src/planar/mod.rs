//! Impact in the plane with Coulomb friction.
//!
//! A contact frame is (t, n): `n` points out of the obstacle into the body, `t` is `n` turned 90° clockwise. `u = (u_t, u_n)` is
//! the velocity of the body's contact point relative to the obstacle, so an approach has `u_n < 0`; `p = (p_t, p_n)` is the
//! impulse on the body and `u⁺ = u⁻ + W p`.
//!
//! - [`rate`]: which contacts separate, stick or slip, asked by impacts and by motion alike;
//! - [`forces`]: bodies that touch, under forces;
//! - [`single`]: one contact, by Routh's walk;
//! - [`staged`]: any number of contacts up to [`MOST_CONTACTS`];
//! - [`share`]: impulses of compression that are open, and what restitution makes of them;
//! - [`sharing`]: other conventions on how contacts that close together share an impact, [`stiffness`] among them;
//! - [`end_states`]: every end state, judged at the end;
//! - [`pivoting`]: one end state of more contacts than can be enumerated.

mod accumulation;
mod answer;
mod bodies;
mod circle;
mod clock;
mod complementarity;
pub mod end_states;
mod equations;
mod family;
pub mod forces;
mod names;
mod pair;
mod paradox;
pub mod pivoting;
pub mod rate;
mod set;
pub mod share;
pub mod sharing;
pub mod single;
mod stage;
pub mod staged;
pub mod stiffness;
mod verify;
mod walk;

pub use answer::{Answer, Broken, Condition, Guess, Solution};
pub use bodies::{Meeting, RigidBody, struck};
pub use names::{Class, ContactState, ImpactType, Slip, StageEnd};
pub use set::{Block, ContactSet, ContactSet2, ContactSet6, MOST_CONTACTS, Touch};
