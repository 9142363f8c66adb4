//! What a quantity measures, and what values it may have.

use crate::unit::Dimension;
use std::fmt;

/// What values a quantity may have.
///
/// # Example
/// A coefficient of restitution is a fraction, a coefficient of friction need not be one.
/// ```
/// use carom_scene::quantity::Allowed;
/// assert!(!Allowed::Fraction.holds(1.5) && Allowed::NotNegative.holds(1.5));
/// assert_eq!(Allowed::Fraction.to_string(), "must be from 0 to 1");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Allowed {
    /// Any finite number.
    Any,
    /// Above 0.
    Positive,
    /// 0 or more.
    NotNegative,
    /// From 0 to 1.
    Fraction,
    /// From 0° to less than 90°.
    Slope,
    /// A whole number from the first to the second.
    Whole(u32, u32),
    /// Below 0: an approach.
    Negative,
    /// A whole number from 0.
    Face,
    /// 0 or more, computed with to a million: a coefficient of friction.
    Coefficient,
}

impl Allowed {
    /// The closed interval of the values that are allowed, as doubles.
    ///
    /// # Example
    /// What is above 0 begins at the smallest normal number.
    /// ```
    /// use carom_scene::quantity::Allowed;
    /// assert_eq!(Allowed::Fraction.interval(), [0.0, 1.0]);
    /// assert_eq!(Allowed::Positive.interval(), [f64::MIN_POSITIVE, f64::INFINITY]);
    /// ```
    pub fn interval(self) -> [f64; 2] {
        let least = f64::MIN_POSITIVE;
        match self {
            Self::Any => [f64::NEG_INFINITY, f64::INFINITY],
            Self::Positive => [least, f64::INFINITY],
            Self::NotNegative => [0.0, f64::INFINITY],
            Self::Fraction => [0.0, 1.0],
            Self::Slope => [0.0, std::f64::consts::FRAC_PI_2.next_down()],
            Self::Whole(least, most) => [f64::from(least), f64::from(most)],
            Self::Negative => [f64::NEG_INFINITY, -least],
            Self::Face | Self::Coefficient => [0.0, 1e6],
        }
    }

    /// True where `value` is allowed.
    ///
    /// # Example
    /// ```
    /// use carom_scene::quantity::Allowed;
    /// let plates = Allowed::Whole(1, 3);
    /// assert_eq!([0.0, 1.0, 2.5, 3.0].map(|count| plates.holds(count)), [false, true, false, true]);
    /// assert!(!Allowed::Any.holds(f64::NAN));
    /// ```
    pub fn holds(self, value: f64) -> bool {
        value.is_finite()
            && match self {
                Self::Any => true,
                Self::Positive => value > 0.0,
                Self::NotNegative | Self::Coefficient => value >= 0.0,
                Self::Fraction => (0.0..=1.0).contains(&value),
                Self::Slope => (0.0..std::f64::consts::FRAC_PI_2).contains(&value),
                Self::Whole(least, most) => {
                    (f64::from(least)..=f64::from(most)).contains(&value) && value.fract() == 0.0
                }
                Self::Negative => value < 0.0,
                Self::Face => (0.0..=1e6).contains(&value) && value.fract() == 0.0,
            }
    }
}

impl fmt::Display for Allowed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Whole(least, most) => {
                return write!(f, "must be a whole number from {least} to {most}");
            }
            Self::Any => "must be a finite number",
            Self::Positive => "must be above 0",
            Self::NotNegative | Self::Coefficient => "must be 0 or more",
            Self::Fraction => "must be from 0 to 1",
            Self::Slope => "must be from 0 to less than 90 deg",
            Self::Negative => "must be below 0",
            Self::Face => "must be a whole number, 0 or more",
        })
    }
}

/// What a quantity is: its dimension and its allowed values.
///
/// # Example
/// A slope is an angle below 90°.
/// ```
/// use carom_scene::{quantity::{Allowed, Kind}, unit::Dimension};
/// let slope = Kind::new(Dimension::Angle, Allowed::Slope);
/// assert!(slope.allowed.holds(1.5) && !slope.allowed.holds(std::f64::consts::FRAC_PI_2));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Kind {
    /// What it measures.
    pub dimension: Dimension,
    /// What values it may have.
    pub allowed: Allowed,
}

impl Kind {
    /// A kind from its parts.
    ///
    /// # Example
    /// ```
    /// use carom_scene::{quantity::{Allowed, Kind}, unit::Dimension};
    /// let mass = Kind::new(Dimension::Mass, Allowed::Positive);
    /// assert_eq!((mass.dimension.si(), mass.allowed.holds(0.0)), ("kg", false));
    /// ```
    pub const fn new(dimension: Dimension, allowed: Allowed) -> Self {
        Self { dimension, allowed }
    }

    /// The closed interval of the values that are allowed and computed with, SI.
    ///
    /// # Example
    /// ```
    /// use carom_scene::{quantity::{Allowed, Kind}, unit::Dimension};
    /// let speed = Kind::new(Dimension::Speed, Allowed::Positive);
    /// assert_eq!(speed.interval(), [1e-12, 1e6]);
    /// ```
    pub fn interval(self) -> [f64; 2] {
        let ([low, high], [least, most]) = (self.allowed.interval(), self.dimension.sizes());
        let bounded = |end: f64| if end == 0.0 { 0.0 } else { end.signum() * end.abs().clamp(least, most) };
        [bounded(low), bounded(high)]
    }

    /// True where `value` is allowed and of a size that is computed with.
    ///
    /// # Example
    /// ```
    /// use carom_scene::{quantity::{Allowed, Kind}, unit::Dimension};
    /// let speed = Kind::new(Dimension::Speed, Allowed::Any);
    /// assert!(speed.holds(-20.0) && speed.holds(0.0) && !speed.holds(1e200));
    /// ```
    pub fn holds(self, value: f64) -> bool {
        let [low, high] = self.interval();
        self.allowed.holds(value) && (low..=high).contains(&value)
    }

    /// What a value must be that does not hold.
    ///
    /// # Example
    /// ```
    /// use carom_scene::{quantity::{Allowed, Kind}, unit::Dimension};
    /// let length = Kind::new(Dimension::Length, Allowed::Positive);
    /// assert_eq!(length.rule_for(-1.0), "must be above 0");
    /// assert_eq!(length.rule_for(1e200), "must be at most 1000000 m");
    /// assert_eq!(length.rule_for(1e-30), "must be at least 1e-9 mm");
    /// ```
    pub fn rule_for(self, value: f64) -> String {
        let [low, high] = self.interval();
        if !self.allowed.holds(value) {
            self.allowed.to_string()
        } else if value > high {
            format!("must be at most {}", self.dimension.show(high))
        } else {
            format!("must be at least {}", self.dimension.show(low))
        }
    }
}
