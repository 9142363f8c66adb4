//! JSON as it is written: keys in their order, and those that are given twice.

use crate::problem::{Problem, ProblemKind};
use serde::de::{Deserialize, Deserializer, MapAccess, SeqAccess, Visitor};
use std::collections::BTreeSet;
use std::fmt;

/// A value of JSON.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Json {
    Null,
    Bool(bool),
    Number(serde_json::Number),
    Text(String),
    List(Vec<Json>),
    Object(Vec<(String, Json)>),
}

/// Reads one JSON text.
///
/// # Errors
/// What is no JSON, and every key that an object has twice: which of the two counts nobody has said.
pub(crate) fn read(source: &str) -> Result<Json, Vec<Problem>> {
    let json: Json = serde_json::from_str(source)
        .map_err(|error| vec![Problem::new(ProblemKind::Syntax, "", format!("not JSON: {error}"), None)])?;
    let mut twice = vec![];
    given_twice("", &json, &mut twice);
    if twice.is_empty() { Ok(json) } else { Err(twice) }
}

fn given_twice(path: &str, json: &Json, found: &mut Vec<Problem>) {
    let joined = |key: &str| if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
    match json {
        Json::List(items) => {
            items.iter().enumerate().for_each(|(i, item)| given_twice(&joined(&i.to_string()), item, found));
        }
        Json::Object(entries) => {
            let mut known = BTreeSet::new();
            for (key, value) in entries {
                if !known.insert(key) {
                    let message = format!("the key {key:?} is given twice: write it once");
                    found.push(Problem::new(ProblemKind::Syntax, joined(key), message, None));
                }
                given_twice(&joined(key), value, found);
            }
        }
        Json::Null | Json::Bool(_) | Json::Number(_) | Json::Text(_) => {}
    }
}

impl<'de> Deserialize<'de> for Json {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Reader)
    }
}

struct Reader;

impl<'de> Visitor<'de> for Reader {
    type Value = Json;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("any JSON value")
    }

    fn visit_unit<E>(self) -> Result<Json, E> {
        Ok(Json::Null)
    }

    fn visit_bool<E>(self, truth: bool) -> Result<Json, E> {
        Ok(Json::Bool(truth))
    }

    fn visit_u64<E>(self, number: u64) -> Result<Json, E> {
        Ok(Json::Number(number.into()))
    }

    fn visit_i64<E>(self, number: i64) -> Result<Json, E> {
        Ok(Json::Number(number.into()))
    }

    fn visit_f64<E>(self, number: f64) -> Result<Json, E> {
        // JSON has no number that is not finite.
        Ok(serde_json::Number::from_f64(number).map_or(Json::Null, Json::Number))
    }

    fn visit_str<E>(self, text: &str) -> Result<Json, E> {
        Ok(Json::Text(text.to_owned()))
    }

    fn visit_string<E>(self, text: String) -> Result<Json, E> {
        Ok(Json::Text(text))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Json, A::Error> {
        let mut list = vec![];
        while let Some(item) = items.next_element()? {
            list.push(item);
        }
        Ok(Json::List(list))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Json, A::Error> {
        let mut list = vec![];
        while let Some(entry) = entries.next_entry()? {
            list.push(entry);
        }
        Ok(Json::Object(list))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_that_is_given_twice_is_told_with_its_path() {
        let told =
            |text: &str| read(text).map_err(|list| list.into_iter().map(|p| p.path).collect::<Vec<_>>());
        assert_eq!(
            told(r#"{"a": [{"b": 1, "b": 1}], "c": 2, "a": 3}"#),
            Err(vec!["a.0.b".into(), "a".into()])
        );
        assert!(told(r#"{"a": {"b": 1}, "c": {"b": 1}}"#).is_ok(), "two tables may have one key each");
    }

    #[test]
    fn keys_keep_their_order() {
        let Json::Object(entries) = read(r#"{"b": 1, "a": [null, true, -2, 0.5, "x"]}"#).unwrap() else {
            panic!("an object")
        };
        let keys: Vec<&str> = entries.iter().map(|(key, _)| key.as_str()).collect();
        assert_eq!(keys, ["b", "a"]);
        let Json::List(items) = &entries[1].1 else { panic!("a list") };
        let number = serde_json::Number::from_f64(0.5).unwrap();
        let text = Json::Text("x".into());
        assert_eq!(
            items[..],
            [Json::Null, Json::Bool(true), Json::Number((-2).into()), Json::Number(number), text]
        );
    }
}
