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
///
/// # Example
/// Below y = 0.6 there are three of five rows of nodes, and 0.6 of the plane.
/// ```
/// use carom_scene::*;
/// use carom_study::regions::{Options, Range, find};
/// let side = Range { from: 0.0, to: 1.0, count: 4 };
/// let label = |x: f64, y: f64| if y < 0.6 { 0_u8 } else if x < 0.3 { 1 } else { 2 };
/// let found = find(side, side, &Options::default(), label).unwrap();
/// let (area_share, grid_nodes) = (found.shares[0].area, found.shares[0].nodes);
/// let report = RegionsLabelReport { label: "0".into(), words: "below".into(), area_share, grid_nodes };
/// assert!((report.area_share - 0.6).abs() < 1e-8 && report.grid_nodes == 3 * 5);
/// ```
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
///
/// # Example
/// Three regions that meet have a boundary for each two of them.
/// ```
/// use carom_scene::*;
/// use carom_study::regions::{Options, Range, find};
/// let side = Range { from: 0.0, to: 1.0, count: 4 };
/// let label = |x: f64, y: f64| if y < 0.6 { 0_u8 } else if x < 0.3 { 1 } else { 2 };
/// let found = find(side, side, &Options::default(), label).unwrap();
/// let report = |b: &carom_study::regions::Boundary<u8>| RegionsBoundaryReport {
///     labels: b.pair.map(|label| label.to_string()), points: b.points.len(), closed: b.closed,
/// };
/// let reports: Vec<_> = found.boundaries.iter().map(report).collect();
/// assert!(reports.len() == 3 && reports.iter().all(|b| !b.closed && b.points > 1));
/// ```
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
///
/// # Example
/// All three meet at (0.3, 0.6).
/// ```
/// use carom_scene::*;
/// use carom_study::regions::{Options, Range, find};
/// let side = Range { from: 0.0, to: 1.0, count: 4 };
/// let label = |x: f64, y: f64| if y < 0.6 { 0_u8 } else if x < 0.3 { 1 } else { 2 };
/// let found = find(side, side, &Options::default(), label).unwrap();
/// let meet = &found.junctions[0];
/// let labels = meet.labels.iter().map(ToString::to_string).collect();
/// let [x, y] = meet.at;
/// let report = RegionsJunctionReport { labels, x, y, accuracy_share: meet.accuracy };
/// assert!((report.x - 0.3).abs() < 2e-9 && (report.y - 0.6).abs() < 2e-9);
/// ```
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
///
/// # Example
/// The engine's boundary against the line x = 0.3: all of its points are within the accuracy.
/// ```
/// use carom_scene::*;
/// use carom_study::regions::{Options, Range, find};
/// let side = Range { from: 0.0, to: 1.0, count: 4 };
/// let label = |x: f64, y: f64| if y < 0.6 { 0_u8 } else if x < 0.3 { 1 } else { 2 };
/// let found = find(side, side, &Options::default(), label).unwrap();
/// let line = found.boundaries.iter().find(|b| b.pair == [1, 2]).unwrap();
/// let far = |point: &[f64; 2]| (point[0] - 0.3).abs();
/// let report = RegionsClosedFormReport {
///     curve: "x = 0.3".into(), states: [1, 2], boundary_points: line.points.len(),
///     largest_distance_share: line.points.iter().map(far).fold(0.0, f64::max),
///     curve_points: 0, curve_points_confirmed: 0,
/// };
/// assert!(report.boundary_points > 1 && report.largest_distance_share < 2e-9);
/// ```
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
///
/// # Example
/// Along x = 0.1 the label changes at y = 0.6.
/// ```
/// use carom_scene::RegionsThresholdReport;
/// use carom_study::stretches::{Options, find};
/// let found = find(&[0.0, 1.0], Options { accuracy: 1e-9, most: 8 }, |y| y < 0.6, |low| *low).pieces;
/// let (last, first) = (found[0].last, found[1].first);
/// let report = RegionsThresholdReport {
///     x: 0.1, y: 0.5 * (last + first), y_bracket: first - last, below: "0".into(), above: "1".into(),
///     closed_form_y: Some(0.6),
/// };
/// assert!(report.closed_form_y.is_some_and(|y| (report.y - y).abs() <= report.y_bracket));
/// ```
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
///
/// # Example
/// Every node of the grid is asked, and what bisection needs besides.
/// ```
/// use carom_scene::*;
/// use carom_study::regions::{Options, Range, find};
/// let side = Range { from: 0.0, to: 1.0, count: 4 };
/// let label = |x: f64, y: f64| if y < 0.6 { 0_u8 } else if x < 0.3 { 1 } else { 2 };
/// let found = find(side, side, &Options::default(), label).unwrap();
/// let work = RegionsWorkReport { evaluations: found.evaluations };
/// assert!(work.evaluations > 5 * 5);
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RegionsWorkReport {
    /// Points at which the engine was asked.
    pub evaluations: usize,
}

/// The summary of a region diagram.
///
/// # Example
/// The labels share the plane among them.
/// ```
/// use carom_scene::*;
/// use carom_study::regions::{Options, Range, find};
/// let side = Range { from: 0.0, to: 1.0, count: 4 };
/// let label = |x: f64, y: f64| if y < 0.6 { 0_u8 } else if x < 0.3 { 1 } else { 2 };
/// let found = find(side, side, &Options::default(), label).unwrap();
/// let label = |s: &carom_study::regions::Share<u8>| RegionsLabelReport {
///     label: s.label.to_string(), words: String::new(), area_share: s.area, grid_nodes: s.nodes,
/// };
/// let axis = || RegionsAxisReport { key: "x".into(), unit: String::new(), from: 0.0, to: 1.0, cells: 4 };
/// let report = RegionsReport {
///     diagram: "mine".into(), title: "mine".into(), axes: [axis(), axis()], settings: [].into(),
///     labels: found.shares.iter().map(label).collect(), boundaries: vec![], junctions: vec![],
///     closed_forms: vec![], points_without_closed_form: 0, ends: None, thresholds: vec![], remarks: vec![],
///     work: RegionsWorkReport { evaluations: found.evaluations },
/// };
/// let whole: f64 = report.labels.iter().map(|label| label.area_share).sum();
/// assert!((whole - 1.0).abs() < 1e-12);
/// ```
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
