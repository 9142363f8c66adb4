//! As much of vectors in space as the closed forms need.

/// A vector in space.
pub(crate) type V = [f64; 3];

pub(crate) fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: V, b: V) -> V {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn minus(a: V, b: V) -> V {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(crate) fn times(k: f64, a: V) -> V {
    a.map(|x| k * x)
}

/// The solution of `m x = b` by Cramer's rule; rows of m.
pub(crate) fn solved(m: [V; 3], b: V) -> V {
    let determinant = dot(m[0], cross(m[1], m[2]));
    let column = |j: usize| [m[0][j], m[1][j], m[2][j]];
    let of = |i: usize| {
        let mut columns = [column(0), column(1), column(2)];
        columns[i] = b;
        dot(columns[0], cross(columns[1], columns[2])) / determinant
    };
    [of(0), of(1), of(2)]
}
