//! Physical dimensions and the units they may be written in.

mod table;

use carom_words::number::plain;
use std::fmt;
use table::{
    ACCELERATION, ANGLE, COUNT_SIZES, DENSITY, DENSITY_SIZES, FORCE, INERTIA, LENGTH, LENGTH_SIZES, MASS,
    MASS_SIZES, NUMBER_SIZES, SPEED, SPIN, TIME, TIME_SIZES, TORQUE,
};

/// What a quantity measures. Its SI unit is the first of [`Dimension::units`].
///
/// # Example
/// A speed may be written in m/s, and `m/s` belongs to no other dimension.
/// ```
/// use carom_scene::unit::Dimension;
/// assert_eq!((Dimension::Speed.si(), Dimension::of_symbol("m/s")), ("m/s", Some(Dimension::Speed)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Dimension {
    /// A plain number: friction, restitution.
    Number,
    /// A whole number: how many plates.
    Count,
    /// Length [m].
    Length,
    /// Angle [rad].
    Angle,
    /// Mass [kg].
    Mass,
    /// Time [s].
    Time,
    /// Speed [m/s].
    Speed,
    /// Spin [rad/s].
    Spin,
    /// Acceleration [m/s²].
    Acceleration,
    /// Moment of inertia [kg m²].
    Inertia,
    /// Mass per volume [kg/m³].
    Density,
    /// Force [N].
    Force,
    /// Torque [N m].
    Torque,
}

/// A unit: its symbol and the fraction that brings a number in it to SI.
///
/// A fraction rather than a factor, so that `347 mm` is exactly the number nearest to 0.347.
///
/// # Example
/// An inch is 25.4 mm.
/// ```
/// use carom_scene::unit::Dimension;
/// let inch = Dimension::Length.unit("in").unwrap();
/// assert_eq!((inch.symbol, inch.to_si(1.0)), ("in", 0.0254));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    /// Its symbol, as it is written (`kg m^2`, `deg`).
    pub symbol: &'static str,
    numerator: f64,
    denominator: f64,
}

const PI: f64 = std::f64::consts::PI;

impl Dimension {
    /// Every dimension.
    ///
    /// # Example
    /// Every symbol belongs to one dimension.
    /// ```
    /// use carom_scene::unit::Dimension;
    /// for dimension in Dimension::ALL {
    ///     let own = |symbol| Dimension::of_symbol(symbol) == Some(dimension);
    ///     assert!(dimension.units().iter().all(|unit| own(unit.symbol)));
    /// }
    /// ```
    pub const ALL: [Dimension; 13] = [
        Self::Number,
        Self::Count,
        Self::Length,
        Self::Angle,
        Self::Mass,
        Self::Time,
        Self::Speed,
        Self::Spin,
        Self::Acceleration,
        Self::Inertia,
        Self::Density,
        Self::Force,
        Self::Torque,
    ];

    /// The units it may be written in, the SI unit first; none for plain and whole numbers.
    ///
    /// # Example
    /// The SI unit comes first: a number in it is its own value.
    /// ```
    /// use carom_scene::unit::Dimension;
    /// assert_eq!(Dimension::Mass.units()[0].to_si(0.3), 0.3);
    /// assert!(Dimension::Number.units().is_empty());
    /// ```
    pub fn units(self) -> &'static [Unit] {
        match self {
            Self::Number | Self::Count => &[],
            Self::Length => LENGTH,
            Self::Angle => ANGLE,
            Self::Mass => MASS,
            Self::Time => TIME,
            Self::Speed => SPEED,
            Self::Spin => SPIN,
            Self::Acceleration => ACCELERATION,
            Self::Inertia => INERTIA,
            Self::Density => DENSITY,
            Self::Force => FORCE,
            Self::Torque => TORQUE,
        }
    }

    /// The symbol of its SI unit; empty for plain and whole numbers.
    ///
    /// # Example
    /// ```
    /// use carom_scene::unit::Dimension;
    /// assert_eq!((Dimension::Acceleration.si(), Dimension::Count.si()), ("m/s^2", ""));
    /// ```
    pub fn si(self) -> &'static str {
        self.units().first().map_or("", |unit| unit.symbol)
    }

    /// The symbol of the unit a drawing uses: millimetres and degrees, else the SI unit.
    ///
    /// # Example
    /// ```
    /// use carom_scene::unit::Dimension;
    /// let usual = [Dimension::Length, Dimension::Angle, Dimension::Mass].map(Dimension::usual);
    /// assert_eq!(usual, ["mm", "deg", "kg"]);
    /// ```
    pub fn usual(self) -> &'static str {
        match self {
            Self::Length => "mm",
            Self::Angle => "deg",
            other => other.si(),
        }
    }

    /// The smallest and the largest size of a value other than zero that is computed with, SI: far beyond what parts have, and near enough for
    /// products of several to stay numbers.
    ///
    /// # Example
    /// ```
    /// use carom_scene::unit::Dimension;
    /// assert_eq!(Dimension::Speed.sizes(), [1e-12, 1e6]);
    /// ```
    pub fn sizes(self) -> [f64; 2] {
        match self {
            Self::Number | Self::Inertia => NUMBER_SIZES,
            Self::Count => COUNT_SIZES,
            Self::Length | Self::Speed | Self::Angle => LENGTH_SIZES,
            Self::Mass => MASS_SIZES,
            Self::Time | Self::Spin | Self::Acceleration => TIME_SIZES,
            Self::Density => DENSITY_SIZES,
            Self::Force | Self::Torque => MASS_SIZES,
        }
    }

    /// The units it may be written in, as a sentence lists them: `m, mm, cm, um, in or ft`.
    ///
    /// # Example
    /// ```
    /// use carom_scene::unit::Dimension;
    /// assert_eq!(Dimension::Time.units_in_words(), "s, ms or min");
    /// assert_eq!(Dimension::Number.units_in_words(), "");
    /// ```
    pub fn units_in_words(self) -> String {
        let symbols: Vec<&str> = self.units().iter().map(|unit| unit.symbol).collect();
        match symbols.split_last() {
            None => String::new(),
            Some((last, [])) => (*last).to_owned(),
            Some((last, others)) => format!("{} or {last}", others.join(", ")),
        }
    }

    /// The unit of this dimension with this symbol. `°`, `µ`, `²`, `³`, `·` and `*` are understood.
    ///
    /// # Example
    /// One symbol may be written in several ways.
    /// ```
    /// use carom_scene::unit::Dimension;
    /// assert_eq!(Dimension::Inertia.unit("kg·m²"), Dimension::Inertia.unit("kg m^2"));
    /// assert_eq!(Dimension::Angle.unit("°").map(|unit| unit.symbol), Some("deg"));
    /// assert!(Dimension::Length.unit("kg").is_none());
    /// ```
    pub fn unit(self, symbol: &str) -> Option<Unit> {
        let plain = plain_symbol(symbol);
        self.units().iter().copied().find(|unit| unit.symbol == plain)
    }

    /// The dimension that a unit's symbol belongs to, for saying what was written instead.
    ///
    /// # Example
    /// ```
    /// use carom_scene::unit::Dimension;
    /// assert_eq!(Dimension::of_symbol("rpm"), Some(Dimension::Spin));
    /// assert_eq!(Dimension::of_symbol("parsec"), None);
    /// ```
    pub fn of_symbol(symbol: &str) -> Option<Dimension> {
        Self::ALL.into_iter().find(|dimension| dimension.unit(symbol).is_some())
    }

    /// An SI value for a person to read: angles in degrees, lengths below a metre in millimetres, 7 digits.
    ///
    /// # Example
    /// ```
    /// use carom_scene::unit::Dimension;
    /// assert_eq!(Dimension::Angle.show(std::f64::consts::FRAC_PI_6), "30 deg");
    /// assert_eq!([0.1, 2.5].map(|length| Dimension::Length.show(length)), ["100 mm", "2.5 m"]);
    /// ```
    pub fn show(self, value: f64) -> String {
        self.show_digits(value, 7)
    }

    /// As [`Dimension::show`], with so many significant digits (at least 1).
    ///
    /// # Example
    /// ```
    /// use carom_scene::unit::Dimension;
    /// assert_eq!(Dimension::Speed.show_digits(2.0 / 3.0, 3), "0.667 m/s");
    /// ```
    pub fn show_digits(self, value: f64, digits: usize) -> String {
        let short = |value: f64| plain(value, digits);
        match self {
            Self::Number | Self::Count => short(value),
            Self::Angle => format!("{} deg", short(value * 180.0 / PI)),
            Self::Length if value.abs() < 1.0 => format!("{} mm", short(value * 1e3)),
            _ => format!("{} {}", short(value), self.si()),
        }
    }
}

impl Unit {
    /// A number in this unit, in SI.
    ///
    /// # Example
    /// A minute has 60 s, and 60 rpm are 2π rad/s.
    /// ```
    /// use carom_scene::unit::Dimension;
    /// let (minute, turns) = (Dimension::Time.unit("min").unwrap(), Dimension::Spin.unit("rpm").unwrap());
    /// assert_eq!(minute.to_si(1.5), 90.0);
    /// assert!((turns.to_si(60.0) - std::f64::consts::TAU).abs() < 1e-15);
    /// ```
    pub fn to_si(self, number: f64) -> f64 {
        number * self.numerator / self.denominator
    }

    /// An SI value in this unit.
    ///
    /// # Example
    /// There and back.
    /// ```
    /// use carom_scene::unit::Dimension;
    /// let millimetre = Dimension::Length.unit("mm").unwrap();
    /// assert_eq!((millimetre.of_si(0.25), millimetre.to_si(250.0)), (250.0, 0.25));
    /// ```
    pub fn of_si(self, value: f64) -> f64 {
        value * self.denominator / self.numerator
    }
}

fn plain_symbol(symbol: &str) -> String {
    let mut plain = String::new();
    for c in symbol.trim().chars() {
        match c {
            '²' => plain.push_str("^2"),
            '³' => plain.push_str("^3"),
            '·' | '*' | '⋅' => plain.push(' '),
            '°' => plain.push_str("deg"),
            'µ' | 'μ' => plain.push('u'),
            other => plain.push(other),
        }
    }
    plain.split_whitespace().collect::<Vec<_>>().join(" ").replace(" /", "/").replace("/ ", "/")
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Number => "a plain number",
            Self::Count => "a whole number",
            Self::Length => "a length",
            Self::Angle => "an angle",
            Self::Mass => "a mass",
            Self::Time => "a time",
            Self::Speed => "a speed",
            Self::Spin => "a spin",
            Self::Acceleration => "an acceleration",
            Self::Inertia => "a moment of inertia",
            Self::Density => "a density",
            Self::Force => "a force",
            Self::Torque => "a torque",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_in_millimetres_is_the_nearest_number_in_metres() {
        let mm = Dimension::Length.unit("mm").unwrap();
        assert_eq!(mm.to_si(347.0), 0.347);
        assert_eq!(mm.to_si(0.1), 1e-4);
    }

    #[test]
    fn signs_of_print_are_understood() {
        assert_eq!(Dimension::Inertia.unit("kg·m²").unwrap().symbol, "kg m^2");
        assert_eq!(Dimension::Angle.unit("°").unwrap().symbol, "deg");
        assert_eq!(Dimension::Length.unit("µm").unwrap().symbol, "um");
        assert_eq!(Dimension::Density.unit("g / cm³").unwrap().symbol, "g/cm^3");
    }

    #[test]
    fn the_imperial_units_are_the_defined_ones() {
        assert_eq!(Dimension::Length.unit("in").unwrap().to_si(1.0), 0.0254);
        assert_eq!(Dimension::Length.unit("ft").unwrap().to_si(1.0), 0.3048);
        assert_eq!(Dimension::Mass.unit("lb").unwrap().to_si(1.0), 0.453_592_37);
    }

    #[test]
    fn no_symbol_belongs_to_two_dimensions() {
        for dimension in Dimension::ALL {
            for unit in dimension.units() {
                assert_eq!(Dimension::of_symbol(unit.symbol), Some(dimension), "{}", unit.symbol);
            }
        }
    }

    #[test]
    fn values_are_shown_in_a_designers_units() {
        assert_eq!(Dimension::Length.show(0.347), "347 mm");
        assert_eq!(Dimension::Angle.show(PI / 12.0), "15 deg");
        assert_eq!(Dimension::Inertia.show(2.5e-4), "0.00025 kg m^2");
        assert_eq!(Dimension::Number.show(0.15), "0.15");
        assert_eq!(Dimension::Angle.show_digits(10.0 * PI / 180.0, 5), "10 deg");
        assert_eq!(Dimension::Length.show_digits(-0.0, 5), "0 mm");
    }
}
