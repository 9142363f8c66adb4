//! `carom run`: runs scenes, prints verdicts, writes reports.

use crate::args::{Format, Output, RunOptions, is_stdin};
use crate::failure::Failure;
use crate::lines::answer_lines;
use crate::printed::{folders, notes, results, tell};
use crate::side_by_side::{self, Done};
use crate::space;
use crate::{feed, files, limits, paper, pipeline, table};
use carom::tasks;
use carom_feeder::{FeedRun, Run};
use carom_scene::{AnyScene, FoundLimits, RunReport, Scene, toml_of_json};
use std::io::Write;
use std::path::{Path, PathBuf};

pub(crate) fn run(options: &RunOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    if options.scenes.iter().any(|path| is_stdin(path)) {
        return lines(options, out);
    }
    let any = read(&options.scenes)?;
    if any.iter().any(|scene| matches!(scene, AnyScene::Space(_))) {
        return space::run(any, options, output, out);
    }
    let scenes: Vec<Scene> = any.into_iter().filter_map(AnyScene::plane).collect();
    if options.paper
        && let Some(scene) = scenes.iter().find(|scene| scene.paper_line().is_none())
    {
        return Err(Failure::Usage(format!(
            "--paper is for scenes of two plates with the second placed by its line; {} is not one",
            scene.name()
        )));
    }
    let (mut done, mut fed) = (vec![], vec![]);
    for scene in scenes {
        let run = pipeline::run(&scene)?;
        fed.push(pipeline::feed(&scene)?);
        done.push((scene, run));
    }
    let limits: Vec<Option<FoundLimits>> =
        done.iter().map(|(scene, _)| limits::sought(scene, options)).collect();
    match output.format {
        Format::Text => print_text(&done, &fed, &limits, options.paper, out)?,
        Format::Json => print_json(&done, &fed, &limits, out)?,
    }
    if options.paper {
        let path = files::write(&output.folder(""), "table-1.md", &paper::markdown(&done))?;
        tell(&format!("table {}", path.display()));
    }
    let names = folders(done.iter().map(|(scene, _)| scene.name()));
    for ((((scene, run), fed), limits), name) in done.iter().zip(&fed).zip(&limits).zip(names) {
        let path = write_report(scene, run, fed.as_ref(), limits.as_ref(), &output.folder(&name))?;
        match output.format {
            Format::Text if fed.is_some() => {
                let all = path.with_file_name("feed.html");
                writeln!(out, "report {}\nfeed   {}", path.display(), all.display())?;
            }
            Format::Text => writeln!(out, "report {}", path.display())?,
            // Stdout is the result's alone.
            Format::Json => tell(&format!("report {}", path.display())),
        }
        if options.open {
            files::open(&path)?;
        }
    }
    Ok(())
}

/// One scene a line in, one result a line out; no reports are written.
fn lines(options: &RunOptions, out: &mut impl Write) -> Result<(), Failure> {
    if options.scenes.len() > 1 || options.paper || options.open {
        let message = "- takes scenes from stdin: no other scene, no --paper and no --open go with it";
        return Err(Failure::Usage(message.to_owned()));
    }
    answer_lines(&mut std::io::stdin().lock(), out, |name, line| {
        let scene = match AnyScene::parse(name, &toml_of_json(name, line)?)? {
            AnyScene::Plane(scene) => *scene,
            AnyScene::Space(scene) => return Ok(serde_json::to_string(&space::report(&scene, options)?)?),
        };
        let (run, fed) = (pipeline::run(&scene)?, pipeline::feed(&scene)?);
        let found = limits::sought(&scene, options);
        Ok(serde_json::to_string(&tasks::run_report(&scene, &run, fed.as_ref(), found.as_ref()))?)
    })
}

/// Reads every scene, in the plane or in space, or says what is wrong with each.
pub(crate) fn read(paths: &[PathBuf]) -> Result<Vec<AnyScene>, Failure> {
    let (mut scenes, mut problems) = (vec![], vec![]);
    for path in paths {
        match AnyScene::read(path) {
            Ok(scene) => scenes.push(scene),
            Err(found) => problems.push(found),
        }
    }
    if problems.is_empty() { Ok(scenes) } else { Err(Failure::Input(problems)) }
}

fn print_text(
    done: &[Done],
    fed: &[Option<FeedRun>],
    limits: &[Option<FoundLimits>],
    paper: bool,
    out: &mut impl Write,
) -> Result<(), Failure> {
    // The verdict comes first, whatever else was asked for; several scenes are compared, not told one after the other.
    match done {
        [(scene, run)] => out.write_all(table::text(scene, run).as_bytes())?,
        several => out.write_all(side_by_side::text(several).as_bytes())?,
    }
    for (scene, _) in done {
        out.write_all(notes(scene.notes()).as_bytes())?;
    }
    for ((scene, _), fed) in done.iter().zip(fed) {
        if let (Some(feed), Some(fed)) = (scene.feed(), fed) {
            writeln!(out, "\n{}", feed::text(scene, feed, fed).trim_end())?;
        }
    }
    for ((scene, run), limits) in done.iter().zip(limits) {
        let title = if done.len() > 1 { format!("{}: ", scene.name()) } else { String::new() };
        if paper {
            writeln!(out, "\n{title}{}", paper::text(scene, run))?;
        }
        if let Some(limits) = limits {
            writeln!(out, "\n{title}{}", limits::text(scene, limits).trim_end())?;
        }
    }
    writeln!(out)?;
    Ok(())
}

fn print_json(
    done: &[Done],
    fed: &[Option<FeedRun>],
    limits: &[Option<FoundLimits>],
    out: &mut impl Write,
) -> Result<(), Failure> {
    let reports: Vec<RunReport> = done
        .iter()
        .zip(fed)
        .zip(limits)
        .map(|(((scene, run), fed), limits)| tasks::run_report(scene, run, fed.as_ref(), limits.as_ref()))
        .collect();
    writeln!(out, "{}", results(&reports)?)?;
    Ok(())
}

/// Writes the report and the result of a run; returns the path of the report.
pub(crate) fn write_report(
    scene: &Scene,
    run: &Run,
    fed: Option<&FeedRun>,
    limits: Option<&FoundLimits>,
    folder: &Path,
) -> Result<PathBuf, Failure> {
    let mut report = folder.to_path_buf();
    for (name, text) in tasks::run_files(scene, run, fed, limits)? {
        report = files::write(folder, name, &text)?;
    }
    Ok(report)
}
