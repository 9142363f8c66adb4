//! Every end state that the laws of an impact allow, judged at the end and not along the way.
//!
//! The staged walk says what happens; here every hypothesis (each contact separates, sticks or slips in the end) is solved and tested, so
//! that a question with several answers, or none, shows. Impulses obey Coulomb's law with the slip of the end state.
//!
//! Newton: `0 ≤ p_n ⊥ u_n⁺ + e u_n⁻ ≥ 0` in one step. Poisson: compression, `0 ≤ p_n ⊥ u_n ≥ 0`, then restitution, in which each normal
//! impulse is at least e times its compression's: `0 ≤ p_n − e p_nᶜ ⊥ u_n⁺ ≥ 0`. Without restitution the two agree. Stronge's law measures
//! work, which an end state does not know: Poisson's is used in its place.
//!
//! Friction without bound (`f64::INFINITY`) is the non-sliding law of older papers: whatever transmits an impulse sticks.
//!
//! Source: Glocker and Pfeiffer, Nonlinear Dynamics 7 (1995) 471, for the two phases.

use crate::Load;
use crate::planar::contacts::names::Slip;
use crate::planar::contacts::set::ContactSet;
use crate::planar::rates::answer::Guess;
use crate::planar::rates::answer::Solution;
use crate::planar::rates::answer::{Answer, Broken};
use crate::planar::rates::rate::RateProblem;
use crate::tolerance::SAME_MOTION;
use crate::{Law, Phase};

/// A consistent end state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EndState<const N: usize> {
    /// What each contact does in the end.
    pub guess: [Guess; N],
    /// Impulses (tangential, normal) on the body [N s].
    pub impulse: [[f64; 2]; N],
    /// Velocities (slip, normal) after [m/s].
    pub velocity: [[f64; 2]; N],
    /// Smallest slack divided by the sum of its terms' magnitudes; infinite where no slack was examined (an end state by pivoting).
    pub margin: f64,
    /// The impulses are not determined, the motion is.
    pub indeterminate: bool,
}

/// A hypothesis that is not consistent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rejected<const N: usize> {
    /// The phase it belongs to.
    pub phase: Phase,
    /// What each contact was supposed to do.
    pub guess: [Guess; N],
    /// The inequality that fails most, and by how much.
    pub broken: Broken,
}

/// All end states.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EndStates<const N: usize> {
    /// The consistent ones whose motions differ.
    pub found: Vec<EndState<N>>,
    /// The others.
    pub rejected: Vec<Rejected<N>>,
}

impl<const N: usize> EndState<N> {
    /// True where it moves so: the contacts of `set` with these velocities (slip, normal) after.
    pub fn moves_as<const M: usize>(&self, set: &ContactSet<N, M>, velocity: &[[f64; 2]; N]) -> bool {
        let after = &velocity[..set.count];
        let before = set.slip[..set.count].iter().chain(&set.normal[..set.count]);
        let largest = before.chain(after.iter().flatten()).fold(0.0, |m: f64, u| m.max(u.abs()));
        let mut pairs = after.iter().flatten().zip(self.velocity[..set.count].iter().flatten());
        pairs.all(|(a, b)| (a - b).abs() <= SAME_MOTION * largest)
    }
}

impl<const N: usize> EndStates<N> {
    /// True where one of them [moves](EndState::moves_as) so.
    pub fn reach<const M: usize>(&self, set: &ContactSet<N, M>, velocity: &[[f64; 2]; N]) -> bool {
        self.found.iter().any(|end| end.moves_as(set, velocity))
    }
}

/// Solves and tests every hypothesis.
///
/// # Limits
/// At most four end states are kept for each phase. We know of no contacts of one rigid body that have more.
///
/// # Example
/// ```
/// use carom_impact::{Law, planar::{Block, ContactSet, end_states}};
/// // A ball of 1 kg dropped straight on a floor leaves at e times its approach speed, whichever law counts.
/// let ball = ContactSet::<1, 2> {
///     count: 1,
///     operator: [[Block { tt: 3.5, tn: 0.0, nt: 0.0, nn: 1.0 }]],
///     slip: [0.0],
///     normal: [-2.0],
///     friction: [0.3],
///     restitution: [0.5],
/// };
/// let ends = end_states::enumerate(&ball, Law::Newton);
/// assert_eq!(ends.found.len(), 1);
/// assert_eq!(ends.found[0].velocity[0], [0.0, 1.0]);
/// ```
pub fn enumerate<const N: usize, const M: usize>(set: &ContactSet<N, M>, law: Law) -> EndStates<N> {
    in_least_room(set, law, true)
}

/// The end states alone, without what rejects the others: most hypotheses of several contacts leave no velocity at all, and are one question then.
///
/// # Limits
/// As [`enumerate`].
///
/// # Example
/// A box that lands on both feet stays; why it does nothing else is not asked.
/// ```
/// use carom_impact::{Law, planar::{ContactSet2, Touch, end_states}};
/// use carom_num::Vec2;
/// let foot = |x| Touch { arm: Vec2::new(x, -0.5), normal: Vec2::new(0.0, 1.0), friction: 0.4, restitution: 0.0 };
/// let set = ContactSet2::of_free_body(1.0, 0.2, Vec2::new(0.0, -1.0), 0.0, &[foot(-0.3), foot(0.3)])?;
/// let found = end_states::found(&set, Law::Newton);
/// assert_eq!(found, end_states::enumerate(&set, Law::Newton).found);
/// assert_eq!((found.len(), found[0].guess.map(|guess| guess.holds)), (1, [true; 2]));
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
pub fn found<const N: usize, const M: usize>(set: &ContactSet<N, M>, law: Law) -> Vec<EndState<N>> {
    in_least_room(set, law, false).found
}

/// The end states, and what rejects the others where that is asked, from arrays that are no longer than they must be.
fn in_least_room<const N: usize, const M: usize>(
    set: &ContactSet<N, M>,
    law: Law,
    explain: bool,
) -> EndStates<N> {
    match set.count {
        0..=2 if N > 2 => widened(&of_any_size(&set.resized::<2, 4>(), law, explain)),
        3..=4 if N > 4 => widened(&of_any_size(&set.resized::<4, 8>(), law, explain)),
        _ => of_any_size(set, law, explain),
    }
}

/// The solutions of a phase; with `explain` what rejects the others is kept.
fn solved<const N: usize, const M: usize>(
    problem: &RateProblem<'_, N, M>,
    phase: Phase,
    explain: bool,
    ends: &mut EndStates<N>,
) -> Answer<N> {
    if !explain {
        return problem.solve();
    }
    problem.solve_observed(&mut |guess, broken| ends.rejected.push(Rejected { phase, guess: *guess, broken }))
}

/// The same end states with room for N contacts.
fn widened<const A: usize, const N: usize>(ends: &EndStates<A>) -> EndStates<N> {
    const OPEN: Guess = Guess { holds: false, slip: Slip::Open };
    let guesses = |from: &[Guess; A]| std::array::from_fn(|i| from.get(i).copied().unwrap_or(OPEN));
    let pairs = |from: &[[f64; 2]; A]| std::array::from_fn(|i| from.get(i).copied().unwrap_or_default());
    let found = ends.found.iter().map(|end| EndState {
        guess: guesses(&end.guess),
        impulse: pairs(&end.impulse),
        velocity: pairs(&end.velocity),
        margin: end.margin,
        indeterminate: end.indeterminate,
    });
    let rejected =
        ends.rejected.iter().map(|r| Rejected { phase: r.phase, guess: guesses(&r.guess), broken: r.broken });
    EndStates { found: found.collect(), rejected: rejected.collect() }
}

fn of_any_size<const N: usize, const M: usize>(
    set: &ContactSet<N, M>,
    law: Law,
    explain: bool,
) -> EndStates<N> {
    let mut ends = EndStates { found: vec![], rejected: vec![] };
    let approaching = (0..set.count).any(|i| set.normal[i] < 0.0);
    let bounces = (0..set.count).any(|i| set.restitution[i] > 0.0);
    if law == Law::Newton || !bounces || !approaching {
        one_step(set, explain, &mut ends);
    } else {
        two_phases(set, explain, &mut ends);
    }
    ends
}

fn problem<const N: usize, const M: usize>(
    set: &ContactSet<N, M>,
    drive: [[f64; 2]; N],
    load: [Load; N],
) -> RateProblem<'_, N, M> {
    // No slip is given: every hypothesis is free to choose the slip it ends with.
    RateProblem {
        count: set.count,
        operator: &set.operator,
        friction: &set.friction,
        drive,
        slip: [0.0; N],
        load,
    }
}

fn touching<const N: usize>(count: usize, base: impl Fn(usize) -> f64) -> [Load; N] {
    std::array::from_fn(|i| if i < count { Load::Touching(base(i)) } else { Load::Absent })
}

fn one_step<const N: usize, const M: usize>(set: &ContactSet<N, M>, explain: bool, ends: &mut EndStates<N>) {
    let bounce: [f64; N] = std::array::from_fn(|i| set.restitution[i] * set.normal[i].min(0.0));
    let drive = std::array::from_fn(|i| [set.slip[i], set.normal[i] + bounce[i]]);
    let problem = problem(set, drive, touching(set.count, |_| 0.0));
    let answer = solved(&problem, Phase::Compression, explain, ends);
    for solution in answer.iter() {
        let velocity =
            std::array::from_fn(|i| [solution.response[i][0], solution.response[i][1] - bounce[i]]);
        ends.found.push(end_state(solution, solution.rates, velocity, solution.margin));
    }
}

fn two_phases<const N: usize, const M: usize>(
    set: &ContactSet<N, M>,
    explain: bool,
    ends: &mut EndStates<N>,
) {
    let drive = std::array::from_fn(|i| [set.slip[i], set.normal[i]]);
    let compressed = problem(set, drive, touching(set.count, |_| 0.0));
    let compression = solved(&compressed, Phase::Compression, explain, ends);
    for first in compression.iter() {
        let drive: [[f64; 2]; N] = std::array::from_fn(|i| snapped(first, i));
        let load = touching(set.count, |i| set.restitution[i] * first.rates[i][1]);
        let restitution = solved(&problem(set, drive, load), Phase::Restitution, explain, ends);
        for second in restitution.iter() {
            let impulse = std::array::from_fn(|i| {
                [first.rates[i][0] + second.rates[i][0], first.rates[i][1] + second.rates[i][1]]
            });
            let margin = first.margin.min(second.margin);
            ends.found.push(end_state(second, impulse, second.response, margin));
        }
    }
}

/// Velocity at the end of a phase, exactly zero where its hypothesis says so.
fn snapped<const N: usize>(solution: &Solution<N>, i: usize) -> [f64; 2] {
    let [u_t, u_n] = solution.response[i];
    let guess = solution.guess[i];
    [if guess.slip == Slip::Sticks { 0.0 } else { u_t }, if guess.holds { 0.0 } else { u_n }]
}

fn end_state<const N: usize>(
    solution: &Solution<N>,
    impulse: [[f64; 2]; N],
    velocity: [[f64; 2]; N],
    margin: f64,
) -> EndState<N> {
    EndState { guess: solution.guess, impulse, velocity, margin, indeterminate: solution.indeterminate }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planar::contacts::set::ContactSet6;
    use crate::planar::contacts::set::Touch;
    use crate::planar::stages::staged;
    use carom_num::Vec2;

    /// Some hundred roundings of velocities of order one.
    const ROUNDING: f64 = 1e-12;
    /// Some ten roundings of numbers of order one.
    const EXACT: f64 = 1e-14;

    fn touch(arm: (f64, f64), friction: f64, restitution: f64) -> Touch {
        let arm = Vec2::new(arm.0, arm.1);
        Touch { arm, normal: Vec2::new(0.0, 1.0), friction, restitution }
    }

    #[test]
    fn one_contact_that_slides_throughout_ends_as_the_walk_does() {
        let touches = [touch((0.02, -0.05), 0.1, 0.5)];
        let set = ContactSet6::of_free_body(1.0, 1e-3, Vec2::new(3.0, -1.0), 0.0, &touches).unwrap();
        for law in [Law::Poisson, Law::Newton] {
            let walk = staged::resolve(&set, law).unwrap();
            let ends = enumerate(&set, law);
            assert_eq!(ends.found.len(), 1, "{law:?}");
            for axis in 0..2 {
                let (a, b) = (walk.velocity[0][axis], ends.found[0].velocity[0][axis]);
                assert!((a - b).abs() < ROUNDING, "{law:?}: {a} is not {b}");
            }
        }
    }

    #[test]
    fn by_poisson_restitution_gives_its_share_of_the_impulse_of_compression() {
        // It sticks before compression ends, so that no two laws agree.
        let set = |e: f64| {
            let touches = [touch((0.02, -0.05), 0.5, e)];
            ContactSet6::of_free_body(1.0, 1e-3, Vec2::new(0.2, -1.0), 0.0, &touches).unwrap()
        };
        let ends = |e: f64, law| enumerate(&set(e), law).found[0];
        let [compression, poisson] = [0.0, 0.5].map(|e| ends(e, Law::Poisson).impulse[0][1]);
        assert!((poisson - 1.5 * compression).abs() < EXACT, "{poisson} N s are not 1.5 · {compression}");
        let newton = ends(0.5, Law::Newton);
        assert!((newton.velocity[0][1] - 0.5).abs() < EXACT, "{newton:?}: half of the approach");
        assert!((newton.impulse[0][1] - poisson).abs() > 1e-3, "{newton:?} is another outcome");
    }

    #[test]
    fn every_hypothesis_is_found_or_rejected() {
        let touches = [touch((-0.05, -0.01), 0.3, 0.0), touch((0.05, -0.01), 0.3, 0.0)];
        let set = ContactSet6::of_free_body(1.0, 1e-3, Vec2::new(0.2, -1.0), 2.0, &touches).unwrap();
        let ends = enumerate(&set, Law::Poisson);
        assert!(!ends.found.is_empty(), "a plastic landing ends somehow");
        // Two contacts, each: separates, sticks, slips forward, slips backward; equal motions are one.
        assert!(ends.found.len() + ends.rejected.len() <= 16, "{ends:?}");
        for end in &ends.found {
            for i in 0..2 {
                let ([p_t, p_n], [_, u_n]) = (end.impulse[i], end.velocity[i]);
                assert!(p_n >= 0.0 && u_n >= -ROUNDING && p_t.abs() <= 0.3 * p_n + ROUNDING, "{end:?}");
                assert!((p_n * u_n).abs() < ROUNDING, "{end:?}");
            }
        }
    }

    #[test]
    fn with_friction_without_bound_a_wheel_of_six_spokes_rolls_on() {
        // Rim at radius 1, J = m r²/2, rolling at 1 rad/s about A until K, 60° on, strikes: ω⁺/ω⁻ = (cos 60° + j)/(1 + j).
        let (c, s) = (0.75_f64.sqrt(), 0.5);
        let touches = [touch((-s, -c), f64::INFINITY, 0.0), touch((s, -c), f64::INFINITY, 0.0)];
        let set = ContactSet6::of_free_body(1.0, 0.5, Vec2::new(c, -s), -1.0, &touches).unwrap();
        let ends = enumerate(&set, Law::Poisson);
        assert_eq!(ends.found.len(), 1, "{ends:?}");
        let (end, spin) = (&ends.found[0], -2.0 / 3.0);
        let open = touches[0].arm - touches[1].arm;
        let lifts = open.turned_left().y * spin;
        assert!((end.velocity[0][1] - lifts).abs() < EXACT, "{:?} is not {lifts}", end.velocity);
        assert_eq!(end.guess[1].slip, Slip::Sticks);
        assert!(ends.rejected.iter().all(|r| r.broken.share > 0.0));
    }

    #[test]
    fn nothing_happens_where_nothing_approaches() {
        let set =
            ContactSet6::of_free_body(1.0, 1.0, Vec2::new(0.0, 1.0), 0.0, &[touch((0.0, -0.1), 0.3, 0.5)])
                .unwrap();
        let ends = enumerate(&set, Law::Poisson);
        assert_eq!(ends.found.len(), 1);
        assert_eq!((ends.found[0].impulse[0], ends.found[0].velocity[0]), ([0.0; 2], [0.0, 1.0]));
    }
}
