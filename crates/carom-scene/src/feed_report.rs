//! What several parts did, as JSON.

use crate::run_impact_report::{ImpactReport, impact_report};
use crate::run_report::{ExitReport, PlateReport, StageReport, exit_report, plate_report, stage_report};
use crate::word::Word;
use carom_feeder::Outcome;
use carom_feeder::{FedPart, Feed, FeedRun, Feeder};
use schemars::JsonSchema;
use serde::Serialize;

/// Several parts, one after the other.
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
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FedPartReport {
    /// Its number, from 1.
    pub part: usize,
    /// When it started [s].
    pub entered_s: f64,
    /// As of a run of one part; or blocked: it did not start, for another part stood in its place; or unresolved: more contacts met at once
    /// than could be resolved.
    pub outcome: Word<Outcome>,
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
        outcome: Word(run.outcome),
        end_s: run.end_time,
        plates: run.landings.iter().map(|landing| plate_report(feeder, landing)).collect(),
        exit: run.exit.as_ref().map(exit_report),
        stages: run.stages.iter().map(|stage| stage_report(feeder, stage)).collect(),
        impacts: run.trace.impacts.iter().map(|impact| impact_report(feeder, impact)).collect(),
    }
}
