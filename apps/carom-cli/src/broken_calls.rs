//! Every command that writes, with each of its calls to the system failing in turn, alone and with all that follow: it is said, nothing is left
//! half-written, what was there before is there still, and the same command does afterwards what it would have done.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod commands;
#[path = "../tests/tree/mod.rs"]
mod tree;

use crate::args::Arguments;
use crate::carry_out;
use crate::failure::Failure;
use crate::faults::{CAUSE, Fault, OUTPUT, Printed, during};
use carom_scene::columns::is_sealed;
use carom_sweep::disk::Call;
use clap::Parser;
use std::collections::BTreeMap;
use std::io::{BufWriter, Error, Write};
use std::path::{Path, PathBuf};

type Files = BTreeMap<PathBuf, Vec<u8>>;

fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples")
}

/// A folder of this test's own, empty.
fn empty(test: &str) -> PathBuf {
    let path = std::env::temp_dir().join(format!("carom-broken-{}", std::process::id())).join(test);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).unwrap();
    path
}

/// Runs a command as `main` does; words that are names of examples are found there.
fn carom(words: &[&str], out: &Path) -> Result<(), Failure> {
    let found = words.iter().map(|word| {
        let example = examples().join(word);
        if example.is_file() { example.display().to_string() } else { (*word).to_owned() }
    });
    let out = ["--out".to_owned(), out.display().to_string()];
    let arguments = Arguments::try_parse_from(["carom".to_owned()].into_iter().chain(found).chain(out));
    let arguments = arguments.unwrap_or_else(|error| panic!("{words:?}: {error}"));
    printed(|out| carry_out(arguments.command, &arguments.output, out))
}

/// Does something with an output that may fail, as `main` does.
pub(crate) fn printed(
    work: impl FnOnce(&mut BufWriter<Printed>) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let mut out = BufWriter::new(Printed::default());
    let done = work(&mut out).and_then(|()| Ok(out.flush()?));
    // What it had still to say after a failure is lost.
    let _ = out.into_parts();
    done
}

/// Every file below a folder, without what a clock says.
fn files(folder: &Path) -> Files {
    tree::files(folder, timeless)
}

fn timeless(path: &Path) -> Vec<u8> {
    let bytes = std::fs::read(path).unwrap();
    if path.extension().is_none_or(|ending| ending != "json") {
        return bytes;
    }
    let lines = bytes.split_inclusive(|byte| *byte == b'\n');
    lines.filter(|line| !line.trim_ascii_start().starts_with(b"\"seconds\"")).flatten().copied().collect()
}

fn ends(path: &Path, ending: &str) -> bool {
    path.extension().is_some_and(|found| found == ending)
}

/// Work that writes into a folder.
type Work<'t> = &'t dyn Fn(&Path) -> Result<(), Failure>;

/// A command, or a part of one, and what was in its folder before.
struct Trial<'t> {
    name: &'t str,
    work: Work<'t>,
    out: PathBuf,
    /// What made what was there before.
    before: Work<'t>,
    earlier: Files,
    wanted: Files,
    /// Replacing what was there before is what it is told to.
    replaces: bool,
    /// It replaces nothing.
    adds: bool,
}

impl<'t> Trial<'t> {
    fn new(name: &'t str, before: Work<'t>, work: Work<'t>) -> Self {
        let out = empty(name);
        let (earlier, wanted) = (Files::new(), Files::new());
        let mut trial = Self { name, work, out, before, earlier, wanted, replaces: false, adds: false };
        trial.earlier = trial.begin();
        work(&trial.out).unwrap_or_else(|failure| panic!("{name}: {failure}"));
        trial.wanted = files(&trial.out);
        assert!(!trial.wanted.is_empty(), "{name} writes files");
        trial
    }

    /// Brings the folder to where it is before the command.
    fn begin(&self) -> Files {
        std::fs::remove_dir_all(&self.out).unwrap();
        std::fs::create_dir_all(&self.out).unwrap();
        if self.earlier.is_empty() {
            (self.before)(&self.out).unwrap();
        }
        for (path, bytes) in &self.earlier {
            let path = self.out.join(path);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, bytes).unwrap();
        }
        files(&self.out)
    }

    /// The calls that an undisturbed command makes.
    fn calls(&self) -> Vec<(Call, PathBuf)> {
        self.begin();
        let (done, calls) = during(Fault::Never, || (self.work)(&self.out));
        done.unwrap_or_else(|failure| panic!("{}: {failure}", self.name));
        calls
    }

    /// One call fails.
    fn fails(&self, fault: Fault, (call, path): &(Call, PathBuf)) {
        self.begin();
        let (done, _) = during(fault, || (self.work)(&self.out));
        let place = format!("{} with {fault:?}: {call:?} of {}", self.name, path.display());
        let left = files(&self.out);
        // What is left of an earlier write is in nobody's way, and a part that cannot be read is written anew.
        let harmless = matches!(call, Call::Remove | Call::Open | Call::Read);
        match done {
            Ok(()) => {
                assert!(harmless, "{place}: nobody noticed");
                assert!(kept(&left).eq(kept(&self.wanted)), "{place}: it says that all is well");
            }
            // Of calls that fail after it one is told.
            Err(failure) if harmless && matches!(fault, Fault::From(_)) => {
                let input = *call != Call::Remove && failure.code() == 2;
                assert!(input || failure.code() == 1, "{place}: {failure}");
            }
            Err(failure) => says(&failure, &place, (*call, path)),
        }
        for (path, bytes) in &left {
            if ends(path, "part") {
                let lasting = matches!(fault, Fault::From(_)) || *call == Call::Remove;
                assert!(lasting, "{place}: {} is left", path.display());
            } else if !ends(path, "lock") {
                let whole = [&self.wanted, &self.earlier].iter().any(|of| of.get(path) == Some(bytes));
                assert!(
                    whole || is_step(path) && is_sealed(bytes),
                    "{place}: {} is not whole",
                    path.display()
                );
            }
        }
        let all_new = self.wanted.iter().all(|(path, bytes)| left.get(path) == Some(bytes));
        let lost = self.earlier.keys().find(|path| !left.contains_key(*path) && !is_step(path));
        assert!(self.replaces || all_new || lost.is_none(), "{place}: {lost:?} was there before");
        let retried = (self.work)(&self.out);
        if self.adds && all_new {
            let text = retried.unwrap_err().to_string();
            assert!(text.contains("is there already"), "{place}, and then not: {text}");
            return;
        }
        retried.unwrap_or_else(|failure| panic!("{place}, and then not: {failure}"));
        let again = files(&self.out);
        let differs = again.iter().find(|(path, bytes)| self.wanted.get(*path) != Some(bytes));
        let differs = differs.map(|(path, _)| path);
        assert!(differs.is_none(), "{place}, and then not: {differs:?}");
        assert!(
            again.len() == self.wanted.len(),
            "{place}, and then not: not all of {:?}",
            self.wanted.keys()
        );
    }
}

/// True for a finished step of a sweep: it stays until its part is written, and no longer.
fn is_step(path: &Path) -> bool {
    path.iter().any(|name| name == "unfinished")
}

/// Files but locks and what is left of writes.
fn kept(files: &Files) -> impl Iterator<Item = (&PathBuf, &Vec<u8>)> {
    files.iter().filter(|(path, _)| !ends(path, "lock") && !ends(path, "part"))
}

/// A failure names what failed, and why.
fn says(failure: &Failure, place: &str, (call, path): (Call, &Path)) {
    let text = failure.to_string();
    // An input that cannot be read is bad input.
    let input = matches!(call, Call::Open | Call::Read);
    assert!(failure.code() == 1 || input && failure.code() == 2, "{place}: {failure:?}");
    let name = path.file_name().unwrap().to_string_lossy().into_owned();
    let named = if path == Path::new(OUTPUT) { OUTPUT.to_owned() } else { name };
    assert!(text.contains(&named), "{place} does not name {named}: {text}");
    assert!(text.contains(&Error::from(CAUSE).to_string()), "{place} does not say why: {text}");
}

/// Lets every call of a command fail in its turn, after these commands; returns how many there are. Where it takes long, calls fail alone and with all
/// that follow by turns.
fn every_call_fails(name: &str, before: &[&[&str]], words: &[&str], long: bool) -> usize {
    let first = |out: &Path| before.iter().try_for_each(|words| carom(words, out));
    let work = |out: &Path| carom(words, out);
    let mut trial = Trial::new(name, &first, &work);
    (trial.replaces, trial.adds) = (words.contains(&"--force"), words[0] == "new");
    every_call_of(&trial, long)
}

/// The same of a part of a command, after other work.
pub(crate) fn every_call_of_part_fails(name: &str, before: Work<'_>, work: Work<'_>) -> usize {
    every_call_of(&Trial::new(name, before, work), false)
}

fn every_call_of(trial: &Trial<'_>, long: bool) -> usize {
    let calls = trial.calls();
    for (k, call) in calls.iter().enumerate() {
        let faults = [Fault::At(k), Fault::From(k)];
        let turn = if long { &faults[k % 2..][..1] } else { &faults[..] };
        turn.iter().for_each(|fault| trial.fails(*fault, call));
    }
    let _ = std::fs::remove_dir_all(&trial.out);
    calls.len()
}
