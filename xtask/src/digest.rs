//! One digest over a fixed set of runs: the same in debug and release builds and on any number of threads.

use crate::{examples, metadata, steps, tree, wasm};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// Numbers of threads of the release build that are compared, and that of the debug build.
const THREADS: [u32; 2] = [1, 8];
const THREADS_OF_DEBUG: u32 = 2;

/// Studies, which share their work among threads; small ones, for the debug build's sake.
const STUDIES: [&str; 8] = [
    "regions pyramid",
    "regions rod",
    "map examples/case_1.toml --x plate.upper.slope=10..17deg:12 --y plate.lower.line.normal=190..400mm:12",
    "map examples/zigzag.toml --x contact.friction=0.1..0.2:6 --y contact.restitution=0..0.6:6",
    "yield examples/designer.toml --samples 2048",
    "yield bench/studies/yields/near_boundary.toml --samples 2048 --seed 7",
    "design examples/design_turn_once.toml --scan 32 --samples 512",
    "roll body examples/roll_body.toml --throws 64 --seed 3",
];

/// What a run is told apart by.
enum Setting {
    /// A build of the command, on so many threads.
    Native { profile: &'static str, threads: u32 },
    /// The command as WebAssembly.
    Wasm(PathBuf),
}

impl Setting {
    fn name(&self) -> String {
        match self {
            Self::Native { profile, threads } => format!("{profile}, {threads} threads"),
            Self::Wasm(_) => "WebAssembly".to_owned(),
        }
    }

    /// Starts the command.
    fn command(&self, target: &Path, named: &Path) -> Command {
        match self {
            Self::Native { profile, threads } => {
                let mut command = Command::new(examples::program(target, profile));
                command.env("RAYON_NUM_THREADS", threads.to_string());
                command
            }
            Self::Wasm(module) => {
                let mut command = Command::new("node");
                command.args(["--no-warnings", "xtask/wasi.mjs"]).arg(module).arg(named);
                command
            }
        }
    }
}

/// Runs every example and every study in each setting and compares what they say and write.
pub(crate) fn check(root: &Path) -> Result<String, String> {
    steps::cargo(root, &["build", "--release", "--package", "carom-cli"])?;
    steps::build_for_tests(root)?;
    let release = THREADS.map(|threads| Setting::Native { profile: "release", threads });
    let debug = Setting::Native { profile: "debug", threads: THREADS_OF_DEBUG };
    let settings: Vec<Setting> = release.into_iter().chain([debug]).collect();
    same(root, &settings).map(|whole| format!("{whole}, 1 and 8 threads in release, 2 in debug"))
}

/// The same, by the command as WebAssembly.
pub(crate) fn check_wasm(root: &Path) -> Result<String, String> {
    steps::cargo(root, &["build", "--release", "--package", "carom-cli"])?;
    let settings = [Setting::Native { profile: "release", threads: 2 }, Setting::Wasm(wasm::command(root)?)];
    same(root, &settings).map(|whole| format!("{whole}, release and WebAssembly"))
}

/// The digest of all runs, which must be the same in all settings.
fn same(root: &Path, settings: &[Setting]) -> Result<String, String> {
    let tasks = tasks(root)?;
    let target = metadata::workspace(root)?.target;
    let mut whole = Digest::default();
    let mut differing = vec![];
    let compared = side_by_side(tasks.len(), |k| compare(root, &target, k, &tasks[k], settings));
    for (task, found) in tasks.iter().zip(compared) {
        let (digest, differs) = found?;
        whole.take(&digest.to_le_bytes());
        differing.extend(differs.iter().map(|setting| format!("{task}: {setting}")));
    }
    if differing.is_empty() {
        Ok(format!("{:016x} over {} runs", whole.0, tasks.len()))
    } else {
        Err(differing.join("\n"))
    }
}

/// `work(0)`, …, `work(count - 1)`, two at a time: a run on one thread leaves a core to another.
fn side_by_side<T: Send>(count: usize, work: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let next = AtomicUsize::new(0);
    let worker = || {
        std::iter::from_fn(|| Some(next.fetch_add(1, Relaxed)).filter(|&k| k < count))
            .map(|k| (k, work(k)))
            .collect::<Vec<_>>()
    };
    let mut done = std::thread::scope(|scope| {
        let other = scope.spawn(worker);
        let mut done = worker();
        done.extend(other.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)));
        done
    });
    done.sort_by_key(|&(k, _)| k);
    done.into_iter().map(|(_, result)| result).collect()
}

/// One task in every setting: its digest in the first, and which others differ.
fn compare(
    root: &Path,
    target: &Path,
    number: usize,
    task: &str,
    settings: &[Setting],
) -> Result<(u64, Vec<String>), String> {
    let run = |setting: &Setting| digest(root, target, number, setting, task);
    let first = run(&settings[0])?;
    let mut differing = vec![];
    for setting in &settings[1..] {
        if run(setting)? != first {
            differing.push(format!("{} and {} differ", settings[0].name(), setting.name()));
        }
    }
    Ok((first, differing))
}

/// The command lines: every example, then the studies.
fn tasks(root: &Path) -> Result<Vec<String>, String> {
    let mut tasks = vec![];
    for path in tree::files(root)?.iter().filter(|path| examples::is_example(path)) {
        let text = tree::text(root, path)?.ok_or_else(|| format!("{path}: not text"))?;
        let name = Path::new(path).file_stem().unwrap_or_default().to_string_lossy();
        tasks.push(format!("{} {path}", examples::verbs(&name, &text).join(" ")));
    }
    tasks.extend(STUDIES.map(str::to_owned));
    Ok(tasks)
}

/// The digest of what one command says and of every file it writes.
fn digest(root: &Path, target: &Path, number: usize, setting: &Setting, task: &str) -> Result<u64, String> {
    // A page names the files beside it: below the root by a name that is the same wherever the root is.
    let named = target.strip_prefix(root).unwrap_or(target).join(format!("digest-out/{number}"));
    let out = root.join(&named);
    if out.exists() {
        std::fs::remove_dir_all(&out).map_err(|problem| format!("{}: {problem}", out.display()))?;
    }
    std::fs::create_dir_all(&out).map_err(|problem| format!("{}: {problem}", out.display()))?;
    let mut command = setting.command(target, &named);
    command.args(task.split(' ')).args(["--format", "json", "--out"]).arg(&named).current_dir(root);
    let mut digest = Digest::default();
    digest.take(timeless(examples::answer(&mut command)?).to_string().as_bytes());
    for file in written(&out)? {
        let bytes = std::fs::read(&file).map_err(|problem| format!("{}: {problem}", file.display()))?;
        digest.take(file.strip_prefix(&out).unwrap_or(&file).to_string_lossy().as_bytes());
        match serde_json::from_slice(&bytes) {
            Ok(json) => digest.take(timeless(json).to_string().as_bytes()),
            Err(_) => digest.take(&bytes),
        }
    }
    Ok(digest.0)
}

/// A result without how long it took and on how many threads.
fn timeless(mut result: Value) -> Value {
    if let Some(fields) = result.as_object_mut() {
        fields.remove("run");
    }
    result
}

/// Every file below a folder, in order; none where a command wrote none.
fn written(folder: &Path) -> Result<Vec<PathBuf>, String> {
    if !folder.exists() {
        return Ok(vec![]);
    }
    let (mut files, mut folders) = (vec![], vec![folder.to_path_buf()]);
    while let Some(folder) = folders.pop() {
        let entries =
            std::fs::read_dir(&folder).map_err(|problem| format!("{}: {problem}", folder.display()))?;
        for entry in entries {
            let path = entry.map_err(|problem| format!("{}: {problem}", folder.display()))?.path();
            if path.is_dir() { folders.push(path) } else { files.push(path) }
        }
    }
    files.sort();
    Ok(files)
}

/// FNV-1a.
struct Digest(u64);

impl Default for Digest {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Digest {
    fn take(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(0x100_0000_01b3);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_digest_is_the_published_one() {
        let mut digest = Digest::default();
        digest.take(b"foobar");
        assert_eq!(digest.0, 0x8594_4171_f739_67e8, "Fowler, Noll, Vo: test vectors of FNV-1a");
    }

    #[test]
    fn work_side_by_side_keeps_its_order() {
        assert_eq!(side_by_side(100, |k| 2 * k), (0..100).map(|k| 2 * k).collect::<Vec<_>>());
        assert!(side_by_side(0, |k| k).is_empty());
    }

    #[test]
    fn how_long_it_took_does_not_count() {
        let result = serde_json::json!({"outcome": "landed", "run": {"seconds": 1.0}});
        assert_eq!(timeless(result).to_string(), "{\"outcome\":\"landed\"}");
    }
}
