//! The answer of a rate problem: a set of solutions, each with its smallest margin.

use crate::planar::contacts::names::Slip;
use crate::tolerance::{EQUAL_MARGINS, SAME_MOTION};

/// What a hypothesis says of one contact.
///
/// # Example
/// A block of 1 kg at rest on an incline of 3 in 4, too smooth to hold it, slides.
/// ```
/// use carom_impact::{Load, planar::{Block, Guess, Slip, rate::RateProblem}};
/// let operator = [[Block { tt: 1.0, tn: 0.0, nt: 0.0, nn: 1.0 }]];
/// let incline = RateProblem::<1, 2> {
///     count: 1, operator: &operator, friction: &[0.5],
///     drive: [[6.0, -8.0]], slip: [0.0], load: [Load::Touching(0.0)],
/// };
/// let slides = Guess { holds: true, slip: Slip::Forward };
/// assert_eq!(incline.solve().solutions[0].map(|solution| solution.guess), Some([slides]));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Guess {
    /// Its normal velocity does not change, and its normal rate may exceed the base load.
    pub holds: bool,
    /// Its slip state; [`Slip::Open`] where it transmits nothing.
    pub slip: Slip,
}

impl Guess {
    /// True where the contact transmits its base load and no more.
    pub(super) fn is_loaded(self) -> bool {
        !self.holds && self.slip != Slip::Open
    }
}

/// The inequality that rejects a hypothesis, or the one that is nearest to doing so.
///
/// Each inequality has a slack. Divided by the sum of the magnitudes of its terms the slack lies in −1…1: this is the *margin* of a solution.
/// A negative margin is a broken inequality, and its magnitude is the *share* by which it is broken: near 0 it is a close call, at 1 nothing
/// speaks for the hypothesis. If several are broken, the one with the largest share is named. Where forces are indeterminate, the
/// inequalities of the motion are asked first, because the motion is the same for all of these forces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Condition {
    /// The contact's normal rate must not pull; against all rates and base loads.
    Pushes(usize),
    /// An open contact must not approach; against the drive and what each rate adds to it.
    Opens(usize),
    /// A sticking contact must stay within the friction cone: `μ r − |q|` against `μ r + |q|`; asked of a push only.
    WithinCone(usize),
    /// Friction must act against the slip it starts; the slip's rate against the drive and what each rate adds to it.
    StartsForward(usize),
    /// Friction must act against the slip it starts; the slip's rate against the drive and what each rate adds to it.
    StartsBackward(usize),
    /// The equations of the hypothesis must have a solution.
    Solvable,
}

/// An inequality that a hypothesis breaks, and by how much.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Broken {
    /// Which inequality.
    pub condition: Condition,
    /// How much is missing, in the unit of the rates (pushes, cone) or of the drive (opens, starts), > 0; not finite where numbers overflow.
    pub amount: f64,
    /// The amount divided by the sum of the magnitudes of its terms, in 0…1.
    pub share: f64,
}

impl Broken {
    /// Equations that have no solution.
    pub(super) const UNSOLVABLE: Self = Self { condition: Condition::Solvable, amount: 0.0, share: 1.0 };
}

/// A consistent hypothesis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solution<const N: usize> {
    /// The hypothesis.
    pub guess: [Guess; N],
    /// Rates (q, r) of each contact.
    pub rates: [[f64; 2]; N],
    /// Response `drive + W (q, r)` of each contact, (t, n), absent ones included.
    pub response: [[f64; 2]; N],
    /// Smallest slack divided by the sum of its terms' magnitudes.
    pub margin: f64,
    /// Which inequality that is.
    pub margin_of: Condition,
    /// True where the motion is determined but the forces are not.
    pub indeterminate: bool,
}

/// All distinct solutions found.
///
/// # Example
/// A rod whose end slips into its lean, `W_nn − μW_tn = 5/2 − 2 · 3/2 < 0`: pressed down it has no motion,
/// pulled off it has two.
/// ```
/// use carom_impact::{Load, planar::{Block, rate::RateProblem}};
/// let operator = [[Block { tt: 2.5, tn: 1.5, nt: 1.5, nn: 2.5 }]];
/// let solutions = |drive: f64| RateProblem::<1, 2> {
///     count: 1, operator: &operator, friction: &[2.0],
///     drive: [[0.0, drive]], slip: [1.0], load: [Load::Touching(0.0)],
/// }.solve().count;
/// assert_eq!([solutions(-10.0), solutions(10.0)], [0, 2]);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Answer<const N: usize> {
    /// The first [`Answer::KEPT`] solutions whose motions differ.
    pub solutions: [Option<Solution<N>>; 4],
    /// Number of solutions whose motions differ.
    pub count: usize,
    /// Every hypothesis was tried: there are no others.
    pub examined: bool,
}

impl<const N: usize> Answer<N> {
    /// How many solutions are kept.
    pub const KEPT: usize = 4;

    /// No solution, so far.
    pub(in crate::planar) const NONE: Self = Self { solutions: [None; 4], count: 0, examined: true };

    /// The kept solutions.
    pub fn iter(&self) -> impl Iterator<Item = &Solution<N>> {
        self.solutions.iter().flatten()
    }

    /// Takes a solution in, unless one with the same motion is there already. `scale` is the drive's magnitude.
    pub(in crate::planar) fn keep(&mut self, solution: Solution<N>, count: usize, scale: f64) {
        let magnitude =
            |s: &Solution<N>| s.response[..count].iter().flatten().fold(scale, |m: f64, v| m.max(v.abs()));
        let own = magnitude(&solution);
        let same = |other: &Solution<N>| {
            let largest = magnitude(other).max(own);
            let near = |i: usize, a: usize| {
                (solution.response[i][a] - other.response[i][a]).abs() <= SAME_MOTION * largest
            };
            (0..count).all(|i| near(i, 0) && near(i, 1))
        };
        if let Some(kept) = self.solutions.iter_mut().flatten().find(|kept| same(kept)) {
            // The member that is farther from being rejected stands for the motion; of equals the one that fixes more of it.
            let fixed = |s: &Solution<N>| {
                s.guess.iter().map(|g| u8::from(g.holds) + u8::from(g.slip == Slip::Sticks)).sum::<u8>()
            };
            let equal = (solution.margin - kept.margin).abs() <= EQUAL_MARGINS;
            if if equal { fixed(&solution) > fixed(kept) } else { solution.margin > kept.margin } {
                *kept = solution;
            }
            return;
        }
        if let Some(place) = self.solutions.get_mut(self.count) {
            *place = Some(solution);
        }
        self.count += 1;
    }

    /// The preferred solution: the one that keeps `present` slip states where there is one, else the one with most open contacts, else
    /// the one with most slipping contacts.
    pub fn preferred(&self, present: Option<&[Slip; N]>) -> Option<&Solution<N>> {
        let keeps = |s: &&Solution<N>| present.is_some_and(|p| (0..N).all(|i| s.guess[i].slip == p[i]));
        let count = |s: &Solution<N>, slip: fn(Slip) -> bool| s.guess.iter().filter(|g| slip(g.slip)).count();
        self.iter().find(keeps).or_else(|| {
            self.iter().max_by_key(|s| {
                (count(s, |s| s == Slip::Open), count(s, |s| matches!(s, Slip::Forward | Slip::Backward)))
            })
        })
    }
}
