//! The schemas say what the readers and writers do.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use carom_scene::schema;

#[test]
fn the_schemas_stay_as_they_are() {
    for (name, schema) in [
        ("scene", schema::scene()),
        ("impact_file", schema::impact_file()),
        ("roll_file", schema::roll_file()),
        ("list", schema::list()),
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
