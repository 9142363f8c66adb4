//! Forces that a hypothesis leaves indeterminate: which member of the family stands for it.

use super::answer::Guess;
use super::equations::{Equations, PerContact, Unknowns};
use crate::planar::contacts::names::Slip;
use crate::tolerance::{NO_BOUND, RANK, SAME_RATE, SLACK_TOLERANCE};
use carom_num::lemke::lemke;
use carom_num::slack::Slacks;
use carom_num::solve::{Solutions, dot, solve_regular};

impl<const N: usize, const M: usize> Equations<'_, N, M> {
    /// The two members of a hypothesis' family that give contact i the least and the largest normal rate; `None` where that rate is the
    /// same in every member. Where nothing bounds the largest, it is one ample rate above that of the member in the middle.
    pub(in crate::planar) fn ends_of(&self, guess: &[Guess; N], i: usize) -> Option<[PerContact<N>; 2]> {
        let unknowns = self.unknowns(guess);
        let family = self.family(guess, &unknowns)?;
        let unit = self.ample_rate();
        let normal = unknowns.number[i][1];
        let moves = |d: &[f64; M]| guess[i].holds && d[normal] != 0.0;
        if unit == 0.0 || !family.free[..family.freedom].iter().any(moves) {
            return None;
        }
        let middle = self.middle(guess, &unknowns, &family);
        let mut slacks = Slacks::<M>::of(family.freedom);
        self.each_force_slack(guess, &unknowns, |slack| {
            slacks.push(slack.at(&middle) / unit, |d| slack.along(&family.free[d]));
        });
        let free = &family.free[..family.freedom];
        let end = |sign: f64| {
            let within = |cap| slacks.clone().highest(0.0, |d| sign * free[d][normal], cap);
            let (z, above) = within(NO_BOUND)?;
            let z = if above < NO_BOUND { z } else { within(1.0)?.0 };
            Some(moved(&middle, &z.map(|z| unit * z), free))
        };
        let ends = [end(-1.0)?, end(1.0)?];
        let open = ends[1][normal] - ends[0][normal] > SAME_RATE * unit;
        open.then(|| ends.map(|x| self.rates(guess, &unknowns, &x)))
    }

    /// The member of an indeterminate family whose smallest slack is largest. Where contacts are wedged, so that slacks grow without
    /// bound, the smallest member: the contacts press each other no more than they must.
    pub(in crate::planar) fn middle(
        &self,
        guess: &[Guess; N],
        unknowns: &Unknowns<N, M>,
        family: &Solutions<M>,
    ) -> [f64; M] {
        self.middle_and_slack(guess, unknowns, family).0
    }

    /// The same, and its smallest slack in units of the ample rate, where that is known.
    pub(super) fn middle_and_slack(
        &self,
        guess: &[Guess; N],
        unknowns: &Unknowns<N, M>,
        family: &Solutions<M>,
    ) -> ([f64; M], Option<f64>) {
        let unit = self.ample_rate();
        if unit == 0.0 {
            return (family.point, None);
        }
        // In units of the ample rate, so that no unit of impulse or force decides.
        let mut slacks = Slacks::<M>::of(family.freedom);
        self.each_force_slack(guess, unknowns, |slack| {
            slacks.push(slack.at(&family.point) / unit, |d| slack.along(&family.free[d]));
        });
        let Some((z, slack)) = slacks.largest_smallest(1.0) else { return (family.point, None) };
        let wedged = slack >= 1.0 - SLACK_TOLERANCE;
        if wedged && let Some(x) = self.least_that_holds(guess, unknowns, family) {
            return (x, Some(slack));
        }
        (moved(&family.point, &z.map(|z| unit * z), &family.free[..family.freedom]), Some(slack))
    }

    /// The member with the least sum of squares among those whose slacks are not negative, from the least of all members: the projection
    /// on a convex set, found from its complementarity problem.
    fn least_that_holds(
        &self,
        guess: &[Guess; N],
        unknowns: &Unknowns<N, M>,
        family: &Solutions<M>,
    ) -> Option<[f64; M]> {
        let least = least_member(family);
        let mut slacks = vec![];
        self.each_force_slack(guess, unknowns, |slack| slacks.push(slack));
        let at_least: Vec<f64> = slacks.iter().map(|slack| slack.at(&least)).collect();
        if at_least.iter().all(|s| *s >= 0.0) {
            return Some(least);
        }
        let mut short = *family;
        short.shorten();
        let basis = &short.free[..family.freedom];
        let slopes: Vec<Vec<f64>> =
            slacks.iter().map(|slack| basis.iter().map(|d| slack.along(d)).collect()).collect();
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let matrix: Vec<Vec<f64>> =
            slopes.iter().map(|a| slopes.iter().map(|b| product(a, b)).collect()).collect();
        // In units of the largest slack, so that no unit of impulse or force decides.
        let unit = at_least.iter().fold(0.0, |m: f64, s| m.max(s.abs()));
        let q: Vec<f64> = at_least.iter().map(|s| s / unit).collect();
        let pressure = lemke(&matrix, &q)?;
        let along = |d: usize| unit * slopes.iter().zip(&pressure).map(|(g, p)| g[d] * p).sum::<f64>();
        let way: Vec<f64> = (0..basis.len()).map(along).collect();
        Some(moved(&least, &way, basis))
    }

    /// A rate that is ample for every contact: ten times the largest that one contact alone would need to cancel its drive, or that a base
    /// load makes. Wedged contacts may press each other as hard as they like; more than this says nothing.
    fn ample_rate(&self) -> f64 {
        let own = |i: usize| {
            let (b, [t, n]) = (&self.problem.operator[i][i], self.problem.drive[i]);
            (t / b.tt).abs().max((n / b.nn).abs()).max(self.problem.base(i))
        };
        10.0 * (0..self.problem.count).map(own).fold(0.0, f64::max)
    }

    /// Slacks that depend on the forces alone: pushing, and the two sides of the cone.
    fn each_force_slack(
        &self,
        guess: &[Guess; N],
        unknowns: &Unknowns<N, M>,
        mut visit: impl FnMut(ForceSlack),
    ) {
        for (i, g) in guess.iter().enumerate().take(self.problem.count) {
            let (mu, base) = (self.problem.friction[i], self.problem.base(i));
            let [q, r] = unknowns.number[i];
            let in_cone = g.slip == Slip::Sticks && !self.problem.never_slides(i);
            if in_cone {
                let bound = if g.holds { (0.0, mu) } else { (mu * base, 0.0) };
                visit(ForceSlack { constant: bound.0, r: (r, bound.1), q: (q, -1.0) });
                visit(ForceSlack { constant: bound.0, r: (r, bound.1), q: (q, 1.0) });
            }
            // The two sides of the cone say already that a sticking contact does not pull.
            if g.holds && (!in_cone || base > 0.0) {
                visit(ForceSlack { constant: -base, r: (r, 1.0), q: (q, 0.0) });
            }
        }
    }
}

/// A slack of the forces of one contact: a constant, and which unknowns it depends on with which slopes.
#[derive(Clone, Copy)]
struct ForceSlack {
    constant: f64,
    r: (usize, f64),
    q: (usize, f64),
}

impl ForceSlack {
    fn at<const M: usize>(&self, x: &[f64; M]) -> f64 {
        self.constant + self.along(x)
    }

    fn along<const M: usize>(&self, x: &[f64; M]) -> f64 {
        self.r.1 * x[self.r.0] + self.q.1 * x[self.q.0]
    }
}

/// A point moved by so much along each of these directions.
fn moved<const M: usize>(from: &[f64; M], by: &[f64], directions: &[[f64; M]]) -> [f64; M] {
    let mut x = *from;
    for (by, direction) in by.iter().zip(directions) {
        x.iter_mut().zip(direction).for_each(|(x, d)| *x += by * d);
    }
    x
}

/// The member of a family whose sum of squares is least.
fn least_member<const M: usize>(family: &Solutions<M>) -> [f64; M] {
    let (mut matrix, mut right) = ([[0.0; M]; M], [0.0; M]);
    for i in 0..family.freedom {
        right[i] = -dot(&family.free[i], &family.point);
        for j in 0..family.freedom {
            matrix[i][j] = dot(&family.free[i], &family.free[j]);
        }
    }
    match solve_regular(matrix, right, family.freedom, RANK) {
        Some(z) => moved(&family.point, &z, &family.free[..family.freedom]),
        None => family.point,
    }
}
