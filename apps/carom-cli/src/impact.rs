//! `carom impact`: resolves one impact, or a stream of them.

mod page;
mod planes;
mod space;
mod text;

use crate::args::{Format, ImpactOptions, Output};
use crate::failure::Failure;
use crate::{files, pipeline};
use carom_scene::{AnyImpact, ImpactAnswer, ImpactAnswerReport, ImpactProblem, SpatialImpactReport};
use page::page;
use planes::{joint, planes};
use serde_json::json;
use std::fmt::Write as _;
use std::io::{BufRead, Write};
use std::path::Path;
use text::text;

pub(crate) fn impact(options: &ImpactOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    if options.file == Path::new("-") {
        return stream(&mut std::io::stdin().lock(), out);
    }
    let file = options.file.display().to_string();
    let source = files::read_input(&options.file)?;
    let problem = match AnyImpact::parse(&file, &source)? {
        AnyImpact::Planar(problem) => *problem,
        AnyImpact::Spatial(problem) => {
            let title = options.file.file_stem().unwrap_or_default().to_string_lossy();
            return space::impact(&problem, (&title, &source), output, out);
        }
    };
    let answer = problem.solve();
    let report = ImpactAnswerReport::new(&problem, &answer);
    match output.format {
        Format::Text => {
            let mut text = text(&problem, &report);
            for (name, plane) in planes(&problem, &answer) {
                // Writing to a String cannot fail.
                let _ = writeln!(
                    text,
                    "\nimpulse plane of {name}\n{}",
                    pipeline::impulse_text(&plane).trim_end()
                );
            }
            out.write_all(text.as_bytes())?;
        }
        Format::Json => writeln!(out, "{}", serde_json::to_string_pretty(&report)?)?,
    }
    if let Some(folder) = &output.out {
        draw(&problem, &answer, folder)?;
        let title = options.file.file_stem().unwrap_or_default().to_string_lossy();
        let page = page(&title, &source, &problem, (&answer, &report));
        let path = files::write(folder, "report.html", &page)?;
        writeln!(std::io::stderr(), "report {}", path.display())?;
    }
    // What was found is told, and that it is not the answer.
    answer.undone().map_or(Ok(()), |why| Err(Failure::Undone(format!("no answer: {why}"))))
}

/// The walk as one picture, or the impulse plane of the one contact.
fn draw(problem: &ImpactProblem, answer: &ImpactAnswer, folder: &Path) -> Result<(), Failure> {
    if let Some(walk) = joint(problem, answer) {
        let path = files::write(folder, "impulse-walk.svg", &pipeline::joint_svg(&walk))?;
        writeln!(std::io::stderr(), "impulse walk {}", path.display())?;
        return Ok(());
    }
    for (name, plane) in planes(problem, answer) {
        let file = format!("impulse-plane-{}.svg", plain(&name));
        let path = files::write(folder, &file, &pipeline::impulse_svg(&plane))?;
        writeln!(std::io::stderr(), "impulse plane of {name} {}", path.display())?;
    }
    Ok(())
}

/// A contact's name as part of a file's name.
fn plain(name: &str) -> String {
    name.chars().map(|c| if c.is_alphanumeric() { c } else { '-' }).collect()
}

/// One JSON object a line in, one a line out, in order. A line with problems is answered by them, and the exit code says so in the end.
pub(crate) fn stream(input: &mut impl BufRead, out: &mut impl Write) -> Result<(), Failure> {
    let mut bad = 0usize;
    for (i, line) in input.lines().enumerate() {
        let line = line.map_err(|error| Failure::file("read", Path::new("stdin"), &error))?;
        if line.trim().is_empty() {
            continue;
        }
        let text = match AnyImpact::parse_json(&format!("line {}", i + 1), &line) {
            Ok(AnyImpact::Planar(problem)) => {
                serde_json::to_string(&ImpactAnswerReport::new(&problem, &problem.solve()))?
            }
            Ok(AnyImpact::Spatial(problem)) => {
                serde_json::to_string(&SpatialImpactReport::new(&problem, &problem.solve()))?
            }
            Err(problems) => {
                bad += 1;
                let list: Vec<_> =
                    problems.list.iter().map(|p| json!({ "path": p.path, "message": p.message })).collect();
                json!({ "line": i + 1, "problems": list }).to_string()
            }
        };
        writeln!(out, "{text}")?;
    }
    match bad {
        0 => Ok(()),
        1 => Err(Failure::Usage("1 line has problems".into())),
        bad => Err(Failure::Usage(format!("{bad} lines have problems"))),
    }
}
