//! `carom feed`: how closely parts may follow each other.

use crate::args::{FeedOptions, Format, Output};
use crate::failure::Failure;
use crate::files;
use crate::printed::with_files;
use crate::progress::{Progress, spent};
use carom::tasks::axes::Asker;
use carom::tasks::feeds::{FeedAsked, FeedStudy};
use carom_scene::Scene;
use std::io::Write;

pub(crate) fn feed(options: &FeedOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    let scene = Scene::read(&options.scene)?;
    let asked = FeedAsked {
        parts: options.parts,
        intervals: options.intervals,
        accuracy: options.accuracy,
        asker: Asker::Command,
    };
    let progress = Progress::new("feeds", None);
    let study = FeedStudy::searched(&scene, &asked, || progress.step())?;
    let seconds = progress.seconds();
    drop(progress);
    deliver(&study, seconds, output, out)
}

fn deliver(
    study: &FeedStudy<'_>,
    seconds: f64,
    output: &Output,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let folder = output.folder(study.scene.name()).join("feed");
    let summary = study.summary(spent(study.drops(), seconds));
    let summary = format!("{}\n", serde_json::to_string_pretty(&summary)?);
    files::bring_outline(study.scene, &folder)?;
    let mut written = vec![
        files::write(&folder, "feed.svg", &study.svg())?,
        files::write(&folder, "feed.csv", &study.csv())?,
        files::write(&folder, "feed.json", &summary)?,
    ];
    let scenes = study.scenes()?;
    for (name, text) in &scenes {
        written.push(files::write(&folder, name, text)?);
    }
    let gone = FeedStudy::FILES.into_iter().filter(|name| scenes.iter().all(|(file, _)| file != name));
    files::remove(&folder, &gone.collect::<Vec<_>>())?;
    match output.format {
        Format::Text => out.write_all(with_files(study.text(seconds), &written).as_bytes())?,
        Format::Json => out.write_all(summary.as_bytes())?,
    }
    Ok(())
}
