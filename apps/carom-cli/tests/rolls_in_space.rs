//! `carom roll pyramid` and `carom roll stool` as a user meets them, and their numbers against the closed forms and an independent program's.

use crate::command;

use command::{Said, carom_on, folder, result_on, shown};
use serde_json::Value;
use std::fs;

/// Numbers that were computed independently are given to ten digits.
const PRINTED: f64 = 1e-9;

fn carom(test: &str, words: &[&str]) -> Said {
    carom_on("2", test, words)
}

fn result(test: &str, words: &[&str]) -> Value {
    result_on("2", test, words)
}

says! {
    pyramid: ["roll", "pyramid", "roll_pyramid.toml"];
    pyramid_by_default: ["roll", "pyramid"];
    pyramid_short: ["roll", "pyramid", "--set", "height_ratio=0.5"];
    pyramid_on_a_triangle: ["roll", "pyramid", "--set", "sides=3", "--set", "height=60 mm"];
    pyramid_json: ["roll", "pyramid", "--set", "sides=3", "--format", "json"];
    pyramid_with_problems: [
        "roll", "pyramid", "roll_stool.toml", "--set", "sides=2", "--set", "height=heavy", "--set", "friction=0.3",
        "--set", "inertia_axial=1 kg m^2",
    ];
    stool: ["roll", "stool", "roll_stool.toml"];
    stool_by_default: ["roll", "stool"];
    stool_json: ["roll", "stool", "roll_stool.toml", "--set", "strikes=1", "--format", "json"];
    stool_with_problems: [
        "roll", "stool", "--set", "axis=[0, 0, 0]", "--set", "spin=[1, 2]", "--set", "height=1 m", "--set",
        "centre_height=2 m", "--set", "supports=13",
    ];
    stool_below_the_plane: ["roll", "stool", "--set", "axis=[0, -1, 0]"];
    stool_that_would_slide: ["roll", "stool", "--set", "tilt=0", "--set", "spin=[0, 0, 1]"];
    stool_overturns: ["roll", "stool", "--set", "height=1 m", "--set", "tilt=11 deg"];
    stool_jams: ["roll", "stool", "--set", "spin=[0, 0, 6]"];
    stool_that_no_held_point_suits: ["roll", "stool", "--set", "spin=[0, 0, 12]"];
    stool_with_several_ways_on: [
        "roll", "stool", "roll_stool.toml", "--set", "centre_height=100 mm", "--set", "inertia_transverse=0.02", "--set",
        "inertia_axial=0.035", "--set", "spin=[-2, 0, 4]", "--set", "choice=end",
    ];
    stool_with_several_ways_through: [
        "roll", "stool", "--set", "friction=0.3", "--set", "spin=[1, 1, 1]", "--set", "choice=end",
    ];
    stool_with_too_little_time: ["roll", "stool", "--set", "time=10 ms"];
}

/// Four feet that come down at once may share the load in more than one way: they share it evenly, unless the file asks to end there.
#[test]
fn where_a_strike_leaves_the_motion_open_the_file_chooses() {
    let of = |choice: &str, name: &str| {
        let choice = format!("choice={choice}");
        let words = ["roll", "stool", "--set", "friction=0.3", "--set", "spin=[1, 1, 1]", "--set", &choice];
        let report = result(name, &words);
        let strike = report["strikes"].as_array().unwrap().last().unwrap().clone();
        assert_eq!((&strike["outcome"], &strike["end_states"]), (&"several".into(), &serde_json::json!([])));
        strike
    };
    let loaded = |strike: &Value| {
        let contacts = strike["contacts"].as_array().unwrap();
        contacts.iter().filter(|c| c["normal_impulse_N_s"].as_f64().unwrap() > 0.0).count()
    };
    for choice in ["keep most", "keep fewest"] {
        let strike = of(choice, choice);
        assert_eq!((loaded(&strike), &strike["open"]), (4, &"the motion".into()), "{choice}");
        assert_eq!(strike["forks"], serde_json::json!([]), "{choice}: a sharing is no way on");
    }
    assert!(of("end", "end")["contacts"].as_array().unwrap().is_empty(), "nothing is chosen");
}

/// Rows of a table computed by enumerating all states of a general body: n, h/a, spin after in body axes, energy ratio, normal impulses at O, A, K,
/// friction; for a = m = Ω = 1.
#[test]
fn pyramids_strike_as_in_an_independent_table() {
    type Row<'a> = (&'a str, &'a str, [f64; 3], f64, &'a [&'a str], f64);
    let rows: [Row; 4] = [
        ("3", "0.5", [0.0, 0.082_992_500_3, 0.0], 0.011_479_591_8, &["A", "K"], 1.027_436),
        (
            "4",
            "0.5",
            [-0.093_969_491_2, -0.023_696_654_3, -0.083_202_529_4],
            0.042_581_826_0,
            &["K"],
            1.352_413,
        ),
        (
            "5",
            "1.5",
            [-0.219_834_091_4, -0.159_718_816_5, -0.407_594_821_2],
            0.239_970_666_3,
            &["O", "K"],
            0.759_999,
        ),
        (
            "8",
            "3",
            [-0.232_738_580_9, -0.096_403_476_7, -0.755_743_274_3],
            0.634_608_773_8,
            &["O", "K"],
            0.420_248,
        ),
    ];
    for (sides, ratio, spin, energy, kept, friction) in rows {
        let set = [format!("sides={sides}"), format!("height_ratio={ratio}")];
        let words = [
            "roll",
            "pyramid",
            "--set",
            &set[0],
            "--set",
            &set[1],
            "--set",
            "circumradius=1",
            "--set",
            "roll_rate=1",
        ];
        let json = result(&format!("table_{sides}_{ratio}"), &words);
        let strike = &json["strikes"][0];
        for (ours, printed) in strike["spin_rad_s"].as_array().unwrap().iter().zip(spin) {
            assert!((ours.as_f64().unwrap() - printed).abs() < PRINTED, "{sides} {ratio}: {ours} {printed}");
        }
        let of = |key: &str| strike[key].as_f64().unwrap();
        assert!((of("energy_after_J") / of("energy_before_J") - energy).abs() < PRINTED, "{sides} {ratio}");
        // Six digits are printed.
        assert!(
            (of("friction_demand") - friction).abs() < 1e-6,
            "{sides} {ratio}: {}",
            of("friction_demand")
        );
        assert_eq!(strike["kept"], serde_json::json!(kept), "{sides} {ratio}");
        assert_eq!(strike["closed_form"]["agrees"], true, "{sides} {ratio}: {}", strike["closed_form"]);
        let states =
            strike["end_states"].as_array().unwrap().len() + strike["rejected"].as_array().unwrap().len();
        assert_eq!(states, 8, "{sides} {ratio}: every state of three contacts");
    }
}

/// The reason that is given for the short pyramid is the printed criterion: the apex's normal impulse, `N_K (h² − q a²)/Q` in the state that keeps O and K.
#[test]
fn the_refused_state_of_a_short_pyramid_names_the_printed_criterion() {
    let json = result(
        "short",
        &["roll", "pyramid", "--set", "height_ratio=0.5", "--set", "circumradius=1", "--set", "roll_rate=1"],
    );
    let rejected = json["strikes"][0]["rejected"].as_array().unwrap();
    let both = rejected.iter().find(|r| r["kept"] == serde_json::json!(["O", "K"])).unwrap();
    assert_eq!(both["at"], "O");
    // n = 4, a = m = Ω = 1, h = 1/2: q = 2/3, Q = 5/3, B = 7/6, L = √1.25, D = √0.75, S = √½.
    let (q, big_q, b, edge, slant) = (2.0 / 3.0, 5.0 / 3.0, 7.0 / 6.0, 1.25_f64.sqrt(), 0.75_f64.sqrt());
    let at_k = 0.3 * 0.5_f64.sqrt() * big_q * b / (edge * slant * (big_q + 2.0 * q * 0.25));
    let at_o = at_k * (0.25 - q) / big_q;
    let ours = both["normal_impulse_N_s"].as_f64().unwrap();
    assert!((ours - at_o).abs() < 1e-14, "{ours} {at_o}");
}

/// A tripod and a cube that another program has followed: DOP853 at 1e-13, events refined by integrating again.
#[test]
fn stools_fall_as_in_an_independent_program() {
    let tripod = result(
        "tripod",
        &["roll", "stool", "roll_stool.toml", "--set", "axis=[0.3, 1, 0]", "--set", "spin=[0, 0, 0]"],
    );
    let strikes = tripod["strikes"].as_array().unwrap();
    assert_eq!(strikes.len(), 2, "two strikes");
    let time = |i: usize| strikes[i]["t_s"].as_f64().unwrap();
    assert!(
        (time(0) - 0.074_631_585_825_16).abs() < 1e-12 && (time(1) - 0.088_009_433_915_60).abs() < 1e-12,
        "{strikes:?}"
    );
    assert_eq!(strikes[0]["kept"], serde_json::json!(["0", "2"]));
    assert_eq!(strikes[1]["kept"], serde_json::json!(["0", "1", "2"]));
    assert_eq!(tripod["end"]["state"], "at rest");
    let cube = result(
        "cube",
        &["roll", "stool", "--set", "circle_radius=0.1414213562373095", "--set", "height=0.2"],
    );
    let first = &cube["strikes"][0];
    assert!((first["t_s"].as_f64().unwrap() - 0.063_476_656_235_59).abs() < 1e-12, "{}", first["t_s"]);
    // Its time of rest is the sum of a geometric series of the last strikes it computed: trusted to eight digits.
    assert!((cube["end"]["t_s"].as_f64().unwrap() - 0.157_380_551_1).abs() < 1e-8, "{}", cube["end"]["t_s"]);
    let forms: Vec<&Value> = cube["strikes"].as_array().unwrap().iter().map(|s| &s["closed_form"]).collect();
    assert!(forms.iter().all(|form| form["agrees"] == true), "{forms:?}");
}

/// From face to face and back, round either way, from support to support, and flat: whatever a closed form covers, and it covers most.
#[test]
fn strikes_agree_with_the_closed_forms_that_cover_them() {
    let cases: [&[&str]; 6] = [
        &["pyramid", "strikes=30"],
        &["pyramid", "strikes=30", "sides=7", "tilt=0.3"],
        &["pyramid", "strikes=30", "sides=12", "height_ratio=3"],
        &["stool", "supports=3", "spin=[0.5, 0, 1]", "axis=[0.05, 1, 0]"],
        &["stool", "supports=5", "spin=[0.5, 0, -1]", "axis=[0.05, 1, 0]"],
        &["stool", "supports=6", "axis=[-0.05, 1, 0]"],
    ];
    for (i, case) in cases.iter().enumerate() {
        let set: Vec<&str> = case[1..].iter().flat_map(|key| ["--set", key]).collect();
        let json = result(&format!("forms_{i}"), &[&["roll", case[0]], &set[..]].concat());
        let strikes = json["strikes"].as_array().unwrap();
        let covered: Vec<&Value> =
            strikes.iter().map(|s| &s["closed_form"]).filter(|form| form.is_object()).collect();
        assert!(
            10 * covered.len() >= 9 * strikes.len() && covered.len() > 5,
            "{case:?}: {} of {}",
            covered.len(),
            strikes.len()
        );
        for form in covered {
            assert_eq!(form["agrees"], true, "{case:?}: {form}");
        }
    }
}

/// A body and its mirror image strike alike at the same times, whatever they keep.
#[test]
fn a_mirror_image_strikes_at_the_same_times() {
    let of = |name: &str, axis: &str, spin: &str| {
        let json = result(
            name,
            &["roll", "stool", "--set", "supports=5", "--set", axis, "--set", spin, "--set", "strikes=20"],
        );
        let strikes = json["strikes"].as_array().unwrap().clone();
        let kept = |s: &Value| {
            s["kept"]
                .as_array()
                .unwrap()
                .iter()
                .map(|k| k.as_str().unwrap().parse::<usize>().unwrap())
                .collect::<Vec<_>>()
        };
        strikes.iter().map(|s| (s["t_s"].as_f64().unwrap(), kept(s))).collect::<Vec<_>>()
    };
    // Reflected in the plane y = 0: turns about x and z turn round, supports count the other way.
    let (one, other) = (
        of("left", "axis=[0.1, 1, 0]", "spin=[0.3, 0.2, 1]"),
        of("right", "axis=[-0.1, 1, 0]", "spin=[-0.3, 0.2, -1]"),
    );
    assert_eq!(one.len(), other.len(), "as many strikes");
    for ((time, kept), (mirrored, image)) in one.iter().zip(&other) {
        // What rounding grows to over twenty strikes of a tenth of a second.
        assert!((time - mirrored).abs() < 1e-12, "{time} {mirrored}");
        let mut image: Vec<usize> = image.iter().map(|k| (5 - k) % 5).collect();
        image.sort_unstable();
        assert_eq!(*kept, image, "at {time}");
    }
}

#[test]
fn reports_are_written_and_can_be_turned() {
    for kind in ["pyramid", "stool"] {
        let said = carom(&format!("page_{kind}"), &["roll", kind, &format!("roll_{kind}.toml")]);
        assert_eq!(said.code, 0, "{}", said.err);
        let folder = folder(&format!("page_{kind}/{kind}"));
        let page = fs::read_to_string(folder.join("report.html")).unwrap();
        for part in
            ["<canvas", "id=\"player\"", "id=\"solid-numbers\"", "class=\"fig tilt\"", "id=\"hypotheses\""]
        {
            assert!(page.contains(part), "{kind}: {part}");
        }
        assert!(!page.contains("http://") && !page.contains("https://"), "nothing from the network");
        assert!(!page.contains("NaN"), "{kind}: no number that is none");
        let json: Value =
            serde_json::from_str(&fs::read_to_string(folder.join("roll.json")).unwrap()).unwrap();
        assert_eq!(json["kind"], kind);
    }
}
