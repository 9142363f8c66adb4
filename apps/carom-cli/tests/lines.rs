//! One problem a line in, one answer a line out: scenes and rolls.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod command;

use command::{Said, answers, command, folder};
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
