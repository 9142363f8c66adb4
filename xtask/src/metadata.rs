//! The workspace's packages and what they depend on, as cargo understands their manifests.

use crate::steps::cargo_program;
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::Command;

/// What a dependency is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Use {
    Normal,
    Build,
    Tests,
}

/// One line of a manifest's dependencies.
#[derive(Clone, Debug)]
pub(crate) struct Dependency {
    /// The package's own name, also where it is renamed.
    pub(crate) name: String,
    pub(crate) used_for: Use,
}

/// One member of the workspace.
#[derive(Clone, Debug)]
pub(crate) struct Package {
    pub(crate) name: String,
    /// Its folder, relative to the workspace: `crates/carom-num`.
    pub(crate) folder: String,
    pub(crate) dependencies: Vec<Dependency>,
}

/// The workspace.
pub(crate) struct Workspace {
    pub(crate) packages: Vec<Package>,
    pub(crate) target: PathBuf,
}

/// Asks cargo for the members, in order of their names.
pub(crate) fn workspace(root: &Path) -> Result<Workspace, String> {
    let json = of_cargo(root, &["--no-deps"])?;
    parse(&json).ok_or_else(|| "cargo metadata does not look as it used to".to_owned())
}

/// What `cargo metadata` says, asked with these words.
pub(crate) fn of_cargo(root: &Path, words: &[&str]) -> Result<Value, String> {
    let output = Command::new(cargo_program())
        .args(["metadata", "--format-version", "1"])
        .args(words)
        .current_dir(root)
        .output()
        .map_err(|problem| format!("cargo metadata: {problem}"))?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    serde_json::from_slice(&output.stdout).map_err(|problem| format!("cargo metadata: {problem}"))
}

fn parse(json: &Value) -> Option<Workspace> {
    let root = Path::new(json["workspace_root"].as_str()?);
    let target = PathBuf::from(json["target_directory"].as_str()?);
    let mut packages: Vec<Package> =
        json["packages"].as_array()?.iter().map(|entry| package(root, entry)).collect::<Option<_>>()?;
    packages.sort_by(|a, b| a.name.cmp(&b.name));
    Some(Workspace { packages, target })
}

fn package(root: &Path, entry: &Value) -> Option<Package> {
    let folder = Path::new(entry["manifest_path"].as_str()?).parent()?.strip_prefix(root).ok()?;
    let dependencies = entry["dependencies"].as_array()?.iter().map(dependency).collect::<Option<_>>()?;
    Some(Package {
        name: entry["name"].as_str()?.to_owned(),
        folder: folder.to_string_lossy().replace('\\', "/"),
        dependencies,
    })
}

fn dependency(entry: &Value) -> Option<Dependency> {
    let used_for = match entry["kind"].as_str() {
        None => Use::Normal,
        Some("build") => Use::Build,
        Some("dev") => Use::Tests,
        Some(_) => return None,
    };
    Some(Dependency { name: entry["name"].as_str()?.to_owned(), used_for })
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn a_manifest_is_read_with_the_use_of_each_dependency() {
        let json = json!({
            "workspace_root": "/w", "target_directory": "/w/target",
            "packages": [{ "name": "b", "manifest_path": "/w/crates/b/Cargo.toml", "dependencies": [
                { "name": "libm", "kind": null }, { "name": "cc", "kind": "build" }, { "name": "a", "kind": "dev" },
            ]}],
        });
        let workspace = parse(&json).expect("the shape cargo gives");
        let package = &workspace.packages[0];
        assert_eq!(package.folder, "crates/b", "the folder is relative to the workspace");
        let uses: Vec<Use> = package.dependencies.iter().map(|d| d.used_for).collect();
        assert_eq!(uses, [Use::Normal, Use::Build, Use::Tests], "normal, build, tests");
    }

    #[test]
    fn a_shape_that_is_not_cargos_is_refused() {
        assert!(parse(&json!({ "packages": [] })).is_none(), "no workspace root");
    }
}
