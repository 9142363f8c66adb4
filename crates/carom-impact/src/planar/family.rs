//! Forces that a hypothesis leaves indeterminate: which member of the family stands for it.

use super::Slip;
use super::answer::Guess;
use super::rate::{RANK_TOLERANCE, RateProblem, SLACK_TOLERANCE, System};
use carom_num::lemke::lemke;
use carom_num::slack::largest_smallest_slack;
use carom_num::solve::{Solutions, solve_regular};

impl<const N: usize, const M: usize> RateProblem<'_, N, M> {
    /// The member of an indeterminate family whose smallest slack is largest. Where contacts are wedged, so that slacks grow without
    /// bound, the smallest member: the contacts press each other no more than they must.
    pub(super) fn middle(
        &self,
        guess: &[Guess; N],
        system: &System<N, M>,
        family: &Solutions<M>,
    ) -> [f64; M] {
        let at = |x: &[f64; M]| self.force_slacks(guess, &self.rates(guess, system, x));
        let (h, rows) = at(&family.point);
        let cap = self.ample_rate();
        if cap == 0.0 {
            return family.point;
        }
        // In units of the ample rate, so that no unit of impulse or force decides.
        let mut g = [[[0.0; M]; 3]; N];
        for d in 0..family.freedom {
            let mut moved = family.point;
            for (m, f) in moved.iter_mut().zip(&family.free[d]) {
                *m += cap * f;
            }
            let (along, _) = at(&moved);
            let slopes = along.as_flattened().iter().zip(h.as_flattened()).map(|(a, h)| (a - h) / cap);
            for (row, slope) in g.as_flattened_mut().iter_mut().zip(slopes) {
                row[d] = slope;
            }
        }
        let h = h.map(|slacks| slacks.map(|slack| slack / cap));
        let (g, h) = (&g.as_flattened()[..rows], &h.as_flattened()[..rows]);
        let Some((z, slack)) = largest_smallest_slack(g, h, family.freedom, 1.0) else {
            return family.point;
        };
        let least = least_member(family, system.unknowns);
        let wedged = slack >= 1.0 - SLACK_TOLERANCE;
        if wedged && let Some(x) = self.least_that_holds(&least, family, system.unknowns, &at) {
            return x;
        }
        let mut x = family.point;
        for (zd, direction) in z.iter().zip(&family.free).take(family.freedom) {
            for (xi, di) in x.iter_mut().zip(direction) {
                *xi += cap * zd * di;
            }
        }
        x
    }

    /// The member with the least sum of squares among those whose slacks are not negative, from the `least` of all members: the projection
    /// on a convex set, found from its complementarity problem.
    fn least_that_holds(
        &self,
        least: &[f64; M],
        family: &Solutions<M>,
        unknowns: usize,
        at: &impl Fn(&[f64; M]) -> ([[f64; 3]; N], usize),
    ) -> Option<[f64; M]> {
        let (slacks, rows) = at(least);
        let slacks = &slacks.as_flattened()[..rows];
        if slacks.iter().all(|s| *s >= 0.0) {
            return Some(*least);
        }
        let basis = orthonormal(family, unknowns);
        // In units of the largest slack, so that no unit of impulse or force decides.
        let unit = slacks.iter().fold(0.0, |m: f64, s| m.max(s.abs()));
        // Slopes of the slacks along each direction of the basis.
        let slopes: Vec<Vec<f64>> = basis
            .iter()
            .map(|direction| {
                let moved = std::array::from_fn(|i| least[i] + unit * direction[i]);
                let (there, _) = at(&moved);
                there.as_flattened()[..rows].iter().zip(slacks).map(|(a, s)| (a - s) / unit).collect()
            })
            .collect();
        let product = |i: usize, j: usize| slopes.iter().map(|g| g[i] * g[j]).sum::<f64>();
        let matrix: Vec<Vec<f64>> = (0..rows).map(|i| (0..rows).map(|j| product(i, j)).collect()).collect();
        let q: Vec<f64> = slacks.iter().map(|s| s / unit).collect();
        let pressure = lemke(&matrix, &q)?;
        let mut x = *least;
        for (direction, g) in basis.iter().zip(&slopes) {
            let along: f64 = unit * g.iter().zip(&pressure).map(|(g, p)| g * p).sum::<f64>();
            for (xi, d) in x.iter_mut().zip(direction) {
                *xi += along * d;
            }
        }
        Some(x)
    }

    /// A rate that is ample for every contact: ten times the largest that one contact alone would need to cancel its drive, or that a base
    /// load makes. Wedged contacts may press each other as hard as they like; more than this says nothing.
    pub(super) fn ample_rate(&self) -> f64 {
        let own = |i: usize| {
            let (b, [t, n]) = (&self.operator[i][i], self.drive[i]);
            (t / b.tt).abs().max((n / b.nn).abs()).max(self.base(i))
        };
        10.0 * (0..self.count).map(own).fold(0.0, f64::max)
    }

    /// Slacks that depend on the forces alone: pushing, and the two sides of the cone.
    pub(super) fn force_slacks(&self, guess: &[Guess; N], rates: &[[f64; 2]; N]) -> ([[f64; 3]; N], usize) {
        let (mut slacks, mut rows) = ([[0.0; 3]; N], 0);
        let mut push = |slack| {
            slacks.as_flattened_mut()[rows] = slack;
            rows += 1;
        };
        for i in 0..self.count {
            let ([q, r], mu) = (rates[i], self.friction[i]);
            let in_cone = guess[i].slip == Slip::Sticks && !self.never_slides(i);
            if in_cone {
                push(mu * r - q);
                push(mu * r + q);
            }
            // The two sides of the cone say already that a sticking contact does not pull.
            if guess[i].holds && (!in_cone || self.base(i) > 0.0) {
                push(r - self.base(i));
            }
        }
        (slacks, rows)
    }
}

/// The free directions of a family, made orthonormal (Gram and Schmidt, twice).
fn orthonormal<const M: usize>(family: &Solutions<M>, unknowns: usize) -> Vec<[f64; M]> {
    let product = |a: &[f64; M], b: &[f64; M]| (0..unknowns).map(|k| a[k] * b[k]).sum::<f64>();
    let mut basis: Vec<[f64; M]> = vec![];
    for direction in &family.free[..family.freedom] {
        let mut d = *direction;
        for _ in 0..2 {
            for b in &basis {
                let part = product(&d, b);
                d.iter_mut().zip(b).for_each(|(d, b)| *d -= part * b);
            }
        }
        let length = product(&d, &d).sqrt();
        basis.push(d.map(|v| v / length));
    }
    basis
}

/// The member of a family whose sum of squares is least.
fn least_member<const M: usize>(family: &Solutions<M>, unknowns: usize) -> [f64; M] {
    let product = |a: &[f64; M], b: &[f64; M]| (0..unknowns).map(|k| a[k] * b[k]).sum::<f64>();
    let (mut matrix, mut right) = ([[0.0; M]; M], [0.0; M]);
    for i in 0..family.freedom {
        right[i] = -product(&family.free[i], &family.point);
        for j in 0..family.freedom {
            matrix[i][j] = product(&family.free[i], &family.free[j]);
        }
    }
    let mut x = family.point;
    if let Some(z) = solve_regular(matrix, right, family.freedom, RANK_TOLERANCE) {
        for (zd, direction) in z.iter().zip(&family.free).take(family.freedom) {
            for (xi, di) in x.iter_mut().zip(direction) {
                *xi += zd * di;
            }
        }
    }
    x
}
