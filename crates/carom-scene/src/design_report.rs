//! What an inverse design says, as JSON.

use crate::approximation::Approximation;
use crate::map_report::StudyRunReport;
use crate::run_report::ExitReport;
use crate::space::SpaceExitReport;
use crate::word::{EndingWord, Word};
use crate::yield_report::ProbabilityReport;
use carom_feeder::Outcome;
use carom_study::design::{Aim, Demand};
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// A layout.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DesignLayoutReport {
    /// The quantities that were chosen, SI.
    pub chosen: BTreeMap<String, f64>,
    /// Share of drops that end as wanted within the limits, under the tolerances.
    #[serde(rename = "yield")]
    pub probability: ProbabilityReport,
    /// The same with every tolerance doubled.
    pub yield_doubled: ProbabilityReport,
    /// The hardest strike on a plate, the first or a later one, where nothing varies [m/s].
    pub impact_speed_m_s: f64,
    /// The largest slip velocity [m/s].
    pub sliding_speed_m_s: f64,
    /// From the highest end of a plate to the lowest [m].
    pub height_m: f64,
    /// From the leftmost end of a plate to the rightmost [m].
    pub width_m: f64,
    /// When the run ends [s].
    pub time_s: f64,
}

/// The worst of the winner's drops within their tolerances.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DesignWorstReport {
    /// The hardest strike on a plate, the first or a later one [m/s].
    pub impact_speed_m_s: f64,
    /// The largest slip velocity [m/s].
    pub sliding_speed_m_s: f64,
    /// When the longest run ends [s].
    pub time_s: f64,
    /// How many drops were looked at.
    pub drops: u64,
    /// True where none of them exceeds a limit on speed or time.
    pub limits_hold: bool,
}

/// What a demand forbids.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ForbiddenReport {
    /// The demand.
    pub demand: Word<Demand>,
    /// Layouts of the first look that fail it.
    pub failed: u64,
    /// Those that fail it and no other.
    pub alone: u64,
    /// The nearest to the limit of these, SI; null where there is none, or the demand has no measure.
    pub nearest: Option<f64>,
    /// The limit, SI; null where the demand has no measure.
    pub limit: Option<f64>,
}

/// An end of a quantity's range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RangeEnd {
    /// The lower one.
    Low,
    /// The upper one.
    High,
}

carom_words::words! {
    RangeEnd {
        Low = "low",
        High = "high",
    }
}

/// How the part leaves the last plate: the pose of a part that moves in the plane, place and attitude of a solid one.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum DesignExitReport {
    /// In the plane.
    Plane(ExitReport),
    /// In space.
    Space(SpaceExitReport),
}

/// How the part comes to lie on a plate.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DeliveredReport {
    /// Name of the plate.
    pub plate: String,
    /// How it ends there.
    pub ending: EndingWord,
}

/// The answer to an inverse design.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "carom design")]
pub struct DesignReport {
    /// Name of the scene.
    pub scene: String,
    /// How the computed part differs from the drawn one; absent where it does not.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub approximations: Vec<Approximation>,
    /// found, or not possible.
    #[schemars(extend("enum" = ["found", "not possible"]))]
    pub outcome: &'static str,
    /// What is aimed at: yield, height or time.
    pub aim: Word<Aim>,
    /// The best layout, with values that a workshop can keep.
    pub winner: Option<DesignLayoutReport>,
    /// The worst of its drops within their tolerances; null without a winner.
    pub worst: Option<DesignWorstReport>,
    /// Its quantities that are at an end of their range, with `low` or `high`: a wider range may do better.
    pub at_range_ends: BTreeMap<String, Word<RangeEnd>>,
    /// How often it strikes each wall where nothing varies; walls that it does not touch are absent.
    pub wall_strikes: BTreeMap<String, usize>,
    /// How the part is delivered: the ending on every plate but the first, in order, in words.
    pub delivered: Vec<String>,
    /// The same as data.
    pub endings: Vec<DeliveredReport>,
    /// How it leaves the last plate, where nothing varies; null where it does not, and without a winner.
    pub exit: Option<DesignExitReport>,
    /// How the winner's run ends that is followed as far as the part goes: `delivered`, or why it is not.
    pub ends: Option<Word<Outcome>>,
    /// Layouts none of which is worse than another in yield, height and impact speed at once.
    pub front: Vec<DesignLayoutReport>,
    /// What the demands forbid, by the first look.
    pub forbidden: Vec<ForbiddenReport>,
    /// Layouts of the first look.
    pub scanned: u64,
    /// Those of them that meet every demand where nothing varies.
    pub met: u64,
    /// What every random number comes from.
    pub seed: u64,
    /// What it took.
    pub run: StudyRunReport,
}
