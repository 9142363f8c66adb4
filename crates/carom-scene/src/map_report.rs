//! What an outcome map says, as JSON.

use crate::approximation::Approximation;
use crate::regions_report::{
    RegionsAxisReport, RegionsBoundaryReport, RegionsJunctionReport, RegionsLabelReport,
};
use crate::word::EndingWord;
use schemars::JsonSchema;
use serde::Serialize;

/// What a study took: kept apart from what it found, which is the same on every machine.
///
/// # Example
/// ```
/// use carom_scene::StudyRunReport;
/// let json = serde_json::to_string(&StudyRunReport { drops: 1000, seconds: 0.5, threads: 2 })?;
/// assert_eq!(json, r#"{"drops":1000,"seconds":0.5,"threads":2}"#);
/// # Ok::<(), serde_json::Error>(())
/// ```
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

/// How many cells end in a way.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CellsEndingReport {
    /// same side, turned, face and its number; else how a run ends that never lies on the plate.
    pub ending: EndingWord,
    /// Cells.
    pub cells: usize,
}

/// The cells of a map: each ends as the drop at its middle does, which was followed or lies in a region whose boundaries were.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CellsReport {
    /// Cells across.
    pub columns: usize,
    /// Cells up.
    pub rows: usize,
    /// How they end; all of them are in the table of cells.
    pub endings: Vec<CellsEndingReport>,
}

/// The summary of an outcome map.
///
/// # Example
/// One ending fills the whole map: (4 + 1)² nodes.
/// ```
/// use carom_scene::*;
/// let (unit, from, to, cells) = (String::from("m"), 0.0, 2.0, 4);
/// let axis = |key: &str| RegionsAxisReport { key: key.into(), unit: unit.clone(), from, to, cells };
/// let (label, words) = ("T".into(), "turned".into());
/// let all = RegionsLabelReport { label, words, area_share: 1.0, grid_nodes: 5 * 5 };
/// let report = MapReport {
///     scene: "mine".into(), approximations: vec![], plate: "lower".into(), axes: [axis("start.to_edge"), axis("plate.lower.drop")],
///     accuracy_share: 1e-9, labels: vec![all], boundaries: vec![], junctions: vec![],
///     impact_speed_m_s: Some(SpanReport { low: 1.0, high: 3.0 }), flat_s: None, unresolved_share: 0.0, cells: None,
///     run: StudyRunReport { drops: 25, seconds: 0.5, threads: 2 },
/// };
/// let json = serde_json::to_value(report)?;
/// assert!(json["labels"][0]["grid_nodes"] == 25 && json["flat_s"].is_null());
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "carom map")]
pub struct MapReport {
    /// Name of the scene.
    pub scene: String,
    /// How the computed part differs from the drawn one; absent where it does not.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub approximations: Vec<Approximation>,
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
    /// A finer grid than that of the axes, every cell of which has its ending; absent where it was not asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cells: Option<CellsReport>,
    /// What it took.
    pub run: StudyRunReport,
}
