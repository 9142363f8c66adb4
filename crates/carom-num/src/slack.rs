//! A linear programme of a few variables: the point whose smallest slack is largest.

/// Most constraints of one programme.
pub const MOST_CONSTRAINTS: usize = 24;
/// Pivots below this fraction of the largest coefficient are zero.
const PIVOT: f64 = 1e-11;
/// Pivots after which the present vertex is taken: a guard against rounding that cycles.
const MOST_PIVOTS: usize = 200;

/// Finds z that makes the smallest of `slack(z)[k] = h[k] + Σⱼ g[k][j] z[j]` largest, but not above `cap`, by the simplex method.
///
/// For up to M − 1 variables and [`MOST_CONSTRAINTS`] − 1 constraints. Returns z and that smallest slack; where several z do equally
/// well, one of them. `None` where there is nothing to maximise or it does not fit.
pub fn largest_smallest_slack<const M: usize>(
    g: &[[f64; M]],
    h: &[f64],
    variables: usize,
    cap: f64,
) -> Option<([f64; M], f64)> {
    if h.is_empty() || h.len() + 1 > MOST_CONSTRAINTS || variables + 1 > M {
        return None;
    }
    let mut tableau = Tableau::new(g, h, variables, cap);
    tableau.start();
    tableau.free_variables();
    tableau.climb();
    let z = tableau.point();
    let slack = |row: &[f64; M], h: f64| h + (0..variables).map(|j| row[j] * z[j]).sum::<f64>();
    let smallest = g.iter().zip(h).map(|(row, h)| slack(row, *h)).fold(f64::INFINITY, f64::min);
    Some((z, smallest.min(cap)))
}

/// What a row or a column of the tableau stands for.
#[derive(Clone, Copy, PartialEq)]
enum Name {
    /// A variable z, free in sign; the last one is the level.
    Free(usize),
    /// The slack of a constraint above the level, not negative.
    Slack(usize),
}

/// Basic quantities as affine functions of the others: `basic = constant + Σ coefficient · nonbasic`.
struct Tableau<const M: usize> {
    rows: usize,
    columns: usize,
    coefficient: [[f64; M]; MOST_CONSTRAINTS],
    constant: [f64; MOST_CONSTRAINTS],
    basic: [Name; MOST_CONSTRAINTS],
    nonbasic: [Name; M],
    /// Largest coefficient at the start.
    scale: f64,
}

impl<const M: usize> Tableau<M> {
    /// Rows: `slack − level` of every constraint, and `cap − level`. Columns: z and the level.
    fn new(g: &[[f64; M]], h: &[f64], variables: usize, cap: f64) -> Self {
        let mut out = Self {
            rows: h.len() + 1,
            columns: variables + 1,
            coefficient: [[0.0; M]; MOST_CONSTRAINTS],
            constant: [0.0; MOST_CONSTRAINTS],
            basic: std::array::from_fn(Name::Slack),
            nonbasic: std::array::from_fn(Name::Free),
            scale: 1.0,
        };
        for (k, (row, h)) in g.iter().zip(h).enumerate() {
            out.coefficient[k][..variables].copy_from_slice(&row[..variables]);
            out.constant[k] = *h;
        }
        out.constant[h.len()] = cap;
        for row in &mut out.coefficient[..out.rows] {
            row[variables] = -1.0;
            out.scale = row.iter().fold(out.scale, |m, c| m.max(c.abs()));
        }
        out
    }

    /// Swaps a basic quantity for another.
    fn pivot(&mut self, row: usize, column: usize) {
        let p = self.coefficient[row][column];
        for j in 0..self.columns {
            self.coefficient[row][j] = if j == column { 1.0 / p } else { -self.coefficient[row][j] / p };
        }
        self.constant[row] = -self.constant[row] / p;
        let (pivot_row, pivot_constant) = (self.coefficient[row], self.constant[row]);
        for i in (0..self.rows).filter(|&i| i != row) {
            let factor = self.coefficient[i][column];
            if factor == 0.0 {
                continue;
            }
            for (j, p) in pivot_row.iter().enumerate().take(self.columns) {
                let own = if j == column { 0.0 } else { self.coefficient[i][j] };
                self.coefficient[i][j] = own + factor * p;
            }
            self.constant[i] += factor * pivot_constant;
        }
        std::mem::swap(&mut self.basic[row], &mut self.nonbasic[column]);
    }

    /// Takes the level as high as z = 0 allows: every slack is then at least it.
    fn start(&mut self) {
        let lowest = (0..self.rows).min_by(|&i, &j| self.constant[i].total_cmp(&self.constant[j]));
        self.pivot(lowest.unwrap_or(0), self.columns - 1);
    }

    fn is_free(name: Name) -> bool {
        matches!(name, Name::Free(_))
    }

    /// The level's row: it became basic at the start and stays.
    fn level(&self) -> usize {
        (0..self.rows).find(|&i| self.basic[i] == Name::Free(self.columns - 1)).unwrap_or(0)
    }

    /// The slack that reaches zero first as a column grows (`sign` 1) or falls (−1).
    fn first_to_vanish(&self, column: usize, sign: f64) -> Option<usize> {
        let mut best: Option<(usize, f64)> = None;
        for i in (0..self.rows).filter(|&i| !Self::is_free(self.basic[i])) {
            let rate = sign * self.coefficient[i][column];
            if rate < -PIVOT * self.scale {
                let way = self.constant[i].max(0.0) / -rate;
                let better = best.is_none_or(|(b, w)| way < w || (way == w && self.before(i, b)));
                if better {
                    best = Some((i, way));
                }
            }
        }
        best.map(|(i, _)| i)
    }

    /// Bland's order of the basic slacks.
    fn before(&self, i: usize, j: usize) -> bool {
        match (self.basic[i], self.basic[j]) {
            (Name::Slack(a), Name::Slack(b)) => a < b,
            _ => false,
        }
    }

    /// Moves every z into the basis, where it stays, in the direction in which the level rises.
    fn free_variables(&mut self) {
        for column in 0..self.columns {
            if !Self::is_free(self.nonbasic[column]) {
                continue;
            }
            let rises = if self.coefficient[self.level()][column] >= 0.0 { 1.0 } else { -1.0 };
            let row = self.first_to_vanish(column, rises).or_else(|| self.first_to_vanish(column, -rises));
            if let Some(row) = row {
                self.pivot(row, column);
            }
        }
    }

    /// Lets slacks grow that raise the level, by Bland's rule, until none does.
    fn climb(&mut self) {
        for _ in 0..MOST_PIVOTS {
            let level = self.level();
            let raises = |j: &usize| {
                !Self::is_free(self.nonbasic[*j]) && self.coefficient[level][*j] > PIVOT * self.scale
            };
            let number = |j: &usize| match self.nonbasic[*j] {
                Name::Slack(k) => k,
                Name::Free(_) => usize::MAX,
            };
            let Some(column) = (0..self.columns).filter(raises).min_by_key(number) else { return };
            let Some(row) = self.first_to_vanish(column, 1.0) else { return };
            self.pivot(row, column);
        }
    }

    fn point(&self) -> [f64; M] {
        let mut z = [0.0; M];
        for i in 0..self.rows {
            if let Name::Free(k) = self.basic[i]
                && k + 1 < self.columns
            {
                z[k] = self.constant[i];
            }
        }
        z
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::solve_regular;

    #[test]
    fn interval_is_halved() {
        // z ≥ 1 and z ≤ 4: the middle has slack 1.5 at both ends.
        let g = [[1.0, 0.0], [-1.0, 0.0]];
        let (z, slack) = largest_smallest_slack(&g, &[-1.0, 4.0], 1, 10.0).unwrap();
        assert!((z[0] - 2.5).abs() < 1e-12 && (slack - 1.5).abs() < 1e-12, "{z:?} {slack}");
        // z ≥ 1 and z ≤ 0 cannot both hold: the best violation is reported, not hidden.
        let (_, slack) = largest_smallest_slack(&g, &[-1.0, 0.0], 1, 10.0).unwrap();
        assert!((slack + 0.5).abs() < 1e-12, "{slack}");
        // Only one side bounded: the cap stops it.
        let (z, slack) = largest_smallest_slack(&g[..1], &[-1.0], 1, 10.0).unwrap();
        assert!(z[0] >= 11.0 - 1e-12 && slack == 10.0, "{z:?} {slack}");
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
            let Some(x) = solve_regular(a, b, n + 1, 1e-12) else { continue };
            let slack = |k: usize| h[k] + (0..n).map(|j| g[k][j] * x[j]).sum::<f64>();
            let smallest = (0..h.len()).map(slack).fold(f64::INFINITY, f64::min).min(cap);
            if smallest >= x[n] - 1e-9 {
                best = best.max(smallest);
            }
        }
        best
    }

    #[test]
    fn the_simplex_finds_the_best_of_all_vertices() {
        let mut state = 1_u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            #[expect(clippy::cast_precision_loss, reason = "random bits")]
            let x = (state >> 33) as f64 / f64::from(1_u32 << 30) - 1.0;
            // Coarse numbers make ties and degenerate vertices.
            if state & 64 == 0 { (4.0 * x).round() / 4.0 } else { x }
        };
        for case in 0..2000 {
            let (n, m) = (1 + case % 3, 3 + case % 6);
            let g: Vec<[f64; 6]> = (0..m).map(|_| std::array::from_fn(|_| random())).collect();
            let h: Vec<f64> = (0..m).map(|_| random()).collect();
            let best = by_all_vertices(&g, &h, n, 1.0);
            let (_, ours) = largest_smallest_slack(&g, &h, n, 1.0).unwrap();
            // Without a vertex nothing bounds z: the level is then found all the same.
            assert!(ours >= best - 1e-10, "case {case}: {ours} {best} {g:?} {h:?}");
            assert!(best == f64::NEG_INFINITY || ours <= best + 1e-10, "case {case}: {ours} {best}");
        }
    }
}
