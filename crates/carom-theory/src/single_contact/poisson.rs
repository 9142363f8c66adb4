//! Poisson's law: p_n = (1 + e) · p_n(compression).
//!
//! ```text
//! type     p_n(compression)                            p_t at the end, any law
//! 1        |C₀|/a₁                                     −sμ p_n
//! 2        |C₀|/(B₂ − μ|B₃|)                           μ sign(B₃) p_n
//! 3        B₁|C₀|/(B₁B₂ − B₃²)                         B₃ p_n/B₁
//! 4        |C₀|/a₁                                     sμ(p_n − 2|S₀|/k)
//! 5        (k|C₀| − 2sμB₃|S₀|)/(k(B₂ − sμB₃))          sμ(p_n − 2|S₀|/k)
//! 6        |C₀|/a₁                                     (B₃p_n − S₀)/B₁
//! 7        (B₁|C₀| − B₃S₀)/(B₁B₂ − B₃²)                (B₃p_n − S₀)/B₁
//! ```
//!
//! Source: Wang and Mason (1992), table of closed forms, written with |C₀| = −C₀ and k = μB₁ + sB₃.

use super::classify::Legs;
use super::contact::ImpactType;
use crate::products::{difference_of_products, product_plus};

/// p_n at the end of compression. It is the same under every law.
pub(super) fn compression_impulse(legs: &Legs, kind: ImpactType) -> f64 {
    use ImpactType as T;
    match kind {
        T::SlidesThroughout | T::ReversesInRestitution | T::StopsInRestitution => legs.closing / legs.a1,
        T::SlipsFromRest => legs.closing / legs.a2_slipping(),
        T::SticksFromRest => legs.b1 * legs.closing / legs.det,
        T::ReversesInCompression => {
            // B₃ has the sign s when the slip reverses, so sB₃ = |B₃|.
            let braking = 2.0 * legs.contact.friction * legs.b3.abs();
            let pressed = difference_of_products(legs.k, legs.closing, braking, legs.slip);
            pressed / (legs.k * legs.a2_slipping())
        }
        T::StopsInCompression => {
            difference_of_products(legs.b1, legs.closing, legs.b3, legs.contact.slip) / legs.det
        }
    }
}

/// The normal impulse of the whole impact.
pub(super) fn normal_impulse(legs: &Legs, kind: ImpactType) -> f64 {
    (1.0 + legs.contact.restitution) * compression_impulse(legs, kind)
}

/// p_t that belongs to p_n at the end of an impact of this type, under any law.
pub(super) fn tangential_impulse(legs: &Legs, kind: ImpactType, normal: f64) -> f64 {
    use ImpactType as T;
    let mu = legs.contact.friction;
    match kind {
        T::SlidesThroughout => -legs.s * mu * normal,
        T::SlipsFromRest => mu * legs.b3.signum() * normal,
        T::ReversesInRestitution | T::ReversesInCompression => {
            legs.s * mu * (normal - 2.0 * legs.slip_stop())
        }
        T::SticksFromRest | T::StopsInRestitution | T::StopsInCompression => {
            product_plus(legs.b3, normal, -legs.contact.slip) / legs.b1
        }
    }
}
