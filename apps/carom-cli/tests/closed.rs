//! What cannot be written to stdout is not done: exit code 1, and a message.

#![cfg(target_os = "linux")]

use crate::command;

use command::{Said, command, folder};
use std::fs::OpenOptions;
use std::process::{Command, Stdio};

#[test]
fn a_full_device_is_told_and_exits_with_one() {
    for words in [
        &["help"][..],
        &["help", "run"],
        &["--version"],
        &["schema", "scene"],
        &["run", "case_2.toml"],
        &["new", "-"],
        &["roll", "prism"],
    ] {
        let full = OpenOptions::new().write(true).open("/dev/full").unwrap();
        // Help and version take no folder.
        let mut asked = match words[0] {
            "help" | "--version" => Command::new(env!("CARGO_BIN_EXE_carom")),
            _ => command(&words[..1], &folder("full")),
        };
        asked.args(if matches!(words[0], "help" | "--version") { words } else { &words[1..] });
        let said: Said = asked.stdout(full).stderr(Stdio::piped()).output().unwrap().into();
        assert_eq!(said.code, 1, "{words:?}: {}", said.err);
        assert!(said.err.contains("cannot write the output"), "{words:?}: {}", said.err);
    }
}
