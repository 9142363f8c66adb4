//! Trigonometric equations, and all of their roots on the circle.

use crate::elementary::sin_cos;
use crate::tolerance::{CIRCLE_NARROW, CIRCLE_OVERLAP, CIRCLE_SAME, CIRCLE_ZERO};
use std::f64::consts::{PI, TAU};

/// `f(θ) = constant + cos₁ cos θ + sin₁ sin θ + cos₂ cos 2θ + sin₂ sin 2θ + …`, up to degree D.
///
/// # Example
/// 1 + 2 cos θ + 3 sin θ at θ = 0: its value is 1 + 2, its slope 3.
/// ```
/// use carom_num::circle::Trigonometric;
/// assert_eq!(Trigonometric { constant: 1.0, cos: [2.0], sin: [3.0] }.at(0.0), [3.0, 3.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trigonometric<const D: usize> {
    /// The constant term.
    pub constant: f64,
    /// Coefficients of cos θ, cos 2θ, …
    pub cos: [f64; D],
    /// Coefficients of sin θ, sin 2θ, …
    pub sin: [f64; D],
}

/// Arcs that the circle is first cut into.
const ARCS: u32 = 8;
/// Cuts after which no more roots are looked for: such a function is zero on an arc, but for rounding.
const MOST_CUTS: u32 = 20_000;
/// Where the first arc begins: not where symmetric functions have their roots.
const BEGINNING: f64 = -3.0;

impl<const D: usize> Trigonometric<D> {
    /// The function of this degree that has these values: `f` must be one.
    ///
    /// # Example
    /// cos² θ = ½ + ½ cos 2θ.
    /// ```
    /// use carom_num::circle::Trigonometric;
    /// let f = Trigonometric::<2>::through(|theta| theta.cos() * theta.cos());
    /// let off = [f.constant - 0.5, f.cos[0], f.cos[1] - 0.5, f.sin[0], f.sin[1]];
    /// assert!(off.iter().all(|off| off.abs() < 4.0 * f64::EPSILON));
    /// ```
    pub fn through(mut f: impl FnMut(f64) -> f64) -> Self {
        let mut out = Self { constant: 0.0, cos: [0.0; D], sin: [0.0; D] };
        let samples = 2 * D + 1;
        #[expect(clippy::cast_precision_loss, reason = "small counts")]
        let share = |k: usize| k as f64 / samples as f64;
        for k in 0..samples {
            let value = f(TAU * share(k)) * share(1);
            out.constant += value;
            for d in 0..D {
                let (sin, cos) = sin_cos(TAU * share((d + 1) * k % samples));
                out.cos[d] += 2.0 * value * cos;
                out.sin[d] += 2.0 * value * sin;
            }
        }
        out
    }

    /// Value and slope.
    ///
    /// # Example
    /// sin 2θ at 45° has its maximum.
    /// ```
    /// use carom_num::circle::Trigonometric;
    /// let f = Trigonometric { constant: 0.0, cos: [0.0; 2], sin: [0.0, 1.0] };
    /// let [value, slope] = f.at(45_f64.to_radians());
    /// assert!((value - 1.0).abs() <= f64::EPSILON && slope.abs() <= 2.0 * f64::EPSILON);
    /// ```
    pub fn at(&self, theta: f64) -> [f64; 2] {
        let (s, c) = sin_cos(theta);
        let (mut sin, mut cos, mut degree) = (0.0, 1.0, 0.0);
        let [mut value, mut slope] = [self.constant, 0.0];
        for (a, b) in self.cos.iter().zip(&self.sin) {
            (cos, sin) = (cos * c - sin * s, sin * c + cos * s);
            degree += 1.0;
            value += a * cos + b * sin;
            slope += degree * (b * cos - a * sin);
        }
        [value, slope]
    }

    /// Sums of the magnitudes of the terms of the function, and of its second derivative.
    fn sizes(&self) -> [f64; 2] {
        let (mut size, mut bend, mut degree) = (self.constant.abs(), 0.0, 0.0);
        for (a, b) in self.cos.iter().zip(&self.sin) {
            degree += 1.0;
            let term = (a * a + b * b).sqrt();
            size += term;
            bend += degree * degree * term;
        }
        [size, bend]
    }

    /// Hands every root to `visit`, once around the circle: an arc is dropped only where a bound on the second derivative says that it holds none. A double root
    /// counts once, to about 1e-7. A function that is zero everywhere, or not finite, has none.
    ///
    /// `terms` is the magnitude of what the coefficients were computed from: far below it they are rounding.
    ///
    /// # Example
    /// sin 2θ has four roots.
    /// ```
    /// use carom_num::circle::Trigonometric;
    /// let mut roots = vec![];
    /// Trigonometric { constant: 0.0, cos: [0.0; 2], sin: [0.0, 1.0] }.each_root(1.0, |theta| roots.push(theta));
    /// assert_eq!(roots.len(), 4);
    /// assert!(roots.iter().all(|theta| (2.0 * theta).sin().abs() < 1e-14));
    /// ```
    pub fn each_root(&self, terms: f64, mut visit: impl FnMut(f64)) {
        let [size, bend] = self.sizes();
        if !size.is_finite() || size <= CIRCLE_ZERO * terms {
            return;
        }
        let half = PI / f64::from(ARCS);
        let (mut first, mut last) = (None, f64::NEG_INFINITY);
        let mut once = |theta: f64, near: f64| {
            let first = *first.get_or_insert(theta);
            if theta - last > near && (theta == first || theta - first < TAU - near) {
                visit(theta);
            }
            last = theta;
        };
        let mut cuts = MOST_CUTS;
        for i in 0..ARCS {
            let middle = (2.0 * f64::from(i) + 1.0) * half + BEGINNING;
            self.search((middle, half), bend, &mut cuts, &mut once);
        }
    }

    fn search(
        &self,
        (middle, half): (f64, f64),
        bend: f64,
        cuts: &mut u32,
        visit: &mut impl FnMut(f64, f64),
    ) {
        let [value, slope] = self.at(middle);
        if value.abs() > slope.abs() * half + 0.5 * bend * half * half {
            return;
        }
        if slope.abs() > bend * half {
            // Arcs overlap, lest a root at an end is in none of them.
            let (low, high) = (middle - half - CIRCLE_OVERLAP, middle + half + CIRCLE_OVERLAP);
            if (self.at(low)[0] > 0.0) != (self.at(high)[0] > 0.0) {
                visit(self.between(low, high, slope > 0.0), 4.0 * CIRCLE_OVERLAP);
            }
        } else if half <= CIRCLE_NARROW {
            visit(middle, CIRCLE_SAME);
        } else if *cuts > 0 {
            *cuts -= 1;
            self.search((middle - 0.5 * half, 0.5 * half), bend, cuts, visit);
            self.search((middle + 0.5 * half, 0.5 * half), bend, cuts, visit);
        }
    }

    /// The root on an arc on which the function rises, or falls, all the way: Newton kept in its bracket.
    fn between(&self, mut low: f64, mut high: f64, rises: bool) -> f64 {
        let mut theta = 0.5 * (low + high);
        loop {
            let [value, slope] = self.at(theta);
            if (value > 0.0) == rises {
                high = theta
            } else {
                low = theta
            }
            let newton = theta - value / slope;
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if (next - theta).abs() <= f64::EPSILON * TAU || high - low <= f64::EPSILON * TAU {
                return next;
            }
            theta = next;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Steps of a fine scan of the circle.
    const FINE: u32 = 20_000;

    #[test]
    fn it_finds_every_root_that_a_fine_scan_finds() {
        let mut state = 7_u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            f64::from(u32::try_from(state >> 33).unwrap()) / f64::from(1_u32 << 30) - 1.0
        };
        let mut number = [0; 5];
        for case in 0..500 {
            let f =
                Trigonometric { constant: random(), cos: [random(), random()], sin: [random(), random()] };
            let mut roots = vec![];
            f.each_root(1.0, |theta| roots.push(theta));
            let at = |i: u32| f.at(TAU * f64::from(i) / f64::from(FINE) - PI)[0] > 0.0;
            let changes = (0..FINE).filter(|i| at(*i) != at(*i + 1)).count();
            assert!(
                roots.len() >= changes && roots.len() <= 4,
                "case {case}: {roots:?}, a scan finds {changes}"
            );
            assert!(roots.iter().all(|theta| f.at(*theta)[0].abs() < 2e-14), "case {case}: {roots:?}");
            number[roots.len()] += 1;
        }
        assert!([0, 2, 4].iter().all(|k| number[*k] > 20), "{number:?} have so many roots");
    }

    #[test]
    fn roots_where_the_circle_closes_are_found() {
        // sin(θ − φ) and sin 2(θ − φ), φ at and around the ends of arcs.
        for k in 0..64 {
            for off in [-1e-16, 0.0, 1e-16, 1e-9, 3e-9] {
                let phi = f64::from(k) * PI / 32.0 - 3.0 + off;
                for second in [false, true] {
                    let (s, c) = sin_cos(if second { 2.0 * phi } else { phi });
                    let [a, b] = if second { [[0.0, -s], [0.0, c]] } else { [[-s, 0.0], [c, 0.0]] };
                    let mut roots = vec![];
                    Trigonometric { constant: 0.0, cos: a, sin: b }.each_root(1.0, |theta| roots.push(theta));
                    assert_eq!(roots.len(), if second { 4 } else { 2 }, "{phi}: {roots:?}");
                }
            }
        }
    }

    #[test]
    fn a_function_is_found_from_its_values() {
        let f = Trigonometric { constant: 0.3, cos: [-1.2, 0.0, 0.7], sin: [0.4, 2.0, -0.1] };
        let g = Trigonometric::<3>::through(|theta| f.at(theta)[0]);
        for k in 0..40 {
            let [a, b] = [f, g].map(|f| f.at(f64::from(k) * 0.37));
            assert!((a[0] - b[0]).abs() < 4e-15 && (a[1] - b[1]).abs() < 1e-14, "{k}: {a:?} {b:?}");
        }
    }

    #[test]
    fn a_double_root_counts_once() {
        // 1 − cos θ.
        let mut roots = vec![];
        Trigonometric { constant: 1.0, cos: [-1.0, 0.0], sin: [0.0; 2] }
            .each_root(1.0, |theta| roots.push(theta));
        assert!(roots.len() == 1 && roots[0].abs() < 1e-6, "{roots:?}");
    }
}
