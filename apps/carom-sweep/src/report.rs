//! What a sweep says.

use crate::disk;
use crate::folder::{Counts, Folder};
use crate::list_file::fingerprint_of;
use crate::{Of, Swept, no_json, table};
use carom::tasks::StudyError;
use carom_scene::{Drawn, StudyRunReport, SweepManifest, SweepReport};
use carom_words::aligned;
use carom_words::number::ascii as fixed;
use carom_words::part::{self, Names};
use std::fmt::Write as _;

/// What is swept: a folder with another text is of another sweep.
pub(crate) fn manifest(sweep: &Of<'_, impl Drawn>) -> Result<String, StudyError> {
    let outline = sweep.scene.part_file().map(|(_, file)| {
        let bytes = disk::read_input(&file);
        bytes.and_then(|bytes| fingerprint_of(&bytes[..])).map_err(|error| disk::unread(&file, &error))
    });
    let manifest = SweepManifest {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        scene: sweep.scene.source().to_owned(),
        outline: outline.transpose()?,
        plate: sweep.scene.feeder().given(sweep.plate).to_owned(),
        quantities: sweep.designs.paths().to_vec(),
        designs: sweep.designs.described()?,
        rows: sweep.designs.len(),
        rows_per_part: sweep.sizes.part,
        rows_per_step: sweep.sizes.step,
        columns: table::described(sweep),
    };
    Ok(format!("{}\n", serde_json::to_string_pretty(&manifest).map_err(no_json)?))
}

/// The rows that are there, of all shards, and how often each ending occurs among them.
fn counted(sweep: &Of<'_, impl Drawn>, folder: &Folder<'_>) -> Result<(u64, Counts), StudyError> {
    let (mut rows, mut endings) = (0, Counts::new());
    let mut add = |counts: Counts| {
        for (ending, count) in counts {
            *endings.entry(ending).or_insert(0) += count;
            rows += count;
        }
    };
    folder.look_again();
    for part in 0..sweep.parts() {
        match folder.of_part(part, &sweep.of_part(part))? {
            Some(counts) => add(counts),
            None => {
                for step in sweep.steps_of(part) {
                    folder.of_step(step, &sweep.of_step(step))?.map(&mut add);
                }
            }
        }
    }
    Ok((rows, endings))
}

pub(crate) fn swept(
    sweep: &Of<'_, impl Drawn>,
    folder: &Folder<'_>,
    (drops, seconds): (usize, f64),
) -> Result<Swept, StudyError> {
    let (rows, endings) = counted(sweep, folder)?;
    let run = StudyRunReport { drops, seconds, threads: carom_study::threads() };
    let report = SweepReport {
        scene: sweep.scene.name().to_owned(),
        approximations: sweep.scene.approximations().to_vec(),
        plate: sweep.scene.feeder().given(sweep.plate).to_owned(),
        rows,
        designs: sweep.designs.len(),
        endings,
        columns: table::described(sweep),
        folder: folder.path().display().to_string(),
        run,
    };
    let idle = sweep.own().next().is_none();
    let text = text(sweep, &report, idle.then(|| sweep.steps()));
    Ok(Swept { report, text })
}

/// For a person. `steps` is how many there are in all, where none of them is this shard's.
fn text(sweep: &Of<'_, impl Drawn>, report: &SweepReport, steps: Option<u64>) -> String {
    let plate = part::obstacle(sweep.scene.feeder(), sweep.plate);
    let mut text = format!("{}: {} of {} designs are swept\n", report.scene, report.rows, report.designs);
    if let Some(steps) = steps {
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "this shard has no step: {} designs make {steps} of {} at most",
            report.designs, sweep.sizes.step
        );
    }
    text.push('\n');
    let mut rows = vec![vec![format!("on \"{plate}\""), "designs".to_owned(), "%".to_owned()]];
    rows.extend(report.endings.iter().map(|(ending, count)| {
        let share = 100.0 * *count as f64 / report.rows.max(1) as f64;
        vec![ending.clone(), count.to_string(), fixed(share, 2)]
    }));
    text += &aligned(&rows);
    // Writing to a String cannot fail.
    let _ = writeln!(text, "\n{:.2} s\n\n{}", report.run.seconds, report.folder);
    text
}
