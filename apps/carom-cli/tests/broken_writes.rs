//! Files that cannot be written, each in its turn: it is said, nothing is left half-written, and the same command goes on afterwards.

use crate::command;
use crate::tree;

use command::{Said, command, empty};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Stdio;

fn carom(words: &[&str], out: &Path) -> Said {
    command(words, out).output().unwrap().into()
}

/// Every file below a folder, by its path from there.
fn files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    tree::files(folder, |path| std::fs::read(path).unwrap())
}

/// Lets a command fail at each of the files that it writes, and then not.
fn each_file_fails(name: &str, words: &[&str]) {
    let whole = empty(&format!("{name}-whole"));
    assert_eq!(carom(words, &whole).code, 0, "{words:?}");
    let wanted = files(&whole);
    assert!(!wanted.is_empty(), "{words:?} writes files");
    for (k, blocked) in wanted.keys().enumerate() {
        let out = empty(&format!("{name}-{k}"));
        // A folder of the file's name: no file can take its place.
        let block = out.join(blocked);
        std::fs::create_dir_all(&block).unwrap();
        let said = carom(words, &out);
        let place = format!("{words:?} with {} in the way", blocked.display());
        let message = said.err;
        assert_eq!(said.code, 1, "{place}: {message}");
        let last = blocked.file_name().unwrap().to_string_lossy();
        assert!(message.contains("cannot ") && message.contains(&*last), "{place}: {message}");
        for (path, bytes) in files(&out) {
            // Locks say nothing and stay where a command fails.
            let locks = path.extension().is_some_and(|ending| ending == "lock");
            // Finished steps of a sweep stay until their part is written.
            let step = path.iter().any(|name| name == "unfinished") && bytes.ends_with(b"PAR1");
            let whole = locks || step || wanted.get(&path) == Some(&bytes);
            assert!(whole, "{place}: {} is not whole", path.display());
        }
        std::fs::remove_dir(&block).unwrap();
        assert_eq!(carom(words, &out).code, 0, "{place}, and then not");
        let again = files(&out);
        assert!(again.keys().eq(wanted.keys()), "{place}, and then not: {:?}", again.keys());
        assert!(again == wanted, "{place}, and then not: byte for byte");
    }
}

#[test]
fn each_file_of_a_run_may_fail() {
    each_file_fails("run", &["run", "case_1.toml"]);
}

#[test]
fn each_file_of_an_impact_may_fail() {
    each_file_fails("impact", &["impact", "impact_box.toml"]);
}

#[test]
fn each_part_of_a_sweep_may_fail() {
    each_file_fails("sweep", &["sweep", "designer.toml", "--grid", "contact.friction=0.5..0.9:33000"]);
}

/// A device that takes nothing.
#[cfg(target_os = "linux")]
#[test]
fn output_that_cannot_be_written_is_said() {
    for (k, words) in [
        &["run", "case_1.toml"][..],
        &["impact", "impact_box.toml"],
        &["schema", "run"],
        &["--help"],
        &["run", "--help"],
    ]
    .iter()
    .enumerate()
    {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let mut command = command(words, &empty(&format!("full-{k}")));
        let said: Said = command.stdout(Stdio::from(full)).output().unwrap().into();
        assert_eq!(said.code, 1, "{words:?}: {}", said.err);
        assert!(said.err.contains("cannot write the output"), "{words:?}: {}", said.err);
    }
}

/// Whoever reads the output may go away at once.
#[test]
fn files_do_not_depend_on_who_reads_the_output() {
    for (k, words) in [
        &["run", "case_1.toml", "case_2.toml"][..],
        &["run", "case_1.toml", "--format", "json"],
        &["impact", "impact_box.toml"],
        &["roll", "prism", "roll_prism.toml"],
        &["roll", "pyramid"],
        &["validate", "incline"],
        &["draw", "case_1.toml"],
    ]
    .iter()
    .enumerate()
    {
        let [read, unread] = ["read", "unread"].map(|name| empty(&format!("{name}-{k}")));
        assert_eq!(carom(words, &read).code, 0, "{words:?}");
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let said: Said = command(words, &unread).stdout(Stdio::from(writer)).output().unwrap().into();
        assert_eq!(said.code, 0, "{words:?}: {}", said.err);
        assert!(files(&unread).keys().eq(files(&read).keys()), "{words:?}: {:?}", files(&unread).keys());
    }
}

/// What a terminal obeys.
#[test]
fn a_name_is_shown_and_not_obeyed() {
    let folder = empty("obeyed");
    let scene = std::fs::read_to_string(command::examples().join("designer.toml")).unwrap();
    let named = scene.replacen("name  = \"lower\"", "name  = \"lo\\u001B[31mwer\"", 1);
    assert_ne!(named, scene, "the scene has that name");
    let file = folder.join("named.toml");
    for text in [named.clone(), named.replace("friction", "fric\u{9b}tion")] {
        std::fs::write(&file, text).unwrap();
        let said = carom(&["run", file.to_str().unwrap()], &folder);
        let shown = format!("{}{}", said.out, said.err);
        assert!(shown.contains("\\u001B[31m") || shown.contains("\\u009B"), "{shown}");
        assert!(!shown.contains(['\u{1b}', '\u{9b}']), "{shown:?}");
    }
}
