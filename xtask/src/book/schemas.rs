//! Reference pages of the book, from the program's own JSON Schemas and help pages.

use crate::examples;
use serde_json::{Map, Value};

/// A page about one schema: its keys, then those of every object that it names.
pub(crate) fn page(name: &str, schema: &Value) -> String {
    let mut out = match name {
        "scene" => "# Keys of a scene\n\n".to_owned(),
        "impact-file" => "# Keys of an impact\n\n".to_owned(),
        "roll-file" => "# Keys of roll files\n\n".to_owned(),
        "list" => "# A list of designs\n\n".to_owned(),
        "error" => "# Keys of the answer to a line that has problems\n\n".to_owned(),
        _ => format!("# Keys of what `carom {name}` says\n\n"),
    };
    if let Some(words) = schema["description"].as_str() {
        out.push_str(&format!("{words}\n\n"));
    }
    let units = match name {
        "scene" | "impact-file" | "roll-file" | "list" => {
            "Quantities are texts with units, or plain SI numbers."
        }
        _ => "The unit follows the quantity in the name of a key: `end_s` is in seconds.",
    };
    out.push_str(&format!("From `carom schema {name}`. {units}\n\n"));
    out.push_str(&body(schema));
    for (name, definition) in schema["$defs"].as_object().into_iter().flatten() {
        out.push_str(&format!("## {}\n\n", plain(name)));
        if let Some(words) = definition["description"].as_str() {
            out.push_str(&format!("{words}\n\n"));
        }
        out.push_str(&body(definition));
    }
    out.truncate(out.trim_end().len());
    out.push('\n');
    out
}

/// What a schema allows: a table of keys, or in words.
fn body(schema: &Value) -> String {
    match schema["properties"].as_object() {
        Some(keys) => table(keys, schema),
        None => format!("Is {}.\n\n", kind(schema)),
    }
}

fn table(keys: &Map<String, Value>, schema: &Value) -> String {
    let required: Vec<&str> =
        schema["required"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    let mut out = "| key | is | means |\n|---|---|---|\n".to_owned();
    for (key, value) in keys {
        let is = kind(value);
        let is = if required.contains(&key.as_str()) {
            is
        } else {
            format!("{}, may be left out", is.trim_end_matches(" or null"))
        };
        let means = value["description"].as_str().unwrap_or_default();
        out.push_str(&format!("| `{key}` | {is} | {} |\n", cell(means)));
    }
    out.push('\n');
    out
}

/// The kind of a value in words, with links to the objects of the page.
fn kind(value: &Value) -> String {
    if let Some(target) = value["$ref"].as_str() {
        let name = plain(target.rsplit('/').next().unwrap_or(target));
        return format!("[{name}](#{})", name.to_lowercase());
    }
    if let Some(words) = value["enum"].as_array() {
        return listed(words.iter().filter_map(Value::as_str).map(|word| format!("`{word}`")));
    }
    if let Some(choices) = value["anyOf"].as_array().or(value["oneOf"].as_array()) {
        return listed(choices.iter().map(kind));
    }
    if value["if"].is_object() {
        return listed([&value["then"], &value["else"]].into_iter().map(kind));
    }
    if let Some(word) = value["const"].as_str() {
        return format!("`{word}`");
    }
    match &value["type"] {
        Value::String(name) => one(name, value),
        Value::Array(names) => listed(names.iter().filter_map(Value::as_str).map(|name| one(name, value))),
        _ => "any value".to_owned(),
    }
}

fn one(name: &str, value: &Value) -> String {
    match name {
        "array" => list(value),
        "string" => "text".to_owned(),
        "integer" => "whole number".to_owned(),
        "boolean" => "true or false".to_owned(),
        "object" if value["properties"].is_object() => {
            let keys = value["properties"].as_object().into_iter().flatten();
            format!("an object of {}", listed(keys.map(|(key, value)| format!("`{key}` ({})", kind(value)))))
        }
        "object" => "an object".to_owned(),
        other => other.to_owned(),
    }
}

fn list(value: &Value) -> String {
    let items = if value["items"].is_object() { kind(&value["items"]) } else { "values".to_owned() };
    match (value["minItems"].as_u64(), value["maxItems"].as_u64()) {
        (Some(least), Some(most)) if least == most => format!("list of {least}: {items}"),
        _ => format!("list: {items}"),
    }
}

fn listed(words: impl Iterator<Item = String>) -> String {
    words.collect::<Vec<_>>().join(" or ")
}

/// `StageReport` is a stage.
fn plain(name: &str) -> &str {
    name.strip_suffix("Report").filter(|rest| !rest.is_empty()).unwrap_or(name)
}

/// A text as a cell of a table; brackets of units are no links, and in code they stand as they are.
fn cell(text: &str) -> String {
    let plain = text.replace('|', "\\|").replace('\n', " ");
    let parts = plain.split('`').enumerate();
    let parts = parts.map(|(n, part)| if n % 2 == 0 { part.replace('[', "\\[") } else { part.to_owned() });
    parts.collect::<Vec<_>>().join("`")
}

/// The table of the project's examples, from the first words of each and the command that it is for.
pub(crate) fn examples(files: &[(String, String)]) -> String {
    let mut out = "| command | what the file holds |\n|---|---|\n".to_owned();
    for (path, text) in files {
        let name = path.rsplit('/').next().unwrap_or(path);
        let verbs = examples::verbs(name.trim_end_matches(".toml"), text).join(" ");
        let words: Vec<&str> = text.lines().map_while(|line| line.strip_prefix('#')).map(str::trim).collect();
        out.push_str(&format!("| `carom {verbs} {path}` | {} |\n", cell(words.join(" ").trim())));
    }
    out
}

/// The page of all commands and their options, from what each says of itself.
pub(crate) fn options(helps: &[(String, String)]) -> String {
    let mut out = "# Commands and options\n\nWhat `carom help COMMAND` prints.\n".to_owned();
    for (command, help) in helps {
        out.push_str(&format!("\n## `carom {command}`\n\n```text\n{}\n```\n", help.trim_end()));
    }
    out
}

/// The words that a help page offers as commands, but for `help` itself.
pub(crate) fn commands(help: &str) -> Vec<String> {
    let list = help.split_once("Commands:\n").map_or("", |(_, rest)| rest);
    let lines = list.lines().take_while(|line| !line.is_empty());
    let words = lines.filter_map(|line| line.split_whitespace().next());
    words.filter(|word| *word != "help").map(str::to_owned).collect()
}

/// The words after `Possible values:` of a help page's first argument.
pub(crate) fn values(help: &str) -> Vec<String> {
    let list = help.split_once("Possible values:\n").map_or("", |(_, rest)| rest);
    let lines = list.lines().map(str::trim).take_while(|line| !line.is_empty());
    let words = lines.filter_map(|line| line.strip_prefix("- ")?.split(':').next());
    words.map(str::to_owned).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn keys_become_a_table_with_links() {
        let schema = json!({
            "title": "carom run", "description": "A run.", "required": ["end_s"],
            "properties": {
                "end_s": { "description": "When it ended [s], as `[a]`.", "type": "number" },
                "exit": { "anyOf": [{ "$ref": "#/$defs/ExitReport" }, { "type": "null" }] },
                "axes": { "type": "array", "minItems": 2, "maxItems": 2, "items": { "type": "string" } },
            },
            "$defs": { "ExitReport": { "type": "string", "enum": ["left", "right"] } },
        });
        let page = page("run", &schema);
        for line in [
            "| `end_s` | number | When it ended \\[s], as `[a]`. |",
            "| `exit` | [Exit](#exit), may be left out |  |",
            "| `axes` | list of 2: text, may be left out |  |",
            "## Exit",
            "Is `left` or `right`.",
        ] {
            assert!(page.lines().any(|found| found == line), "no line {line} in\n{page}");
        }
    }

    #[test]
    fn help_pages_name_commands_and_values() {
        let help = "x\n\nCommands:\n  run   Run it\n  help  Print\n\nOptions:\n";
        assert_eq!(commands(help), ["run"], "all but help");
        let help = "  <OF>\n          Possible values:\n          - scene: A file\n          - run:   A result\n\n  - no";
        assert_eq!(values(help), ["scene", "run"], "the words before the colons");
    }
}
