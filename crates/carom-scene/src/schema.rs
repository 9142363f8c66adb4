//! JSON Schemas of what Carom reads and writes.

use crate::design_report::DesignReport;
use crate::face_report::SolidFaceReport;
use crate::feed_study_report::FeedStudyReport;
use crate::fit_report::FitReport;
use crate::force_report::ForceAnswerReport;
use crate::form::Form;
use crate::grammar::schema::{DIALECT, of_files};
use crate::impact_report::ImpactAnswerReport;
use crate::impact_space_report::SpatialImpactReport;
use crate::line_error::LineError;
use crate::located_report::LocatedReport;
use crate::map_report::MapReport;
use crate::part_throws::FacesReport;
use crate::regions_report::RegionsReport;
use crate::roll::RollReport;
use crate::roll::spatial::{PoseReport, SpatialRollReport};
use crate::run_report::RunReport;
use crate::space::SpaceRunReport;
use crate::sweep_report::SweepReport;
use crate::yield_report::YieldReport;
use schemars::generate::SchemaSettings;
use schemars::transform::RecursiveTransform;
use schemars::{JsonSchema, Schema};
use serde_json::{Value, json};

/// Of a scene.
///
/// # Example
/// A scene has a part and plates, in the plane as in space.
/// ```
/// let schema = carom_scene::schema::scene().to_value();
/// let keys = schema["$defs"]["SpaceScene"]["properties"].as_object().unwrap();
/// assert!(keys.contains_key("part") && keys.contains_key("plate"));
/// ```
pub fn scene() -> Schema {
    file(Form::Scene)
}

/// Of the faces of a part and its throws.
///
/// # Example
/// ```
/// let schema = carom_scene::schema::faces().to_value();
/// assert!(schema["properties"].as_object().unwrap().contains_key("faces"));
/// ```
pub fn faces() -> Schema {
    of::<FacesReport>()
}

/// Of the faces of a solid part and its throws.
///
/// # Example
/// ```
/// let schema = carom_scene::schema::space_faces().to_value();
/// assert_eq!(schema["title"], "carom faces: in space");
/// assert!(schema["$defs"].as_object().unwrap().contains_key("SolidFaceReport"));
/// ```
pub fn space_faces() -> Schema {
    let mut schema = of::<FacesReport<SolidFaceReport>>();
    schema.insert("title".to_owned(), "carom faces: in space".into());
    schema
}

/// Of the result of a run in space.
///
/// # Example
/// ```
/// let schema = carom_scene::schema::space_run().to_value();
/// assert!(schema["properties"].as_object().unwrap().contains_key("faces"));
/// ```
pub fn space_run() -> Schema {
    of::<SpaceRunReport>()
}

/// Of the result of a run.
///
/// # Example
/// ```
/// let schema = carom_scene::schema::run().to_value();
/// assert!(schema["properties"].as_object().unwrap().contains_key("outcome"));
/// ```
pub fn run() -> Schema {
    of::<RunReport>()
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
    of::<AnyImpactReport>()
}

/// Of the answer to contacts under forces.
///
/// # Example
/// ```
/// let schema = carom_scene::schema::contact().to_value();
/// assert!(schema["properties"].as_object().unwrap().contains_key("solutions"));
/// ```
pub fn contact() -> Schema {
    of::<ForceAnswerReport>()
}

/// Of the answer to a line of input that has problems.
///
/// # Example
/// ```
/// let schema = carom_scene::schema::line_error().to_value();
/// assert!(schema["properties"].as_object().unwrap().contains_key("error"));
/// ```
pub fn line_error() -> Schema {
    of::<LineError>()
}

/// Of the summary of an outcome map.
///
/// # Example
/// ```
/// let schema = carom_scene::schema::map().to_value();
/// assert!(schema["properties"].as_object().unwrap().contains_key("boundaries"));
/// ```
pub fn map() -> Schema {
    of::<MapReport>()
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
    of::<YieldReport>()
}

/// Of the summary of a yield that was located.
///
/// # Example
/// ```
/// let schema = carom_scene::schema::located().to_value();
/// assert!(schema["properties"].as_object().unwrap().contains_key("yield"));
/// ```
pub fn located() -> Schema {
    of::<LocatedReport>()
}

/// Of the summary of a fit.
///
/// # Example
/// ```
/// let schema = carom_scene::schema::fit().to_value();
/// assert!(schema["properties"].as_object().unwrap().contains_key("not_told_apart"));
/// ```
pub fn fit() -> Schema {
    of::<FitReport>()
}

/// Of the answer to an inverse design.
///
/// # Example
/// ```
/// let schema = carom_scene::schema::design().to_value();
/// assert!(schema["properties"].as_object().unwrap().contains_key("winner"));
/// ```
pub fn design() -> Schema {
    of::<DesignReport>()
}

/// Of the summary of a search for the interval of a feed.
///
/// # Example
/// ```
/// let schema = carom_scene::schema::feed().to_value();
/// assert!(schema["properties"].as_object().unwrap().contains_key("smallest"));
/// ```
pub fn feed() -> Schema {
    of::<FeedStudyReport>()
}

/// Of the summary of a sweep.
///
/// # Example
/// ```
/// let schema = carom_scene::schema::sweep().to_value();
/// assert!(schema["properties"].as_object().unwrap().contains_key("endings"));
/// ```
pub fn sweep() -> Schema {
    of::<SweepReport>()
}

/// Of the summary of a region diagram.
///
/// # Example
/// ```
/// let schema = carom_scene::schema::regions().to_value();
/// assert!(schema["properties"].as_object().unwrap().contains_key("junctions"));
/// ```
pub fn regions() -> Schema {
    of::<RegionsReport>()
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
    of::<AnyRollReport>()
}

/// Of anything that is written. Descriptions end where the documentation goes on with an example in Rust.
///
/// # Example
/// ```
/// /// A grain of sand.
/// ///
/// /// # Example
/// /// `Grain { mass: 1e-5 }`
/// #[derive(schemars::JsonSchema)]
/// #[expect(dead_code)]
/// struct Grain {
///     mass: f64,
/// }
/// let schema = carom_scene::schema::of::<Grain>().to_value();
/// assert_eq!(schema["description"], "A grain of sand.");
/// ```
pub fn of<T: JsonSchema>() -> Schema {
    let settings = SchemaSettings::default().with_transform(RecursiveTransform(without_example));
    settings.into_generator().into_root_schema_for::<T>()
}

/// Of a kind of file that is read.
///
/// # Example
/// A cylinder has a radius.
/// ```
/// use carom_scene::{Form, RollKind, schema};
/// let schema = schema::file(Form::Roll(RollKind::Cylinder)).to_value();
/// assert!(schema["properties"].as_object().unwrap().contains_key("radius"));
/// ```
pub fn file(form: Form) -> Schema {
    let file = form.file();
    Schema::try_from(of_files(file.title, &[file])).unwrap_or_default()
}

/// Of an impact, or of contacts under forces.
pub fn impact_file() -> Schema {
    file(Form::Impact)
}

/// Of a roll file: that of any kind of body.
pub fn roll_file() -> Schema {
    let rolls = Form::ALL.into_iter().filter(|form| matches!(form, Form::Roll(_) | Form::SpatialRoll(_)));
    let files: Vec<_> = rolls.map(Form::file).collect();
    Schema::try_from(of_files("carom roll: input", &files)).unwrap_or_default()
}

/// Of a list of designs, `carom sweep --list`: a CSV file is an object a line, its first line are the keys.
pub fn list() -> Schema {
    let schema = json!({
        "$schema": DIALECT,
        "title": "carom sweep: list of designs",
        "description": "Rows of a CSV file. Its first line names quantities by their paths in the scene, every other gives each of them a value.",
        "type": "array",
        "minItems": 1,
        "items": {
            "type": "object",
            "description": "A path, as `carom run --limits` lists them (`plate.lower.slope`), with a number in SI or a text with a unit.",
            "minProperties": 1,
            "additionalProperties": { "type": ["number", "string"] },
        },
    });
    Schema::try_from(schema).unwrap_or_default()
}

/// Of the runs that `carom fit` reads: a CSV file is an object a line, its first line are the keys.
///
/// # Example
/// ```
/// let schema = carom_scene::schema::runs().to_value();
/// assert!(schema["items"]["properties"].as_object().unwrap().contains_key("drops"));
/// ```
pub fn runs() -> Schema {
    let schema = json!({
        "$schema": DIALECT,
        "title": "carom fit: runs",
        "description": "Rows of a CSV file. Its first line names the columns; every other tells of one drop, or of many that were alike.",
        "type": "array",
        "minItems": 1,
        "items": {
            "type": "object",
            "description": "A row has an outcome, a face or a time. A key that is a path of the scene (`plate.upper.slope`) says how that quantity was set for the row.",
            "properties": {
                "outcome": { "type": "string", "description": "How the drop ended on the plate that is looked at: `same side`, `turned`, `face 2`, or `stuck`, `delivered`, `missed`, …" },
                "face": { "type": "integer", "minimum": 0, "description": "Number of the face on which it lies there." },
                "time": { "type": ["number", "string"], "description": "From the start until it lies flat there, or until the run ends [s]." },
                "scatter": { "type": ["number", "string"], "description": "Standard deviation of the time [s]." },
                "drops": { "type": "integer", "minimum": 1, "default": 1, "description": "How many drops the row tells of." },
            },
            "additionalProperties": { "type": ["number", "string"] },
        },
    });
    Schema::try_from(schema).unwrap_or_default()
}

/// An example in Rust is for who reads the documentation; a description ends before it.
fn without_example(schema: &mut Schema) {
    let description = schema.get("description").and_then(Value::as_str);
    let Some((words, _)) = description.and_then(|words| words.split_once("# Example")) else { return };
    let words = words.trim_end().to_owned();
    schema.insert("description".to_owned(), words.into());
}
