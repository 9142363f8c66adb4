//! Single values: a quantity from a number, a text or a distribution.

use crate::node::{Entry, Node, Value};
use crate::problem::{Problem, ProblemKind};
use crate::quantity::{self, Allowed, Kind, Quantity, QuantityProblem, Tolerance};
use crate::unit::Dimension;

/// The keys of `{ low, high }`: every value between them is equally likely.
pub(super) const UNIFORM: [&str; 2] = ["low", "high"];
/// The keys of `{ value, sigma }`: a normal distribution.
pub(super) const NORMAL: [&str; 2] = ["value", "sigma"];

/// A quantity as it is written, or what is wrong with it. A plain number above `longest_plain` [m] is a length whose unit was forgotten.
pub(crate) fn quantity(
    path: &str,
    node: &Node,
    kind: Kind,
    longest_plain: Option<f64>,
) -> Result<Quantity, Vec<Problem>> {
    let (value, tolerance) = match &node.value {
        Value::Number(number) => (*number, None),
        Value::Text(text) => written(path, text, node, kind)?,
        Value::Table(entries) => distribution(path, entries, node, kind)?,
        _ => return Err(vec![expected(&kind.dimension.to_string(), path, node)]),
    };
    let quantity = Quantity { value, kind, tolerance, span: Some(node.span.clone()) };
    if let Some(problem) = out_of_range(path, &quantity) {
        // An angle as a plain number is often one in degrees.
        let plain = matches!(node.value, Value::Number(_)) && kind.dimension == Dimension::Angle;
        let help = "a plain number is in rad: write degrees as \"15 deg\"";
        return Err(vec![if plain { problem.with_help(help) } else { problem }]);
    }
    match forgotten_unit(path, node, kind, longest_plain) {
        Some(problem) => Err(vec![problem]),
        None => Ok(quantity),
    }
}

fn written(
    path: &str,
    text: &str,
    node: &Node,
    kind: Kind,
) -> Result<(f64, Option<Tolerance>), Vec<Problem>> {
    let written = quantity::parse(text, kind.dimension).map_err(|problem| {
        let message = format!("\"{text}\": {}", problem.in_words(kind.dimension));
        let problem = Problem::new(ProblemKind::Quantity, path, message, Some(node.span.clone()));
        vec![problem.with_allowed(kind.dimension.units().iter().map(|unit| unit.symbol))]
    })?;
    Ok((written.value, written.tolerance))
}

/// `{ value, sigma }` or `{ low, high }`, of numbers and texts.
fn distribution(
    path: &str,
    entries: &[Entry],
    node: &Node,
    kind: Kind,
) -> Result<(f64, Option<Tolerance>), Vec<Problem>> {
    let uniform = entries.iter().any(|entry| UNIFORM.contains(&entry.key.as_str()));
    let keys = if uniform { UNIFORM } else { NORMAL };
    let mut problems: Vec<Problem> = entries
        .iter()
        .filter(|entry| !keys.contains(&entry.key.as_str()))
        .map(|entry| {
            let message = format!("unknown key; [{path}] has {}", keys.join(", "));
            let place = format!("{path}.{}", entry.key);
            Problem::new(ProblemKind::UnknownKey, place, message, Some(entry.key_span.clone()))
        })
        .collect();
    // Ends of a distribution may lie where the quantity itself may not; its middle and its spread may not.
    let any = Kind::new(kind.dimension, Allowed::Any);
    let spread = Kind::new(kind.dimension, Allowed::Positive);
    let kinds = if uniform { [any, any] } else { [kind, spread] };
    let mut values = [None; 2];
    for ((value, key), kind) in values.iter_mut().zip(keys).zip(kinds) {
        match plain(path, key, entries, node, kind) {
            Ok(number) => *value = Some(number),
            Err(found) => problems.extend(found),
        }
    }
    let [Some(first), Some(second)] = values else { return Err(problems) };
    if !problems.is_empty() {
        return Err(problems);
    }
    if !uniform {
        return Ok((first, Some(Tolerance::Sigma { sigma: second })));
    }
    if first < second {
        return Ok((0.5 * (first + second), Some(Tolerance::Uniform { low: first, high: second })));
    }
    let message = QuantityProblem::Order.in_words(kind.dimension);
    Err(vec![Problem::new(ProblemKind::OutOfRange, path, message, Some(node.span.clone()))])
}

/// A number or a text of a distribution.
fn plain(path: &str, key: &str, entries: &[Entry], node: &Node, kind: Kind) -> Result<f64, Vec<Problem>> {
    let path = format!("{path}.{key}");
    let Some(entry) = entries.iter().find(|entry| entry.key == key) else {
        let message = missing(kind);
        return Err(vec![Problem::new(ProblemKind::MissingKey, path, message, Some(node.span.clone()))]);
    };
    match entry.node.value {
        Value::Number(_) | Value::Text(_) => quantity(&path, &entry.node, kind, None).map(|q| q.value),
        _ => Err(vec![expected(&kind.dimension.to_string(), &path, &entry.node)]),
    }
}

/// What is said of a quantity that is missing.
pub(super) fn missing(kind: Kind) -> String {
    let unit = kind.dimension.usual();
    let example = if unit.is_empty() { String::new() } else { format!(", for example in {unit}") };
    format!("missing: {}{example}", kind.dimension)
}

/// What is wrong with a plain number as a length: read in metres it is longer than anything there is.
fn forgotten_unit(path: &str, node: &Node, kind: Kind, longest: Option<f64>) -> Option<Problem> {
    let (Value::Number(number), Dimension::Length) = (&node.value, kind.dimension) else { return None };
    let longest = longest.filter(|longest| number.abs() > *longest)?;
    let (shown, longest) = (kind.dimension.show(*number), kind.dimension.show(longest));
    let message = format!("{number} without a unit is {shown}: more than {longest} needs its unit");
    let problem = Problem::new(ProblemKind::Quantity, path, message, Some(node.span.clone()));
    Some(problem.with_help(format!(
        "a plain number is in m: write millimetres as \"{number} mm\", or \"{number} m\" where it is so long"
    )))
}

pub(super) fn expected(what: &str, path: &str, node: &Node) -> Problem {
    let message = format!("expected {what}, found {}", node.value.type_in_words());
    Problem::new(ProblemKind::WrongValue, path, message, Some(node.span.clone()))
}

/// What is wrong with the value of a quantity, or with the ends of its tolerance.
pub(crate) fn out_of_range(path: &str, quantity: &Quantity) -> Option<Problem> {
    let Quantity { value, kind, tolerance, span } = quantity;
    let ends = match tolerance {
        Some(Tolerance::Limits { half_width }) => [value - half_width, value + half_width],
        Some(Tolerance::Uniform { low, high }) => [*low, *high],
        Some(Tolerance::Sigma { .. }) | None => [*value, *value],
    };
    let bad = |value: f64| !kind.holds(value);
    let wrong = [*value].into_iter().chain(ends).find(|value| bad(*value));
    let message = if !value.is_finite() {
        Allowed::Any.to_string()
    } else if bad(*value) {
        format!("{} {}", kind.dimension.show(*value), kind.rule_for(*value))
    } else if kind.dimension == Dimension::Count && tolerance.is_some() {
        "a whole number has no tolerance".to_owned()
    } else {
        let end = ends.into_iter().find(|end| bad(*end))?;
        format!("its tolerance reaches {}, and it {}", kind.dimension.show(end), kind.rule_for(end))
    };
    Some(
        Problem::new(ProblemKind::OutOfRange, path, message, span.clone())
            .with_allowed([wrong.map_or(kind.allowed.to_string(), |value| kind.rule_for(value))]),
    )
}
