//! The command as a user meets it: exit code, stdout, stderr, files.

use crate::command;

use command::{Said, command, empty, examples, fed, folder, shown};
use std::fs;
use std::path::Path;
use std::process::Command;

/// Runs the command in a folder that has the examples in it.
fn carom_in(place: &Path, words: &[&str], input: &str) -> Said {
    fed(Command::new(env!("CARGO_BIN_EXE_carom")).args(words).current_dir(place), input)
}

fn carom(test: &str, words: &[&str], input: &str) -> Said {
    let place = empty(test);
    for entry in fs::read_dir(examples()).unwrap() {
        let path = entry.unwrap().path();
        if path.is_file() {
            fs::copy(&path, place.join(path.file_name().unwrap())).unwrap();
        }
    }
    carom_in(&place, words, input)
}

says! {
    run_case_1: ["run", "case_1.toml"], "";
    run_case_2: ["run", "case_2.toml"], "";
    run_designer: ["run", "designer.toml"], "";
    run_stuck: ["run", "too_flat.toml"], "";
    run_paper: ["run", "case_1.toml", "case_2.toml", "--paper"], "";
    run_disc: ["run", "disc.toml"], "";
    run_hexagon: ["run", "hexagon.toml"], "";
    run_zigzag: ["run", "zigzag.toml"], "";
    run_solid: ["run", "solid.toml"], "";
    run_solid_bolt: ["run", "solid_bolt.toml"], "";
    run_solid_groove: ["run", "solid_groove.toml"], "";
    run_solid_bracket: ["run", "solid_bracket.toml"], "";
    run_solid_beside_a_rod: ["run", "solid.toml", "case_2.toml"], "";
    run_feed: ["run", "feed.toml"], "";
    feed_without_parts: ["feed", "case_1.toml", "--parts", "0"], "";
    run_bouncing: ["run", "bouncing.toml"], "";
    run_side_by_side: ["run", "case_1.toml", "case_2.toml", "disc.toml"], "";
    run_paper_without_its_line: ["run", "designer.toml", "--paper"], "";
    run_nothing_there: ["run", "no.toml", "none.toml"], "";
    run_a_scene_with_problems: ["run", "impact_bar.toml"], "";
    draw_designer: ["draw", "designer.toml"], "";
    draw_as_json: ["draw", "case_1.toml", "--format", "json"], "";
    draw_solid: ["draw", "solid.toml"], "";
    draw_solid_groove: ["draw", "solid_groove.toml"], "";
    draw_solid_for_simulators: ["draw", "solid_bolt.toml", "--simulators"], "";
    draw_solid_as_json: ["draw", "solid.toml", "--format", "json"], "";
    faces_of_a_bracket: ["faces", "bracket.toml", "--throws", "256", "--height", "50 ± 10 mm", "--spin", "5 rad/s"], "";
    faces_of_a_solid: ["faces", "solid.toml", "--throws", "32", "--height", "5 mm", "--plate", "upper"], "";
    faces_of_a_solid_with_problems: ["faces", "solid.toml", "--height", "3", "--speed", "-1 m/s", "--plate", "nine"], "";
    faces_of_a_disc: ["faces", "disc.toml"], "";
    faces_with_problems: ["faces", "bracket.toml", "--height", "3", "--speed", "-1 m/s", "--plate", "nine"], "";
    new_to_stdout: ["new", "-", "--plates", "3"], "";
    impact_bar: ["impact", "impact_bar.toml"], "";
    impact_cradle: ["impact", "impact_cradle.toml"], "";
    impact_box: ["impact", "impact_box.toml"], "";
    impact_row: ["impact", "impact_row.toml"], "";
    impact_operator: ["impact", "impact_operator.toml"], "";
    impact_of_a_scene: ["impact", "case_1.toml"], "";
    roll_cylinder: ["roll", "cylinder"], "";
    roll_cylinder_at_a_step: ["roll", "cylinder", "roll_cylinder.toml"], "";
    roll_prism_down_a_slope: ["roll", "prism", "roll_prism.toml", "--set", "strikes=4"], "";
    roll_rod: ["roll", "rod", "roll_rod.toml"], "";
    roll_rod_json: ["roll", "rod", "--set", "strikes=1", "--format", "json"], "";
    roll_with_problems: ["roll", "prism", "roll_cylinder.toml", "--set", "mass=heavy"], "";
    roll_nothing_there: ["roll", "rod", "none.toml"], "";
    unknown_command: ["jump"], "";
}

#[test]
fn where_nothing_approaches_nothing_happens() {
    let line = r#"{"body": {"mass": 1, "inertia": 1, "velocity": [0, 1]}, "contact": [{"point": [0, -1], "normal": [0, 1], "friction": 0.2}]}"#;
    let said = carom("nothing_happens", &["impact", "-"], line);
    let answer: serde_json::Value = serde_json::from_str(&said.out).unwrap();
    assert_eq!(answer["outcome"], "unique");
    assert_eq!(answer["staged"]["velocity_m_s"], serde_json::json!([0.0, 1.0]));
    let place = empty("leaving");
    let leaving = "[body]\nmass = 1\ninertia = 1\nvelocity = [0, 1]\n[[contact]]\npoint = [0, -1]\nnormal = [0, 1]\nfriction = 0\n";
    fs::write(place.join("leaving.toml"), leaving).unwrap();
    let said = carom_in(&place, &["impact", "leaving.toml"], "");
    assert!(said.out.starts_with("NOTHING HAPPENS: no contact approaches"), "{}", said.out);
}

#[test]
fn json_stands_alone_on_stdout() {
    let said = carom("json_alone", &["run", "case_2.toml", "--format", "json"], "");
    let json: serde_json::Value = serde_json::from_str(&said.out).unwrap();
    assert_eq!(json["outcome"], "landed");
    assert_eq!(json["plates"][0]["verdict"], "turned");
    assert_eq!(json["impacts"][0]["type"], 1);
    assert_eq!(json["impacts"][0]["contacts"][0]["feature"], "front");
    assert!(said.err.starts_with("report out/case_2"), "{}", said.err);
    let several = carom("json_list", &["run", "case_1.toml", "case_2.toml", "--format", "json"], "");
    let json: serde_json::Value = serde_json::from_str(&several.out).unwrap();
    assert_eq!(json[0]["plates"][0]["verdict"], "same");
}

#[test]
fn limits_say_how_many_runs_they_took() {
    let said = carom("limits", &["run", "case_2.toml", "--limits"], "");
    // Stderr may hold progress: how much depends on the machine.
    insta::assert_snapshot!(said.out);
    let json = carom("limits_json", &["run", "case_2.toml", "--limits", "--format", "json"], "");
    let json: serde_json::Value = serde_json::from_str(&json.out).unwrap();
    assert!(json["limit_runs"].as_u64().unwrap() > 100, "{}", json["limit_runs"]);
    assert_eq!(json["limits"][3]["quantity"], "contact.friction");
}

#[test]
fn the_papers_table_in_docs_is_up_to_date() {
    let said = carom("table_1", &["run", "case_1.toml", "case_2.toml", "--paper"], "");
    assert_eq!((said.code, said.err.as_str()), (0, "table out/table-1.md\n"));
    let made = folder("table_1/out/table-1.md");
    let kept = examples().join("../docs/table-1.md");
    let (made, kept) = (fs::read_to_string(made).unwrap(), fs::read_to_string(kept).unwrap());
    assert_eq!(made, kept, "the page itself says how it is made");
    assert!(!made.contains("| fails |"), "a printed value is neither confirmed nor explained");
}

/// What the errata say follows from the printed state before each impact, by the impact alone.
#[test]
fn the_errata_follow_from_the_printed_states() {
    // τ, n of the mass centre from the struck corner, then velocity and spin before; τ to the right, so spins are counter-clockwise.
    let cases = [
        ([0.016254, 0.047284], [-0.127, -1.504, 5.490], [0.0456, -0.1734, -10.668, -0.4588]),
        ([-0.026600, 0.042337], [0.558, -1.852, 7.637], [0.408, -0.851, 31.972, 1.761]),
    ];
    for ([tau, n], [v_tau, v_n, spin], after) in cases {
        let input = format!(
            r#"{{"body":{{"mass":0.3,"inertia":2.5e-4,"velocity":[{v_tau},{v_n}],"spin":{spin}}},"contact":[{{"point":[{},{}],"normal":[0,1],"friction":0.15,"restitution":0}}]}}"#,
            -tau, -n
        );
        let said = carom("errata", &["impact", "-"], &format!("{input}\n"));
        let json: serde_json::Value = serde_json::from_str(&said.out).unwrap();
        let staged = &json["staged"];
        let found = [
            &staged["velocity_m_s"][0],
            &staged["velocity_m_s"][1],
            &staged["spin_rad_s"],
            &staged["contacts"][0]["slip_m_s"],
        ];
        for (found, after) in found.into_iter().zip(after) {
            let found = found.as_f64().unwrap();
            assert!((found - after).abs() < 2e-3 * after.abs(), "{found} instead of {after}");
        }
    }
}

#[test]
fn reports_of_bouncing_parts_stay_small() {
    for scene in ["disc", "hexagon", "zigzag", "bouncing"] {
        let said = carom(&format!("small_{scene}"), &["run", &format!("{scene}.toml")], "");
        assert_eq!(said.code, 0);
        let page = folder(&format!("small_{scene}/out/{scene}/report.html"));
        let size = fs::metadata(page).unwrap().len();
        assert!(size < 600_000, "{scene}: {size} bytes");
    }
}

#[test]
fn reports_are_written_and_named() {
    let said = carom("reports", &["run", "case_1.toml", "--out", "here"], "");
    assert!(said.out.ends_with("report here/case_1/report.html\n"), "{}", said.out);
    let place = folder("reports/here/case_1");
    for (file, holds) in [("report.html", "<svg"), ("run.json", "\"outcome\""), ("trace.csv", ",")] {
        assert!(fs::read_to_string(place.join(file)).unwrap().contains(holds), "{file}");
    }
}

#[test]
fn a_report_that_cannot_be_written_is_said() {
    let place = empty("unwritable");
    fs::copy(examples().join("case_1.toml"), place.join("case_1.toml")).unwrap();
    fs::write(place.join("full"), "a file in the way").unwrap();
    let said = carom_in(&place, &["run", "case_1.toml", "--out", "full"], "");
    assert_eq!(said.code, 1);
    assert!(said.err.contains("full"), "{}", said.err);
}

#[test]
fn the_same_scene_gives_the_same_bytes() {
    let run = |test| carom(test, &["run", "case_1.toml", "--format", "json"], "").out;
    assert_eq!(run("same_1"), run("same_2"));
}

#[test]
fn a_new_scene_runs_and_is_never_written_over() {
    let place = empty("new");
    assert_eq!(carom_in(&place, &["new", "mine.toml"], "").code, 0);
    let run = carom_in(&place, &["run", "mine.toml"], "");
    assert_eq!((run.code, run.err.as_str()), (0, ""), "{}", run.out);
    let again = carom_in(&place, &["new", "mine.toml"], "");
    assert_eq!(again.code, 1);
    assert!(again.err.contains("is there already"), "{}", again.err);
}

#[test]
fn watch_runs_and_stops_when_told() {
    let said = carom("watch", &["watch", "case_2.toml", "--runs", "1"], "");
    assert_eq!(said.code, 0);
    assert!(said.out.starts_with("TURNED on \"lower\""), "{}", said.out);
}

#[test]
fn impacts_stream_through_in_order() {
    let good = r#"{"law":"newton","operator":{"w_tt":3.5,"w_tn":0,"w_nn":1,"slip":0,"approach":-2,"friction":0.3,"restitution":0.5}}"#;
    let bad = r#"{"operator":{"w_tt":-1}}"#;
    let said = carom("stream", &["impact", "-"], &format!("{good}\n\n{bad}\nno json\n{good}\n"));
    let lines: Vec<serde_json::Value> =
        said.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!((said.code, lines.len()), (2, 4));
    assert_eq!(lines[0]["staged"]["contacts"][0]["normal_velocity_m_s"], 1.0);
    let problems = lines[1]["error"]["problems"].as_array().unwrap();
    assert!(problems.iter().any(|problem| problem["path"] == "operator.w_tt"), "{}", lines[1]);
    assert_eq!(lines[2]["line"], 4);
    assert_eq!(lines[0], lines[3]);
}

#[test]
fn impulse_planes_are_drawn() {
    let said = carom("planes", &["impact", "impact_bar.toml", "--out", "planes"], "");
    assert_eq!(said.code, 0);
    let place = folder("planes/planes/impact_bar/impulse-plane-K.svg");
    assert!(fs::read_to_string(place).unwrap().contains("<svg"), "it is a drawing");
    let said = carom("walks", &["impact", "impact_box.toml", "--out", "walk"], "");
    let written = "impulse walk walk/impact_box/impulse-walk.svg\nreport walk/impact_box/report.html\n";
    assert_eq!((said.code, said.err.as_str()), (0, written));
    let place = folder("walks/walk/impact_box/impulse-walk.svg");
    let svg = fs::read_to_string(place).unwrap();
    for part in ["<svg", ">left</text>", ">right</text>", ">restitution ends</text>"] {
        assert!(svg.contains(part), "{part}");
    }
}

#[test]
fn impacts_in_one_folder_do_not_write_over_each_other() {
    let examples = ["impact_bar", "impact_box", "impact_twist", "impact_space_balls"];
    let all = empty("one_folder");
    for example in examples {
        let said: Said = command(&["impact", &format!("{example}.toml")], &all).output().unwrap().into();
        assert!(said.err.ends_with(&format!("{example}/report.html\n")), "{}", said.err);
    }
    for example in examples {
        let place = all.join(example);
        let page = fs::read_to_string(place.join("report.html")).unwrap();
        assert!(page.contains(&format!("<h1>{example}</h1>")), "the page of {example} is its own");
        let json = fs::read_to_string(place.join("impact.json")).unwrap();
        let json: serde_json::Value = serde_json::from_str(&json).unwrap();
        assert!(json["outcome"].is_string(), "its answer lies beside it: {json}");
    }
}

#[test]
fn a_contact_without_an_impulse_says_so_in_place_of_a_plane() {
    let said = carom("no_impulse", &["impact", "impact_step.toml"], "");
    assert!(said.out.contains("impulse plane of A\nit takes no impulse\n"), "{}", said.out);
    assert!(said.out.contains("impulse plane of K\np_t [N s]\n"), "{}", said.out);
}

#[test]
fn a_report_of_an_impact_says_what_was_examined() {
    let page = |example: &str| {
        let test = format!("page_{example}");
        let said = carom(&test, &["impact", &format!("{example}.toml"), "--out", "page"], "");
        assert_eq!(said.code, 0, "{}", said.err);
        let place = folder(&test).join("page").join(example).join("report.html");
        fs::read_to_string(place).unwrap()
    };
    let (boxed, row) = (page("impact_box"), page("impact_row"));
    for part in
        ["Left separates, right separates", "class=\"fig joint\"", "in sequence", "hypotheses are rejected"]
    {
        assert!(boxed.contains(part), "{part}");
    }
    for part in ["Of 7 contacts 1 separates, 6 stick", "Whether there are others was not examined", "ball 8"]
    {
        assert!(row.contains(part), "{part}");
    }
    assert!(
        !row.contains("id=\"hypotheses\"") && !row.contains("id=\"walk\""),
        "nothing that was not sought"
    );
    for page in [boxed, row] {
        assert!(
            !page.contains("https://") && !page.replace("http://www.w3.org/2000/svg", "").contains("http://")
        );
    }
}

#[test]
fn rolls_are_written_and_named() {
    let said = carom("rolls", &["roll", "prism", "roll_prism.toml", "--out", "here"], "");
    assert!(said.out.ends_with("report here/prism/report.html\n"), "{}", said.out);
    let place = folder("rolls/here/prism");
    let page = fs::read_to_string(place.join("report.html")).unwrap();
    for part in ["<svg", "id=\"player\"", "id=\"motion-numbers\"", "3: separates at A, sticks at K"] {
        assert!(page.contains(part), "{part}");
    }
    assert!(!page.contains("http://") && !page.contains("https://"), "nothing from the network");
    let json: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(place.join("roll.json")).unwrap()).unwrap();
    assert_eq!(json["end"]["state"], "strikes reached");
}

#[test]
fn a_scene_named_by_dots_writes_nothing_outside_the_folder_asked_for() {
    let place = empty("dots");
    fs::copy(examples().join("case_2.toml"), place.join("...toml")).unwrap();
    for command in ["run", "draw"] {
        let project = place.join(command);
        fs::create_dir_all(&project).unwrap();
        let out = project.join("out");
        let said = carom_in(&place, &[command, "...toml", "--out", out.to_str().unwrap()], "");
        assert!(said.code <= 1, "{command} ends with {}: {}", said.code, said.err);
        let beside: Vec<_> =
            fs::read_dir(&project).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        assert_eq!(beside, ["out"], "{command} has written beside --out");
    }
}

#[test]
fn watch_runs_again_when_the_drawing_of_the_part_is_saved() {
    use std::io::{BufRead, BufReader};
    let place = empty("watch_outline");
    for name in ["bracket.toml", "bracket.dxf"] {
        fs::copy(examples().join(name), place.join(name)).unwrap();
    }
    let mut command = Command::new(env!("CARGO_BIN_EXE_carom"));
    command.args(["watch", "bracket.toml", "--runs", "2"]).current_dir(&place);
    let mut child = command.stdout(std::process::Stdio::piped()).spawn().unwrap();
    let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
    let first = lines.by_ref().map(|line| line.unwrap()).find(|line| line.starts_with("report "));
    assert!(first.is_some(), "the first run");
    let drawing = fs::read_to_string(place.join("bracket.dxf")).unwrap();
    fs::write(place.join("bracket.dxf"), format!("999\nsaved again\n{drawing}")).unwrap();
    let second = lines.map(|line| line.unwrap()).find(|line| line.starts_with("report "));
    assert!(second.is_some(), "the second run");
    assert!(child.wait().unwrap().success(), "it ends after two runs");
}
