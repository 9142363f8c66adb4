//! Stronge's law: the normal impulse returns in restitution e² of the work it took in compression.
//!
//! On a leg the work is quadratic in p_n, `∫u_n dp_n = (u_n² − u_n₀²)/(2a)`, so the final normal velocity V follows from the work
//! that is left on the last leg, and p_n from V as under Newton's law with V in place of e|C₀|:
//!
//! ```text
//! types 1, 2, 3     V = e|C₀|                                              (one leg only)
//! types 4, 6        V² = C_s² + (a₂/a₁)(e|C₀| − C_s)(e|C₀| + C_s)          C_s = C₀ + a₁p_s in [0, e|C₀|)
//! types 5, 7        V² = e²[C_s² + a₂ p_s(|C₀| + |C_s|)]                   C_s < 0
//! ```
//!
//! Every term is positive, so nothing cancels. Source: the law, Stronge (1990); the closed forms, ours.

use super::classify::Legs;
use super::contact::ImpactType;
use super::poisson::impulse_to_reach;

/// The normal impulse of the whole impact.
pub(super) fn normal_impulse(legs: &Legs, kind: ImpactType) -> f64 {
    impulse_to_reach(legs, kind, legs.closing + final_normal_velocity(legs, kind))
}

/// V = u_n⁺.
pub(super) fn final_normal_velocity(legs: &Legs, kind: ImpactType) -> f64 {
    use ImpactType as T;
    let e = legs.contact.restitution;
    let newtons = e * legs.closing;
    match kind {
        T::SlidesThroughout | T::SlipsFromRest | T::SticksFromRest => newtons,
        T::ReversesInRestitution | T::StopsInRestitution => {
            let at_stop = legs.normal_velocity_at_stop();
            // Rounding on the boundary to type 1 must not leave a negative rest, magnified by a₂/a₁.
            let left = (newtons - at_stop).max(0.0) * (newtons + at_stop);
            (at_stop * at_stop + legs.last_response(kind) / legs.a1 * left).sqrt()
        }
        T::ReversesInCompression | T::StopsInCompression => {
            let at_stop = legs.normal_velocity_at_stop();
            let taken = legs.slip_stop() * (legs.closing + at_stop.abs());
            e * (at_stop * at_stop + legs.last_response(kind) * taken).sqrt()
        }
    }
}
