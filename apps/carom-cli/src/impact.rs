//! `carom impact`: resolves one impact, or a stream of them.

mod space;
pub(crate) mod text;

use crate::args::{Format, ImpactOptions, Output, is_stdin};
use crate::failure::Failure;
use crate::lines::answer_lines;
use crate::printed::tell;
use crate::{files, pipeline};
use carom::tasks::impact::ImpactStudy;
use carom_scene::{AnyImpact, ImpactAnswerReport, SpatialImpactReport, toml_of_json};
use std::fmt::Write as _;
use std::io::Write;
use std::path::Path;
use text::text;

pub(crate) fn impact(options: &ImpactOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    if is_stdin(&options.file) {
        return answer_lines(&mut std::io::stdin().lock(), out, answer);
    }
    let file = options.file.display().to_string();
    let source = files::read_input(&options.file)?;
    let title = options.file.file_stem().unwrap_or_default().to_string_lossy();
    let problem = match AnyImpact::parse(&file, &source)? {
        AnyImpact::Planar(problem) => *problem,
        AnyImpact::Spatial(problem) => {
            return space::impact(&problem, (&title, &source), output, out);
        }
    };
    let study = ImpactStudy::of(problem);
    let ImpactStudy { problem, answer, report } = &study;
    match output.format {
        Format::Text => {
            let mut text = text(problem, report, &answer.certainty());
            for (name, plane) in study.planes() {
                let drawn = pipeline::impulse_text(&plane);
                let drawn = if drawn.is_empty() { "it takes no impulse" } else { drawn.trim_end() };
                // Writing to a String cannot fail.
                let _ = writeln!(text, "\nimpulse plane of {name}\n{drawn}");
            }
            out.write_all(text.as_bytes())?;
        }
        Format::Json => writeln!(out, "{}", serde_json::to_string_pretty(report)?)?,
    }
    if output.out.is_some() {
        write_all(&study.files(&title, &source)?, &output.folder(&title))?;
    }
    // What was found is told, and that it is not the answer.
    answer.undone().map_or(Ok(()), |why| {
        let why = carom_words::impact::failure(&problem.names, &why);
        Err(Failure::Undone(format!("no answer: {why}")))
    })
}

/// Writes the files of an impact and says where they are.
fn write_all<N: AsRef<str>>(files: &[(N, String)], folder: &Path) -> Result<(), Failure> {
    for (name, text) in files {
        let name = name.as_ref();
        let path = files::write(folder, name, text)?;
        let path = path.display();
        match name.strip_suffix(".svg").map(|picture| picture.replace("impulse-", "impulse ")) {
            Some(picture) => tell(&format!("{} {path}", picture.replace("plane-", "plane of "))),
            None if name == "report.html" => tell(&format!("report {path}")),
            None => {}
        }
    }
    Ok(())
}

/// The answer to one line.
pub(crate) fn answer(name: &str, line: &str) -> Result<String, Failure> {
    Ok(match AnyImpact::parse(name, &toml_of_json(name, line)?)? {
        AnyImpact::Planar(problem) => {
            serde_json::to_string(&ImpactAnswerReport::new(&problem, &problem.solve()))?
        }
        AnyImpact::Spatial(problem) => {
            serde_json::to_string(&SpatialImpactReport::new(&problem, &problem.solve()))?
        }
    })
}
