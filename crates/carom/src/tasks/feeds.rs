//! How closely parts may follow each other: the study of `carom feed`.

mod picture;
mod report;

use super::StudyError;
use super::axes::{Asker, Complaints};
use super::tolerance::INTERVAL_ACCURACY;
use carom_feeder::Feed;
use carom_scene::{Drawn, Scene, SpaceScene};
use carom_study::Device;
use carom_study::feeds::{Feeds, FeedsError, Happens, Kind, MOST_NODES, Plan, search, search_solid};
use carom_words::study;
use std::ops::RangeInclusive;

/// Parts of a scene that has no feed.
const PARTS: usize = 3;
/// How many parts may be asked for.
const ALLOWED_PARTS: RangeInclusive<usize> = 2..=100;
/// How finely changes may be located [s].
const ALLOWED_ACCURACY: RangeInclusive<f64> = 1e-9..=0.1;
/// Intervals that may be asked.
const ALLOWED_INTERVALS: RangeInclusive<usize> = 16..=MOST_NODES;
/// Intervals that are looked at first, where nothing is asked.
pub const INTERVALS: usize = 400;

/// The names of the files of [`FeedStudy::scenes`], of which some may not be there.
pub const FILES: [&str; 3] = ["touches.toml", "otherwise.toml", "free.toml"];

/// What is asked of a feed.
///
/// # Example
/// ```
/// use carom::tasks::feeds::FeedAsked;
/// assert_eq!(FeedAsked::default().accuracy, 1e-6);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FeedAsked {
    /// How many parts; the scene's where none are asked, or 3. Not of solid parts: what is said of them is so for any number.
    pub parts: Option<usize>,
    /// Intervals that are looked at first.
    pub intervals: usize,
    /// How finely changes are located \[s\].
    pub accuracy: f64,
    /// Who asks.
    pub asker: Asker,
}

impl Default for FeedAsked {
    fn default() -> Self {
        Self { parts: None, intervals: INTERVALS, accuracy: INTERVAL_ACCURACY, asker: Asker::Call }
    }
}

/// A search for the smallest interval, and what it is of.
///
/// # Example
/// ```
/// use carom::{prelude::*, tasks::feeds::{FeedAsked, FeedStudy}};
/// let scene = Scene::read("../../examples/feed_closely.toml".as_ref())?;
/// let asked = FeedAsked { intervals: 16, parts: Some(2), ..FeedAsked::default() };
/// let study = FeedStudy::searched(&scene, &asked, || {}).unwrap();
/// assert!(study.found.smallest.is_some());
/// # Ok::<(), carom::Error>(())
/// ```
pub struct FeedStudy<'s, S: Drawn = Scene> {
    /// The scene.
    pub scene: &'s S,
    /// How it is fed; `None` of solid parts, of which one alone is followed.
    pub feed: Option<Feed>,
    /// The interval that the scene has \[s\].
    pub given: Option<f64>,
    /// How it was searched.
    pub plan: Plan,
    /// What came out.
    pub found: Feeds<<S::Feeder as Device>::Run>,
}

/// A scene that is saved.
struct Saved {
    file: &'static str,
    why: &'static str,
    words: &'static str,
    interval: f64,
}

impl<'s> FeedStudy<'s> {
    /// Searches the intervals of a scene; `step` is called after each feed.
    ///
    /// # Errors
    /// Everything that is wrong with what is asked; one part alone that does not come through.
    pub fn searched(scene: &'s Scene, asked: &FeedAsked, step: impl Fn() + Sync) -> Result<Self, StudyError> {
        let mut complaints = Complaints::of(asked.asker);
        let parts = parts(scene, asked.parts, &mut complaints);
        let plan = plan(asked, &mut complaints);
        complaints.finish()?;
        let feed = scene.fed(parts, 1.0)?;
        let found = search(scene.feeder(), &feed, &plan, |run| scene.ends_as_wanted(run), step)
            .map_err(|error| refused(scene, &error))?;
        let given = scene.feed().map(|feed| feed.interval);
        Ok(Self { scene, feed: Some(feed), given, plan, found })
    }

    /// The scenes that are worth a look, as they are fed, by the names of their files.
    ///
    /// # Errors
    /// A scene that cannot be written.
    pub fn scenes(&self) -> Result<Vec<(&'static str, String)>, StudyError> {
        let scene = |saved: Saved| {
            let text = self.scene.text_fed(self.parts(), saved.interval)?;
            Ok((saved.file, format!("# {}: {}.\n{text}", self.scene.name(), saved.words)))
        };
        self.saved().map(scene).collect()
    }
}

impl<'s> FeedStudy<'s, SpaceScene> {
    /// Searches the intervals of a scene with a solid part; `step` is called after each.
    ///
    /// # Errors
    /// As [`FeedStudy::searched`].
    ///
    /// # Example
    /// ```
    /// use carom::{prelude::*, tasks::feeds::{FeedAsked, FeedStudy}};
    /// use carom::scene::AnyScene;
    /// let AnyScene::Space(scene) = AnyScene::read("../../examples/solid_groove.toml".as_ref())? else {
    ///     panic!("it is in space")
    /// };
    /// let asked = FeedAsked { intervals: 16, ..FeedAsked::default() };
    /// let study = FeedStudy::searched_solid(&scene, &asked, || {}).unwrap();
    /// assert!(study.found.smallest.is_some());
    /// # Ok::<(), carom::Error>(())
    /// ```
    pub fn searched_solid(
        scene: &'s SpaceScene,
        asked: &FeedAsked,
        step: impl Fn() + Sync,
    ) -> Result<Self, StudyError> {
        let mut complaints = Complaints::of(asked.asker);
        if let Some(parts) = asked.parts {
            let why =
                format!("{parts} is not taken: what is said of solid parts is so for any number of them");
            complaints.push("parts", why);
        }
        let plan = plan(asked, &mut complaints);
        complaints.finish()?;
        let found = search_solid(scene.feeder(), &plan, |run| scene.ends_as_wanted(run), step)
            .map_err(|error| refused(scene, &error))?;
        Ok(Self { scene, feed: None, given: None, plan, found })
    }
}

impl<S: Drawn> FeedStudy<'_, S> {
    /// How many parts become of what is said: one, where it is so for all.
    fn parts(&self) -> usize {
        self.feed.map_or(1, |feed| feed.parts)
    }

    /// Parts that went through in all.
    pub fn drops(&self) -> usize {
        self.found.runs * self.parts()
    }

    /// The picture, by itself.
    pub fn svg(&self) -> String {
        picture::svg(self)
    }

    fn saved(&self) -> impl Iterator<Item = Saved> {
        let found = &self.found;
        let replayed = self.feed.is_some();
        let longest = |is: &dyn Fn(&Happens) -> bool| {
            found.stretches.iter().rev().find(|piece| is(&piece.label)).map(|piece| piece.last)
        };
        // Where it is not resolved whether parts touch, nothing is there to be replayed.
        let touches = longest(&|happens| happens.meets.is_some());
        let saved = |file, why, words, interval: Option<f64>| {
            interval.map(|interval| Saved { file, why, words, interval })
        };
        let free = found.smallest.as_ref().map(|smallest| smallest.free);
        let [first, second, third] = FILES;
        [
            saved(first, "touches", "the longest interval with a touch", touches),
            saved(
                second,
                "otherwise",
                "the longest interval at which a part ends otherwise than wanted",
                longest(&|happens| happens.kind() == Kind::Harmful),
            ),
            saved(third, "free", "the smallest interval above which parts do not touch", free),
        ]
        .into_iter()
        .flatten()
        .filter(move |_| replayed)
    }
}

/// How the intervals are searched.
fn plan(asked: &FeedAsked, complaints: &mut Complaints) -> Plan {
    if !ALLOWED_INTERVALS.contains(&asked.intervals) {
        complaints.push("intervals", format!("{} is outside 16 to {MOST_NODES}", asked.intervals));
    }
    if !ALLOWED_ACCURACY.contains(&asked.accuracy) {
        complaints.push("accuracy", format!("{} s is outside 1e-9 s to 0.1 s", asked.accuracy));
    }
    Plan { nodes: asked.intervals, accuracy: asked.accuracy, ..Plan::default() }
}

/// How many parts are fed.
fn parts(scene: &Scene, asked: Option<usize>, complaints: &mut Complaints) -> usize {
    let parts = asked.or(scene.feed().map(|feed| feed.parts)).unwrap_or(PARTS);
    if !ALLOWED_PARTS.contains(&parts) {
        match asked {
            Some(_) => complaints.push("parts", format!("{parts} is outside 2 to 100")),
            None => {
                let option = complaints.asker().option("parts");
                complaints.push_of_scene(
                    "feed.parts",
                    format!("{parts} of the scene ({option} takes others) is outside 2 to 100"),
                );
            }
        }
    }
    parts
}

fn refused(scene: &impl Drawn, error: &FeedsError) -> StudyError {
    let mut text = format!("{}: {error}", scene.name());
    if let FeedsError::Alone(outcome) = error {
        text.push_str(&format!(": {}", study::outcome(*outcome)));
    }
    match error {
        FeedsError::Alone(_) | FeedsError::Motion(_) => StudyError::Undone(text),
        _ => StudyError::Asked(text),
    }
}
