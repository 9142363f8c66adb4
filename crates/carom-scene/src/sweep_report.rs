//! What a sweep says, as JSON, and what its folder says of it.

use crate::map_report::StudyRunReport;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// What is swept, `_sweep.json`: part files beside it are of this and nothing else.
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
}

/// The summary of a sweep.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "carom sweep")]
pub struct SweepReport {
    /// Name of the scene.
    pub scene: String,
    /// The plate that is looked at.
    pub plate: String,
    /// Designs whose rows are there, of all shards.
    pub rows: u64,
    /// Designs in all.
    pub designs: u64,
    /// How often each ending occurs among the rows.
    pub endings: BTreeMap<String, u64>,
    /// Folder of the part files.
    pub folder: String,
    /// What this shard took: nothing for parts that were there.
    pub run: StudyRunReport,
}
