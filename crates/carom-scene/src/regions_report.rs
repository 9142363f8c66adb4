//! What a region diagram says, as JSON: areas, boundaries, meeting points, distances to closed forms.

use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// An axis of a diagram.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RegionsAxisReport {
    /// The quantity's key.
    pub key: String,
    /// The unit of `from`, `to` and of every coordinate; empty for plain numbers.
    pub unit: String,
    /// Where it begins.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// Cells of the first grid.
    pub cells: usize,
}

/// A quantity that is no axis.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RegionsSettingReport {
    /// Its value in `unit`.
    pub value: f64,
    /// Its SI unit; empty for plain numbers.
    pub unit: String,
}

/// A label with the room it takes.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RegionsLabelReport {
    /// The label, as it stands in its region.
    pub label: String,
    /// What it is.
    pub words: String,
    /// Share of the plane, 0 to 1.
    pub area_share: f64,
    /// Nodes of the first grid that have it.
    pub grid_nodes: usize,
}

/// A boundary between two labels.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RegionsBoundaryReport {
    /// The labels on its two sides.
    pub labels: [String; 2],
    /// Points of its polyline; they are in `regions.csv`.
    pub points: usize,
    /// True where it closes upon itself.
    pub closed: bool,
}

/// A point where three or more labels meet.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RegionsJunctionReport {
    /// The labels.
    pub labels: Vec<String>,
    /// Abscissa, in the axis' unit.
    pub x: f64,
    /// Ordinate, in the axis' unit.
    pub y: f64,
    /// Size of the window that it lies in, as a share of the axes.
    pub accuracy_share: f64,
}

/// How a closed form and the engine's boundary compare.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RegionsClosedFormReport {
    /// The closed form.
    pub curve: String,
    /// Numbers of the states on its two sides.
    pub states: [u8; 2],
    /// Points of the engine's boundary between these states.
    pub boundary_points: usize,
    /// Largest distance of one of them from the curve, as a share of the axes.
    pub largest_distance_share: f64,
    /// Points of the curve, where it applies.
    pub curve_points: usize,
    /// Those on whose two sides the engine finds the two states.
    pub curve_points_confirmed: usize,
}

/// Where the outcome changes on one line of the plane, at a fixed abscissa.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RegionsThresholdReport {
    /// The abscissa, in the axis' unit.
    pub x: f64,
    /// The ordinate between two points of which the engine says one thing and the other.
    pub y: f64,
    /// How far these two points are apart.
    pub y_bracket: f64,
    /// The label below.
    pub below: String,
    /// The label above.
    pub above: String,
    /// The closed form's ordinate; null where there is none for this change.
    pub closed_form_y: Option<f64>,
}

/// On what share of the nodes of the first grid the laws leave a choice.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RegionsEndsReport {
    /// Several end states obey the laws, judged at the end alone.
    pub several_share: f64,
    /// The staged impact, which gives the label, ends in none of them: the end depends on the way there.
    pub not_reached_share: f64,
    /// The staged impact met several ways on, and one was chosen.
    pub branching_share: f64,
}

/// What a diagram took.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RegionsWorkReport {
    /// Points at which the engine was asked.
    pub evaluations: usize,
}

/// The summary of a region diagram.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "carom regions")]
pub struct RegionsReport {
    /// Name of the diagram, and of its folder.
    pub diagram: String,
    /// What it shows.
    pub title: String,
    /// Abscissa and ordinate.
    pub axes: [RegionsAxisReport; 2],
    /// The quantities that are no axis, by key.
    pub settings: BTreeMap<String, RegionsSettingReport>,
    /// The labels.
    pub labels: Vec<RegionsLabelReport>,
    /// The boundaries.
    pub boundaries: Vec<RegionsBoundaryReport>,
    /// Where three or more labels meet.
    pub junctions: Vec<RegionsJunctionReport>,
    /// Comparisons with closed forms, where there are any.
    pub closed_forms: Vec<RegionsClosedFormReport>,
    /// Points of boundaries between labels for which there is no closed form.
    pub points_without_closed_form: usize,
    /// Where the laws leave a choice; null where it is not examined.
    pub ends: Option<RegionsEndsReport>,
    /// Where the outcome changes on single lines: of a pyramid at every whole number of sides; empty for other diagrams.
    pub thresholds: Vec<RegionsThresholdReport>,
    /// What else a person should know.
    pub remarks: Vec<String>,
    /// What it took.
    pub work: RegionsWorkReport,
}
