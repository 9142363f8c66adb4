//! A step made from states that are known already.

use super::{Step, Vector};
use crate::tolerance::THROUGH_RANK;

impl<V: Vector> Step<V> {
    /// A step whose two ends are known, and four states between at these fractions of it: the polynomial of degree 7 through all of them. `None` where two
    /// fractions are one, or one is an end.
    ///
    /// # Example
    /// t⁷ from 0 to 1, known at four places between.
    /// ```
    /// use carom_num::ode8::Step;
    /// let at = |x: f64| (x, [x.powi(7)]);
    /// let known = [0.2, 0.4, 0.6, 0.8].map(at);
    /// let power = Step::through(([0.0], [0.0]), &known, ([1.0], [7.0]), 1.0).unwrap();
    /// assert!((power.at(0.5)[0] - 1.0 / 128.0).abs() < 1e-14);
    /// assert!(Step::through(([0.0], [0.0]), &[at(0.5); 4], ([1.0], [7.0]), 1.0).is_none());
    /// ```
    pub fn through(
        (start, start_rate): (V, V),
        between: &[(f64, V); 4],
        (end, end_rate): (V, V),
        length: f64,
    ) -> Option<Self> {
        let mut out = Self::between((start, start_rate), (end, end_rate), length);
        let mut matrix = [[0.0; 4]; 4];
        for (row, (x, _)) in matrix.iter_mut().zip(between) {
            let z = 1.0 - x;
            *row = [1.0, *x, x * z, x * x * z].map(|basis| basis * x * x * z * z);
        }
        for i in 0..V::COUNT {
            let rest = between.map(|(x, state)| state.at(i) - out.at(x).at(i));
            let terms = crate::solve::solve_regular(matrix, rest, 4, THROUGH_RANK)?;
            for (dense, term) in out.dense[2..].iter_mut().zip(terms) {
                *dense = V::from_fn(|k| if k == i { term } else { dense.at(k) });
            }
        }
        Some(out)
    }
}
