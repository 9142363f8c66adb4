//! Studies of solid parts as a user meets them.

use crate::command;

use command::{command, empty};
use serde_json::Value;
use std::path::Path;

/// A box on a plate of 15°, held by friction above tan 15°.
const HELD: &str = "part = { box = [0.04, 0.01, 0.02], mass = 0.06 }\ncontact = { friction = 0.5 }\nstart = { to_edge = 0.1 }\n[[plate]]\nslope = \"15 deg\"\nwidth = 0.06\n";

/// A box that slides over the end of a plate, onto one whose slope is open.
const DOWN: &str = "part = { box = [0.04, 0.01, 0.02], mass = 0.06 }\ncontact = { friction = \"0.2 ± 0.02\", restitution = 0 }\nstart = { to_edge = 0.02, speed = \"0.3 m/s\" }\n[[plate]]\nslope = \"15 deg\"\nlength = \"200 mm\"\nwidth = 0.06\n[[plate]]\nslope = \"15 deg\"\nbelow = { x = \"-20 mm\", y = \"-25 mm\" }\nwidth = 0.1\nwant = \"same\"\n[design]\nfree = { \"plate.1.slope\" = \"5..40 deg\" }\nmax_impact_speed = \"0.75 m/s\"\n";

/// A command's answer, of the scene `held.toml`, or another one.
fn asked(place: &Path, words: &[&str]) -> Value {
    asked_of(place, ("held.toml", HELD), words)
}

fn asked_of(place: &Path, (name, text): (&str, &str), words: &[&str]) -> Value {
    std::fs::write(place.join(name), text).unwrap();
    let scene = place.join(name).display().to_string();
    let words: Vec<&str> = words.iter().map(|word| if *word == name { &scene } else { *word }).collect();
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

/// The layout that is found does what is asked of it, run as a scene of its own.
#[test]
fn a_design_of_a_solid_ends_as_wanted() {
    let (place, plan) = (empty("solid-design"), ["--scan", "16", "--samples", "16", "--format", "json"]);
    let found = asked_of(&place, ("down.toml", DOWN), &[&["design", "down.toml"], &plan[..]].concat());
    assert_eq!(
        (&found["outcome"], &found["delivered"][0]),
        (&"found".into(), &"same side on \"plate 2\"".into())
    );
    assert!(found["exit"]["attitude"].is_array(), "it leaves the plate that it lands on: {}", found["exit"]);
    let designed = std::fs::read_to_string(place.join("down/design/design.toml")).unwrap();
    let run = asked_of(&place, ("own.toml", &designed), &["run", "own.toml", "--format", "json"]);
    let (judged, landing) = (&found["winner"], &run["plates"][0]);
    assert!(landing["verdict"] == "same" && judged["impact_speed_m_s"].as_f64().unwrap() <= 0.75, "{judged}");
    assert_eq!(judged["time_s"], run["end_s"], "it is judged by the same run");
}

#[test]
fn a_design_of_a_solid_says_what_forbids_it() {
    let (place, strict) = (empty("solid-design-none"), DOWN.replace("0.75 m/s", "0.05 m/s"));
    let words = ["design", "down.toml", "--scan", "16", "--format", "json"];
    let found = asked_of(&place, ("down.toml", &strict), &words);
    let speed =
        found["forbidden"].as_array().unwrap().iter().find(|f| f["demand"] == "impact speed").unwrap();
    assert!(
        found["winner"].is_null() && speed["alone"] == 6 && speed["nearest"].as_f64().unwrap() > 0.5,
        "{speed}"
    );
}

/// A cube whose corners are cut off has faces of eight corners, of which three touch at once in a groove as wide as it, more than can be asked at once: that the drop has no answer is not what anyone wants.
#[test]
fn what_has_no_answer_is_not_wanted() {
    let sign = |k: usize, bit: usize| if k >> bit & 1 == 1 { 0.01 } else { -0.01 };
    let corner = |k: usize| {
        let mut at = [sign(k, 0), sign(k, 1), sign(k, 2)];
        at[k / 8] *= std::f64::consts::SQRT_2 - 1.0;
        format!("[{}, {}, {}]", at[0], at[1], at[2])
    };
    let corners: Vec<String> = (0..24).map(corner).collect();
    let part =
        format!("part = {{ shape = \"solid\", vertices = [{}], density = 2700 }}\n", corners.join(", "));
    let scene = HELD.replacen("part = { box = [0.04, 0.01, 0.02], mass = 0.06 }\n", &part, 1);
    let scene = scene.replacen("friction = 0.5", "friction = \"0.5 ± 0.1\"", 1);
    let scene = format!("{scene}[groove]\nwidth = 0.02\n");
    let words = ["yield", "cube.toml", "--samples", "16", "--format", "json"];
    let found = asked_of(&empty("no-answer"), ("cube.toml", &scene), &words);
    assert_eq!(found["yield"]["count"], 0, "{found}");
    assert!(found["wanted"].as_str().unwrap().starts_with("nothing is wanted"), "{found}");
}
