//! The referee through the command: cases out, answers in.

use crate::command;

use command::{Said, command, fed, folder};
use serde_json::{Value, json};

fn lines(words: &[&str]) -> Vec<Value> {
    let said: Said = command(words, &folder("cases")).output().unwrap().into();
    assert_eq!(said.code, 0, "{}", said.err);
    said.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

/// What the command itself answers to cases.
fn answered(cases: &[Value]) -> String {
    let of = |key: &str, verb: &str| {
        let asked: Vec<&Value> = cases.iter().filter(|case| !case[key].is_null()).collect();
        let input: String = asked.iter().map(|case| format!("{}\n", case[key])).collect();
        let said = fed(&mut command(&[verb, "-"], &folder("answered")), &input);
        let answer = |(case, line): (&&Value, &str)| {
            let said: Value = serde_json::from_str(line).unwrap();
            let end = if said["staged"].is_null() { &said["end"] } else { &said["staged"] };
            let name = &case["case"];
            match (verb, end["bodies"].as_array().filter(|bodies| !bodies.is_empty())) {
                ("run", _) => {
                    let plates = said["plates"].as_array().unwrap();
                    json!({ "case": name, "verdict": plates.last().unwrap()["verdict"] })
                }
                (_, Some(bodies)) => {
                    let body = |of: &Value| json!({ "velocity_m_s": of["velocity_m_s"], "spin_rad_s": of["spin_rad_s"] });
                    json!({ "case": name, "bodies": bodies.iter().map(body).collect::<Vec<_>>() })
                }
                _ => {
                    json!({ "case": name, "velocity_m_s": end["velocity_m_s"], "spin_rad_s": end["spin_rad_s"] })
                }
            }
        };
        asked.iter().zip(said.out.lines()).map(answer).map(|line| format!("{line}\n")).collect::<String>()
    };
    of("impact", "impact") + &of("scene", "run")
}

#[test]
fn the_command_answers_its_own_cases_as_they_say() {
    let cases = lines(&["cases", "--format", "json"]);
    let said = fed(&mut command(&["judge", "-", "--format", "json"], &folder("judge")), &answered(&cases));
    assert_eq!(said.code, 0, "{}", said.err);
    let report: Value = serde_json::from_str(&said.out).unwrap();
    let all = &report["engines"][0]["all"];
    assert_eq!((&all["agree"], &all["missing"]), (&json!(cases.len()), &json!(0)), "{all:#}");
}

#[test]
fn a_person_sees_groups_and_what_the_columns_mean() {
    let said: Said = command(&["cases", "--group", "drop"], &folder("cases_text")).output().unwrap().into();
    assert!(said.out.contains("63 cases") && said.out.contains("--format json"), "{}", said.out);
    let line = r#"{"case": "drop/001", "engine": "mine", "verdict": "turned"}"#;
    let said = fed(&mut command(&["judge", "-", "--all"], &folder("judge_text")), line);
    assert!(
        said.out.contains("mine: ") && said.out.contains("follow another law or convention"),
        "{}",
        said.out
    );
    assert!(said.out.contains("drop/001"), "each case that has an answer: {}", said.out);
}

#[test]
fn every_bad_line_is_told_with_its_number() {
    let bad = [
        r#"{"case": "ball/001", "verdict": "turned"}"#,
        r#"{"case": "bal/001", "velocity_m_s": [0, 0], "spin_rad_s": 0}"#,
        r#"{"case": "ball/002", "velocity_m_s": [0, 0, 0], "spin_rad_s": 0}"#,
        r#"{"case": "drop/001", "verdict": "upside down"}"#,
        r#"{"case": "ball/003", "velocity_m_s": [0, 0]}"#,
        "no JSON",
        r#"{"case": "ball/004", "refused": "no"}"#,
        r#"{"case": "ball/004", "refused": "no"}"#,
        r#"{"case": "ball/005", "spin": 3}"#,
    ];
    let said = fed(&mut command(&["judge", "-"], &folder("judge_bad")), &bad.join("\n"));
    assert_eq!((said.code, said.out.as_str()), (2, ""), "{}", said.err);
    for number in [1, 2, 3, 4, 5, 6, 8, 9] {
        assert!(said.err.contains(&format!("line {number}")), "line {number}: {}", said.err);
    }
    assert!(!said.err.contains("line 7"), "the first of two is good: {}", said.err);
    for word in [
        "did you mean \"ball/001\"",
        "2 numbers",
        "same, turned or none",
        "second answer",
        "unknown field `spin`",
    ] {
        assert!(said.err.contains(word), "{word}: {}", said.err);
    }
    for words in [&["judge", "nowhere.jsonl"][..], &["cases", "--group", "nothing"], &["judge"]] {
        let said: Said = command(words, &folder("judge_usage")).output().unwrap().into();
        assert_eq!(said.code, 2, "{words:?}: {}", said.err);
    }
}

#[test]
fn cases_of_ones_own_are_judged_too() {
    let mut case = lines(&["cases", "--format", "json", "--group", "ball"])[0].clone();
    case["case"] = "mine".into();
    let file = folder("own_cases").join("cases.jsonl");
    std::fs::create_dir_all(file.parent().unwrap()).unwrap();
    std::fs::write(&file, format!("{case}\n")).unwrap();
    let answer = json!({ "case": "mine", "bodies": case["expected"]["answers"][0]["bodies"] }).to_string();
    let words = ["judge", "-", "--cases", file.to_str().unwrap()];
    let said = fed(&mut command(&words, &folder("own_judge")), &answer);
    assert!(said.out.contains("stdin: 1 of 1 answers agree"), "{}{}", said.out, said.err);
    std::fs::write(&file, format!("{case}\n{case}\n{{}}\n")).unwrap();
    let said = fed(&mut command(&words, &folder("own_judge")), &answer);
    assert!(said.err.contains("line 2") && said.err.contains("line 3"), "{}", said.err);
}

#[test]
fn a_case_that_is_none_is_refused_before_anything_is_judged() {
    let case = lines(&["cases", "--format", "json", "--group", "ball"])[0].clone();
    let drop = lines(&["cases", "--format", "json", "--group", "drop"])[0].clone();
    let changed = |from: &Value, path: &str, to: Value| {
        let mut other = from.clone();
        *other.pointer_mut(path).unwrap() = to;
        other
    };
    let mut typo = case.clone();
    typo["impact"]["contact"][0]["restitutoin"] = 0.5.into();
    let mut still = case.clone();
    still["impact"]["body"]["velocity"] = json!([0, 0]);
    still["impact"]["body"]["spin"] = 0.into();
    let wrong = [
        (typo, "impact.contact.0.restitutoin"),
        (still, "nothing moves before it"),
        (changed(&case, "/expected/answers", json!([])), "at least one answer"),
        (changed(&case, "/tolerance", json!(-1)), "a share from 0 to 1"),
        (changed(&case, "/expected/answers/0/bodies/0/velocity_m_s", json!([0, 0, 0])), "2 numbers"),
        (changed(&case, "/impact", Value::Null), "one of impact and scene"),
        (changed(&drop, "/scene", json!({ "x": 1 })), "scene.x"),
        (changed(&drop, "/expected/answers/0/verdict", json!("maybe")), "same, turned or none"),
        (changed(&case, "/case", json!(" ")), "a case has a name"),
    ];
    let file = folder("wrong_cases").join("cases.jsonl");
    std::fs::create_dir_all(file.parent().unwrap()).unwrap();
    for (bad, told) in wrong {
        std::fs::write(&file, format!("{bad}\n")).unwrap();
        let words = ["judge", "-", "--cases", file.to_str().unwrap()];
        let answer = r#"{"case": "ball/001", "velocity_m_s": [999, 999], "spin_rad_s": 7}"#;
        let said = fed(&mut command(&words, &folder("wrong_judge")), answer);
        assert_eq!((said.code, said.out.as_str()), (2, ""), "{told}: {}", said.err);
        assert!(said.err.contains(told), "{told}: {}", said.err);
    }
}

#[test]
fn one_engine_answers_a_case_once_in_all_files_and_in_numbers() {
    let out = folder("two_files");
    std::fs::create_dir_all(&out).unwrap();
    let line = r#"{"case": "ball/001", "engine": "mine", "velocity_m_s": [0, 0], "spin_rad_s": 0}"#;
    let files = ["a.jsonl", "b.jsonl"].map(|name| out.join(name));
    for file in &files {
        std::fs::write(file, line).unwrap();
    }
    let words: Vec<&str> =
        ["judge"].into_iter().chain(files.iter().map(|file| file.to_str().unwrap())).collect();
    let said: Said = command(&words, &out).output().unwrap().into();
    assert!(said.code == 2 && said.err.contains("two files answer"), "{}", said.err);
    for (bad, told) in [
        (r#"{"case": "ball/001", "velocity_m_s": [1.7e308, 1.7e308], "spin_rad_s": 1e308}"#, "too large"),
        (r#"["ball/001", "mine", [], [0, 0], 0, null, null]"#, "one JSON object a line"),
        (r#"{"case": "ball/001", "engine": "two\nlines", "refused": "no"}"#, "name of the engine"),
        (
            r#"{"case": "ball/001", "velocity_m_s": [0, 0], "spin_rad_s": "fast"}"#,
            "a number, or a list of three",
        ),
    ] {
        let said = fed(&mut command(&["judge", "-"], &out), bad);
        assert!(said.code == 2 && said.err.contains(told), "{told}: {}", said.err);
    }
}
