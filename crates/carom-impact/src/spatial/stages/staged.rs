//! Several contacts in space: the staged impact.
//!
//! *Compression.* The drive is the present normal velocity: over the contacts with `u_n ≤ 0` the rate problem is solved with the drive `(0, 0, u_n)`
//! and followed to the next event, with friction against every slip as it turns. With one contact this is Routh's walk; several closing contacts come
//! to rest together, each loaded as its own approach demands.
//!
//! *Restitution.* Contact i owes what its law says of its compression; a contact that is open when compression ends owes nothing. A clock loads every
//! debtor at the rate `eᵢ Pᵢ`, Pᵢ its impulse of compression; contacts with `u_n = 0` may take more. Poisson's clock stops at 1; by Stronge's law
//! every contact stops for itself, where its normal impulse has returned `eᵢ²` of its work; by Newton's, used where one contact closes, where its
//! normal velocity is `−e` times that before. If the walk would gain energy, all restitutions are scaled by the largest common factor that prevents
//! it.
//!
//! Where no hypothesis is consistent, the contact that friction drives in becomes the clock until its slip stops (Painlevé's paradox).
//!
//! # Source
//! Routh 1860 and Keller 1986 for one contact; Glocker and Pfeiffer 1995 for the complementarity of several; the walk is that of
//! [`planar::staged`](crate::planar::staged), with slips that turn.

use super::leg::StageEvent;
use super::walk::Walk;
use crate::Load;
use crate::spatial::contacts::set::ContactSet;
use crate::spatial::ends::non_sliding::Conclusion;
use crate::spatial::rates::answer::{Freedom, Mode, Preference};
use crate::spatial::rates::rate::RateProblem;
use crate::{ImpactError, Law, Phase};
use carom_num::Vec3;

/// Several contacts at one instant of the walk, each in its own frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Station<const N: usize> {
    /// Velocities [m/s].
    pub velocity: [Vec3; N],
    /// Impulses so far [N s].
    pub impulse: [Vec3; N],
}

/// Why a stage is walked as it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ground {
    /// A hypothesis is consistent.
    Consistent,
    /// Friction drives this contact in (Painlevé's paradox): no hypothesis is consistent, or none along the slips as they are ends the approach, and it is the
    /// clock until a slip stops, with those that are like it, or with those that it drives in and that drive it in.
    DrivenIn(usize),
    /// No hypothesis is consistent, though friction drives no contact in by itself: the one that approaches fastest is loaded first.
    FastestFirst(usize),
}

/// One stage of the walk: contacts do the same from its start to its end, though slips may turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stage<const N: usize> {
    /// Compression or restitution.
    pub phase: Phase,
    /// What each contact does.
    pub mode: [Mode; N],
    /// Where the stage starts.
    pub start: Station<N>,
    /// Where it ends.
    pub end: Station<N>,
    /// Why it ends.
    pub ended_by: StageEvent,
    /// No slip turns in it.
    pub straight: bool,
    /// Drive of the rate problem at its start ([`Stage::question`]).
    pub drive: [Vec3; N],
    /// How each contact takes part in that problem.
    pub load: [Load; N],
    /// The contacts that are loaded whatever their normal velocities do, the one that [`Ground`] names and those that are like it; none where a hypothesis is consistent.
    pub clocks: [bool; N],
    /// Why it is walked. Unless this is [`Ground::Consistent`], the rate problem at its start has no consistent hypothesis.
    pub ground: Ground,
}

impl<const N: usize> Stage<N> {
    /// The rate problem at its start: what else could have happened there.
    pub fn question<'a>(&self, set: &'a ContactSet<N>) -> RateProblem<'a, N> {
        RateProblem {
            count: set.count,
            operator: &set.operator,
            friction: &set.friction,
            drive: self.drive,
            slip: self.start.velocity.map(|v| [v.x, v.y]),
            load: self.load,
        }
    }
}

/// The outcome of an impact at several contacts in space.
///
/// # Example
/// A ball of 1 kg that slips fast: 3 N s along the normal, of which friction is a tenth, against the slip.
/// ```
/// use carom_impact::{Law, spatial::{ContactSet, RigidBody, Touch, staged}};
/// use carom_num::{Mat3, Vec3};
/// let inertia = Mat3::diagonal(0.4, 0.4, 0.4);
/// let ball = RigidBody { mass: 1.0, inertia, velocity: Vec3::new(3.0, 4.0, -2.0), spin: Vec3::ZERO };
/// let touch = Touch { arm: -Vec3::Z, normal: Vec3::Z, friction: 0.1, restitution: 0.5 };
/// let out = staged::resolve(&ContactSet::<1>::of_free_body(&ball, &[touch])?, Law::Poisson)?;
/// assert!((out.impulse[0] - Vec3::new(-0.18, -0.24, 3.0)).norm() < 1e-14);
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StagedOutcome<const N: usize> {
    /// Impulses on the bodies that the normals point into, in the contacts' frames [N s].
    pub impulse: [Vec3; N],
    /// Velocities after, in the contacts' frames [m/s].
    pub velocity: [Vec3; N],
    /// Work of the tangential and of the normal impulse of each contact [J].
    pub work: [[f64; 2]; N],
    /// The law that was used.
    pub law: Law,
    /// Largest number of consistent continuations met: above 1 the walk chose. Each question is widened only until it has an answer
    /// ([`RateProblem::solve_first`](crate::spatial::rates::rate::RateProblem::solve_first)).
    pub branches: usize,
    /// False where other continuations may exist: several contacts at rest could have started to slip. See [`Answer::examined`](crate::spatial::rates::answer::Answer::examined).
    pub examined: bool,
    /// The largest freedom of any stage. Above [`Freedom::Rates`] the motion depends on how contacts share the load; they
    /// shared it as equal springs do.
    pub freedom: Freedom,
    /// True where the total work is positive beyond rounding (possible under Newton's law).
    pub gained_energy: bool,
    /// Common factor on the coefficients of restitution that keeps energy from growing; 1 where none is needed.
    pub restitution_scaled: f64,
    /// True where friction, not approach, forced the impact.
    pub without_approach: bool,
    /// Stages without a consistent hypothesis: above 0 the laws alone do not say what happens.
    pub forced: usize,
    /// Smallest scaled slack of the hypotheses at the start of stages.
    pub margin: f64,
    /// Stages walked.
    pub stages: usize,
}

impl<const N: usize> StagedOutcome<N> {
    /// Work of all impulses [J]: what the kinetic energy has changed by.
    pub fn total_work(&self) -> f64 {
        self.work.iter().flatten().sum()
    }

    /// How many motions the law allows. They are several also where contacts may share what they carry in more than one way, and the motion depends on it.
    ///
    /// # Example
    /// A table on four feet, of which one has less friction, falls flat while it slides and spins.
    /// ```
    /// use carom_impact::{Law, spatial::{Conclusion, ContactSet, RigidBody, Touch, staged}};
    /// use carom_num::{Mat3, Vec3};
    /// let (velocity, spin) = (Vec3::new(1.0, 0.5, -1.0), Vec3::Z * 2.0);
    /// let body = RigidBody { mass: 1.0, inertia: Mat3::diagonal(0.2, 0.3, 0.4), velocity, spin };
    /// let touch = |x: f64, y: f64, friction| {
    ///     Touch { arm: Vec3::new(x, y, -0.3), normal: Vec3::Z, friction, restitution: 0.0 }
    /// };
    /// let feet = [touch(0.5, 0.4, 0.1), touch(-0.5, 0.4, 0.3), touch(-0.5, -0.4, 0.3), touch(0.5, -0.4, 0.3)];
    /// let of = |feet: &[Touch]| {
    ///     let set = ContactSet::<4>::of_free_body(&body, feet)?;
    ///     Ok::<_, carom_impact::ImpactError>(staged::resolve(&set, Law::Poisson)?.conclusion())
    /// };
    /// assert_eq!(of(&feet)?, Conclusion::Several);
    /// assert_eq!(of(&feet[..3])?, Conclusion::Unique, "three feet share a load in one way");
    /// # Ok::<(), carom_impact::ImpactError>(())
    /// ```
    pub fn conclusion(&self) -> Conclusion {
        match (self.branches > 1 || self.freedom == Freedom::Motion, self.forced) {
            (true, _) => Conclusion::Several,
            (_, 0) => Conclusion::Unique,
            _ => Conclusion::Forced,
        }
    }

    /// The least friction coefficient, the same for all contacts, in whose cones the impulses of the outcome lie: the largest quotient of tangential
    /// and normal impulse.
    ///
    /// It is at most the friction that the impact was walked with, and equals it where a contact slipped straight all the way.
    pub fn friction_demand(&self) -> f64 {
        crate::spatial::ends::non_sliding::demand(&self.impulse)
    }
}

/// Halvings of the factor on restitution.
const MOST_HALVINGS: u32 = 40;

/// Resolves an impact at several contacts in space.
///
/// Nothing happens where no contact approaches, unless friction drives a touching contact in (Painlevé's paradox).
///
/// # Guarantees
/// No contact approaches after; normal impulses push and tangential ones stay within the cone; energy grows under Newton's law only.
///
/// # Errors
/// [`ImpactError::TooMany`] above [`MOST_EXAMINED`](crate::spatial::MOST_EXAMINED) contacts; [`ImpactError::OutsideDomain`] with the first quantity that no contact has;
/// [`ImpactError::Overflow`] where a result is not finite; [`ImpactError::Jammed`] where no hypothesis is consistent and no slip is left to
/// stop, where the motion is lost in rounding, or where the impulses do not account for the change of the velocities;
/// [`ImpactError::Unending`] after a budget of stages.
///
/// # Limits
/// Rigid bodies. How contacts that close together share the impact is a convention, and so is how fast each of them restitutes. Where more contacts
/// hold than a body has freedoms, they share as equal springs do (`freedom` says so). A slip that starts smoothly, at a contact that comes to
/// the edge of its cone while others turn, is followed to about 1e-8. Contacts with normals far apart and friction above 1 may hold each other, or
/// hand the load to each other without end: then the walk is refused. On one plane an impact of six contacts that all
/// start to slip takes some hundredths of a second, of sixteen about one, at worst tens of seconds; on two
/// planes eight take a tenth of a second, and sixteen two.
///
/// # Example
/// A rod of 1 kg and 1 m falls flat on two supports at its ends with 1 m/s while it spins about the vertical with 3 rad/s. Both ends slip with 1.5
/// m/s, across the rod and against each other. The supports take 1/2 N s each, and their friction brakes the spin by `μ (1/2 + 1/2) (1/2) / J = 6 μ`:
/// it stops from μ = 1/2 on.
/// ```
/// use carom_impact::Law;
/// use carom_impact::spatial::{ContactSet, RigidBody, Touch, staged};
/// use carom_num::{Mat3, Vec3};
/// let inertia = Mat3::diagonal(1e-4, 1.0 / 12.0, 1.0 / 12.0);
/// let rod = RigidBody { mass: 1.0, inertia, velocity: -Vec3::Z, spin: Vec3::Z * 3.0 };
/// let end = |x: f64, friction| Touch { arm: Vec3::X * x, normal: Vec3::Z, friction, restitution: 0.0 };
/// let spin_after = |friction: f64| {
///     let set = ContactSet::<2>::of_free_body(&rod, &[end(-0.5, friction), end(0.5, friction)])?;
///     let out = staged::resolve(&set, Law::Poisson)?;
///     let pushed = |body: RigidBody, (arm, i): (f64, usize)| body.pushed(Vec3::X * arm, set.frame[i].transposed() * out.impulse[i]);
///     let after = pushed(rod, (-0.5, 0)).and_then(|body| pushed(body, (0.5, 1)));
///     Ok::<_, carom_impact::ImpactError>(after.map_or(f64::NAN, |body| body.spin.z))
/// };
/// assert!((spin_after(0.2)? - 1.8).abs() < 1e-12);
/// assert!(spin_after(0.6)?.abs() < 1e-12);
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
pub fn resolve<const N: usize>(set: &ContactSet<N>, law: Law) -> Result<StagedOutcome<N>, ImpactError> {
    resolve_preferring(set, law, Preference::default())
}

/// As [`resolve`], but where several hypotheses are consistent, `preference` chooses.
///
/// # Errors
/// As [`resolve`].
pub fn resolve_preferring<const N: usize>(
    set: &ContactSet<N>,
    law: Law,
    preference: Preference,
) -> Result<StagedOutcome<N>, ImpactError> {
    walked(set, law, preference, &mut vec![])
}

/// Walks, and keeps every stage.
fn walked<const N: usize>(
    set: &ContactSet<N>,
    law: Law,
    preference: Preference,
    stages: &mut Vec<Stage<N>>,
) -> Result<StagedOutcome<N>, ImpactError> {
    set.check()?;
    let law = law_used(set, law);
    let mut compressed = Walk::new(set, preference);
    compressed.compress(&mut |stage| stages.push(*stage))?;
    let (mut walk, mut factor, compression) = (compressed, 1.0, stages.len());
    walk.restitute(law, factor, &mut |stage| stages.push(*stage))?;
    if walk.gained_energy() && law != Law::Newton {
        // Only now the factor on restitution is known: the walk that counts is the second.
        factor = largest_harmless_factor(&compressed, law)?;
        walk = compressed;
        stages.truncate(compression);
        walk.restitute(law, factor, &mut |stage| stages.push(*stage))?;
    }
    walk.outcome(law, factor)
}

/// As [`resolve_preferring`], handing every stage to `observe` in order.
///
/// # Errors
/// As [`resolve`].
///
/// # Example
/// The last stage ends where the outcome says.
/// ```
/// use carom_impact::{Law, spatial::{ContactSet, Preference, RigidBody, Touch, staged}};
/// use carom_num::{Mat3, Vec3};
/// let inertia = Mat3::diagonal(0.4, 0.4, 0.4);
/// let ball = RigidBody { mass: 1.0, inertia, velocity: Vec3::new(0.7, 0.0, -2.0), spin: Vec3::ZERO };
/// let touch = Touch { arm: -Vec3::Z, normal: Vec3::Z, friction: 0.3, restitution: 0.5 };
/// let set = ContactSet::<1>::of_free_body(&ball, &[touch])?;
/// let mut ends = vec![];
/// let out = staged::resolve_observed(&set, Law::Poisson, Preference::MostOpen, &mut |s| ends.push(s.end))?;
/// assert_eq!((ends.len(), ends.last().map(|end| end.impulse)), (out.stages, Some(out.impulse)));
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
pub fn resolve_observed<const N: usize>(
    set: &ContactSet<N>,
    law: Law,
    preference: Preference,
    observe: &mut impl FnMut(&Stage<N>),
) -> Result<StagedOutcome<N>, ImpactError> {
    let mut stages = vec![];
    let outcome = walked(set, law, preference, &mut stages)?;
    stages.iter().for_each(observe);
    Ok(outcome)
}

/// Newton's law says what one closing contact does.
fn law_used<const N: usize>(set: &ContactSet<N>, law: Law) -> Law {
    let closing = set.velocity[..set.count].iter().filter(|u| u.z < 0.0).count();
    if law == Law::Newton && closing != 1 { Law::Poisson } else { law }
}

/// The largest common factor on the restitution under which no energy is gained.
fn largest_harmless_factor<const N: usize>(from: &Walk<'_, N>, law: Law) -> Result<f64, ImpactError> {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..MOST_HALVINGS {
        let middle = 0.5 * (low + high);
        let mut walk = *from;
        walk.restitute(law, middle, &mut |_| {})?;
        if walk.gained_energy() { high = middle } else { low = middle }
    }
    Ok(low)
}
