//! JSON Schemas of what Carom reads and writes.

use crate::design_report::DesignReport;
use crate::feed_study_report::FeedStudyReport;
use crate::impact_report::ImpactAnswerReport;
use crate::impact_space_report::SpatialImpactReport;
use crate::map_report::MapReport;
use crate::regions_report::RegionsReport;
use crate::roll::RollReport;
use crate::roll::spatial::{PoseReport, SpatialRollReport};
use crate::run_report::RunReport;
use crate::schema_scene::SceneFile;
use crate::sweep_report::SweepReport;
use crate::yield_report::YieldReport;
use schemars::{JsonSchema, Schema, schema_for};

/// Of a scene.
///
/// # Example
/// A scene has a part and plates.
/// ```
/// let schema = carom_scene::schema::scene().to_value();
/// let keys = schema["properties"].as_object().unwrap();
/// assert!(keys.contains_key("part") && keys.contains_key("plate"));
/// ```
pub fn scene() -> Schema {
    schema_for!(SceneFile)
}

/// Of the result of a run.
///
/// # Example
/// ```
/// let schema = carom_scene::schema::run().to_value();
/// assert!(schema["properties"].as_object().unwrap().contains_key("outcome"));
/// ```
pub fn run() -> Schema {
    schema_for!(RunReport)
}

/// What `carom impact` prints.
#[derive(JsonSchema)]
#[schemars(untagged, title = "carom impact", extend("type" = "object"))]
#[expect(dead_code, reason = "only its schema is wanted")]
enum AnyImpactReport {
    /// Of an impact in the plane.
    Planar(Box<ImpactAnswerReport>),
    /// Of an impact in space.
    Spatial(Box<SpatialImpactReport>),
}

/// Of the answer to an impact, in the plane or in space.
///
/// # Example
/// Of the plane or of space.
/// ```
/// let schema = carom_scene::schema::impact().to_value();
/// assert_eq!(schema["anyOf"].as_array().map(Vec::len), Some(2));
/// ```
pub fn impact() -> Schema {
    schema_for!(AnyImpactReport)
}

/// Of the summary of an outcome map.
///
/// # Example
/// ```
/// let schema = carom_scene::schema::map().to_value();
/// assert!(schema["properties"].as_object().unwrap().contains_key("boundaries"));
/// ```
pub fn map() -> Schema {
    schema_for!(MapReport)
}

/// Of the summary of a yield study.
///
/// # Example
/// `yield` is no name in Rust, but it is the key.
/// ```
/// let schema = carom_scene::schema::yields().to_value();
/// assert!(schema["properties"].as_object().unwrap().contains_key("yield"));
/// ```
pub fn yields() -> Schema {
    schema_for!(YieldReport)
}

/// Of the answer to an inverse design.
///
/// # Example
/// ```
/// let schema = carom_scene::schema::design().to_value();
/// assert!(schema["properties"].as_object().unwrap().contains_key("winner"));
/// ```
pub fn design() -> Schema {
    schema_for!(DesignReport)
}

/// Of the summary of a search for the interval of a feed.
///
/// # Example
/// ```
/// let schema = carom_scene::schema::feed().to_value();
/// assert!(schema["properties"].as_object().unwrap().contains_key("smallest"));
/// ```
pub fn feed() -> Schema {
    schema_for!(FeedStudyReport)
}

/// Of the summary of a sweep.
///
/// # Example
/// ```
/// let schema = carom_scene::schema::sweep().to_value();
/// assert!(schema["properties"].as_object().unwrap().contains_key("endings"));
/// ```
pub fn sweep() -> Schema {
    schema_for!(SweepReport)
}

/// Of the summary of a region diagram.
///
/// # Example
/// ```
/// let schema = carom_scene::schema::regions().to_value();
/// assert!(schema["properties"].as_object().unwrap().contains_key("junctions"));
/// ```
pub fn regions() -> Schema {
    schema_for!(RegionsReport)
}

/// What `carom roll` prints.
#[derive(JsonSchema)]
#[schemars(untagged, title = "carom roll", extend("type" = "object"))]
#[expect(dead_code, clippy::large_enum_variant, reason = "only its schema is wanted")]
enum AnyRollReport {
    /// Of a cylinder, prism or rod: in the plane.
    Planar(RollReport),
    /// Of a pyramid, a stool or a body: in space.
    Spatial(SpatialRollReport),
    /// Of many throws of a body.
    Poses(PoseReport),
}

/// Of the strikes of a body that rolls, in the plane or in space.
///
/// # Example
/// In the plane, in space, or of many throws.
/// ```
/// let schema = carom_scene::schema::roll().to_value();
/// assert_eq!(schema["anyOf"].as_array().map(Vec::len), Some(3));
/// ```
pub fn roll() -> Schema {
    schema_for!(AnyRollReport)
}
