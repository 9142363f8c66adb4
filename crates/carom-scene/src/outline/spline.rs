//! B-splines of degree 1 to 3 as Bézier curves.

use super::edge::Edge;
use carom_num::Vec2;

/// A B-spline as a file has it; weights may be missing.
pub(crate) struct Spline {
    pub(crate) degree: usize,
    pub(crate) knots: Vec<f64>,
    pub(crate) points: Vec<Vec2>,
    pub(crate) weights: Vec<f64>,
}

impl Spline {
    /// Its pieces between knots: the curve itself, not an approximation.
    ///
    /// # Errors
    /// In words, why it cannot be one of cubic pieces.
    ///
    /// # Source
    /// L. Ramshaw, "Blossoms are polar forms", Computer Aided Geometric Design 6, 1989, 323–358: a piece's control points are values of the blossom at its ends.
    pub(crate) fn edges(&self) -> Result<Vec<Edge>, String> {
        let (p, n) = (self.degree, self.points.len());
        if !(1..=3).contains(&p) {
            return Err(format!("has degree {p}: only 1, 2 and 3 are read"));
        }
        if n == 0 {
            return Err("has no control points: save it with them, not by its fit points".to_owned());
        }
        if n <= p || self.knots.len() != n + p + 1 {
            let knots = self.knots.len();
            return Err(format!(
                "of degree {p} has {n} control points and {knots} knots: they do not go together"
            ));
        }
        if self.knots.windows(2).any(|pair| pair[1] < pair[0]) {
            return Err("has knots that do not ascend".to_owned());
        }
        let same = |weight: &f64| (weight - self.weights[0]).abs() <= f64::EPSILON * self.weights[0].abs();
        if !self.weights.iter().all(same) {
            return Err("is rational (its weights differ): only splines of equal weights are read".to_owned());
        }
        let spans = (p..n).filter(|i| self.knots[*i] < self.knots[i + 1]);
        let edges: Vec<Edge> = spans.map(|span| self.piece(span)).collect();
        if edges.is_empty() { Err("has no length".to_owned()) } else { Ok(edges) }
    }

    fn piece(&self, span: usize) -> Edge {
        let (a, b) = (self.knots[span], self.knots[span + 1]);
        match self.degree {
            1 => Edge::Line { from: self.blossom(span, &[a]), to: self.blossom(span, &[b]) },
            2 => {
                let [from, middle, to] = [[a, a], [a, b], [b, b]].map(|at| self.blossom(span, &at));
                quadratic(from, middle, to)
            }
            _ => Edge::Cubic([[a, a, a], [a, a, b], [a, b, b], [b, b, b]].map(|at| self.blossom(span, &at))),
        }
    }

    /// The blossom of the piece over a span of knots.
    fn blossom(&self, span: usize, at: &[f64]) -> Vec2 {
        let (p, knots) = (self.degree, &self.knots);
        let mut d: Vec<Vec2> = self.points[span - p..=span].to_vec();
        for r in 1..=p {
            for j in (r..=p).rev() {
                let (left, right) = (knots[span - p + j], knots[span + 1 + j - r]);
                let share = (at[r - 1] - left) / (right - left);
                d[j] = d[j - 1] * (1.0 - share) + d[j] * share;
            }
        }
        d[p]
    }
}

/// A quadratic Bézier curve as a cubic one.
pub(crate) fn quadratic(from: Vec2, middle: Vec2, to: Vec2) -> Edge {
    let third = |end: Vec2| (end + middle * 2.0) / 3.0;
    Edge::Cubic([from, third(from), third(to), to])
}
