//! `carom schema`: the JSON Schema of what Carom reads and writes.

use crate::args::{SchemaOf, SchemaOptions};
use crate::failure::Failure;
use carom_scene::schema as schemas;
use std::io::Write;

pub(crate) fn schema(options: &SchemaOptions, out: &mut impl Write) -> Result<(), Failure> {
    let schema = match options.of {
        SchemaOf::Scene => schemas::scene(),
        SchemaOf::Run => schemas::run(),
        SchemaOf::Impact => schemas::impact(),
        SchemaOf::Roll => {
            let message = "this version has no `carom roll`, so there is no schema of it: scene, run and impact have one";
            return Err(Failure::Undone(message.into()));
        }
    };
    writeln!(out, "{}", serde_json::to_string_pretty(&schema)?)?;
    Ok(())
}
