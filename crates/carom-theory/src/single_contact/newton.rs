//! Newton's law: u_n⁺ = −e u_n⁻, whatever happened on the way.
//!
//! ```text
//! types 1, 2, 3     p_n = (1+e)|C₀|/a                                  as Poisson's law
//! types 4, 6        p_n = p_s + D/a₂                                   D = e|C₀| − C_s = ((1+e)P_q − P_d)/k
//! types 5, 7        p_n = p_c + e|C₀|/a₂                               p_c: the impulse of compression
//! ```
//!
//! The sticking types solve `W p = (−S₀, (1+e)|C₀|)`: `p_n = ((1+e)B₁|C₀| − B₃S₀)/(B₁B₂ − B₃²)`, whose numerator cancels when the
//! second leg is much softer than the first (a₂ ≪ a₁); the forms above do not cancel.
//!
//! The energy may grow in types 4 to 7 (Kane and Levinson 1985; Keller 1986). Source of the closed forms: ours, from the legs.

use super::classify::Legs;
use super::contact::ImpactType;
use super::poisson::compression_impulse;

/// The normal impulse of the whole impact.
pub(super) fn normal_impulse(legs: &Legs, kind: ImpactType) -> f64 {
    use ImpactType as T;
    let e = legs.contact.restitution;
    match kind {
        T::SlidesThroughout | T::SlipsFromRest | T::SticksFromRest => {
            (1.0 + e) * compression_impulse(legs, kind)
        }
        T::ReversesInRestitution | T::StopsInRestitution => {
            let missing = (-legs.slip_excess(1.0 + e) / legs.k).max(0.0);
            legs.slip_stop() + missing / legs.last_response(kind)
        }
        T::ReversesInCompression | T::StopsInCompression => {
            compression_impulse(legs, kind) + e * legs.closing / legs.last_response(kind)
        }
    }
}
