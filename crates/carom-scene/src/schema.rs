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
pub fn scene() -> Schema {
    schema_for!(SceneFile)
}

/// Of the result of a run.
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
pub fn impact() -> Schema {
    schema_for!(AnyImpactReport)
}

/// Of the summary of an outcome map.
pub fn map() -> Schema {
    schema_for!(MapReport)
}

/// Of the summary of a yield study.
pub fn yields() -> Schema {
    schema_for!(YieldReport)
}

/// Of the answer to an inverse design.
pub fn design() -> Schema {
    schema_for!(DesignReport)
}

/// Of the summary of a search for the interval of a feed.
pub fn feed() -> Schema {
    schema_for!(FeedStudyReport)
}

/// Of the summary of a sweep.
pub fn sweep() -> Schema {
    schema_for!(SweepReport)
}

/// Of the summary of a region diagram.
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
pub fn roll() -> Schema {
    schema_for!(AnyRollReport)
}
