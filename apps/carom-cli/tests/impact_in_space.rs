//! An impact in space as a user meets it.

use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// What rounding leaves of numbers of order one.
const ROUNDING: f64 = 1e-12;

fn example() -> String {
    named("impact_twist.toml")
}

fn named(name: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name)).unwrap()
}

fn file(test: &str, text: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{test}.toml"));
    fs::write(&path, text).unwrap();
    path
}

fn carom(path: &Path, more: &[&str]) -> (i32, String, String) {
    let output =
        Command::new(env!("CARGO_BIN_EXE_carom")).arg("impact").arg(path).args(more).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

fn answer(test: &str, text: &str) -> Value {
    let (code, said, errors) = carom(&file(test, text), &["--format", "json"]);
    assert_eq!((code, errors.as_str()), (0, ""), "{text}");
    serde_json::from_str(&said).unwrap()
}

#[test]
fn the_slips_of_a_drifting_rod_turn_and_stop_one_after_the_other() {
    let twist = answer("twist", &example());
    assert_eq!(twist["outcome"], "unique");
    let stages = twist["stages"].as_array().unwrap();
    let ends: Vec<&str> = stages.iter().map(|stage| stage["ended_by"].as_str().unwrap()).collect();
    let stop = |which: &str| format!("slip stops at {which}");
    assert_eq!(ends, ["compression ends", &stop("A"), &stop("B"), "restitution ends"]);
    assert_eq!(stages[0]["straight"], false, "slips turn");
    for stage in stages {
        assert_eq!(stage["ways_on"].as_array().unwrap().len(), 1, "{stage}");
        // An end that slips has one hypothesis, one that does not has two; while it touches it may be open as well. All but one are rejected by name.
        let rejected = stage["rejected"].as_array().unwrap();
        let least = if stage["phase"] == "compression" { 3 } else { 0 };
        assert!(rejected.len() >= least, "{stage}");
        assert!(rejected.iter().all(|r| !r["because"].as_str().unwrap().is_empty()), "{stage}");
    }
    let end = &twist["end"];
    let energy = |key: &str| end[key].as_f64().unwrap();
    assert!(energy("energy_after_J") < energy("energy_before_J"));
    for contact in end["contacts"].as_array().unwrap() {
        assert!((contact["normal_velocity_m_s"].as_f64().unwrap() - 0.5).abs() < ROUNDING, "{contact}");
    }
    assert_eq!(twist["non_sliding"][0]["hypothesis"], "A keeps; B keeps");
    assert_eq!(twist["non_sliding_rejected"].as_array().unwrap().len(), 3, "the other three states");
}

#[test]
fn without_drift_the_spin_goes_as_its_closed_form_says() {
    let still = example().replace("[\"0.4 m/s\", \"0.4 m/s\", ", "[0, 0, ");
    // μ m v a/J = 6 μ in compression, a half of it in restitution.
    for (friction, spin) in [(0.05, 0.45), (0.45, 0.0)] {
        let text = still.replace("0.45", &friction.to_string());
        let after = answer("still", &text)["end"]["spin_rad_s"][2].as_f64().unwrap();
        assert!((after - spin).abs() < ROUNDING, "friction {friction}: {after}");
        let (_, said, _) = carom(&file("still", &text), &[]);
        assert!(said.contains("closed form") && said.contains(": agrees"), "{said}");
    }
}

#[test]
fn a_page_is_written_and_every_fault_is_named() {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("impact_in_space");
    let (code, said, errors) = carom(&file("page", &example()), &["--out", out.to_str().unwrap()]);
    assert!(code == 0 && said.contains("stage 1, compression: A slips, B slips"), "{said}{errors}");
    let page = fs::read_to_string(out.join("page/report.html")).unwrap();
    assert!(page.contains("stage 1") && page.contains("would still approach"), "hypotheses on the page");
    let bad =
        example().replace("normal      = [0, 0, 1]", "normal      = [0, 1]").replace("1 kg\"", "-1 kg\"");
    let (code, _, errors) = carom(&file("bad", &bad), &[]);
    assert_eq!(code, 2, "{errors}");
    for what in ["body.mass", "contact.0.normal", "contact.1.normal", "three numbers"] {
        assert!(errors.contains(what), "{what}: {errors}");
    }
    let impossible = example().replace("[1e-4, ", "[1, ");
    let (code, _, errors) = carom(&file("impossible", &impossible), &[]);
    assert!(code == 2 && errors.contains("principal moments"), "{errors}");
}

#[test]
fn what_may_take_long_says_so_before_it_begins() {
    let body = "body = { mass = 1, inertia = [0.4, 0.4, 0.4], velocity = [0, 0, 1] }\n";
    let foot = |x: usize| {
        format!("[[contact]]\npoint = [{x}, 0, -1]\nnormal = [0, 0, 1]\nfriction = 0.3\nrestitution = 0\n")
    };
    for (count, says) in [(5, false), (6, true)] {
        let text = body.to_owned() + &(0..count).map(foot).collect::<String>();
        let (code, said, errors) = carom(&file("many", &text), &[]);
        assert!(code == 0 && said.starts_with("NOTHING HAPPENS"), "{said}{errors}");
        assert_eq!(errors.starts_with(&format!("{count} contacts: ")), says, "{errors}");
    }
}

/// A body of three contacts with one friction, for which no hypothesis is consistent where its impact starts.
const PARADOX: &str = "
law = 'poisson'
[body]
mass = 0.3422059019002911
inertia = [0.019897331714858964, 0.03767202583049526, 0.035001269687660014]
velocity = [-0.377662744328299, -0.057772020481583364, 1.0242073279167256]
spin = [-0.5853920498013141, -0.09876749970933225, 0.3486079898097021]
[[contact]]
point = [-0.34327685387780293, 0.3539785716137293, 0.41435952690763544]
normal = [-0.14995179772904704, -0.7962495086626681, -0.5860897357165425]
friction = 1.411866303760657
restitution = 0.7820850369686129
[[contact]]
point = [0.31608044948984027, 1.2970973815349116, -1.0356397653629077]
normal = [-0.14995179772904704, -0.7962495086626681, -0.5860897357165425]
friction = 1.411866303760657
restitution = 0.7820850369686129
[[contact]]
point = [0.12522606349506418, 0.05495889330428919, 0.7007344742999427]
normal = [-0.14995179772904704, -0.7962495086626681, -0.5860897357165425]
friction = 1.411866303760657
restitution = 0.7820850369686129
";

#[test]
fn a_stage_that_no_hypothesis_allows_is_called_forced_everywhere() {
    let said = answer("paradox", PARADOX);
    assert_eq!(said["outcome"], "forced", "it is never unique");
    let first = &said["stages"][0];
    assert!(first["forced"].as_str().unwrap().contains("A"), "{first}");
    assert_eq!(first["ways_on"].as_array().unwrap().len(), 0, "none is consistent");
    // B rises: of the two that approach, which slip, each is open or holds.
    assert_eq!(first["rejected"].as_array().unwrap().len(), 4, "and each is refused by name: {first}");
    let forced = said["stages"].as_array().unwrap().iter().filter(|stage| !stage["forced"].is_null()).count();
    assert!((1..6).contains(&forced), "the others are consistent: {forced}");
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("paradox_in_space");
    let (code, text, errors) = carom(&file("paradox", PARADOX), &["--out", out.to_str().unwrap()]);
    let lead = text.lines().nth(1).unwrap();
    assert!(code == 0 && lead.contains("no way on is consistent at"), "{text}{errors}");
    assert!(!text.contains("one way on"), "{text}");
    assert!(text.contains("  no way on is consistent: friction drives A in"), "{text}");
    let page = fs::read_to_string(out.join("paradox/report.html")).unwrap();
    assert!(page.contains("stage 1: no way on is consistent: friction drives A in"), "the page says so");
}

#[test]
fn several_bodies_are_told_in_text_on_the_page_and_in_lines() {
    let balls = named("impact_space_balls.toml");
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("balls_in_space");
    let (code, said, errors) = carom(&file("balls", &balls), &["--out", out.to_str().unwrap()]);
    assert!(code == 0 && said.starts_with("BALLS SEPARATES, CUSHION"), "{said}{errors}");
    for what in ["cue ", "red ", "cushion ", "velocity m/s", "J before"] {
        assert!(said.contains(what), "{what}: {said}");
    }
    let page = fs::read_to_string(out.join("balls/report.html")).unwrap();
    assert!(page.contains("After, red: velocity"), "each body on the page");
    let answer = answer("balls_json", &balls);
    let names: Vec<&str> = answer["end"]["bodies"]
        .as_array()
        .unwrap()
        .iter()
        .map(|body| body["name"].as_str().unwrap())
        .collect();
    assert_eq!(names, ["cue", "red", "cushion"], "in the file's order");
    assert!(answer["end"]["velocity_m_s"].is_null() && answer["axes"] == "file", "{answer}");
}

#[test]
fn the_operator_alone_answers_in_its_own_axes() {
    let operator = named("impact_space_operator.toml");
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("operator_in_space");
    let (code, said, errors) = carom(&file("operator", &operator), &["--out", out.to_str().unwrap()]);
    assert!(code == 0 && said.contains("(t1, t2, n)") && !said.contains("J before"), "{said}{errors}");
    let page = fs::read_to_string(out.join("operator/report.html")).unwrap();
    assert!(page.contains("axes of its own"), "the page says so");
    let answer = answer("operator_json", &operator);
    assert_eq!((&answer["axes"], &answer["end"]["bodies"]), (&"contact".into(), &serde_json::json!([])));
}

#[test]
fn a_file_that_mixes_plane_and_space_says_where() {
    let mixed = named("impact_space_balls.toml").replace("[1, 0, 0]", "[1, 0]");
    let (code, said, errors) = carom(&file("mixed", &mixed), &[]);
    assert_eq!((code, said.as_str()), (2, ""), "{errors}");
    assert!(errors.contains("contact.0.normal: expected three numbers"), "{errors}");
    assert!(errors.contains("the file mixes plane and space"), "{errors}");
    assert!(errors.contains("mixed.toml:"), "file and line: {errors}");
}
