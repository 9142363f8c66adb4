//! Running steps: one line each, the whole output where one fails.

use std::io::{self, Read, Write};
use std::path::Path;
use std::process::{Command, ExitCode, Stdio};
use std::time::Instant;

/// One step of `check`. It answers with a note for its line, or with everything that was said when it failed.
pub(crate) struct Step {
    pub(crate) name: &'static str,
    pub(crate) run: fn(&Path) -> Result<String, String>,
}

/// Runs all the steps, the later ones too when an earlier one fails; exit code 1 where any failed.
pub(crate) fn run_all(root: &Path, chosen: &[&Step]) -> ExitCode {
    let failed: Vec<&str> = chosen.iter().filter(|step| !passes(root, step)).map(|step| step.name).collect();
    if failed.is_empty() {
        return ExitCode::SUCCESS;
    }
    println!("failed: {}", failed.join(", "));
    ExitCode::FAILURE
}

fn passes(root: &Path, step: &Step) -> bool {
    print!("{:<9}", step.name);
    // A terminal shows the step while it runs; a closed one is no reason to stop checking.
    let _shown = io::stdout().flush();
    let start = Instant::now();
    let outcome = (step.run)(root);
    let seconds = start.elapsed().as_secs_f64();
    match &outcome {
        Ok(note) => println!("ok   {seconds:7.1} s   {note}"),
        Err(said) => println!("FAIL {seconds:7.1} s\n{}\n", said.trim_end()),
    }
    outcome.is_ok()
}

/// Runs cargo in `root`; an empty note where it exits 0.
pub(crate) fn cargo(root: &Path, words: &[&str]) -> Result<String, String> {
    let mut command = Command::new(cargo_program());
    command.args(words).current_dir(root);
    said_by(command).map(|_| String::new())
}

/// Builds all that `cargo test --workspace` runs, and the libraries and programs beside it. Any of these alone would have other features of what it depends on, and be built anew for the tests.
pub(crate) fn build_for_tests(root: &Path) -> Result<String, String> {
    cargo(root, &["build", "--workspace", "--lib", "--bins", "--tests"])
}

/// Clippy over everything, and over the command without its default features: a build that leaves crates out must hold too.
pub(crate) fn clippy(root: &Path) -> Result<String, String> {
    let strict = ["--all-targets", "--", "--deny", "warnings"];
    cargo(root, &[&["clippy", "--workspace"][..], &strict].concat())?;
    cargo(root, &[&["clippy", "--package", "carom-cli", "--no-default-features"][..], &strict].concat())
}

/// Runs a campaign of random cases, which speaks for itself.
pub(crate) fn campaign(root: &Path, words: &[String]) -> ExitCode {
    let mut command = Command::new(cargo_program());
    command.args(["run", "--release", "--quiet", "--package", "carom-campaign", "--"]).args(words);
    match command.current_dir(root).status() {
        Ok(status) if status.success() => ExitCode::SUCCESS,
        Ok(_) => ExitCode::FAILURE,
        Err(problem) => {
            eprintln!("{command:?}\n{problem}");
            ExitCode::FAILURE
        }
    }
}

/// The README's test command; the note counts the tests.
pub(crate) fn tests(root: &Path) -> Result<String, String> {
    let mut command = Command::new(cargo_program());
    command.args(["test", "--workspace"]).current_dir(root);
    said_by(command).map(|said| format!("{} tests passed", passed(&said)))
}

/// The cargo that runs this chore, so that both use one toolchain.
pub(crate) fn cargo_program() -> String {
    std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned())
}

/// True where a program is there and ends well, whatever it says.
pub(crate) fn answers(command: &mut Command) -> bool {
    command.stdout(Stdio::null()).stderr(Stdio::null()).status().is_ok_and(|status| status.success())
}

/// Runs a command to its end: all it said on both streams in order, as an error where it did not exit 0.
pub(crate) fn said_by(mut command: Command) -> Result<String, String> {
    let shown = format!("{command:?}");
    let said = (|| {
        let (mut reader, writer) = io::pipe()?;
        command.stdin(Stdio::null()).stdout(writer.try_clone()?).stderr(writer);
        let mut child = command.spawn()?;
        // The command still holds the writing end: the reader would wait for it for ever.
        drop(command);
        let mut bytes = Vec::new();
        reader.read_to_end(&mut bytes)?;
        Ok::<_, io::Error>((child.wait()?.success(), String::from_utf8_lossy(&bytes).into_owned()))
    })();
    match said {
        Ok((true, said)) => Ok(said),
        Ok((false, said)) => Err(format!("{shown}\n{said}")),
        Err(problem) => Err(format!("{shown}\n{problem}")),
    }
}

/// Adds up `test result: ok. 12 passed; …` over all test binaries.
fn passed(said: &str) -> u64 {
    said.lines()
        .filter_map(|line| line.strip_prefix("test result: ok. "))
        .filter_map(|rest| rest.split(' ').next()?.parse::<u64>().ok())
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn passed_tests_add_up_over_binaries() {
        let said = "running 2 tests\ntest result: ok. 12 passed; 0 failed\n\n\
                    test result: ok. 30 passed; 0 failed\ntest result: FAILED. 7 passed; 1 failed\n";
        assert_eq!(passed(said), 42, "12 + 30, the failed binary not counted");
    }

    #[test]
    fn a_failing_command_says_everything() {
        let error = cargo(Path::new("."), &["no-such-subcommand"]);
        let said = error.expect_err("cargo has no such subcommand");
        assert!(said.contains("no-such-subcommand"), "the command's own words are kept: {said}");
    }
}
