//! Stronge's law: the normal impulse returns in restitution e² of the work it took in compression.
//!
//! On a leg the work is quadratic in p_n, `∫u_n dp_n = (u_n² − u_n₀²)/(2a)`, so the final normal velocity V follows from the work
//! that is left on the last leg, and the impulse from V:
//!
//! ```text
//! types 1, 2, 3     V = e|C₀|                                        p_n = (1+e)|C₀|/a       (one leg only)
//! types 4, 6        V² = C_s² + (a₂/a₁) D (e|C₀| + C_s)              p_n = p_s + D (e|C₀| + C_s)/(a₁(V + C_s))
//!                   C_s = C₀ + a₁p_s in [0, e|C₀|),  D = e|C₀| − C_s = ((1+e)P_q − P_d)/k
//! types 5, 7        V² = e²[C_s² + a₂ p_s(|C₀| + |C_s|)]             p_n = p_c + V/a₂        C_s < 0
//! ```
//!
//! Only positive terms are added. Source: the law, Stronge (1990); the closed forms, ours.

use super::classify::Legs;
use super::contact::ImpactType;
use super::poisson::compression_impulse;

/// The normal impulse of the whole impact.
pub(super) fn normal_impulse(legs: &Legs, kind: ImpactType) -> f64 {
    use ImpactType as T;
    match kind {
        T::SlidesThroughout | T::SlipsFromRest | T::SticksFromRest => {
            (1.0 + legs.contact.restitution) * compression_impulse(legs, kind)
        }
        T::ReversesInRestitution | T::StopsInRestitution => {
            let velocities = legs.normal_velocity_at_stop() + final_normal_velocity(legs, kind);
            let returned = work_left(legs) / legs.a1;
            // Both velocities vanish only where nothing is left to return.
            legs.slip_stop() + if velocities > 0.0 { returned / velocities } else { 0.0 }
        }
        T::ReversesInCompression | T::StopsInCompression => {
            compression_impulse(legs, kind) + final_normal_velocity(legs, kind) / legs.last_response(kind)
        }
    }
}

/// D (e|C₀| + C_s): twice the work that is left where the slip stops in restitution, times a₁.
fn work_left(legs: &Legs) -> f64 {
    let restitution = legs.contact.restitution;
    // Rounding on the boundary to type 1 must not leave a negative rest, magnified by a₂/a₁.
    let missing = (-legs.slip_excess(1.0 + restitution) / legs.k).max(0.0);
    missing * (restitution * legs.closing + legs.normal_velocity_at_stop())
}

/// V = u_n⁺.
pub(super) fn final_normal_velocity(legs: &Legs, kind: ImpactType) -> f64 {
    use ImpactType as T;
    let e = legs.contact.restitution;
    match kind {
        T::SlidesThroughout | T::SlipsFromRest | T::SticksFromRest => e * legs.closing,
        T::ReversesInRestitution | T::StopsInRestitution => {
            let at_stop = legs.normal_velocity_at_stop();
            (at_stop * at_stop + legs.last_response(kind) / legs.a1 * work_left(legs)).sqrt()
        }
        T::ReversesInCompression | T::StopsInCompression => {
            let at_stop = legs.normal_velocity_at_stop();
            let taken = legs.slip_stop() * (legs.closing + at_stop.abs());
            e * (at_stop * at_stop + legs.last_response(kind) * taken).sqrt()
        }
    }
}
