//! Files to checked models, and results to files.
//!
//! - [`Scene`]: a feeder's drawing in TOML, with units and tolerances; every problem in one [`Problems`];
//! - [`mod@unit`], [`quantity`]: what a quantity may be written in;
//! - [`ImpactProblem`]: one impact, in TOML or JSON, and its [`ImpactAnswer`];
//! - [`RollProblem`]: a body that rolls, rocks or pivots, and its [`RollRun`] through its strikes;
//! - [`RunReport`], [`ImpactAnswerReport`], [`RollReport`], [`RegionsReport`]: results as JSON; [`schema`]: their schemas and the scene's.

mod angles;
mod approximation;
mod assemble;
mod chain;
pub mod columns;
mod contact_table;
mod crossing;
mod design_report;
mod design_space;
mod drag;
mod drawing;
mod drawn;
pub mod editing;
mod face_report;
mod feed;
mod feed_report;
mod feed_study_report;
mod fields;
mod fit_report;
mod fitted;
mod force_answer;
mod force_report;
mod form;
mod grammar;
mod impact_answer;
mod impact_axes;
mod impact_bodies;
mod impact_contacts;
mod impact_end_report;
mod impact_event_report;
mod impact_file;
mod impact_operator;
mod impact_report;
mod impact_space;
mod impact_space_bodies;
mod impact_space_read;
mod impact_space_report;
mod impact_space_stage_report;
mod impact_touch;
mod impact_verdict;
mod inequality_report;
pub mod input;
mod json;
mod json_text;
mod label;
mod layout;
mod library;
mod limits;
mod line_error;
mod lines;
mod located_report;
mod map_report;
mod measures;
mod node;
mod outline;
mod part;
mod part_drawing;
mod part_throws;
mod problem;
pub mod quantity;
mod read_design;
mod read_library;
mod read_outline;
mod read_part;
mod read_plate;
mod read_scene;
mod regions_report;
mod roll;
mod run_end_report;
mod run_impact_report;
mod run_report;
mod scene;
pub mod schema;
mod space;
mod start;
mod suggest;
mod surfaces;
mod sweep_report;
mod tolerance;
pub mod unit;
mod variants;
mod varied;
mod visit;
mod wanted;
mod word;
mod write;
mod yield_report;

pub use angles::{angle_to_normal, incidence};
pub use approximation::{Approximation, ApproximationKind};
pub use carom_study::design::Aim;
pub use design_report::*;
pub use design_space::DesignSpace;
pub use drag::{Grip, Hold, Snap};
pub use drawing::{Design, Free, Side, Want};
pub use drawn::Drawn;
pub use face_report::{FaceReport, SolidFaceReport};
pub use feed_report::*;
pub use feed_study_report::*;
pub use fields::Field;
pub use fit_report::*;
pub use fitted::Fitted;
pub use force_answer::{ForceAnswer, ForceMotion, ForceRejected};
pub use force_report::*;
pub use form::Form;
pub use impact_answer::{Deciders, Examined, ImpactAnswer, Shared, Walk};
pub use impact_axes::{ImpactNumber, ImpactTemplate};
pub use impact_bodies::Group;
pub use impact_contacts::{ImpactContacts, MOST_PIVOTED};
pub use impact_end_report::*;
pub use impact_event_report::*;
pub use impact_file::{ContactPlaces, Convention, ImpactBody, ImpactProblem};
pub use impact_report::*;
pub use impact_space::{AnyImpact, SpatialImpactAnswer, SpatialImpactProblem};
pub use impact_space_bodies::SpatialGroup;
pub use impact_space_report::*;
pub use impact_space_stage_report::*;
pub use impact_verdict::*;
pub use inequality_report::*;
pub use json_text::toml_of_json;
pub use label::{label_beside, labelled};
pub use limits::FoundLimits;
pub use line_error::{LineError, LineProblem, LineProblems};
pub use located_report::*;
pub use map_report::*;
pub use measures::{Measure, MeasureAxis};
pub use part_throws::{FacesReport, PartEndReport, PartThrows, Thrown};
pub use problem::{Problem, ProblemKind, Problems};
pub use regions_report::*;
pub use roll::spatial::{
    ClosedFormReport, PoseEndReport, PoseReport, PoseThrowReport, PyramidShape, RestingReport,
    SpatialContactReport, SpatialDrawing, SpatialEndReport, SpatialEndStateReport, SpatialForkReport,
    SpatialRejectedReport, SpatialRollKind, SpatialRollPoseReport, SpatialRollProblem, SpatialRollReport,
    SpatialRollRun, SpatialSeriesReport, SpatialStageReport, SpatialStrike, SpatialStrikeReport,
    THROW_DIMENSIONS, Throw, ThrowRangeReport, ThrownBody, ThrownBodyReport, ThrownFaceReport, ThrownShape,
    ThrownVertexReport, TiltReport,
};
pub use roll::{
    MOST_POSES, PoseAt, PoseMark, PosesError, RollEnd, RollEndReport, RollKind, RollPose, RollPoseReport,
    RollProblem, RollProblems, RollReport, RollRun, RollStrikeReport, pose_interval,
};
pub use run_end_report::*;
pub use run_impact_report::*;
pub use run_report::*;
pub use scene::{NamedQuantity, Scene};
pub use space::{
    AnyScene, SolidThrows, SpaceContactReport, SpaceExitReport, SpaceImpactReport, SpaceRunReport,
    SpaceScene, SpaceStageReport, SpaceStateReport,
};
pub use suggest::nearest;
pub use sweep_report::*;
pub use variants::Variants;
pub use varied::Varied;
pub use wanted::Wanted;
pub use word::{EndingWord, PoseWord, Word};
pub use yield_report::*;
