//! Every shipped example through the command `carom`.

use crate::{metadata, steps, tree};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Builds the command as the README does and runs every `examples/*.toml`.
pub(crate) fn check(root: &Path) -> Result<String, String> {
    let files = tree::files(root)?;
    let examples: Vec<&str> = files.iter().map(String::as_str).filter(|path| is_example(path)).collect();
    if examples.is_empty() {
        return Ok("skipped: there is no examples/*.toml".to_owned());
    }
    steps::cargo(root, &["build", "--release", "--package", "carom-cli"])?;
    let target = metadata::workspace(root)?.target;
    let program = program(&target, "release");
    let failures: Vec<String> =
        examples.iter().filter_map(|path| run(root, &program, &target, path).err()).collect();
    if failures.is_empty() { Ok(format!("{} examples", examples.len())) } else { Err(failures.join("\n\n")) }
}

/// The command as a profile builds it.
pub(crate) fn program(target: &Path, profile: &str) -> PathBuf {
    target.join(profile).join(format!("carom{}", std::env::consts::EXE_SUFFIX))
}

pub(crate) fn is_example(path: &str) -> bool {
    path.strip_prefix("examples/").is_some_and(|name| name.ends_with(".toml") && !name.contains('/'))
}

/// The command an example is written for: `roll_KIND…` rolls, `contact_…` is under forces, bodies or an operator are struck, a feeder is run.
pub(crate) fn verbs<'n>(name: &'n str, text: &str) -> Vec<&'n str> {
    if let Some(kind) = name.strip_prefix("roll_").and_then(|rest| rest.split('_').next()) {
        return vec!["roll", kind];
    }
    if name.starts_with("contact_") {
        return vec!["contact"];
    }
    let struck = text.lines().map(str::trim).any(|line| ["[body]", "[[body]]", "[operator]"].contains(&line));
    vec![if struck { "impact" } else { "run" }]
}

/// One example: it must exit 0 and answer with JSON that names an outcome, or how it ends.
fn run(root: &Path, program: &Path, target: &Path, path: &str) -> Result<(), String> {
    let text = tree::text(root, path)?.ok_or_else(|| format!("{path}: not text"))?;
    let name = Path::new(path).file_stem().unwrap_or_default().to_string_lossy();
    let mut command = Command::new(program);
    command.args(verbs(&name, &text)).args([path, "--format", "json", "--out"]);
    command.arg(target.join("examples-out").join(PathBuf::from(&*name))).current_dir(root);
    let said = answer(&mut command)?;
    match outcome(&said) {
        Some(_) => Ok(()),
        None => Err(format!("{command:?}: the answer has neither an \"outcome\" nor an \"end\"\n{said:#}")),
    }
}

/// Runs a command to its end: the JSON it prints; all that it says where it does not exit 0, or prints none.
pub(crate) fn answer(command: &mut Command) -> Result<Value, String> {
    let output = command.output().map_err(|problem| format!("{command:?}\n{problem}"))?;
    let (said, errors) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    if !output.status.success() {
        return Err(format!("{command:?}: {}\n{errors}{said}", output.status));
    }
    serde_json::from_slice(&output.stdout)
        .map_err(|problem| format!("{command:?}: the answer is not JSON: {problem}\n{errors}{said}"))
}

fn outcome(json: &Value) -> Option<String> {
    json["outcome"].as_str().or(json["end"]["state"].as_str()).map(str::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn examples_stand_directly_in_their_folder() {
        assert!(is_example("examples/box.toml"), "an example");
        for path in ["examples/parts/box.toml", "examples/README.md", "crates/carom/examples/box.toml"] {
            assert!(!is_example(path), "{path} is none");
        }
    }

    #[test]
    fn the_tables_of_a_file_tell_its_command() {
        assert_eq!(
            verbs("bar", "law = \"poisson\"\n[body]\nmass = 1\n"),
            ["impact"],
            "a free body is struck"
        );
        assert_eq!(verbs("bar", "  [operator]"), ["impact"], "an operator too");
        assert_eq!(verbs("row", "[[body]]\nname = \"a\"\n"), ["impact"], "several bodies too");
        assert_eq!(verbs("rod", "[part]\nshape = \"rod\" # [body]\n"), ["run"], "a feeder is run");
        assert_eq!(verbs("roll_prism_slope", "sides = 6\n"), ["roll", "prism"], "a prism rolls");
    }

    #[test]
    fn a_command_that_prints_no_json_is_quoted() {
        let cargo = |word: &str| answer(Command::new(steps::cargo_program()).arg(word)).unwrap_err();
        let printed = cargo("--version");
        assert!(printed.contains("not JSON") && printed.contains("\ncargo "), "what it printed: {printed}");
        let failed = cargo("no-such-subcommand");
        assert!(failed.contains("no such command"), "why it failed: {failed}");
    }

    #[test]
    fn an_answer_names_its_outcome() {
        let outcome = |said: &str| outcome(&serde_json::from_str(said).ok()?);
        assert_eq!(outcome("{\"outcome\": \"landed\"}").as_deref(), Some("landed"), "named");
        assert_eq!(outcome("{\"end\": {\"state\": \"free\"}}").as_deref(), Some("free"), "the end of a roll");
        assert!(outcome("{\"outcome\": NaN}").is_none(), "NaN is no JSON");
        assert!(outcome("[]").is_none(), "no outcome");
    }
}
