//! What several parts did, as JSON.

use crate::run_impact_report::{ImpactReport, impact_report};
use crate::run_report::{ExitReport, PlateReport, StageReport, exit_report, plate_report, stage_report};
use carom_feeder::{FedPart, Feed, FeedRun, Feeder};
use schemars::JsonSchema;
use serde::Serialize;

/// Several parts, one after the other.
///
/// # Example
/// Three parts, one every 0.9 s.
/// ```
/// # use carom_scene::*;
/// # let scene = Scene::read("../../examples/feed.toml".as_ref())?;
/// # let (feeder, feed) = (scene.feeder(), scene.feed().unwrap());
/// # let run = feeder.prepare(carom_motion::planar::Options::default()).unwrap().feed(feed).unwrap();
/// let report = FeedReport::new(feeder, feed, &run);
/// assert_eq!((report.parts.len(), report.interval_s, report.friction), (3, 0.9, 0.2));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FeedReport {
    /// Time from one part's start to the next [s].
    pub interval_s: f64,
    /// Friction coefficient between parts.
    pub friction: f64,
    /// Coefficient of restitution between parts.
    pub restitution: f64,
    /// When nothing was left to decide [s].
    pub end_s: f64,
    /// Why it was broken off there, where it was.
    pub broken_off: Option<String>,
    /// The parts, in order; their times count from the first part's start.
    pub parts: Vec<FedPartReport>,
    /// The first contact of each two parts that touch, in order of time.
    pub contacts: Vec<FeedContactReport>,
}

/// One of several parts.
///
/// # Example
/// The third part starts two intervals after the first.
/// ```
/// # use carom_scene::*;
/// # let scene = Scene::read("../../examples/feed.toml".as_ref())?;
/// # let (feeder, feed) = (scene.feeder(), scene.feed().unwrap());
/// # let run = feeder.prepare(carom_motion::planar::Options::default()).unwrap().feed(feed).unwrap();
/// let report = FeedReport::new(feeder, feed, &run);
/// let last: &FedPartReport = &report.parts[2];
/// assert_eq!((last.part, last.entered_s), (3, 2.0 * 0.9));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FedPartReport {
    /// Its number, from 1.
    pub part: usize,
    /// When it started [s].
    pub entered_s: f64,
    /// As of a run of one part; or blocked: it did not start, for another part stood in its place; or unresolved: more contacts met at once
    /// than could be resolved.
    pub outcome: &'static str,
    /// When that was decided [s].
    pub end_s: f64,
    /// The plates it landed on, in order of landing.
    pub plates: Vec<PlateReport>,
    /// How it left over the last plate's edge; null unless delivered.
    pub exit: Option<ExitReport>,
    /// The stages, in order of time, to the end of the feed.
    pub stages: Vec<StageReport>,
    /// The impacts, in order of time; `another part` is what it struck where it struck no plate or wall.
    pub impacts: Vec<ImpactReport>,
}

/// Two parts that touch.
///
/// # Example
/// A later part strikes the one ahead, after it has started itself.
/// ```
/// # use carom_scene::*;
/// # let scene = Scene::read("../../examples/feed.toml".as_ref())?;
/// # let (feeder, feed) = (scene.feeder(), scene.feed().unwrap());
/// # let run = feeder.prepare(carom_motion::planar::Options::default()).unwrap().feed(feed).unwrap();
/// let report = FeedReport::new(feeder, feed, &run);
/// let FeedContactReport { parts: [ahead, behind], t_s, .. } = report.contacts[0];
/// assert!(ahead < behind && t_s > report.parts[behind - 1].entered_s);
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FeedContactReport {
    /// Their numbers, from 1.
    pub parts: [usize; 2],
    /// When they touch first [s].
    pub t_s: f64,
    /// Speed of the points that strike each other then [m/s]; null where they come to touch without a strike.
    pub speed_m_s: Option<f64>,
}

impl FeedReport {
    /// The report of a feed.
    ///
    /// # Example
    /// Each contact of the feed is told, with the parts numbered from 1.
    /// ```
    /// # use carom_scene::*;
    /// # let scene = Scene::read("../../examples/feed.toml".as_ref())?;
    /// # let (feeder, feed) = (scene.feeder(), scene.feed().unwrap());
    /// # let run = feeder.prepare(carom_motion::planar::Options::default()).unwrap().feed(feed).unwrap();
    /// let report = FeedReport::new(feeder, feed, &run);
    /// assert_eq!(report.contacts.len(), run.contacts.len());
    /// assert_eq!(report.contacts[0].parts, run.contacts[0].parts.map(|part| part + 1));
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn new(feeder: &Feeder, feed: &Feed, run: &FeedRun) -> Self {
        let contact = |c: &carom_feeder::Contact| FeedContactReport {
            parts: c.parts.map(|part| part + 1),
            t_s: c.time,
            speed_m_s: c.speed,
        };
        Self {
            interval_s: feed.interval,
            friction: feed.between.friction,
            restitution: feed.between.restitution,
            end_s: run.end_time,
            broken_off: run.broken_off.as_ref().map(ToString::to_string),
            parts: run.parts.iter().enumerate().map(|(i, part)| part_report(feeder, i, part)).collect(),
            contacts: run.contacts.iter().map(contact).collect(),
        }
    }
}

fn part_report(feeder: &Feeder, number: usize, part: &FedPart) -> FedPartReport {
    let run = &part.run;
    FedPartReport {
        part: number + 1,
        entered_s: part.entered,
        outcome: run.outcome.word(),
        end_s: run.end_time,
        plates: run.landings.iter().map(|landing| plate_report(feeder, landing)).collect(),
        exit: run.exit.as_ref().map(exit_report),
        stages: run.stages.iter().map(|stage| stage_report(feeder, stage)).collect(),
        impacts: run.trace.impacts.iter().map(|impact| impact_report(feeder, impact)).collect(),
    }
}
