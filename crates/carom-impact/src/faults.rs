//! Everything that is wrong with the numbers of an impact, at once.

use crate::ImpactError;
use crate::error::Of;
use std::fmt;

/// Faults that are named; of more, how many there are is told.
const NAMED: usize = 6;
/// Stands for a fault of the body.
const BODY: u8 = u8::MAX;

/// A quantity that an impact is computed from, and what is allowed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Quantity {
    Mass,
    Inertia,
    CentreX,
    CentreY,
    VelocityX,
    VelocityY,
    Spin,
    Normal,
    Arm,
    Point,
    Impulse,
    Body,
    OtherBody,
    Operator,
    Slip,
    NormalVelocity,
    Bound,
    Friction,
    Wtt,
    Wtn,
    Wnn,
    OwnTangential,
    OwnNormal,
    Restitution,
    Determinant,
}

impl Quantity {
    /// Its words, and what is allowed.
    fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Mass => ("mass", "> 0"),
            Self::Inertia => ("inertia", "> 0"),
            Self::CentreX => ("centre x", "a finite number"),
            Self::CentreY => ("centre y", "a finite number"),
            Self::VelocityX => ("velocity x", "a finite number"),
            Self::VelocityY => ("velocity y", "a finite number"),
            Self::Spin => ("spin", "a finite number"),
            Self::Normal => ("length of the normal", "> 0"),
            Self::Arm => ("arm", "finite numbers"),
            Self::Point => ("point", "a finite number"),
            Self::Impulse => ("impulse", "a finite number"),
            Self::Body => ("body", "a body, counted from 0"),
            Self::OtherBody => ("body", "two different bodies"),
            Self::Operator => ("operator", "finite"),
            Self::Slip => ("slip", "finite"),
            Self::NormalVelocity => ("normal velocity", "finite"),
            Self::Bound => ("friction", "finite"),
            Self::Friction => ("friction", ">= 0"),
            Self::Wtt => ("W_tt", "finite"),
            Self::Wtn => ("W_tn", "finite"),
            Self::Wnn => ("W_nn", "finite"),
            Self::OwnTangential => ("W_tt", "> 0"),
            Self::OwnNormal => ("W_nn", "> 0"),
            Self::Restitution => ("restitution", "0 to 1"),
            Self::Determinant => ("W_tt W_nn - W_tn^2", "> 0"),
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Fault {
    value: f64,
    contact: u8,
    quantity: Quantity,
}

impl Fault {
    fn contact(self) -> Option<usize> {
        (self.contact != BODY).then_some(usize::from(self.contact))
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (quantity, allowed) = self.quantity.words();
        write!(f, "{} is {}, allowed is {allowed}", Of(quantity, &self.contact()), self.value)
    }
}

/// Several numbers that no impact can be computed from.
///
/// # Example
/// ```
/// use carom_impact::{ImpactError, planar::ContactSet2};
/// use carom_num::Vec2;
/// let refused = ContactSet2::of_free_body(-1.0, 1.0, Vec2::new(f64::NAN, 0.0), 0.0, &[]).unwrap_err();
/// let ImpactError::Faults(faults) = refused else { panic!("two faults") };
/// assert_eq!(faults.count(), 2);
/// assert_eq!(faults.to_string(), "mass is -1, allowed is > 0; velocity x is NaN, allowed is a finite number");
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Faults {
    named: [Option<Fault>; NAMED],
    count: u32,
}

impl Faults {
    pub(super) const NONE: Self = Self { named: [None; NAMED], count: 0 };

    /// How many there are.
    pub fn count(&self) -> usize {
        self.count as usize
    }

    /// Notes a fault of a contact, or of the body, unless the value `holds`. A NaN must make `holds` false.
    pub(super) fn check(&mut self, holds: bool, contact: Option<usize>, quantity: Quantity, value: f64) {
        if holds {
            return;
        }
        if let Some(place) = self.named.get_mut(self.count as usize) {
            let contact = contact.map_or(BODY, |i| u8::try_from(i).unwrap_or(BODY - 1));
            *place = Some(Fault { value, contact, quantity });
        }
        self.count = self.count.saturating_add(1);
    }

    /// As [`Self::check`] that a number is finite.
    pub(super) fn finite(&mut self, contact: Option<usize>, quantity: Quantity, value: f64) {
        self.check(value.is_finite(), contact, quantity, value);
    }

    /// `Ok` where there are none.
    pub(super) fn refuse(self) -> Result<(), ImpactError> {
        match (self.named[0], self.count) {
            (None, _) => Ok(()),
            (Some(fault), 1) => {
                let (quantity, allowed) = fault.quantity.words();
                let (contact, value) = (fault.contact(), fault.value);
                Err(ImpactError::OutsideDomain { contact, quantity, value, allowed })
            }
            _ => Err(ImpactError::Faults(self)),
        }
    }
}

impl fmt::Display for Faults {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, fault) in self.named.iter().flatten().enumerate() {
            write!(f, "{}{fault}", if i > 0 { "; " } else { "" })?;
        }
        match self.count().saturating_sub(NAMED) {
            0 => Ok(()),
            more => write!(f, "; and {more} more"),
        }
    }
}
