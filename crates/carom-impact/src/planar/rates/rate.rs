//! The rate problem: these contacts touch; which separate, stick or slip, and at which force (or impulse) rates?
//!
//! Contact i has a normal rate `rᵢ = βᵢ + xᵢ` (a base load βᵢ ≥ 0 and an excess xᵢ) and a tangential rate `qᵢ`; the response is
//! `w = drive + W (q, r)`. Signorini: `0 ≤ xᵢ ⊥ wₙᵢ ≥ 0`. Coulomb: `qᵢ = −μᵢ sᵢ rᵢ` while it slips with sign sᵢ; at zero slip either it
//! sticks (`wₜᵢ = 0`, `|qᵢ| ≤ μᵢ rᵢ`) or it starts to slip with sign s where `s wₜᵢ ≥ 0`.
//!
//! Every hypothesis is tried, those that leave no response by one of them; each consistent one is a solution, each other one
//! names the inequality that rejects it. Hypotheses whose
//! motions `w` agree are one solution. Where a hypothesis leaves the forces indeterminate (a box held by two sticking contacts), the
//! member of the family whose smallest slack is largest stands for it.

use super::answer::{Answer, Broken, Guess, Solution};
use super::equations::Equations;
use super::standstill::Standstill;
use crate::Load;
use crate::planar::contacts::names::Slip;
use crate::planar::contacts::set::Block;

/// A rate problem of up to N contacts; M = 2 N.
///
/// ```text
/// w = drive + W (q, r);   0 ≤ x ⊥ w_n ≥ 0,  r = β + x;   |q| ≤ μ r, against the slip or the slip that starts
/// ```
///
/// The unit of the drive decides that of the rates: accelerations [m/s²] give forces [N], velocities [m/s] impulses [N s].
///
/// # Limits
/// Planar, rigid, one friction coefficient a contact. A drive or operator that is not finite, or a count above N, has no solution.
///
/// # Example
/// A block of 1 kg at rest on an incline of 3 in 4 (g = 10 m/s², gravity (6, −8) in (t, n)) holds from μ = 3/4 on, and slides else.
/// ```
/// use carom_impact::{Load, planar::{Block, Slip, rate::RateProblem}};
/// let block = [[Block { tt: 1.0, tn: 0.0, nt: 0.0, nn: 1.0 }]];
/// let ask = |friction: f64| {
///     let problem = RateProblem::<1, 2> {
///         count: 1, operator: &block, friction: &[friction],
///         drive: [[6.0, -8.0]], slip: [0.0], load: [Load::Touching(0.0)],
///     };
///     let answer = problem.solve();
///     assert_eq!(answer.count, 1);
///     answer.solutions[0].map(|s| (s.guess[0].slip, s.rates[0]))
/// };
/// assert_eq!(ask(0.8), Some((Slip::Sticks, [-6.0, 8.0])));
/// assert_eq!(ask(0.5), Some((Slip::Forward, [-4.0, 8.0])));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct RateProblem<'a, const N: usize, const M: usize> {
    /// Number of contacts.
    pub count: usize,
    /// The operator W.
    pub operator: &'a [[Block; N]; N],
    /// Friction coefficients.
    pub friction: &'a [f64; N],
    /// Drive (t, n) of each contact.
    pub drive: [[f64; 2]; N],
    /// Slip velocities: only the sign counts, and whether it is zero.
    pub slip: [f64; N],
    /// How each contact takes part.
    pub load: [Load; N],
}

/// Most contacts of which every hypothesis is tried.
pub const MOST_EXAMINED: usize = 6;
/// A contact holds or not, and sticks or slips forward or backward.
const MOST_OPTIONS: usize = 6;

/// What each contact may do.
pub(super) struct Options<const N: usize> {
    of: [[Guess; MOST_OPTIONS]; N],
    number: [usize; N],
    count: usize,
}

impl<const N: usize> Options<N> {
    fn of<const M: usize>(problem: &RateProblem<'_, N, M>) -> Self {
        let none = [Guess { holds: false, slip: Slip::Open }; MOST_OPTIONS];
        let mut options = Self { of: [none; N], number: [0; N], count: problem.count.min(N) };
        for i in 0..options.count {
            for (place, option) in options.of[i].iter_mut().zip(problem.options(i)) {
                *place = option;
                options.number[i] += 1;
            }
        }
        options
    }

    /// Those of each contact.
    pub(super) fn each(&self) -> impl Iterator<Item = &[Guess]> + Clone {
        self.of.iter().zip(self.number).map(|(of, number)| &of[..number]).take(self.count)
    }
}

impl<const N: usize, const M: usize> RateProblem<'_, N, M> {
    /// Examines every hypothesis and returns the solutions whose motions differ; of more than [`MOST_EXAMINED`] contacts one solution, without
    /// examining whether there are others.
    ///
    /// # Example
    /// A block of 1 kg on a floor, pulled up by more than its weight: it leaves with what is left, 2 m/s².
    /// ```
    /// use carom_impact::{Load, planar::{Block, Slip, rate::RateProblem}};
    /// let operator = [[Block { tt: 1.0, tn: 0.0, nt: 0.0, nn: 1.0 }]];
    /// let answer = RateProblem::<1, 2> {
    ///     count: 1, operator: &operator, friction: &[0.5],
    ///     drive: [[0.0, 12.0 - 10.0]], slip: [0.0], load: [Load::Touching(0.0)],
    /// }.solve();
    /// let solution = answer.solutions[0].unwrap();
    /// assert_eq!((answer.count, solution.guess[0].slip, solution.response), (1, Slip::Open, [[0.0, 2.0]]));
    /// ```
    pub fn solve(&self) -> Answer<N> {
        if self.count == 1 && N >= 1 {
            return self.solve_one();
        }
        if self.count == 2 && N >= 2 {
            return self.solve_two();
        }
        if self.count > MOST_EXAMINED {
            return self.solve_by_pivoting();
        }
        self.solve_by_elimination()
    }

    /// The answer for any number of contacts. Hypotheses that leave no response are one, and are not tried each on its own where that is clear.
    pub(super) fn solve_by_elimination(&self) -> Answer<N> {
        if self.count > N {
            return Answer::NONE;
        }
        let equations = Equations::of(self);
        let options = Options::of(self);
        let standstill = Standstill::of(&equations, &options);
        self.each_hypothesis(&options, standstill.as_ref(), |guess| equations.solution(guess))
    }

    /// As [`RateProblem::solve`], handing each rejected hypothesis with the inequality that it breaks most to `reject`.
    ///
    /// # Example
    /// The block on the incline of 3 in 4 slides forward: three other hypotheses are rejected.
    /// ```
    /// use carom_impact::{Load, planar::{Block, Condition, Slip, rate::RateProblem}};
    /// let operator = [[Block { tt: 1.0, tn: 0.0, nt: 0.0, nn: 1.0 }]];
    /// let incline = RateProblem::<1, 2> {
    ///     count: 1, operator: &operator, friction: &[0.5],
    ///     drive: [[6.0, -8.0]], slip: [0.0], load: [Load::Touching(0.0)],
    /// };
    /// let mut rejected = vec![];
    /// incline.solve_observed(&mut |guess, broken| rejected.push((guess[0].slip, broken.condition)));
    /// assert_eq!(rejected, [
    ///     (Slip::Open, Condition::Opens(0)),
    ///     (Slip::Sticks, Condition::WithinCone(0)),
    ///     (Slip::Backward, Condition::StartsBackward(0)),
    /// ]);
    /// ```
    pub fn solve_observed(&self, reject: &mut impl FnMut(&[Guess; N], Broken)) -> Answer<N> {
        let equations = Equations::of(self);
        self.each_hypothesis(&Options::of(self), None, |guess| {
            equations.try_guess(guess).map_err(|broken| reject(guess, broken)).ok()
        })
    }

    /// Tries every hypothesis, but those that leave no response where it is known what they come to, and keeps those that pass.
    fn each_hypothesis(
        &self,
        options: &Options<N>,
        standstill: Option<&Standstill<N, M>>,
        mut try_one: impl FnMut(&[Guess; N]) -> Option<Solution<N>>,
    ) -> Answer<N> {
        let mut answer = Answer::NONE;
        if self.count > N {
            return answer;
        }
        let scale = self.scale();
        let mut still = standstill.and_then(|standstill| standstill.solution);
        let mut guess = options.of.map(|of| of[0]);
        let mut choice = [0; N];
        // Velocities that are held by the contacts from each one on, and how many of them.
        let (mut held, mut count) = ([[0.0; M]; M], [0; N]);
        let mut turned = self.count;
        loop {
            // What the contacts hold whose option is new, from the last one down to the first: at one of them nothing may be left.
            let at_rest = standstill.and_then(|standstill| {
                (0..turned.min(self.count)).rev().find(|&i| {
                    let before = if i + 1 < self.count { count[i + 1] } else { 0 };
                    let holds = standstill.hold((i, guess[i]), &mut held, before);
                    holds.is_none_or(|now| {
                        count[i] = now;
                        false
                    })
                })
            });
            // The solution that stands for all of those comes where the first of them would.
            let solution = if at_rest.is_some() { still.take() } else { try_one(&guess) };
            if let Some(solution) = solution {
                answer.keep(solution, self.count, scale);
            }
            // Steps like an odometer over the options of each contact; past all of those whose contacts before hold everything already.
            let from = at_rest.unwrap_or(0);
            let Some(next) = (from..self.count).find(|&i| choice[i] + 1 < options.number[i]) else {
                return answer;
            };
            choice[next] += 1;
            choice[..next].fill(0);
            for i in 0..=next {
                guess[i] = options.of[i][choice[i]];
            }
            turned = next + 1;
        }
    }

    /// Magnitude of the drive and of what the base loads do: differences far below it are rounding.
    pub(in crate::planar) fn scale(&self) -> f64 {
        let mut scale = self.drive[..self.count].iter().flatten().fold(0.0, |m: f64, v| m.max(v.abs()));
        for j in 0..self.count {
            let base = self.base(j);
            for b in self.operator[..self.count].iter().map(|row| &row[j]).filter(|_| base > 0.0) {
                scale = scale.max(base * b.nn.abs().max(b.tn.abs()));
            }
        }
        scale
    }

    /// The possibilities of contact i: those in which it does not hold, then those in which it does.
    pub(super) fn options(&self, i: usize) -> impl Iterator<Item = Guess> + Clone {
        let (may_hold, base) = match self.load[i] {
            Load::Absent => (false, 0.0),
            Load::Touching(base) => (true, base),
            Load::Prescribed(base) => (false, base),
        };
        let slips: &'static [Slip] = if self.never_slides(i) {
            &[Slip::Sticks]
        } else if self.slip[i] > 0.0 || (self.slip[i] == 0.0 && self.friction[i] == 0.0) {
            &[Slip::Forward]
        } else if self.slip[i] < 0.0 {
            &[Slip::Backward]
        } else {
            &[Slip::Sticks, Slip::Forward, Slip::Backward]
        };
        let free = if base > 0.0 { slips } else { &[Slip::Open] };
        let held = if may_hold { slips } else { &[] };
        let guess = |holds| move |slip: &Slip| Guess { holds, slip: *slip };
        free.iter().map(guess(false)).chain(held.iter().map(guess(true)))
    }

    /// Friction without bound: whatever transmits an impulse sticks.
    pub(super) fn never_slides(&self, i: usize) -> bool {
        self.friction[i] == f64::INFINITY
    }

    pub(in crate::planar) fn base(&self, i: usize) -> f64 {
        match self.load[i] {
            Load::Absent => 0.0,
            Load::Touching(base) | Load::Prescribed(base) => base,
        }
    }

    /// Tests one hypothesis.
    ///
    /// # Errors
    /// [`Broken`] names the inequality that is broken most; [`super::answer::Condition`] says what its share is measured against.
    pub fn try_guess(&self, guess: &[Guess; N]) -> Result<Solution<N>, Broken> {
        Equations::of(self).try_guess(guess)
    }

    /// The rates (t, n) that satisfy the equations of a hypothesis, and whether others satisfy them too; inequalities are not asked. `None`
    /// where the equations contradict each other by more than the fraction `contradiction` of their largest right-hand side.
    pub fn rates_of(&self, guess: &[Guess; N], contradiction: f64) -> Option<([[f64; 2]; N], bool)> {
        Equations::of(self).rates_of(guess, contradiction)
    }
}
