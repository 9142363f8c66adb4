//! What a sweep says.

use super::designs::fingerprint_of;
use super::folder::Folder;
use super::{PART, Sweep};
use crate::failure::Failure;
use crate::progress::spent;
use crate::side_by_side::aligned;
use crate::table::fixed;
use crate::warned;
use carom_scene::{Scene, SweepManifest, SweepReport};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io::Write;

/// What is swept: a folder with another text is of another sweep.
pub(super) fn manifest(sweep: &Sweep<'_>) -> Result<String, Failure> {
    let outline = sweep.scene.outline_file().map(|(_, file)| fingerprint_of(&file));
    let manifest = SweepManifest {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        scene: sweep.scene.source().to_owned(),
        outline: outline.transpose()?,
        plate: sweep.scene.feeder().plates[sweep.plate].name.clone(),
        quantities: sweep.designs.paths().to_vec(),
        designs: sweep.designs.described()?,
        rows: sweep.designs.len(),
        rows_per_part: PART,
    };
    Ok(format!("{}\n", serde_json::to_string_pretty(&manifest)?))
}

/// The rows that are there, of all shards, and how often each ending occurs among them.
fn counted(sweep: &Sweep<'_>, folder: &Folder) -> Result<(u64, BTreeMap<String, u64>), Failure> {
    let (mut rows, mut endings) = (0, BTreeMap::new());
    for part in 0..sweep.parts() {
        let Some(told) = folder.told_by(part)? else { continue };
        let counts = told.iter().find(|(key, _)| key == "endings").map(|(_, value)| value.as_str());
        let counts: BTreeMap<String, u64> = serde_json::from_str(counts.unwrap_or("{}"))?;
        for (ending, count) in counts {
            *endings.entry(ending).or_insert(0) += count;
            rows += count;
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
        folder: folder.path().display().to_string(),
        run,
    };
    if json {
        writeln!(out, "{}", serde_json::to_string_pretty(&report)?)?;
    } else {
        let idle = sweep.own().next().is_none();
        out.write_all(text(sweep.scene, &report, idle.then(|| sweep.parts())).as_bytes())?;
    }
    Ok(())
}

/// For a person. `parts` is how many part files there are in all, where none of them is this shard's.
fn text(scene: &Scene, report: &SweepReport, parts: Option<u64>) -> String {
    let mut text = format!(
        "{}: {} of {} designs are swept{}\n{}",
        report.scene,
        report.rows,
        report.designs,
        warned::beside(scene),
        warned::below(scene)
    );
    if let Some(parts) = parts {
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "this shard has no part file: {} designs make {parts} of {PART} at most",
            report.designs
        );
    }
    text.push('\n');
    let mut rows = vec![vec![format!("on \"{}\"", report.plate), "designs".to_owned(), "%".to_owned()]];
    rows.extend(report.endings.iter().map(|(ending, count)| {
        let share = 100.0 * *count as f64 / report.rows.max(1) as f64;
        vec![ending.clone(), count.to_string(), fixed(share, 2)]
    }));
    text += &aligned(&rows);
    // Writing to a String cannot fail.
    let _ = writeln!(text, "\n{:.2} s\n\n{}", report.run.seconds, report.folder);
    text
}
