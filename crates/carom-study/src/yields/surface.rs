//! A boundary as a surface of second degree, fitted to places on it.

use carom_num::solve::solve_regular;

/// Coefficients of a fit at most: of six quantities beside the one along which the boundary is located.
const MOST: usize = 28;
/// Places for every coefficient, at least: fewer say too little.
const PLACES: usize = 2;
/// Pivots below this fraction of the largest entry show that the places do not determine the surface: they lie on another one.
const RANK: f64 = 1e-10;
/// Points over which a share is averaged.
const POINTS: u32 = 1 << 13;

/// Where the boundary is along one quantity, over the others.
#[derive(Clone, Debug)]
pub(super) struct Surface {
    coefficients: [f64; MOST],
    /// What lies below it is wanted.
    below: bool,
}

impl Surface {
    /// The surface of least squares through places: (the others, where it is). `None` where there are too many quantities or too few places.
    pub(super) fn through(places: &[(&[f64], f64)], below: bool) -> Option<Self> {
        let count = terms(places.first()?.0)?.1;
        if places.len() < PLACES * count {
            return None;
        }
        let (mut matrix, mut right) = ([[0.0; MOST]; MOST], [0.0; MOST]);
        for (others, place) in places {
            let (term, _) = terms(others)?;
            for i in 0..count {
                right[i] += term[i] * place;
                for j in 0..count {
                    matrix[i][j] += term[i] * term[j];
                }
            }
        }
        Some(Self { coefficients: solve_regular(matrix, right, count, RANK)?, below })
    }

    /// The share of a line that is wanted.
    pub(super) fn share(&self, others: &[f64]) -> f64 {
        let Some((term, count)) = terms(others) else { return 0.0 };
        let place: f64 = (0..count).map(|i| term[i] * self.coefficients[i]).sum();
        let place = place.clamp(0.0, 1.0);
        if self.below { place } else { 1.0 - place }
    }

    /// The share of the whole cube, by a pattern of points that starts somewhere: what the pattern leaves differs from start to start.
    ///
    /// Points: multiples of irrational numbers, by Roberts, *The unreasonable effectiveness of quasirandom sequences* (2018): powers of 1/φ with
    /// `φ^(n + 1) = φ + 1`.
    pub(super) fn mean(&self, start: &[f64]) -> f64 {
        let quantities = start.len();
        let mut phi = 2.0;
        for _ in 0..60 {
            phi = carom_num::elementary::pow(1.0 + phi, 1.0 / (quantities as f64 + 1.0));
        }
        let steps: Vec<f64> =
            (1..=quantities).map(|k| carom_num::elementary::pow(phi, -(k as f64))).collect();
        let mut others = vec![0.0; quantities];
        let sum: f64 = (0..POINTS)
            .map(|number| {
                for ((other, step), start) in others.iter_mut().zip(&steps).zip(start) {
                    *other = (start + f64::from(number) * step).fract();
                }
                self.share(&others)
            })
            .sum();
        sum / f64::from(POINTS)
    }
}

/// 1, every quantity and every product of two, about the middle; and how many. `None` where they are too many.
fn terms(others: &[f64]) -> Option<([f64; MOST], usize)> {
    let mut out = [0.0; MOST];
    let n = others.len();
    let count = 1 + n + n * (n + 1) / 2;
    if count > MOST {
        return None;
    }
    out[0] = 1.0;
    let mut next = 1 + n;
    for i in 0..n {
        let x = others[i] - 0.5;
        out[1 + i] = x;
        for other in &others[i..] {
            out[next] = x * (other - 0.5);
            next += 1;
        }
    }
    Some((out, count))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a failure is a failed test")]

    use super::*;

    #[test]
    fn a_paraboloid_is_met_and_averaged() {
        let place = |u: &[f64]| 0.3 + 0.2 * u[0] + 0.1 * u[1] * u[1] - 0.15 * u[0] * u[1];
        let at = |k: usize| [(0.37 * k as f64).fract(), (0.61 * k as f64).fract()];
        let points: Vec<[f64; 2]> = (1..30).map(at).collect();
        let places: Vec<(&[f64], f64)> = points.iter().map(|u| (&u[..], place(u))).collect();
        let surface = Surface::through(&places, true).unwrap();
        assert!((surface.share(&[0.9, 0.2]) - place(&[0.9, 0.2])).abs() < 1e-12);
        // 0.3 + 0.1 + 0.1/3 − 0.15/4.
        let mean = 0.3 + 0.1 + 0.1 / 3.0 - 0.15 / 4.0;
        for start in [[0.5, 0.5], [0.1, 0.7]] {
            assert!((surface.mean(&start) - mean).abs() < 1e-4, "{}", surface.mean(&start));
        }
        assert!(Surface::through(&places[..8], true).is_none(), "six coefficients from eight places");
    }
}
