//! The rate problem: these contacts touch; which separate, stick or slip, and at which force (or impulse) rates?
//!
//! Contact i has a normal rate `rᵢ = βᵢ + xᵢ` (a base load βᵢ ≥ 0 and an excess xᵢ) and a tangential rate `qᵢ`; the response is
//! `w = drive + W (q, r)`. Signorini: `0 ≤ xᵢ ⊥ wₙᵢ ≥ 0`. Coulomb: `qᵢ = −μᵢ sᵢ rᵢ` while it slips with sign sᵢ; at zero slip either it
//! sticks (`wₜᵢ = 0`, `|qᵢ| ≤ μᵢ rᵢ`) or it starts to slip with sign s where `s wₜᵢ ≥ 0`.
//!
//! Every hypothesis is tried; each consistent one is a solution, each other one names the inequality that rejects it. Hypotheses whose
//! motions `w` agree are one solution. Where a hypothesis leaves the forces indeterminate (a box held by two sticking contacts), the
//! member of the family whose smallest slack is largest stands for it.

use super::answer::{Answer, Condition, Guess, Solution};
use super::{Block, Slip};
use carom_num::solve::{solve_any, solve_regular};

/// How a contact takes part in a rate problem.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Load {
    /// It does not touch.
    Absent,
    /// It touches: base load β, and an excess complementary to its normal rate.
    Touching(f64),
    /// Its normal rate is β whatever its normal velocity does.
    Prescribed(f64),
}

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
/// use carom_impact::planar::{Block, Slip, rate::{Load, RateProblem}};
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

/// Slacks below this fraction of their terms count as zero.
pub const SLACK_TOLERANCE: f64 = 1e-11;
/// Stands for no row.
const NONE: usize = usize::MAX;
/// Pivots below this fraction of the matrix count as zero.
pub(super) const RANK_TOLERANCE: f64 = 1e-9;

impl<const N: usize, const M: usize> RateProblem<'_, N, M> {
    /// Tries every hypothesis and returns the solutions whose motions differ.
    pub fn solve(&self) -> Answer<N> {
        if let Some(answer) = self.solve_two_sliding() {
            return answer;
        }
        self.each_hypothesis(|guess| {
            let (rates, indeterminate) = self.rates_of(guess)?;
            if self.pulls_or_slips(guess, &rates) {
                return None;
            }
            self.verify(guess, rates, indeterminate).ok()
        })
    }

    /// As [`RateProblem::solve`], handing each rejected hypothesis with the inequality that rejects it most and its slack to `reject`.
    pub fn solve_observed(&self, reject: &mut impl FnMut(&[Guess; N], Condition, f64)) -> Answer<N> {
        self.each_hypothesis(|guess| {
            self.try_guess(guess).map_err(|(condition, slack)| reject(guess, condition, slack)).ok()
        })
    }

    /// Tries every hypothesis and keeps those that pass.
    fn each_hypothesis(&self, mut try_one: impl FnMut(&[Guess; N]) -> Option<Solution<N>>) -> Answer<N> {
        let mut answer = Answer { solutions: [None; 4], count: 0 };
        if self.count > N {
            return answer;
        }
        let scale = self.scale();
        let mut guess = [Guess { holds: false, slip: Slip::Open }; N];
        let mut choice = [0usize; N];
        loop {
            let mut known = true;
            for i in 0..self.count {
                match self.option(i, choice[i]) {
                    Some(g) => guess[i] = g,
                    None => known = false,
                }
            }
            if known && let Some(solution) = try_one(&guess) {
                answer.keep(solution, self.count, scale);
            }
            if !self.next(&mut choice) {
                return answer;
            }
        }
    }

    /// Magnitude of the drive and of what the base loads do: differences far below it are rounding.
    pub(super) fn scale(&self) -> f64 {
        let mut scale = self.drive[..self.count].iter().flatten().fold(0.0, |m: f64, v| m.max(v.abs()));
        for j in 0..self.count {
            let base = self.base(j);
            for b in self.operator[..self.count].iter().map(|row| &row[j]).filter(|_| base > 0.0) {
                scale = scale.max(base * b.nn.abs().max(b.tn.abs()));
            }
        }
        scale
    }

    /// The inequalities that rates alone can break: most hypotheses fall here, before their motion is asked.
    fn pulls_or_slips(&self, guess: &[Guess; N], rates: &[[f64; 2]; N]) -> bool {
        let total: f64 = (0..self.count).map(|i| rates[i][0].abs() + rates[i][1].abs() + self.base(i)).sum();
        (0..self.count).any(|i| {
            let ([q, r], base) = (rates[i], self.base(i));
            let pulls = guess[i].holds && r - base < -SLACK_TOLERANCE * total;
            let bound = self.friction[i] * r;
            let in_cone = guess[i].slip != Slip::Sticks
                || self.never_slides(i)
                || bound - q.abs() >= -SLACK_TOLERANCE * (bound + q.abs());
            pulls || !in_cone
        })
    }

    /// Steps `choice` like an odometer over the options of each contact.
    fn next(&self, choice: &mut [usize; N]) -> bool {
        for (i, c) in choice.iter_mut().enumerate().take(self.count) {
            *c += 1;
            if self.option(i, *c).is_some() {
                return true;
            }
            *c = 0;
        }
        false
    }

    /// The k-th possibility of contact i.
    fn option(&self, i: usize, k: usize) -> Option<Guess> {
        let (may_hold, base) = match self.load[i] {
            Load::Absent => return (k == 0).then_some(Guess { holds: false, slip: Slip::Open }),
            Load::Touching(base) => (true, base),
            Load::Prescribed(base) => (false, base),
        };
        let slips: &[Slip] = if self.never_slides(i) {
            &[Slip::Sticks]
        } else if self.slip[i] > 0.0 || (self.slip[i] == 0.0 && self.friction[i] == 0.0) {
            &[Slip::Forward]
        } else if self.slip[i] < 0.0 {
            &[Slip::Backward]
        } else {
            &[Slip::Sticks, Slip::Forward, Slip::Backward]
        };
        let free: &[Slip] = if base > 0.0 { slips } else { &[Slip::Open] };
        if k < free.len() {
            Some(Guess { holds: false, slip: free[k] })
        } else if may_hold && k - free.len() < slips.len() {
            Some(Guess { holds: true, slip: slips[k - free.len()] })
        } else {
            None
        }
    }

    /// Friction without bound: whatever transmits an impulse sticks.
    pub(super) fn never_slides(&self, i: usize) -> bool {
        self.friction[i] == f64::INFINITY
    }

    pub(super) fn base(&self, i: usize) -> f64 {
        match self.load[i] {
            Load::Absent => 0.0,
            Load::Touching(base) | Load::Prescribed(base) => base,
        }
    }

    /// Tests one hypothesis.
    ///
    /// # Errors
    /// The inequality that is violated most, with its scaled slack.
    pub fn try_guess(&self, guess: &[Guess; N]) -> Result<Solution<N>, (Condition, f64)> {
        let (rates, indeterminate) = self.rates_of(guess).ok_or((Condition::Solvable, -1.0))?;
        self.verify(guess, rates, indeterminate)
    }

    /// The rates (t, n) that a hypothesis demands, its inequalities not asked, and whether they are one of a family; `None` where its
    /// equations contradict each other.
    pub fn rates_of(&self, guess: &[Guess; N]) -> Option<([[f64; 2]; N], bool)> {
        let system = self.system(guess);
        let n = system.unknowns;
        if let Some(x) = self.solve_small(&system) {
            return Some((self.rates(guess, &system, &x), false));
        }
        let family = solve_any(system.matrix, system.right, n, RANK_TOLERANCE)?;
        let x = if family.freedom == 0 { family.point } else { self.middle(guess, &system, &family) };
        Some((self.rates(guess, &system, &x), family.freedom > 0))
    }

    /// The unknowns of a regular system: one or two by hand.
    fn solve_small(&self, s: &System<N, M>) -> Option<[f64; M]> {
        let mut x = [0.0; M];
        match s.unknowns {
            0 => Some(x),
            1 => {
                x[0] = s.right[0] / s.matrix[0][0];
                (s.matrix[0][0] != 0.0).then_some(x)
            }
            2 => {
                let [[a, b], [c, d]] = [0, 1].map(|i| [s.matrix[i][0], s.matrix[i][1]]);
                let determinant = a * d - b * c;
                let largest = a.abs().max(b.abs()).max(c.abs()).max(d.abs());
                x[0] = (s.right[0] * d - s.right[1] * b) / determinant;
                x[1] = (s.right[1] * a - s.right[0] * c) / determinant;
                (determinant.abs() > RANK_TOLERANCE * largest * largest).then_some(x)
            }
            n => solve_regular(s.matrix, s.right, n, RANK_TOLERANCE),
        }
    }

    fn system(&self, guess: &[Guess; N]) -> System<N, M> {
        let mut s = System { unknowns: 0, row: [[NONE; 2]; N], matrix: [[0.0; M]; M], right: [0.0; M] };
        let mut unknown = [(0, 0); M];
        for (i, g) in guess.iter().enumerate().take(self.count) {
            for (axis, counts) in [g.slip == Slip::Sticks, g.holds].into_iter().enumerate() {
                if counts {
                    s.row[i][axis] = s.unknowns;
                    unknown[s.unknowns] = (i, axis);
                    s.unknowns += 1;
                }
            }
        }
        let n = s.unknowns;
        for (row, &(i, axis)) in unknown[..n].iter().enumerate() {
            s.right[row] = -self.drive[i][axis];
            for (column, &(j, of)) in unknown[..n].iter().enumerate() {
                let (to_q, to_r) = self.entry(i, axis, j);
                s.matrix[row][column] = if of == 0 { to_q } else { to_r + to_q * self.pull(guess[j], j) };
            }
            for (j, g) in guess.iter().enumerate().take(self.count) {
                if !g.holds && g.slip != Slip::Open {
                    let (to_q, to_r) = self.entry(i, axis, j);
                    s.right[row] -= (to_r + to_q * self.pull(*g, j)) * self.base(j);
                }
            }
        }
        s
    }

    pub(super) fn entry(&self, i: usize, axis: usize, j: usize) -> (f64, f64) {
        let b = &self.operator[i][j];
        if axis == 0 { (b.tt, b.tn) } else { (b.nt, b.nn) }
    }

    /// q per r of a slipping contact.
    pub(super) fn pull(&self, guess: Guess, i: usize) -> f64 {
        guess.slip.pull(self.friction[i])
    }

    pub(super) fn rates(&self, guess: &[Guess; N], system: &System<N, M>, x: &[f64; M]) -> [[f64; 2]; N] {
        let mut rates = [[0.0; 2]; N];
        for i in 0..self.count {
            if guess[i].slip == Slip::Open {
                continue;
            }
            let r = if guess[i].holds { x[system.row[i][1]] } else { self.base(i) };
            let q =
                if guess[i].slip == Slip::Sticks { x[system.row[i][0]] } else { self.pull(guess[i], i) * r };
            rates[i] = [q, r];
        }
        rates
    }

    pub(super) fn verify(
        &self,
        guess: &[Guess; N],
        rates: [[f64; 2]; N],
        indeterminate: bool,
    ) -> Result<Solution<N>, (Condition, f64)> {
        let (response, terms) = self.response(&rates);
        let total =
            (0..self.count).fold(0.0, |m: f64, i| m + rates[i][0].abs() + rates[i][1].abs() + self.base(i));
        let mut worst = (Condition::Solvable, f64::INFINITY);
        let mut check = |condition: Condition, slack: f64, scale: f64| {
            let scaled = if scale == 0.0 { 0.0 } else { slack / scale };
            if scaled < worst.1 || scaled.is_nan() {
                worst = (condition, scaled);
            }
        };
        for i in 0..self.count {
            let ([q, r], g) = (rates[i], guess[i]);
            if g.holds {
                check(Condition::Pushes(i), r - self.base(i), total);
            } else if matches!(self.load[i], Load::Touching(_)) {
                check(Condition::Opens(i), response[i][1], terms[i][1]);
            }
            match g.slip {
                Slip::Sticks if self.never_slides(i) => {}
                Slip::Sticks => check(
                    Condition::WithinCone(i),
                    self.friction[i] * r - q.abs(),
                    self.friction[i] * r + q.abs(),
                ),
                Slip::Forward if self.starts(i) => {
                    check(Condition::StartsForward(i), response[i][0], terms[i][0])
                }
                Slip::Backward if self.starts(i) => {
                    check(Condition::StartsBackward(i), -response[i][0], terms[i][0])
                }
                _ => {}
            }
        }
        let (margin_of, margin) = worst;
        let sound = response.iter().flatten().sum::<f64>().is_finite();
        if sound && margin >= -SLACK_TOLERANCE {
            let rates = clip(rates);
            Ok(Solution { guess: *guess, rates, response, margin, margin_of, indeterminate })
        } else {
            Err(worst)
        }
    }

    /// True where a slip would start from rest and its direction is a matter of the solution.
    fn starts(&self, i: usize) -> bool {
        self.slip[i] == 0.0 && self.friction[i] > 0.0
    }

    /// `drive + W (q, r)` of every contact, and the sums of the magnitudes of its terms.
    fn response(&self, rates: &[[f64; 2]; N]) -> ([[f64; 2]; N], [[f64; 2]; N]) {
        let mut response = self.drive;
        let mut terms = [[0.0; 2]; N];
        for i in 0..self.count {
            for axis in 0..2 {
                terms[i][axis] = self.drive[i][axis].abs();
                for (j, [q, r]) in rates.iter().enumerate().take(self.count) {
                    let (to_q, to_r) = self.entry(i, axis, j);
                    response[i][axis] += to_q * q + to_r * r;
                    terms[i][axis] += (to_q * q).abs() + (to_r * r).abs();
                }
            }
        }
        (response, terms)
    }
}

/// Rounding must not leave a normal rate that pulls.
fn clip<const N: usize>(mut rates: [[f64; 2]; N]) -> [[f64; 2]; N] {
    for rate in &mut rates {
        if rate[1] < 0.0 {
            *rate = [0.0; 2];
        }
    }
    rates
}

/// The linear system of a hypothesis: which unknown stands for which rate.
pub(super) struct System<const N: usize, const M: usize> {
    pub(super) unknowns: usize,
    row: [[usize; 2]; N],
    matrix: [[f64; M]; M],
    right: [f64; M],
}
