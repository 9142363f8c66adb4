//! `carom watch`: runs a scene again at each save; as JSON, one line a run.

use crate::args::{Format, Output, WatchOptions};
use crate::failure::Failure;
use crate::printed::tell;
use crate::{files, pipeline, run, table};
use carom_scene::{RunReport, Scene};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

/// Time between two looks at the files.
const LOOK: Duration = Duration::from_millis(150);

/// What tells one save from another.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Stamp {
    modified: Option<SystemTime>,
    length: u64,
}

fn stamp(path: &Path) -> Option<Stamp> {
    let metadata = std::fs::metadata(path).ok()?;
    Some(Stamp { modified: metadata.modified().ok(), length: metadata.len() })
}

pub(crate) fn watch(options: &WatchOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    let (mut runs, mut seen) = (0, [None; 2]);
    // The drawing of the part, once a scene that names one could be read.
    let mut outline: Option<PathBuf> = None;
    loop {
        let mut now = [stamp(&options.scene), outline.as_deref().and_then(stamp)];
        if runs == 0 || now != seen {
            let read = Scene::read(&options.scene).map_err(Failure::from);
            if let Ok(scene) = &read {
                let drawn = scene.outline_file().map(|(_, path)| path);
                if drawn != outline {
                    outline = drawn;
                    now[1] = outline.as_deref().and_then(stamp);
                }
            }
            let done = read.and_then(|scene| once(&scene, options, output, runs == 0, out));
            seen = now;
            runs += 1;
            let last = options.runs.is_some_and(|most| runs >= most);
            match done {
                // A scene with problems is saved again soon: that is what watching is for.
                Err(failure @ (Failure::Input(_) | Failure::Undone(_))) if !last => {
                    tell(&failure.to_string());
                }
                other => other?,
            }
            if last {
                return Ok(());
            }
            tell(&format!("watching {}: reload the page after a save", options.scene.display()));
            tell("");
            out.flush()?;
        }
        std::thread::sleep(LOOK);
    }
}

fn once(
    scene: &Scene,
    options: &WatchOptions,
    output: &Output,
    first: bool,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let run = pipeline::run(scene)?;
    let fed = pipeline::feed(scene)?;
    let path = run::write_report(scene, &run, fed.as_ref(), None, &output.folder(scene.name()))?;
    match output.format {
        Format::Text => {
            out.write_all(table::text(scene, &run).as_bytes())?;
            writeln!(out, "\nreport {}", path.display())?;
        }
        Format::Json => {
            let report = RunReport::new(scene, &run, None);
            writeln!(out, "{}", serde_json::to_string(&report)?)?;
        }
    }
    if first && options.open { files::open(&path) } else { Ok(()) }
}
