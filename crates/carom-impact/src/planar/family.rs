//! Forces that a hypothesis leaves indeterminate: which member of the family stands for it.

use super::Slip;
use super::answer::Guess;
use super::rate::{RANK_TOLERANCE, RateProblem, SLACK_TOLERANCE, System};
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
        if wedged && at(&least).0.as_flattened()[..rows].iter().all(|s| *s >= 0.0) {
            return least;
        }
        let mut x = family.point;
        for (zd, direction) in z.iter().zip(&family.free).take(family.freedom) {
            for (xi, di) in x.iter_mut().zip(direction) {
                *xi += cap * zd * di;
            }
        }
        x
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
