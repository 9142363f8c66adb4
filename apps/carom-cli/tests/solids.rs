//! Studies of solid parts as a user meets them.

use crate::command;

use command::{command, empty};
use serde_json::Value;
use std::path::Path;

/// A box on a plate of 15°, held by friction above tan 15°.
const HELD: &str = "part = { box = [0.04, 0.01, 0.02], mass = 0.06 }\ncontact = { friction = 0.5 }\nstart = { to_edge = 0.1 }\n[[plate]]\nslope = \"15 deg\"\nwidth = 0.06\n";

fn asked(place: &Path, words: &[&str]) -> Value {
    std::fs::write(place.join("held.toml"), HELD).unwrap();
    let scene = place.join("held.toml").display().to_string();
    let words: Vec<&str> =
        words.iter().map(|word| if *word == "held.toml" { &scene } else { *word }).collect();
    let said: command::Said = command(&words, place).output().unwrap().into();
    assert_eq!(said.code, 0, "{}", said.err);
    serde_json::from_str(&said.out).unwrap()
}

fn least_friction() -> f64 {
    carom_num::elementary::tan(15_f64.to_radians())
}

#[test]
fn a_map_of_a_solid_has_its_border_there() {
    let axes = ["--x", "contact.friction=0.2..0.32:2", "--y", "start.to_edge=0.08m..0.12m:2"];
    let words =
        [&["map", "held.toml"], &axes[..], &["--accuracy", "1e-3", "--depth", "0", "--format", "json"]];
    let place = empty("solid-map");
    let found = asked(&place, &words.concat());
    // What slides leaves the only plate.
    let slides = found["labels"].as_array().unwrap().iter().find(|label| label["label"] == "es").unwrap();
    let share = (least_friction() - 0.2) / (0.32 - 0.2);
    assert!((slides["area_share"].as_f64().unwrap() - share).abs() < 1e-3, "{slides}, not {share}");
    assert!(place.join("held/map.svg").exists());
}

#[test]
fn a_sweep_of_a_solid_has_a_row_a_design() {
    let words = ["sweep", "held.toml", "--grid", "contact.friction=0.2..0.4:3", "--format", "json"];
    let found = asked(&empty("solid-sweep"), &words);
    assert_eq!((&found["rows"], &found["endings"]["stuck"]), (&3.into(), &2.into()), "{found}");
}
