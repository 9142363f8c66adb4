//! The programs that the book shows, run as a reader runs them. They need Python: where there is none they are not run, and the test says so.

use crate::command;

use command::{carom_on, folder};
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn shown(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/examples").join(name)
}

/// The path of programs with the command of this build first.
fn path() -> OsString {
    let own = Path::new(env!("CARGO_BIN_EXE_carom")).parent().unwrap().to_path_buf();
    let others = std::env::var_os("PATH").unwrap_or_default();
    std::env::join_paths(std::iter::once(own).chain(std::env::split_paths(&others))).unwrap()
}

/// What Python says; `None` where it is not there.
fn python(words: &[&str]) -> Option<Output> {
    let output = Command::new("python3").args(words).env("PATH", path()).output().ok();
    if output.is_none() {
        writeln_to_person("python3 is not here: the programs of the book were not run");
    }
    output
}

fn writeln_to_person(text: &str) {
    use std::io::Write;
    let _ = writeln!(std::io::stderr(), "{text}");
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap().replace("\r\n", "\n")
}

#[test]
fn the_program_that_asks_in_lines_says_what_the_book_shows() {
    let Some(said) = python(&[shown("ask.py").to_str().unwrap()]) else { return };
    assert!(said.status.success(), "{}", text(&said.stderr));
    let expected = std::fs::read_to_string(shown("ask.txt")).unwrap();
    assert_eq!(text(&said.stdout), expected, "its answers are those of the book");
    assert!(expected.starts_with("it stops slipping from friction 0.333333333 on\n"), "a third, by hand");
}

#[test]
fn the_program_that_reads_a_table_reads_every_row() {
    let scene = shown("sure.toml");
    let grid = ["--grid", "plate.1.drop=150..260mm:12", "--grid", "contact.friction=0.1..0.3:5", "--force"];
    let said = carom_on("2", "programs_table", &[&["sweep", scene.to_str().unwrap()], &grid[..]].concat());
    assert_eq!(said.code, 0, "{}", said.err);
    let libraries = "import pandas, polars, duckdb, pyarrow";
    let Some(there) = python(&["-c", libraries]) else { return };
    if !there.status.success() {
        writeln_to_person("pandas, Polars, DuckDB or pyarrow is not here: the table was not read");
        return;
    }
    let table = folder("programs_table").join("sure").join("sweep");
    let said = python(&[shown("table.py").to_str().unwrap(), table.to_str().unwrap()]).unwrap();
    let told = text(&said.stdout);
    assert!(said.status.success(), "{told}{}", text(&said.stderr));
    let expected = std::fs::read_to_string(shown("table.txt")).unwrap();
    assert_eq!(told, expected, "three readers, one table, as the book shows it");
}
