//! The package for Python: built as a wheel, installed into an environment of its own, and tried there.

use crate::steps::{cargo, said_by};
use std::path::{Path, PathBuf};
use std::process::Command;

const PACKAGE: &str = "apps/carom-py";
/// What its tests need beside it.
const TESTS: &str = "apps/carom-py[derive,test]";
/// Tests of derivations, as the folder of the package names them.
const DERIVED: [&str; 3] = [
    "tests/test_derive.py",
    "tests/test_derive_engine.py",
    "tests/test_notebooks.py::test_simultaneous_collisions",
];

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
    // Derivations take as long as all the others, and a core each. The notebook that derives a table of formulas is read by their tests.
    let derived = DERIVED.map(|test| format!("{PACKAGE}/{test}"));
    // A single test is named from the package's folder on.
    let others = DERIVED.map(|test| {
        if test.contains("::") { format!("--deselect={test}") } else { format!("--ignore={PACKAGE}/{test}") }
    });
    let rest = [format!("{PACKAGE}/tests"), format!("{PACKAGE}/README.md"), "README.md".to_owned()];
    let tried = |files: &[String]| {
        let mut words = vec!["-m", "pytest", "-q", "-rP", "-p", "no:cacheprovider"];
        words.extend(files.iter().map(String::as_str));
        said(root, &python, &words)
    };
    let [derived, tests] = std::thread::scope(|scope| {
        let derived = scope.spawn(|| tried(&derived));
        let tests = tried(&[others.as_slice(), rest.as_slice()].concat());
        [derived.join().unwrap_or_else(|_| Err("the derivations' tests panicked".to_owned())), tests]
    });
    let (derived, tests) = (derived?, tests?);
    let docs = said(
        root,
        &python,
        &["-m", "pytest", "-q", "-p", "no:cacheprovider", "--doctest-modules", "--pyargs", "carom"],
    )?;
    let timed = said(root, &python, &[&format!("{PACKAGE}/measure.py")])?;
    let passed = |said: &str| said.lines().rev().find(|line| line.contains(" passed")).map(str::to_owned);
    let measured = tests.lines().chain(timed.lines()).filter_map(|line| line.strip_prefix("measured: "));
    let counts = [&tests, &derived, &docs].map(|said| passed(said).unwrap_or_default());
    Ok(format!(
        "{}; derivations {}; docs {}\n{}",
        counts[0],
        counts[1],
        counts[2],
        measured.collect::<Vec<_>>().join("\n")
    ))
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
