//! `carom roll body` as a user meets it: from vertices and from an STL file, once and many times.

use crate::command;

use command::{Said, carom_on, folder, result_on as result, shown};
use serde_json::Value;
use std::fs;

fn carom(test: &str, words: &[&str]) -> Said {
    carom_on("2", test, words)
}

says! {
    brick: ["roll", "body", "roll_body.toml"];
    surface: ["roll", "body", "bolt.stl", "--set", "density=7800 kg/m^3", "--set", "turn=2.9", "--set", "strikes=3"];
    throws: ["roll", "body", "roll_body.toml", "--throws", "64", "--seed", "7"];
    body_with_problems: ["roll", "body", "bolt.stl", "--set", "densty=1", "--set", "height=-1 mm", "--set", "centre=[0, 0, \"1 m\"]"];
    body_with_an_impossible_inertia: [
        "roll", "body", "--set", "inertia=[1, 1, 3]", "--set", "height=-1 mm", "--set", "friction=-1",
    ];
    bolt_with_friction: ["roll", "body", "bolt.stl", "--set", "friction=0.3"];
    flat_body: [
        "roll", "body", "--set",
        "vertices=[['0 m', '0 m', '0 m'], ['10 mm', '0 m', '0 m'], ['0 m', '10 mm', '0 m'], ['10 mm', '10 mm', '1e-6 mm']]",
    ];
    no_such_surface: ["roll", "body", "nut.stl"];
    throws_of_a_stool: ["roll", "stool", "--throws", "64"];
}

#[test]
fn examples_come_to_rest_on_stable_faces() {
    for (file, face) in
        [("roll_body.toml", 1), ("roll_body_bolt.toml", 22), ("roll_body_tetrahedron.toml", 3)]
    {
        let report = result("1", &format!("rest_{face}"), &["roll", "body", file]);
        assert_eq!(report["end"]["state"], "at rest", "{file}");
        assert_eq!(report["resting"]["face"], face, "{file}");
        assert_eq!(report["body"]["faces"][face]["stable"], true, "{file}");
        assert!(report["inertia_axial_kg_m2"].is_null(), "a polyhedron has no axis of its own");
        let energy = |key: &str| report["resting"][key].as_f64().unwrap();
        assert!(energy("energy_end_J") < energy("energy_start_J"), "{file}");
        // At rest it has nothing but its height: m g h.
        let height = report["body"]["faces"][face]["centre_height_m"].as_f64().unwrap();
        let weight = report["mass_kg"].as_f64().unwrap() * 9.81;
        assert!((energy("energy_end_J") / (weight * height) - 1.0).abs() < 1e-9, "{file}");
    }
}

#[test]
fn with_friction_vertices_slide_and_lose_no_more_than_there_is() {
    let report = result("1", "friction", &["roll", "body", "roll_body.toml", "--set", "friction=0.1"]);
    assert_eq!((&report["end"]["state"], &report["friction"]), (&"at rest".into(), &0.1.into()));
    for strike in report["strikes"].as_array().unwrap() {
        assert!(strike["energy_after_J"].as_f64() <= strike["energy_before_J"].as_f64(), "{strike}");
        assert!(
            strike["friction_demand"].is_null() && strike["end_states"] == serde_json::json!([]),
            "{strike}"
        );
        for contact in strike["contacts"].as_array().unwrap() {
            let of = |key: &str| contact[key].as_f64().unwrap();
            assert!(
                of("tangential_impulse_N_s") <= 0.1 * of("normal_impulse_N_s") * (1.0 + 1e-9),
                "{contact}"
            );
        }
    }
    assert_eq!(report["strikes"][0]["contacts"][0]["state"], "slides");
}

/// What friction stops in a strike rests exactly, and is said to keep.
#[test]
fn what_friction_stops_keeps() {
    let report = result("1", "stops", &["roll", "body", "--set", "friction=0.7"]);
    let contact = &report["strikes"][0]["contacts"][0];
    assert_eq!(
        (&contact["state"], &contact["velocity_m_s"]),
        (&"keeps".into(), &serde_json::json!([0.0, 0.0, 0.0]))
    );
    assert_eq!(report["strikes"][0]["state"], "1 keeps");
}

/// A box that lands on an edge, and on a face, without any friction: nothing moves it along the plane.
#[test]
fn without_any_friction_what_nothing_moves_rests() {
    for axis in ["axis=[1, 0, 0]", "axis=[2, 1, 0.5]"] {
        let words = ["roll", "body", "--set", "friction=0", "--set", axis];
        let report = result("1", "frictionless", &words);
        assert_eq!(report["end"]["state"], "at rest", "{axis}");
    }
}

#[test]
fn throws_are_all_counted_and_the_same_on_any_number_of_threads() {
    let words = ["roll", "body", "roll_body_tetrahedron.toml", "--throws", "100", "--seed", "3"];
    let [mut one, mut three] =
        ["1", "3"].map(|threads| result(threads, &format!("threads_{threads}"), &words));
    for report in [&mut one, &mut three] {
        report.as_object_mut().unwrap().remove("run").expect("what it took stands apart");
    }
    assert_eq!(one, three);
    assert_eq!(one["throws"], 128, "rounded up");
    let count = |end: &Value| end["probability"]["count"].as_u64().unwrap();
    let ends = one["ends"].as_array().unwrap();
    assert_eq!(ends.iter().map(count).sum::<u64>(), 128, "no throw is lost");
    let other = result("2", "seed", &["roll", "body", "roll_body_tetrahedron.toml", "--throws", "100"]);
    assert_ne!(one["ends"], other["ends"], "another seed");
}

#[test]
fn the_first_throw_of_an_end_is_made_again() {
    let many = result("2", "many", &["roll", "body", "roll_body.toml", "--throws", "64"]);
    for (i, end) in many["ends"].as_array().unwrap().iter().enumerate() {
        let Some(set) = end["first"]["set"].as_array() else { continue };
        let set: Vec<&str> = set.iter().flat_map(|set| ["--set", set.as_str().unwrap()]).collect();
        let again =
            result("1", &format!("again_{i}"), &[&["roll", "body", "roll_body.toml"], &set[..]].concat());
        if end["face"].is_null() {
            assert_eq!(again["end"]["state"], end["end"], "{set:?}");
        } else {
            assert_eq!(again["resting"]["face"], end["face"], "{set:?}");
        }
    }
}

#[test]
fn pages_are_whole_and_need_no_network() {
    for (test, file, words) in [
        ("page", "body/report.html", &["roll", "body", "bolt.stl"][..]),
        ("throws_page", "throws/throws.html", &["roll", "body", "roll_body.toml", "--throws", "32"][..]),
    ] {
        assert_eq!(carom(test, words).code, 0, "{words:?}");
        let page = fs::read_to_string(folder(test).join(file)).unwrap();
        assert!(page.ends_with("</html>\n") && page.contains("id=\"solid\""), "{file}");
        assert!(!page.contains("http") && !page.contains("NaN"), "{file}");
    }
}
