//! The package for Python: built as a wheel, installed into an environment of its own, and tried there.

use crate::steps::{cargo, said_by};
use std::path::{Path, PathBuf};
use std::process::Command;

const PACKAGE: &str = "apps/carom-py";
/// What its tests need beside it.
const TESTS: &str = "apps/carom-py[derive,test]";

/// Builds, installs and tries it; the note has what was measured.
pub(crate) fn check(root: &Path) -> Result<String, String> {
    let own = environment(root)?;
    let program = |name: &str| own.join("bin").join(name);
    // The command, whose answers are compared.
    cargo(root, &["build", "--release", "--package", "carom-cli"])?;
    cargo(root, &["build", "--release", "--package", "carom-py", "--example", "impacts"])?;
    said(root, &program("pip"), &["install", "--quiet", &format!("./{TESTS}")])?;
    let python = program("python");
    said(root, &python, &[&format!("{PACKAGE}/generate.py"), "check"])?;
    let folder = root.join(PACKAGE);
    said(&folder, &program("mypy"), &["python", "tests"])?;
    said(&folder, &python, &["-m", "mypy.stubtest", "carom._carom"])?;
    said(&folder, &program("pyright"), &["--pythonpath", &python.to_string_lossy(), "python"])?;
    let tests = said(
        root,
        &python,
        &[
            "-m",
            "pytest",
            "-q",
            "-rP",
            "-p",
            "no:cacheprovider",
            &format!("{PACKAGE}/tests"),
            &format!("{PACKAGE}/README.md"),
            "README.md",
        ],
    )?;
    let docs = said(
        root,
        &python,
        &["-m", "pytest", "-q", "-p", "no:cacheprovider", "--doctest-modules", "--pyargs", "carom"],
    )?;
    let timed = said(root, &python, &[&format!("{PACKAGE}/measure.py")])?;
    let passed = |said: &str| said.lines().rev().find(|line| line.contains(" passed")).map(str::to_owned);
    let measured = tests.lines().chain(timed.lines()).filter_map(|line| line.strip_prefix("measured: "));
    let counts = [&tests, &docs].map(|said| passed(said).unwrap_or_default());
    Ok(format!("{}; docs {}\n{}", counts[0], counts[1], measured.collect::<Vec<_>>().join("\n")))
}

/// A new environment of Python, without what the machine has.
fn environment(root: &Path) -> Result<PathBuf, String> {
    let place = root.join("target/python");
    if place.exists() {
        std::fs::remove_dir_all(&place).map_err(|problem| format!("{}: {problem}", place.display()))?;
    }
    let mut command = Command::new("python3");
    command.args(["-m", "venv"]).arg(&place).current_dir(root);
    said_by(command)?;
    Ok(place)
}

fn said(folder: &Path, program: &Path, words: &[&str]) -> Result<String, String> {
    let mut command = Command::new(program);
    command.args(words).current_dir(folder);
    said_by(command)
}
