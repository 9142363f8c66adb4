//! What a closed form says when it is asked outside the domain it was derived for.

use std::error::Error;
use std::fmt;

/// A quantity lies outside the domain in which a closed form holds.
///
/// # Example
/// ```
/// use carom_theory::bouncing::Drop;
/// let error = Drop { height: 5.0, gravity: 10.0, restitution: 1.5 }.check().expect_err("e is above 1");
/// assert_eq!(error.to_string(), "restitution is 1.5, allowed is 0 <= e <= 1");
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutsideDomain {
    /// The quantity, in the words of the documentation.
    pub quantity: &'static str,
    /// Its value.
    pub value: f64,
    /// What is allowed.
    pub allowed: &'static str,
}

impl fmt::Display for OutsideDomain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} is {}, allowed is {}", self.quantity, self.value, self.allowed)
    }
}

impl Error for OutsideDomain {}

/// `Ok` if `holds`, else the error that names the quantity. A NaN must make `holds` false.
pub(crate) fn require(
    holds: bool,
    quantity: &'static str,
    value: f64,
    allowed: &'static str,
) -> Result<(), OutsideDomain> {
    if holds { Ok(()) } else { Err(OutsideDomain { quantity, value, allowed }) }
}

/// `Ok` if the value is finite and greater than zero.
pub(crate) fn require_positive(quantity: &'static str, value: f64) -> Result<(), OutsideDomain> {
    require(value > 0.0 && value.is_finite(), quantity, value, "finite and > 0")
}

/// `Ok` if the value is finite and not negative.
pub(crate) fn require_not_negative(quantity: &'static str, value: f64) -> Result<(), OutsideDomain> {
    require(value >= 0.0 && value.is_finite(), quantity, value, "finite and >= 0")
}

/// `Ok` if the value is finite.
pub(crate) fn require_finite(quantity: &'static str, value: f64) -> Result<(), OutsideDomain> {
    require(value.is_finite(), quantity, value, "finite")
}
