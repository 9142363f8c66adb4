//! What a search for the interval of a feed says, as JSON.

use crate::approximation::Approximation;
use crate::map_report::StudyRunReport;
use crate::word::{EndingWord, Word};
use carom_feeder::{Doing, Outcome, StageName};
use carom_study::feeds::Kind;
use carom_study::feeds::{End, Happens, Meets};
use carom_study::stretches::Stretch;
use carom_words::part::Names;
use schemars::JsonSchema;
use serde::Serialize;

/// What a part was doing.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DoingReport {
    /// Its stage, as in the result of a run; null where it has just been put on the first plate.
    pub stage: Option<Word<StageName>>,
    /// The plate or wall it is on; in flight, the one it was on last.
    pub plate: String,
}

/// How two parts are in each other's way.
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
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FeedEndReport {
    /// same side, turned, face and its number; else how a run ends that never lies on the last plate.
    pub ending: EndingWord,
    /// How its run ends: it is followed until it has left the last plate or rests.
    pub outcome: Word<Outcome>,
    /// True where it ends as is wanted, and leaves the feeder or does what one alone does.
    pub as_wanted: bool,
}

/// Intervals at which the same happens.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FeedStretchReport {
    /// The shortest interval of them that was followed [s].
    pub from_s: f64,
    /// The longest interval of them that was followed [s].
    pub to_s: f64,
    /// no_touch, as_wanted (parts touch, and all end as wanted), otherwise (one at least does not), touch (solid parts touch, and are not followed on), blocked (a part cannot start) or
    /// unresolved (more meet at once than is resolved).
    pub what: Word<Kind>,
    /// How parts are first in each other's way; null where none is.
    pub first: Option<FeedMeetingReport>,
    /// What becomes of each part. Of solid parts that do not touch what becomes of one, as of all; of those that touch it is not followed, and the list is empty.
    pub parts: Vec<FeedEndReport>,
}

/// The smallest interval above which parts do not touch.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SmallestIntervalReport {
    /// Parts do not touch at this interval [s].
    pub interval_s: f64,
    /// They do at this one, the longest that was seen, or it is not resolved whether they do [s].
    pub touching_s: f64,
    /// What happens at that one, as in the stretches.
    pub below: Word<Kind>,
    /// 60 s over the interval.
    pub parts_per_minute: f64,
    /// The plate that limits it: the one that the part ahead is on.
    pub limited_by: Option<String>,
    /// How they touch at the longest interval at which they do.
    pub first: Option<FeedMeetingReport>,
}

/// The longest interval at which the way of one part alone meets itself.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct OwnMeetingReport {
    /// It does at this interval [s].
    pub low_s: f64,
    /// It does at none above this [s].
    pub high_s: f64,
}

/// One part alone.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct AloneReport {
    /// How it ends on the last plate.
    pub ending: EndingWord,
    /// How its run ends.
    pub outcome: Word<Outcome>,
    /// When [s].
    pub end_s: f64,
}

/// A scene that was saved: `carom run` follows it again.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SavedFeedReport {
    /// Its file, beside the summary.
    pub file: String,
    /// touches: the longest interval with a touch; otherwise: the longest at which a part ends otherwise; free: the smallest free of touch.
    #[schemars(extend("enum" = ["touches", "otherwise", "free"]))]
    pub why: &'static str,
    /// The interval [s].
    pub interval_s: f64,
}

/// The summary of a search for the interval of a feed.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "carom feed")]
pub struct FeedStudyReport {
    /// Name of the scene.
    pub scene: String,
    /// How the computed part differs from the drawn one; absent where it does not.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub approximations: Vec<Approximation>,
    /// Number of parts that are fed; null of solid parts: what is said is so for any number.
    pub parts: Option<usize>,
    /// Friction coefficient between parts; null of solid parts, which are followed until they touch.
    pub friction: Option<f64>,
    /// Coefficient of restitution between parts; null of solid parts.
    pub restitution: Option<f64>,
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
    /// Feeds that were followed; of solid parts one part alone.
    pub feeds: usize,
    /// What it took; a drop is one part of one feed.
    pub run: StudyRunReport,
}

impl FeedMeetingReport {
    /// Of a meeting on this feeder.
    pub fn new(feeder: &impl Names, meets: &Meets) -> Self {
        let doing = |doing: Doing| DoingReport {
            stage: doing.stage.map(Word),
            plate: feeder.given(doing.obstacle).to_owned(),
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
    pub fn new(feeder: &impl Names, stretch: &Stretch<Happens>) -> Self {
        let end = |end: &End| FeedEndReport {
            ending: EndingWord(end.ending),
            outcome: Word(end.outcome),
            as_wanted: end.as_wanted,
        };
        Self {
            from_s: stretch.first,
            to_s: stretch.last,
            what: Word(stretch.label.kind()),
            first: stretch.label.meets.as_ref().map(|meets| FeedMeetingReport::new(feeder, meets)),
            parts: stretch.label.ends.iter().map(end).collect(),
        }
    }
}
