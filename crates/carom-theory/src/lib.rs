//! Closed forms of the literature on sliding, tipping, rocking and striking bodies.
//!
//! Every function states its equation, its domain, its source and a number that can be checked by hand. Nothing here calls the
//! engine, and the engine calls nothing here: tests, validation and region diagrams compare the two.
//!
//! Units are SI and angles radians throughout. A contact frame is (t, n): `n` points out of the obstacle into the body and `t` is
//! `n` turned 90° clockwise, so that (t, n) is right-handed. Spins are counter-clockwise, unless a quantity is called a *roll
//! rate*, which is positive when the body rolls forward, along +t (clockwise).

mod domain;
mod pendulum;
mod products;
mod roots;
mod vectors;

pub mod bouncing;
pub mod bridged_hollow;
pub mod circular_chute;
pub mod disc_on_disc;
pub mod eccentric_disc;
pub mod falling_stick;
pub mod free_body;
pub mod hooked_part;
pub mod incline;
pub mod painleve;
pub mod rocking;
pub mod rod_on_edge;
pub mod rod_on_plate;
pub mod round_edge;
pub mod single_contact;
pub mod solids;
pub mod spatial;
pub mod wedging;

pub use domain::OutsideDomain;
