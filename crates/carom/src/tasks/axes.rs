//! What a study is asked over: the quantities it knows, what they are set to, and the ranges of those that move.

use super::map::MapAxis;
use carom_scene::quantity::{QuantityProblem, parse, parse_range};
use carom_scene::unit::{Dimension, Unit};
use carom_scene::{Drawn, Problem, ProblemKind, Problems, label_beside, labelled, nearest};
use carom_study::regions::{MOST_CELLS, Range};
use std::ops::RangeInclusive;

/// Who asks, and so how its options are written.
///
/// # Example
/// ```
/// use carom::tasks::axes::Asker;
/// assert_eq!((Asker::Command.option("x"), Asker::Call.option("x")), ("--x".to_owned(), "x".to_owned()));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Asker {
    /// The command: options have two dashes.
    #[default]
    Command,
    /// A call of a function: options are its arguments.
    Call,
}

impl Asker {
    /// An option as its asker writes it.
    pub fn option(self, name: &str) -> String {
        match self {
            Self::Command => format!("--{name}"),
            Self::Call => name.to_owned(),
        }
    }

    /// Where the options stand.
    fn place(self) -> &'static str {
        match self {
            Self::Command => "the command line",
            Self::Call => "the call",
        }
    }
}

/// Cells of an axis that says none.
const CELLS: usize = 80;

/// A quantity that may be set or be an axis.
#[derive(Clone, Debug)]
pub struct Key {
    /// Its name on the command line and in files.
    pub name: String,
    /// What it measures and its letter, as an axis says it.
    pub words: String,
    /// Its dimension.
    pub dimension: Dimension,
    /// SI.
    pub value: f64,
    /// Closed interval that it must lie in, SI.
    pub allowed: [f64; 2],
    /// True where a unit must be written, as in scenes; elsewhere a plain number is SI.
    pub needs_unit: bool,
}

impl Key {
    /// A quantity for which a plain number is SI.
    pub fn new(name: &str, words: &str, dimension: Dimension, value: f64, allowed: [f64; 2]) -> Self {
        Self { name: name.to_owned(), words: words.to_owned(), dimension, value, allowed, needs_unit: false }
    }

    /// Why a value is not allowed; `None` where it is.
    pub fn outside(&self, value: f64) -> Option<String> {
        let [low, high] = self.allowed;
        let show = |value| self.dimension.show(value);
        (!(low..=high).contains(&value)).then(|| match (low.is_finite(), high.is_finite()) {
            (true, true) => format!("{} is outside {} to {}", show(value), show(low), show(high)),
            (true, false) => format!("{} is below {}", show(value), show(low)),
            _ => format!("{} is not a finite number", show(value)),
        })
    }
}

/// An axis: its quantity, and its range in the unit it is shown in.
#[derive(Clone, Debug)]
pub struct Axis {
    /// Which of the quantities.
    pub key: usize,
    /// From where to where, and its cells.
    pub range: Range,
    unit: Option<Unit>,
}

impl Axis {
    /// A value of the axis in SI.
    pub fn si(&self, shown: f64) -> f64 {
        self.unit.map_or(shown, |unit| unit.to_si(shown))
    }

    /// As the axis of a map.
    pub fn of_map(&self, keys: &[Key]) -> MapAxis {
        MapAxis { path: keys[self.key].name.clone(), range: self.range, unit: self.unit }
    }

    /// The symbol of its unit; empty for plain numbers.
    pub fn unit(&self) -> &'static str {
        self.unit.map_or("", |unit| unit.symbol)
    }
}

/// The quantities and the axes of a diagram.
#[derive(Clone, Debug)]
pub struct Plane {
    /// All quantities.
    pub keys: Vec<Key>,
    /// Abscissa and ordinate.
    pub axes: [Axis; 2],
}

impl Plane {
    /// All quantities in SI, with the two axes at a point.
    pub fn at(&self, x: f64, y: f64) -> Vec<f64> {
        let mut values: Vec<f64> = self.keys.iter().map(|key| key.value).collect();
        for (axis, shown) in self.axes.iter().zip([x, y]) {
            values[axis.key] = axis.si(shown);
        }
        values
    }

    /// The quantities that are no axis, for a person: `b = 0.5, h = 300 mm`.
    pub fn fixed(&self) -> String {
        let fixed = self.keys.iter().enumerate().filter(|(k, _)| self.axes.iter().all(|axis| axis.key != *k));
        let texts: Vec<String> =
            fixed.map(|(_, key)| format!("{} = {}", key.words, key.dimension.show(key.value))).collect();
        texts.join(", ")
    }
}

/// What is wrong with what is asked.
///
/// # Example
/// ```
/// use carom::tasks::axes::{Asker, Complaints};
/// let mut complaints = Complaints::of(Asker::Command);
/// complaints.push("accuracy", "7 is outside 1e-12 to 0.1".to_owned());
/// assert!(complaints.finish().unwrap_err().to_string().contains("--accuracy"));
/// ```
#[derive(Clone, Debug, Default)]
pub struct Complaints {
    asker: Asker,
    list: Vec<Problem>,
}

impl Complaints {
    /// None as yet.
    pub fn of(asker: Asker) -> Self {
        Self { asker, list: vec![] }
    }

    /// Who asks.
    pub fn asker(&self) -> Asker {
        self.asker
    }

    /// One more, of an option without its dashes.
    pub fn push(&mut self, option: &str, message: String) {
        let option = self.asker.option(option);
        self.list.push(Problem::new(ProblemKind::WrongValue, option, message, None));
    }

    /// One more, of a key of the scene.
    pub fn push_of_scene(&mut self, key: &str, message: String) {
        self.list.push(Problem::new(ProblemKind::WrongValue, key, message, None));
    }

    /// Fails where there are any.
    ///
    /// # Errors
    /// All of them.
    pub fn finish(self) -> Result<(), Problems> {
        if self.list.is_empty() { Ok(()) } else { Err(Problems::new(self.asker.place(), "", self.list)) }
    }
}

/// Reads `set`, `x` and `y`, the latter two with their defaults; `None` where an axis is none.
pub fn read(
    mut keys: Vec<Key>,
    settings: &[String],
    axes: [&str; 2],
    complaints: &mut Complaints,
) -> Option<Plane> {
    for setting in settings {
        let option = format!("set {setting}");
        let Some((name, text)) = setting.split_once('=') else {
            complaints.push(&option, "expected KEY=VALUE".to_owned());
            continue;
        };
        let Some(k) = position(&keys, name, &option, complaints) else { continue };
        let key = &mut keys[k];
        let read = match parse(text, key.dimension) {
            Err(problem @ QuantityProblem::NoUnit(_)) if key.needs_unit => {
                Err(problem.in_words(key.dimension))
            }
            _ => quantity(text, key.dimension),
        };
        match read.map(|value| (value, key.outside(value))) {
            Ok((value, None)) => key.value = value,
            Ok((_, Some(message))) | Err(message) => complaints.push(&option, message),
        }
    }
    let [x, y] = [("x", axes[0]), ("y", axes[1])]
        .map(|(flag, text)| read_axis(&keys, flag, text, &("cells", 1..=MOST_CELLS), complaints));
    let axes = [x?, y?];
    if axes[0].key == axes[1].key {
        complaints.push("y", format!("{} is the abscissa already", keys[axes[0].key].name));
    }
    Some(Plane { keys, axes })
}

fn position(keys: &[Key], name: &str, option: &str, complaints: &mut Complaints) -> Option<usize> {
    let found = keys.iter().position(|key| key.name == name.trim());
    if found.is_none() {
        complaints.push(option, unknown(keys, name.trim()));
    }
    found
}

/// That there is no such quantity, and which was probably meant.
pub fn unknown(keys: &[Key], name: &str) -> String {
    let names: Vec<&str> = keys.iter().map(|key| key.name.as_str()).collect();
    match nearest(name, &names) {
        Some(near) => {
            format!("there is no quantity \"{name}\": did you mean \"{near}\"{}?", label_beside(near))
        }
        None => format!("\"{name}\" is none of {}", names.join(", ")),
    }
}

/// Reads an axis; `divided` is what its range is divided into, and into how many.
pub fn read_axis(
    keys: &[Key],
    flag: &str,
    text: &str,
    (divided, allowed): &(&str, RangeInclusive<usize>),
    complaints: &mut Complaints,
) -> Option<Axis> {
    let option = format!("{flag} {text}");
    let Some((name, rest)) = text.split_once('=') else {
        complaints.push(&option, format!("expected KEY=A..B or KEY=A..B:{}", divided.to_uppercase()));
        return None;
    };
    let k = position(keys, name, &option, complaints);
    let (range, cells) = rest.rsplit_once(':').map_or((rest, None), |(range, cells)| (range, Some(cells)));
    let count = cells.map_or(Some(CELLS), |cells| {
        let count = cells.trim().parse().ok().filter(|count| allowed.contains(count));
        if count.is_none() {
            complaints.push(
                &option,
                format!("\"{cells}\" {divided}: {} to {} are allowed", allowed.start(), allowed.end()),
            );
        }
        count
    });
    // Only now: an unknown key and a wrong count are told together.
    let k = k?;
    let key = &keys[k];
    match limits(range, key) {
        Ok((low, high)) => {
            let outside: Vec<String> =
                [low, high].into_iter().filter_map(|value| key.outside(value)).collect();
            outside.iter().for_each(|message| complaints.push(&option, message.clone()));
            let unit = written(range, key.dimension).or_else(|| key.dimension.unit(key.dimension.usual()));
            let shown = |value| unit.map_or(value, |unit: Unit| unit.of_si(value));
            let range = Range { from: shown(low), to: shown(high), count: count? };
            outside.is_empty().then_some(Axis { key: k, range, unit })
        }
        Err(message) => {
            complaints.push(&option, message);
            None
        }
    }
}

/// A quantity with its unit, or a plain SI number.
///
/// # Errors
/// What is wrong with the text.
pub fn quantity(text: &str, dimension: Dimension) -> Result<f64, String> {
    match parse(text, dimension) {
        Ok(written) => Ok(written.value),
        Err(QuantityProblem::NoUnit(number)) => Ok(number),
        Err(problem) => Err(problem.in_words(dimension)),
    }
}

/// A range with units, or of plain SI numbers where they are allowed.
fn limits(text: &str, key: &Key) -> Result<(f64, f64), String> {
    let dimension = key.dimension;
    match parse_range(text, dimension) {
        Err(QuantityProblem::NoUnit(_)) if key.needs_unit => {
            let (units, usual) = (dimension.units_in_words(), dimension.usual());
            Err(format!("\"{text}\" has no unit: write \"{} {usual}\" (or another of {units})", text.trim()))
        }
        Err(QuantityProblem::NoUnit(_)) => {
            parse_range(text, Dimension::Number).map_err(|problem| problem.in_words(dimension))
        }
        other => other.map_err(|problem| problem.in_words(dimension)),
    }
}

/// The unit a range is written in, where it has one.
fn written(text: &str, dimension: Dimension) -> Option<Unit> {
    let symbol = text.trim().trim_start_matches(|c: char| !c.is_alphabetic() && c != '°');
    let symbol = symbol.rsplit("..").next()?.trim_start_matches(|c: char| !c.is_alphabetic() && c != '°');
    dimension.unit(symbol)
}

/// The quantities of a scene that may be moved. On the command line their units are written, as in the scene; in a call plain numbers are SI.
pub fn keys(scene: &impl Drawn, asker: Asker) -> Vec<Key> {
    let quantities = scene.quantities().into_iter();
    let continuous = quantities.filter(|quantity| quantity.kind.dimension != Dimension::Count);
    continuous
        .map(|quantity| {
            let (dimension, allowed) = (quantity.kind.dimension, quantity.kind.interval());
            let key = Key::new(&quantity.path, &labelled(&quantity.path), dimension, quantity.value, allowed);
            Key { needs_unit: asker == Asker::Command, ..key }
        })
        .collect()
}

/// The same text with a plate's number replaced by its name.
pub fn named(scene: &impl Drawn, text: &str) -> String {
    let Some((path, rest)) = text.split_once('=') else { return text.to_owned() };
    format!("{}={rest}", scene.canonical(path.trim()))
}

/// The number of the plate that is looked at.
pub fn plate(scene: &impl Drawn, named: Option<&str>, complaints: &mut Complaints) -> usize {
    super::plate(scene, named).unwrap_or_else(|message| {
        complaints.push("plate", message);
        0
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_range_is_shown_in_the_unit_it_is_written_in() {
        let key = Key::new("gamma", "γ", Dimension::Angle, 0.5, [0.0, 1.6]);
        let axis = |text: &str| {
            let mut complaints = Complaints::default();
            let axis =
                read_axis(std::slice::from_ref(&key), "x", text, &("cells", 1..=MOST_CELLS), &mut complaints);
            complaints.finish().map(|()| axis.unwrap()).map_err(|problems| problems.to_string())
        };
        for (text, unit) in
            [("gamma=1..89 deg:8", "deg"), ("gamma=1deg..89°", "deg"), ("gamma=0.1..1.5 rad", "rad")]
        {
            assert_eq!(axis(text).unwrap().unit(), unit, "{text}");
        }
        assert!((axis("gamma=1deg..89deg:8").unwrap().range.to - 89.0).abs() < 1e-12, "shown in degrees");
        assert!(
            (axis("gamma=0.1..1.5").unwrap().si(45.0) - 0.25 * std::f64::consts::PI).abs() < 1e-15,
            "rad in"
        );
        assert!(axis("gamma=1..89:8").unwrap_err().contains("outside"), "89 rad");
        assert!(axis("gama=1..2 deg").unwrap_err().contains("did you mean \"gamma\"?"));
        assert!(axis("gama=1..2:0").unwrap_err().matches("--x").count() >= 2, "every fault");
    }
}
