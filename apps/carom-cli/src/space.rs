//! `carom run` of scenes in space.

use crate::args::{Format, Output, RunOptions};
use crate::failure::Failure;
use crate::printed::{folders, notes, results, tell};
use crate::table::{fixed, from_to, met, shouted, signed, stages};
use crate::{files, limits, pipeline, table};
use carom::tasks::{self, space as space_tasks};
use carom_feeder::Stage;
use carom_feeder::spatial::{Feeder, Run};
use carom_figure::{SpaceRow, milliseconds, space_contacts, space_energy_change, space_rows, space_tilt};
use carom_motion::spatial::{Impact, State, Touch};
use carom_scene::{AnyScene, Drawn, FoundLimits, RunReport, SpaceRunReport, SpaceScene};
use carom_words::{Words, part, run as run_words};
use serde::Serialize;
use std::io::Write;

/// The result of a run, in the plane or in space: the keys in their own order.
#[derive(Serialize)]
#[serde(untagged)]
enum Told {
    Plane(Box<RunReport>),
    Space(Box<SpaceRunReport>),
}

/// Runs scenes of which some are in space, each by itself.
pub(crate) fn run(
    scenes: Vec<AnyScene>,
    options: &RunOptions,
    output: &Output,
    out: &mut impl Write,
) -> Result<(), Failure> {
    if options.paper {
        let message = "--paper is for parts that move in the plane: one of these scenes has a solid part";
        return Err(Failure::Usage(message.to_owned()));
    }
    let mut reports = vec![];
    let names = folders(scenes.iter().map(AnyScene::name));
    for (scene, name) in scenes.into_iter().zip(names) {
        let folder = output.folder(&name);
        let (report, text, path) = match scene {
            AnyScene::Plane(scene) => {
                let (run, fed) = (pipeline::run(&scene)?, pipeline::feed(&scene)?);
                let found = limits::sought(&*scene, options);
                let found = found.as_ref();
                let report = Told::Plane(Box::new(tasks::run_report(&scene, &run, fed.as_ref(), found)));
                let text =
                    format!("{}{}{}", table::text(&scene, &run), notes(scene.notes()), told(&*scene, found));
                (report, text, crate::run::write_report(&scene, &run, fed.as_ref(), found, &folder)?)
            }
            AnyScene::Space(scene) => {
                let run = followed(&scene)?;
                let found = limits::sought(&*scene, options);
                let found = found.as_ref();
                let report = Told::Space(Box::new(space_tasks::run_report(&scene, &run, found)));
                let mut path = files::write_bytes(
                    &folder,
                    "motion.glb",
                    &carom_figure::space_glb(scene.feeder(), &run),
                )?;
                for (name, text) in space_tasks::run_files(&scene, &run, found)? {
                    path = files::write(&folder, name, &text)?;
                }
                (report, format!("{}{}", text(&scene, &run), told(&*scene, found)), path)
            }
        };
        match output.format {
            Format::Text => writeln!(out, "{text}\nreport {}\n", path.display())?,
            Format::Json => tell(&format!("report {}", path.display())),
        }
        reports.push(report);
        if options.open {
            files::open(&path)?;
        }
    }
    if output.format == Format::Json {
        writeln!(out, "{}", results(&reports)?)?;
    }
    Ok(())
}

/// What is told of how far each quantity may move.
fn told(scene: &impl Drawn, found: Option<&FoundLimits>) -> String {
    found.map_or(String::new(), |found| format!("\n{}\n", limits::text(scene, found).trim_end()))
}

/// The result of a run, for a line of many.
pub(crate) fn report(scene: &SpaceScene, options: &RunOptions) -> Result<SpaceRunReport, Failure> {
    let found = limits::sought(scene, options);
    Ok(space_tasks::run_report(scene, &followed(scene)?, found.as_ref()))
}

fn followed(scene: &SpaceScene) -> Result<Run, Failure> {
    scene.feeder().run().map_err(|error| Failure::Undone(format!("{}: {error}", scene.name())))
}

/// The verdict first, then stages and strikes in order of time.
fn text(scene: &SpaceScene, run: &Run) -> String {
    let feeder = scene.feeder();
    let mut parts = vec![shouted(run_words::headline_in_space(feeder, run))];
    match run.final_landing().and_then(|landing| landing.flat) {
        Some(flat) => parts.push(format!("flat at {flat:.3} s")),
        None => parts.push(format!("ended at {:.3} s", run.end_time)),
    }
    if let Some(k) = run.deciding_strike() {
        parts.push(format!("struck at {:.2} m/s", run.struck_at[k]));
        parts.extend(
            space_energy_change(&run.impacts[k]).map(|change| format!("{} % energy", signed(change, 0))),
        );
    }
    parts.extend(met(&scene.wanted(run)));
    let mut text = format!("{}\n\n{}", parts.join("   "), stages(&rows(feeder, run)));
    if run.forks > 0 {
        text.push_str(&format!(
            "\n{} of {} strikes have several consistent outcomes: the one that keeps the most contacts is followed\n",
            run.forks,
            run.impacts.len()
        ));
    }
    for approximation in scene.approximations() {
        text.push_str(&format!("\n{}\n", approximation.text));
    }
    text.push_str(&notes(scene.notes()));
    text
}

/// Stages and the strikes between them, in order of time.
fn rows(feeder: &Feeder, run: &Run) -> Vec<[String; 8]> {
    let cells = |row: SpaceRow<'_>| match row {
        SpaceRow::Stage(_, stage) => stage_cells(feeder, stage),
        SpaceRow::Strike(k, impact) => strike_cells(feeder, run, k, impact),
    };
    space_rows(run).into_iter().map(cells).collect()
}

fn stage_cells(feeder: &Feeder, stage: &Stage<State, Touch>) -> [String; 8] {
    let (start, end) = (&stage.start, &stage.end);
    let both = |of: &dyn Fn(&State) -> f64, digits| from_to(fixed(of(start), digits), fixed(of(end), digits));
    [
        stage.name.word().to_owned(),
        stage.obstacle.map_or("-".to_owned(), |obstacle| part::obstacle(feeder, obstacle)),
        format!("{:.4}", stage.start_time),
        milliseconds(stage.end_time - stage.start_time),
        both(&|state| state.velocity.norm(), 3),
        both(&|state| space_tilt(feeder, state).to_degrees(), 1),
        both(&|state| state.spin.norm(), 2),
        run_words::stage_end(feeder, &stage.ended_by),
    ]
}

fn strike_cells(feeder: &Feeder, run: &Run, k: usize, impact: &Impact) -> [String; 8] {
    let change = space_energy_change(impact)
        .map_or(String::new(), |change| format!(", {} % energy", signed(change, 0)));
    [
        "STRIKE".to_owned(),
        part::obstacle(feeder, run.struck[k]),
        format!("{:.4}", impact.time),
        String::new(),
        fixed(run.struck_at[k], 3),
        String::new(),
        from_to(fixed(impact.spin_before.norm(), 2), fixed(impact.spin_after.norm(), 2)),
        format!("{}{change}", space_contacts(impact)),
    ]
}
