//! The values of a file, for a form.

use crate::reply::{Failure, QuantityShown};
use carom_scene::quantity::Kind;
use carom_scene::unit::Dimension;
use carom_scene::{Field, Form, editing};
use std::collections::BTreeMap;

/// What ten decimals may take from a value, as a share of it.
const PRINTED: f64 = 1e-9;

/// Every value that a file holds or may hold.
pub(crate) fn fields(form: Form, text: &str) -> Vec<QuantityShown> {
    form.fields(text).iter().map(quantity).collect()
}

/// The text with a value as a person typed it.
pub(crate) fn written(text: &str, path: &str, value: &str) -> Result<String, Failure> {
    let (table, key) = path.rsplit_once('.').unwrap_or(("", path));
    editing::setting(text, table, key, value).ok_or_else(|| Failure::of_page("the file has no such table"))
}

/// The text with these values, in SI.
pub(crate) fn moved(form: Form, text: &str, values: &BTreeMap<String, f64>) -> Result<String, Failure> {
    let dimensions = dimensions(form, text, values.keys())?;
    let mut text = text.to_owned();
    for ((path, value), dimension) in values.iter().zip(dimensions) {
        text = written(&text, path, &shown(*value, dimension))?;
    }
    Ok(text)
}

/// A value in SI with its unit.
pub(crate) fn si(value: f64, dimension: Dimension) -> String {
    format!("{value:?} {}", dimension.si()).trim_end().to_owned()
}

/// A value in the unit of drawings, where that unit says the same.
fn shown(value: f64, dimension: Dimension) -> String {
    let usual = dimension.usual();
    let of = dimension.unit(usual).map(|unit| (unit, format!("{:.10}", unit.of_si(value))));
    let short = of.map(|(unit, text)| (unit, text.trim_end_matches('0').trim_end_matches('.').to_owned()));
    match short.filter(|(unit, text)| text.parse::<f64>().is_ok_and(|short| near(unit.to_si(short), value))) {
        Some((_, text)) if dimension != Dimension::Count => format!("{text} {usual}"),
        _ => si(value, dimension),
    }
}

/// Equal but for what printing takes.
fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= PRINTED * b.abs()
}

/// The dimensions of single numbers of a file, by their paths.
pub(crate) fn dimensions<S: AsRef<str>>(
    form: Form,
    text: &str,
    paths: impl IntoIterator<Item = S>,
) -> Result<Vec<Dimension>, Failure> {
    let fields = form.fields(text);
    let of = |path: S| {
        let path = path.as_ref();
        let field = fields.iter().find(|field| field.path() == path && field.value.is_some());
        let kind = field.and_then(|field| field.kind);
        kind.map(|kind| kind.dimension)
            .ok_or_else(|| Failure::of_page(&format!("{path} is no single number of this file")))
    };
    paths.into_iter().map(of).collect()
}

fn quantity(field: &Field) -> QuantityShown {
    let usual = field.kind.map_or("", |kind| kind.dimension.usual());
    let unit = field.kind.and_then(|kind| kind.dimension.unit(usual));
    let key = field.key.replace('_', " ");
    QuantityShown {
        path: field.path(),
        label: if field.group.is_empty() { key } else { format!("{}: {key}", field.group) },
        text: field.text.clone(),
        written: field.written,
        value: field.value.unwrap_or_default(),
        allowed: field.kind.map_or([None; 2], allowed),
        unit: usual.to_owned(),
        si: unit.map_or(1.0, |unit| unit.to_si(1.0)),
        about: field.about,
        choices: field.choices.clone(),
        number: field.value.is_some(),
    }
}

fn allowed(kind: Kind) -> [Option<f64>; 2] {
    kind.interval().map(|end| end.is_finite().then_some(end))
}
