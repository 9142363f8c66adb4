//! `carom sweep`: any number of designs, streamed to Parquet; stopped at any moment it goes on where it was.

mod designs;
mod folder;
mod list_file;
mod lock;
mod report;
mod table;

use crate::args::{Format, Output, SweepOptions};
use crate::failure::Failure;
use crate::progress::Progress;
use carom::tasks::axes::{Asker, Complaints, plate};
use carom_scene::columns::{ColumnsError, HAS_PARQUET};
use carom_scene::{Problems, Scene, Variants};
use carom_study::sweep;
use designs::Designs;
use folder::Folder;
use std::io::Write;
use std::ops::Range;

/// Designs of one part file, of a group of rows in it, and of a step: what is worked through at a time, and lost at most. Each divides the one before.
#[cfg(not(test))]
const PART: u64 = 1_000_000;
#[cfg(not(test))]
const GROUP: u64 = 100_000;
#[cfg(not(test))]
const STEP: u64 = 10_000;
/// Few, so that a test has several part files soon.
#[cfg(test)]
const PART: u64 = 8;
#[cfg(test)]
const GROUP: u64 = 8;
#[cfg(test)]
const STEP: u64 = 4;

/// A sweep and what it is of.
struct Sweep<'s> {
    scene: &'s Scene,
    plate: usize,
    designs: Designs,
    /// Which of how many shards, from 0.
    shard: (u64, u64),
}

impl Sweep<'_> {
    /// How many part files there are.
    fn parts(&self) -> u64 {
        self.designs.len().div_ceil(PART)
    }

    /// How many steps there are.
    fn steps(&self) -> u64 {
        self.designs.len().div_ceil(STEP)
    }

    /// The steps of this shard.
    fn own(&self) -> impl Iterator<Item = u64> + use<> {
        let (shard, of) = self.shard;
        (0..self.steps()).filter(move |step| step % of == shard)
    }

    /// Designs of a part file.
    fn of_part(&self, part: u64) -> Range<u64> {
        part * PART..((part + 1) * PART).min(self.designs.len())
    }

    /// Designs of a step.
    fn of_step(&self, step: u64) -> Range<u64> {
        step * STEP..((step + 1) * STEP).min(self.designs.len())
    }

    /// The steps of a part.
    fn steps_of(&self, part: u64) -> Range<u64> {
        part * (PART / STEP)..((part + 1) * (PART / STEP)).min(self.steps())
    }
}

pub(crate) fn sweep(options: &SweepOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    // A sweep is its tables: without them, hours of work would leave nothing.
    if !HAS_PARQUET {
        return Err(Failure::Undone(format!("a sweep writes tables: {}", ColumnsError::NoParquet)));
    }
    let scene = Scene::read(&options.scene)?;
    let mut complaints = Complaints::of(Asker::Command);
    let plate = plate(&scene, options.plate.as_deref(), &mut complaints);
    let shard = shard(&options.shard, &mut complaints);
    let designs = designs::read(&scene, options, &mut complaints)?;
    complaints.finish()?;
    let sweep = Sweep { scene: &scene, plate, designs, shard };
    let folder = output.folder(scene.name()).join("sweep");
    let folder = Folder::open(folder, &report::manifest(&sweep)?, shard, options.force)?;
    let took = follow(&sweep, &folder)?;
    report::deliver(&sweep, &folder, took, output.format == Format::Json, out)?;
    folder.close();
    Ok(())
}

/// `2/8`: the second of eight.
fn shard(text: &str, complaints: &mut Complaints) -> (u64, u64) {
    let numbers =
        text.split_once('/').and_then(|(i, n)| Some((i.trim().parse().ok()?, n.trim().parse().ok()?)));
    match numbers {
        Some((i, n)) if (1..=n).contains(&i) => (i - 1, n),
        _ => {
            complaints.push("shard", format!("\"{text}\": expected I/N with I from 1 to N, as in 2/8"));
            (0, 1)
        }
    }
}

/// Works through the steps that are missing; returns how many drops that took, and the time [s].
fn follow(sweep: &Sweep<'_>, folder: &Folder) -> Result<(usize, f64), Failure> {
    let paths: Vec<&str> = sweep.designs.paths().iter().map(String::as_str).collect();
    let variants: Variants<'_> = sweep.scene.variants(&paths)?;
    let count = |step: u64| sweep.of_step(step).count();
    let progress = Progress::new("designs", Some(sweep.own().map(count).sum()));
    let mut reader = sweep.designs.reader()?;
    let mut dropped = 0;
    for step in sweep.own() {
        let part = step / (PART / STEP);
        let rows = sweep.of_step(step);
        let finished = folder.of_part(part, &sweep.of_part(part))?.is_some();
        if finished || folder.of_step(step, &rows)?.is_some() {
            progress.skip(count(step));
        } else {
            let designs = reader.take(rows)?;
            let feeder = |values: &[f64]| {
                progress.step();
                variants.feeder(values).ok()
            };
            let drops = sweep::drops(&designs, sweep.plate, feeder);
            folder.write_step(step, &table::step(sweep, folder, step, (&designs, &drops))?)?;
            dropped += drops.len();
        }
        finish(sweep, folder, part)?;
    }
    Ok((dropped, progress.seconds()))
}

/// Puts the steps of a part into its file where all are there, and removes those of a part that has one.
fn finish(sweep: &Sweep<'_>, folder: &Folder, part: u64) -> Result<(), Failure> {
    let steps = sweep.steps_of(part);
    if folder.of_part(part, &sweep.of_part(part))?.is_none() {
        let whole = steps.clone().all(|step| folder.has_step(step));
        let Some((bytes, counts)) = (if whole { table::part(sweep, folder, part)? } else { None }) else {
            return Ok(());
        };
        folder.write_part(part, &bytes, counts)?;
    }
    steps.into_iter().try_for_each(|step| folder.drop_step(step))
}

/// Problems of the command line and of the list of designs.
fn list_problems(file: &str, problems: Vec<carom_scene::Problem>) -> Failure {
    Failure::from(Problems::new(file, "", problems))
}

#[cfg(test)]
mod tests;
