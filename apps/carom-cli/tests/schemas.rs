//! What the command prints as JSON is what its schemas say: every key, every type, and nothing besides.

use crate::command;

use command::{Said, command, folder, result_on};
use serde_json::Value;

fn schema(of: &str) -> Value {
    // Tests run side by side: each thread, which is named as its test, writes to a folder of its own.
    let own = std::thread::current().name().map_or("schema".into(), |test| format!("schema-{test}"));
    let said: Said = command(&["schema", of], &folder(&own)).output().unwrap().into();
    assert_eq!(said.code, 0, "{of}: {}", said.err);
    serde_json::from_str(&said.out).unwrap()
}

/// The name of a value's type in a schema.
fn type_of(value: &Value) -> &'static str {
    match value {
        Value::Null => "null",
        Value::Bool(_) => "boolean",
        Value::Number(number) if number.is_f64() => "number",
        Value::Number(_) => "integer",
        Value::String(_) => "string",
        Value::Array(_) => "array",
        Value::Object(_) => "object",
    }
}

/// Every way in which a value is not what a schema says.
fn faults(root: &Value, schema: &Value, value: &Value, at: &str) -> Vec<String> {
    if let Some(name) = schema["$ref"].as_str() {
        let target = &root["$defs"][name.trim_start_matches("#/$defs/")];
        assert!(target.is_object(), "{at}: no {name}");
        return faults(root, target, value, at);
    }
    if let Some(ways) = schema["anyOf"].as_array() {
        let fits = ways.iter().any(|way| faults(root, way, value, at).is_empty());
        return if fits { vec![] } else { vec![format!("{at}: fits none of {ways:?}")] };
    }
    if let Some(ways) = schema["oneOf"].as_array() {
        let fit = ways.iter().filter(|way| faults(root, way, value, at).is_empty()).count();
        return if fit == 1 { vec![] } else { vec![format!("{at}: fits {fit} of {ways:?}")] };
    }
    if let Some(word) = schema.get("const").filter(|word| *word != value) {
        return vec![format!("{at}: {value}, allowed is {word}")];
    }
    if let Some(words) = schema["enum"].as_array().filter(|words| !words.contains(value)) {
        return vec![format!("{at}: {value}, allowed is {words:?}")];
    }
    let allowed: Vec<&str> = match &schema["type"] {
        Value::String(word) => vec![word],
        Value::Array(words) => words.iter().filter_map(Value::as_str).collect(),
        other => panic!("{at}: no type but {other}"),
    };
    let found = type_of(value);
    let is_allowed = allowed.contains(&found) || (found == "integer" && allowed.contains(&"number"));
    if !is_allowed {
        return vec![format!("{at}: {found}, allowed is {allowed:?}")];
    }
    match value {
        Value::Object(entries) => keys(root, schema, entries, at),
        Value::Array(items) => {
            let item = |(i, item): (usize, &Value)| {
                let one =
                    if schema["items"].is_object() { &schema["items"] } else { &schema["prefixItems"][i] };
                faults(root, one, item, &format!("{at}[{i}]"))
            };
            items.iter().enumerate().flat_map(item).collect()
        }
        _ => vec![],
    }
}

fn keys(root: &Value, schema: &Value, entries: &serde_json::Map<String, Value>, at: &str) -> Vec<String> {
    let mut out = vec![];
    let required = schema["required"].as_array().map_or(&[][..], Vec::as_slice);
    for key in required.iter().filter_map(Value::as_str) {
        if !entries.contains_key(key) {
            out.push(format!("{at}: no {key}"));
        }
    }
    for (key, value) in entries {
        let place = format!("{at}.{key}");
        match (&schema["properties"][key], &schema["additionalProperties"]) {
            (known, _) if known.is_object() => out.extend(faults(root, known, value, &place)),
            (_, others) if others.is_object() => out.extend(faults(root, others, value, &place)),
            _ => out.push(format!("{place}: the schema does not know it")),
        }
    }
    out
}

fn are_as_their_schema(of: &str, cases: &[&[&str]]) {
    let schema = schema(of);
    for (i, words) in cases.iter().enumerate() {
        let result = result_on("0", &format!("schema_{of}_{i}"), words);
        let faults = faults(&schema, &schema, &result, "");
        assert!(faults.is_empty(), "{words:?}\n{}", faults.join("\n"));
    }
}

/// Results of commands, each of which is what its schema says.
macro_rules! results {
    ($($test:ident: $of:literal, $([$($word:literal),* $(,)?]),* $(,)?;)*) => { $(
        #[test]
        fn $test() {
            are_as_their_schema($of, &[$(&[$of, $($word),*]),*]);
        }
    )* };
}

results! {
    validations_are_as_their_schema: "validate",
        ["housner_block", "energy_gain"];
    runs_are_as_their_schema: "run",
        ["too_flat.toml"],
        ["disc.toml"],
        ["case_2.toml"],
        ["feed.toml"],
        ["designer.toml"];
    faces_are_as_their_schema: "faces",
        ["bracket.toml", "--throws", "64"],
        ["bolt.toml", "--throws", "16", "--height", "50 ± 10 mm", "--speed", "1 m/s"];
    impacts_are_as_their_schema: "impact",
        ["impact_operator.toml"],
        ["impact_box.toml"],
        ["impact_cradle.toml"],
        ["impact_row.toml"],
        ["impact_twist.toml"],
        ["impact_space_balls.toml"],
        ["impact_space_operator.toml"];
    contacts_are_as_their_schema: "contact",
        ["contact_painleve.toml"];
    rolls_are_as_their_schema: "roll",
        ["cylinder"],
        ["prism", "roll_prism.toml"],
        ["prism", "roll_prism.toml", "--poses", "50 ms"],
        ["rod", "roll_rod.toml"],
        ["pyramid", "roll_pyramid.toml"],
        ["stool", "roll_stool.toml"],
        ["stool", "--set", "spin=[0, 0, 6]"],
        ["stool", "--set", "spin=[0, 0, 6]", "--poses", "50 ms"],
        ["body", "roll_body_tetrahedron.toml"],
        ["body", "bolt.stl"],
        ["body", "roll_body.toml", "--throws", "32"];
    maps_are_as_their_schema: "map",
        ["designer.toml", "--x", "plate.1.slope=5..40 deg:6", "--y", "contact.friction=0.05..0.5:6"];
    designs_are_as_their_schema: "design",
        ["designer.toml", "--scan", "64", "--samples", "256"];
    feeds_are_as_their_schema: "feed",
        ["case_1.toml", "--intervals", "16"],
        ["too_flat.toml", "--intervals", "16"],
        ["solid.toml", "--intervals", "16"];
    sweeps_are_as_their_schema: "sweep",
        ["designer.toml", "--grid", "plate.1.slope=5..40 deg:6", "--force"];
    yields_are_as_their_schema: "yield",
        ["designer.toml", "--samples", "1024"];
    fits_are_as_their_schema: "fit",
        ["measured.toml", "measured.csv", "--samples", "16", "--nodes", "1000"];
    regions_are_as_their_schema: "regions",
        ["cylinder", "--x", "friction=0..1.5:12", "--y", "gamma=1..89 deg:12"],
        ["strike", "--x", "angle_to_normal=-80..80 deg:8", "--depth", "1"],
        ["pyramid", "--x", "sides=3..5:4", "--y", "height_ratio=0.5..1:4"],
        ["stool-strike", "--x", "swinging=-2..2:4", "--depth", "1"],
        ["--file", "impact_bar.toml", "--x", "body.spin=-10..10:8", "--y", "contact.0.friction=0..1:8"];
}

#[test]
fn faces_and_runs_in_space_are_as_their_schema() {
    for (of, words) in [
        ("space-faces", &["faces", "solid_bolt.toml", "--throws", "16", "--height", "1 mm"][..]),
        ("space-run", &["run", "solid_bolt.toml"]),
    ] {
        are_as_their_schema(of, &[words]);
    }
}

#[test]
fn a_fault_is_found() {
    let schema = schema("regions");
    let odd = serde_json::json!({ "diagram": 3, "zebra": true, "labels": [{ "label": null }] });
    let found = faults(&schema, &schema, &odd, "");
    let has = |text: &str| found.iter().any(|fault| fault.contains(text));
    assert!(has(".diagram: integer") && has(".zebra: the schema") && has(": no axes"), "{found:?}");
    assert!(has(".labels[0].label: null") && has(".labels[0]: no words"), "{found:?}");
}

#[test]
fn schemas_are_objects() {
    for of in [
        "scene",
        "run",
        "impact",
        "roll",
        "error",
        "map",
        "yield",
        "faces",
        "space-faces",
        "fit",
        "feed",
        "sweep",
        "design",
        "regions",
    ] {
        assert_eq!(schema(of)["type"], "object", "{of}");
    }
}
