//! The command as it is called beside the examples: what it says, and where it writes.

use serde_json::Value;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// What the command says, and how it ends.
pub(crate) struct Said {
    pub(crate) code: i32,
    pub(crate) out: String,
    pub(crate) err: String,
}

impl From<Output> for Said {
    fn from(output: Output) -> Self {
        Self {
            code: output.status.code().unwrap(),
            out: String::from_utf8(output.stdout).unwrap(),
            err: String::from_utf8(output.stderr).unwrap(),
        }
    }
}

pub(crate) fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples")
}

/// Where a test writes: below a folder of its file's own.
pub(crate) fn folder(test: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(env!("CARGO_CRATE_NAME")).join(test)
}

/// The same, there and empty.
pub(crate) fn empty(test: &str) -> PathBuf {
    let path = folder(test);
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).unwrap();
    path
}

/// The command beside the examples; what it writes goes to a folder.
pub(crate) fn command(words: &[&str], out: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_carom"));
    command.args(words).arg("--out").arg(out).current_dir(examples());
    command
}

/// Nothing, where whoever reads has gone.
fn only_closed(error: std::io::Error) -> std::io::Result<()> {
    if error.kind() == std::io::ErrorKind::BrokenPipe { Ok(()) } else { Err(error) }
}

/// Runs a command that reads this from stdin.
pub(crate) fn fed(command: &mut Command, input: &str) -> Said {
    let piped = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = piped.spawn().unwrap();
    let mut stdin = child.stdin.take().unwrap();
    // It answers while it reads: whoever writes everything first would wait for a pipe that is full.
    std::thread::scope(|scope| {
        // What refuses its options reads nothing, and the pipe may be closed by then.
        scope.spawn(move || stdin.write_all(input.as_bytes()).or_else(only_closed).unwrap());
        child.wait_with_output().unwrap().into()
    })
}

/// As [`fed`]: the code, and the lines it answers with as JSON.
pub(crate) fn answers(test: &str, words: &[&str], input: &str) -> (i32, Vec<Value>) {
    let said = fed(&mut command(words, &folder(test)), input);
    (said.code, said.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect())
}

/// Runs the command beside the examples, on so many threads; its folder is the test's own, and new.
pub(crate) fn carom_on(threads: &str, test: &str, words: &[&str]) -> Said {
    let folder = folder(test);
    let _ = fs::remove_dir_all(&folder);
    let said = command(words, &folder).env("RAYON_NUM_THREADS", threads).output().unwrap();
    let Said { code, out, err } = said.into();
    // Snapshots are the same wherever the folder is.
    let [out, err] = [out, err].map(|said| said.replace(folder.to_str().unwrap(), "OUT"));
    Said { code, out, err }
}

/// What it prints as JSON.
pub(crate) fn result_on(threads: &str, test: &str, words: &[&str]) -> Value {
    let said = carom_on(threads, test, &[words, &["--format", "json"]].concat());
    assert_eq!(said.code, 0, "{words:?}: {}", said.err);
    serde_json::from_str(&said.out).unwrap()
}

/// As a snapshot keeps it.
pub(crate) fn shown(said: &Said) -> String {
    format!("exit {}\n--- stdout\n{}--- stderr\n{}", said.code, said.out, said.err)
}

/// Tests that hold what the file's own `carom` says to a snapshot.
macro_rules! says {
    ($($name:ident: $words:expr $(, $input:expr)?;)*) => { $(
        #[test]
        fn $name() {
            insta::assert_snapshot!(shown(&carom(stringify!($name), &$words $(, $input)?)));
        }
    )* };
}
