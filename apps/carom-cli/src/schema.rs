//! `carom schema`: the JSON Schema of what Carom reads and writes.

use crate::args::{Output, SchemaOf, SchemaOptions};
use crate::failure::Failure;
use crate::files;
use crate::printed::tell;
use carom_scene::schema as schemas;
use std::io::Write;

pub(crate) fn schema(options: &SchemaOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    let (name, schema) = match options.of {
        SchemaOf::Scene => ("scene", schemas::scene()),
        SchemaOf::ImpactFile => ("impact-file", schemas::impact_file()),
        SchemaOf::RollFile => ("roll-file", schemas::roll_file()),
        SchemaOf::List => ("list", schemas::list()),
        SchemaOf::Run => ("run", schemas::run()),
        SchemaOf::Impact => ("impact", schemas::impact()),
        SchemaOf::Contact => ("contact", schemas::contact()),
        SchemaOf::Roll => ("roll", schemas::roll()),
        SchemaOf::Error => ("error", schemas::line_error()),
        SchemaOf::Map => ("map", schemas::map()),
        SchemaOf::Yield => ("yield", schemas::yields()),
        SchemaOf::Feed => ("feed", schemas::feed()),
        SchemaOf::Sweep => ("sweep", schemas::sweep()),
        SchemaOf::Design => ("design", schemas::design()),
        SchemaOf::Regions => ("regions", schemas::regions()),
        SchemaOf::Validate => ("validate", carom_validation::schema()),
    };
    let text = format!("{}\n", serde_json::to_string_pretty(&schema)?);
    out.write_all(text.as_bytes())?;
    if let Some(folder) = &output.out {
        let path = files::write(folder, &format!("carom-{name}.schema.json"), &text)?;
        tell(&format!("schema {}", path.display()));
    }
    Ok(())
}
