//! The equations of a hypothesis: where a contact holds or sticks, its velocity does not change that way.
//!
//! All hypotheses of a problem draw their equations from the same columns, the responses of all contacts to one rate each, so these are
//! set up once. Systems of up to two unknowns are solved by hand, others by one elimination that serves families as well: no more than
//! three rates of a single body are independent, so most hypotheses of several contacts leave forces indeterminate.

use super::answer::{Broken, Guess, Solution};
use super::rate::RateProblem;
use crate::planar::contacts::names::Slip;
use crate::tolerance::RANK;
use carom_num::solve::{Solutions, Tolerance, solve_rows};

/// A number (t, n) for every contact.
pub(super) type PerContact<const N: usize> = [[f64; 2]; N];

/// A rate problem with its equations set up.
pub(in crate::planar) struct Equations<'p, const N: usize, const M: usize> {
    pub(in crate::planar) problem: &'p RateProblem<'p, N, M>,
    /// Response to the tangential rate of a contact.
    tangential: [PerContact<N>; N],
    /// Response to the normal rate of a contact, friction included: as it sticks, slips forward, slips backward.
    normal: [[PerContact<N>; 3]; N],
}

/// What satisfies the equations of a hypothesis.
enum Found<const N: usize, const M: usize> {
    /// These rates and no others.
    One(PerContact<N>),
    /// Many rates, all with one motion.
    Family(Solutions<M>),
}

/// Rates of a hypothesis whose forces have the most slack.
pub(super) struct Middle<const N: usize> {
    pub(super) rates: PerContact<N>,
    /// Other rates satisfy the equations too.
    pub(super) indeterminate: bool,
    /// That slack, in ample rates, where they do and it is known.
    pub(super) slack: Option<f64>,
}

/// Which rates of a hypothesis are unknown.
#[derive(Clone, Copy)]
pub(in crate::planar) struct Unknowns<const N: usize, const M: usize> {
    pub(in crate::planar) count: usize,
    /// Contact and axis of each.
    of: [(usize, usize); M],
    /// The unknown that stands for each rate; that of a rate which is none is never asked for.
    pub(in crate::planar) number: [[usize; 2]; N],
}

impl<'p, const N: usize, const M: usize> Equations<'p, N, M> {
    pub(in crate::planar) fn of(problem: &'p RateProblem<'p, N, M>) -> Self {
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
    pub(in crate::planar) fn normal(&self, j: usize, slip: Slip) -> &PerContact<N> {
        match slip {
            Slip::Sticks | Slip::Open => &self.normal[j][0],
            Slip::Forward => &self.normal[j][1],
            Slip::Backward => &self.normal[j][2],
        }
    }

    fn column(&self, guess: &[Guess; N], (j, axis): (usize, usize)) -> &PerContact<N> {
        if axis == 0 { &self.tangential[j] } else { self.normal(j, guess[j].slip) }
    }

    /// The solution that a hypothesis is, if it is consistent.
    pub(in crate::planar) fn solution(&self, guess: &[Guess; N]) -> Option<Solution<N>> {
        let (rates, indeterminate) = self.possible_rates(guess).ok()?;
        self.problem.tested(guess, rates, indeterminate)
    }

    /// Tests one hypothesis.
    pub(super) fn try_guess(&self, guess: &[Guess; N]) -> Result<Solution<N>, Broken> {
        let (rates, indeterminate) = self.possible_rates(guess)?;
        self.problem.verify(guess, rates, indeterminate)
    }

    /// The rates of a hypothesis, unless its motion, which is that of every member of its family, rejects it already.
    fn possible_rates(&self, guess: &[Guess; N]) -> Result<(PerContact<N>, bool), Broken> {
        let unknowns = self.unknowns(guess);
        match self.found(guess, &unknowns, RANK).ok_or(Broken::UNSOLVABLE)? {
            Found::One(rates) => Ok((rates, false)),
            Found::Family(family) => {
                let any = self.rates(guess, &unknowns, &family.point);
                match self.problem.moves_wrongly(guess, &any) {
                    Some(why) => Err(why),
                    None => Ok((self.rates(guess, &unknowns, &self.middle(guess, &unknowns, &family)), true)),
                }
            }
        }
    }

    /// The rates of a hypothesis, in the middle of what its forces allow; `contradiction` as in [`RateProblem::rates_of`].
    pub(super) fn middle_of(&self, guess: &[Guess; N], contradiction: f64) -> Option<Middle<N>> {
        let unknowns = self.unknowns(guess);
        Some(match self.found(guess, &unknowns, contradiction)? {
            Found::One(rates) => Middle { rates, indeterminate: false, slack: None },
            Found::Family(family) => {
                let (x, slack) = self.middle_and_slack(guess, &unknowns, &family);
                Middle { rates: self.rates(guess, &unknowns, &x), indeterminate: true, slack }
            }
        })
    }

    /// As [`RateProblem::rates_of`].
    pub(in crate::planar) fn rates_of(
        &self,
        guess: &[Guess; N],
        contradiction: f64,
    ) -> Option<(PerContact<N>, bool)> {
        self.middle_of(guess, contradiction).map(|middle| (middle.rates, middle.indeterminate))
    }

    /// What satisfies the equations of a hypothesis; `None` where they contradict each other by more than this fraction of the largest.
    fn found(
        &self,
        guess: &[Guess; N],
        unknowns: &Unknowns<N, M>,
        contradiction: f64,
    ) -> Option<Found<N, M>> {
        if let Some(x) = self.solve_small(guess, unknowns) {
            return Some(Found::One(self.rates(guess, unknowns, &x)));
        }
        let (mut rows, mut right) = self.equations(guess, unknowns);
        let n = unknowns.count;
        let tolerance = Tolerance { rank: RANK, contradiction };
        let family = solve_rows(&mut rows[..n], &mut right[..n], n, tolerance)?;
        Some(match family.freedom {
            0 => Found::One(self.rates(guess, unknowns, &family.point)),
            _ => Found::Family(family),
        })
    }

    /// The rates that satisfy the equations of a hypothesis, where there are many.
    pub(in crate::planar) fn family(
        &self,
        guess: &[Guess; N],
        unknowns: &Unknowns<N, M>,
    ) -> Option<Solutions<M>> {
        match self.found(guess, unknowns, RANK)? {
            Found::One(_) => None,
            Found::Family(family) => Some(family),
        }
    }

    pub(in crate::planar) fn unknowns(&self, guess: &[Guess; N]) -> Unknowns<N, M> {
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

    /// The right-hand side of one equation: minus the drive, and minus the response to the base loads.
    fn right(&self, guess: &[Guess; N], (i, axis): (usize, usize)) -> f64 {
        let mut right = -self.problem.drive[i][axis];
        for (j, g) in guess.iter().enumerate().take(self.problem.count) {
            if g.is_loaded() {
                right -= self.normal(j, g.slip)[i][axis] * self.problem.base(j);
            }
        }
        right
    }

    /// One or two unknowns of a regular system, by hand.
    fn solve_small(&self, guess: &[Guess; N], s: &Unknowns<N, M>) -> Option<[f64; M]> {
        let mut x = [0.0; M];
        let entry = |row: usize, column: usize| {
            let (i, axis) = s.of[row];
            self.column(guess, s.of[column])[i][axis]
        };
        let right = |row: usize| self.right(guess, s.of[row]);
        match s.count {
            0 => Some(x),
            1 => {
                let a = entry(0, 0);
                x[0] = right(0) / a;
                (a != 0.0).then_some(x)
            }
            2 => {
                let [[a, b], [c, d]] = [0, 1].map(|i| [entry(i, 0), entry(i, 1)]);
                let [right_a, right_c] = [right(0), right(1)];
                let determinant = a * d - b * c;
                let largest = a.abs().max(b.abs()).max(c.abs()).max(d.abs());
                x[0] = (right_a * d - right_c * b) / determinant;
                x[1] = (right_c * a - right_a * c) / determinant;
                (determinant.abs() > RANK * largest * largest).then_some(x)
            }
            _ => None,
        }
    }

    /// Both sides of the equations.
    fn equations(&self, guess: &[Guess; N], s: &Unknowns<N, M>) -> ([[f64; M]; M], [f64; M]) {
        let (mut rows, mut right) = ([[0.0; M]; M], [0.0; M]);
        let of = &s.of[..s.count];
        for (k, &(i, axis)) in of.iter().enumerate() {
            right[k] = self.right(guess, (i, axis));
            for (entry, &unknown) in rows[k].iter_mut().zip(of) {
                *entry = self.column(guess, unknown)[i][axis];
            }
        }
        (rows, right)
    }

    pub(in crate::planar) fn rates(
        &self,
        guess: &[Guess; N],
        unknowns: &Unknowns<N, M>,
        x: &[f64; M],
    ) -> PerContact<N> {
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
}
