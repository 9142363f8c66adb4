//! Fuzzing: every target for some seconds, where a nightly compiler and cargo-fuzz are installed.

use crate::steps::answers;
use std::path::Path;
use std::process::{Command, ExitCode};

/// The targets: folders of `fuzz/corpus`.
const TARGETS: [&str; 7] = ["scene", "impact", "planar", "outline", "impact_file", "stl", "rate"];
/// How long each is run where nothing is said [s].
const SECONDS: u32 = 60;
/// Longest that one input may take [s], and longest input [bytes].
const PATIENCE: u32 = 20;
const LONGEST: u32 = 16_384;
/// Where inputs go that reach something new: they help the next run, and are no part of the project.
const WORKING: &str = "target/fuzz-corpus";

/// What the command line asks for.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Plan {
    seconds: u32,
    targets: Vec<&'static str>,
}

/// Reads `[--seconds N] [TARGET...]`.
pub(crate) fn plan(words: &[&str]) -> Result<Plan, String> {
    let mut plan = Plan { seconds: SECONDS, targets: vec![] };
    let mut rest = words.iter();
    while let Some(word) = rest.next() {
        if *word == "--seconds" {
            let number = rest.next().and_then(|number| number.parse().ok()).filter(|number| *number > 0);
            plan.seconds = number.ok_or("--seconds needs a whole number above 0")?;
        } else {
            let known = TARGETS.iter().find(|target| *target == word);
            let of = || format!("not a target: {word}; there are {}", TARGETS.join(", "));
            plan.targets.push(known.ok_or_else(of)?);
        }
    }
    if plan.targets.is_empty() {
        plan.targets = TARGETS.to_vec();
    }
    Ok(plan)
}

/// Fuzzes each target in turn; exits 1 where one found something, 2 where the tools are missing.
pub(crate) fn run(root: &Path, plan: &Plan) -> ExitCode {
    if let Some(missing) = missing() {
        eprintln!("nothing was fuzzed: {missing}");
        eprintln!("`cargo test -p carom-fuzz` replays the corpus without either");
        return ExitCode::from(2);
    }
    let mut broken = vec![];
    for target in &plan.targets {
        println!("{target}: {} s", plan.seconds);
        match fuzz(root, target, plan.seconds) {
            Ok(true) => {}
            Ok(false) => broken.push(*target),
            Err(problem) => {
                eprintln!("{target}: {problem}");
                broken.push(target);
            }
        }
    }
    if broken.is_empty() {
        println!("nothing found in {}", plan.targets.join(", "));
        return ExitCode::SUCCESS;
    }
    println!("found something: {} (inputs in fuzz/targets/artifacts)", broken.join(", "));
    ExitCode::FAILURE
}

/// What is missing of the tools, and how it is installed.
fn missing() -> Option<&'static str> {
    if !answers(nightly().arg("--version")) {
        return Some("there is no nightly compiler: rustup toolchain install nightly");
    }
    if !answers(nightly().args(["fuzz", "--version"])) {
        return Some("there is no cargo-fuzz: cargo install cargo-fuzz");
    }
    None
}

/// Cargo of the nightly toolchain: rustup's proxy chooses it, whichever toolchain runs this chore.
fn nightly() -> Command {
    let mut command = Command::new("cargo");
    for told in ["CARGO", "RUSTC", "RUSTUP_TOOLCHAIN"] {
        command.env_remove(told);
    }
    command.arg("+nightly");
    command
}

/// Fuzzes one target; false where it found something.
fn fuzz(root: &Path, target: &str, seconds: u32) -> Result<bool, String> {
    let said = |error: std::io::Error| error.to_string();
    let working = root.join(WORKING).join(target);
    std::fs::create_dir_all(&working).map_err(said)?;
    let seeds = root.join("fuzz/corpus").join(target);
    let mut command = nightly();
    // No target has unsafe code of its own: without a sanitizer it runs several times as often.
    command.current_dir(root).args([
        "fuzz",
        "run",
        "--fuzz-dir",
        "fuzz/targets",
        "--sanitizer",
        "none",
        target,
    ]);
    command.arg(working).arg(seeds).arg("--");
    command.arg(format!("-max_total_time={seconds}"));
    command.args([format!("-timeout={PATIENCE}"), format!("-max_len={LONGEST}")]);
    command.arg("-print_final_stats=1");
    command.status().map(|status| status.success()).map_err(said)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_targets_are_fuzzed_unless_some_are_named() {
        assert_eq!(plan(&[]), Ok(Plan { seconds: SECONDS, targets: TARGETS.to_vec() }), "all, a minute each");
        let some = plan(&["--seconds", "5", "rate", "stl"]);
        assert_eq!(some, Ok(Plan { seconds: 5, targets: vec!["rate", "stl"] }), "two of them");
    }

    #[test]
    fn unknown_targets_and_times_are_refused() {
        for words in [&["scenes"][..], &["--seconds"], &["--seconds", "0"], &["--seconds", "rate"]] {
            assert!(plan(words).is_err(), "{words:?} must be refused");
        }
    }

    #[test]
    fn every_target_has_seeds_and_a_program() {
        let root = crate::tree::root();
        for target in TARGETS {
            assert!(root.join("fuzz/corpus").join(target).is_dir(), "seeds of {target}");
            let program = root.join(format!("fuzz/targets/fuzz_targets/{target}.rs"));
            assert!(program.is_file(), "the program of {target}");
        }
    }
}
