//! The schemas say what the readers and writers do.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use carom_scene::{Scene, schema};
use serde_json::Value;
use std::collections::BTreeMap;

/// A scene whose every table has a key that nobody knows.
const ODD: &str = r#"
zebra = 1
part = { shape = "SHAPE", zebra = 1 }
contact = { zebra = 1 }
start = { zebra = 1 }
channel = { zebra = 1 }
zigzag = { zebra = 1 }
feed = { zebra = 1 }
design = { zebra = 1 }
plate = [PLATES]
wall = [{ zebra = 1 }]
"#;

/// The keys each table is said to have, by its name: "[part] has a, b".
fn said(text: &str) -> BTreeMap<String, Vec<String>> {
    let problems = Scene::parse("odd.toml", text).expect_err("it has odd keys");
    let mut keys: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for problem in problems.list {
        if let Some(said) = problem.message.strip_prefix("unknown key; ") {
            let (table, list) = said.split_once(" has ").unwrap();
            let table = table.trim_matches(['[', ']']).split('.').next().unwrap().to_owned();
            keys.entry(table).or_default().extend(list.split(", ").map(str::to_owned));
        }
    }
    keys
}

fn properties(schema: &Value) -> Vec<String> {
    let mut keys: Vec<String> = schema["properties"].as_object().unwrap().keys().cloned().collect();
    keys.sort();
    keys
}

#[test]
fn the_scene_schema_has_the_readers_keys() {
    let schema = schema::scene().to_value();
    let mut keys: BTreeMap<String, Vec<String>> = BTreeMap::new();
    let ways = [
        "{ zebra = 1, wall = \"left\" }",
        "{ zebra = 1, line = { along = 1, normal = 1 } }",
        "{ zebra = 1, below = [0, 0] }",
        "{ zebra = 1, edge = [0, 0] }",
        "{ zebra = 1, from = [0, 0] }",
        "{ zebra = 1 }",
    ];
    for shape in ["rod", "box", "polygon", "disc", "outline", "none"] {
        let heft = |text: &str| said(&text.replace("SHAPE", shape).replace("PLATES", &ways.join(", ")));
        for (table, found) in heft(ODD) {
            keys.entry(table).or_default().extend(found);
        }
    }
    for list in keys.values_mut() {
        list.sort();
        list.dedup();
    }
    assert_eq!(keys["the file"], properties(&schema));
    let tables = ["part", "contact", "start", "channel", "zigzag", "feed", "design", "plate", "wall"];
    for table in tables {
        let name = format!("{}{}", table[..1].to_uppercase(), &table[1..]);
        let found: Vec<String> = keys[table].iter().filter(|key| *key != "zebra").cloned().collect();
        assert_eq!(found, properties(&schema["$defs"][&name]), "{table}");
    }
}

#[test]
fn the_schemas_stay_as_they_are() {
    for (name, schema) in [
        ("scene", schema::scene()),
        ("run", schema::run()),
        ("impact", schema::impact()),
        ("roll", schema::roll()),
        ("regions", schema::regions()),
        ("map", schema::map()),
        ("yield", schema::yields()),
    ] {
        let text = serde_json::to_string_pretty(&schema).unwrap();
        insta::assert_snapshot!(format!("schema_{name}"), text);
    }
}
