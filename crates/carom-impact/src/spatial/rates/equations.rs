//! The equations of a hypothesis: where a contact holds or sticks, its velocity does not change that way.
//!
//! A single body has six independent rates, so several contacts often leave a family of rates. The shortest member stands for the others, where nothing
//! sticks the shortest of which none pulls: it does not depend on the frame, and it changes steadily with the slips. Without friction, and where all
//! contacts have one friction and slide one way, it is what equal and very small compliances of all contacts make of them.

use super::answer::{Freedom, Guess, Member, Mode};
use super::rate::RateProblem;
use crate::tolerance::{NO_MOTION, RANK};
use carom_num::Vec3;
use carom_num::solve::{Solutions, Tolerance, solve_regular, solve_rows};

/// Most unknown rates: three for each of eight contacts.
const MOST: usize = 24;

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
    of: [(usize, usize); MOST],
}

impl Unknowns {
    /// True where all of them are rates along normals.
    fn are_normal(&self) -> bool {
        self.of[..self.count].iter().all(|(_, axis)| *axis == 2)
    }

    /// The contacts of some of the unknowns, one bit each.
    fn contacts(&self, some: u64) -> u32 {
        let unknowns = self.of[..self.count].iter().enumerate();
        unknowns.filter(|(place, _)| some & (1 << place) != 0).fold(0, |bits, (_, (i, _))| bits | 1 << i)
    }
}

/// What a hypothesis demands of its unknowns.
struct Equations<const M: usize> {
    matrix: [[f64; M]; M],
    right: [f64; M],
    /// The largest sum of magnitudes of which a right side is made.
    terms: f64,
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

impl<const N: usize> Hypothesis<'_, N> {
    /// The rates that the hypothesis demands; of a family the shortest, and where nothing sticks the shortest of which none pulls, if there is one. `None`
    /// where its equations contradict each other.
    pub(in crate::spatial) fn rates(&self) -> Option<Found<N>> {
        self.found(true)
    }

    /// The rates that the hypothesis demands, the shortest of a family, whether they pull or not.
    pub(in crate::spatial) fn shortest(&self) -> Option<[Vec3; N]> {
        Some(self.found(false)?.rates)
    }

    fn found(&self, pushing: bool) -> Option<Found<N>> {
        let unknowns = self.unknowns();
        match unknowns.count {
            0..=3 => self.found_sized::<3>(&unknowns, pushing),
            4..=6 => self.found_sized::<6>(&unknowns, pushing),
            7..=12 => self.found_sized::<12>(&unknowns, pushing),
            _ => self.found_sized::<MOST>(&unknowns, pushing),
        }
    }

    fn found_sized<const M: usize>(&self, unknowns: &Unknowns, pushing: bool) -> Option<Found<N>> {
        let equations = self.equations::<M>(unknowns);
        let mut member = Member::Shortest;
        if let Some(x) = solve_regular(equations.matrix, equations.right, unknowns.count, RANK) {
            return Some(Found { rates: self.spread(&x, unknowns), freedom: Freedom::None, member });
        }
        let mut family = equations.solved(unknowns.count)?;
        family.shorten();
        if pushing && unknowns.are_normal() {
            // A contact that holds carries its base load at least.
            let least = unknowns.of.map(|(i, _)| self.problem.base(i));
            let least = &least[..unknowns.count];
            let pulls = family.point.iter().zip(least).any(|(x, least)| x < least);
            if pulls && let Some(above) = family.shortest_above(least) {
                family.point = above.point;
                member = Member::Pushing(unknowns.contacts(above.at_least));
            }
        }
        let moves = family.free[..family.freedom].iter().any(|free| self.moves(&self.direct(free, unknowns)));
        let freedom = if moves { Freedom::Motion } else { Freedom::Rates };
        Some(Found { rates: self.spread(&family.point, unknowns), freedom, member })
    }

    /// The shortest rates of which these contacts, one bit each, carry no more than their base loads.
    pub(in crate::spatial) fn rates_without(&self, idle: u32) -> Option<[Vec3; N]> {
        let unknowns = self.unknowns();
        let mut equations = self.equations::<MOST>(&unknowns);
        let carries_least = |(i, axis): (usize, usize)| axis == 2 && idle & (1 << i) != 0;
        for (place, &(i, axis)) in unknowns.of[..unknowns.count].iter().enumerate() {
            if carries_least((i, axis)) {
                let base = self.problem.base(i);
                for (row, right) in equations.matrix.iter_mut().zip(&mut equations.right) {
                    *right -= row[place] * base;
                    row[place] = 0.0;
                }
            }
        }
        let mut family = equations.solved(unknowns.count)?;
        family.shorten();
        for (x, &of) in family.point.iter_mut().zip(&unknowns.of[..unknowns.count]) {
            *x = if carries_least(of) { self.problem.base(of.0) } else { *x };
        }
        Some(self.spread(&family.point, &unknowns))
    }

    /// All rates that satisfy the equations, the shortest as the point.
    pub(super) fn family(&self) -> Option<(Solutions<MOST>, Unknowns)> {
        let unknowns = self.unknowns();
        let mut family = self.equations::<MOST>(&unknowns).solved(unknowns.count)?;
        family.shorten();
        Some((family, unknowns))
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

    fn unknowns(&self) -> Unknowns {
        let mut out = Unknowns { count: 0, of: [(0, 0); MOST] };
        for (i, g) in self.guess.iter().enumerate().take(self.problem.count) {
            let sticks = g.mode == Mode::Sticks;
            for (axis, counts) in [sticks, sticks, g.holds].into_iter().enumerate() {
                if counts && let Some(place) = out.of.get_mut(out.count) {
                    *place = (i, axis);
                    out.count += 1;
                }
            }
        }
        out
    }

    /// Both sides of the equations. The right-hand side is minus the drive, and minus the response to the base loads.
    fn equations<const M: usize>(&self, unknowns: &Unknowns) -> Equations<M> {
        let (mut matrix, mut right, mut terms) = ([[0.0; M]; M], [0.0; M], 0.0f64);
        let pull: [Vec3; N] = std::array::from_fn(|j| self.pull(j));
        let of = &unknowns.of[..unknowns.count];
        for (k, &(i, axis)) in of.iter().enumerate() {
            right[k] = -component(self.problem.drive[i], axis);
            let mut of_row = right[k].abs();
            for j in (0..self.problem.count).filter(|&j| self.is_loaded(j)) {
                let row = self.problem.operator[i][j].rows[axis];
                right[k] -= row.dot(pull[j]) * self.problem.base(j);
                of_row += row.norm() * pull[j].norm() * self.problem.base(j).abs();
            }
            terms = terms.max(of_row);
            for (entry, &(j, by)) in matrix[k].iter_mut().zip(of) {
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
        for (x, &(i, axis)) in x.iter().zip(&unknowns.of[..unknowns.count]) {
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
