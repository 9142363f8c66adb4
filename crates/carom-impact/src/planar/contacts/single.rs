//! One contact: Routh's walk in impulse space.
//!
//! The normal impulse is the clock. While the contact slips, `dp_t = −μ sign(u_t) dp_n`; where the slip stops it sticks if
//! `|W_tn| ≤ μ W_tt`, else it slips on in the direction `sign(W_tn)`. Velocities are linear in the impulse, so the walk is a few
//! straight stages, each ended by a slip stop, the end of compression or the end of restitution.
//!
//! Source: Routh 1860; Wang and Mason, J. Appl. Mech. 59 (1992) 635; Stronge, J. Appl. Mech. 58 (1991) 1049.

mod walk;

use super::names::ContactState;
use super::names::ImpactType;
use super::names::Slip;
use super::names::StageEnd;
use crate::faults::{Faults, Quantity};
use crate::{ImpactError, Law, Phase};
use walk::{Compression, Walk};

/// One contact just before an impact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// `W_tt` [1/kg], > 0.
    pub w_tt: f64,
    /// `W_tn` [1/kg], with `W_tn² < W_tt W_nn`.
    pub w_tn: f64,
    /// `W_nn` [1/kg], > 0.
    pub w_nn: f64,
    /// Slip velocity `u_t` [m/s].
    pub slip: f64,
    /// Normal velocity `u_n` [m/s]; an approach is negative.
    pub normal: f64,
    /// Coulomb friction coefficient, ≥ 0.
    pub friction: f64,
    /// Coefficient of restitution, in [0, 1].
    pub restitution: f64,
}

impl Contact {
    /// Whether the contact is one of a rigid body.
    ///
    /// # Errors
    /// [`ImpactError::OutsideDomain`] names the first quantity that is not finite or violates `W_tt > 0`, `W_nn > 0`,
    /// `W_tt W_nn > W_tn²`, `μ ≥ 0` or `0 ≤ e ≤ 1`.
    ///
    /// # Example
    /// ```
    /// use carom_impact::planar::single::Contact;
    /// let contact = Contact {
    ///     w_tt: 1.0, w_tn: 2.0, w_nn: 1.0, slip: 0.0, normal: -1.0, friction: 0.3, restitution: 0.5,
    /// };
    /// assert!(contact.check().is_err(), "1 · 1 < 2²");
    /// assert_eq!(Contact { w_tn: 0.5, ..contact }.check(), Ok(()));
    /// ```
    #[inline]
    pub fn check(&self) -> Result<(), ImpactError> {
        let Self { w_tt, w_tn, w_nn, slip, normal, friction, restitution: e } = *self;
        // Zero times a number is zero only where the number is finite.
        let finite = (w_tt.abs() + w_nn.abs() + slip.abs() + normal.abs() + friction.abs()) * 0.0 == 0.0;
        let positive = w_tt > 0.0 && w_nn > 0.0 && w_tt * w_nn > w_tn * w_tn;
        if finite && positive && friction >= 0.0 && (0.0..=1.0).contains(&e) {
            Ok(())
        } else {
            self.complain()
        }
    }

    #[cold]
    fn complain(&self) -> Result<(), ImpactError> {
        let Self { w_tt, w_tn, w_nn, slip, normal, friction, restitution: e } = *self;
        let (at, mut faults) = (Some(0), Faults::NONE);
        faults.finite(at, Quantity::Wtt, w_tt);
        faults.finite(at, Quantity::Wtn, w_tn);
        faults.finite(at, Quantity::Wnn, w_nn);
        faults.finite(at, Quantity::Slip, slip);
        faults.finite(at, Quantity::NormalVelocity, normal);
        faults.finite(at, Quantity::Bound, friction);
        // What is not finite is named already.
        faults.check(w_tt > 0.0 || !w_tt.is_finite(), at, Quantity::OwnTangential, w_tt);
        faults.check(w_nn > 0.0 || !w_nn.is_finite(), at, Quantity::OwnNormal, w_nn);
        faults.check(friction >= 0.0 || !friction.is_finite(), at, Quantity::Friction, friction);
        faults.check((0.0..=1.0).contains(&e), at, Quantity::Restitution, e);
        let determinant = w_tt * w_nn - w_tn * w_tn;
        // It tells something only where its numbers do.
        let sound = w_tt > 0.0 && w_nn > 0.0 && w_tn.is_finite();
        faults.check(determinant > 0.0 || !sound, at, Quantity::Determinant, determinant);
        faults.refuse()?;
        // Each number is finite, but a sum of them is not.
        Err(ImpactError::Overflow)
    }
}

/// The outcome of an impact at one contact.
///
/// # Example
/// The work is the change of energy, here that of a ball of 1 kg that falls with 2 m/s and rises with 1 m/s.
/// ```
/// use carom_impact::{Law, planar::single};
/// let ball = single::Contact {
///     w_tt: 3.5, w_tn: 0.0, w_nn: 1.0, slip: 0.0, normal: -2.0, friction: 0.3, restitution: 0.5,
/// };
/// let out = single::resolve(&ball, Law::Poisson)?;
/// assert_eq!(out.normal_work + out.tangential_work, 0.5 * (1.0 - 4.0));
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// Normal impulse on the body [N s], ≥ 0.
    pub normal_impulse: f64,
    /// Tangential impulse on the body [N s].
    pub tangential_impulse: f64,
    /// Slip velocity after [m/s].
    pub slip: f64,
    /// Normal velocity after [m/s], ≥ 0.
    pub normal: f64,
    /// Work of the normal impulse [J].
    pub normal_work: f64,
    /// Work of the tangential impulse [J].
    pub tangential_work: f64,
    /// Type, `None` where nothing happens (no approach and no paradox).
    pub kind: Option<ImpactType>,
    /// What the contact does at the end.
    pub state: ContactState,
    /// True where the total work is positive (possible under Newton's law).
    pub gained_energy: bool,
    /// True where the contact did not approach: friction forced the impact (Painlevé's paradox).
    pub without_approach: bool,
    /// Smallest decided inequality of the walk (which of two events comes first, stick or slip) divided by the sum of its terms.
    pub margin: f64,
}

/// Position of the walk, handed to an observer at the end of each stage.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Station {
    /// Normal impulse so far [N s].
    pub normal_impulse: f64,
    /// Tangential impulse so far [N s].
    pub tangential_impulse: f64,
    /// Slip velocity [m/s].
    pub slip: f64,
    /// Normal velocity [m/s].
    pub normal: f64,
}

/// One straight stage of the walk.
///
/// # Example
/// Each stage starts where the one before has ended.
/// ```
/// use carom_impact::{Law, planar::single};
/// let ball = single::Contact {
///     w_tt: 3.5, w_tn: 0.0, w_nn: 1.0, slip: 1.0, normal: -2.0, friction: 0.3, restitution: 0.5,
/// };
/// let mut stages = vec![];
/// single::resolve_observed(&ball, Law::Poisson, &mut |stage| stages.push(*stage))?;
/// assert!(stages.len() == 3 && stages.windows(2).all(|pair| pair[0].end == pair[1].start));
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stage {
    /// Compression or restitution.
    pub phase: Phase,
    /// What the contact does.
    pub slip: Slip,
    /// Where the stage starts.
    pub start: Station,
    /// Where it ends.
    pub end: Station,
    /// Why it ends.
    pub ended_by: StageEnd,
}

/// Resolves an impact at one contact.
///
/// ```text
/// u⁺ = u⁻ + W p;   while it slips dp_t = −μ sign(u_t) dp_n;   stopped, it sticks with dp_t = −(W_tn/W_tt) dp_n if |W_tn| ≤ μ W_tt
/// ```
///
/// Nothing happens where `u_n ≥ 0`, unless `u_n = 0` and `W_nn − sμW_tn < 0`: then friction drives the contact into the obstacle
/// and the impact without approach is resolved (its slip must stop first).
///
/// # Errors
/// [`ImpactError::OutsideDomain`] as [`Contact::check`]; [`ImpactError::Overflow`] where a result is not finite.
///
/// # Limits
/// Rigid bodies, dry friction with one coefficient. Under Newton's law energy can grow where the slip stops or reverses.
///
/// # Source
/// Routh 1860; Wang and Mason, J. Appl. Mech. 59 (1992) 635; Stronge, Proc. R. Soc. A 431 (1990) 169.
///
/// # Example
/// ```
/// use carom_impact::{Law, planar::{ImpactType, single}};
/// // A ball of 1 kg dropped straight on a floor: it leaves at e times its approach speed.
/// let ball = single::Contact { w_tt: 3.5, w_tn: 0.0, w_nn: 1.0, slip: 0.0, normal: -2.0, friction: 0.3, restitution: 0.5 };
/// let out = single::resolve(&ball, Law::Poisson)?;
/// assert_eq!((out.normal, out.normal_impulse), (1.0, 3.0));
/// assert_eq!(out.kind, Some(ImpactType::SticksFromRest));
/// // Thrown with a slip of 7 m/s it slips throughout and loses μ · W_tt · 3 N s of it.
/// let out = single::resolve(&single::Contact { slip: 7.0, ..ball }, Law::Poisson)?;
/// assert!((out.slip - (7.0 - 0.3 * 3.5 * 3.0)).abs() < 1e-15);
/// assert_eq!(out.kind, Some(ImpactType::SlidesThroughout));
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
pub fn resolve(contact: &Contact, law: Law) -> Result<Outcome, ImpactError> {
    resolve_observed(contact, law, &mut |_: &Stage| {})
}

/// As [`resolve`], handing every stage to `observe` in order.
///
/// # Errors
/// As [`resolve`].
///
/// # Example
/// Poisson's law: of 3 N s a third belongs to restitution, where e = 1/2.
/// ```
/// use carom_impact::{Law, planar::single};
/// let ball = single::Contact {
///     w_tt: 3.5, w_tn: 0.0, w_nn: 1.0, slip: 0.0, normal: -2.0, friction: 0.3, restitution: 0.5,
/// };
/// let mut impulses = vec![];
/// single::resolve_observed(&ball, Law::Poisson, &mut |stage| impulses.push(stage.end.normal_impulse))?;
/// assert_eq!(impulses, [2.0, 3.0]);
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
pub fn resolve_observed(
    contact: &Contact,
    law: Law,
    observe: &mut impl FnMut(&Stage),
) -> Result<Outcome, ImpactError> {
    contact.check()?;
    let mut walk = Walk::new(contact);
    if contact.normal > 0.0 || (contact.normal == 0.0 && walk.rates().normal >= 0.0) {
        return Ok(walk.outcome(None, false));
    }
    walk.compress(observe);
    let stopped_in_compression = walk.stopped;
    let compression = Compression { impulse: walk.now.normal_impulse, work: walk.normal_work };
    walk.restitute(law, &compression, observe);
    let sticks = walk.slip == Slip::Sticks;
    let kind = match (walk.from_rest, stopped_in_compression, walk.stopped) {
        (true, _, _) if sticks => ImpactType::SticksFromRest,
        (true, _, _) => ImpactType::SlipsFromRest,
        (_, true, _) if sticks => ImpactType::StopsInCompression,
        (_, true, _) => ImpactType::ReversesInCompression,
        (_, _, true) if sticks => ImpactType::StopsInRestitution,
        (_, _, true) => ImpactType::ReversesInRestitution,
        _ => ImpactType::SlidesThroughout,
    };
    let out = walk.outcome(Some(kind), contact.normal == 0.0);
    let sum = out.slip + out.normal + out.normal_impulse + out.tangential_impulse;
    if (sum + walk.work_terms).is_finite() { Ok(out) } else { Err(ImpactError::Overflow) }
}
