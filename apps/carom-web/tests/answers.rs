//! Requests of every kind, answered without a browser.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use serde_json::{Value, json};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

fn example(name: &str) -> String {
    std::fs::read_to_string(format!("{}/../../examples/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

fn ask(name: &str, text: &str, ask: &Value) -> Value {
    let request = json!({ "name": name, "text": text, "ask": ask });
    serde_json::from_str(&carom_web::answer(&request.to_string(), &())).unwrap()
}

fn show(name: &str, text: &str, change: &Value) -> Value {
    let window = json!({ "low": [-0.3, -0.2], "scale": 1000.0, "size": [600.0, 400.0], "speed": 50.0 });
    ask(name, text, &json!({ "show": { "change": change, "frame": { "window": window } } }))
}

#[test]
fn every_kind_of_file_is_shown() {
    let kinds = [
        ("case_2.toml", "scene"),
        ("impact_box.toml", "impact"),
        ("impact_operator.toml", "impact"),
        ("contact_painleve.toml", "impact"),
        ("roll_prism.toml", "roll"),
        ("roll_stool.toml", "solid"),
        ("roll_body.toml", "solid"),
        ("solid.toml", "space"),
    ];
    for (name, kind) in kinds {
        let shown = show(name, &example(name), &Value::Null);
        assert_eq!(shown["kind"], kind, "{name}: {}", shown["failure"]);
        let quantities = shown["quantities"].as_array().unwrap();
        assert!(quantities.len() > 5, "{name} has values");
        assert!(!shown["headline"]["word"].as_str().unwrap().is_empty(), "{name} ends somehow");
    }
}

#[test]
fn what_is_pulled_is_written_in_whole_steps() {
    let text = example("impact_box.toml");
    let pull = |table: &str, key: &str, from: [f64; 2], at: [f64; 2]| {
        let pulled = json!({ "table": table, "key": key, "from": from });
        let shown =
            show("box.toml", &text, &json!({ "pull": { "pulled": pulled, "at": at, "fine": false } }));
        shown["text"].as_str().unwrap_or_else(|| panic!("{}", shown["failure"])).to_owned()
    };
    // A pixel is a millimetre, and the step is 5 mm.
    assert!(
        pull("contact.0", "point", [-0.05, -0.02], [271.0, 221.0])
            .contains("point       = [\"-30 mm\", \"-20 mm\"]")
    );
    assert!(pull("contact.0", "normal", [-0.05, -0.02], [300.0, 220.0]).contains("normal      = [1, 0]"));
    // 50 pixels are 1 m/s, and near the mass centre it stands still.
    assert!(
        pull("body", "velocity", [0.0, 0.0], [350.0, 300.0])
            .contains("velocity = [\"1.0 m/s\", \"-2.0 m/s\"]")
    );
    assert!(
        pull("body", "velocity", [0.0, 0.0], [301.0, 201.0]).contains("velocity = [\"0 m/s\", \"0 m/s\"]")
    );
}

#[test]
fn contacts_come_and_go() {
    let text = example("impact_box.toml");
    let more = show("box.toml", &text, &json!({ "add_contact": { "at": [300.0, 350.0] } }));
    let written = more["text"].as_str().unwrap();
    assert!(written.contains("point = [\"0 mm\", \"-150 mm\"]\nnormal = [0, 1]"), "{written}");
    let fewer = show("box.toml", written, &json!({ "remove_contact": { "contact": 2 } }));
    assert_eq!(fewer["text"].as_str().unwrap().trim(), text.trim());
    // Of several bodies nobody knows which two a new contact is between.
    let cradle =
        show("cradle.toml", &example("impact_cradle.toml"), &json!({ "add_contact": { "at": [0.0, 0.0] } }));
    assert!(cradle["failure"]["message"].as_str().unwrap().contains("write which two meet"));
}

#[test]
fn what_does_not_fit_is_told_and_nothing_panics() {
    let changes = [
        json!({ "pull": { "pulled": { "table": "contact.9", "key": "point", "from": [0.0, 0.0] }, "at": [1.0, 1.0], "fine": true } }),
        json!({ "remove_contact": { "contact": 99 } }),
        json!({ "remove": { "obstacle": 99 } }),
        json!({ "want": { "plate": 99, "want": "turned" } }),
        json!({ "write": { "path": "no.such.path", "value": "1" } }),
        json!({ "move": { "values": { "no.such": 1.0 } } }),
    ];
    let texts = ["case_2.toml", "impact_box.toml", "roll_prism.toml", "roll_stool.toml"].map(example);
    for text in texts.iter().map(String::as_str).chain(["", "]", "a = 1", "[body]\nmass = 1", "sides = 0"]) {
        for change in &changes {
            let shown = show("x.toml", text, change);
            assert!(shown["failure"]["message"].is_string(), "{change} of {text:.20}: {shown:.200}");
        }
        for study in [json!("files"), json!({ "at": { "values": {} } })] {
            ask("x.toml", text, &json!({ "study": study }));
        }
        let shared = json!({ "yield": { "samples": 16, "seed": 1 } });
        for known in [json!([]), json!([["[1, 2"]]), json!([["[1, 2]"]]), json!([[], []])] {
            let joined = ask("x.toml", text, &json!({ "joined": { "study": shared, "known": known } }));
            assert!(joined["failure"]["message"].is_string(), "{known} of {text:.20}: {joined:.200}");
        }
    }
}

/// Long work by so many workers, and how many steps the last of all took.
fn shared(name: &str, text: &str, study: &Value, of: u32) -> (Value, usize) {
    let mut known: Vec<Vec<String>> = vec![];
    loop {
        let round = known.len();
        let portion = |number: u32| {
            let asked = json!({ "study": study, "round": round, "number": number, "of": of });
            let reply = ask(name, text, &json!({ "portion": asked }));
            assert!(reply["portion"].is_string(), "{}", reply["failure"]);
            reply["portion"].as_str().unwrap().to_owned()
        };
        known.push((0..of).map(portion).collect());
        let joined = json!({ "joined": { "study": study, "known": known } });
        let request = json!({ "name": name, "text": text, "ask": joined });
        let heard = Heard::default();
        let reply: Value = serde_json::from_str(&carom_web::answer(&request.to_string(), &heard)).unwrap();
        if reply["again"] != true {
            return (reply, heard.steps.into_inner());
        }
    }
}

#[test]
fn workers_say_together_what_one_says() {
    let side = |path: &str, from: f64, to: f64| json!({ "path": path, "from": from, "to": to });
    let map = |axes: [Value; 2], cells: usize| json!({ "map": { "axes": axes, "cells": cells, "depth": 1, "accuracy": 1e-3 } });
    let of_scene = [side("contact.friction", 0.05, 0.4), side("contact.restitution", 0.0, 0.4)];
    let of_impact = [side("contact.0.friction", 0.05, 1.0), side("contact.1.friction", 0.05, 1.0)];
    for (name, study) in [
        ("designer.toml", json!({ "yield": { "samples": 2048, "seed": 1 } })),
        ("case_2.toml", map(of_scene, 8)),
        ("impact_step.toml", map(of_impact, 6)),
    ] {
        let text = example(name);
        let (one, _) = shared(name, &text, &study, 1);
        assert!(one["html"].as_str().unwrap().len() > 1000, "{name}: a picture or tables");
        for of in [2, 5, 40] {
            let (several, steps) = shared(name, &text, &study, of);
            assert_eq!(several, one, "{name} by {of} workers");
            assert!(steps < 40, "{name}: {steps} drops had to be asked again of {of} workers");
        }
    }
}

#[test]
fn regions_of_an_impact_are_told_at_each_point_as_they_are_drawn() {
    let text = example("impact_step.toml");
    let side = |path: &str| json!({ "path": path, "from": 0.05, "to": 1.0 });
    let axes = [side("contact.0.friction"), side("contact.1.friction")];
    let map = json!({ "map": { "axes": axes, "cells": 6, "depth": 0, "accuracy": 1e-2 } });
    let html = shared("step.toml", &text, &map, 1).0["html"].as_str().unwrap().to_owned();
    let at = json!({ "at": { "values": { "contact.0.friction": 0.5, "contact.1.friction": 0.1 } } });
    let there =
        ask("step.toml", &text, &json!({ "study": at }))["headline"]["word"].as_str().unwrap().to_owned();
    assert!(html.contains(&there), "{there} is in the legend");
}

#[derive(Default)]
struct Heard {
    steps: AtomicUsize,
    news: Mutex<Vec<String>>,
}

impl carom_web::Watch for Heard {
    fn step(&self) {
        self.steps.fetch_add(1, Ordering::Relaxed);
    }

    fn told(&self, news: &str) {
        self.news.lock().unwrap().push(news.to_owned());
    }
}

#[test]
fn a_search_tells_how_far_it_is() {
    let heard = Heard::default();
    let study = json!({ "design": { "scan": 16, "samples": 16, "seed": 1 } });
    let request = json!({ "name": "d.toml", "text": example("designer.toml"), "ask": { "study": study } });
    let found: Value = serde_json::from_str(&carom_web::answer(&request.to_string(), &heard)).unwrap();
    let news = heard.news.into_inner().unwrap();
    assert_eq!(news.len(), 9, "one for each look");
    let last: Value = serde_json::from_str(news.last().unwrap()).unwrap();
    assert_eq!((&last["look"], &last["looks"]), (&json!(9), &json!(9)));
    assert!(last["best"]["picture"].as_str().unwrap().contains("<path"), "the best so far is seen");
    assert!(heard.steps.into_inner() > 1000, "every drop is counted");
    assert_eq!(found["found"]["possible"], true, "{}", found["failure"]);
}
