//! `carom sweep`: any number of designs, streamed to Parquet; stopped at any moment it goes on where it was.

mod designs;
mod folder;
mod records;
mod report;

use crate::args::{Format, Output, SweepOptions};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::quantities;
use crate::regions::keys::Complaints;
use carom_scene::columns::{Column, parquet};
use carom_scene::{Problems, Scene, Variants};
use carom_study::{Dropped, sweep};
use designs::Designs;
use folder::{FINGERPRINT, Folder};
use std::collections::BTreeMap;
use std::io::Write;

/// Designs of one part file.
#[cfg(not(test))]
const PART: u64 = 1 << 14;
/// Few, so that a test has several part files soon.
#[cfg(test)]
const PART: u64 = 8;

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

    /// The part files of this shard.
    fn own(&self) -> impl Iterator<Item = u64> + use<> {
        let (shard, of) = self.shard;
        (0..self.parts()).filter(move |part| part % of == shard)
    }

    /// Designs of a part file.
    fn of_part(&self, part: u64) -> std::ops::Range<u64> {
        part * PART..((part + 1) * PART).min(self.designs.len())
    }
}

pub(crate) fn sweep(options: &SweepOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    let scene = Scene::read(&options.scene)?;
    let mut complaints = Complaints::default();
    let plate = quantities::plate(&scene, options.plate.as_deref(), &mut complaints);
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
            complaints.push("--shard", format!("\"{text}\": expected I/N with I from 1 to N, as in 2/8"));
            (0, 1)
        }
    }
}

/// Works through the part files that are missing; returns how many drops that took, and the time [s].
fn follow(sweep: &Sweep<'_>, folder: &Folder) -> Result<(usize, f64), Failure> {
    let paths: Vec<&str> = sweep.designs.paths().iter().map(String::as_str).collect();
    let variants: Variants<'_> = sweep.scene.variants(&paths)?;
    let count = |part: u64| sweep.of_part(part).count();
    let progress = Progress::new("designs", Some(sweep.own().map(count).sum()));
    let mut reader = sweep.designs.reader()?;
    let mut dropped = 0;
    for part in sweep.own() {
        if folder.has(part)? {
            progress.skip(count(part));
            continue;
        }
        let designs = reader.take(sweep.of_part(part))?;
        let feeder = |values: &[f64]| {
            progress.step();
            variants.feeder(values).ok()
        };
        let drops = sweep::drops(&designs, sweep.plate, feeder);
        folder.write(part, &table(sweep, folder.fingerprint(), part, (&designs, &drops))?)?;
        dropped += drops.len();
    }
    Ok((dropped, progress.seconds()))
}

/// How often each ending occurs.
fn counts(drops: &[Dropped]) -> BTreeMap<String, u64> {
    let mut counts = BTreeMap::new();
    for dropped in drops {
        *counts.entry(dropped.ending.to_string()).or_insert(0) += 1;
    }
    counts
}

/// One part file.
fn table(
    sweep: &Sweep<'_>,
    fingerprint: &str,
    part: u64,
    (designs, drops): (&[Vec<f64>], &[Dropped]),
) -> Result<Vec<u8>, Failure> {
    let plate = sweep.plate;
    let number = |of: &dyn Fn(&Dropped) -> Option<f64>| Column::Number(drops.iter().map(of).collect());
    let landing = |dropped: &Dropped| {
        let run = dropped.run.as_ref()?;
        run.landings.iter().find(|landing| landing.plate == plate).copied()
    };
    let rows = sweep.of_part(part).map(|row| i64::try_from(row).ok());
    let mut columns: Vec<(&str, Column)> = vec![("design", Column::Whole(rows.collect()))];
    for (i, path) in sweep.designs.paths().iter().enumerate() {
        columns.push((path, Column::Number(designs.iter().map(|design| design.get(i).copied()).collect())));
    }
    let outcome = |d: &Dropped| d.run.as_ref().map(|run| run.outcome.word().to_owned());
    columns.extend([
        ("ending", Column::Word(drops.iter().map(|d| Some(d.ending.to_string())).collect())),
        ("outcome", Column::Word(drops.iter().map(outcome).collect())),
        ("impact_speed_m_s", number(&|d| landing(d).map(|l| l.impact_speed))),
        ("max_sliding_speed_m_s", number(&|d| landing(d).map(|l| l.max_sliding_speed))),
        ("first_touch_s", number(&|d| landing(d).map(|l| l.first_touch))),
        ("flat_s", number(&|d| landing(d).and_then(|l| l.flat))),
        ("end_s", number(&|d| d.run.as_ref().map(|run| run.end_time))),
        ("margin", number(&Dropped::margin)),
    ]);
    let counts = serde_json::to_string(&counts(drops))?;
    let about = [
        ("scene", sweep.scene.source()),
        ("plate", &sweep.scene.feeder().plates[plate].name),
        ("version", env!("CARGO_PKG_VERSION")),
        ("endings", &counts),
        (FINGERPRINT, fingerprint),
    ];
    parquet(&columns, &about).map_err(|error| Failure::Undone(error.to_string()))
}

/// Problems of the command line and of the list of designs.
fn list_problems(file: &str, problems: Vec<carom_scene::Problem>) -> Failure {
    Failure::from(Problems::new(file, "", problems))
}
