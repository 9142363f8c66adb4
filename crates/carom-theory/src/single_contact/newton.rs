//! Newton's law: u_n⁺ = −e u_n⁻, whatever happened on the way.
//!
//! The normal velocity gains `(1 + e)|C₀|`, and p_n is linear in that gain on the leg where the impact ends:
//!
//! ```text
//! types 1, 2, 3     as Poisson's law
//! types 4, 5        ((1+e)k|C₀| − 2sμB₃|S₀|)/(k(B₂ − sμB₃))
//! types 6, 7        ((1+e)B₁|C₀| − B₃S₀)/(B₁B₂ − B₃²)
//! ```
//!
//! The energy may grow in types 4 to 7 (Kane and Levinson 1985; Keller 1986). Source of the closed forms: ours, from the legs.

use super::classify::Legs;
use super::contact::ImpactType;
use super::poisson::impulse_to_reach;

/// The normal impulse of the whole impact.
pub(super) fn normal_impulse(legs: &Legs, kind: ImpactType) -> f64 {
    impulse_to_reach(legs, kind, (1.0 + legs.contact.restitution) * legs.closing)
}
