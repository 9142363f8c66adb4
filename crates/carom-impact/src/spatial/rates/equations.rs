//! The equations of a hypothesis: where a contact holds or sticks, its velocity does not change that way.
//!
//! A single body has six independent rates, so several contacts often leave a family of rates. Of these the one stands for the others that equal springs
//! make of the load, see [`springs`](super::springs).

use super::answer::{Freedom, Guess, Member, Mode};
use super::rate::RateProblem;
use crate::spatial::contacts::set::MOST_EXAMINED;
use crate::tolerance::{NO_MOTION, RANK};
use carom_num::Vec3;
use carom_num::solve::{Solutions, Tolerance, solve_regular, solve_rows};

/// Most unknown rates: three for each contact.
pub(super) const MOST: usize = 3 * MOST_EXAMINED;

/// A hypothesis with the directions in which its contacts slip.
#[derive(Clone, Copy)]
pub(in crate::spatial) struct Hypothesis<'p, const N: usize> {
    pub(in crate::spatial) problem: &'p RateProblem<'p, N>,
    pub(in crate::spatial) guess: &'p [Guess; N],
    /// Unit vectors; zero where a contact does not slip.
    pub(in crate::spatial) direction: [[f64; 2]; N],
}

/// The rates that satisfy the equations of a hypothesis.
#[derive(Clone, Copy)]
pub(in crate::spatial) struct Found<const N: usize> {
    pub(in crate::spatial) rates: [Vec3; N],
    pub(in crate::spatial) freedom: Freedom,
    pub(in crate::spatial) member: Member,
}

/// Which rates are unknown: contact and axis of each.
#[derive(Clone, Copy)]
pub(super) struct Unknowns {
    pub(in crate::spatial) count: usize,
    of: [(u8, u8); MOST],
}

impl Unknowns {
    pub(super) fn of(&self) -> impl Iterator<Item = (usize, usize)> {
        self.of[..self.count].iter().map(|(contact, axis)| (usize::from(*contact), usize::from(*axis)))
    }

    /// A number for each of them, from its contact and axis.
    pub(super) fn each<const M: usize>(&self, number: impl Fn((usize, usize)) -> f64) -> [f64; M] {
        let mut out = [0.0; M];
        out.iter_mut().zip(self.of()).for_each(|(out, of)| *out = number(of));
        out
    }

    /// The contacts whose normal rates are below zero, one bit each.
    pub(super) fn pulled<const M: usize>(&self, x: &[f64; M]) -> u32 {
        let normal = self.of().zip(x).filter(|((_, axis), x)| *axis == 2 && **x < 0.0);
        normal.fold(0, |bits, ((i, _), _)| bits | 1 << i)
    }
}

/// What a hypothesis demands of its unknowns.
pub(super) struct Equations<const M: usize> {
    pub(super) matrix: [[f64; M]; M],
    pub(super) right: [f64; M],
    /// The largest sum of magnitudes of which a right side is made.
    pub(super) terms: f64,
}

impl<const M: usize> Equations<M> {
    /// All solutions of the first n; `None` where the equations contradict each other.
    ///
    /// Loads of contacts that lie evenly about the mass centre turn it by nothing but their rounding: what contradicts is measured against the terms of the
    /// right sides, for these may leave nothing of each other.
    fn solved(mut self, n: usize) -> Option<Solutions<M>> {
        self.matrix[..n].iter_mut().for_each(|row| row[n..].fill(0.0));
        let largest = self.right[..n].iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        let contradiction = if largest > 0.0 { RANK * (self.terms / largest).max(1.0) } else { RANK };
        let tolerance = Tolerance { rank: RANK, contradiction };
        solve_rows(&mut self.matrix[..n], &mut self.right[..n], n, tolerance)
    }
}

/// Calls a method with the size of arrays that its unknowns need.
macro_rules! sized {
    ($self:ident.$method:ident($unknowns:expr $(, $more:expr)*)) => {
        match $unknowns.count {
            0..=3 => $self.$method::<3>($unknowns $(, $more)*),
            4..=6 => $self.$method::<6>($unknowns $(, $more)*),
            7..=12 => $self.$method::<12>($unknowns $(, $more)*),
            13..=24 => $self.$method::<24>($unknowns $(, $more)*),
            _ => $self.$method::<MOST>($unknowns $(, $more)*),
        }
    };
}

impl<const N: usize> Hypothesis<'_, N> {
    /// The rates that the hypothesis demands; `None` where its equations leave some open, or contradict each other.
    pub(super) fn determined(&self) -> Option<[Vec3; N]> {
        let unknowns = self.unknowns();
        sized!(self.determined_sized(&unknowns))
    }

    /// The rates that the hypothesis demands, as equal springs share them; `None` where its equations contradict each other.
    pub(super) fn shared(&self) -> Option<[Vec3; N]> {
        let unknowns = self.unknowns();
        sized!(self.shared_sized(&unknowns))
    }

    /// Hands over the rates that the hypothesis demands. Equal springs share them, of which more than one set may be lifted: all of these are asked for where
    /// they make a difference to the motion. If there is none in which no contact pulls, the rates are those of which none is lifted.
    pub(super) fn each_rates(&self, visit: &mut impl FnMut(Found<N>)) {
        let unknowns = self.unknowns();
        sized!(self.each_sized(&unknowns, visit));
    }

    /// The rates where these contacts, one bit each, are lifted, and by how much each contact sinks in.
    pub(in crate::spatial) fn sprung_by(&self, lifted: u32) -> Option<([Vec3; N], [f64; N])> {
        let unknowns = self.unknowns();
        sized!(self.sprung_sized(&unknowns, lifted))
    }

    fn determined_sized<const M: usize>(&self, unknowns: &Unknowns) -> Option<[Vec3; N]> {
        let Equations { matrix, right, .. } = self.equations::<M>(unknowns);
        solve_regular(matrix, right, unknowns.count, RANK).map(|x| self.spread(&x, unknowns))
    }

    fn shared_sized<const M: usize>(&self, unknowns: &Unknowns) -> Option<[Vec3; N]> {
        let equations = self.equations::<M>(unknowns);
        if let Some(x) = solve_regular(equations.matrix, equations.right, unknowns.count, RANK) {
            return Some(self.spread(&x, unknowns));
        }
        let springs = self.springs(unknowns, &equations)?;
        let sprung = springs.guessed().map(|rest| rest.sprung).or_else(|| springs.sprung(0))?;
        Some(self.spread(&sprung.x, unknowns))
    }

    fn each_sized<const M: usize>(&self, unknowns: &Unknowns, visit: &mut impl FnMut(Found<N>)) {
        let equations = self.equations::<M>(unknowns);
        let mut hand = |x: &[f64; M], freedom, lifted| {
            visit(Found { rates: self.spread(x, unknowns), freedom, member: Member::Springs(lifted) });
        };
        if let Some(x) = solve_regular(equations.matrix, equations.right, unknowns.count, RANK) {
            return hand(&x, Freedom::None, 0);
        }
        let Some(springs) = self.springs(unknowns, &equations) else { return };
        let Some(family) = equations.solved(unknowns.count) else { return };
        let moves = family.free[..family.freedom].iter().any(|free| self.moves(&self.direct(free, unknowns)));
        let freedom = if moves { Freedom::Motion } else { Freedom::Rates };
        let guessed = springs.guessed();
        let rests = guessed.filter(|rest| rest.rests);
        let mut ways: Vec<_> = rests.into_iter().collect();
        if moves || rests.is_none() {
            let others = springs.all().into_iter();
            ways.extend(others.filter(|other| rests.is_none_or(|rest| rest.lifted != other.lifted)));
        }
        if ways.is_empty() {
            ways.extend(guessed);
        }
        for rest in &ways {
            hand(&rest.sprung.x, freedom, rest.lifted);
        }
        if ways.is_empty()
            && let Some(sprung) = springs.sprung(0)
        {
            hand(&sprung.x, freedom, 0);
        }
    }

    fn sprung_sized<const M: usize>(
        &self,
        unknowns: &Unknowns,
        lifted: u32,
    ) -> Option<([Vec3; N], [f64; N])> {
        let mut sinks = [0.0; N];
        let equations = self.equations::<M>(unknowns);
        if lifted == 0
            && let Some(x) = solve_regular(equations.matrix, equations.right, unknowns.count, RANK)
        {
            return Some((self.spread(&x, unknowns), sinks));
        }
        let sprung = self.springs(unknowns, &equations)?.sprung(lifted)?;
        for ((i, axis), sink) in unknowns.of().zip(sprung.sinks) {
            sinks[i] = if axis == 2 { sink } else { sinks[i] };
        }
        Some((self.spread(&sprung.x, unknowns), sinks))
    }

    /// All rates that satisfy the equations, the shortest as the point.
    pub(super) fn family<const M: usize>(&self, unknowns: &Unknowns) -> Option<Solutions<M>> {
        let mut family = self.equations::<M>(unknowns).solved(unknowns.count)?;
        family.shorten();
        Some(family)
    }

    /// True where these rates alone move a contact.
    fn moves(&self, rates: &[Vec3; N]) -> bool {
        let contacts = 0..self.problem.count;
        contacts.clone().any(|i| {
            let (mut moved, mut terms) = (Vec3::ZERO, 0.0);
            for j in contacts.clone() {
                let by = self.problem.operator[i][j] * rates[j];
                moved += by;
                terms += by.norm();
            }
            moved.norm() > NO_MOTION * terms
        })
    }

    /// Rates of contact j for a normal rate of 1, friction included where it slides.
    pub(in crate::spatial) fn pull(&self, j: usize) -> Vec3 {
        let mu = self.problem.friction[j];
        let [x, y] = if self.guess[j].slides() { self.direction[j] } else { [0.0; 2] };
        Vec3::new(-mu * x, -mu * y, 1.0)
    }

    pub(super) fn unknowns(&self) -> Unknowns {
        let mut out = Unknowns { count: 0, of: [(0, 0); MOST] };
        for (i, g) in (0..).zip(&self.guess[..self.problem.count]) {
            let sticks = g.mode == Mode::Sticks;
            for (axis, counts) in (0..).zip([sticks, sticks, g.holds]) {
                if counts && let Some(place) = out.of.get_mut(out.count) {
                    *place = (i, axis);
                    out.count += 1;
                }
            }
        }
        out
    }

    /// Both sides of the equations. The right-hand side is minus the drive, and minus the response to the base loads.
    pub(super) fn equations<const M: usize>(&self, unknowns: &Unknowns) -> Equations<M> {
        let (mut matrix, mut right, mut terms) = ([[0.0; M]; M], [0.0; M], 0.0f64);
        let pull: [Vec3; N] = std::array::from_fn(|j| self.pull(j));
        for (k, (i, axis)) in unknowns.of().enumerate() {
            right[k] = -component(self.problem.drive[i], axis);
            let mut of_row = right[k].abs();
            for j in (0..self.problem.count).filter(|&j| self.is_loaded(j)) {
                let row = self.problem.operator[i][j].rows[axis];
                right[k] -= row.dot(pull[j]) * self.problem.base(j);
                of_row += row.norm() * pull[j].norm() * self.problem.base(j).abs();
            }
            terms = terms.max(of_row);
            for (entry, (j, by)) in matrix[k].iter_mut().zip(unknowns.of()) {
                let row = self.problem.operator[i][j].rows[axis];
                *entry = if by == 2 { row.dot(pull[j]) } else { component(row, by) };
            }
        }
        Equations { matrix, right, terms }
    }

    /// True where the contact transmits its base load and no more.
    fn is_loaded(&self, i: usize) -> bool {
        !self.guess[i].holds && self.guess[i].mode != Mode::Open
    }

    /// The rates of all contacts, base loads included.
    pub(super) fn spread<const M: usize>(&self, x: &[f64; M], unknowns: &Unknowns) -> [Vec3; N] {
        let mut rates = self.direct(x, unknowns);
        for i in (0..self.problem.count).filter(|&i| self.is_loaded(i)) {
            rates[i] += self.pull(i) * self.problem.base(i);
        }
        rates
    }

    /// The rates of all contacts that unknowns stand for, base loads left out.
    pub(super) fn direct<const M: usize>(&self, x: &[f64; M], unknowns: &Unknowns) -> [Vec3; N] {
        let mut rates = [Vec3::ZERO; N];
        for (x, (i, axis)) in x.iter().zip(unknowns.of()) {
            rates[i] += match axis {
                0 => Vec3::X * *x,
                1 => Vec3::Y * *x,
                _ => self.pull(i) * *x,
            };
        }
        rates
    }
}

pub(in crate::spatial) fn component(v: Vec3, axis: usize) -> f64 {
    match axis {
        0 => v.x,
        1 => v.y,
        _ => v.z,
    }
}
