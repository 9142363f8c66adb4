//! The command without its default features: what it leaves out, and that it says so.
#![cfg(not(any(feature = "parquet", feature = "png")))]
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn carom(words: &[&str], out: &Path) -> Output {
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/designer.toml");
    let mut command = Command::new(env!("CARGO_BIN_EXE_carom"));
    command.arg(words[0]).arg(scene).args(&words[1..]).arg("--out").arg(out).output().unwrap()
}

/// A folder of this test's own, empty.
fn empty(test: &str) -> PathBuf {
    let path = std::env::temp_dir().join(format!("carom-thin-{}-{test}", std::process::id()));
    let _ = std::fs::remove_dir_all(&path);
    path
}

#[test]
fn a_sweep_says_that_there_is_no_parquet_and_writes_nothing() {
    let out = empty("sweep");
    let done = carom(&["sweep", "--grid", "contact.friction=0.5..0.9:3"], &out);
    let said = String::from_utf8(done.stderr).unwrap();
    let expected = "a sweep writes tables: this build of Carom has no Parquet: build it with the cargo feature `parquet`\n";
    assert_eq!((done.status.code(), said.as_str()), (Some(1), expected), "one sentence");
    assert!(!out.exists(), "no folder is made");
}

#[test]
fn a_map_leaves_out_its_table_and_its_pixels_and_writes_the_rest() {
    let out = empty("map");
    let axes = ["--x", "plate.lower.slope=5..40 deg:3", "--y", "contact.friction=0.05..0.5:3"];
    let done = carom(&[&["map", "--depth", "0", "--accuracy", "0.01"][..], &axes].concat(), &out);
    let said = String::from_utf8(done.stderr).unwrap();
    assert!(done.status.success() && said.contains("map.parquet is left out: this build"), "{said}");
    let mut names: Vec<String> = std::fs::read_dir(out.join("designer"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    assert_eq!(names, ["map.csv", "map.json", "map.svg"], "the files");
    std::fs::remove_dir_all(out).unwrap();
}
