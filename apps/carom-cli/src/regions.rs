//! `carom regions`: region diagrams of what the engine says.

use crate::args::{Format, Output, RegionsOptions, RegionsWord};
use crate::failure::Failure;
use crate::files;
use crate::printed::with_files;
use carom::tasks::axes::Asker;
use carom::tasks::regions::{RegionsAsked, RegionsOf, RegionsStudy, RegionsSubject};
use std::io::Write;

pub(crate) fn regions(
    options: &RegionsOptions,
    output: &Output,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let (name, text);
    let of = match (options.of, &options.file) {
        (Some(word), _) => RegionsSubject::Kind(kind(word)),
        (None, Some(path)) => {
            (name, text) = (path.display().to_string(), files::read_input(path)?);
            RegionsSubject::File(&name, &text)
        }
        (None, None) => {
            return Err(Failure::Usage("name a kind of strike, or an impact file with --file".to_owned()));
        }
    };
    let asked = RegionsAsked {
        of,
        set: &options.set,
        axes: [options.x.as_deref(), options.y.as_deref()],
        elastic: options.elastic,
        depth: options.depth,
        asker: Asker::Command,
    };
    deliver(RegionsStudy::drawn(&asked, || {})?, output, out)
}

fn kind(word: RegionsWord) -> RegionsOf {
    match word {
        RegionsWord::Cylinder => RegionsOf::Cylinder,
        RegionsWord::Prism => RegionsOf::Prism,
        RegionsWord::Rod => RegionsOf::Rod,
        RegionsWord::Strike => RegionsOf::Strike,
        RegionsWord::Pyramid => RegionsOf::Pyramid,
        RegionsWord::Contact => RegionsOf::Contact,
        RegionsWord::Stool => RegionsOf::Stool,
        RegionsWord::StoolStrike => RegionsOf::StoolStrike,
    }
}

/// Writes the files of a diagram and says what came out.
fn deliver(study: RegionsStudy, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    let summary = format!("{}\n", serde_json::to_string_pretty(&study.report)?);
    let folder = output.folder(&study.slug);
    let mut written = files::write_drawing(&folder, "regions", &study.svg)?;
    written.push(files::write(&folder, "regions.csv", &study.csv)?);
    written.extend(files::write_table(&folder, "regions.parquet", study.table)?);
    written.push(files::write(&folder, "regions.json", &summary)?);
    match output.format {
        Format::Text => out.write_all(with_files(study.text, &written).as_bytes())?,
        Format::Json => out.write_all(summary.as_bytes())?,
    }
    Ok(())
}
