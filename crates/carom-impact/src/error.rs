//! Why an impact could not be resolved.

use crate::faults::Faults;
use std::fmt;
use thiserror::Error;

/// Why an impact could not be resolved.
///
/// # Example
/// ```
/// use carom_impact::{Law, planar::single};
/// let ball = single::Contact {
///     w_tt: 3.5, w_tn: 0.0, w_nn: 1.0, slip: 0.0, normal: -2.0, friction: 0.3, restitution: 1.5,
/// };
/// let error = single::resolve(&ball, Law::Poisson).unwrap_err();
/// assert_eq!(error.to_string(), "restitution of contact 0 is 1.5, allowed is 0 to 1");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ImpactError {
    /// More contacts than fit.
    #[error("{count} contacts at once: at most {most} are resolved")]
    TooMany {
        /// Contacts given.
        count: usize,
        /// Contacts that fit.
        most: usize,
    },
    /// A number that no impact can be computed from.
    #[error("{} is {value}, allowed is {allowed}", Of(.quantity, .contact))]
    OutsideDomain {
        /// The contact it belongs to, counted from 0; `None` for the body.
        contact: Option<usize>,
        /// The quantity, in the words of the documentation.
        quantity: &'static str,
        /// Its value.
        value: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// Several such numbers.
    #[error("{0}")]
    Faults(Faults),
    /// Two contacts are one.
    #[error("contacts {first} and {second} coincide: same bodies, same point, same normal")]
    Coincide {
        /// One of them.
        first: usize,
        /// The other.
        second: usize,
    },
    /// The data are finite, but a product of them is not.
    #[error("the numbers of the impact overflow: choose other units")]
    Overflow,
    /// The walk did not end within its budget of stages.
    #[error("the impact did not end within {stages} stages")]
    Unending {
        /// Stages walked.
        stages: usize,
    },
    /// The contacts pass the load around in a circle without end: each round leads back to the same velocities and adds the same impulses.
    /// This happens only where obstacles close in on a body, or where the law never ends restitution.
    #[error(
        "the impact has no end: in rounds of {stages} stages the impulses grow and the velocities return"
    )]
    Circling {
        /// Stages of a round.
        stages: usize,
    },
    /// No hypothesis is consistent, and no contact has a slip that could be stopped first. Or contacts wedge a body so hard that its remaining
    /// motion is smaller than the rounding of their impulses.
    #[error("no consistent motion through the impact: the contacts are jammed")]
    Jammed,
}

/// A quantity, and the contact it belongs to where there is one.
pub(super) struct Of<'a>(pub(super) &'a str, pub(super) &'a Option<usize>);

impl fmt::Display for Of<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.1 {
            Some(contact) => write!(f, "{} of contact {contact}", self.0),
            None => f.write_str(self.0),
        }
    }
}

pub(super) fn outside(
    contact: Option<usize>,
    quantity: &'static str,
    value: f64,
    allowed: &'static str,
) -> ImpactError {
    ImpactError::OutsideDomain { contact, quantity, value, allowed }
}

/// `Ok` if `holds`, else the error. A NaN must make `holds` false.
pub(super) fn require(holds: bool, error: impl FnOnce() -> ImpactError) -> Result<(), ImpactError> {
    if holds { Ok(()) } else { Err(error()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_refusal_names_the_quantity_the_contact_the_value_and_what_is_allowed() {
        let error = outside(Some(1), "restitution", 1.5, "0 to 1");
        assert_eq!(error.to_string(), "restitution of contact 1 is 1.5, allowed is 0 to 1");
        assert_eq!(outside(None, "mass", 0.0, "> 0").to_string(), "mass is 0, allowed is > 0");
    }
}
