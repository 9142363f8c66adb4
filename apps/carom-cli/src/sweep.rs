//! `carom sweep`: any number of designs, streamed to Parquet.

use crate::args::{Format, Output, SweepOptions};
use crate::failure::Failure;
use crate::printed::tell;
use crate::progress::Progress;
use carom::tasks::axes::Asker;
use carom_scene::Scene;
use carom_sweep::{DesignsAsked, Sizes, Sweep, SweepAsked};
use std::io::Write;

pub(crate) fn sweep(options: &SweepOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    let scene = Scene::read(&options.scene)?;
    let asked = SweepAsked {
        designs: match &options.list {
            Some(file) => DesignsAsked::List(file),
            None => DesignsAsked::Grid(&options.grid),
        },
        plate: options.plate.as_deref(),
        shard: &options.shard,
        force: options.force,
        sizes: sizes(),
        asker: Asker::Command,
    };
    let folder = output.folder(scene.name()).join("sweep");
    let sweep = Sweep::open(&scene, &asked, folder, tell)?;
    let progress = Progress::new("designs", Some(sweep.designs()));
    let swept = sweep.follow(|designs| progress.steps(designs))?;
    drop(progress);
    match output.format {
        Format::Text => out.write_all(swept.text.as_bytes())?,
        Format::Json => writeln!(out, "{}", serde_json::to_string_pretty(&swept.report)?)?,
    }
    Ok(())
}

#[cfg(not(test))]
fn sizes() -> Sizes {
    Sizes::default()
}

/// Few designs, so that a test has several part files soon.
#[cfg(test)]
fn sizes() -> Sizes {
    Sizes { part: 8, group: 8, step: 4 }
}

#[cfg(test)]
mod tests;
