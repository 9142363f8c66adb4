//! How contacts that close together share an impact: conventions that rigid bodies leave open.
//!
//! - *Together* ([`staged::resolve`]): all closing contacts come to rest at once, each loaded as its own approach demands.
//! - *In sequence* ([`in_sequence`]): one after another, the fastest approach first, each as if the others were not there.
//! - *By stiffness* ([`by_stiffness`]): springs of given stiffness ratios, in the limit of stiff ones.
//! - *Every* ([`every`]): loads in any proportion that may change at every event; a sample of the reachable outcomes.
//!
//! A single closing contact has nothing to share: all conventions agree, except that a sequence may strike contacts that only touch.
//!
//! Sources: Liu, Zhao and Brogliato, Proc. R. Soc. A 464 (2008) 3193, without friction (by stiffness); Halm and Posa, "Modeling and
//! analysis of non-unique behaviors in multiple frictional impacts", arXiv:1902.01462 (every).

#[cfg(test)]
mod tests;

use super::stage::{Step, change};
use super::staged::{self, StagedOutcome};
use super::stiffness::by_stiffness;
use super::walk::Walk;
use crate::Load;
use crate::planar::contacts::names::ContactState;
use crate::planar::contacts::names::StageEnd;
use crate::planar::contacts::set::ContactSet;
use crate::planar::contacts::single;
use crate::tolerance::{ADDED_ROUNDING, LEAST_SHARE, OTHER_OUTCOME, SEQUENCE_OVER, WEDGED_STILL};
use crate::{ImpactError, Law, Phase};

/// A convention on sharing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Sharing<const N: usize> {
    /// All come to rest at once.
    #[default]
    Together,
    /// One after another, the fastest approach first.
    InSequence,
    /// As springs `F = k δ^exponent`.
    ByStiffness {
        /// Stiffness of each contact; only the ratios count.
        stiffness: [f64; N],
        /// 1: linear; 1.5: Hertz.
        exponent: f64,
    },
}

/// Resolves an impact under a convention on sharing.
///
/// # Errors
/// As [`staged::resolve`], [`in_sequence`] and [`by_stiffness`].
///
/// # Example
/// By whatever convention, three elastic balls keep the energy: with the impulses p and q their velocities
/// are 1 − p, p − q and q.
/// ```
/// use carom_impact::{Law, planar::{Block, ContactSet, sharing::{Sharing, self}}};
/// let cell = |nn| Block { tt: 1.0, tn: 0.0, nt: 0.0, nn };
/// let cradle = ContactSet::<2, 4> {
///     count: 2, operator: [[cell(2.0), cell(-1.0)], [cell(-1.0), cell(2.0)]],
///     slip: [0.0; 2], normal: [-1.0, 0.0], friction: [0.0; 2], restitution: [1.0; 2],
/// };
/// let springs = Sharing::ByStiffness { stiffness: [1.0; 2], exponent: 1.5 };
/// for how in [Sharing::Together, Sharing::InSequence, springs] {
///     let [[_, p], [_, q]] = sharing::resolve(&cradle, Law::Poisson, &how)?.impulse;
///     // Springs are followed to about 1e-9.
///     assert!(((1.0 - p).powi(2) + (p - q).powi(2) + q * q - 1.0).abs() < 1e-8);
/// }
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
pub fn resolve<const N: usize, const M: usize>(
    set: &ContactSet<N, M>,
    law: Law,
    sharing: &Sharing<N>,
) -> Result<StagedOutcome<N>, ImpactError> {
    match sharing {
        Sharing::Together => staged::resolve(set, law),
        Sharing::InSequence => in_sequence(set, law),
        Sharing::ByStiffness { stiffness, exponent } => by_stiffness(set, stiffness, *exponent),
    }
}

/// Impacts after which a sequence is given up.
const MOST_IMPACTS: usize = 1 << 20;

/// One contact after another, the fastest approach first, each struck as if the others were not there, until none approaches.
///
/// The outcome's `branches` counts contacts that were equally fast at some instant: their order is then arbitrary.
///
/// # Errors
/// As [`staged::resolve`]; [`ImpactError::Unending`] where the sequence does not come to rest within its budget.
///
/// # Example
/// Newton's cradle of three: the first ball stops, the last leaves with its velocity.
/// ```
/// use carom_impact::{Law, planar::{Block, ContactSet, sharing}};
/// let cell = |nn| Block { tt: 1.0, tn: 0.0, nt: 0.0, nn };
/// let cradle = ContactSet::<2, 4> {
///     count: 2,
///     operator: [[cell(2.0), cell(-1.0)], [cell(-1.0), cell(2.0)]],
///     slip: [0.0; 2],
///     normal: [-1.0, 0.0],
///     friction: [0.0; 2],
///     restitution: [1.0; 2],
/// };
/// let out = sharing::in_sequence(&cradle, Law::Poisson)?;
/// assert_eq!([out.impulse[0][1], out.impulse[1][1]], [1.0, 1.0]);
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
pub fn in_sequence<const N: usize, const M: usize>(
    set: &ContactSet<N, M>,
    law: Law,
) -> Result<StagedOutcome<N>, ImpactError> {
    set.check()?;
    let mut out = untouched(set, law);
    let fastest = out.velocity.iter().flatten().fold(0.0, |m: f64, u| m.max(u.abs()));
    // Magnitudes of all that was added to a velocity: what its rounding is measured against.
    let mut added = 0.0;
    for _ in 0..MOST_IMPACTS {
        let Some(i) = fastest_approach(&out, set.count, SEQUENCE_OVER * fastest) else {
            // What is left below the rounding of the impulses is at rest.
            let still = (SEQUENCE_OVER * fastest).max(ADDED_ROUNDING * added);
            for u in out.velocity[..set.count].iter_mut().flatten().filter(|u| u.abs() <= still) {
                *u = 0.0;
            }
            settle_states(&mut out, set.count);
            return Ok(out);
        };
        let approach = out.velocity[i][1];
        let ties =
            (0..set.count).filter(|&j| (out.velocity[j][1] - approach).abs() <= SEQUENCE_OVER * fastest);
        out.branches = out.branches.max(ties.count());
        let [slip, normal] = out.velocity[i];
        let one = single::resolve(&single::Contact { slip, normal, ..set.alone(i) }, law)?;
        let (q, p) = (one.tangential_impulse, one.normal_impulse);
        for j in 0..set.count {
            let b = &set.operator[j][i];
            out.velocity[j][0] += b.tt * q + b.tn * p;
            out.velocity[j][1] += b.nt * q + b.nn * p;
            added += (b.tt * q).abs() + (b.tn * p).abs() + (b.nt * q).abs() + (b.nn * p).abs();
        }
        out.velocity[i] = [one.slip, one.normal];
        out.impulse[i][0] += q;
        out.impulse[i][1] += p;
        out.work[i][0] += one.tangential_work;
        out.work[i][1] += one.normal_work;
        out.gained_energy |= one.gained_energy;
        out.margin = out.margin.min(one.margin);
    }
    Err(ImpactError::Unending { stages: MOST_IMPACTS })
}

fn fastest_approach<const N: usize>(out: &StagedOutcome<N>, count: usize, over: f64) -> Option<usize> {
    let normal = |i: usize| out.velocity[i][1];
    (0..count).filter(|&i| normal(i) < -over).min_by(|&i, &j| normal(i).total_cmp(&normal(j)))
}

/// The outcome of an impact that has not begun.
pub(super) fn untouched<const N: usize, const M: usize>(
    set: &ContactSet<N, M>,
    law: Law,
) -> StagedOutcome<N> {
    StagedOutcome {
        impulse: [[0.0; 2]; N],
        velocity: std::array::from_fn(|i| [set.slip[i], set.normal[i]]),
        work: [[0.0; 2]; N],
        state: [ContactState::Separates; N],
        law,
        branches: 1,
        open_share: [false; N],
        gained_energy: false,
        restitution_scaled: 1.0,
        without_approach: false,
        margin: f64::INFINITY,
    }
}

/// Reads each contact's state from its velocities.
pub(super) fn settle_states<const N: usize>(out: &mut StagedOutcome<N>, count: usize) {
    for i in 0..count {
        out.state[i] = ContactState::of(out.velocity[i]);
    }
}

/// A sample of the outcomes that can be reached if the closing contacts are loaded in any proportion. At every event of compression new
/// proportions are drawn; restitution is Poisson's.
///
/// The first samples load one contact at a time, in every order by rotation, and all alike; the rest follow a fixed low-discrepancy
/// sequence, so that the same call gives the same sample. Outcomes whose velocities agree to 1e-6 are one.
///
/// # Errors
/// As [`staged::resolve`], of a walk that has no way on.
///
/// # Limits
/// An inner approximation: what is listed can be reached, but more may be.
///
/// # Example
/// Two feet close at 1 m/s, `W₁₁ = W₂₂ = 2` and `W₁₂ = 1`. Loaded alike both rest. After 1/2 N s at the first
/// alone it rests, and the second needs 1/4 N s more, which lifts the first with 1/4 m/s.
/// ```
/// use carom_impact::planar::{Block, ContactSet, sharing};
/// let cell = |tt, nn| Block { tt, tn: 0.0, nt: 0.0, nn };
/// let feet = ContactSet::<2, 4> {
///     count: 2, operator: [[cell(1.0, 2.0), cell(0.0, 1.0)], [cell(0.0, 1.0), cell(1.0, 2.0)]],
///     slip: [0.0; 2], normal: [-1.0, -1.0], friction: [0.0; 2], restitution: [0.0; 2],
/// };
/// let all = sharing::every(&feet, 10)?;
/// let reached = |up: f64| all.iter().any(|out| (out.velocity[0][1] - up).abs() < 1e-14);
/// assert!(reached(0.0) && reached(0.25) && !reached(0.3));
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
pub fn every<const N: usize, const M: usize>(
    set: &ContactSet<N, M>,
    samples: usize,
) -> Result<Vec<StagedOutcome<N>>, ImpactError> {
    set.check()?;
    let mut found: Vec<StagedOutcome<N>> = vec![];
    for sample in 0..samples.max(set.count + 1) {
        let mut walk = Walk::new(set);
        compress_in_proportion(&mut walk, sample)?;
        walk.restitute(Law::Poisson, 1.0, &mut |_| {})?;
        let out = walk.outcome(Law::Poisson, 1.0)?;
        if !out.gained_energy && !found.iter().any(|other| alike(set, other, &out)) {
            found.push(out);
        }
    }
    Ok(found)
}

/// True where two outcomes have the same velocities, to 1e-6 of the largest.
pub fn alike<const N: usize, const M: usize>(
    set: &ContactSet<N, M>,
    a: &StagedOutcome<N>,
    b: &StagedOutcome<N>,
) -> bool {
    let all = || a.velocity[..set.count].iter().flatten().zip(b.velocity[..set.count].iter().flatten());
    let largest = all().fold(0.0, |m: f64, (u, v)| m.max(u.abs()).max(v.abs()));
    let before = set.slip[..set.count].iter().chain(&set.normal[..set.count]);
    let fastest = before.fold(0.0, |m: f64, u| m.max(u.abs()));
    all().all(|(u, v)| (u - v).abs() <= (OTHER_OUTCOME * largest).max(WEDGED_STILL * fastest))
}

/// Loads every closing contact at a rate of its own until none approaches.
fn compress_in_proportion<const N: usize, const M: usize>(
    walk: &mut Walk<'_, N, M>,
    sample: usize,
) -> Result<(), ImpactError> {
    for event in 0.. {
        let closing: [bool; N] = std::array::from_fn(|i| i < walk.set.count && walk.approaches(i));
        if !closing.iter().any(|c| *c) {
            break;
        }
        walk.spend()?;
        let weight = proportions::<N>(&closing, walk.set.count, sample, event);
        let load = std::array::from_fn(|i| {
            if closing[i] && weight[i] > 0.0 {
                Load::Prescribed(weight[i])
            } else if i < walk.set.count && walk.normal(i) <= 0.0 && !closing[i] {
                Load::Touching(0.0)
            } else {
                Load::Absent
            }
        });
        let drive = [[0.0; 2]; N];
        let answer = walk.ask(drive, load).solve();
        let Some(chosen) = answer.preferred(walk.present.as_ref()).copied() else {
            // No way on in these proportions: as the approaches themselves demand.
            return walk.compress(&mut |_| {});
        };
        let change = walk.kept_out(change(&chosen, &drive), &chosen, None);
        let mut step = Step { length: f64::INFINITY, why: StageEnd::CompressionEnds };
        for i in (0..walk.set.count).filter(|&i| closing[i] && change[i][1] > 0.0) {
            let length = -walk.normal(i) / change[i][1];
            if length < step.length {
                step = Step { length, why: StageEnd::Closes(i) };
            }
        }
        let step = walk.next_event(&chosen, &change, step);
        if !step.length.is_finite() {
            return walk.compress(&mut |_| {});
        }
        walk.advance(Phase::Compression, &chosen, &change, &step);
    }
    walk.compress(&mut |_| {})
}

/// Rates of load for one stage of a sample: first one contact alone, then all alike, then spread evenly over all proportions.
fn proportions<const N: usize>(closing: &[bool; N], count: usize, sample: usize, event: usize) -> [f64; N] {
    let mut weight = [0.0; N];
    if sample < count {
        let alone = (0..count).map(|k| (sample + k) % count).find(|&i| closing[i]);
        if let Some(i) = alone {
            weight[i] = 1.0;
        }
        return weight;
    }
    for (i, w) in weight.iter_mut().enumerate().take(count).filter(|(i, _)| closing[*i]) {
        *w = if sample == count { 1.0 } else { spread(sample, 7 * event + i) };
    }
    weight
}

/// A number in (0, 1) of an additive recurrence, one for each sample and axis.
fn spread(sample: usize, axis: usize) -> f64 {
    // Fractional parts of multiples of square roots of primes are spread evenly, and independently of each other.
    const ROOTS: [f64; 8] = [2.0, 3.0, 5.0, 7.0, 11.0, 13.0, 17.0, 19.0];
    #[expect(clippy::cast_precision_loss, reason = "small counts")]
    let (n, shift) = (sample as f64, (axis / ROOTS.len()) as f64);
    let x = n * ROOTS[axis % ROOTS.len()].sqrt() + shift * 0.381_966_011_250_105;
    (x - x.floor()).max(LEAST_SHARE)
}
