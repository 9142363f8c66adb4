//! Integrals by weighted values.

/// Nodes and weights of the Gauss–Legendre rule of eight points on (−1, 1), the positive half; the other half is its mirror image.
///
/// It is exact for polynomials up to degree 15.
///
/// # Source
/// Abramowitz & Stegun (1964), table 25.4, n = 8.
///
/// # Example
/// The integral of x¹⁴ over (−1, 1) is 2/15, and the weights of both halves add up to the length of the interval.
/// ```
/// use carom_num::quadrature::GAUSS_LEGENDRE_8;
/// let sum = |power: i32| 2.0 * GAUSS_LEGENDRE_8.iter().map(|(x, weight)| weight * x.powi(power)).sum::<f64>();
/// assert!((sum(0) - 2.0).abs() < 1e-15 && (sum(14) - 2.0 / 15.0).abs() < 1e-15);
/// ```
pub const GAUSS_LEGENDRE_8: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
];
