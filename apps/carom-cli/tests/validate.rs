//! `carom validate` as it is called.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

fn validate(words: &[&str], out: &str) -> (Output, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_carom"));
    let output = command.arg("validate").args(words).arg("--out").arg(folder(out)).output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    let (said, errors) = (text(&output.stdout), text(&output.stderr));
    (output, said, errors)
}

#[test]
fn a_result_is_shown_with_what_is_wrong_in_print() {
    let (output, said, errors) = validate(&["housner_block"], "validate-one");
    assert!(output.status.success(), "{errors}");
    assert!(said.starts_with("AS DECLARED   16 printed entries   14 agrees   2 wrong in print"), "{said}");
    assert!(said.contains("-0.1250000000") && said.contains("right: 0.0000000000"), "{said}");
    assert!(!said.contains("0.6250000000"), "what agrees is left out: {said}");
    let page = std::fs::read_to_string(folder("validate-one").join("validation/report.html")).unwrap();
    assert!(page.contains("All 16 printed entries are as declared"), "the page says so too");
}

#[test]
fn every_entry_is_shown_where_that_is_asked_for() {
    let (_, said, _) = validate(&["housner_block", "--all"], "validate-all");
    assert!(said.contains("0.6250000000"), "{said}");
}

#[test]
fn a_name_that_is_none_is_refused() {
    let (output, said, errors) = validate(&["housner"], "validate-none");
    assert_eq!((output.status.code(), said.as_str()), (Some(2), ""), "{errors}");
    assert!(errors.contains("housner_block"), "it names those that there are: {errors}");
}

#[test]
fn the_list_names_every_result() {
    let (output, said, _) = validate(&["--list"], "validate-list");
    assert!(output.status.success(), "{said}");
    assert_eq!(said.lines().count(), 17, "{said}");
}
