//! `carom validate` as it is called.

use crate::command;

use command::{Said, command, folder};

fn validate(words: &[&str], out: &str) -> Said {
    command(&[&["validate"], words].concat(), &folder(out)).output().unwrap().into()
}

#[test]
fn a_result_is_shown_with_what_is_wrong_in_print() {
    let Said { code, out: said, err } = validate(&["housner_block"], "one");
    assert_eq!(code, 0, "{err}");
    assert!(said.starts_with("AS DECLARED   16 printed entries   14 agrees   2 wrong in print"), "{said}");
    assert!(said.contains("-0.1250000000") && said.contains("right: 0.0000000000"), "{said}");
    assert!(!said.contains("0.6250000000"), "what agrees is left out: {said}");
    let page = std::fs::read_to_string(folder("one").join("validation/report.html")).unwrap();
    assert!(page.contains("All 16 verdicts hold"), "the page says so too");
}

#[test]
fn every_entry_is_shown_where_that_is_asked_for() {
    let said = validate(&["housner_block", "--all"], "all").out;
    assert!(said.contains("0.6250000000"), "{said}");
}

#[test]
fn a_name_that_is_none_is_refused() {
    let Said { code, out: said, err } = validate(&["housner"], "none");
    assert_eq!((code, said.as_str()), (2, ""), "{err}");
    assert!(err.contains("housner_block"), "it names those that there are: {err}");
}

#[test]
fn the_list_names_every_result() {
    let Said { code, out: said, .. } = validate(&["--list"], "list");
    assert_eq!(code, 0, "{said}");
    assert_eq!(said.lines().count(), 20, "{said}");
}
