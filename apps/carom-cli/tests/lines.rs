//! One problem a line in, one answer a line out: scenes and rolls.

use crate::command;

use command::{Said, answers, command, fed, folder};
use serde_json::Value;
use std::io::{BufRead, BufReader, Write};
use std::process::Stdio;

fn example(name: &str) -> String {
    format!("{}/../../examples/{name}", env!("CARGO_MANIFEST_DIR"))
}

/// A TOML file as one line of JSON.
fn line(name: &str) -> String {
    let text = std::fs::read_to_string(example(name)).unwrap();
    serde_json::to_string(&toml::from_str::<toml::Table>(&text).unwrap()).unwrap()
}

fn of_file(test: &str, words: &[&str]) -> Value {
    let words = [words, &["--format", "json"]].concat();
    let said: Said = command(&words, &folder(test)).output().unwrap().into();
    serde_json::from_str(&said.out).unwrap()
}

#[test]
fn scenes_in_lines_end_as_their_files_do() {
    let input = format!("{}\n{{\"part\": 3}}\n\n{}\n", line("case_2.toml"), line("disc.toml"));
    let (code, said) = answers("lines_run", &["run", "-"], &input);
    assert_eq!((code, said.len()), (2, 3), "one line has problems: {said:?}");
    for (answer, name) in [(&said[0], "case_2.toml"), (&said[2], "disc.toml")] {
        let mut expected = of_file("lines_run_file", &["run", &example(name)]);
        // A line has no name but its number.
        expected["scene"] = answer["scene"].clone();
        assert!(*answer == expected, "{name}: {answer:#} {expected:#}");
    }
    let problems = said[1]["error"]["problems"].as_array().unwrap();
    assert_eq!((&said[1]["line"], &problems[0]["path"]), (&2.into(), &"part".into()), "{problems:?}");
}

#[test]
fn rolls_in_lines_end_as_their_files_do() {
    for (kind, name) in [("prism", "roll_prism.toml"), ("pyramid", "roll_pyramid.toml")] {
        let (code, said) = answers("lines_roll", &["roll", kind, "-"], &line(name));
        assert_eq!((code, said.len()), (0, 1), "{kind}: {said:?}");
        let expected = of_file("lines_roll_file", &["roll", kind, &example(name)]);
        assert!(said[0] == expected, "{kind}: {:#} {expected:#}", said[0]);
    }
}

#[test]
fn what_writes_files_does_not_go_with_lines() {
    for words in [&["run", "-", "--paper"][..], &["roll", "body", "-", "--throws", "32"]] {
        let said: Said = command(words, &folder("lines_refused")).output().unwrap().into();
        assert_eq!(said.code, 2, "{words:?}");
        assert!(said.err.contains("from stdin"), "{words:?}: {}", said.err);
    }
}

#[test]
fn each_line_is_answered_before_the_next_is_asked() {
    let asked = [
        (&["run", "-"][..], line("disc.toml")),
        (&["roll", "prism", "-"], line("roll_prism.toml")),
        (&["impact", "-"], line("impact_operator.toml")),
        (&["contact", "-"], line("contact_painleve.toml")),
    ];
    for (words, question) in asked {
        let mut piped = command(words, &folder("lines_asked"));
        let mut child = piped.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
        let (mut stdin, stdout) = (child.stdin.take().unwrap(), child.stdout.take().unwrap());
        let mut answers = BufReader::new(stdout).lines();
        for n in 1..=2 {
            writeln!(stdin, "{question}").unwrap();
            let answer: Value = serde_json::from_str(&answers.next().unwrap().unwrap()).unwrap();
            assert!(answer["error"].is_null(), "{words:?}, line {n}: {answer:#}");
        }
        drop(stdin);
        assert!(child.wait().unwrap().success(), "{words:?}");
    }
}

/// Every way in which a line can be bad, and one that is good but has no answer.
#[test]
fn an_error_line_is_as_its_schema_says() {
    let schema: Said = command(&["schema", "error"], &folder("lines_schema")).output().unwrap().into();
    let schema: Value = serde_json::from_str(&schema.out).unwrap();
    let keys = |of: &Value| of.as_object().unwrap().keys().cloned().collect::<Vec<_>>();
    let named = |name: &str| schema["$defs"][name]["properties"].clone();
    let asked: [(&[&str], &str); 5] = [
        (&["run", "-"], r#"{"part": {"shape": "rod", "lenght": "10 furlong"}}"#),
        (&["roll", "prism", "-"], r#"{"sides": 4, "sides": 5}"#),
        (&["impact", "-"], r#"{"law": "newtn"}"#),
        (&["contact", "-"], "[1]"),
        (
            &["contact", "-"],
            r#"{"body": {"mass": 1, "inertia": 1, "velocity": [0, -1]}, "contact": [{"point": [0, 0], "normal": [0, 1], "friction": 0}]}"#,
        ),
    ];
    for (words, line) in asked {
        let (code, answers) = answers("lines_errors", words, &format!("{line}\n"));
        assert_eq!((code, answers.len()), (2, 1), "{words:?}");
        assert_eq!(keys(&answers[0]), keys(&schema["properties"]), "{words:?}");
        assert_eq!(keys(&answers[0]["error"]), keys(&named("LineProblems")), "{words:?}");
        for problem in answers[0]["error"]["problems"].as_array().unwrap() {
            assert_eq!(keys(problem), keys(&named("LineProblem")), "{words:?}");
            assert!(!problem["message"].as_str().unwrap().is_empty(), "{words:?}");
        }
    }
    let twice = answers("lines_errors", &["roll", "prism", "-"], "{\"sides\": 4, \"sides\": 5}\n");
    assert_eq!(twice.1[0]["error"]["problems"][0]["path"], "sides", "{:?}", twice.1);
    let help = answers("lines_errors", &["impact", "-"], "{\"law\": \"newtn\"}\n");
    let problems = help.1[0]["error"]["problems"].as_array().unwrap();
    let law = problems.iter().find(|problem| problem["key"] == "law").unwrap();
    assert_eq!(law["help"], "did you mean \"newton\"?", "{law}");
    assert_eq!(law["allowed"], serde_json::json!(["poisson", "stronge", "newton"]), "{law}");
}

#[test]
fn a_wrong_interval_of_poses_is_told_once_before_any_line_is_read() {
    let words = ["roll", "prism", "-", "--poses", "10 furlong"];
    let said = fed(&mut command(&words, &folder("lines_poses")), "");
    assert_eq!((said.code, said.out.as_str()), (2, ""), "{}", said.err);
    assert_eq!(said.err.matches("--poses").count(), 1, "{}", said.err);
}
