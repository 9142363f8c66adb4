//! Studies as a user meets them: maps and yields.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::Command;

struct Said {
    code: i32,
    out: String,
    err: String,
}

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("studies").join(name)
}

fn carom(words: &[&str], out: &str, threads: &str) -> Said {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let mut command = Command::new(env!("CARGO_BIN_EXE_carom"));
    command.args(words).arg("--out").arg(folder(out)).current_dir(examples).env("RAYON_NUM_THREADS", threads);
    let output = command.output().unwrap();
    Said {
        code: output.status.code().unwrap(),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    }
}

/// A result without what differs from run to run.
fn result(said: &Said) -> Value {
    assert_eq!(said.code, 0, "{}", said.err);
    let mut json: Value = serde_json::from_str(&said.out).unwrap();
    json.as_object_mut().unwrap().remove("run").unwrap();
    json
}

#[test]
fn a_seed_gives_the_same_result_on_any_number_of_threads() {
    let words = ["yield", "designer.toml", "--samples", "2048", "--format", "json"];
    let one = result(&carom(&words, "one", "1"));
    assert_eq!(one, result(&carom(&words, "three", "3")));
    let other = [&words[..], &["--seed", "2"]].concat();
    assert_ne!(one, result(&carom(&other, "other", "1")), "another seed, other samples");
    let files = |name: &str| {
        let text = |file: &str| std::fs::read(folder(name).join("designer").join(file)).unwrap();
        (text("worst-stuck.toml"), text("worst-hardest.toml"))
    };
    assert_eq!(files("one"), files("three"), "byte for byte");
}

#[test]
fn worst_cases_replay() {
    let words = ["yield", "designer.toml", "--samples", "1024", "--format", "json"];
    let found = result(&carom(&words, "worst", "2"));
    let worst = found["worst"].as_array().unwrap();
    assert_eq!(worst.len(), 2, "{worst:?}");
    for worst in worst {
        let file = folder("worst").join("designer").join(worst["file"].as_str().unwrap());
        let said = carom(&["run", file.to_str().unwrap(), "--format", "json"], "replayed", "1");
        let run: Value = serde_json::from_str(&said.out).unwrap();
        let plate = run["plates"].as_array().unwrap().iter().find(|plate| plate["plate"] == "lower");
        let ending = match plate {
            Some(plate) => plate["verdict"].as_str().unwrap(),
            None => run["outcome"].as_str().unwrap(),
        };
        assert_eq!(ending, worst["ending"].as_str().unwrap(), "{}", said.out);
        let speed = plate.map_or(0.0, |plate| plate["impact_speed_m_s"].as_f64().unwrap());
        assert_eq!(speed, worst["impact_speed_m_s"].as_f64().unwrap());
    }
}

#[test]
fn a_map_is_the_same_on_any_number_of_threads() {
    let axes = ["--x", "plate.lower.slope=5..40 deg:10", "--y", "contact.friction=0.05..0.5:8"];
    let words = [&["map", "designer.toml"][..], &axes, &["--format", "json"]].concat();
    let one = result(&carom(&words, "map_one", "1"));
    assert_eq!(one, result(&carom(&words, "map_two", "2")));
    let file = |name: &str, file: &str| std::fs::read(folder(name).join("designer").join(file)).unwrap();
    for name in ["map.svg", "map.csv"] {
        assert_eq!(file("map_one", name), file("map_two", name), "{name}");
    }
    let share: f64 =
        one["labels"].as_array().unwrap().iter().map(|l| l["area_share"].as_f64().unwrap()).sum();
    assert!((share - 1.0).abs() < 1e-9, "the outcomes cover the plane: {share}");
}

#[test]
fn what_is_wrong_with_a_study_is_said_at_once() {
    let map = ["map", "designer.toml", "--plate", "3", "--accuracy", "2", "--x", "plate.lower.slop=1..2 deg"];
    let said = carom(&[&map[..], &["--y", "contact.friction=-1..0.5:0"]].concat(), "bad", "1");
    assert_eq!(said.code, 2);
    for problem in ["--plate", "--accuracy", "plate.lower.slop", "cells", "5 problems"] {
        assert!(said.err.contains(problem), "{problem}: {}", said.err);
    }
    let said = carom(&["yield", "case_1.toml"], "bad", "1");
    assert_eq!(said.code, 2);
    assert!(said.err.contains("nothing varies") && said.err.contains("±"), "{}", said.err);
    let said = carom(&["yield", "designer.toml", "--samples", "0"], "bad", "1");
    assert_eq!(said.code, 2, "{}", said.err);
}
