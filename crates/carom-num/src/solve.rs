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

/// All solutions of the leading n × n part of `a x = b`, by elimination with full pivoting.
///
/// Returns `None` where the equations contradict each other by more than `tolerance` times the largest entry.
pub fn solve_any<const M: usize>(
    mut a: [[f64; M]; M],
    mut b: [f64; M],
    n: usize,
    tolerance: f64,
) -> Option<Solutions<M>> {
    let scale = largest(&a, n);
    let right = b[..n].iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    let mut column: [usize; M] = std::array::from_fn(|i| i);
    let mut rank = 0;
    while rank < n {
        let (p, q) = full_pivot(&a, rank, n);
        if a[p][q].abs() <= tolerance * scale {
            break;
        }
        a.swap(rank, p);
        b.swap(rank, p);
        for row in a.iter_mut().take(n) {
            row.swap(rank, q);
        }
        column.swap(rank, q);
        eliminate(&mut a, &mut b, rank, n);
        rank += 1;
    }
    if b[rank..n].iter().any(|v| v.abs() > tolerance * right) {
        return None;
    }
    let mut out = Solutions { point: [0.0; M], free: [[0.0; M]; M], freedom: n - rank };
    for k in 0..rank {
        out.point[column[k]] = b[k] / a[k][k];
    }
    for (d, direction) in out.free.iter_mut().enumerate().take(n - rank) {
        direction[column[rank + d]] = 1.0;
        for k in 0..rank {
            direction[column[k]] = -a[k][rank + d] / a[k][k];
        }
    }
    Some(out)
}

fn full_pivot<const M: usize>(a: &[[f64; M]; M], from: usize, n: usize) -> (usize, usize) {
    let mut best = (from, from);
    for i in from..n {
        for j in from..n {
            if a[i][j].abs() > a[best.0][best.1].abs() {
                best = (i, j);
            }
        }
    }
    best
}

/// Clears column `k` above and below its pivot.
fn eliminate<const M: usize>(a: &mut [[f64; M]; M], b: &mut [f64; M], k: usize, n: usize) {
    for i in 0..n {
        if i != k && a[i][k] != 0.0 {
            let factor = a[i][k] / a[k][k];
            for j in k..n {
                a[i][j] -= factor * a[k][j];
            }
            a[i][k] = 0.0;
            b[i] -= factor * b[k];
        }
    }
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
