//! Small dense linear systems, rank-deficient ones included.

/// The solutions of a small linear system: a point, and the directions along which the solution is free.
#[derive(Clone, Copy, Debug)]
pub struct Solutions<const M: usize> {
    /// One solution (free unknowns set to zero).
    pub point: [f64; M],
    /// Directions that leave the equations satisfied.
    pub free: [[f64; M]; M],
    /// How many of `free` count.
    pub freedom: usize,
}

/// Solves the leading n × n part of `a x = b` where it is regular, by elimination with partial pivoting.
///
/// Returns `None` where a pivot falls below `rank_tolerance` times the largest entry of the matrix.
pub fn solve_regular<const M: usize>(
    mut a: [[f64; M]; M],
    mut b: [f64; M],
    n: usize,
    rank_tolerance: f64,
) -> Option<[f64; M]> {
    let floor = rank_tolerance * largest(&a, n);
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
        b.swap(k, p);
        for i in k + 1..n {
            let factor = a[i][k] / a[k][k];
            if factor != 0.0 {
                for j in k + 1..n {
                    a[i][j] -= factor * a[k][j];
                }
                b[i] -= factor * b[k];
            }
        }
    }
    for k in (0..n).rev() {
        for j in k + 1..n {
            b[k] -= a[k][j] * b[j];
        }
        b[k] /= a[k][k];
    }
    Some(b)
}

fn largest<const M: usize>(a: &[[f64; M]; M], n: usize) -> f64 {
    a[..n].iter().flat_map(|row| row[..n].iter()).fold(0.0, |m: f64, v| m.max(v.abs()))
}

/// All solutions of the leading n × n part of `a x = b`, as [`solve_columns`].
pub fn solve_any<const M: usize>(
    a: [[f64; M]; M],
    b: [f64; M],
    n: usize,
    tolerance: f64,
) -> Option<Solutions<M>> {
    let within = |value: f64, i: usize, j: usize| if i < n && j < n { value } else { 0.0 };
    let columns = std::array::from_fn(|j| std::array::from_fn(|i| within(a[i][j], i, j)));
    let right = std::array::from_fn(|i| within(b[i], i, 0));
    solve_columns(columns, right, n, tolerance)
}

/// All solutions of `Σⱼ columns[j] x[j] = right` for the first n columns, by elimination with full pivoting; equations that are not there
/// are rows of zeros.
///
/// Pivots up to `tolerance` times the largest entry count as zero. Returns `None` where the equations contradict each other by more than
/// `tolerance` times the largest entry of `right`.
pub fn solve_columns<const M: usize>(
    mut columns: [[f64; M]; M],
    mut right: [f64; M],
    n: usize,
    tolerance: f64,
) -> Option<Solutions<M>> {
    let magnitude = right.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    // Columns with a pivot come first; a row counts as long as it has none.
    let mut order: [usize; M] = std::array::from_fn(|j| j);
    let (mut pivot_row, mut counts) = ([0; M], [1.0; M]);
    let (mut rank, mut floor) = (0, 0.0);
    while rank < n {
        let (pivot, row, place) = full_pivot(&columns, &order[rank..n], &counts);
        if rank == 0 {
            floor = tolerance * pivot;
        }
        if pivot <= floor {
            break;
        }
        order.swap(rank, rank + place);
        let column = columns[order[rank]];
        for &j in &order[rank + 1..n] {
            clear(&mut columns[j], &column, row);
        }
        clear(&mut right, &column, row);
        (pivot_row[rank], counts[row]) = (row, 0.0);
        rank += 1;
    }
    if right.iter().zip(&counts).any(|(v, counts)| (v * counts).abs() > tolerance * magnitude) {
        return None;
    }
    let mut out = Solutions { point: [0.0; M], free: [[0.0; M]; M], freedom: n - rank };
    for (&j, &row) in order.iter().zip(&pivot_row[..rank]) {
        out.point[j] = right[row];
    }
    for (direction, &k) in out.free.iter_mut().zip(&order[rank..n]) {
        direction[k] = 1.0;
        for (&j, &row) in order.iter().zip(&pivot_row[..rank]) {
            direction[j] = -columns[k][row];
        }
    }
    Some(out)
}

/// The largest entry of these columns in the rows that count: its magnitude, its row, and the place of its column among them. A NaN is not
/// larger than anything.
fn full_pivot<const M: usize>(
    columns: &[[f64; M]; M],
    of: &[usize],
    counts: &[f64; M],
) -> (f64, usize, usize) {
    let mut largest = [0.0; M];
    for &j in of {
        for ((largest, v), counts) in largest.iter_mut().zip(&columns[j]).zip(counts) {
            let v = v.abs() * counts;
            *largest = if v > *largest { v } else { *largest };
        }
    }
    let mut row = 0;
    for i in 1..M {
        if largest[i] > largest[row] {
            row = i;
        }
    }
    let place = of.iter().position(|&j| columns[j][row].abs() == largest[row]);
    (largest[row], row, place.unwrap_or(0))
}

/// Takes the unknown of a pivot's column out of all equations but its own, in which it stays with factor 1.
fn clear<const M: usize>(of: &mut [f64; M], column: &[f64; M], row: usize) {
    let factor = of[row] / column[row];
    for (v, c) in of.iter_mut().zip(column) {
        *v -= c * factor;
    }
    of[row] = factor;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn regular_system_is_solved() {
        let x = solve_regular([[2.0, 1.0], [1.0, 3.0]], [3.0, 5.0], 2, 1e-14).unwrap();
        assert!((x[0] - 0.8).abs() < 1e-15 && (x[1] - 1.4).abs() < 1e-15, "{x:?}");
    }

    #[test]
    fn singular_system_gives_a_line_or_nothing() {
        let a = [[1.0, 2.0], [2.0, 4.0]];
        assert!(solve_regular(a, [1.0, 2.0], 2, 1e-12).is_none(), "rank 1");
        let s = solve_any(a, [1.0, 2.0], 2, 1e-12).unwrap();
        assert_eq!(s.freedom, 1);
        let x: Vec<f64> = (0..2).map(|i| s.point[i] + 3.0 * s.free[0][i]).collect();
        assert!((x[0] + 2.0 * x[1] - 1.0).abs() < 1e-14, "{x:?}");
        assert!(solve_any(a, [1.0, 3.0], 2, 1e-12).is_none(), "contradiction");
    }
}
