//! A plate without a name has one label for people, counted from 1; paths keep its number, counted from 0.

use crate::command;

use command::{Said, command, empty, folder};
use std::path::{Path, PathBuf};

/// A second published case whose plates have no names; nothing is said besides but what is added to the second plate.
fn scene(place: &Path, added: &str) -> PathBuf {
    let text = format!(
        "[part]\nshape = \"rod\"\nlength = \"100 mm\"\nmass = \"0.3 kg\"\n[contact]\nfriction = \"0.15 ± 0.08\"\n\
         [start]\nto_edge = \"100 mm\"\n[[plate]]\nslope = \"10 ± 0.1 deg\"\n[[plate]]\ndownhill = \"left\"\n\
         line = {{ along = \"428 mm\", normal = \"300 mm\" }}\n{added}"
    );
    let path = place.join("unnamed.toml");
    std::fs::write(&path, text).unwrap();
    path
}

/// What a command says about the scene; what it writes goes to a folder of this name.
fn said(name: &str, added: &str, words: &[&str]) -> String {
    let place = empty(name);
    let file = scene(&place, added).display().to_string();
    let (verb, rest) = words.split_first().unwrap();
    let all: Vec<&str> = [*verb, &file].into_iter().chain(rest.iter().copied()).collect();
    let said: Said = command(&all, &place).output().unwrap().into();
    format!("{}{}", said.out, said.err)
}

#[test]
fn every_text_calls_a_plate_the_same() {
    let axes: &[&str] = &["map", "--x", "plate.0.slope=9..12 deg:4", "--y", "contact.friction=0.1..0.2:4"];
    let asked: [(&[&str], &str); 6] = [
        (&["run"], "TURNED on \"plate 2\""),
        (&["draw"], "\nplate 2, as written: "),
        (axes, "how a drop ends on \"plate 2\""),
        (&["feed", "--intervals", "16"], "limited by \"plate 1\""),
        (&["yield", "--samples", "64"], "on \"plate 2\""),
        (&["sweep", "--grid", "contact.friction=0.1..0.2:3"], "on \"plate 2\""),
    ];
    for (words, label) in asked {
        let text = said(words[0], "", words);
        assert!(text.contains(label), "{words:?}: {label}: {text}");
        let odd = |line: &&str| ["\"0\"", "\"1\""].iter().any(|number| line.contains(number));
        assert_eq!(text.lines().find(odd), None, "{words:?}");
    }
}

#[test]
fn pages_and_drawings_call_a_plate_the_same() {
    for (words, files) in [
        (&["draw"][..], &["drawing.svg", "drawing.dxf", "layout.svg"][..]),
        (&["yield", "--samples", "64"], &["yield.html"]),
    ] {
        let name = format!("{}_files", words[0]);
        said(&name, "", words);
        for file in files {
            let text = std::fs::read_to_string(folder(&name).join("unnamed").join(file)).unwrap();
            assert!(text.contains("plate 2"), "{file}");
        }
    }
}

#[test]
fn a_path_with_a_number_has_the_label_beside_it() {
    assert!(said("limits", "", &["run", "--limits"]).contains("plate.0.slope (plate 1)"), "limits");
    let text = said("deciders", "", &["yield", "--samples", "4096"]);
    assert!(text.contains("plate.0.slope (plate 1)"), "yields");
    let text = said("problem", "friction = -1\n", &["run"]);
    assert!(text.contains("plate.1.friction (plate 2): "), "{text}");
    let text =
        said("axis", "", &["map", "--x", "plate.1.slope=9..12 deg:4", "--y", "contact.friction=0.1..0.2:4"]);
    assert!(text.contains("did you mean \"plate.0.slope\" (plate 1)?"), "{text}");
}
