//! The referee of engines: cases whose answers are known, and a judge of the answers that others give.
//!
//! A [`Case`] is one line of JSON: an impact file or a scene in SI numbers, every answer that its law allows, what other laws and
//! conventions say, and where all of this comes from. [`cases`] makes them: the same ones each time, from closed forms where there are
//! some. [`judge`] compares the [`Answer`]s of an engine with them.

mod answer;
mod case;
mod cases;
mod judge;
mod motion;
mod report;
mod tolerance;

pub use answer::{Answer, read_answers, twice};
pub use case::{Body, Case, Expected, Known, PartOfDrop, Place, PlateOfDrop, Spin, World, read_cases};
pub use cases::{cases, of_group};
pub use judge::{Judged, Verdict, judge};
pub use report::{EngineReport, GroupReport, JudgeReport, Spread};

/// The JSON Schema of a line of a case file.
pub fn case_schema() -> schemars::Schema {
    carom_scene::schema::of::<Case>()
}

/// The JSON Schema of a line of an answer file.
pub fn answer_schema() -> schemars::Schema {
    carom_scene::schema::of::<Answer>()
}

/// The JSON Schema of what the judge says.
pub fn judge_schema() -> schemars::Schema {
    carom_scene::schema::of::<JudgeReport>()
}
