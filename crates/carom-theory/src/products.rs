//! Sums of products with one or two roundings, so that a difference of nearly equal products keeps its digits.

/// `a·b + c`, rounded once, the same on every machine.
pub(crate) fn product_plus(a: f64, b: f64, c: f64) -> f64 {
    libm::fma(a, b, c)
}

/// `a·b − c·d` within 1.5 units in the last place.
///
/// Source: Kahan; error bound by Jeannerod, Louvet and Muller, Math. Comp. 82 (2013) 2245.
pub(crate) fn difference_of_products(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let cd = c * d;
    let lost = libm::fma(c, d, -cd);
    libm::fma(a, b, -cd) - lost
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_difference_of_products_keeps_the_digits_that_plain_arithmetic_loses() {
        let tiny = f64::EPSILON;
        let (a, b) = (1.0 + tiny, 1.0 - tiny);
        assert_eq!(difference_of_products(a, b, 1.0, 1.0), -tiny * tiny, "(1+ε)(1−ε) − 1 = −ε²");
        assert_ne!(a * b - 1.0, -tiny * tiny, "plain arithmetic has no digit left");
        assert_eq!(product_plus(a, b, -1.0), -tiny * tiny, "one rounding");
    }
}
