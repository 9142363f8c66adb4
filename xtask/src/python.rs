//! The package for Python: built as a wheel, installed into an environment of its own, and tried there.

use crate::steps::{cargo, cargo_program, said_by};
use crate::studio;
use std::path::{Path, PathBuf};
use std::process::Command;

const PACKAGE: &str = "apps/carom-py";
/// The studio's page within the package, for notebooks.
const PAGE: &str = "apps/carom-py/python/carom/carom-studio.html";
const WHEELS: &str = "target/wheels";
const MATURIN: &str = "maturin>=1.16,<2";
/// The first interpreter without a lock that the bridge to Python knows.
const FREE_THREADED: &str = "3.14t";
/// Tests of derivations, as the folder of the package names them.
const DERIVED: [&str; 3] = [
    "tests/test_derive.py",
    "tests/test_derive_engine.py",
    "tests/test_notebooks.py::test_simultaneous_collisions",
];

/// Builds the wheels, with the studio in them; the note says where they are.
pub(crate) fn wheels(root: &Path) -> Result<String, String> {
    let own = environment(root)?;
    let each = [wheel(root, &own)?, free_threaded(root, &own)?];
    Ok(each.map(|wheel| format!("{WHEELS}/{wheel}")).join("\n"))
}

/// Builds the wheel that every interpreter from 3.11 on takes: its name.
fn wheel(root: &Path, own: &Path) -> Result<String, String> {
    let page = root.join(studio::page(root)?);
    std::fs::copy(&page, root.join(PAGE)).map_err(|problem| format!("{}: {problem}", page.display()))?;
    built(maturin(root, own)?)
}

/// Builds the wheel for interpreters without a lock. None has to be on this machine: what it has to know of one, maturin knows.
fn free_threaded(root: &Path, own: &Path) -> Result<String, String> {
    let mut rustc = Command::new("rustc");
    rustc.arg("-vV");
    let said = said_by(rustc)?;
    let host = said.lines().find_map(|line| line.strip_prefix("host: ")).unwrap_or_default();
    let mut command = maturin(root, own)?;
    command.args(["--interpreter", &format!("python{FREE_THREADED}"), "--target", host]);
    command.env("PYO3_CROSS", "1").env("PYO3_CROSS_PYTHON_VERSION", FREE_THREADED);
    built(command)
}

/// `maturin build`, of an environment that has it.
fn maturin(root: &Path, own: &Path) -> Result<Command, String> {
    let program = |name: &str| own.join("bin").join(name);
    said(root, &program("pip"), &["install", "--quiet", MATURIN])?;
    let mut command = Command::new(program("maturin"));
    command.args(["build", "--release", "--locked", "--out"]).arg(root.join(WHEELS));
    command.current_dir(root.join(PACKAGE)).env("CARGO", cargo_program());
    Ok(command)
}

/// Runs maturin: the name of the wheel that it says it built.
fn built(command: Command) -> Result<String, String> {
    let said = said_by(command)?;
    let wheel = said
        .lines()
        .rev()
        .find_map(|line| line.rsplit(['/', '\\']).next().filter(|name| name.ends_with(".whl")));
    wheel.map(str::to_owned).ok_or_else(|| format!("maturin names no wheel:\n{said}"))
}

/// Builds, installs and tries it; the note has what was measured.
pub(crate) fn check(root: &Path) -> Result<String, String> {
    let own = environment(root)?;
    let program = |name: &str| own.join("bin").join(name);
    // The command, whose answers are compared.
    cargo(root, &["build", "--release", "--package", "carom-cli"])?;
    cargo(root, &["build", "--release", "--package", "carom-py", "--example", "impacts"])?;
    let wheel = wheel(root, &own)?;
    said(root, &program("pip"), &["install", "--quiet", &format!("./{WHEELS}/{wheel}[derive,test]")])?;
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
