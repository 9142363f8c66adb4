//! What a search for the interval of a feed says, as JSON.

use crate::approximation::Approximation;
use crate::map_report::StudyRunReport;
use carom_feeder::{Doing, Feeder};
use carom_study::feeds::{End, Happens, Meets};
use carom_study::stretches::Stretch;
use schemars::JsonSchema;
use serde::Serialize;

/// What a part was doing.
///
/// # Example
/// The part ahead slides on the lower plate, the other one has just been put down.
/// ```
/// # use carom_scene::*;
/// # use carom_feeder::{Doing, Outcome, StageName};
/// # use carom_study::{Ending, feeds::{End, Happens, Meets}, stretches::Stretch};
/// # let scene = Scene::read("../../examples/feed.toml".as_ref())?;
/// let slides = Doing { stage: Some(StageName::Slide), obstacle: 1 };
/// let doing = [slides, Doing { stage: None, obstacle: 0 }];
/// let meets = Meets { parts: [0, 1], doing, blocked: true };
/// let report = FeedMeetingReport::new(scene.feeder(), &meets);
/// let DoingReport { stage, plate } = &report.doing[0];
/// assert_eq!((*stage, plate.as_str()), (Some("slide"), "lower"));
/// assert_eq!(report.doing[1].stage, None);
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DoingReport {
    /// Its stage, as in the result of a run; null where it has just been put on the first plate.
    pub stage: Option<&'static str>,
    /// The plate or wall it is on; in flight, the one it was on last.
    pub plate: String,
}

/// How two parts are in each other's way.
///
/// # Example
/// Parts are numbered from 1.
/// ```
/// # use carom_scene::*;
/// # use carom_feeder::{Doing, Outcome, StageName};
/// # use carom_study::{Ending, feeds::{End, Happens, Meets}, stretches::Stretch};
/// # let scene = Scene::read("../../examples/feed.toml".as_ref())?;
/// let slides = Doing { stage: Some(StageName::Slide), obstacle: 1 };
/// let doing = [slides, Doing { stage: None, obstacle: 0 }];
/// let meets = Meets { parts: [0, 1], doing, blocked: true };
/// let report = FeedMeetingReport::new(scene.feeder(), &meets);
/// assert_eq!((report.parts, report.blocked), ([1, 2], true));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FeedMeetingReport {
    /// Their numbers, from 1; the first one goes ahead.
    pub parts: [usize; 2],
    /// What each was doing until then.
    pub doing: [DoingReport; 2],
    /// True where the second found its place taken and did not start; false where they touched.
    pub blocked: bool,
}

/// What becomes of one part.
///
/// # Example
/// ```
/// # use carom_scene::*;
/// # use carom_feeder::{Doing, Outcome, StageName};
/// # use carom_study::{Ending, feeds::{End, Happens, Meets}, stretches::Stretch};
/// # let scene = Scene::read("../../examples/feed.toml".as_ref())?;
/// let slides = Doing { stage: Some(StageName::Slide), obstacle: 1 };
/// let doing = [slides, Doing { stage: None, obstacle: 0 }];
/// let meets = Meets { parts: [0, 1], doing, blocked: true };
/// let report = FeedMeetingReport::new(scene.feeder(), &meets);
/// let end = End { ending: Ending::Stays, outcome: Outcome::Delivered, as_wanted: true };
/// let label = Happens { meets: Some(meets), ends: vec![end; 2], broken_off: false };
/// let stretch = FeedStretchReport::new(scene.feeder(), &Stretch { label, first: 0.2, last: 0.5 });
/// let FeedEndReport { ending, outcome, as_wanted } = &stretch.parts[1];
/// assert_eq!((ending.as_str(), *outcome, *as_wanted), ("stays on it", "delivered", true));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FeedEndReport {
    /// same side, turned, face and its number; else how a run ends that never lies on the last plate.
    pub ending: String,
    /// How its run ends: it is followed until it has left the last plate or rests.
    pub outcome: &'static str,
    /// True where it ends as is wanted, and leaves the feeder or does what one alone does.
    pub as_wanted: bool,
}

/// Intervals at which the same happens.
///
/// # Example
/// At intervals from 0.2 s to 0.5 s parts touch, and all end as wanted.
/// ```
/// # use carom_scene::*;
/// # use carom_feeder::{Doing, Outcome, StageName};
/// # use carom_study::{Ending, feeds::{End, Happens, Meets}, stretches::Stretch};
/// # let scene = Scene::read("../../examples/feed.toml".as_ref())?;
/// let slides = Doing { stage: Some(StageName::Slide), obstacle: 1 };
/// let doing = [slides, Doing { stage: None, obstacle: 0 }];
/// let meets = Meets { parts: [0, 1], doing, blocked: true };
/// let report = FeedMeetingReport::new(scene.feeder(), &meets);
/// let end = End { ending: Ending::Stays, outcome: Outcome::Delivered, as_wanted: true };
/// let label = Happens { meets: Some(meets), ends: vec![end; 2], broken_off: false };
/// let stretch = FeedStretchReport::new(scene.feeder(), &Stretch { label, first: 0.2, last: 0.5 });
/// assert_eq!((stretch.from_s, stretch.to_s, stretch.what), (0.2, 0.5, "as_wanted"));
/// assert_eq!(stretch.first, Some(report));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FeedStretchReport {
    /// The shortest interval of them that was followed [s].
    pub from_s: f64,
    /// The longest interval of them that was followed [s].
    pub to_s: f64,
    /// no_touch, as_wanted (parts touch, and all end as wanted), otherwise (one at least does not), blocked (a part cannot start) or unresolved
    /// (more meet at once than is resolved).
    pub what: &'static str,
    /// How parts are first in each other's way; null where none is.
    pub first: Option<FeedMeetingReport>,
    /// What becomes of each part.
    pub parts: Vec<FeedEndReport>,
}

/// The smallest interval above which parts do not touch.
///
/// # Example
/// A part every half second; where nothing is known of how they touch, null.
/// ```
/// use carom_scene::SmallestIntervalReport;
/// let smallest = SmallestIntervalReport {
///     interval_s: 0.5, touching_s: 0.4999, below: "as_wanted", parts_per_minute: 60.0 / 0.5,
///     limited_by: Some("lower".into()), first: None,
/// };
/// let json = serde_json::to_value(smallest)?;
/// assert!(json["parts_per_minute"] == 120.0 && json["first"].is_null());
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SmallestIntervalReport {
    /// Parts do not touch at this interval [s].
    pub interval_s: f64,
    /// They do at this one, the longest that was seen, or it is not resolved whether they do [s].
    pub touching_s: f64,
    /// What happens at that one, as in the stretches.
    pub below: &'static str,
    /// 60 s over the interval.
    pub parts_per_minute: f64,
    /// The plate that limits it: the one that the part ahead is on.
    pub limited_by: Option<String>,
    /// How they touch at the longest interval at which they do.
    pub first: Option<FeedMeetingReport>,
}

/// The longest interval at which the way of one part alone meets itself.
///
/// # Example
/// A disc of 0.06 m that starts from rest at 6 m/s² is out of its own way after `√(4·0.06/6)` = 0.2 s.
/// ```
/// use carom_scene::OwnMeetingReport;
/// let json = serde_json::to_value(OwnMeetingReport { low_s: 0.1999, high_s: 0.2001 })?;
/// let out_of_its_way = (4.0 * 0.06 / 6.0_f64).sqrt();
/// assert!(json["low_s"].as_f64().is_some_and(|low| low < out_of_its_way));
/// assert!(json["high_s"].as_f64().is_some_and(|high| out_of_its_way < high));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct OwnMeetingReport {
    /// It does at this interval [s].
    pub low_s: f64,
    /// It does at none above this [s].
    pub high_s: f64,
}

/// One part alone.
///
/// # Example
/// ```
/// use carom_scene::{AloneReport, Scene};
/// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
/// let run = scene.feeder().run_untraced().unwrap();
/// let ending = carom_study::Ending::of(&run, 1).to_string();
/// let alone = AloneReport { ending, outcome: run.outcome.word(), end_s: run.end_time };
/// assert_eq!((alone.ending.as_str(), alone.outcome), ("turned", "landed"));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct AloneReport {
    /// How it ends on the last plate.
    pub ending: String,
    /// How its run ends.
    pub outcome: &'static str,
    /// When [s].
    pub end_s: f64,
}

/// A scene that was saved: `carom run` follows it again.
///
/// # Example
/// The scene that is saved is fed at that interval.
/// ```
/// use carom_scene::{SavedFeedReport, Scene};
/// let scene = Scene::read("../../examples/feed.toml".as_ref())?;
/// let saved = SavedFeedReport { file: "free.toml".into(), why: "free", interval_s: 0.75 };
/// let written = Scene::parse(&saved.file, &scene.text_fed(2, saved.interval_s)?)?;
/// assert_eq!(written.feed().map(|feed| feed.interval), Some(0.75));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SavedFeedReport {
    /// Its file, beside the summary.
    pub file: String,
    /// touches: the longest interval with a touch; otherwise: the longest at which a part ends otherwise; free: the smallest free of touch.
    pub why: &'static str,
    /// The interval [s].
    pub interval_s: f64,
}

/// The summary of a search for the interval of a feed.
///
/// # Example
/// Where parts come to rest there is no smallest interval: null.
/// ```
/// use carom_scene::{AloneReport, FeedStudyReport, StudyRunReport};
/// let report = FeedStudyReport {
///     scene: "mine".into(), approximations: vec![], parts: 2, friction: 0.2, restitution: 0.0, wanted: "turned".into(),
///     accuracy_s: 1e-6, alone: AloneReport { ending: "turned".into(), outcome: "stuck", end_s: 1.5 },
///     smallest: None, piles_up: true, own_meeting: None, stretches: vec![], unresolved_s: 0.0,
///     saved: vec![], feeds: 100,
///     run: StudyRunReport { drops: 200, seconds: 0.5, threads: 2 },
/// };
/// assert_eq!(report.run.drops, report.parts * report.feeds);
/// assert!(serde_json::to_value(report)?["smallest"].is_null());
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "carom feed")]
pub struct FeedStudyReport {
    /// Name of the scene.
    pub scene: String,
    /// How the computed part differs from the drawn one; absent where it does not.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub approximations: Vec<Approximation>,
    /// Number of parts that are fed.
    pub parts: usize,
    /// Friction coefficient between parts.
    pub friction: f64,
    /// Coefficient of restitution between parts.
    pub restitution: f64,
    /// What is wanted: as the scene says, or as one part alone ends.
    pub wanted: String,
    /// How finely changes are located [s].
    pub accuracy_s: f64,
    /// One part alone, followed until it has left the last plate or rests.
    pub alone: AloneReport,
    /// The smallest interval above which parts do not touch; null where there is none.
    pub smallest: Option<SmallestIntervalReport>,
    /// True where parts come to rest on the feeder, and are in the way of later ones at every interval.
    pub piles_up: bool,
    /// The longest interval at which the way of one part meets itself, found without any feed; null where it comes to rest.
    pub own_meeting: Option<OwnMeetingReport>,
    /// What happens at which interval, from the shortest to the longest that was followed.
    pub stretches: Vec<FeedStretchReport>,
    /// What of these lies between changes that were not followed [s].
    pub unresolved_s: f64,
    /// Scenes that were saved.
    pub saved: Vec<SavedFeedReport>,
    /// Feeds that were followed.
    pub feeds: usize,
    /// What it took; a drop is one part of one feed.
    pub run: StudyRunReport,
}

impl FeedMeetingReport {
    /// Of a meeting on this feeder.
    ///
    /// # Example
    /// ```
    /// # use carom_scene::*;
    /// # use carom_feeder::{Doing, Outcome, StageName};
    /// # use carom_study::{Ending, feeds::{End, Happens, Meets}, stretches::Stretch};
    /// # let scene = Scene::read("../../examples/feed.toml".as_ref())?;
    /// let slides = Doing { stage: Some(StageName::Slide), obstacle: 1 };
    /// let doing = [slides, Doing { stage: None, obstacle: 0 }];
    /// let meets = Meets { parts: [0, 1], doing, blocked: true };
    /// let report = FeedMeetingReport::new(scene.feeder(), &meets);
    /// assert_eq!(report.parts, meets.parts.map(|part| part + 1));
    /// assert_eq!(report.doing[0].plate, scene.feeder().plates[1].name);
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn new(feeder: &Feeder, meets: &Meets) -> Self {
        let doing = |doing: Doing| DoingReport {
            stage: doing.stage.map(|stage| stage.word()),
            plate: feeder.obstacle_name(doing.obstacle).to_owned(),
        };
        Self {
            parts: meets.parts.map(|part| part + 1),
            doing: meets.doing.map(doing),
            blocked: meets.blocked,
        }
    }
}

impl FeedStretchReport {
    /// Of a stretch of intervals.
    ///
    /// # Example
    /// ```
    /// # use carom_scene::*;
    /// # use carom_feeder::{Doing, Outcome, StageName};
    /// # use carom_study::{Ending, feeds::{End, Happens, Meets}, stretches::Stretch};
    /// # let scene = Scene::read("../../examples/feed.toml".as_ref())?;
    /// let slides = Doing { stage: Some(StageName::Slide), obstacle: 1 };
    /// let doing = [slides, Doing { stage: None, obstacle: 0 }];
    /// let meets = Meets { parts: [0, 1], doing, blocked: true };
    /// let report = FeedMeetingReport::new(scene.feeder(), &meets);
    /// let end = End { ending: Ending::Stays, outcome: Outcome::Delivered, as_wanted: true };
    /// let label = Happens { meets: Some(meets), ends: vec![end; 2], broken_off: false };
    /// let stretch = FeedStretchReport::new(scene.feeder(), &Stretch { label, first: 0.2, last: 0.5 });
    /// assert_eq!((stretch.parts.len(), stretch.what), (2, carom_study::feeds::Kind::Harmless.word()));
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn new(feeder: &Feeder, stretch: &Stretch<Happens>) -> Self {
        let end = |end: &End| FeedEndReport {
            ending: end.ending.to_string(),
            outcome: end.outcome.word(),
            as_wanted: end.as_wanted,
        };
        Self {
            from_s: stretch.first,
            to_s: stretch.last,
            what: stretch.label.kind().word(),
            first: stretch.label.meets.as_ref().map(|meets| FeedMeetingReport::new(feeder, meets)),
            parts: stretch.label.ends.iter().map(end).collect(),
        }
    }
}
