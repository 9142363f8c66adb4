//! Several contacts: the staged impact.
//!
//! *Compression.* The drive is the present normal velocity: over the contacts with `u_n ≤ 0` the rate problem is solved with the drive
//! `(0, u_n)` and walked along to the next event: a slip stops, an open contact closes again, or no contact approaches any more.
//! With one closing contact this is Routh's walk, its touching contacts held by complementarity.
//!
//! *Restitution.* Contact i owes `eᵢ Pᵢ`, Pᵢ its normal impulse of compression; contacts that are open when compression ends owe
//! nothing. A clock loads every debtor at the rate `eᵢ Pᵢ`; contacts with `u_n = 0` may take more. Poisson's clock stops at 1,
//! Stronge's where the striking contact's work is used up, Newton's where its normal velocity is `−e` times that before (the latter two
//! only where one contact closes: for more they are not unique, and Poisson's is used).
//!
//! Where no hypothesis is consistent, the contact with `W_nn − sμW_nt < 0` becomes the clock until its slip stops: an impact without
//! approach (Painlevé's paradox). Contacts that drive each other in as well, so that none can be loaded alone, are loaded together, all at
//! the same rate.
//!
//! Two contacts may hand the load to each other infinitely often within a finite impulse, each time with a smaller slip: such a series
//! of stages is geometric, and is closed at its limit.
//!
//! Source: Routh 1860; Glocker and Pfeiffer 1995 for the complementarity of several contacts; the walk by stages for several contacts is
//! this project's own (`docs/notation.md` names its conventions).

#[cfg(doc)]
use super::share;
use super::share::Share;
use super::walk::Walk;
use crate::planar::contacts::names::ContactState;
use crate::planar::contacts::names::Slip;
use crate::planar::contacts::names::StageEnd;
use crate::planar::contacts::set::ContactSet;
use crate::{ImpactError, Law, Phase};

/// The outcome of an impact at several contacts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StagedOutcome<const N: usize> {
    /// Impulses (tangential, normal) on the body [N s].
    pub impulse: [[f64; 2]; N],
    /// Velocities (slip, normal) after [m/s].
    pub velocity: [[f64; 2]; N],
    /// Work of the tangential and of the normal impulse of each contact [J].
    pub work: [[f64; 2]; N],
    /// What each contact does at the end.
    pub state: [ContactState; N],
    /// The law that was used.
    pub law: Law,
    /// Largest number of consistent continuations met at a stage: above 1 the walk chose.
    pub branches: usize,
    /// Contacts whose impulse of compression is not determined: many values give the same motion in compression. Restitution multiplies
    /// the value that is taken, so that another [`Share`] may give another motion after the impact ([`share::outcomes`]).
    pub open_share: [bool; N],
    /// True where the total work is positive beyond rounding (possible under Newton's law).
    pub gained_energy: bool,
    /// Common factor on the coefficients of restitution that keeps energy from growing; 1 where none is needed.
    pub restitution_scaled: f64,
    /// True where friction, not approach, forced the impact.
    pub without_approach: bool,
    /// Smallest scaled slack of the hypotheses walked.
    pub margin: f64,
}

/// One contact at one instant of the walk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Station<const N: usize> {
    /// Velocities (slip, normal) [m/s].
    pub velocity: [[f64; 2]; N],
    /// Impulses (tangential, normal) so far [N s].
    pub impulse: [[f64; 2]; N],
}

/// One straight stage of the walk. Where stages accumulate, the last of them stands for the infinitely many that follow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stage<const N: usize> {
    /// Compression or restitution.
    pub phase: Phase,
    /// What each contact does.
    pub slip: [Slip; N],
    /// Where the stage starts.
    pub start: Station<N>,
    /// Where it ends.
    pub end: Station<N>,
    /// Why it ends.
    pub ended_by: StageEnd,
}

/// Resolves an impact at several contacts.
///
/// Nothing happens where no contact approaches, unless friction drives a touching contact in (Painlevé's paradox).
///
/// # Guarantees
/// No contact approaches after; normal impulses push and tangential ones stay within the cone; energy grows under Newton's law only.
///
/// # Errors
/// [`ImpactError::TooMany`] and [`ImpactError::OutsideDomain`] as [`ContactSet::check`]; [`ImpactError::Overflow`] where a result is not
/// finite; [`ImpactError::Jammed`] where no hypothesis is consistent and no slip is left to stop, or where the motion is lost in rounding;
/// [`ImpactError::Circling`] where the contacts pass the load around without end; [`ImpactError::Unending`] after a budget of stages.
///
/// # Limits
/// Rigid bodies. How several contacts that close together share the impact is a convention (they come to rest together), and so is how
/// fast each of them restitutes. Stronge's and Newton's laws are used where one contact closes; else the outcome's `law` says Poisson.
///
/// # Source
/// As the module.
///
/// # Example
/// A uniform rod of length 1 m and mass 1 kg turns about one end, which rests on a smooth floor, and falls flat with 6 rad/s: the
/// supports at its ends take `m ω l/6` and `m ω l/3`, and it stops.
/// ```
/// use carom_impact::{Law, planar::{ContactSet2, Touch, staged}};
/// use carom_num::Vec2;
/// let normal = Vec2::new(0.0, 1.0);
/// let end = |x| Touch { arm: Vec2::new(x, 0.0), normal, friction: 0.0, restitution: 0.0 };
/// let rod = ContactSet2::of_free_body(1.0, 1.0 / 12.0, Vec2::new(0.0, -3.0), -6.0, &[end(-0.5), end(0.5)])?;
/// let out = staged::resolve(&rod, Law::Poisson)?;
/// assert!((out.impulse[0][1] - 1.0).abs() < 1e-14 && (out.impulse[1][1] - 2.0).abs() < 1e-14);
/// assert_eq!(out.velocity, [[0.0, 0.0], [0.0, 0.0]]);
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
pub fn resolve<const N: usize, const M: usize>(
    set: &ContactSet<N, M>,
    law: Law,
) -> Result<StagedOutcome<N>, ImpactError> {
    resolve_as(set, law, Share::Middle)
}

/// As [`resolve`], with the share of compression that is asked for where it is open.
pub(super) fn resolve_as<const N: usize, const M: usize>(
    set: &ContactSet<N, M>,
    law: Law,
    share: Share,
) -> Result<StagedOutcome<N>, ImpactError> {
    set.check()?;
    let law = law_used(set, law);
    let mut walk = Walk::new(set);
    walk.share = share;
    walk.compress(&mut |_| {})?;
    let mut factor = 1.0;
    walk.restitute(law, factor, &mut |_| {})?;
    if walk.gained_energy() && law != Law::Newton {
        // Rare enough to walk through compression once more.
        walk = Walk::new(set);
        walk.share = share;
        walk.compress(&mut |_| {})?;
        factor = largest_harmless_factor(&walk, law)?;
        walk.restitute(law, factor, &mut |_| {})?;
    }
    walk.outcome(law, factor)
}

/// As [`resolve`]. Hands every stage to `observe`, in order; of an impact that is refused, the stages before that.
///
/// # Errors
/// As [`resolve`].
///
/// # Example
/// A box of 2 kg on both feet, e = 1/2: each takes 3 N s until it rests, and half of that after.
/// ```
/// use carom_impact::{Law, planar::{ContactSet2, Touch, staged}};
/// use carom_num::Vec2;
/// let normal = Vec2::new(0.0, 1.0);
/// let foot = |x| Touch { arm: Vec2::new(x, -1.0), normal, friction: 0.0, restitution: 0.5 };
/// let set = ContactSet2::of_free_body(2.0, 1.0, Vec2::new(0.0, -3.0), 0.0, &[foot(-1.0), foot(1.0)])?;
/// let mut impulses = vec![];
/// staged::resolve_observed(&set, Law::Poisson, &mut |stage| impulses.push(stage.end.impulse[0][1]))?;
/// assert!(impulses.len() == 2 && (impulses[0] - 3.0).abs() < 1e-14 && (impulses[1] - 4.5).abs() < 1e-14);
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
pub fn resolve_observed<const N: usize, const M: usize>(
    set: &ContactSet<N, M>,
    law: Law,
    observe: &mut impl FnMut(&Stage<N>),
) -> Result<StagedOutcome<N>, ImpactError> {
    // The factor on restitution is known only at the end: the walk that is shown is the second.
    let outcome = resolve(set, law);
    set.check()?;
    let (law, factor) = match &outcome {
        Ok(outcome) => (outcome.law, outcome.restitution_scaled),
        Err(_) => (law_used(set, law), 1.0),
    };
    let mut walk = Walk::new(set);
    walk.compress(observe).and_then(|()| walk.restitute(law, factor, observe)).and(outcome)
}

/// Stronge's and Newton's laws say what one closing contact does.
fn law_used<const N: usize, const M: usize>(set: &ContactSet<N, M>, law: Law) -> Law {
    let closing = set.normal[..set.count].iter().filter(|&&u| u < 0.0).count();
    if closing == 1 { law } else { Law::Poisson }
}

/// The largest common factor on the restitution under which no energy is gained.
fn largest_harmless_factor<const N: usize, const M: usize>(
    from: &Walk<'_, N, M>,
    law: Law,
) -> Result<f64, ImpactError> {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        let mut walk = from.clone();
        walk.restitute(law, middle, &mut |_| {})?;
        if walk.gained_energy() {
            high = middle;
        } else {
            low = middle;
        }
    }
    Ok(low)
}
