//! `carom feed`: how closely parts may follow each other.

mod picture;
mod report;

use crate::args::{FeedOptions, Format, Output};
use crate::failure::Failure;
use crate::files;
use crate::progress::Progress;
use crate::regions::keys::Complaints;
use carom_feeder::Feed;
use carom_scene::Scene;
use carom_study::feeds::{Feeds, FeedsError, Happens, Kind, MOST_NODES, Plan, search};
use carom_words::study;
use std::io::Write;
use std::ops::RangeInclusive;

/// Parts of a scene that has no feed.
const PARTS: usize = 3;
/// How many parts may be asked for.
const ALLOWED_PARTS: RangeInclusive<usize> = 2..=100;
/// How finely changes may be located [s].
const ALLOWED_ACCURACY: RangeInclusive<f64> = 1e-9..=0.1;
/// Intervals that may be asked.
const ALLOWED_INTERVALS: RangeInclusive<usize> = 16..=MOST_NODES;

/// A search and what it is of.
struct Searched<'s> {
    scene: &'s Scene,
    feed: Feed,
    plan: Plan,
    found: Feeds,
    seconds: f64,
}

/// A scene that is saved.
struct Saved {
    file: &'static str,
    why: &'static str,
    words: &'static str,
    interval: f64,
}

pub(crate) fn feed(options: &FeedOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    let scene = Scene::read(&options.scene)?;
    let mut complaints = Complaints::default();
    let parts = parts(&scene, options.parts, &mut complaints);
    if !ALLOWED_INTERVALS.contains(&options.intervals) {
        complaints.push("--intervals", format!("{} is outside 16 to {MOST_NODES}", options.intervals));
    }
    if !ALLOWED_ACCURACY.contains(&options.accuracy) {
        complaints.push("--accuracy", format!("{} s is outside 1e-9 s to 0.1 s", options.accuracy));
    }
    complaints.finish()?;
    let feed = scene.fed(parts, 1.0)?;
    let plan = Plan { nodes: options.intervals, accuracy: options.accuracy, ..Plan::default() };
    let progress = Progress::new("feeds", None);
    let found = search(scene.feeder(), &feed, &plan, |run| scene.ends_as_wanted(run), || progress.step())
        .map_err(|error| refused(&scene, &error))?;
    let seconds = progress.seconds();
    drop(progress);
    deliver(&Searched { scene: &scene, feed, plan, found, seconds }, output, out)
}

/// How many parts are fed.
fn parts(scene: &Scene, asked: Option<usize>, complaints: &mut Complaints) -> usize {
    let parts = asked.or(scene.feed().map(|feed| feed.parts)).unwrap_or(PARTS);
    if !ALLOWED_PARTS.contains(&parts) {
        let (option, whose) = match asked {
            Some(_) => ("--parts", ""),
            None => ("feed.parts", " of the scene (--parts takes others)"),
        };
        complaints.push(option, format!("{parts}{whose} is outside 2 to 100"));
    }
    parts
}

fn refused(scene: &Scene, error: &FeedsError) -> Failure {
    let mut text = format!("{}: {error}", scene.name());
    if let FeedsError::Alone(outcome) = error {
        text.push_str(&format!(": {}", study::outcome(*outcome)));
    }
    match error {
        FeedsError::Alone(_) | FeedsError::Motion(_) => Failure::Undone(text),
        _ => Failure::Usage(text),
    }
}

/// The scenes that are worth a look, as they are fed.
fn saved(found: &Feeds) -> Vec<Saved> {
    let longest = |is: &dyn Fn(&Happens) -> bool| {
        found.stretches.iter().rev().find(|piece| is(&piece.label)).map(|piece| piece.last)
    };
    // Where it is not resolved whether parts touch, nothing is there to be replayed.
    let touches = longest(&|happens| happens.meets.is_some());
    let saved = |file, why, words, interval: Option<f64>| {
        interval.map(|interval| Saved { file, why, words, interval })
    };
    let free = found.smallest.as_ref().map(|smallest| smallest.free);
    [
        saved("touches.toml", "touches", "the longest interval with a touch", touches),
        saved(
            "otherwise.toml",
            "otherwise",
            "the longest interval at which a part ends otherwise than wanted",
            longest(&|happens| happens.kind() == Kind::Harmful),
        ),
        saved("free.toml", "free", "the smallest interval above which parts do not touch", free),
    ]
    .into_iter()
    .flatten()
    .collect()
}

fn deliver(searched: &Searched<'_>, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    let folder = output.folder(searched.scene.name()).join("feed");
    let scenes = saved(&searched.found);
    let summary = format!("{}\n", serde_json::to_string_pretty(&report::summary(searched, &scenes))?);
    files::bring_outline(searched.scene, &folder)?;
    let mut written = vec![
        files::write(&folder, "feed.svg", &picture::svg(searched))?,
        files::write(&folder, "feed.csv", &report::csv(searched))?,
        files::write(&folder, "feed.json", &summary)?,
    ];
    for scene in &scenes {
        let text = searched.scene.text_fed(searched.feed.parts, scene.interval)?;
        let head = format!("# {}: {}.\n", searched.scene.name(), scene.words);
        written.push(files::write(&folder, scene.file, &format!("{head}{text}"))?);
    }
    let mut rest = vec!["touches.toml", "otherwise.toml", "free.toml"];
    rest.retain(|name| scenes.iter().all(|scene| scene.file != *name));
    files::remove(&folder, &rest)?;
    match output.format {
        Format::Text => out.write_all(report::text(searched, &written).as_bytes())?,
        Format::Json => out.write_all(summary.as_bytes())?,
    }
    Ok(())
}
