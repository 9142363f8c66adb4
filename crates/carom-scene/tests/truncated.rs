//! Every example, ended early at every byte: it is read, or everything wrong with it is listed.

use carom_scene::{
    AnyImpact, AnyScene, Problems, RollKind, RollProblem, Scene, SpatialRollKind, SpatialRollProblem,
};
use std::path::{Path, PathBuf};

fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples")
}

/// The examples whose names begin with one of these and end so, in order.
fn named(first: &[&str], ending: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(examples()).unwrap().map(|entry| entry.unwrap().path());
    let mut found: Vec<PathBuf> = entries
        .filter(|path| {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            name.ends_with(ending) && first.iter().any(|first| name.starts_with(first))
        })
        .collect();
    found.sort();
    found
}

/// How many beginnings of a text were read, and how many refused.
#[derive(Default)]
struct Tally {
    read: usize,
    refused: usize,
}

impl Tally {
    fn note(&mut self, file: &Path, end: usize, refusals: Option<Vec<Problems>>) {
        let Some(refusals) = refusals else {
            self.read += 1;
            return;
        };
        self.refused += 1;
        let place = format!("{} ended at byte {end}", file.display());
        assert!(!refusals.is_empty(), "{place}: a refusal without a list");
        for problems in refusals {
            assert!(!problems.list.is_empty(), "{place}: a list without a problem");
            let shown = problems.to_string();
            for problem in &problems.list {
                assert!(!problem.message.is_empty(), "{place}: a problem without words");
                assert!(shown.contains(&problem.message), "{place}: a problem that is not shown: {shown}");
            }
        }
    }
}

/// Reads every beginning of these files.
fn every_beginning(files: &[PathBuf], read: impl Fn(&Path, &str) -> Result<(), Vec<Problems>>) -> Tally {
    let mut tally = Tally::default();
    for file in files {
        let text = std::fs::read_to_string(file).unwrap();
        assert!(read(file, &text).is_ok(), "{} is an example", file.display());
        for end in (0..text.len()).filter(|end| text.is_char_boundary(*end)) {
            tally.note(file, end, read(file, &text[..end]).err());
        }
    }
    tally
}

#[test]
fn scenes_that_end_early_list_their_problems() {
    let mut files = named(&[""], ".toml");
    files.retain(|file| {
        let name = file.file_name().unwrap().to_string_lossy();
        !["impact_", "contact_", "roll_"].iter().any(|kind| name.starts_with(kind))
    });
    let tally = every_beginning(&files, |file, text| {
        AnyScene::parse(&file.display().to_string(), text).map(drop).map_err(|problems| vec![problems])
    });
    assert!(files.len() > 10 && tally.refused > tally.read, "{} read, {} refused", tally.read, tally.refused);
}

#[test]
fn impacts_that_end_early_list_their_problems() {
    let files = named(&["impact_", "contact_"], ".toml");
    let tally = every_beginning(&files, |file, text| {
        AnyImpact::parse(&file.display().to_string(), text).map(drop).map_err(|problems| vec![problems])
    });
    assert!(files.len() > 4 && tally.refused > tally.read, "{} read, {} refused", tally.read, tally.refused);
}

#[test]
fn rolls_that_end_early_list_their_problems() {
    let kinds =
        [("roll_cylinder", RollKind::Cylinder), ("roll_prism", RollKind::Prism), ("roll_rod", RollKind::Rod)];
    let mut tally = Tally::default();
    for (name, kind) in kinds {
        let one = every_beginning(&named(&[name], ".toml"), |file, text| {
            RollProblem::parse(kind, &file.display().to_string(), text, &[]).map(drop).map_err(|list| list.0)
        });
        (tally.read, tally.refused) = (tally.read + one.read, tally.refused + one.refused);
    }
    let kinds = [
        ("roll_pyramid", SpatialRollKind::Pyramid),
        ("roll_stool", SpatialRollKind::Stool),
        ("roll_body", SpatialRollKind::Body),
    ];
    for (name, kind) in kinds {
        let one = every_beginning(&named(&[name], ".toml"), |file, text| {
            let parsed = SpatialRollProblem::parse(kind, &file.display().to_string(), text, &[]);
            parsed.map(drop).map_err(|list| list.0)
        });
        (tally.read, tally.refused) = (tally.read + one.read, tally.refused + one.refused);
    }
    // Every quantity of a roll has a default, so that comments and whole lines are files.
    assert!(tally.read > 0 && tally.refused > 0, "{} read, {} refused", tally.read, tally.refused);
}

/// Every beginning of a file that another one names, in a folder of its own.
fn every_beginning_of(named: &Path, read: impl Fn(&Path) -> Result<(), Vec<Problems>>) -> Tally {
    let name = named.file_name().unwrap();
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("truncated-{}", name.to_string_lossy()));
    std::fs::create_dir_all(&folder).unwrap();
    let bytes = std::fs::read(named).unwrap();
    let mut tally = Tally::default();
    for end in 0..=bytes.len() {
        std::fs::write(folder.join(name), &bytes[..end]).unwrap();
        tally.note(named, end, read(&folder).err());
    }
    tally
}

#[test]
fn outlines_that_end_early_list_their_problems() {
    let text = std::fs::read_to_string(examples().join("bracket.toml")).unwrap();
    let tally = every_beginning_of(&examples().join("bracket.dxf"), |folder| {
        let file = folder.join("scene.toml").display().to_string();
        Scene::parse(&file, &text).map(drop).map_err(|problems| vec![problems])
    });
    assert!(tally.read > 0 && tally.refused > tally.read, "{} read, {} refused", tally.read, tally.refused);
}

#[test]
fn surfaces_that_end_early_list_their_problems() {
    let text = std::fs::read_to_string(examples().join("roll_body_bolt.toml")).unwrap();
    let tally = every_beginning_of(&examples().join("bolt.stl"), |folder| {
        let file = folder.join("body.toml").display().to_string();
        SpatialRollProblem::parse(SpatialRollKind::Body, &file, &text, &[]).map(drop).map_err(|list| list.0)
    });
    assert!(tally.read > 0 && tally.refused > tally.read, "{} read, {} refused", tally.read, tally.refused);
}

#[test]
fn svg_outlines_that_end_early_list_their_problems() {
    let part = "[part]\nshape = \"outline\"\nfile = \"plate.svg\"\nchord = \"0.1 mm\"\nmass = \"0.1 kg\"\n";
    let rest = "[contact]\nfriction = 0.2\n[start]\nto_edge = \"60 mm\"\n[[plate]]\nslope = \"20 deg\"\n";
    let drawing = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/outlines/plate.svg");
    let tally = every_beginning_of(&drawing, |folder| {
        let file = folder.join("scene.toml").display().to_string();
        Scene::parse(&file, &format!("{part}{rest}")).map(drop).map_err(|problems| vec![problems])
    });
    assert!(tally.read > 0 && tally.refused > tally.read, "{} read, {} refused", tally.read, tally.refused);
}
