//! How many lines of the engine the tests of its crates reach, where cargo-llvm-cov is installed.

use crate::arrows::ENGINE;
use crate::steps::{answers, cargo_program};
use serde_json::Value;
use std::fmt::Write as _;
use std::path::Path;
use std::process::{Command, ExitCode};

/// Least share of the lines of an engine crate that its tests reach.
const LEAST: f64 = 0.95;
/// Tests that run for minutes where every line is counted, and reach nothing that shorter ones do not.
const LEFT_OUT: [&str; 15] = [
    "a_box_that_stays_in_a_plane_moves_as_the_plane_says",
    "a_hundred_thousand_random_sets",
    "broken_numbers",
    "contacts_in_all_directions_gain_no_energy",
    "energy_never_grows_and_no_contact_approaches_after",
    "energy_never_grows_and_nothing_sinks",
    "in_a_plane_two_contacts_are_the_walk_of_the_plane",
    "parts_of_random_feeds_stay_apart",
    "ten_thousand_random_feeders",
    "that_run_out_anywhere_are_said",
    "that_runs_out_at_every_event",
    "the_order_of_the_contacts_does_not_matter",
    "thrown_",
    "turning_the_world_turns_the_outcome",
    "with_a_slip_before_ample_friction",
];
/// Files that are tests themselves.
const TESTS: &str = r"broken_numbers\.rs|/tests\.rs|/tests/";

/// Lines of a file or a crate.
#[derive(Clone, Debug, Default, PartialEq)]
struct Lines {
    name: String,
    all: u64,
    reached: u64,
}

impl Lines {
    fn share(&self) -> f64 {
        self.reached as f64 / self.all.max(1) as f64
    }
}

/// Runs the tests of the engine crates and counts; exits 1 where a crate is below [`LEAST`], 2 where the tool is missing.
pub(crate) fn run(root: &Path) -> ExitCode {
    if !answers(llvm_cov(root).arg("--version")) {
        eprintln!("nothing was counted: there is no cargo-llvm-cov: cargo install cargo-llvm-cov");
        return ExitCode::from(2);
    }
    match counted(root) {
        Ok(files) => {
            let crates: Vec<Lines> = ENGINE.iter().map(|name| sum(name, &files)).collect();
            print!("{}", table(&crates, &files));
            ExitCode::from(u8::from(crates.iter().any(|lines| lines.share() < LEAST)))
        }
        Err(problem) => {
            eprintln!("{problem}");
            ExitCode::FAILURE
        }
    }
}

fn llvm_cov(root: &Path) -> Command {
    let mut command = Command::new(cargo_program());
    command.arg("llvm-cov").current_dir(root);
    command
}

/// The lines of every source file that the tests of the engine reach.
fn counted(root: &Path) -> Result<Vec<Lines>, String> {
    let mut tests = llvm_cov(root);
    tests.args(["test", "--no-report"]);
    tests.args(ENGINE.iter().flat_map(|name| ["--package", name]));
    tests.arg("--").args(LEFT_OUT.iter().flat_map(|name| ["--skip", name]));
    let status = tests.status().map_err(|error| format!("{tests:?}\n{error}"))?;
    if !status.success() {
        return Err("a test fails: nothing was counted".to_owned());
    }
    let mut report = llvm_cov(root);
    report.args(["report", "--json", "--summary-only", "--ignore-filename-regex", TESTS]);
    let said = report.output().map_err(|error| format!("{report:?}\n{error}"))?;
    if !said.status.success() {
        return Err(String::from_utf8_lossy(&said.stderr).into_owned());
    }
    let report: Value = serde_json::from_slice(&said.stdout).map_err(|error| error.to_string())?;
    Ok(files(&report, root))
}

/// The files of a report, by their path below the root.
fn files(report: &Value, root: &Path) -> Vec<Lines> {
    let listed = report["data"][0]["files"].as_array().map(Vec::as_slice).unwrap_or_default();
    let file = |entry: &Value| {
        let path = Path::new(entry["filename"].as_str()?).strip_prefix(root).ok()?;
        let lines = &entry["summary"]["lines"];
        let name = path.to_string_lossy().replace('\\', "/");
        Some(Lines { name, all: lines["count"].as_u64()?, reached: lines["covered"].as_u64()? })
    };
    listed.iter().filter_map(file).collect()
}

/// The files of a crate.
fn own<'f>(name: &str, files: &'f [Lines]) -> impl Iterator<Item = &'f Lines> + use<'f> {
    let folder = format!("crates/{name}/src/");
    files.iter().filter(move |file| file.name.starts_with(&folder))
}

/// All files of a crate.
fn sum(name: &str, files: &[Lines]) -> Lines {
    own(name, files).fold(Lines { name: name.to_owned(), ..Lines::default() }, |sum, file| Lines {
        all: sum.all + file.all,
        reached: sum.reached + file.reached,
        ..sum
    })
}

/// A line each crate, and each file below the least.
fn table(crates: &[Lines], files: &[Lines]) -> String {
    let mut out = String::new();
    let below = crates.iter().flat_map(|of| own(&of.name, files)).filter(|file| file.share() < LEAST);
    for lines in crates.iter().chain(below) {
        let Lines { name, all, reached } = lines;
        let _ = writeln!(out, "{:6.2} %  {reached:6} of {all:6} lines  {name}", 100.0 * lines.share());
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_summed_by_crate_and_files_below_the_least_are_named() {
        let entry = |path: &str, count: u64, covered: u64| {
            let lines = serde_json::json!({ "count": count, "covered": covered });
            serde_json::json!({ "filename": path, "summary": { "lines": lines } })
        };
        let report = serde_json::json!({ "data": [{ "files": [
            entry("/here/crates/carom-num/src/a.rs", 30, 30),
            entry("/here/crates/carom-num/src/b.rs", 10, 9),
            entry("/here/crates/carom-study/src/c.rs", 10, 0),
        ] }] });
        let files = files(&report, Path::new("/here"));
        let sum = sum("carom-num", &files);
        assert_eq!((sum.all, sum.reached), (40, 39), "both files of the crate, and no other's");
        let table = table(&[sum], &files);
        assert!(table.starts_with(" 97.50 %      39 of     40 lines  carom-num\n"), "{table}");
        assert!(table.contains("b.rs") && !table.contains("a.rs") && !table.contains("c.rs"), "{table}");
    }
}
