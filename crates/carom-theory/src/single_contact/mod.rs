//! One contact, planar, with Coulomb friction: every class of impact in closed form, for three laws of restitution.
//!
//! ```text
//! u⁺ = u⁻ + W p,   u = (u_t, u_n),  p = (p_t, p_n),   S₀ = u_t⁻ (slip),  C₀ = u_n⁻ (approach, < 0)
//! ```
//!
//! With Routh's clock p_n the impact is a broken line of at most two legs. On the first the contact slips in its initial direction
//! `s = sign S₀`; the slip stops at `p_s`; on the second it sticks, or slips the other way. With `B₁ = W_tt`, `B₂ = W_nn`,
//! `B₃ = −W_tn`, each quantity is linear on each leg:
//!
//! ```text
//! first leg     d|u_t|/dp_n = −k,  k  = μB₁ + sB₃            p_s = |S₀|/k  (if k > 0)
//!               du_n/dp_n   =  a₁ = B₂ + sμB₃
//! second leg    du_n/dp_n   =  a₂ = (B₁B₂ − B₃²)/B₁ (sticks, μ ≥ |μ_s|)   or   B₂ − sμB₃ (slips back, μ < |μ_s|)
//! ```
//!
//! where `μ_s = −B₃/B₁`. The second leg always closes (`a₂ > 0`), the first need not: `a₁ ≤ 0` is Painlevé's case, possible only
//! with `k > 0`, so that the slip stops first and the impact is of class C-sticking even without approach.
//!
//! # The class does not depend on the law
//!
//! | type | class | condition |
//! |---|---|---|
//! | 1 | sliding | P_d ≥ (1+e) P_q |
//! | 2, 3 | slides / sticks from rest | S₀ = 0, μ < / ≥ \|μ_s\| |
//! | 4, 6 | R-reversed / R-sticking | P_q ≤ P_d < (1+e) P_q, μ < / ≥ \|μ_s\| |
//! | 5, 7 | C-reversed / C-sticking | P_d < P_q, μ < / ≥ \|μ_s\| |
//!
//! with `P_d = (B₂ + sμB₃)|S₀| = a₁|S₀|` and `P_q = (μB₁ + sB₃)|C₀| = k|C₀|`. Wang and Mason derive this for Poisson's law. It
//! holds for all three laws here with the same e: whether the slip stops in compression is asked before any restitution, and as
//! long as the first leg lasts the three laws end it at the same point, `p_n = (1+e)|C₀|/a₁`. With Stronge's law the work
//! returned when the slip stops in restitution is `C_s²/(2a₁)`, `C_s = C₀ + a₁p_s`, and the budget is `e²C₀²/(2a₁)`: it lasts
//! beyond the slip stop exactly if `C_s < e|C₀|`, which is `P_d < (1+e)P_q` again. Newton's law asks `C_s < e|C₀|` directly.
//! The impulses of types 1, 2 and 3 are therefore the same under the three laws; those of types 4 to 7 differ.
//!
//! # Accuracy, and how to compare
//!
//! Every denominator (k, a₁, a₂ and B₁B₂ − B₃²) and every numerator that can cancel is formed with fused operations, so the
//! impulses of types 1, 2, 3, 5 and 7 are right to a few units in the last place *for the numbers given*. Types 4 and 6 lose up to
//! a factor a₁/a₂: the rounding of the slip stop, seen on a second leg that closes more slowly. Against a walk with twice the
//! digits, 4·10⁵ free bodies of m r²/J up to 2000 leave a residual below 2·10⁻¹³ under each law, 1.5·10⁵ of them
//! placed at a relative distance of 10⁻¹ to 10⁻¹⁶ from a class boundary.
//!
//! What no formula can do is repair the numbers given: near Painlevé (a₁ → 0, types 1, 4, 6), near a slip that is not braked
//! (k → 0) and near a singular operator (B₁B₂ → B₃²) a rounding of the data moves the result by [`Numbers::condition`] times as
//! much. Compare the impulses of another program by `|Δp_n| ≤ tolerance · condition · p_n` and `|Δp_t| ≤ tolerance · condition ·
//! max(1, μ) p_n` (p_t itself may vanish), and velocities by the sum of the magnitudes of their terms
//! ([`Impact::velocity_scale`]) times the same factor.
//!
//! Impulses are continuous across every class boundary but one (a vanishing approach at a₁ = 0); types are not: compare types only
//! where [`Numbers::margin`] exceeds `condition ×` rounding. On the very boundary of type 1 the condition that counts is the one
//! of the type beyond it.
//!
//! # Source
//!
//! Routh, *Dynamics of a System of Rigid Bodies* (1860); Plavnieks (1969), the seven types; Wang and Mason, J. Appl. Mech. 59
//! (1992) 635, the classes and Poisson's closed forms; Stronge, Proc. R. Soc. A 431 (1990) 169. The closed forms for Stronge's
//! and Newton's laws, and the statement on the classes, are derived here.

mod classify;
mod contact;
mod ledger;
mod newton;
mod poisson;
mod stronge;

pub use classify::{Inequality, Numbers};
pub use contact::{Contact, Impact, ImpactType, Law, Operator, Work};

use crate::OutsideDomain;
use crate::domain::require_finite;
use classify::Legs;

/// The impact of one contact under one law: impulses, velocities after, works and the numbers that classify it.
///
/// An open or grazing contact transmits nothing (`kind = None`), unless it grazes in Painlevé's case.
///
/// # Errors
///
/// [`OutsideDomain`] unless W_tt > 0, W_nn > 0, W_tt W_nn > W_tn², μ ≥ 0, 0 ≤ e ≤ 1 and all numbers are finite, also those of the result.
///
/// # Limits
///
/// Products of three data must neither overflow (an error) nor vanish: keep their magnitudes within 10⁻⁷⁰ to 10⁷⁰.
///
/// # Example
///
/// A particle (W = 1) thrown at 45° with μ = 0.25, e = 0.5 slides throughout: p_n = (1+e)·1, p_t = −μ p_n.
///
/// ```
/// use carom_theory::single_contact::{Contact, Law, Operator, resolve};
/// let w = Operator { tt: 1.0, tn: 0.0, nn: 1.0 };
/// let thrown = Contact { w, slip: 1.0, approach: -1.0, friction: 0.25, restitution: 0.5 };
/// let impact = resolve(&thrown, Law::Poisson)?;
/// assert_eq!((impact.tangential_impulse, impact.normal_impulse), (-0.375, 1.5));
/// assert_eq!(impact.kind.map(|k| k.number()), Some(1));
/// # Ok::<(), carom_theory::OutsideDomain>(())
/// ```
pub fn resolve(contact: &Contact, law: Law) -> Result<Impact, OutsideDomain> {
    contact.check()?;
    let legs = Legs::of(contact);
    let numbers = legs.numbers();
    let Some(kind) = numbers.kind else {
        return Ok(ledger::nothing(contact, law, numbers));
    };
    let compression = poisson::compression_impulse(&legs, kind);
    let normal = match law {
        Law::Poisson => poisson::normal_impulse(&legs, kind),
        Law::Stronge => stronge::normal_impulse(&legs, kind),
        Law::Newton => newton::normal_impulse(&legs, kind),
    };
    let impact = ledger::close(&legs, law, numbers, compression, normal);
    require_finite("normal impulse", impact.normal_impulse)?;
    require_finite("tangential impulse", impact.tangential_impulse)?;
    require_finite("energy change", impact.work.energy_change())?;
    Ok(impact)
}
