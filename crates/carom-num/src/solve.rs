//! Small dense linear systems, rank-deficient ones included.

use crate::Basis;

/// The solutions of a small linear system: a point, and the directions along which the solution is free.
///
/// # Example
/// x + 2 y = 4, twice: along the line that is left, x + 2 y does not change.
/// ```
/// let line = carom_num::solve::solve_any([[1.0, 2.0]; 2], [4.0; 2], 2, 1e-12).unwrap();
/// let left = |x: [f64; 2]| x[0] + 2.0 * x[1];
/// assert_eq!((line.freedom, left(line.point), left(line.free[0])), (1, 4.0, 0.0));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Solutions<const M: usize> {
    /// One solution (free unknowns set to zero).
    pub point: [f64; M],
    /// Directions that leave the equations satisfied.
    pub free: [[f64; M]; M],
    /// How many of `free` count.
    pub freedom: usize,
}

/// What counts as zero where equations may depend on each other.
///
/// # Example
/// x = 1 and x = 1.01 contradict each other, but by less than 5 %.
/// ```
/// use carom_num::solve::{Tolerance, solve_rows};
/// let solve = |t| solve_rows(&mut [[1.0], [1.0]], &mut [1.0, 1.01], 1, t).map(|s| s.point[0]);
/// assert_eq!(solve(Tolerance::of(1e-12)), None);
/// let near = solve(Tolerance { rank: 1e-12, contradiction: 0.05 });
/// assert!(near.is_some_and(|x| (1.0..=1.01).contains(&x)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Pivots up to this times the largest entry.
    pub rank: f64,
    /// What equations that depend on others may contradict them by, times the largest right side.
    pub contradiction: f64,
}

impl Tolerance {
    /// The same bound for rank and contradiction.
    pub const fn of(both: f64) -> Self {
        Self { rank: both, contradiction: both }
    }
}

impl<const M: usize> Solutions<M> {
    /// Makes the directions that count orthonormal, and the point the shortest of all solutions.
    ///
    /// # Limits
    /// The directions must be independent, as [`solve_any`] and [`solve_rows`] leave them.
    ///
    /// # Example
    /// ```
    /// use carom_num::solve::solve_any;
    /// // x + y = 2, twice.
    /// let mut line = solve_any([[1.0; 2]; 2], [2.0; 2], 2, 1e-12).ok_or("contradiction")?;
    /// assert_eq!(line.point, [0.0, 2.0]);
    /// line.shorten();
    /// assert!(line.point.iter().all(|x| (x - 1.0).abs() < 1e-15));
    /// # Ok::<(), &str>(())
    /// ```
    pub fn shorten(&mut self) {
        let mut basis = Basis::NONE;
        for direction in &self.free[..self.freedom] {
            basis.take(*direction, 0.0);
        }
        for axis in basis.axes() {
            let along = dot(&self.point, axis);
            self.point.iter_mut().zip(axis).for_each(|(p, a)| *p -= along * a);
        }
        self.free.iter_mut().zip(basis.axes()).for_each(|(free, axis)| *free = *axis);
    }
}

/// The scalar product.
///
/// # Example
/// ```
/// assert_eq!(carom_num::solve::dot(&[1.0, 2.0], &[3.0, 4.0]), 11.0);
/// ```
pub fn dot<const M: usize>(a: &[f64; M], b: &[f64; M]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// Solves the leading n × n part of `a x = b` where it is regular, by elimination with partial pivoting.
///
/// Returns `None` where a pivot falls below `rank_tolerance` times the largest entry of the matrix. For several right sides see [`Factored`].
///
/// # Example
/// 2 x + y = 4 and x + 3 y = 7.
/// ```
/// use carom_num::solve::solve_regular;
/// assert_eq!(solve_regular([[2.0, 1.0], [1.0, 3.0]], [4.0, 7.0], 2, 1e-14), Some([1.0, 2.0]));
/// assert_eq!(solve_regular([[1.0, 2.0], [2.0, 4.0]], [1.0, 2.0], 2, 1e-14), None, "rank 1");
/// ```
pub fn solve_regular<const M: usize>(
    mut a: [[f64; M]; M],
    mut b: [f64; M],
    n: usize,
    rank_tolerance: f64,
) -> Option<[f64; M]> {
    factor(&mut a, n, rank_tolerance, |k, p| b.swap(k, p))?;
    substitute(&a, &mut b, n);
    Some(b)
}

/// A regular matrix, factored: many right sides cost little each.
///
/// # Example
/// 2 x + y and x + 3 y.
/// ```
/// use carom_num::solve::Factored;
/// let both = Factored::of([[2.0, 1.0], [1.0, 3.0]], 2, 1e-14).unwrap();
/// assert_eq!([[4.0, 7.0], [5.0, 5.0]].map(|right| both.solve(right)), [[1.0, 2.0], [2.0, 1.0]]);
/// assert!(Factored::of([[1.0, 2.0], [2.0, 4.0]], 2, 1e-14).is_none(), "rank 1");
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Factored<const M: usize> {
    parts: [[f64; M]; M],
    /// The row that each row was swapped with, in turn.
    swaps: [usize; M],
    n: usize,
}

impl<const M: usize> Factored<M> {
    /// The leading n × n part of a matrix; `None` where [`solve_regular`] finds it singular.
    pub fn of(mut parts: [[f64; M]; M], n: usize, rank_tolerance: f64) -> Option<Self> {
        let mut swaps = [0; M];
        factor(&mut parts, n, rank_tolerance, |k, p| swaps[k] = p)?;
        Some(Self { parts, swaps, n })
    }

    /// The solution for a right side.
    pub fn solve(&self, mut right: [f64; M]) -> [f64; M] {
        for (k, p) in self.swaps[..self.n].iter().enumerate() {
            right.swap(k, *p);
        }
        substitute(&self.parts, &mut right, self.n);
        right
    }
}

/// Replaces the leading n × n part of a matrix by its triangular factors, the lower one without its diagonal of ones. Tells every pair of rows that it swaps.
fn factor<const M: usize>(
    a: &mut [[f64; M]; M],
    n: usize,
    rank_tolerance: f64,
    mut swapped: impl FnMut(usize, usize),
) -> Option<()> {
    let floor = rank_tolerance * largest(a, n);
    for k in 0..n {
        let mut p = k;
        for i in k + 1..n {
            if a[i][k].abs() > a[p][k].abs() {
                p = i;
            }
        }
        if a[p][k].abs() <= floor {
            return None;
        }
        a.swap(k, p);
        swapped(k, p);
        let (above, below) = a[..n].split_at_mut(k + 1);
        let pivot = &above[k][k..n];
        for row in below {
            let row = &mut row[k..n];
            row[0] /= pivot[0];
            let factor = row[0];
            if factor != 0.0 {
                row[1..].iter_mut().zip(&pivot[1..]).for_each(|(v, p)| *v -= factor * p);
            }
        }
    }
    Some(())
}

/// Solves with the factors of a matrix, whose rows are in the order of the right side.
fn substitute<const M: usize>(a: &[[f64; M]; M], b: &mut [f64; M], n: usize) {
    for i in 1..n {
        let (before, own) = b.split_at_mut(i);
        // One after the other, as elimination would.
        a[i][..i].iter().zip(before).for_each(|(factor, v)| own[0] -= factor * *v);
    }
    for k in (0..n).rev() {
        for j in k + 1..n {
            b[k] -= a[k][j] * b[j];
        }
        b[k] /= a[k][k];
    }
}

fn largest<const M: usize>(a: &[[f64; M]; M], n: usize) -> f64 {
    a[..n].iter().flat_map(|row| row[..n].iter()).fold(0.0, |m: f64, v| m.max(v.abs()))
}

/// All solutions of the leading n × n part of `a x = b`, as [`solve_rows`].
///
/// # Example
/// x + 2 y = 1 and 2 x + 4 y = 2 leave a line, and 2 x + 4 y = 3 leaves nothing.
/// ```
/// use carom_num::solve::solve_any;
/// let solve = |right| solve_any([[1.0, 2.0], [2.0, 4.0]], [1.0, right], 2, 1e-12);
/// assert_eq!(solve(2.0).map(|line| line.freedom), Some(1));
/// assert!(solve(3.0).is_none());
/// ```
pub fn solve_any<const M: usize>(
    mut a: [[f64; M]; M],
    mut b: [f64; M],
    n: usize,
    tolerance: f64,
) -> Option<Solutions<M>> {
    a[..n].iter_mut().for_each(|row| row[n..].fill(0.0));
    solve_rows(&mut a[..n], &mut b[..n], n, Tolerance::of(tolerance))
}

/// All solutions of `Σⱼ rows[i][j] x[j] = right[i]` in the first n unknowns, by elimination with full pivoting.
///
/// There may be more equations than unknowns, or fewer; entries of unknowns that do not count are zero. Both sides are overwritten. Returns
/// `None` where the equations contradict each other by more than is allowed; smaller contradictions are ignored.
///
/// # Example
/// x + y = 3, x − y = 1 and their sum.
/// ```
/// use carom_num::solve::{Tolerance, solve_rows};
/// let mut rows = [[1.0, 1.0], [1.0, -1.0], [2.0, 0.0]];
/// let found = solve_rows(&mut rows, &mut [3.0, 1.0, 4.0], 2, Tolerance::of(1e-12)).unwrap();
/// assert_eq!((found.freedom, found.point), (0, [2.0, 1.0]));
/// ```
pub fn solve_rows<const M: usize>(
    rows: &mut [[f64; M]],
    right: &mut [f64],
    n: usize,
    tolerance: Tolerance,
) -> Option<Solutions<M>> {
    let contradiction = tolerance.contradiction * right.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    // The row that an unknown is found from; rows without unknown come last.
    let mut found_from = [None; M];
    let (mut rank, mut floor) = (0, 0.0);
    while rank < rows.len() {
        let (magnitude, row, column) = largest_entry(&rows[rank..]);
        if rank == 0 {
            floor = tolerance.rank * magnitude;
        }
        if magnitude <= floor {
            break;
        }
        rows.swap(rank, rank + row);
        right.swap(rank, rank + row);
        found_from[column] = Some(rank);
        eliminate(rows, right, rank, column);
        rank += 1;
    }
    let contradicts = right[rank..].iter().any(|v| v.abs() > contradiction);
    (!contradicts).then(|| solutions(rows, right, &found_from[..n]))
}

/// The largest entry: its magnitude, row and column. A NaN is not larger than anything.
fn largest_entry<const M: usize>(rows: &[[f64; M]]) -> (f64, usize, usize) {
    let mut of_column = [0.0; M];
    for row in rows {
        for (m, v) in of_column.iter_mut().zip(row) {
            *m = if v.abs() > *m { v.abs() } else { *m };
        }
    }
    let magnitude = of_column.iter().fold(0.0, |m: f64, v| if *v > m { *v } else { m });
    // Without a branch, which would be hard to foresee.
    let column = (0..M).fold(0, |at, j| if of_column[j] == magnitude { j } else { at });
    let row = (0..rows.len()).fold(0, |at, i| if rows[i][column].abs() == magnitude { i } else { at });
    (magnitude, row, column)
}

/// Clears a column in all rows but that of its pivot.
fn eliminate<const M: usize>(rows: &mut [[f64; M]], right: &mut [f64], pivot: usize, column: usize) {
    let (pivot_row, pivot_right) = (rows[pivot], right[pivot]);
    for (i, (row, right)) in rows.iter_mut().zip(right).enumerate() {
        if i != pivot {
            let factor = row[column] / pivot_row[column];
            row.iter_mut().zip(&pivot_row).for_each(|(v, p)| *v -= factor * p);
            row[column] = 0.0;
            *right -= factor * pivot_right;
        }
    }
}

/// Reads the solutions from rows that are cleared but for their own unknown and those that are free.
fn solutions<const M: usize>(rows: &[[f64; M]], right: &[f64], found_from: &[Option<usize>]) -> Solutions<M> {
    let mut out = Solutions { point: [0.0; M], free: [[0.0; M]; M], freedom: 0 };
    for (free, _) in found_from.iter().enumerate().filter(|(_, row)| row.is_none()) {
        let direction = &mut out.free[out.freedom];
        out.freedom += 1;
        direction[free] = 1.0;
        for (j, k) in found_from.iter().enumerate() {
            if let Some(k) = *k {
                direction[j] = -rows[k][free] / rows[k][j];
            }
        }
    }
    for (point, (j, k)) in out.point.iter_mut().zip(found_from.iter().enumerate()) {
        if let Some(k) = *k {
            *point = right[k] / rows[k][j];
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Between the rounding of these systems and their pivots, which are of order one.
    const RANK: f64 = 1e-12;
    /// Some ten roundings of numbers of order one.
    const ROUNDING: f64 = 1e-14;

    #[test]
    fn regular_system_is_solved() {
        let x = solve_regular([[2.0, 1.0], [1.0, 3.0]], [3.0, 5.0], 2, RANK).unwrap();
        assert!((x[0] - 0.8).abs() < 1e-15 && (x[1] - 1.4).abs() < 1e-15, "{x:?}");
    }

    #[test]
    fn singular_system_gives_a_line_or_nothing() {
        let a = [[1.0, 2.0], [2.0, 4.0]];
        assert!(solve_regular(a, [1.0, 2.0], 2, RANK).is_none(), "rank 1");
        let s = solve_any(a, [1.0, 2.0], 2, RANK).unwrap();
        assert_eq!(s.freedom, 1);
        let x: Vec<f64> = (0..2).map(|i| s.point[i] + 3.0 * s.free[0][i]).collect();
        assert!((x[0] + 2.0 * x[1] - 1.0).abs() < ROUNDING, "{x:?}");
        assert!(solve_any(a, [1.0, 3.0], 2, RANK).is_none(), "contradiction");
    }

    #[test]
    fn the_shortest_solution_is_across_all_directions() {
        // x + 2 y + 2 z = 9, three times: the foot of the plane is (1, 2, 2).
        let mut plane = solve_any([[1.0, 2.0, 2.0]; 3], [9.0; 3], 3, RANK).unwrap();
        plane.shorten();
        let foot = [1.0, 2.0, 2.0];
        assert!(plane.point.iter().zip(foot).all(|(x, f)| (x - f).abs() < ROUNDING), "{plane:?}");
        assert_eq!(plane.freedom, 2, "a plane");
        let [a, b] = [plane.free[0], plane.free[1]];
        let off = [dot(&a, &a) - 1.0, dot(&b, &b) - 1.0, dot(&a, &b), dot(&a, &foot), dot(&b, &foot)];
        assert!(off.iter().all(|x| x.abs() < ROUNDING), "orthonormal, in the plane: {off:?}");
    }

    #[test]
    fn equations_may_be_more_than_unknowns_or_fewer() {
        // x + y = 3, x − y = 1 and their sum.
        let equations = [[1.0, 1.0, 0.0], [1.0, -1.0, 0.0], [2.0, 0.0, 0.0]];
        let (mut rows, mut right) = (equations, [3.0, 1.0, 4.0]);
        let exact = Tolerance::of(RANK);
        let s = solve_rows(&mut rows, &mut right, 2, exact).unwrap();
        assert_eq!((s.freedom, s.point), (0, [2.0, 1.0, 0.0]), "three equations for two unknowns");
        let (mut rows, mut right) = (equations, [3.0, 1.0, 5.0]);
        assert!(solve_rows(&mut rows, &mut right, 2, exact).is_none(), "their sum is 4");
        let (mut rows, mut right) = (equations, [3.0, 1.0, 4.0 + 1e-4]);
        let lenient = Tolerance { contradiction: 1e-3, ..exact };
        let s = solve_rows(&mut rows, &mut right, 2, lenient).unwrap();
        assert!(
            (s.point[0] - 2.0).abs() < 1e-3 && (s.point[1] - 1.0).abs() < 1e-3,
            "nearly their sum: {s:?}"
        );
        let (mut rows, mut right) = ([equations[1]], [1.0]);
        let s = solve_rows(&mut rows, &mut right, 3, exact).unwrap();
        assert_eq!(s.freedom, 2, "one equation for three unknowns");
        let off = |x: &[f64; 3]| x[0] - x[1];
        assert!(off(&s.point) == 1.0 && s.free[..2].iter().all(|d| off(d) == 0.0), "{s:?}");
    }
}
