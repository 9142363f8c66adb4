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

mod contacts;
mod ends;
mod rates;
mod stages;

pub use contacts::single;
pub use ends::{end_states, pivoting};
pub use rates::{forces, rate};
pub use stages::{share, sharing, staged, stiffness};

pub use contacts::bodies::{Meeting, RigidBody, struck};
pub use contacts::names::{Class, ContactState, ImpactType, Slip, StageEnd};
pub use contacts::set::{Block, ContactSet, ContactSet2, ContactSet6, MOST_CONTACTS, Touch};
pub use rates::answer::{Answer, Broken, Condition, Guess, Solution};
