//! Inputs that cannot be read: what is wrong is said, with the file's name, and nothing is written.

use crate::command;

use command::{Said, command, empty, examples};
use std::path::Path;

/// Commands with a file each, whose place is `FILE`.
const COMMANDS: [&[&str]; 14] = [
    &["run", "FILE"],
    &["draw", "FILE"],
    &["watch", "FILE", "--runs", "1"],
    &["impact", "FILE"],
    &["roll", "prism", "FILE"],
    &["roll", "pyramid", "FILE"],
    &["roll", "body", "FILE"],
    &["regions", "--file", "FILE", "--x", "body.spin=-1..1", "--y", "body.mass=1..2"],
    &["map", "FILE", "--x", "contact.friction=0..1", "--y", "contact.friction=0..1"],
    &["yield", "FILE"],
    &["feed", "FILE"],
    &["design", "FILE"],
    &["sweep", "FILE", "--grid", "contact.friction=0.1..0.2:2"],
    &["sweep", "designer.toml", "--list", "FILE"],
];

/// Asks every command for a file; it must say what is wrong.
fn refused(name: &str, file: &Path) {
    for (k, words) in COMMANDS.iter().enumerate() {
        let words: Vec<&str> =
            words.iter().map(|word| if *word == "FILE" { file.to_str().unwrap() } else { word }).collect();
        let out = empty(&format!("{name}-{k}"));
        let said: Said = command(&words, &out).output().unwrap().into();
        assert!(said.code == 1 || said.code == 2, "{words:?} ends with {}: {}", said.code, said.err);
        let last = file.file_name().unwrap().to_str().unwrap();
        assert!(said.err.contains(last), "{words:?} does not name {last}: {}", said.err);
        assert!(!said.err.contains("panicked"), "{words:?}: {}", said.err);
        assert_eq!(std::fs::read_dir(&out).unwrap().count(), 0, "{words:?} has written something");
    }
}

#[test]
fn files_that_are_not_there() {
    refused("missing", &empty("of-missing").join("nowhere.toml"));
}

#[test]
fn folders_in_the_place_of_files() {
    let folder = empty("of-folders").join("folder.toml");
    std::fs::create_dir_all(&folder).unwrap();
    refused("folder", &folder);
}

#[test]
fn files_that_are_no_text() {
    let file = empty("of-bytes").join("bytes.toml");
    std::fs::write(&file, b"[part]\nshape = \"\xff\xfe\"\n").unwrap();
    refused("bytes", &file);
}

#[test]
fn files_with_nothing_in_them() {
    let file = empty("of-nothing").join("nothing.toml");
    std::fs::write(&file, "").unwrap();
    // Every quantity of a roll has a default: of those that read one, nothing is wrong with an empty file.
    for words in COMMANDS.iter().filter(|words| words[0] != "roll") {
        let words: Vec<&str> =
            words.iter().map(|word| if *word == "FILE" { file.to_str().unwrap() } else { word }).collect();
        let said: Said = command(&words, &empty("nothing-out")).output().unwrap().into();
        assert_eq!(said.code, 2, "{words:?}: {}", said.err);
        assert!(said.err.contains("nothing.toml"), "{words:?}: {}", said.err);
    }
}

/// What gives bytes for ever, and what gives none until somebody comes to its other end.
#[cfg(unix)]
#[test]
fn files_without_an_end() {
    refused("zero", Path::new("/dev/zero"));
    let pipe = empty("of-pipes").join("pipe.toml");
    assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    refused("pipe", &pipe);
}

/// A drawing in a scene's folder that has no end.
#[cfg(unix)]
#[test]
fn drawings_without_an_end() {
    let folder = empty("of-endless-drawings");
    std::fs::copy(examples().join("bracket.toml"), folder.join("bracket.toml")).unwrap();
    std::os::unix::fs::symlink("/dev/zero", folder.join("bracket.dxf")).unwrap();
    let said: Said =
        command(&["run", folder.join("bracket.toml").to_str().unwrap()], &folder).output().unwrap().into();
    assert_eq!(said.code, 2, "{}", said.err);
    assert!(said.err.contains("is longer than 64 MiB"), "{}", said.err);
}

#[test]
fn a_scene_is_judged_beside_a_command_line_that_is_wrong() {
    let file = empty("of-both").join("both.toml");
    let scene = std::fs::read_to_string(examples().join("designer.toml")).unwrap();
    std::fs::write(&file, format!("gravitas = 9.81\n{scene}")).unwrap();
    let file = file.to_str().unwrap();
    for words in
        [&["yield", file, "--samples", "1"][..], &["run", file, "--quick"], &["design", file, "--scan", "x"]]
    {
        let said: Said = command(words, &empty("both-out")).output().unwrap().into();
        assert_eq!(said.code, 2, "{words:?}: {}", said.err);
        assert!(said.err.contains(words[2]), "{words:?}: {}", said.err);
        assert!(
            said.err.contains("gravitas") && said.err.contains("both.toml:1:1"),
            "{words:?}: {}",
            said.err
        );
    }
}

#[cfg(unix)]
#[test]
fn files_that_may_not_be_read() {
    use std::os::unix::fs::PermissionsExt;
    let file = empty("of-secrets").join("secret.toml");
    std::fs::copy(examples().join("designer.toml"), &file).unwrap();
    std::fs::set_permissions(&file, std::fs::Permissions::from_mode(0o000)).unwrap();
    // Whoever may read everything is refused nothing.
    if std::fs::read(&file).is_err() {
        refused("secret", &file);
    }
}

/// What a scene's part is drawn in, and a body's surface.
#[test]
fn drawings_that_cannot_be_read() {
    for (scene, drawing, words) in [
        ("bracket.toml", "bracket.dxf", &["run"][..]),
        ("roll_body_bolt.toml", "bolt.stl", &["roll", "body"]),
    ] {
        let folder = empty(&format!("of-{drawing}"));
        let file = folder.join(scene);
        std::fs::copy(examples().join(scene), &file).unwrap();
        let words = [words, &[file.to_str().unwrap()]].concat();
        let refused = |kind: &str| {
            let out = empty(&format!("{drawing}-{kind}"));
            let said: Said = command(&words, &out).output().unwrap().into();
            assert_eq!(said.code, 2, "{kind}: {}", said.err);
            assert!(said.err.contains(drawing), "{kind}: {}", said.err);
            assert_eq!(std::fs::read_dir(&out).unwrap().count(), 0, "{kind}: it has written something");
        };
        refused("missing");
        std::fs::create_dir(folder.join(drawing)).unwrap();
        refused("folder");
        std::fs::remove_dir(folder.join(drawing)).unwrap();
        std::fs::write(folder.join(drawing), b"\xff\xfe\x00\x01").unwrap();
        refused("bytes");
    }
}
