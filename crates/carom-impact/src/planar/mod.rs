//! Impact in the plane with Coulomb friction.
//!
//! A contact frame is (t, n): `n` points out of the obstacle into the body, `t` is `n` turned 90° clockwise. `u = (u_t, u_n)` is
//! the velocity of the body's contact point relative to the obstacle, so an approach has `u_n < 0`; `p = (p_t, p_n)` is the
//! impulse on the body and `u⁺ = u⁻ + W p`.

mod names;

pub use names::{Class, ContactState, ImpactType, Law, Phase, Slip, StageEnd};
