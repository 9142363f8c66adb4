//! Which crate may depend on which: the arrows of `ARCHITECTURE.md`.

use crate::metadata::{self, Dependency, Package, Use};
use crate::rooms;
use std::path::Path;

/// Our crates by height. An arrow may only point down; two crates of one height do not see each other.
const HEIGHTS: [(&str, u8); 13] = [
    ("carom-num", 0),
    ("carom-impact", 1),
    ("carom-motion", 2),
    ("carom-feeder", 3),
    ("carom-study", 4),
    ("carom-words", 5),
    ("carom-scene", 6),
    ("carom-figure", 6),
    ("carom", 7),
    ("carom-validation", 7),
    ("carom-studio", 8),
    ("carom-sweep", 8),
    ("carom-referee", 8),
];
/// Everything else in `apps/`.
const APP_HEIGHT: u8 = 9;
/// The closed forms stand apart, so that a test against them is a test against something else.
const THEORY: &str = "carom-theory";
/// Whose answers set them beside the engine's.
const FACE: &str = "carom";

/// The crates that must stay light enough for a browser, and all that they may use from outside.
pub(crate) const ENGINE: [&str; 5] = ["carom-num", "carom-impact", "carom-motion", "carom-feeder", THEORY];
const ENGINE_MAY_USE: [&str; 2] = ["libm", "thiserror"];

/// External crates that have one home below `apps/` (an empty home: none); tables and their report are files too.
const HOMES: [(&str, &[&str]); 14] = [
    ("serde", &["carom-scene", "carom-validation"]),
    ("serde_json", &["carom-scene", "carom"]),
    ("serde_path_to_error", &["carom-scene"]),
    ("toml", &["carom-scene", "carom-validation"]),
    ("schemars", &["carom-scene", "carom-validation"]),
    ("miette", &["carom-scene"]),
    ("rayon", &["carom-study"]),
    ("resvg", &["carom-figure"]),
    ("maud", &["carom-figure"]),
    ("anyhow", &[]),
    ("axum", &[]),
    ("clap", &[]),
    ("indicatif", &[]),
    ("tokio", &[]),
];

/// Checks the workspace's manifests, and the rooms within crates.
pub(crate) fn check(root: &Path) -> Result<String, String> {
    let packages = metadata::workspace(root)?.packages;
    let faults = [faults(&packages), rooms::faults(root)?].concat();
    if faults.is_empty() { Ok(format!("{} packages", packages.len())) } else { Err(faults.join("\n")) }
}

fn faults(packages: &[Package]) -> Vec<String> {
    let mut found = vec![];
    for package in packages {
        if package.folder.starts_with("crates/") && height(package).is_none() && package.name != THEORY {
            found.push(format!(
                "{}: a new crate needs a decision note in docs/decisions/ and a height in xtask/src/arrows.rs",
                package.name
            ));
        }
        for dependency in &package.dependencies {
            let fault = match packages.iter().find(|other| other.name == dependency.name) {
                Some(other) => inner_fault(package, dependency, other),
                None => outer_fault(package, dependency),
            };
            found.extend(fault.map(|why| format!("{} -> {}: {why}", package.name, dependency.name)));
        }
    }
    found
}

/// `None` for theory and for packages outside `crates/` and `apps/`.
fn height(package: &Package) -> Option<u8> {
    let known = HEIGHTS.iter().find(|(name, _)| *name == package.name).map(|(_, height)| *height);
    known.or_else(|| package.folder.starts_with("apps/").then_some(APP_HEIGHT))
}

/// What is wrong with an arrow between two of ours.
fn inner_fault(package: &Package, dependency: &Dependency, other: &Package) -> Option<String> {
    if package.name == THEORY {
        return Some("the closed forms depend on nothing of ours, not even in tests".to_owned());
    }
    if dependency.used_for == Use::Tests {
        return None;
    }
    if other.name == THEORY {
        // Answers show them beside the engine's results; what computes these does not see them.
        let outside = ["apps/", "bench/"].iter().any(|folder| package.folder.starts_with(folder));
        return (!outside && package.name != FACE)
            .then(|| "only tests, measurements, apps and the face may name the closed forms".to_owned());
    }
    match (height(package), height(other)) {
        (Some(from), Some(to)) if to >= from => Some("the arrow points up or sideways".to_owned()),
        (Some(_), None) => Some("nothing in crates/ or apps/ may depend on a package beside them".to_owned()),
        _ => None,
    }
}

/// What is wrong with an arrow to a crate from outside.
fn outer_fault(package: &Package, dependency: &Dependency) -> Option<String> {
    if dependency.used_for == Use::Tests || !package.folder.starts_with("crates/") {
        return None;
    }
    if ENGINE.contains(&package.name.as_str()) {
        let allowed = ENGINE_MAY_USE.contains(&dependency.name.as_str());
        return (!allowed).then(|| format!("an engine crate uses only {}", ENGINE_MAY_USE.join(", ")));
    }
    let (_, homes) = HOMES.iter().find(|(name, _)| *name == dependency.name)?;
    if homes.contains(&package.name.as_str()) {
        return None;
    }
    let whose = homes.join(" and ");
    Some(if homes.is_empty() { "its home is apps/".to_owned() } else { format!("its home is {whose}") })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn package(folder: &str, dependencies: &[(&str, Use)]) -> Package {
        let name = folder.rsplit('/').next().unwrap().to_owned();
        let dependencies = dependencies
            .iter()
            .map(|(name, used_for)| Dependency { name: (*name).to_owned(), used_for: *used_for })
            .collect();
        Package { name, folder: folder.to_owned(), dependencies }
    }

    /// The faults of a house in which one crate has the dependencies given and the others have none.
    fn with(folder: &str, dependencies: &[(&str, Use)]) -> Vec<String> {
        let mut packages = vec![package(folder, dependencies)];
        for name in HEIGHTS.iter().map(|(name, _)| *name).chain([THEORY]) {
            if packages[0].name != name {
                packages.push(package(&format!("crates/{name}"), &[]));
            }
        }
        packages.push(package("apps/carom-web", &[]));
        packages.push(package("xtask", &[]));
        faults(&packages)
    }

    #[test]
    fn arrows_that_point_down_are_allowed() {
        let all_down =
            [("carom-num", Use::Normal), ("carom-impact", Use::Normal), ("thiserror", Use::Normal)];
        assert!(with("crates/carom-motion", &all_down).is_empty(), "motion stands on impact and num");
        let app = [("carom", Use::Normal), ("carom-figure", Use::Normal), ("clap", Use::Normal)];
        assert!(with("apps/carom-cli", &app).is_empty(), "an app stands on everything");
    }

    #[test]
    fn arrows_that_point_up_or_sideways_are_refused() {
        for (from, to) in [
            ("crates/carom-impact", "carom-motion"),
            ("crates/carom-scene", "carom-figure"),
            ("crates/carom-figure", "carom"),
            ("apps/carom-cli", "carom-web"),
            ("apps/carom-cli", "xtask"),
        ] {
            assert_eq!(with(from, &[(to, Use::Normal)]).len(), 1, "{from} -> {to}");
            assert_eq!(with(from, &[(to, Use::Build)]).len(), 1, "{from} -> {to}, to build");
        }
    }

    #[test]
    fn tests_may_look_up_and_at_the_closed_forms() {
        let for_tests =
            [("carom-theory", Use::Tests), ("carom-feeder", Use::Tests), ("proptest", Use::Tests)];
        assert!(with("crates/carom-num", &for_tests).is_empty(), "dev-dependencies are free");
    }

    #[test]
    fn the_closed_forms_stand_apart() {
        assert_eq!(
            with("crates/carom-feeder", &[("carom-theory", Use::Normal)]).len(),
            1,
            "named by the engine"
        );
        assert!(with("apps/carom-cli", &[("carom-theory", Use::Normal)]).is_empty(), "an app draws them");
        assert!(
            with("bench/campaign", &[("carom-theory", Use::Normal)]).is_empty(),
            "a campaign counts by them"
        );
        assert_eq!(
            with("crates/carom-theory", &[("carom-num", Use::Tests)]).len(),
            1,
            "leaning on ours in tests"
        );
        assert!(with("crates/carom-theory", &[("libm", Use::Normal)]).is_empty(), "libm is not ours");
    }

    #[test]
    fn external_crates_stay_at_home() {
        for (folder, name) in [
            ("crates/carom-num", "serde"),
            ("crates/carom-feeder", "rand"),
            ("crates/carom-figure", "serde_json"),
            ("crates/carom-scene", "rayon"),
            ("crates/carom-scene", "anyhow"),
        ] {
            assert_eq!(with(folder, &[(name, Use::Normal)]).len(), 1, "{folder} -> {name}");
        }
        assert!(with("crates/carom-scene", &[("serde", Use::Normal)]).is_empty(), "serde's home");
        assert!(with("crates/carom-validation", &[("toml", Use::Normal)]).is_empty(), "tables are files");
        assert!(with("crates/carom-study", &[("rayon", Use::Normal)]).is_empty(), "rayon's home");
    }

    #[test]
    fn a_crate_without_a_height_is_refused() {
        assert_eq!(with("crates/carom-tenth", &[]).len(), 1, "a tenth crate needs a decision");
    }
}
