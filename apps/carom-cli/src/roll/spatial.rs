//! `carom roll pyramid|stool|body`: follows a body in space through its strikes.

use super::poses;
use super::spatial_text::text;
use super::throws;
use crate::args::{Format, Output, RollOptions};
use crate::failure::Failure;
use crate::files;
use crate::printed::tell;
use carom::tasks::solid::SolidStudy;
use carom_scene::{SpatialRollKind, SpatialRollProblem};
use carom_words::Words;
use std::io::Write;
use std::path::Path;

pub(super) fn roll(
    kind: SpatialRollKind,
    options: &RollOptions,
    every: Option<f64>,
    output: &Output,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let (name, source) = match &options.file {
        Some(path) if is_surface(path) => (path.display().to_string(), naming(path)),
        Some(path) => (path.display().to_string(), files::read_input(path)?),
        None => (format!("roll {}", kind.word()), String::new()),
    };
    let problem = SpatialRollProblem::parse(kind, &name, &source, &options.set)
        .map_err(|found| Failure::Input(found.0))?;
    if let Some(throws) = options.throws {
        return throws::study(&name, &problem, throws, options, output, out);
    }
    let run = poses::spatial(&name, &problem, every)?;
    let study = SolidStudy::of_run(problem, run);
    let SolidStudy { problem, run, report } = &study;
    let json = format!("{}\n", serde_json::to_string_pretty(report)?);
    match output.format {
        Format::Text => out.write_all(text(problem, report).as_bytes())?,
        Format::Json => out.write_all(json.as_bytes())?,
    }
    let folder = output.folder(kind.word());
    let file = files::write(&folder, "roll.json", &json)?;
    let path = files::write(&folder, "report.html", &study.page(&name))?;
    match output.format {
        Format::Text => {
            poses::tell_where(run.poses.as_ref().map(Vec::len), &file, out)?;
            writeln!(out, "report {}", path.display())?;
        }
        // Stdout is the result's alone.
        Format::Json => tell(&format!("report {}", path.display())),
    }
    if options.open { files::open(&path) } else { Ok(()) }
}

/// The result of one roll file, in one line of JSON.
pub(super) fn answer(
    kind: SpatialRollKind,
    name: &str,
    source: &str,
    options: &RollOptions,
    every: Option<f64>,
) -> Result<String, Failure> {
    let problem = SpatialRollProblem::parse(kind, name, source, &options.set)
        .map_err(|found| Failure::Input(found.0))?;
    let run = poses::spatial(name, &problem, every)?;
    Ok(serde_json::to_string(&SolidStudy::of_run(problem, run).report)?)
}

/// True of a file that draws a surface, and says nothing else.
fn is_surface(path: &Path) -> bool {
    path.extension().is_some_and(|end| end.eq_ignore_ascii_case("stl"))
}

/// The roll file that would name it, beside it.
fn naming(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    format!("file = {}\n", serde_json::Value::from(name))
}
