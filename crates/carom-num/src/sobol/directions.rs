//! Direction numbers of Sobol's sequence.
//!
//! Source: S. Joe and F. Y. Kuo, Constructing Sobol sequences with better two-dimensional projections, SIAM Journal on Scientific Computing
//! 30 (2008) 2635–2654; their list of criterion D(6), of which these are dimensions 2 to 64.

/// Inner coefficients of a primitive polynomial, and the first direction numbers of its dimension; its degree is their count.
pub(super) struct Directions {
    pub(super) inner: u32,
    pub(super) first: &'static [u32],
}

const fn directions(inner: u32, first: &'static [u32]) -> Directions {
    Directions { inner, first }
}

/// Dimension 2 and those after it; the first has van der Corput's sequence.
pub(super) const DIRECTIONS: [Directions; 63] = [
    directions(0, &[1]),
    directions(1, &[1, 3]),
    directions(1, &[1, 3, 1]),
    directions(2, &[1, 1, 1]),
    directions(1, &[1, 1, 3, 3]),
    directions(4, &[1, 3, 5, 13]),
    directions(2, &[1, 1, 5, 5, 17]),
    directions(4, &[1, 1, 5, 5, 5]),
    directions(7, &[1, 1, 7, 11, 19]),
    directions(11, &[1, 1, 5, 1, 1]),
    directions(13, &[1, 1, 1, 3, 11]),
    directions(14, &[1, 3, 5, 5, 31]),
    directions(1, &[1, 3, 3, 9, 7, 49]),
    directions(13, &[1, 1, 1, 15, 21, 21]),
    directions(16, &[1, 3, 1, 13, 27, 49]),
    directions(19, &[1, 1, 1, 15, 7, 5]),
    directions(22, &[1, 3, 1, 15, 13, 25]),
    directions(25, &[1, 1, 5, 5, 19, 61]),
    directions(1, &[1, 3, 7, 11, 23, 15, 103]),
    directions(4, &[1, 3, 7, 13, 13, 15, 69]),
    directions(7, &[1, 1, 3, 13, 7, 35, 63]),
    directions(8, &[1, 3, 5, 9, 1, 25, 53]),
    directions(14, &[1, 3, 1, 13, 9, 35, 107]),
    directions(19, &[1, 3, 1, 5, 27, 61, 31]),
    directions(21, &[1, 1, 5, 11, 19, 41, 61]),
    directions(28, &[1, 3, 5, 3, 3, 13, 69]),
    directions(31, &[1, 1, 7, 13, 1, 19, 1]),
    directions(32, &[1, 3, 7, 5, 13, 19, 59]),
    directions(37, &[1, 1, 3, 9, 25, 29, 41]),
    directions(41, &[1, 3, 5, 13, 23, 1, 55]),
    directions(42, &[1, 3, 7, 3, 13, 59, 17]),
    directions(50, &[1, 3, 1, 3, 5, 53, 69]),
    directions(55, &[1, 1, 5, 5, 23, 33, 13]),
    directions(56, &[1, 1, 7, 7, 1, 61, 123]),
    directions(59, &[1, 1, 7, 9, 13, 61, 49]),
    directions(62, &[1, 3, 3, 5, 3, 55, 33]),
    directions(14, &[1, 3, 1, 15, 31, 13, 49, 245]),
    directions(21, &[1, 3, 5, 15, 31, 59, 63, 97]),
    directions(22, &[1, 3, 1, 11, 11, 11, 77, 249]),
    directions(38, &[1, 3, 1, 11, 27, 43, 71, 9]),
    directions(47, &[1, 1, 7, 15, 21, 11, 81, 45]),
    directions(49, &[1, 3, 7, 3, 25, 31, 65, 79]),
    directions(50, &[1, 3, 1, 1, 19, 11, 3, 205]),
    directions(52, &[1, 1, 5, 9, 19, 21, 29, 157]),
    directions(56, &[1, 3, 7, 11, 1, 33, 89, 185]),
    directions(67, &[1, 3, 3, 3, 15, 9, 79, 71]),
    directions(70, &[1, 3, 7, 11, 15, 39, 119, 27]),
    directions(84, &[1, 1, 3, 1, 11, 31, 97, 225]),
    directions(97, &[1, 1, 1, 3, 23, 43, 57, 177]),
    directions(103, &[1, 3, 7, 7, 17, 17, 37, 71]),
    directions(115, &[1, 3, 1, 5, 27, 63, 123, 213]),
    directions(122, &[1, 1, 3, 5, 11, 43, 53, 133]),
    directions(8, &[1, 3, 5, 5, 29, 17, 47, 173, 479]),
    directions(13, &[1, 3, 3, 11, 3, 1, 109, 9, 69]),
    directions(16, &[1, 1, 1, 5, 17, 39, 23, 5, 343]),
    directions(22, &[1, 3, 1, 5, 25, 15, 31, 103, 499]),
    directions(25, &[1, 1, 1, 11, 11, 17, 63, 105, 183]),
    directions(44, &[1, 1, 5, 11, 9, 29, 97, 231, 363]),
    directions(47, &[1, 1, 5, 15, 19, 45, 41, 7, 383]),
    directions(52, &[1, 3, 7, 7, 31, 19, 83, 137, 221]),
    directions(55, &[1, 1, 1, 3, 23, 15, 111, 223, 83]),
    directions(59, &[1, 1, 5, 13, 31, 15, 55, 25, 161]),
    directions(62, &[1, 1, 3, 13, 25, 47, 39, 87, 257]),
];
