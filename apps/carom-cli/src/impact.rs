//! `carom impact`: resolves one impact, or a stream of them.

mod page;
mod planes;
mod space;
pub(crate) mod text;

use crate::args::{Format, ImpactOptions, Output, is_stdin};
use crate::failure::Failure;
use crate::lines::answer_lines;
use crate::printed::tell;
use crate::{files, pipeline};
use carom_scene::{
    AnyImpact, ImpactAnswer, ImpactAnswerReport, ImpactProblem, SpatialImpactReport, toml_of_json,
};
use page::page;
use planes::{joint, planes};
use serde::Serialize;
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
    let answer = problem.solve();
    let report = ImpactAnswerReport::new(&problem, &answer);
    match output.format {
        Format::Text => {
            let mut text = text(&problem, &report, &answer.certainty());
            for (name, plane) in planes(&problem, &answer) {
                let drawn = pipeline::impulse_text(&plane);
                let drawn = if drawn.is_empty() { "it takes no impulse" } else { drawn.trim_end() };
                // Writing to a String cannot fail.
                let _ = writeln!(text, "\nimpulse plane of {name}\n{drawn}");
            }
            out.write_all(text.as_bytes())?;
        }
        Format::Json => writeln!(out, "{}", serde_json::to_string_pretty(&report)?)?,
    }
    if output.out.is_some() {
        let folder = output.folder(&title);
        draw(&problem, &answer, &folder)?;
        let page = page(&title, &source, &problem, (&answer, &report));
        write_report(&folder, &page, &report)?;
    }
    // What was found is told, and that it is not the answer.
    answer.undone().map_or(Ok(()), |why| {
        let why = carom_words::impact::failure(&problem.names, &why);
        Err(Failure::Undone(format!("no answer: {why}")))
    })
}

/// Writes the page and the answer of an impact.
fn write_report(folder: &Path, page: &str, answer: &impl Serialize) -> Result<(), Failure> {
    files::write(folder, "impact.json", &format!("{}\n", serde_json::to_string_pretty(answer)?))?;
    let path = files::write(folder, "report.html", page)?;
    tell(&format!("report {}", path.display()));
    Ok(())
}

/// The walk as one picture, or the impulse plane of the one contact.
fn draw(problem: &ImpactProblem, answer: &ImpactAnswer, folder: &Path) -> Result<(), Failure> {
    if let Some(walk) = joint(problem, answer) {
        let path = files::write(folder, "impulse-walk.svg", &pipeline::joint_svg(&walk))?;
        tell(&format!("impulse walk {}", path.display()));
        return Ok(());
    }
    for (name, plane) in planes(problem, answer) {
        let file = format!("impulse-plane-{}.svg", plain(&name));
        let path = files::write(folder, &file, &pipeline::impulse_svg(&plane))?;
        tell(&format!("impulse plane of {name} {}", path.display()));
    }
    Ok(())
}

/// A contact's name as part of a file's name.
fn plain(name: &str) -> String {
    name.chars().map(|c| if c.is_alphanumeric() { c } else { '-' }).collect()
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
