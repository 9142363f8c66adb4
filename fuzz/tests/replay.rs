//! Every input in `corpus/` again: seeds, and what once broke something.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use carom_fuzz::TARGETS;
use std::path::{Path, PathBuf};

/// Largest corpus of all targets together [bytes]: a checkout carries it.
const MOST_BYTES: usize = 200_000;

fn corpus(target: &str) -> Vec<(PathBuf, Vec<u8>)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus").join(target);
    let entries = std::fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    paths.into_iter().map(|path| (path.clone(), std::fs::read(&path).unwrap())).collect()
}

fn replay(target: &str) {
    let run = TARGETS.iter().find(|(name, _)| *name == target).expect("a target of this name").1;
    let inputs = corpus(target);
    assert!(!inputs.is_empty(), "{target} has no inputs");
    for (path, bytes) in inputs {
        let held = std::panic::catch_unwind(|| run(&bytes));
        assert!(held.is_ok(), "{} breaks what must hold of {target}", path.display());
    }
}

macro_rules! replays {
    ($($test:ident: $target:literal;)*) => {
        $(
            #[test]
            fn $test() {
                replay($target);
            }
        )*

        #[test]
        fn every_target_is_replayed() {
            let replayed = [$($target),*];
            let targets: Vec<&str> = TARGETS.iter().map(|(name, _)| *name).collect();
            assert_eq!(targets, replayed, "targets of the library, and tests of this file");
        }
    };
}

replays! {
    scenes_hold: "scene";
    impacts_hold: "impact";
    feeders_hold: "planar";
    outlines_hold: "outline";
    impact_files_hold: "impact_file";
    stl_files_hold: "stl";
    rate_problems_hold: "rate";
}

#[test]
fn the_corpus_is_small() {
    let bytes: usize = TARGETS.iter().flat_map(|(name, _)| corpus(name)).map(|(_, bytes)| bytes.len()).sum();
    assert!(bytes <= MOST_BYTES, "{bytes} bytes, {MOST_BYTES} allowed: minimise inputs before they are kept");
}
