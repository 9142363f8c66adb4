//! What a sweep says.

use super::folder::{Counts, Folder};
use super::list_file::fingerprint_of;
use super::{PART, STEP, Sweep, table};
use crate::disk;
use crate::failure::Failure;
use crate::progress::spent;
use crate::table::fixed;
use carom_scene::{SweepManifest, SweepReport};
use carom_words::aligned;
use carom_words::part;
use std::fmt::Write as _;
use std::io::Write;

/// What is swept: a folder with another text is of another sweep.
pub(super) fn manifest(sweep: &Sweep<'_>) -> Result<String, Failure> {
    let outline = sweep.scene.outline_file().map(|(_, file)| {
        let bytes = disk::read_input(&file);
        bytes.and_then(|bytes| fingerprint_of(&bytes[..])).map_err(|error| Failure::unread(&file, &error))
    });
    let manifest = SweepManifest {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        scene: sweep.scene.source().to_owned(),
        outline: outline.transpose()?,
        plate: sweep.scene.feeder().plates[sweep.plate].name.clone(),
        quantities: sweep.designs.paths().to_vec(),
        designs: sweep.designs.described()?,
        rows: sweep.designs.len(),
        rows_per_part: PART,
        rows_per_step: STEP,
        columns: table::described(sweep),
    };
    Ok(format!("{}\n", serde_json::to_string_pretty(&manifest)?))
}

/// The rows that are there, of all shards, and how often each ending occurs among them.
fn counted(sweep: &Sweep<'_>, folder: &Folder) -> Result<(u64, Counts), Failure> {
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

pub(super) fn deliver(
    sweep: &Sweep<'_>,
    folder: &Folder,
    (dropped, seconds): (usize, f64),
    json: bool,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let (rows, endings) = counted(sweep, folder)?;
    let run = spent(dropped, seconds);
    let report = SweepReport {
        scene: sweep.scene.name().to_owned(),
        approximations: sweep.scene.approximations().to_vec(),
        plate: sweep.scene.feeder().plates[sweep.plate].name.clone(),
        rows,
        designs: sweep.designs.len(),
        endings,
        columns: table::described(sweep),
        folder: folder.path().display().to_string(),
        run,
    };
    if json {
        writeln!(out, "{}", serde_json::to_string_pretty(&report)?)?;
    } else {
        let idle = sweep.own().next().is_none();
        out.write_all(text(sweep, &report, idle.then(|| sweep.steps())).as_bytes())?;
    }
    Ok(())
}

/// For a person. `steps` is how many there are in all, where none of them is this shard's.
fn text(sweep: &Sweep<'_>, report: &SweepReport, steps: Option<u64>) -> String {
    let plate = part::obstacle(sweep.scene.feeder(), sweep.plate);
    let mut text = format!("{}: {} of {} designs are swept\n", report.scene, report.rows, report.designs);
    if let Some(steps) = steps {
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "this shard has no step: {} designs make {steps} of {STEP} at most",
            report.designs
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
