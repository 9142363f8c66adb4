//! `carom schema`: the JSON Schema of what Carom reads and writes.

use crate::args::Output;
use crate::failure::Failure;
use crate::files;
use crate::printed::tell;
use carom_scene::schema as schemas;
use clap::{Args, ValueEnum};
use std::io::Write;

/// What a schema is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum SchemaOf {
    /// A scene file.
    Scene,
    /// An impact file: for `carom impact` and `carom contact`.
    ImpactFile,
    /// A roll file: for `carom roll`.
    RollFile,
    /// A list of designs: for `carom sweep --list`.
    List,
    /// The result of `carom run --format json`.
    Run,
    /// The same of a scene with a solid part.
    SpaceRun,
    /// The result of `carom faces --format json`.
    Faces,
    /// The same of a scene with a solid part.
    SpaceFaces,
    /// The result of `carom impact --format json`.
    Impact,
    /// The result of `carom contact --format json`.
    Contact,
    /// The result of `carom roll --format json`.
    Roll,
    /// The answer to a line from stdin that has problems: of `carom run -`, `impact -`, `contact -` and `roll KIND -`.
    Error,
    /// The result of `carom map --format json`.
    Map,
    /// The result of `carom yield --format json`.
    Yield,
    /// The result of `carom yield --locate --format json`.
    Located,
    /// The runs of `carom fit`.
    Runs,
    /// The result of `carom fit --format json`.
    Fit,
    /// The result of `carom feed --format json`.
    Feed,
    /// The result of `carom sweep --format json`.
    Sweep,
    /// The result of `carom design --format json`.
    Design,
    /// The result of `carom regions --format json`.
    Regions,
    /// The result of `carom validate --format json`.
    Validate,
    /// A line of `carom cases --format json`.
    Cases,
    /// A line of the answers that `carom judge` reads.
    Answers,
    /// The result of `carom judge --format json`.
    Judge,
}

#[derive(Args, Debug)]
pub(crate) struct SchemaOptions {
    /// What it is of.
    #[arg(value_enum)]
    pub(crate) of: SchemaOf,
}

pub(crate) fn schema(options: &SchemaOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    let (name, schema) = match options.of {
        SchemaOf::Scene => ("scene", schemas::scene()),
        SchemaOf::ImpactFile => ("impact-file", schemas::impact_file()),
        SchemaOf::RollFile => ("roll-file", schemas::roll_file()),
        SchemaOf::List => ("list", schemas::list()),
        SchemaOf::Run => ("run", schemas::run()),
        SchemaOf::SpaceRun => ("space-run", schemas::space_run()),
        SchemaOf::Faces => ("faces", schemas::faces()),
        SchemaOf::SpaceFaces => ("space-faces", schemas::space_faces()),
        SchemaOf::Impact => ("impact", schemas::impact()),
        SchemaOf::Contact => ("contact", schemas::contact()),
        SchemaOf::Roll => ("roll", schemas::roll()),
        SchemaOf::Error => ("error", schemas::line_error()),
        SchemaOf::Map => ("map", schemas::map()),
        SchemaOf::Yield => ("yield", schemas::yields()),
        SchemaOf::Located => ("located", schemas::located()),
        SchemaOf::Runs => ("runs", schemas::runs()),
        SchemaOf::Fit => ("fit", schemas::fit()),
        SchemaOf::Feed => ("feed", schemas::feed()),
        SchemaOf::Sweep => ("sweep", schemas::sweep()),
        SchemaOf::Design => ("design", schemas::design()),
        SchemaOf::Regions => ("regions", schemas::regions()),
        SchemaOf::Validate => ("validate", carom_validation::schema()),
        SchemaOf::Cases => ("cases", carom_referee::case_schema()),
        SchemaOf::Answers => ("answers", carom_referee::answer_schema()),
        SchemaOf::Judge => ("judge", carom_referee::judge_schema()),
    };
    let text = format!("{}\n", serde_json::to_string_pretty(&schema)?);
    out.write_all(text.as_bytes())?;
    if let Some(folder) = &output.out {
        let path = files::write(folder, &format!("carom-{name}.schema.json"), &text)?;
        tell(&format!("schema {}", path.display()));
    }
    Ok(())
}
