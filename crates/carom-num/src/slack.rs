//! A linear programme of a few variables: the point whose smallest slack is largest.

use crate::tolerance::PIVOT;

/// Pivots after which the present vertex is taken: a guard against rounding that cycles.
const MOST_PIVOTS: usize = 200;

/// A number for each slack of [`Slacks`], and for one more: up to 2 M.
type PerSlack<const M: usize> = [[f64; M]; 2];

/// What a row or a column of the tableau stands for: below M a variable z, free in sign, or, as the last one, the level; from M on the
/// slack of a constraint above the level, not negative.
type Name = usize;

/// Slacks that depend linearly on a few variables: `slack(z)[k] = constant[k] + Σⱼ slope[j][k] z[j]`.
///
/// There is room for M − 1 variables and 2 M − 1 slacks.
///
/// # Example
/// The point deepest inside a triangle with sides 3, 4 and 5 is the centre of its inscribed circle, of radius
/// 1.
/// ```
/// use carom_num::slack::Slacks;
/// let mut distances = Slacks::<3>::of(2);
/// distances.push(0.0, |j| [1.0, 0.0][j]);
/// distances.push(0.0, |j| [0.0, 1.0][j]);
/// distances.push(2.4, |j| [-0.6, -0.8][j]);
/// let (z, radius) = distances.largest_smallest(10.0).unwrap();
/// assert!([z[0], z[1], radius].iter().all(|v| (v - 1.0).abs() < 1e-15));
/// ```
#[derive(Clone, Debug)]
pub struct Slacks<const M: usize> {
    /// A row for each slack, a column for each variable. While the programme is solved: basic quantities as affine functions of the
    /// others, `basic = constant + Σ coefficient · nonbasic`, column by column.
    rows: usize,
    columns: usize,
    coefficient: [PerSlack<M>; M],
    constant: PerSlack<M>,
    basic: [[Name; M]; 2],
    nonbasic: [Name; M],
    /// Largest slope, and at least 1, that of the level.
    steepest: f64,
    /// The level's row: it becomes basic at the start and stays.
    level: usize,
}

impl<const M: usize> Slacks<M> {
    /// No slacks yet, of so many variables.
    ///
    /// # Example
    /// Without slacks there is nothing to maximise.
    /// ```
    /// assert_eq!(carom_num::slack::Slacks::<2>::of(1).largest_smallest(1.0), None);
    /// ```
    pub fn of(variables: usize) -> Self {
        Self {
            rows: 0,
            columns: variables,
            coefficient: [[[0.0; M]; 2]; M],
            constant: [[0.0; M]; 2],
            basic: [std::array::from_fn(|k| M + k), std::array::from_fn(|k| 2 * M + k)],
            nonbasic: std::array::from_fn(|j| j),
            steepest: 1.0,
            level: 0,
        }
    }

    /// Adds a slack; `slope(j)` is that along variable j.
    ///
    /// # Example
    /// z ≥ 1 and z ≤ 4: in the middle both slacks are 1.5.
    /// ```
    /// let mut slacks = carom_num::slack::Slacks::<2>::of(1);
    /// slacks.push(-1.0, |_| 1.0);
    /// slacks.push(4.0, |_| -1.0);
    /// let (z, slack) = slacks.largest_smallest(10.0).unwrap();
    /// assert_eq!((z[0], slack), (2.5, 1.5));
    /// ```
    pub fn push(&mut self, constant: f64, slope: impl Fn(usize) -> f64) {
        let row = self.rows;
        self.rows += 1;
        if let Some(place) = self.constant.as_flattened_mut().get_mut(row) {
            *place = constant;
        }
        for (j, column) in self.coefficient.iter_mut().enumerate().take(self.columns) {
            if let Some(place) = column.as_flattened_mut().get_mut(row) {
                *place = slope(j);
                self.steepest = self.steepest.max(place.abs());
            }
        }
    }

    /// Finds z that makes the smallest slack largest, but not above `cap`, by the simplex method.
    ///
    /// Returns z and that smallest slack; where several z do equally well, one of them. `None` where there is nothing to maximise or it
    /// does not fit. The slacks are solved in place: they are of no use afterwards.
    ///
    /// # Example
    /// z ≥ 1 and z ≤ 0 cannot hold both: at ½ each is missed by ½.
    /// ```
    /// let mut slacks = carom_num::slack::Slacks::<2>::of(1);
    /// slacks.push(-1.0, |_| 1.0);
    /// slacks.push(0.0, |_| -1.0);
    /// let (z, slack) = slacks.largest_smallest(10.0).unwrap();
    /// assert_eq!((z[0], slack), (0.5, -0.5));
    /// ```
    pub fn largest_smallest(&mut self, cap: f64) -> Option<([f64; M], f64)> {
        let fits = self.rows > 0 && self.rows < 2 * M && self.columns < M;
        if !fits {
            return None;
        }
        self.add_level(cap);
        self.start();
        self.free_variables();
        self.climb();
        Some((self.point(), self.constant.as_flattened()[self.level].min(cap)))
    }

    /// Finds z that makes one more quantity largest, `constant + Σⱼ slope(j) z[j]`, but not above `cap`, while no slack is negative, by
    /// the simplex method.
    ///
    /// z = 0 must be a point where no slack is negative: a constant below zero counts as the rounding of zero.
    ///
    /// Returns z and the quantity; `None` where it does not fit. The slacks are solved in place: they are of no use afterwards.
    ///
    /// # Example
    /// Within 0 ≤ z ≤ 4 the quantity 1 − 2 z is largest at 0, and 1 + 2 z at 4.
    /// ```
    /// let mut slacks = carom_num::slack::Slacks::<2>::of(1);
    /// slacks.push(0.0, |_| 1.0);
    /// slacks.push(4.0, |_| -1.0);
    /// let highest = |slope: f64| slacks.clone().highest(1.0, |_| slope, 100.0).map(|(_, most)| most);
    /// assert_eq!((highest(-2.0), highest(2.0)), (Some(1.0), Some(9.0)));
    /// ```
    pub fn highest(
        &mut self,
        constant: f64,
        slope: impl Fn(usize) -> f64,
        cap: f64,
    ) -> Option<([f64; M], f64)> {
        let quantity = self.rows;
        let fits = quantity + 1 < 2 * M && self.columns < M;
        if !fits {
            return None;
        }
        let constants = &mut self.constant.as_flattened_mut()[..quantity];
        constants.iter_mut().for_each(|c| *c = c.max(0.0));
        self.push(constant, slope);
        self.add_level(cap.max(constant));
        // The level is below the quantity alone: it does not press on the slacks.
        self.coefficient[self.columns - 1].as_flattened_mut()[..quantity].fill(0.0);
        self.level = quantity;
        self.pivot(self.level, self.columns - 1);
        self.free_variables();
        self.climb();
        Some((self.point(), self.constant.as_flattened()[self.level]))
    }

    /// Takes the level off every slack, as the last column, and adds the row `cap − level`.
    fn add_level(&mut self, cap: f64) {
        self.constant.as_flattened_mut()[self.rows] = cap;
        self.rows += 1;
        self.coefficient[self.columns].as_flattened_mut()[..self.rows].fill(-1.0);
        self.columns += 1;
    }

    /// Coefficients up to this are zero.
    fn zero(&self) -> f64 {
        PIVOT * self.steepest
    }

    /// Swaps a basic quantity for another.
    fn pivot(&mut self, row: usize, column: usize) {
        let mut pivot_column = self.coefficient[column];
        let p = pivot_column.as_flattened()[row];
        let others = (0..self.columns).filter(|&j| j != column);
        for j in others {
            replace(&mut self.coefficient[j], &pivot_column.as_flattened()[..self.rows], row, p);
        }
        replace(&mut self.constant, &pivot_column.as_flattened()[..self.rows], row, p);
        pivot_column.as_flattened_mut()[..self.rows].iter_mut().for_each(|c| *c *= 1.0 / p);
        pivot_column.as_flattened_mut()[row] = 1.0 / p;
        self.coefficient[column] = pivot_column;
        std::mem::swap(&mut self.basic.as_flattened_mut()[row], &mut self.nonbasic[column]);
    }

    /// Takes the level as high as z = 0 allows: every slack is then at least it.
    fn start(&mut self) {
        let constant = &self.constant.as_flattened()[..self.rows];
        let lowest = (0..self.rows).min_by(|&i, &j| constant[i].total_cmp(&constant[j]));
        self.level = lowest.unwrap_or(0);
        self.pivot(self.level, self.columns - 1);
    }

    /// The slack that reaches zero first as a column grows (`sign` 1) or falls (−1); of several the one with the lowest number, as Bland's
    /// rule wants it.
    fn first_to_vanish(&self, column: usize, sign: f64) -> Option<usize> {
        let (basic, constant) = (self.basic.as_flattened(), self.constant.as_flattened());
        let coefficient = self.coefficient[column].as_flattened();
        let mut best: Option<(usize, f64)> = None;
        for i in (0..self.rows).filter(|&i| basic[i] >= M) {
            let rate = sign * coefficient[i];
            if rate < -self.zero() {
                let way = constant[i].max(0.0) / -rate;
                if best.is_none_or(|(b, w)| way < w || (way == w && basic[i] < basic[b])) {
                    best = Some((i, way));
                }
            }
        }
        best.map(|(i, _)| i)
    }

    /// Moves every z into the basis, where it stays, in the direction in which the level rises.
    fn free_variables(&mut self) {
        for column in 0..self.columns {
            if self.nonbasic[column] >= M {
                continue;
            }
            let rises = if self.coefficient[column].as_flattened()[self.level] >= 0.0 { 1.0 } else { -1.0 };
            let row = self.first_to_vanish(column, rises).or_else(|| self.first_to_vanish(column, -rises));
            if let Some(row) = row {
                self.pivot(row, column);
            }
        }
    }

    /// Lets slacks grow that raise the level, by Bland's rule, until none does.
    fn climb(&mut self) {
        for _ in 0..MOST_PIVOTS {
            let raises = |j: &usize| {
                self.nonbasic[*j] >= M && self.coefficient[*j].as_flattened()[self.level] > self.zero()
            };
            let columns = (0..self.columns).filter(raises);
            let Some(column) = columns.min_by_key(|&j| self.nonbasic[j]) else { return };
            let Some(row) = self.first_to_vanish(column, 1.0) else { return };
            self.pivot(row, column);
        }
    }

    fn point(&self) -> [f64; M] {
        let mut z = [0.0; M];
        let basic = self.basic.as_flattened()[..self.rows].iter().zip(self.constant.as_flattened());
        for (&name, constant) in basic {
            if name + 1 < self.columns {
                z[name] = *constant;
            }
        }
        z
    }
}

/// Puts the basic quantity of `row` in the place of the pivot column's in the terms of one column.
fn replace<const M: usize>(terms: &mut PerSlack<M>, pivot_column: &[f64], row: usize, p: f64) {
    let factor = -terms.as_flattened()[row] / p;
    for (term, c) in terms.as_flattened_mut().iter_mut().zip(pivot_column) {
        *term += factor * c;
    }
    terms.as_flattened_mut()[row] = factor;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::solve_regular;

    /// What a vertex of the programme errs by: pivots of 1e-3 lose some digits.
    const VERTEX: f64 = 1e-10;
    /// Some hundred roundings of numbers of order ten: an error, and a pivot that is none.
    const ROUNDING: f64 = 1e-12;

    #[test]
    fn interval_is_halved() {
        // z ≥ 1 and z ≤ 4: the middle has slack 1.5 at both ends.
        let largest = |h: &[f64]| {
            let mut slacks = Slacks::<2>::of(1);
            h.iter().zip([1.0, -1.0]).for_each(|(h, slope)| slacks.push(*h, |_| slope));
            slacks.largest_smallest(10.0).unwrap()
        };
        let (z, slack) = largest(&[-1.0, 4.0]);
        assert!((z[0] - 2.5).abs() < ROUNDING && (slack - 1.5).abs() < ROUNDING, "{z:?} {slack}");
        // z ≥ 1 and z ≤ 0 cannot both hold: the best violation is reported, not hidden.
        let (_, slack) = largest(&[-1.0, 0.0]);
        assert!((slack + 0.5).abs() < ROUNDING, "{slack}");
        // Only one side bounded: the cap stops it.
        let (z, slack) = largest(&[-1.0]);
        assert!(z[0] >= 11.0 - ROUNDING && slack == 10.0, "{z:?} {slack}");
    }

    /// The largest level among all vertices, one by one: `variables + 1` of the constraints, or the cap, hold with equality.
    fn by_all_vertices(g: &[[f64; 6]], h: &[f64], n: usize, cap: f64) -> f64 {
        let mut best = f64::NEG_INFINITY;
        let m = h.len() + 1;
        for mask in 0..1_u32 << m {
            if mask.count_ones() as usize != n + 1 {
                continue;
            }
            let (mut a, mut b) = ([[0.0; 6]; 6], [0.0; 6]);
            for (row, k) in (0..m).filter(|k| mask >> k & 1 == 1).enumerate() {
                if k < h.len() {
                    a[row][..n].copy_from_slice(&g[k][..n]);
                }
                a[row][n] = if k < h.len() { -1.0 } else { 1.0 };
                b[row] = if k < h.len() { -h[k] } else { cap };
            }
            let Some(x) = solve_regular(a, b, n + 1, ROUNDING) else { continue };
            let slack = |k: usize| h[k] + (0..n).map(|j| g[k][j] * x[j]).sum::<f64>();
            let smallest = (0..h.len()).map(slack).fold(f64::INFINITY, f64::min).min(cap);
            if smallest >= x[n] - 1e-9 {
                best = best.max(smallest);
            }
        }
        best
    }

    /// Numbers in −1…1, half of them coarse: these make ties and degenerate vertices.
    fn numbers(mut state: u64) -> impl FnMut() -> f64 {
        move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            #[expect(clippy::cast_precision_loss, reason = "random bits")]
            let x = (state >> 33) as f64 / f64::from(1_u32 << 30) - 1.0;
            if state & 64 == 0 { (4.0 * x).round() / 4.0 } else { x }
        }
    }

    #[test]
    fn the_highest_is_that_of_all_vertices() {
        let mut random = numbers(7);
        for case in 0..2000 {
            let (n, m) = (1 + case % 3, 3 + case % 6);
            let mut g: Vec<[f64; 6]> = (0..m).map(|_| std::array::from_fn(|_| random())).collect();
            // z = 0 is allowed, sometimes just so; a box around it bounds everything.
            let mut h: Vec<f64> = (0..m).map(|_| random().max(0.0)).collect();
            let aim: [f64; 6] = std::array::from_fn(|_| random());
            let mut slacks = Slacks::<18>::of(n);
            for axis in 0..n {
                for sign in [1.0, -1.0] {
                    g.push(std::array::from_fn(|j| if j == axis { sign } else { 0.0 }));
                    h.push(3.0);
                }
            }
            g.iter().zip(&h).for_each(|(g, h)| slacks.push(*h, |j| g[j]));
            let (z, ours) = slacks.highest(0.5, |j| aim[j], 100.0).unwrap();
            let value = |z: &[f64]| 0.5 + (0..n).map(|j| aim[j] * z[j]).sum::<f64>();
            let slack = |k: usize, z: &[f64]| h[k] + (0..n).map(|j| g[k][j] * z[j]).sum::<f64>();
            assert!((value(&z) - ours).abs() <= VERTEX, "case {case}: {} is reached, {ours} said", value(&z));
            let least = (0..h.len()).map(|k| slack(k, &z)).fold(f64::INFINITY, f64::min);
            assert!(least >= -VERTEX, "case {case}: a slack of {least} at {z:?}");
            // Every vertex: n of the constraints hold with equality.
            let mut best = f64::NEG_INFINITY;
            for mask in (0..1_u32 << h.len()).filter(|mask| mask.count_ones() as usize == n) {
                let (mut a, mut b) = ([[0.0; 6]; 6], [0.0; 6]);
                for (row, k) in (0..h.len()).filter(|k| mask >> k & 1 == 1).enumerate() {
                    a[row][..n].copy_from_slice(&g[k][..n]);
                    b[row] = -h[k];
                }
                let Some(x) = solve_regular(a, b, n, ROUNDING) else { continue };
                if (0..h.len()).all(|k| slack(k, &x) >= -VERTEX) {
                    best = best.max(value(&x));
                }
            }
            assert!((ours - best).abs() <= 1e-9, "case {case}: {ours}, of the vertices {best}");
        }
    }

    #[test]
    fn the_simplex_finds_the_best_of_all_vertices() {
        let mut random = numbers(1);
        for case in 0..2000 {
            let (n, m) = (1 + case % 3, 3 + case % 6);
            let g: Vec<[f64; 6]> = (0..m).map(|_| std::array::from_fn(|_| random())).collect();
            let h: Vec<f64> = (0..m).map(|_| random()).collect();
            let best = by_all_vertices(&g, &h, n, 1.0);
            let mut slacks = Slacks::<6>::of(n);
            g.iter().zip(&h).for_each(|(g, h)| slacks.push(*h, |j| g[j]));
            let (z, ours) = slacks.largest_smallest(1.0).unwrap();
            let at_z = |(g, h): (&[f64; 6], &f64)| h + (0..n).map(|j| g[j] * z[j]).sum::<f64>();
            let reached = g.iter().zip(&h).map(at_z).fold(1.0, f64::min);
            assert!((reached - ours).abs() <= VERTEX, "case {case}: {reached} is reached, {ours} said");
            // Without a vertex nothing bounds z: the level is then found all the same.
            assert!(ours >= best - VERTEX, "case {case}: {ours} {best} {g:?} {h:?}");
            assert!(best == f64::NEG_INFINITY || ours <= best + VERTEX, "case {case}: {ours} {best}");
        }
    }
}
