//! The tree of a file, whichever notation it is written in, with the place of every value.

use crate::json::{self, Json};
use crate::problem::{Problem, ProblemKind};
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A value and its place.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Node {
    pub(crate) value: Value,
    pub(crate) span: Range<usize>,
}

/// A value.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Value {
    Text(String),
    Number(f64),
    Bool(bool),
    List(Vec<Node>),
    Table(Vec<Entry>),
    /// A date, a time: nothing a scene knows.
    Other(&'static str),
}

/// A key with its value.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Entry {
    pub(crate) key: String,
    pub(crate) key_span: Range<usize>,
    pub(crate) node: Node,
}

impl Value {
    /// What it is, for saying that something else was expected.
    pub(crate) fn type_in_words(&self) -> &'static str {
        match self {
            Self::Text(_) => "a text",
            Self::Number(_) => "a number",
            Self::Bool(_) => "true or false",
            Self::List(_) => "a list",
            Self::Table(_) => "a table",
            Self::Other(name) => name,
        }
    }
}

/// The tree of a TOML text, with every syntax error in it.
pub(crate) fn from_toml(source: &str) -> (Node, Vec<Problem>) {
    let (table, errors) = DeTable::parse_recoverable(source);
    let problems = errors
        .iter()
        .map(|error| Problem::new(ProblemKind::Syntax, "", error.message().to_owned(), error.span()))
        .collect();
    let span = table.span();
    (Node { value: table_value(table.get_ref()), span }, problems)
}

fn table_value(table: &DeTable<'_>) -> Value {
    let mut entries: Vec<Entry> = table
        .iter()
        .map(|(key, value)| Entry {
            key: key.get_ref().to_string(),
            key_span: key.span(),
            node: toml_node(value),
        })
        .collect();
    entries.sort_by_key(|entry| entry.key_span.start);
    Value::Table(entries)
}

fn toml_node(value: &Spanned<DeValue<'_>>) -> Node {
    let node = match value.get_ref() {
        DeValue::String(text) => Value::Text(text.to_string()),
        DeValue::Integer(number) => {
            let digits = number.as_str().replace('_', "");
            if number.radix() == 10 {
                Value::Number(digits.parse().unwrap_or(f64::NAN))
            } else {
                Value::Number(i64::from_str_radix(&digits, number.radix()).map_or(f64::NAN, |n| n as f64))
            }
        }
        DeValue::Float(number) => Value::Number(number.as_str().replace('_', "").parse().unwrap_or(f64::NAN)),
        DeValue::Boolean(truth) => Value::Bool(*truth),
        DeValue::Datetime(_) => Value::Other("a date or time"),
        DeValue::Array(items) => Value::List(items.iter().map(toml_node).collect()),
        DeValue::Table(table) => table_value(table),
    };
    Node { value: node, span: value.span() }
}

/// The tree of one JSON text. JSON values have no places of their own: all are the whole text.
pub(crate) fn from_json(source: &str) -> Result<Node, Vec<Problem>> {
    Ok(json_node(json::read(source)?, &(0..source.len())))
}

fn json_node(value: Json, span: &Range<usize>) -> Node {
    let value = match value {
        Json::Null => Value::Other("null"),
        Json::Bool(truth) => Value::Bool(truth),
        Json::Number(number) => Value::Number(number.as_f64().unwrap_or(f64::NAN)),
        Json::Text(text) => Value::Text(text),
        Json::List(items) => Value::List(items.into_iter().map(|item| json_node(item, span)).collect()),
        Json::Object(entries) => {
            let entry = |(key, value)| Entry { key, key_span: span.clone(), node: json_node(value, span) };
            Value::Table(entries.into_iter().map(entry).collect())
        }
    };
    Node { value, span: span.clone() }
}
