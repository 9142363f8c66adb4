//! Sobol's points with Owen's scrambling: random points that fill a cube evenly.
//!
//! The mean of a function over the first 2ᵏ points has an error that falls faster than that of random points, for smooth functions almost as
//! 1/N^1.5; scrambling makes each point uniform in the cube, so that the mean is unbiased and repetitions with other seeds tell its error.
//!
//! Source: I. M. Sobol', USSR Computational Mathematics and Mathematical Physics 7 (1967) 86; A. B. Owen, Randomly permuted (t,m,s)-nets and
//! (t,s)-sequences (1995), whose permutations of digits are drawn here from a hash of seed, dimension and the digits before.

mod directions;

use directions::DIRECTIONS;

/// Most dimensions.
///
/// # Example
/// ```
/// use carom_num::sobol::{MOST_DIMENSIONS, Sobol};
/// assert!(Sobol::new(MOST_DIMENSIONS, 1).is_some() && Sobol::new(MOST_DIMENSIONS + 1, 1).is_none());
/// ```
pub const MOST_DIMENSIONS: usize = DIRECTIONS.len() + 1;
/// Binary digits of the sequence: 2³² points before it repeats.
const DIGITS: usize = 32;

/// A scrambled sequence: any of its points is known from its number alone.
///
/// # Example
/// ```
/// use carom_num::sobol::Sobol;
/// let sobol = Sobol::new(2, 7).unwrap();
/// let mean = |axis: usize| (0..256).map(|i| sobol.at(i, axis)).sum::<f64>() / 256.0;
/// assert!((mean(0) - 0.5).abs() < 1e-3 && (mean(1) - 0.5).abs() < 1e-3);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Sobol {
    seed: u64,
    /// A direction number for each digit of a point's number, by dimension.
    directions: Vec<[u32; DIGITS]>,
}

impl Sobol {
    /// A sequence in so many dimensions; `None` for none, or more than [`MOST_DIMENSIONS`].
    ///
    /// # Example
    /// Another seed gives another scrambling of the same sequence.
    /// ```
    /// use carom_num::sobol::Sobol;
    /// let [a, b] = [1, 2].map(|seed| Sobol::new(3, seed).unwrap());
    /// assert!(a.point(5) != b.point(5) && a == Sobol::new(3, 1).unwrap());
    /// assert_eq!(Sobol::new(0, 1), None);
    /// ```
    pub fn new(dimensions: usize, seed: u64) -> Option<Self> {
        let fits = (1..=MOST_DIMENSIONS).contains(&dimensions);
        fits.then(|| Self { seed, directions: (0..dimensions).map(directions_of).collect() })
    }

    /// How many dimensions it has.
    pub fn dimensions(&self) -> usize {
        self.directions.len()
    }

    /// One coordinate of a point, in (0, 1).
    ///
    /// # Limits
    /// Points 2³² apart are equal before they are scrambled.
    ///
    /// # Panics
    /// Never: a dimension that the sequence does not have gives ½.
    ///
    /// # Example
    /// Each eighth of the interval holds one of the first eight points.
    /// ```
    /// let sobol = carom_num::sobol::Sobol::new(2, 7).unwrap();
    /// let mut eighths: Vec<_> = (0..8).map(|i| (8.0 * sobol.at(i, 1)) as u32).collect();
    /// eighths.sort();
    /// assert_eq!(eighths, [0, 1, 2, 3, 4, 5, 6, 7]);
    /// ```
    pub fn at(&self, number: u64, dimension: usize) -> f64 {
        let Some(directions) = self.directions.get(dimension) else { return 0.5 };
        let digits = unscrambled(number, directions);
        scrambled(digits, mixed(self.seed ^ mixed(dimension as u64 + 1)))
    }

    /// A whole point.
    ///
    /// # Example
    /// Each quarter of the square holds one of the first four points.
    /// ```
    /// let sobol = carom_num::sobol::Sobol::new(2, 7).unwrap();
    /// let mut quarters: Vec<_> = (0..4).map(|i| sobol.point(i)).map(|p| (p[0] > 0.5, p[1] > 0.5)).collect();
    /// quarters.sort();
    /// assert_eq!(quarters, [(false, false), (false, true), (true, false), (true, true)]);
    /// ```
    pub fn point(&self, number: u64) -> Vec<f64> {
        (0..self.dimensions()).map(|dimension| self.at(number, dimension)).collect()
    }
}

/// The direction numbers of a dimension, from Sobol's recurrence.
fn directions_of(dimension: usize) -> [u32; DIGITS] {
    let mut v = [0u32; DIGITS];
    let Some(given) = dimension.checked_sub(1).and_then(|k| DIRECTIONS.get(k)) else {
        return std::array::from_fn(|k| 1 << (DIGITS - 1 - k));
    };
    let degree = given.first.len();
    for k in 0..DIGITS {
        v[k] = match given.first.get(k) {
            Some(m) => m << (DIGITS - 1 - k),
            None => {
                let mut next = v[k - degree] ^ (v[k - degree] >> degree);
                for j in 1..degree {
                    if given.inner >> (degree - 1 - j) & 1 == 1 {
                        next ^= v[k - j];
                    }
                }
                next
            }
        };
    }
    v
}

/// The digits of a coordinate, the first one highest.
fn unscrambled(number: u64, directions: &[u32; DIGITS]) -> u32 {
    let mut digits = 0;
    for (k, direction) in directions.iter().enumerate() {
        if number >> k & 1 == 1 {
            digits ^= direction;
        }
    }
    digits
}

/// Owen's scrambling: whether a digit is flipped is drawn anew for each choice of the digits before it. Digits beyond the last are random.
fn scrambled(digits: u32, seed: u64) -> f64 {
    let mut out = 0u64;
    for k in 0..DIGITS {
        let before = u64::from(digits) >> (DIGITS - k);
        // The leading one tells apart prefixes of different lengths.
        let turn = mixed(seed ^ (before | 1 << k).wrapping_mul(0x9e37_79b9_7f4a_7c15)) >> 63;
        out = out << 1 | (u64::from(digits) >> (DIGITS - 1 - k) & 1 ^ turn);
    }
    let rest = mixed(seed ^ u64::from(digits).wrapping_mul(0xd1b5_4a32_d192_ed03)) >> 44;
    #[expect(clippy::cast_precision_loss, reason = "52 digits")]
    let whole = (out << 20 | rest) as f64;
    (whole + 0.5) / 4_503_599_627_370_496.0
}

/// A random number in (0, 1), known from its place alone: what plain Monte Carlo takes where Sobol's points are to be checked.
///
/// # Example
/// The mean of n numbers has the standard deviation 1/√(12 n): here 0.0029.
/// ```
/// use carom_num::sobol::random;
/// let mean = (0..10_000).map(|i| random(1, i, 0)).sum::<f64>() / 1e4;
/// assert!((mean - 0.5).abs() < 4.0 * 0.0029);
/// ```
pub fn random(seed: u64, number: u64, dimension: usize) -> f64 {
    let digits = mixed(mixed(mixed(seed) ^ number) ^ (dimension as u64 + 1)) >> 12;
    #[expect(clippy::cast_precision_loss, reason = "52 digits")]
    let whole = digits as f64;
    (whole + 0.5) / 4_503_599_627_370_496.0
}

/// The finaliser of splitmix64 (Steele, Lea and Flood, 2014): every digit of the result depends on every digit of the argument.
fn mixed(x: u64) -> u64 {
    let x = x.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let x = (x ^ x >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let x = (x ^ x >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ x >> 31
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_points_are_those_of_the_literature() {
        // Joe and Kuo's own first points, taken in the order of the numbers' digits (their listing follows Gray's code).
        let at = |number: u64, dimension: usize| {
            f64::from(unscrambled(number, &directions_of(dimension))) / 4_294_967_296.0
        };
        assert_eq!([at(1, 0), at(1, 1), at(1, 2)], [0.5, 0.5, 0.5]);
        assert_eq!([at(2, 0), at(2, 1), at(2, 2)], [0.25, 0.75, 0.75]);
        assert_eq!([at(3, 0), at(3, 1), at(3, 2)], [0.75, 0.25, 0.25]);
        assert_eq!([at(4, 0), at(4, 1), at(4, 2)], [0.125, 0.625, 0.375]);
    }

    #[test]
    fn every_slice_of_every_dimension_holds_one_point() {
        // A net: of the first 2¹⁰ points each interval of length 2⁻¹⁰ holds one, in every dimension, scrambled too.
        let sobol = Sobol::new(MOST_DIMENSIONS, 3).unwrap();
        for dimension in 0..MOST_DIMENSIONS {
            let mut seen = vec![false; 1024];
            for i in 0..1024 {
                let x = sobol.at(i, dimension);
                assert!(x > 0.0 && x < 1.0);
                seen[(x * 1024.0) as usize] = true;
            }
            assert!(seen.iter().all(|s| *s), "dimension {dimension}");
        }
    }

    #[test]
    fn two_dimensions_fill_squares_evenly() {
        // The first two dimensions are a (0, m, 2)-net: every box of area 2⁻⁸ with sides of powers of two holds one of 2⁸ points.
        let sobol = Sobol::new(2, 11).unwrap();
        for wide in 0..=8 {
            let mut seen = vec![0; 256];
            for i in 0..256 {
                let column = (sobol.at(i, 0) * f64::from(1u32 << wide)) as usize;
                let row = (sobol.at(i, 1) * f64::from(1u32 << (8 - wide))) as usize;
                seen[column * (1 << (8 - wide)) + row] += 1;
            }
            assert!(seen.iter().all(|n| *n == 1), "{wide}");
        }
    }

    #[test]
    fn the_error_of_a_mean_falls_faster_than_that_of_random_points() {
        // ∫ Π (1 + (x − ½)) over five dimensions is 1: 8 scrambles each.
        let error = |n: u64| {
            let of = |seed: u64| {
                let sobol = Sobol::new(5, seed).unwrap();
                let f = |i: u64| (0..5).map(|d| 0.5 + sobol.at(i, d)).product::<f64>();
                (0..n).map(f).sum::<f64>() / n as f64 - 1.0
            };
            ((0..8).map(|seed| of(seed).powi(2)).sum::<f64>() / 8.0).sqrt()
        };
        let slope = (error(4096) / error(64)).log2() / 6.0;
        assert!(slope < -1.0, "{slope}");
    }
}
