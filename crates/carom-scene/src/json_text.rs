//! JSON as the text of a file: every reader takes one line of it, with the same keys.

use crate::json::{self, Json};
use crate::problem::{Problem, ProblemKind, Problems};
use std::fmt::Write as _;

/// The TOML text that says what one JSON object says; `file` is the name that problems are reported under.
///
/// # Errors
/// What is no JSON object, a key that is given twice, and a `null`.
///
/// # Example
/// A roll file in one line.
/// ```
/// use carom_scene::{RollKind, RollProblem, toml_of_json};
/// let text = toml_of_json("line 1", r#"{"sides": 4, "strikes": 1, "slope": "5 deg"}"#)?;
/// assert_eq!(text, "\"sides\" = 4\n\"strikes\" = 1\n\"slope\" = \"5 deg\"\n");
/// assert!(RollProblem::parse(RollKind::Prism, "line 1", &text, &[]).is_ok());
/// # Ok::<(), carom_scene::Problems>(())
/// ```
pub fn toml_of_json(file: &str, json: &str) -> Result<String, Problems> {
    let fail =
        |kind, path: &str, message| Problems::new(file, "", vec![Problem::new(kind, path, message, None)]);
    let Json::Object(entries) = json::read(json).map_err(|list| Problems::new(file, "", list))? else {
        return Err(fail(ProblemKind::Syntax, "", "expected one JSON object".to_owned()));
    };
    let (mut text, mut nulls) = (String::new(), vec![]);
    for (key, value) in &entries {
        text.push_str(&quoted(key));
        text.push_str(" = ");
        write_value(&mut text, value, key, &mut nulls);
        text.push('\n');
    }
    let is_null = |path| {
        let message = "is null: leave the key out; other problems are told once no key is null".to_owned();
        Problem::new(ProblemKind::WrongValue, path, message, None)
    };
    if nulls.is_empty() {
        Ok(text)
    } else {
        Err(Problems::new(file, "", nulls.into_iter().map(is_null).collect()))
    }
}

/// `nulls` takes the path of every null.
fn write_value(text: &mut String, value: &Json, path: &str, nulls: &mut Vec<String>) {
    match value {
        Json::Null => nulls.push(path.to_owned()),
        Json::Bool(truth) => text.push_str(if *truth { "true" } else { "false" }),
        // Writing to a String cannot fail.
        Json::Number(number) => drop(write!(text, "{number}")),
        Json::Text(word) => text.push_str(&quoted(word)),
        Json::List(items) => {
            text.push('[');
            for (i, item) in items.iter().enumerate() {
                text.push_str(if i > 0 { ", " } else { "" });
                write_value(text, item, &format!("{path}.{i}"), nulls);
            }
            text.push(']');
        }
        Json::Object(entries) => {
            text.push_str("{ ");
            for (i, (key, item)) in entries.iter().enumerate() {
                let comma = if i > 0 { ", " } else { "" };
                // Writing to a String cannot fail.
                let _ = write!(text, "{comma}{} = ", quoted(key));
                write_value(text, item, &format!("{path}.{key}"), nulls);
            }
            text.push_str(" }");
        }
    }
}

/// A basic string of TOML; its escapes are those of JSON, which lets one control character stand.
fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string().replace('\u{7f}', "\\u007f")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Scene;

    #[test]
    fn a_scene_in_one_line_is_the_scene() {
        let text = std::fs::read_to_string("../../examples/case_2.toml").unwrap();
        let written: toml::Table = toml::from_str(&text).unwrap();
        let line = serde_json::to_string(&written).unwrap();
        let [scene, again] =
            [text, toml_of_json("line 1", &line).unwrap()].map(|text| Scene::parse("a.toml", &text).unwrap());
        assert_eq!(scene.feeder(), again.feeder(), "{line}");
    }

    #[test]
    fn what_toml_does_not_know_is_named_with_its_path() {
        let message = |json: &str| toml_of_json("line 7", json).unwrap_err().to_string();
        assert!(message("{\"a\": {\"b\": [1, null]}}").contains("a.b.1"), "the path of the null");
        let both = message("{\"a\": null, \"b\": {\"c\": null}}");
        assert!(both.contains("a: is null") && both.contains("b.c: is null"), "every null: {both}");
        assert!(message("[1]").contains("expected one JSON object"), "a list");
        assert!(message("{").contains("not JSON"), "half a line");
        let odd = toml_of_json("line 7", "{\"a\\u007f\\u0000\\\"\": \"\\u007f\\n\"}").unwrap();
        let table: toml::Table = toml::from_str(&odd).unwrap();
        assert_eq!(table["a\u{7f}\0\""].as_str(), Some("\u{7f}\n"), "{odd}");
    }
}
