//! Quantities: a number, its unit, its tolerance and what is allowed.

mod allowed;

pub use allowed::{Allowed, Kind};

use crate::unit::{Dimension, Unit};
use std::ops::Range;

/// How far a quantity may be from its middle, SI.
///
/// # Example
/// Limits of ±0.5 in 15, and a tenth of 0.15.
/// ```
/// use carom_scene::{quantity::{Tolerance, parse}, unit::Dimension};
/// let half = |text, dimension| parse(text, dimension).ok().and_then(|written| written.tolerance);
/// assert_eq!(half("15 ± 0.5 mm", Dimension::Length), Some(Tolerance::Limits { half_width: 0.0005 }));
/// assert_eq!(half("2 ± 25 %", Dimension::Number), Some(Tolerance::Limits { half_width: 0.5 }));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tolerance {
    /// Limits ± `half_width` of a normal distribution with σ = `half_width`/3, cut at the limits.
    Limits {
        /// Half the distance of the limits.
        half_width: f64,
    },
    /// A normal distribution.
    Sigma {
        /// Its standard deviation.
        sigma: f64,
    },
    /// Every value between two is equally likely.
    Uniform {
        /// The lowest value.
        low: f64,
        /// The highest value.
        high: f64,
    },
}

/// A quantity of a scene.
///
/// # Example
/// Ends that are written move with the middle.
/// ```
/// use carom_scene::quantity::{Allowed, Kind, Quantity, Tolerance};
/// use carom_scene::unit::Dimension;
/// let kind = Kind::new(Dimension::Length, Allowed::Positive);
/// let tolerance = Some(Tolerance::Uniform { low: 0.25, high: 0.75 });
/// let mut width = Quantity { tolerance, ..Quantity::default_of(0.5, kind) };
/// width.move_to(1.5);
/// assert_eq!(width.tolerance, Some(Tolerance::Uniform { low: 1.25, high: 1.75 }));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// Its value, or the middle of its tolerance, SI.
    pub value: f64,
    /// What it is.
    pub kind: Kind,
    /// Its tolerance, where one is written.
    pub tolerance: Option<Tolerance>,
    /// Where it stands in the file; `None` for a default.
    pub span: Option<Range<usize>>,
}

impl Quantity {
    /// Gives it another value, or middle: its tolerance moves with it.
    ///
    /// # Example
    /// The middle moves, the limits about it stay as wide.
    /// ```
    /// use carom_scene::quantity::{Allowed, Kind, Quantity, Tolerance};
    /// use carom_scene::unit::Dimension;
    /// let kind = Kind::new(Dimension::Length, Allowed::Positive);
    /// let limits = Some(Tolerance::Limits { half_width: 0.1 });
    /// let mut width = Quantity { tolerance: limits, ..Quantity::default_of(0.5, kind) };
    /// width.move_to(0.7);
    /// assert_eq!((width.value, width.tolerance), (0.7, limits));
    /// ```
    pub fn move_to(&mut self, value: f64) {
        self.tolerance = self.tolerance.map(|tolerance| tolerance.moved(value - self.value));
        self.value = value;
    }

    /// The value below which this share of all values lies: its own where it has no tolerance.
    ///
    /// # Example
    /// ```
    /// use carom_scene::quantity::{Allowed, Kind, Quantity, Tolerance};
    /// use carom_scene::unit::Dimension;
    /// let kind = Kind::new(Dimension::Length, Allowed::Positive);
    /// let tolerance = Some(Tolerance::Uniform { low: 0.25, high: 0.75 });
    /// let width = Quantity { tolerance, ..Quantity::default_of(0.5, kind) };
    /// assert_eq!((width.at(0.25), Quantity { tolerance: None, ..width }.at(0.25)), (0.375, 0.5));
    /// ```
    pub fn at(&self, share: f64) -> f64 {
        let allowed = self.kind.interval();
        self.tolerance.map_or(self.value, |tolerance| tolerance.at(share, self.value, allowed))
    }

    /// A quantity that stands in no file.
    ///
    /// # Example
    /// What stands in no file has no place there, and no tolerance.
    /// ```
    /// use carom_scene::quantity::{Allowed, Kind, Quantity};
    /// use carom_scene::unit::Dimension;
    /// let gravity = Quantity::default_of(9.81, Kind::new(Dimension::Acceleration, Allowed::Positive));
    /// assert_eq!((gravity.value, gravity.tolerance, gravity.span), (9.81, None, None));
    /// ```
    pub fn default_of(value: f64, kind: Kind) -> Self {
        Self { value, kind, tolerance: None, span: None }
    }
}

/// A number as it is written: SI, with its tolerance.
///
/// # Example
/// 347 mm is exactly the number nearest to 0.347.
/// ```
/// use carom_scene::{quantity::{Written, parse}, unit::Dimension};
/// assert_eq!(parse("347 mm", Dimension::Length), Ok(Written { value: 0.347, tolerance: None }));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Written {
    /// Its value or middle, SI.
    pub value: f64,
    /// Its tolerance.
    pub tolerance: Option<Tolerance>,
}

/// Why a text is not a quantity.
///
/// # Example
/// ```
/// use carom_scene::{quantity::{QuantityProblem, parse}, unit::Dimension};
/// let problem = |text| parse(text, Dimension::Length).unwrap_err();
/// assert_eq!(problem("100"), QuantityProblem::NoUnit(100.0));
/// assert_eq!(problem("3 kg"), QuantityProblem::WrongDimension("kg".into(), Dimension::Mass));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum QuantityProblem {
    /// It does not begin with a number.
    NoNumber,
    /// It is NaN or infinite.
    NotFinite,
    /// It has no unit, and this number.
    NoUnit(f64),
    /// Nobody knows this unit.
    UnknownUnit(String),
    /// The unit is of another dimension.
    WrongDimension(String, Dimension),
    /// A plain number was given a unit.
    NeedsNoUnit(String),
    /// The tolerance is not above 0.
    Tolerance,
    /// The low end is not below the high end.
    Order,
    /// A range needs `..`.
    NoRange,
}

impl QuantityProblem {
    /// What is wrong and what is allowed, for a quantity of this dimension.
    ///
    /// # Example
    /// ```
    /// use carom_scene::{quantity::QuantityProblem, unit::Dimension};
    /// let words = QuantityProblem::NoUnit(100.0).in_words(Dimension::Length);
    /// assert!(words.starts_with("has no unit: write \"100 mm\""));
    /// ```
    pub fn in_words(&self, dimension: Dimension) -> String {
        let units = dimension.units_in_words();
        match self {
            Self::NoNumber if units.is_empty() => format!("expected {dimension}"),
            Self::NoNumber => format!("expected {dimension}: a number and one of {units}"),
            Self::NotFinite => "must be a finite number".to_owned(),
            Self::NoUnit(number) => {
                format!("has no unit: write \"{number} {}\" (or another of {units})", dimension.usual())
            }
            // A decimal comma ends the number.
            Self::UnknownUnit(unit) if unit.starts_with(',') => {
                format!("has a comma: decimals are written with a point, {dimension} in {units}")
            }
            Self::UnknownUnit(unit) => format!("unknown unit \"{unit}\": {dimension} takes {units}"),
            Self::WrongDimension(unit, other) if units.is_empty() => {
                format!("\"{unit}\" is {other}, but this is {dimension} without a unit")
            }
            Self::WrongDimension(unit, other) => {
                format!("\"{unit}\" is {other}, but this is {dimension}: it takes {units}")
            }
            Self::NeedsNoUnit(unit) => format!("this is {dimension} without a unit, but has \"{unit}\""),
            Self::Tolerance => "its tolerance must be above 0".to_owned(),
            Self::Order => "its low end must be below its high end".to_owned(),
            Self::NoRange => "expected a range like \"10..40 deg\"".to_owned(),
        }
    }
}

/// Reads `100 mm`, `15 ± 0.5 deg`, `15 deg +- 0.5 deg`, `0.15 ± 10 %`, `0.3`.
///
/// # Errors
/// Why it is not a quantity of this dimension.
///
/// # Example
/// ```
/// use carom_scene::{quantity::parse, unit::Dimension};
/// assert_eq!(parse("3 min", Dimension::Time).map(|written| written.value), Ok(180.0));
/// assert!(parse("3 min", Dimension::Mass).is_err());
/// ```
pub fn parse(text: &str, dimension: Dimension) -> Result<Written, QuantityProblem> {
    for sign in ["±", "+-", "+/-"] {
        if let Some((middle, around)) = text.split_once(sign) {
            return parse_tolerance(middle, around, dimension);
        }
    }
    let (number, unit) = split(text)?;
    Ok(Written { value: to_si(number, unit, dimension)?, tolerance: None })
}

fn parse_tolerance(middle: &str, around: &str, dimension: Dimension) -> Result<Written, QuantityProblem> {
    let (value, value_unit) = split(middle)?;
    let (half, half_unit) = split(around)?;
    if half_unit == "%" {
        let value = to_si(value, value_unit, dimension)?;
        return limits(value, value.abs() * half / 100.0);
    }
    let value_unit = if value_unit.is_empty() { half_unit } else { value_unit };
    let half_unit = if half_unit.is_empty() { value_unit } else { half_unit };
    limits(to_si(value, value_unit, dimension)?, to_si(half, half_unit, dimension)?)
}

fn limits(value: f64, half_width: f64) -> Result<Written, QuantityProblem> {
    if half_width > 0.0 {
        Ok(Written { value, tolerance: Some(Tolerance::Limits { half_width }) })
    } else {
        Err(QuantityProblem::Tolerance)
    }
}

/// Reads `10..40 deg`, `60 mm..200 mm`, `2..6`: low and high, SI.
///
/// # Errors
/// Why it is not a range of this dimension.
///
/// # Example
/// One unit may stand for both ends.
/// ```
/// use carom_scene::{quantity::{QuantityProblem, parse_range}, unit::Dimension};
/// assert_eq!(parse_range("60..200 mm", Dimension::Length), Ok((0.06, 0.2)));
/// assert_eq!(parse_range("200..60 mm", Dimension::Length), Err(QuantityProblem::Order));
/// ```
pub fn parse_range(text: &str, dimension: Dimension) -> Result<(f64, f64), QuantityProblem> {
    let (low, high) = text.split_once("..").ok_or(QuantityProblem::NoRange)?;
    let (low, low_unit) = split(low)?;
    let (high, high_unit) = split(high)?;
    let low_unit = if low_unit.is_empty() { high_unit } else { low_unit };
    let (low, high) = (to_si(low, low_unit, dimension)?, to_si(high, high_unit, dimension)?);
    if low < high { Ok((low, high)) } else { Err(QuantityProblem::Order) }
}

fn to_si(number: f64, unit: &str, dimension: Dimension) -> Result<f64, QuantityProblem> {
    if !number.is_finite() {
        return Err(QuantityProblem::NotFinite);
    }
    if unit.is_empty() {
        return if dimension.units().is_empty() { Ok(number) } else { Err(QuantityProblem::NoUnit(number)) };
    }
    let value = dimension.unit(unit).map(|known: Unit| known.to_si(number));
    value.ok_or_else(|| match Dimension::of_symbol(unit) {
        Some(other) => QuantityProblem::WrongDimension(unit.to_owned(), other),
        None if dimension.units().is_empty() => QuantityProblem::NeedsNoUnit(unit.to_owned()),
        None => QuantityProblem::UnknownUnit(unit.to_owned()),
    })
}

/// The number at the start of a text, and the unit after it.
fn split(text: &str) -> Result<(f64, &str), QuantityProblem> {
    let text = text.trim();
    let end = number_length(text);
    match text[..end].replace('−', "-").parse::<f64>() {
        Ok(number) => Ok((number, text[end..].trim())),
        Err(_) if is_not_finite(text) => Err(QuantityProblem::NotFinite),
        Err(_) => Err(QuantityProblem::NoNumber),
    }
}

fn is_not_finite(text: &str) -> bool {
    let word = text.trim_start_matches(['+', '-', '−']).to_ascii_lowercase();
    ["nan", "inf"].iter().any(|start| word.starts_with(start))
}

fn number_length(text: &str) -> usize {
    let sign = text.chars().next().filter(|c| matches!(c, '+' | '-' | '−')).map_or(0, char::len_utf8);
    let digits = |from: usize| text[from..].bytes().take_while(|c| c.is_ascii_digit() || *c == b'.').count();
    let mantissa = sign + digits(sign);
    let rest = &text[mantissa..];
    if !rest.starts_with(['e', 'E']) {
        return mantissa;
    }
    let exponent_sign = usize::from(rest[1..].starts_with(['+', '-']));
    let exponent = rest[1 + exponent_sign..].bytes().take_while(u8::is_ascii_digit).count();
    if exponent == 0 { mantissa } else { mantissa + 1 + exponent_sign + exponent }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn value(text: &str, dimension: Dimension) -> f64 {
        parse(text, dimension).unwrap().value
    }

    #[test]
    fn numbers_with_units_come_out_in_si() {
        assert_eq!(value("100 mm", Dimension::Length), 0.1);
        assert_eq!(value("100mm", Dimension::Length), 0.1);
        assert_eq!(value("-1.5e2 mm", Dimension::Length), -0.15);
        assert_eq!(value("−150 mm", Dimension::Length), -0.15);
        assert_eq!(value("15 deg", Dimension::Angle), 15.0 * PI / 180.0);
        assert_eq!(value("2.5e-4 kg m^2", Dimension::Inertia), 2.5e-4);
        assert_eq!(value("9.81 m/s²", Dimension::Acceleration), 9.81);
        assert!((value("30 rpm", Dimension::Spin) - PI).abs() <= 4.0 * f64::EPSILON, "30 turns a minute");
        assert_eq!(value("0.15", Dimension::Number), 0.15);
        assert_eq!(value("7.8 g/cm^3", Dimension::Density), 7800.0);
    }

    #[test]
    fn tolerances_are_kept_and_the_middle_is_used() {
        let deg = |x: f64| x * PI / 180.0;
        for text in ["15 ± 0.5 deg", "15 +- 0.5 deg", "15 deg +/- 0.5 deg", "15 deg ± 0.5"] {
            let written = parse(text, Dimension::Angle).unwrap();
            assert_eq!(written.value, deg(15.0), "{text}");
            assert_eq!(written.tolerance, Some(Tolerance::Limits { half_width: deg(0.5) }), "{text}");
        }
        let written = parse("0.2 ± 10 %", Dimension::Number).unwrap();
        assert_eq!(written.tolerance, Some(Tolerance::Limits { half_width: 0.02 }));
    }

    #[test]
    fn ranges_share_their_unit() {
        assert_eq!(parse_range("60..200 mm", Dimension::Length), Ok((0.06, 0.2)));
        assert_eq!(parse_range("2..6", Dimension::Count), Ok((2.0, 6.0)));
        assert_eq!(parse_range("6..2", Dimension::Count), Err(QuantityProblem::Order));
    }

    #[test]
    fn what_is_no_quantity_says_why() {
        let because = |text: &str, dimension| parse(text, dimension).unwrap_err();
        assert_eq!(because("long", Dimension::Length), QuantityProblem::NoNumber);
        assert_eq!(because("nan m", Dimension::Length), QuantityProblem::NotFinite);
        assert_eq!(because("-inf", Dimension::Number), QuantityProblem::NotFinite);
        assert_eq!(because("1e999 m", Dimension::Length), QuantityProblem::NotFinite);
        assert_eq!(because("100", Dimension::Length), QuantityProblem::NoUnit(100.0));
        assert_eq!(because("3 furlong", Dimension::Length), QuantityProblem::UnknownUnit("furlong".into()));
        let wrong = QuantityProblem::WrongDimension("mm".into(), Dimension::Length);
        assert_eq!(because("3 mm", Dimension::Mass), wrong);
        assert_eq!(because("15 ± 0 deg", Dimension::Angle), QuantityProblem::Tolerance);
    }
}
