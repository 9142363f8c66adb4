//! `carom contact`: contacts under forces.

use crate::command;

use command::{Said, answers, command, empty, folder};
use serde_json::Value;

/// A uniform rod of 1 kg, ℓ = 1 m, that slides with 1 m/s into its lean; `lean` is cos θ and sin θ.
fn rod(lean: [f64; 2], friction: f64, spin: f64) -> String {
    let [cos, sin] = lean;
    // The end slides along the plate: the mass centre goes with it.
    let velocity = [1.0 - spin * sin, -spin * cos];
    format!(
        r#"{{"gravity": 10, "body": {{"mass": 1, "inertia": {}, "velocity": [{}, {}], "spin": {spin}}}, "contact": [{{"name": "end", "point": [{cos}, -{sin}], "normal": [0, 1], "friction": {friction}}}]}}"#,
        1.0 / 3.0,
        velocity[0],
        velocity[1]
    )
}

fn lines(input: &str) -> (i32, Vec<Value>) {
    answers("contact_lines", &["contact", "-"], input)
}

#[test]
fn a_rod_has_one_motion_or_none_or_two_as_painleve_says() {
    let lean = [0.5, 3f64.sqrt() / 2.0];
    // m A = 1 + 3 cos θ (cos θ − μ sin θ): 1.75 − 3 · 1.6 · 0.433 < 0, and positive for μ = 1.
    let pressed = |friction: f64| 1.0 + 3.0 * lean[0] * (lean[0] - friction * lean[1]);
    let input = [rod(lean, 1.0, 0.0), rod(lean, 1.6, 0.0), rod(lean, 1.6, 4.0)].join("\n");
    let (code, said) = lines(&input);
    assert_eq!(code, 0, "{said:?}");
    let outcomes: Vec<&str> = said.iter().map(|answer| answer["outcome"].as_str().unwrap()).collect();
    assert_eq!(outcomes, ["unique", "none", "several"], "m A = {} and {}", pressed(1.0), pressed(1.6));

    // It slides: N cancels the weight at the end, and friction takes μN.
    let contact = &said[0]["solutions"][0]["contacts"][0];
    let force = 10.0 / pressed(1.0);
    let is = |key: &str, value: f64| (contact[key].as_f64().unwrap() - value).abs() < 1e-12;
    assert!(is("normal_force_N", force) && is("tangential_force_N", -force), "{contact}");
    assert!(is("normal_acceleration_m_s2", 0.0), "{contact}");
    let centre = said[0]["solutions"][0]["acceleration_m_s2"].as_array().unwrap();
    assert!((centre[1].as_f64().unwrap() - (force - 10.0)).abs() < 1e-12, "{centre:?}");

    // Thrown off with ω² sin θ − 10, or held down against that.
    let free = 16.0 * lean[1] - 10.0;
    let held = free / -pressed(1.6);
    let of = |k: usize| {
        let contact = &said[2]["solutions"][k]["contacts"][0];
        ["normal_force_N", "normal_acceleration_m_s2"].map(|key| contact[key].as_f64().unwrap())
    };
    let near = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).abs().max((a[1] - b[1]).abs()) < 1e-12;
    assert!(near(of(0), [0.0, free]) && near(of(1), [held, 0.0]), "{:?} {:?} {free} {held}", of(0), of(1));
}

#[test]
fn a_line_with_problems_is_answered_by_them_and_the_rest_go_on() {
    let good = rod([0.5, 3f64.sqrt() / 2.0], 1.0, 0.0);
    let falls = good.replace("\"velocity\": [1,", "\"velocity\": [-3,").replace(", -0]", ", -2]");
    let operator =
        r#"{"operator": {"w_tt": 1, "w_tn": 0, "w_nn": 1, "slip": 0, "approach": -1, "friction": 0}}"#;
    let (code, said) = lines(&[&falls, "{}", operator, &good].map(String::from).join("\n"));
    assert_eq!((code, said.len()), (2, 4), "{said:?}");
    let message = |k: usize| said[k]["error"]["problems"][0]["message"].as_str().unwrap().to_owned();
    assert!(message(0).contains("normal velocity of end is -2"), "{}", message(0));
    assert!(message(1).contains("missing"), "{}", message(1));
    assert!(message(2).contains("has no forces"), "{}", message(2));
    assert_eq!(said[3]["outcome"], "unique", "the rest goes on");
}

#[test]
fn an_answer_goes_into_the_folder_that_is_asked_for() {
    let example = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/contact_painleve.toml");
    let place = empty("contact_out");
    let asked = ["contact", example, "--format", "json"];
    let said: Said = command(&asked, &place).output().unwrap().into();
    let file = place.join("contact_painleve/contact.json");
    assert_eq!((said.code, said.err), (0, format!("answer {}\n", file.display())), "it says where");
    assert_eq!(std::fs::read_to_string(file).unwrap(), said.out, "the answer as it is printed");
}

#[test]
fn the_text_names_the_motion_and_what_rejects_the_others() {
    let example = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/contact_painleve.toml");
    let said: Said = command(&["contact", example], &folder("contact_text")).output().unwrap().into();
    assert_eq!(said.code, 0, "{}", said.err);
    assert!(said.out.starts_with("NO MOTION IS CONSISTENT: Painlevé's paradox"), "{}", said.out);
    assert!(
        said.out.contains("end separates") && said.out.contains("end would still approach"),
        "{}",
        said.out
    );
    assert!(said.out.contains("normal force at end < 0"), "{}", said.out);
}
