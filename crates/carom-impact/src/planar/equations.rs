//! The equations of a hypothesis: where a contact holds or sticks, its velocity does not change that way.
//!
//! All hypotheses of a problem draw their equations from the same columns, the responses of all contacts to one rate each, so these are
//! set up once. Systems of up to two unknowns are solved by hand, others by one elimination that serves families as well: no more than
//! three rates of a single body are independent, so most hypotheses of several contacts leave forces indeterminate.

use super::Slip;
use super::answer::{Condition, Guess, Solution};
use super::rate::{Load, RANK_TOLERANCE, RateProblem, SLACK_TOLERANCE};
use carom_num::solve::solve_columns;

/// A number (t, n) for every contact.
type PerContact<const N: usize> = [[f64; 2]; N];

/// A rate problem with its equations set up.
pub(super) struct Equations<'p, const N: usize, const M: usize> {
    pub(super) problem: &'p RateProblem<'p, N, M>,
    /// Response to the tangential rate of a contact.
    tangential: [PerContact<N>; N],
    /// Response to the normal rate of a contact, friction included: as it sticks, slips forward, slips backward.
    normal: [[PerContact<N>; 3]; N],
}

/// Which rates of a hypothesis are unknown.
#[derive(Clone, Copy)]
pub(super) struct Unknowns<const N: usize, const M: usize> {
    pub(super) count: usize,
    /// Contact and axis of each.
    of: [(usize, usize); M],
    /// The unknown that stands for each rate; that of a rate which is none is never asked for.
    pub(super) number: [[usize; 2]; N],
}

impl<'p, const N: usize, const M: usize> Equations<'p, N, M> {
    pub(super) fn of(problem: &'p RateProblem<'p, N, M>) -> Self {
        let none = [[0.0; 2]; N];
        let mut out = Self { problem, tangential: [none; N], normal: [[none; 3]; N] };
        let count = problem.count.min(N);
        for j in 0..count {
            let pull = Slip::Forward.pull(problem.friction[j]);
            for i in 0..count {
                let b = &problem.operator[i][j];
                out.tangential[j][i] = [b.tt, b.nt];
                let [sticks, forward, backward] = &mut out.normal[j];
                sticks[i] = [b.tn, b.nn];
                forward[i] = [b.tn + b.tt * pull, b.nn + b.nt * pull];
                backward[i] = [b.tn - b.tt * pull, b.nn - b.nt * pull];
            }
        }
        out
    }

    /// Response to the normal rate of contact j, friction included.
    pub(super) fn normal(&self, j: usize, slip: Slip) -> &PerContact<N> {
        match slip {
            Slip::Sticks | Slip::Open => &self.normal[j][0],
            Slip::Forward => &self.normal[j][1],
            Slip::Backward => &self.normal[j][2],
        }
    }

    fn column(&self, guess: &[Guess; N], (j, axis): (usize, usize)) -> &PerContact<N> {
        if axis == 0 { &self.tangential[j] } else { self.normal(j, guess[j].slip) }
    }

    /// Tests one hypothesis.
    pub(super) fn try_guess(&self, guess: &[Guess; N]) -> Result<Solution<N>, (Condition, f64)> {
        let (rates, indeterminate) = self.rates_of(guess).ok_or((Condition::Solvable, -1.0))?;
        self.verify(guess, rates, indeterminate)
    }

    /// The rates (t, n) that a hypothesis demands, its inequalities not asked, and whether they are one of a family; `None` where its
    /// equations contradict each other.
    pub(super) fn rates_of(&self, guess: &[Guess; N]) -> Option<(PerContact<N>, bool)> {
        let unknowns = self.unknowns(guess);
        let right = self.right(guess);
        if let Some(x) = self.solve_small(guess, &unknowns, &right) {
            return Some((self.rates(guess, &unknowns, &x), false));
        }
        let mut columns = [[0.0; M]; M];
        for (column, &of) in columns.iter_mut().zip(&unknowns.of[..unknowns.count]) {
            *column = unknowns.equations(self.column(guess, of));
        }
        let right = unknowns.equations(&right);
        let family = solve_columns(columns, right, unknowns.count, RANK_TOLERANCE)?;
        let x = if family.freedom == 0 { family.point } else { self.middle(guess, &unknowns, &family) };
        Some((self.rates(guess, &unknowns, &x), family.freedom > 0))
    }

    fn unknowns(&self, guess: &[Guess; N]) -> Unknowns<N, M> {
        let mut out = Unknowns { count: 0, of: [(0, 0); M], number: [[0; 2]; N] };
        for (i, g) in guess.iter().enumerate().take(self.problem.count) {
            for (axis, counts) in [g.slip == Slip::Sticks, g.holds].into_iter().enumerate() {
                if counts {
                    out.number[i][axis] = out.count;
                    out.of[out.count] = (i, axis);
                    out.count += 1;
                }
            }
        }
        out
    }

    /// What the unknown rates have to bring about: the drive and what the base loads do, taken back.
    fn right(&self, guess: &[Guess; N]) -> PerContact<N> {
        let mut right = self.problem.drive.map(|drive| drive.map(|d| -d));
        for (j, g) in guess.iter().enumerate().take(self.problem.count) {
            let base = self.problem.base(j);
            if !g.holds && g.slip != Slip::Open && base != 0.0 {
                let pairs = right.as_flattened_mut().iter_mut().zip(self.normal(j, g.slip).as_flattened());
                pairs.for_each(|(right, to)| *right -= to * base);
            }
        }
        right
    }

    /// One or two unknowns of a regular system, by hand.
    fn solve_small(&self, guess: &[Guess; N], s: &Unknowns<N, M>, right: &PerContact<N>) -> Option<[f64; M]> {
        let mut x = [0.0; M];
        let entry = |row: usize, column: usize| {
            let (i, axis) = s.of[row];
            self.column(guess, s.of[column])[i][axis]
        };
        let right = |row: usize| right[s.of[row].0][s.of[row].1];
        match s.count {
            0 => Some(x),
            1 => {
                let a = entry(0, 0);
                x[0] = right(0) / a;
                (a != 0.0).then_some(x)
            }
            2 => {
                let [[a, b], [c, d]] = [0, 1].map(|i| [entry(i, 0), entry(i, 1)]);
                let determinant = a * d - b * c;
                let largest = a.abs().max(b.abs()).max(c.abs()).max(d.abs());
                x[0] = (right(0) * d - right(1) * b) / determinant;
                x[1] = (right(1) * a - right(0) * c) / determinant;
                (determinant.abs() > RANK_TOLERANCE * largest * largest).then_some(x)
            }
            _ => None,
        }
    }

    pub(super) fn rates(&self, guess: &[Guess; N], unknowns: &Unknowns<N, M>, x: &[f64; M]) -> PerContact<N> {
        let mut rates = [[0.0; 2]; N];
        for (i, g) in guess.iter().enumerate().take(self.problem.count) {
            if g.slip == Slip::Open {
                continue;
            }
            let [q, r] = unknowns.number[i];
            let r = if g.holds { x[r] } else { self.problem.base(i) };
            let q = if g.slip == Slip::Sticks { x[q] } else { g.slip.pull(self.problem.friction[i]) * r };
            rates[i] = [q, r];
        }
        rates
    }

    /// Asks every inequality of a hypothesis.
    pub(super) fn verify(
        &self,
        guess: &[Guess; N],
        rates: PerContact<N>,
        indeterminate: bool,
    ) -> Result<Solution<N>, (Condition, f64)> {
        let problem = self.problem;
        let (response, terms) = self.response(&rates);
        let total = problem.total(&rates);
        let mut worst = (Condition::Solvable, f64::INFINITY);
        let mut check = |condition: Condition, slack: f64, scale: f64| {
            let scaled = if scale == 0.0 { 0.0 } else { slack / scale };
            if scaled < worst.1 || scaled.is_nan() {
                worst = (condition, scaled);
            }
        };
        for i in 0..problem.count {
            let ([q, r], g) = (rates[i], guess[i]);
            if g.holds {
                check(Condition::Pushes(i), r - problem.base(i), total);
            } else if matches!(problem.load[i], Load::Touching(_)) {
                check(Condition::Opens(i), response[i][1], terms[i][1]);
            }
            let bound = problem.friction[i] * r;
            match g.slip {
                Slip::Sticks if problem.never_slides(i) => {}
                Slip::Sticks => check(Condition::WithinCone(i), bound - q.abs(), bound + q.abs()),
                Slip::Forward if problem.starts(i) => {
                    check(Condition::StartsForward(i), response[i][0], terms[i][0])
                }
                Slip::Backward if problem.starts(i) => {
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

    /// `drive + W (q, r)` of every contact, and the sums of the magnitudes of its terms.
    fn response(&self, rates: &PerContact<N>) -> (PerContact<N>, PerContact<N>) {
        let mut response = self.problem.drive;
        let mut terms = response.map(|drive| drive.map(f64::abs));
        for (j, [q, r]) in rates.iter().enumerate().take(self.problem.count) {
            let sums = response.as_flattened_mut().iter_mut().zip(terms.as_flattened_mut());
            let to_q = self.tangential[j].as_flattened();
            let to_r = self.normal[j][0].as_flattened();
            for ((response, terms), (to_q, to_r)) in sums.zip(to_q.iter().zip(to_r)) {
                *response += to_q * q + to_r * r;
                *terms += (to_q * q).abs() + (to_r * r).abs();
            }
        }
        (response, terms)
    }
}

impl<const N: usize, const M: usize> Unknowns<N, M> {
    /// The rows that a hypothesis makes equations of; the others are zero.
    fn equations(&self, rows: &PerContact<N>) -> [f64; M] {
        let mut out = [0.0; M];
        for &(i, axis) in &self.of[..self.count] {
            out[2 * i + axis] = rows[i][axis];
        }
        out
    }
}

/// Rounding must not leave a normal rate that pulls.
fn clip<const N: usize>(mut rates: PerContact<N>) -> PerContact<N> {
    for rate in &mut rates {
        if rate[1] < 0.0 {
            *rate = [0.0; 2];
        }
    }
    rates
}
