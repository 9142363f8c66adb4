//! Any number of designs of a scene, streamed to Parquet; stopped at any moment, a sweep goes on where it was.
//!
//! The command and Python sweep with it. A folder holds part files, which are whole or not there; several processes, each with a shard of the
//! work, may write into one. [`disk`] has the calls that read and change files.

mod designs;
pub mod disk;
mod folder;
mod list_file;
mod lock;
mod report;
mod table;

use carom::tasks::StudyError;
use carom::tasks::axes::{Asker, Complaints, plate};
use carom_scene::columns::{ColumnsError, HAS_PARQUET};
use carom_scene::{Drawn, Scene, SweepReport, Variants};
use carom_study::sweep;
use designs::Designs;
use folder::Folder;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// How the work is divided. Each number divides the one before.
///
/// # Example
/// ```
/// assert_eq!(carom_sweep::Sizes::default().part, 1_000_000);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sizes {
    /// Designs of one part file.
    pub part: u64,
    /// Of a group of rows in it.
    pub group: u64,
    /// Of a step: what is worked through at a time, and lost at most.
    pub step: u64,
}

impl Sizes {
    /// Of a scene in space, where a drop takes a hundred times as long as in the plane.
    pub const IN_SPACE: Self = Self { part: 100_000, group: 10_000, step: 500 };
}

impl Default for Sizes {
    fn default() -> Self {
        Self { part: 1_000_000, group: 100_000, step: 10_000 }
    }
}

/// Which designs.
#[derive(Clone, Copy, Debug)]
pub enum DesignsAsked<'a> {
    /// Quantities and their points, every combination of them: `plate.lower.slope=5..40 deg:71`.
    Grid(&'a [String]),
    /// A CSV file: the first line names quantities, each other one is a design.
    List(&'a Path),
}

/// What is asked of a sweep.
#[derive(Clone, Copy, Debug)]
pub struct SweepAsked<'a> {
    /// Which designs.
    pub designs: DesignsAsked<'a>,
    /// The plate to look at, by name or number from 0; the last where none is named.
    pub plate: Option<&'a str>,
    /// Which part of the work: `2/8` is the second of eight.
    pub shard: &'a str,
    /// Replace what the folder holds of another sweep.
    pub force: bool,
    /// How the work is divided.
    pub sizes: Sizes,
    /// Who asks.
    pub asker: Asker,
}

/// What is swept.
struct Of<'s, S: Drawn> {
    scene: &'s S,
    plate: usize,
    designs: Designs,
    /// Which of how many shards, from 0.
    shard: (u64, u64),
    sizes: Sizes,
}

impl<S: Drawn> Of<'_, S> {
    /// How many part files there are.
    fn parts(&self) -> u64 {
        self.designs.len().div_ceil(self.sizes.part)
    }

    /// How many steps there are.
    fn steps(&self) -> u64 {
        self.designs.len().div_ceil(self.sizes.step)
    }

    /// The steps of this shard.
    fn own(&self) -> impl Iterator<Item = u64> + use<S> {
        let (shard, of) = self.shard;
        (0..self.steps()).filter(move |step| step % of == shard)
    }

    /// Designs of a part file.
    fn of_part(&self, part: u64) -> Range<u64> {
        let size = self.sizes.part;
        part * size..((part + 1) * size).min(self.designs.len())
    }

    /// Designs of a step.
    fn of_step(&self, step: u64) -> Range<u64> {
        let size = self.sizes.step;
        step * size..((step + 1) * size).min(self.designs.len())
    }

    /// How many designs a step has.
    fn count(&self, step: u64) -> usize {
        self.of_step(step).count()
    }

    /// The part of a step.
    fn part_of(&self, step: u64) -> u64 {
        step / (self.sizes.part / self.sizes.step)
    }

    /// The steps of a part.
    fn steps_of(&self, part: u64) -> Range<u64> {
        let each = self.sizes.part / self.sizes.step;
        part * each..((part + 1) * each).min(self.steps())
    }
}

/// A sweep whose folder is open.
pub struct Sweep<'s, S: Drawn = Scene> {
    of: Of<'s, S>,
    folder: Folder<'s>,
}

/// What a sweep came to.
pub struct Swept {
    /// What it says to a program.
    pub report: SweepReport,
    /// What it says to a person.
    pub text: String,
}

impl<'s, S: Drawn> Sweep<'s, S> {
    /// Opens the folder of a sweep, anew or to go on with it; `tell` hears of files that are found damaged.
    ///
    /// # Errors
    /// Everything that is wrong with what is asked and with the list; a folder of another sweep, or at which somebody else is at work; a build
    /// without Parquet.
    pub fn open(
        scene: &'s S,
        asked: &SweepAsked<'_>,
        folder: PathBuf,
        tell: impl Fn(&str) + Send + 's,
    ) -> Result<Self, StudyError> {
        // A sweep is its tables: without them, hours of work would leave nothing.
        if !HAS_PARQUET {
            return Err(StudyError::Undone(format!("a sweep writes tables: {}", ColumnsError::NoParquet)));
        }
        let mut complaints = Complaints::of(asked.asker);
        let plate = plate(scene, asked.plate, &mut complaints);
        let shard = shard(asked.shard, &mut complaints);
        let designs = designs::read(scene, asked.designs, &mut complaints)?;
        complaints.finish()?;
        let of = Of { scene, plate, designs, shard, sizes: asked.sizes };
        let manifest = report::manifest(&of)?;
        let folder = Folder::open(folder, &manifest, shard, (asked.force, asked.asker), Box::new(tell))?;
        Ok(Self { of, folder })
    }

    /// How many designs this shard has.
    pub fn designs(&self) -> usize {
        self.of.own().map(|step| self.of.count(step)).sum()
    }

    /// Works through the steps that are missing; `step` is called with how many designs are done more.
    ///
    /// # Errors
    /// A file that cannot be written or read. What was written before is whole: the same sweep goes on where this one stopped.
    pub fn follow(self, step: impl Fn(usize) + Sync) -> Result<Swept, StudyError> {
        let begun = Instant::now();
        let dropped = follow(&self.of, &self.folder, &step)?;
        let swept = report::swept(&self.of, &self.folder, (dropped, begun.elapsed().as_secs_f64()))?;
        self.folder.close();
        Ok(swept)
    }
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

/// Works through the steps that are missing; returns how many drops that took.
fn follow(
    of: &Of<'_, impl Drawn>,
    folder: &Folder<'_>,
    step: &(dyn Fn(usize) + Sync),
) -> Result<usize, StudyError> {
    let paths: Vec<&str> = of.designs.paths().iter().map(String::as_str).collect();
    let variants = Variants::over(of.scene, &paths)?;
    let mut reader = of.designs.reader()?;
    let mut dropped = 0;
    for number in of.own() {
        let part = of.part_of(number);
        let rows = of.of_step(number);
        let finished = folder.of_part(part, &of.of_part(part))?.is_some();
        if finished || folder.of_step(number, &rows)?.is_some() {
            step(of.count(number));
        } else {
            let designs = reader.take(rows)?;
            let feeder = |values: &[f64]| {
                step(1);
                variants.feeder(values).ok()
            };
            let drops = sweep::drops(&designs, of.plate, feeder);
            folder.write_step(number, &table::step(of, folder, number, (&designs, &drops))?)?;
            dropped += drops.len();
        }
        finish(of, folder, part)?;
    }
    Ok(dropped)
}

/// Puts the steps of a part into its file where all are there, and removes those of a part that has one.
fn finish(of: &Of<'_, impl Drawn>, folder: &Folder<'_>, part: u64) -> Result<(), StudyError> {
    let steps = of.steps_of(part);
    if folder.of_part(part, &of.of_part(part))?.is_none() {
        let whole = steps.clone().all(|step| folder.has_step(step));
        let Some((bytes, counts)) = (if whole { table::part(of, folder, part)? } else { None }) else {
            return Ok(());
        };
        folder.write_part(part, &bytes, counts)?;
    }
    steps.into_iter().try_for_each(|step| folder.drop_step(step))
}

/// That a result is not JSON, which none is.
fn no_json(error: serde_json::Error) -> StudyError {
    StudyError::Undone(format!("cannot write the result as JSON: {error}"))
}
