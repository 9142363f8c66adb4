//! `carom watch`: runs a scene again at each save; as JSON, one line a run.

use crate::args::{Format, Output, WatchOptions};
use crate::failure::Failure;
use crate::printed::tell;
use crate::{files, pipeline, run, table};
use carom_scene::{RunReport, Scene};
use std::io::Write;
use std::path::Path;
use std::time::{Duration, SystemTime};

/// Time between two looks at the file.
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
    let (mut runs, mut seen) = (0, None);
    loop {
        let now = stamp(&options.scene);
        if runs == 0 || now != seen {
            seen = now;
            let done = once(options, output, runs == 0, out);
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
            tell(&format!("watching {}", options.scene.display()));
            tell("");
            out.flush()?;
        }
        std::thread::sleep(LOOK);
    }
}

fn once(options: &WatchOptions, output: &Output, first: bool, out: &mut impl Write) -> Result<(), Failure> {
    let scene = Scene::read(&options.scene)?;
    let run = pipeline::run(&scene)?;
    let fed = pipeline::feed(&scene)?;
    let path = run::write_report(&scene, &run, fed.as_ref(), None, &output.folder(scene.name()))?;
    match output.format {
        Format::Text => {
            out.write_all(table::text(&scene, &run).as_bytes())?;
            writeln!(out, "\nreport {}", path.display())?;
        }
        Format::Json => {
            let report = RunReport::new(&scene, &run, None);
            writeln!(out, "{}", serde_json::to_string(&report)?)?;
        }
    }
    if first && options.open { files::open(&path) } else { Ok(()) }
}
