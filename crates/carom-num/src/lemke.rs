//! The linear complementarity problem by Lemke's method.

use crate::tolerance::{LEMKE_CANCELS, LEMKE_COVERED, LEMKE_TIE, PIVOT};

/// A vector z with `w = M z + q`, `w ≥ 0`, `z ≥ 0` and `wᵀz = 0`, by complementary pivoting with the covering vector of ones; ties are
/// decided lexicographically, so that no pivot comes back.
///
/// `m` is square, row by row. `None` where the method ends in a ray: for a copositive-plus matrix there is then no solution.
///
/// Source: Lemke, Management Science 11 (1965) 681; Cottle, Pang and Stone, The Linear Complementarity Problem (1992), sections 4.4 and 4.9.
///
/// # Example
/// `2 z₁ + z₂ = 3` and `z₁ + 2 z₂ = 3` have the solution (1, 1), so that w = 0; `w = −z − 3` is never
/// positive.
/// ```
/// use carom_num::lemke::lemke;
/// let z = lemke(&[vec![2.0, 1.0], vec![1.0, 2.0]], &[-3.0, -3.0]).unwrap();
/// assert!(z.iter().all(|z| (z - 1.0).abs() <= 2.0 * f64::EPSILON));
/// assert_eq!(lemke(&[vec![-1.0]], &[-3.0]), None);
/// ```
pub fn lemke(m: &[Vec<f64>], q: &[f64]) -> Option<Vec<f64>> {
    let n = q.len();
    if m.len() != n || m.iter().any(|row| row.len() != n) {
        return None;
    }
    if q.iter().all(|q| *q >= 0.0) {
        return Some(vec![0.0; n]);
    }
    let mut tableau = Tableau::new(m, q);
    // Of equals the last: the other rows then stay lexicographically positive.
    let lowest = (0..n).rev().min_by(|&i, &j| q[i].total_cmp(&q[j]))?;
    let mut left = tableau.exchange(lowest, 2 * n);
    for _ in 0..100 * (n + 1) {
        if left == 2 * n {
            return Some(tableau.solution());
        }
        let entering = if left < n { left + n } else { left - n };
        let Some(row) = tableau.leaving(entering) else {
            // A ray along which z₀ has already vanished but for rounding ends in a solution.
            let largest = q.iter().fold(0.0, |s: f64, v| s.max(v.abs()));
            return (tableau.covering() <= LEMKE_COVERED * largest).then(|| tableau.solution());
        };
        left = tableau.exchange(row, entering);
    }
    None
}

/// `I w − M z − 1 z₀ = q`: columns w, z, z₀, q; one row for each basic variable.
struct Tableau {
    n: usize,
    rows: Vec<Vec<f64>>,
    basic: Vec<usize>,
    scale: f64,
}

impl Tableau {
    fn new(m: &[Vec<f64>], q: &[f64]) -> Self {
        let n = q.len();
        let row = |i: usize| {
            let mut row = vec![0.0; 2 * n + 2];
            row[i] = 1.0;
            for (to, from) in row[n..2 * n].iter_mut().zip(&m[i]) {
                *to = -from;
            }
            row[2 * n] = -1.0;
            row[2 * n + 1] = q[i];
            row
        };
        let scale = m.iter().flatten().fold(1.0, |s: f64, v| s.max(v.abs()));
        Self { n, rows: (0..n).map(row).collect(), basic: (0..n).collect(), scale }
    }

    /// Brings a variable into the basis in place of the one of this row, which is returned.
    fn exchange(&mut self, row: usize, entering: usize) -> usize {
        let pivot = self.rows[row][entering];
        self.rows[row].iter_mut().for_each(|v| *v /= pivot);
        let chosen = self.rows[row].clone();
        for (i, other) in self.rows.iter_mut().enumerate() {
            let factor = other[entering];
            if i != row && factor != 0.0 {
                for (v, c) in other.iter_mut().zip(&chosen) {
                    let taken = factor * c;
                    let left = *v - taken;
                    // What cancels is zero: rounding must not decide ties.
                    *v = if left.abs() <= LEMKE_CANCELS * (v.abs() + taken.abs()) { 0.0 } else { left };
                }
                other[entering] = 0.0;
            }
        }
        std::mem::replace(&mut self.basic[row], entering)
    }

    /// The row whose variable reaches zero first as `entering` grows; z₀ before others, else the lexicographically smallest.
    fn leaving(&self, entering: usize) -> Option<usize> {
        let right = 2 * self.n + 1;
        let mut best: Option<usize> = None;
        for i in (0..self.n).filter(|&i| self.rows[i][entering] > PIVOT * self.scale) {
            let better = match best {
                None => true,
                Some(b) => self.before(i, b, entering, right),
            };
            if better {
                best = Some(i);
            }
        }
        best
    }

    fn before(&self, i: usize, j: usize, entering: usize, right: usize) -> bool {
        let ratio = |row: usize, column: usize| self.rows[row][column] / self.rows[row][entering];
        let (a, b) = (ratio(i, right), ratio(j, right));
        let tie = (a - b).abs() <= LEMKE_TIE * (a.abs() + b.abs());
        if !tie {
            return a < b;
        }
        if self.basic[i] == 2 * self.n || self.basic[j] == 2 * self.n {
            return self.basic[i] == 2 * self.n;
        }
        let differs = (0..self.n).find(|&k| ratio(i, k) != ratio(j, k));
        differs.is_some_and(|k| ratio(i, k) < ratio(j, k))
    }

    /// Value of z₀.
    fn covering(&self) -> f64 {
        let row = self.basic.iter().position(|&basic| basic == 2 * self.n);
        row.map_or(0.0, |i| self.rows[i][2 * self.n + 1])
    }

    fn solution(&self) -> Vec<f64> {
        let mut z = vec![0.0; self.n];
        for (row, &basic) in self.rows.iter().zip(&self.basic) {
            if (self.n..2 * self.n).contains(&basic) {
                z[basic - self.n] = row[2 * self.n + 1].max(0.0);
            }
        }
        z
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_textbook_problem_is_solved() {
        // Murty's example: M = [[2, 1], [1, 2]], q = (−5, −6): both positive, z = (4/3, 7/3).
        let z = lemke(&[vec![2.0, 1.0], vec![1.0, 2.0]], &[-5.0, -6.0]).unwrap();
        assert!((z[0] - 4.0 / 3.0).abs() < 1e-14 && (z[1] - 7.0 / 3.0).abs() < 1e-14, "{z:?}");
        // One stays at zero: w₂ = 1·z₁ − 1 = 4 − 1 ≥ 0 for z₁ = 5/2 … with a weak second pull.
        let z = lemke(&[vec![2.0, 0.0], vec![1.0, 2.0]], &[-5.0, -1.0]).unwrap();
        assert_eq!(z, [2.5, 0.0]);
        assert_eq!(lemke(&[vec![1.0]], &[3.0]), Some(vec![0.0]), "nothing to do");
        assert_eq!(lemke(&[vec![-1.0]], &[-3.0]), None, "w = −z − 3 is never positive");
    }
}
