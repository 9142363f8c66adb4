//! `carom sweep`: any number of designs, streamed to Parquet.

use crate::args::{Format, Output, SweepOptions};
use crate::failure::Failure;
use crate::printed::tell;
use crate::progress::Progress;
use carom::tasks::axes::Asker;
use carom_scene::{AnyScene, Drawn};
use carom_sweep::{DesignsAsked, Sizes, Sweep, SweepAsked};
use std::io::Write;

pub(crate) fn sweep(options: &SweepOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    match AnyScene::read(&options.scene)? {
        AnyScene::Plane(scene) => of_scene(&*scene, sizes(Sizes::default()), options, output, out),
        AnyScene::Space(scene) => of_scene(&*scene, sizes(Sizes::IN_SPACE), options, output, out),
    }
}

fn of_scene(
    scene: &impl Drawn,
    sizes: Sizes,
    options: &SweepOptions,
    output: &Output,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let asked = SweepAsked {
        designs: match &options.list {
            Some(file) => DesignsAsked::List(file),
            None => DesignsAsked::Grid(&options.grid),
        },
        plate: options.plate.as_deref(),
        shard: &options.shard,
        force: options.force,
        sizes,
        asker: Asker::Command,
    };
    let folder = output.folder(scene.name()).join("sweep");
    let sweep = Sweep::open(scene, &asked, folder, tell)?;
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
fn sizes(usual: Sizes) -> Sizes {
    usual
}

/// Few designs, so that a test has several part files soon.
#[cfg(test)]
fn sizes(_: Sizes) -> Sizes {
    Sizes { part: 8, group: 8, step: 4 }
}

#[cfg(test)]
mod tests;
