//! What a sweep says, as JSON, and what its folder says of it.

use crate::approximation::Approximation;
use crate::map_report::StudyRunReport;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// What is swept, `_sweep.json`: part files beside it are of this and nothing else.
///
/// # Example
/// 1000 designs in parts of 300 are four parts.
/// ```
/// use carom_scene::{ColumnReport, SweepManifest};
/// let manifest = SweepManifest {
///     version: "0.1.0".into(), scene: String::new(), outline: None, plate: "lower".into(),
///     quantities: vec!["contact.friction".into()], designs: vec![], rows: 1000, rows_per_part: 300, rows_per_step: 30,
///     columns: vec![ColumnReport { name: "end_s".into(), unit: "s".into() }],
/// };
/// let json = serde_json::to_value(manifest)?;
/// let parts = json["rows"].as_u64().zip(json["rows_per_part"].as_u64()).map(|(all, one)| all.div_ceil(one));
/// assert_eq!(parts, Some(4));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SweepManifest {
    /// Version of the program.
    pub version: String,
    /// The text of the scene.
    pub scene: String,
    /// Length and fingerprint of the file that draws the part; null where the scene itself does.
    pub outline: Option<String>,
    /// The plate that is looked at.
    pub plate: String,
    /// The quantities that differ from design to design.
    pub quantities: Vec<String>,
    /// The axes of a grid, or the length and fingerprint of a list.
    pub designs: Vec<String>,
    /// Designs.
    pub rows: u64,
    /// Designs of one part file; the last one may have fewer.
    pub rows_per_part: u64,
    /// Designs that are worked through at a time, and lost at most where a sweep is stopped.
    pub rows_per_step: u64,
    /// The columns of a part file, in their order.
    pub columns: Vec<ColumnReport>,
}

/// A column of a table.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct ColumnReport {
    /// Its name.
    pub name: String,
    /// Its unit, SI; empty for words, counts and pure numbers.
    pub unit: String,
}

/// The summary of a sweep.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "carom sweep")]
pub struct SweepReport {
    /// Name of the scene.
    pub scene: String,
    /// How the computed part differs from the drawn one; absent where it does not.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub approximations: Vec<Approximation>,
    /// The plate that is looked at.
    pub plate: String,
    /// Designs whose rows are there, of all shards.
    pub rows: u64,
    /// Designs in all.
    pub designs: u64,
    /// How often each ending occurs among the rows.
    pub endings: BTreeMap<String, u64>,
    /// The columns of the part files, in their order.
    pub columns: Vec<ColumnReport>,
    /// Folder of the part files.
    pub folder: String,
    /// What this shard took: nothing for parts that were there.
    pub run: StudyRunReport,
}
