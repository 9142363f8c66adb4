//! `carom feed`: how closely parts may follow each other.

use crate::args::{FeedOptions, Format, Output};
use crate::failure::Failure;
use crate::files;
use crate::printed::with_files;
use crate::progress::{Progress, spent};
use carom::tasks::axes::Asker;
use carom::tasks::feeds::{FILES, FeedAsked, FeedStudy};
use carom_scene::{AnyScene, Drawn};
use std::io::Write;

pub(crate) fn feed(options: &FeedOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    let asked = FeedAsked {
        parts: options.parts,
        intervals: options.intervals,
        accuracy: options.accuracy,
        asker: Asker::Command,
    };
    match AnyScene::read(&options.scene)? {
        AnyScene::Plane(scene) => {
            let progress = Progress::new("feeds", None);
            let study = FeedStudy::searched(&scene, &asked, || progress.step())?;
            let scenes = study.scenes()?;
            deliver(&study, &scenes, progress, output, out)
        }
        AnyScene::Space(scene) => {
            let progress = Progress::new("intervals", None);
            let study = FeedStudy::searched_solid(&scene, &asked, || progress.step())?;
            deliver(&study, &[], progress, output, out)
        }
    }
}

/// Writes what was found, with the scenes that can be replayed.
fn deliver(
    study: &FeedStudy<'_, impl Drawn>,
    scenes: &[(&str, String)],
    progress: Progress,
    output: &Output,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let seconds = progress.seconds();
    drop(progress);
    let folder = output.folder(study.scene.name()).join("feed");
    if !scenes.is_empty() {
        files::bring_outline(study.scene, &folder)?;
    }
    let summary = study.summary(spent(study.drops(), seconds));
    let summary = format!("{}\n", serde_json::to_string_pretty(&summary)?);
    let mut written = vec![
        files::write(&folder, "feed.svg", &study.svg())?,
        files::write(&folder, "feed.csv", &study.csv())?,
        files::write(&folder, "feed.json", &summary)?,
    ];
    for (name, text) in scenes {
        written.push(files::write(&folder, name, text)?);
    }
    let gone = FILES.into_iter().filter(|name| scenes.iter().all(|(file, _)| file != name));
    files::remove(&folder, &gone.collect::<Vec<_>>())?;
    match output.format {
        Format::Text => out.write_all(with_files(study.text(seconds), &written).as_bytes())?,
        Format::Json => out.write_all(summary.as_bytes())?,
    }
    Ok(())
}
