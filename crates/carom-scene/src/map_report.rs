//! What an outcome map says, as JSON.

use crate::regions_report::{
    RegionsAxisReport, RegionsBoundaryReport, RegionsJunctionReport, RegionsLabelReport,
};
use schemars::JsonSchema;
use serde::Serialize;

/// What a study took: kept apart from what it found, which is the same on every machine.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct StudyRunReport {
    /// Drops that were followed.
    pub drops: usize,
    /// Time it took [s].
    pub seconds: f64,
    /// Threads that worked on it.
    pub threads: usize,
}

/// The lowest and the highest of a measure among the nodes of a map.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpanReport {
    /// Lowest.
    pub low: f64,
    /// Highest.
    pub high: f64,
}

/// The summary of an outcome map.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "carom map")]
pub struct MapReport {
    /// Name of the scene.
    pub scene: String,
    /// The plate that is looked at.
    pub plate: String,
    /// Abscissa and ordinate.
    pub axes: [RegionsAxisReport; 2],
    /// How finely boundaries are located, as a share of the axes.
    pub accuracy_share: f64,
    /// The outcomes: same side, turned, face and its number, or how a run ends that never lies on the plate.
    pub labels: Vec<RegionsLabelReport>,
    /// The boundaries between them.
    pub boundaries: Vec<RegionsBoundaryReport>,
    /// Where three or more outcomes meet.
    pub junctions: Vec<RegionsJunctionReport>,
    /// Speed at which the plate is first struck, over the nodes where the part lies on it [m/s]; null where it never does.
    pub impact_speed_m_s: Option<SpanReport>,
    /// When the part first lies flat on the plate, over the nodes [s].
    pub flat_s: Option<SpanReport>,
    /// Share of the plane that was not looked into: cells that hold more than was followed when they were as small as allowed.
    pub unresolved_share: f64,
    /// What it took.
    pub run: StudyRunReport,
}
