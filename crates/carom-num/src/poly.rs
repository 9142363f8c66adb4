//! Quartic interpolation on an interval, and the certainty that it has no root there; the first root of a parabola.

use crate::tolerance::QUARTIC_ARRIVED;

/// The quartic through five values at the Chebyshev–Lobatto nodes of [0, 1] ([`NODES`]), in the Bernstein basis.
///
/// # Example
/// x⁴ is the last of the Bernstein polynomials, and its highest Chebyshev coefficient on [0, 1] is 1/2⁷.
/// ```
/// use carom_num::poly::{NODES, Quartic};
/// let q = Quartic::through(&NODES.map(|x| x.powi(4)));
/// assert!((q.highest - 1.0 / 128.0).abs() < f64::EPSILON);
/// assert!(q.bernstein[..4].iter().all(|b| b.abs() < 8.0 * f64::EPSILON) && q.bernstein[4] == 1.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quartic {
    /// Bernstein coefficients.
    pub bernstein: [f64; 5],
    /// Magnitude of the highest Chebyshev coefficient: the size of what the interpolant can just resolve.
    pub highest: f64,
}

/// √½.
const S: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// First positive root of `value + rate t − bend t²/2`: for so long a quantity of this value (at least 0) and rate stays positive whose second
/// rate is at least `-bend`. A parabola that does not bend downwards is taken as a line; infinite, or nearly, where that rises.
///
/// # Example
/// Thrown up from 15 m with 10 m/s, a ball is above the ground for 3 s at 10 m/s²: 15 + 10 t − 5 t² = 0.
/// ```
/// assert_eq!(carom_num::poly::first_root(15.0, 10.0, 10.0), 3.0);
/// ```
#[inline]
pub fn first_root(value: f64, rate: f64, bend: f64) -> f64 {
    let bend = bend.max(f64::MIN_POSITIVE);
    let root = (rate * rate + 2.0 * bend * value).sqrt();
    if rate < 0.0 { 2.0 * value / (root - rate) } else { (rate + root) / bend }
}

/// Nodes on [0, 1].
///
/// # Example
/// `xₖ = (1 − cos(k π/4))/2`.
/// ```
/// for (k, x) in carom_num::poly::NODES.into_iter().enumerate() {
///     assert!((1.0 - 2.0 * x - (k as f64 * 45_f64.to_radians()).cos()).abs() <= f64::EPSILON);
/// }
/// ```
pub const NODES: [f64; 5] = [0.0, 0.5 - 0.5 * S, 0.5, 0.5 + 0.5 * S, 1.0];

impl Quartic {
    /// The interpolant of `f` at [`NODES`].
    ///
    /// # Example
    /// A parabola is its own interpolant, without a term of degree 4.
    /// ```
    /// use carom_num::poly::{NODES, Quartic};
    /// let q = Quartic::through(&NODES.map(|x| 3.0 - 2.0 * x + x * x));
    /// assert!((q.at(0.25) - 2.5625).abs() < 8.0 * f64::EPSILON && q.highest < 2.0 * f64::EPSILON);
    /// ```
    pub fn through(f: &[f64; 5]) -> Self {
        // Chebyshev coefficients by the discrete cosine transform, then each T_k in the Bernstein basis of degree 4.
        let c0 = 0.25 * (0.5 * f[0] + f[1] + f[2] + f[3] + 0.5 * f[4]);
        let c1 = 0.5 * (0.5 * (f[4] - f[0]) + S * (f[3] - f[1]));
        let c2 = 0.5 * (0.5 * (f[0] + f[4]) - f[2]);
        let c3 = 0.5 * (0.5 * (f[4] - f[0]) - S * (f[3] - f[1]));
        let c4 = 0.25 * (0.5 * (f[0] + f[4]) - f[1] + f[2] - f[3]);
        let bernstein = [
            f[0],
            c0 - 0.5 * c1 - c2 + 3.5 * c3 - 7.0 * c4,
            c0 - (5.0 / 3.0) * c2 + (35.0 / 3.0) * c4,
            c0 + 0.5 * c1 - c2 - 3.5 * c3 - 7.0 * c4,
            f[4],
        ];
        Self { bernstein, highest: c4.abs() }
    }

    /// A lower bound of the interpolant on [0, 1]: its smallest Bernstein coefficient.
    ///
    /// # Example
    /// For 2 − x the bound is the least value; for (x − ½)², whose least value is 0, it is −1/12.
    /// ```
    /// use carom_num::poly::{NODES, Quartic};
    /// assert_eq!(Quartic::through(&NODES.map(|x| 2.0 - x)).lower_bound(), 1.0);
    /// let square = Quartic::through(&NODES.map(|x| (x - 0.5) * (x - 0.5)));
    /// assert!((square.lower_bound() + 1.0 / 12.0).abs() < f64::EPSILON);
    /// ```
    pub fn lower_bound(&self) -> f64 {
        self.bernstein.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// True where not only the interpolant falls all the way, but any function that differs from it by at most one Chebyshev term of the next
    /// degree, as large as its own highest: such a function has at most one root.
    ///
    /// # Example
    /// ```
    /// use carom_num::poly::{NODES, Quartic};
    /// assert!(Quartic::through(&NODES.map(|x| 1.0 - 2.0 * x)).certainly_falls());
    /// // (x − ½)² rises again.
    /// assert!(!Quartic::through(&NODES.map(|x| (x - 0.5) * (x - 0.5))).certainly_falls());
    /// ```
    pub fn certainly_falls(&self) -> bool {
        // On [0, 1] the slope of T₅ is at most 2 · 5²; that of a quartic is at least 4 times the least difference of its coefficients.
        self.bernstein.windows(2).all(|w| 4.0 * (w[0] - w[1]) > 50.0 * self.highest)
    }

    /// `Some(true)`: the interpolant falls through zero, and so does every function that differs from it by a Chebyshev term of the next degree, at most as large as its own
    /// highest. `Some(false)`: none of them does. `None`: some do.
    ///
    /// # Example
    /// ```
    /// use carom_num::poly::{NODES, Quartic};
    /// let dips = |height: f64| Quartic::through(&NODES.map(|x: f64| (x - 0.5).powi(2) + (x - 0.5).powi(4) + height));
    /// assert_eq!([0.1, 1e-2, -1e-2, -0.1].map(|height| dips(height).surely_falls()), [Some(false), None, None, Some(true)]);
    /// ```
    pub fn surely_falls(&self) -> Option<bool> {
        // That term is T₅ − T₃ on these nodes, where both are equal: |T₅ − T₃| ≤ 2 sin θ |sin 4θ| with 2x − 1 = cos θ, which this polynomial bounds. What starts at zero
        // may start as slowly as a square.
        let room =
            if self.bernstein[0] > 0.0 { [0.0, 8.0, -4.0, 8.0, 0.0] } else { [0.0, 0.0, 4.0, 8.0, 0.0] };
        let moved = |by: f64| {
            let bernstein = std::array::from_fn(|i| self.bernstein[i] + by * self.highest * room[i]);
            Self { bernstein, ..*self }.first_fall().is_some()
        };
        if moved(1.0) { Some(true) } else { (!moved(-1.0)).then_some(false) }
    }

    /// Value at `x` in [0, 1] (de Casteljau).
    ///
    /// # Example
    /// ```
    /// use carom_num::poly::{NODES, Quartic};
    /// assert!((Quartic::through(&NODES.map(|x| x.powi(4))).at(0.5) - 0.0625).abs() < 4.0 * f64::EPSILON);
    /// ```
    pub fn at(&self, x: f64) -> f64 {
        let mut b = self.bernstein;
        for last in (1..5).rev() {
            for i in 0..last {
                b[i] += x * (b[i + 1] - b[i]);
            }
        }
        b[0]
    }

    /// Where the interpolant falls through zero first, to about 1e-9 of the interval: none is passed over. `None` where it stays positive after its start; a start at or
    /// below zero counts once it falls further. `None` as well where a value is not finite.
    ///
    /// # Example
    /// ```
    /// use carom_num::poly::{NODES, Quartic};
    /// let first = Quartic::through(&NODES.map(|x| (x - 0.25) * (x - 0.75))).first_fall().unwrap();
    /// assert!((first - 0.25).abs() < 1e-8, "it rises at 0.75");
    /// assert_eq!(Quartic::through(&NODES.map(|x| 1.0 + x)).first_fall(), None);
    /// ```
    pub fn first_fall(&self) -> Option<f64> {
        if !self.bernstein.iter().all(|c| c.is_finite()) {
            return None;
        }
        first_fall(&self.bernstein, 0.0, 1.0, 0)
    }
}

/// Halvings after which a root is narrow enough to be polished.
const MOST_HALVINGS: u32 = 30;

/// The first fall of a Bernstein polynomial on [a, b]: halves are dropped once all their coefficients are positive.
fn first_fall(bernstein: &[f64; 5], a: f64, b: f64, depth: u32) -> Option<f64> {
    if bernstein[1..].iter().all(|c| *c > 0.0) {
        return None;
    }
    if bernstein[0] > 0.0 && bernstein[4] <= 0.0 && bernstein.windows(2).all(|w| w[1] < w[0]) {
        return Some(a + (b - a) * monotone_root(bernstein));
    }
    let middle = 0.5 * (a + b);
    if depth == MOST_HALVINGS {
        return (bernstein[4] <= 0.0).then_some(middle);
    }
    let (left, right) = halves(bernstein);
    first_fall(&left, a, middle, depth + 1).or_else(|| first_fall(&right, middle, b, depth + 1))
}

/// The root of a Bernstein polynomial that falls all the way from above zero to below it: Newton kept in its bracket.
fn monotone_root(bernstein: &[f64; 5]) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    let mut x = bernstein[0] / (bernstein[0] - bernstein[4]);
    for _ in 0..8 {
        let (value, slope) = value_and_slope(bernstein, x);
        if value > 0.0 {
            low = x;
        } else {
            high = x;
        }
        let newton = x - value / slope;
        // Where it has arrived it may stand on an end of its bracket.
        if (newton - x).abs() < QUARTIC_ARRIVED {
            return newton.clamp(0.0, 1.0);
        }
        x = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
    }
    x
}

fn value_and_slope(bernstein: &[f64; 5], x: f64) -> (f64, f64) {
    let mut b = *bernstein;
    let mut slope = 0.0;
    for last in (1..5).rev() {
        slope = b[1] - b[0];
        for i in 0..last {
            b[i] += x * (b[i + 1] - b[i]);
        }
    }
    (b[0], 4.0 * slope)
}

/// De Casteljau's halving.
fn halves(bernstein: &[f64; 5]) -> ([f64; 5], [f64; 5]) {
    let (mut left, mut right) = ([0.0; 5], *bernstein);
    for i in 0..5 {
        left[i] = right[0];
        for j in 0..4 - i {
            right[j] = 0.5 * (right[j] + right[j + 1]);
        }
    }
    (left, right)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quartic_is_reproduced() {
        let f = |x: f64| 1.0 - 3.0 * x + 2.0 * x * x - 0.5 * x.powi(3) + 7.0 * x.powi(4);
        let q = Quartic::through(&NODES.map(f));
        for i in 0..=20 {
            let x = f64::from(i) / 20.0;
            assert!((q.at(x) - f(x)).abs() < 1e-14, "{x}: {} {}", q.at(x), f(x));
        }
        assert!(
            q.lower_bound() <= NODES.map(f).into_iter().fold(f64::INFINITY, f64::min),
            "bound is a bound"
        );
    }

    /// Newton's method may meet the root of a line to the last digit, and stand on an end of its bracket then.
    #[test]
    fn the_fall_of_a_line_is_its_root() {
        for k in 1..1000 {
            let root = f64::from(k) / 1000.0;
            let found = Quartic::through(&NODES.map(|x| root - x)).first_fall().unwrap();
            assert!((found - root).abs() < 1e-9, "{found} is not {root}");
        }
    }

    #[test]
    fn first_fall_is_the_first_root() {
        // Roots at 0.25 and 0.75.
        let q = Quartic::through(&NODES.map(|x| (x - 0.25) * (x - 0.75)));
        assert!((q.first_fall().unwrap() - 0.25).abs() < 1e-8, "{:?}", q.first_fall());
        assert!(Quartic::through(&NODES.map(|x| 1.0 + x)).first_fall().is_none(), "no root");
        // Two roots close together are not stepped over, and a start at zero that rises is no fall.
        let close = Quartic::through(&NODES.map(|x| (x - 0.26) * (x - 0.30)));
        assert!((close.first_fall().unwrap() - 0.26).abs() < 1e-8, "{:?}", close.first_fall());
        assert!(Quartic::through(&NODES.map(|x| x * (1.0 + x))).first_fall().is_none(), "rises from zero");
    }
}
