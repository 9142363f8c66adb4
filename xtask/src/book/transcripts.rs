//! Transcripts, figures and files of the book, made by running the program.

use super::commands::{self, Step, Transcript};
use super::{Made, figures};
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// A folder in which a reader could stand: the scenes of the book, and the project's examples in `examples/`.
pub(crate) struct Desk {
    pub(crate) program: PathBuf,
    pub(crate) folder: PathBuf,
}

impl Desk {
    /// Clears the folder and lays out the files.
    pub(crate) fn lay_out(root: &Path, program: PathBuf, folder: PathBuf) -> Result<Self, String> {
        if folder.exists() {
            fs::remove_dir_all(&folder).map_err(|problem| format!("{}: {problem}", folder.display()))?;
        }
        copy(&root.join("book/examples"), &folder)?;
        copy(&root.join("examples"), &folder.join("examples"))?;
        Ok(Self { program, folder })
    }

    /// What the program says to a command line, which may be fed from a file: its text, and whether it exited with 0.
    pub(crate) fn ask(&self, line: &str) -> Result<(String, bool), String> {
        let shown = |problem: std::io::Error| format!("{line}: {problem}");
        let (words, input) = line.split_once(" < ").map_or((line, None), |(words, file)| (words, Some(file)));
        let input = input.map(|file| fs::File::open(self.folder.join(file))).transpose().map_err(shown)?;
        let output = Command::new(&self.program)
            .args(commands::words(words))
            .current_dir(&self.folder)
            .stdin(input.map_or_else(Stdio::null, Stdio::from))
            .output()
            .map_err(shown)?;
        let said = [output.stdout, output.stderr].concat();
        let said = String::from_utf8(said).map_err(|_| format!("{line}: it does not answer with text"))?;
        Ok((without_clock(&said), output.status.success()))
    }

    fn read(&self, file: &str) -> Result<String, String> {
        fs::read_to_string(self.folder.join(file)).map_err(|problem| format!("{file}: {problem}"))
    }
}

fn copy(from: &Path, to: &Path) -> Result<(), String> {
    let shown = |problem: std::io::Error| format!("{} to {}: {problem}", from.display(), to.display());
    fs::create_dir_all(to).map_err(shown)?;
    for entry in fs::read_dir(from).map_err(shown)? {
        let path = entry.map_err(shown)?.path();
        if let Some(name) = path.file_name().filter(|_| path.is_file()) {
            fs::copy(&path, to.join(name)).map_err(shown)?;
        }
    }
    Ok(())
}

/// Runs one transcript: its text, and the drawings and files it names.
pub(crate) fn make(desk: &Desk, transcript: &Transcript) -> Result<Vec<Made>, String> {
    let mut made = vec![];
    let mut text = String::new();
    for step in &transcript.steps {
        match step {
            Step::Run { line, succeeds } => {
                let (said, success) = desk.ask(line)?;
                if success != *succeeds {
                    let what = if success { "succeeds, and should not" } else { "fails" };
                    return Err(format!("[{}] {line}: {what}\n{said}", transcript.name));
                }
                let gap = if text.is_empty() { "" } else { "\n" };
                write!(text, "{gap}$ {line}\n{said}").map_err(|problem| problem.to_string())?;
            }
            Step::Figure { name, file, label } => {
                let drawing = figures::drawing(&desk.read(file)?, label.as_deref());
                let drawing =
                    drawing.ok_or_else(|| format!("[{}] {file}: no drawing {label:?}", transcript.name))?;
                made.push(Made { path: format!("figures/{name}.svg"), text: drawing });
            }
            Step::Keep(file) => {
                made.push(Made { path: format!("files/{file}"), text: desk.read(file)? });
            }
        }
    }
    made.push(Made { path: format!("transcripts/{}.txt", transcript.name), text });
    Ok(made)
}

/// The same without how long work took, which differs from run to run.
fn without_clock(said: &str) -> String {
    let mut out = String::new();
    for line in said.lines() {
        let counts = [" drops", " feeds", " throws"].iter().any(|word| line.contains(word));
        match line.rsplit_once(", ") {
            Some((before, last)) if counts && is_duration(last) => out.push_str(before),
            _ if is_duration(line) => continue,
            _ => out.push_str(line.trim_end()),
        }
        out.push('\n');
    }
    out
}

/// `2.56 s`
fn is_duration(text: &str) -> bool {
    text.strip_suffix(" s").is_some_and(|number| number.parse::<f64>().is_ok())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn how_long_work_took_is_left_out_and_times_of_the_model_stay() {
        let said = "flat at 1.193 s\n35752 drops, seed 1, 2.56 s\n0.17 s\ntime: mean 0.5 s, 5 to 95 % 0.4 to 0.6 s; 9 parts\n";
        assert_eq!(
            without_clock(said),
            "flat at 1.193 s\n35752 drops, seed 1\ntime: mean 0.5 s, 5 to 95 % 0.4 to 0.6 s; 9 parts\n",
            "two durations are gone"
        );
    }
}
