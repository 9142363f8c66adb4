//! `carom contact`: bodies that touch, under forces: which motions are consistent at this instant.

use crate::args::{ContactOptions, Format, Output, is_stdin};
use crate::failure::Failure;
use crate::files;
use crate::impact::text::hypotheses_text;
use crate::lines::answer_lines;
use crate::printed::tell;
use crate::table::fixed;
use carom::tasks::impact::words::forces_headline;
use carom_scene::{Certainty, ForceAnswerReport, ForceMotionReport, ImpactProblem, Uniqueness, toml_of_json};
use carom_words::aligned;
use std::fmt::Write as _;
use std::io::Write;

pub(crate) fn contact(
    options: &ContactOptions,
    output: &Output,
    out: &mut impl Write,
) -> Result<(), Failure> {
    if is_stdin(&options.file) {
        return answer_lines(&mut std::io::stdin().lock(), out, |name, line| {
            let problem = ImpactProblem::parse(name, &toml_of_json(name, line)?)?;
            let answer = problem.under_forces(name)?;
            Ok(serde_json::to_string(&ForceAnswerReport::new(&problem, &answer))?)
        });
    }
    let file = options.file.display().to_string();
    let source = files::read_input(&options.file)?;
    let problem = ImpactProblem::parse(&file, &source)?;
    let answer = problem.under_forces(&file)?;
    let report = ForceAnswerReport::new(&problem, &answer);
    match output.format {
        Format::Text => out.write_all(text(&report, &answer.certainty()).as_bytes())?,
        Format::Json => writeln!(out, "{}", serde_json::to_string_pretty(&report)?)?,
    }
    if output.out.is_some() {
        let name = options.file.file_stem().unwrap_or_default().to_string_lossy();
        let json = format!("{}\n", serde_json::to_string_pretty(&report)?);
        let path = files::write(&output.folder(&name), "contact.json", &json)?;
        tell(&format!("answer {}", path.display()));
    }
    Ok(())
}

fn text(report: &ForceAnswerReport, certainty: &Certainty) -> String {
    let mut text = format!("{}\n", forces_headline(report, certainty));
    for (i, motion) in report.solutions.iter().enumerate() {
        let number =
            if report.count > 1 { format!("{} of {}   ", i + 1, report.count) } else { String::new() };
        // Writing to a String cannot fail.
        let _ = writeln!(text, "\n{number}{}", motion.hypothesis);
        text.push_str(&motion_text(motion));
    }
    if let Some(more) = report.count.checked_sub(report.solutions.len()).filter(|more| *more > 0) {
        let _ = writeln!(text, "\n… {more} more");
    }
    if report.uniqueness == Uniqueness::NotExamined {
        text.push_str(
            "\nOf more than six contacts one motion is sought; whether there are others was not examined.\n",
        );
        return text;
    }
    let rejected = report.rejected.iter().map(|r| [&r.hypothesis, &r.because]);
    text + "\nrejected\n" + &hypotheses_text(vec![], rejected, 0)
}

fn motion_text(motion: &ForceMotionReport) -> String {
    let head = ["contact", "", "N N", "T N", "du_n/dt m/s²", "du_t/dt m/s²"].map(str::to_owned).to_vec();
    let mut rows = vec![head];
    rows.extend(motion.contacts.iter().map(|c| {
        let numbers =
            [c.normal_force, c.tangential_force, c.normal_acceleration_m_s2, c.slip_acceleration_m_s2];
        let mut row = vec![c.name.clone(), c.state.to_string()];
        row.extend(numbers.map(|number| fixed(number, 6)));
        row
    }));
    let mut text = aligned(&rows);
    let mut body = |name: &str, [x, y]: [f64; 2], spin: f64| {
        let (x, y, spin) = (fixed(x, 6), fixed(y, 6), fixed(spin, 6));
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{name:<11} acceleration {x}, {y} m/s²   spin {spin} 1/s²");
    };
    if let Some((acceleration, spin)) = motion.acceleration_m_s2.zip(motion.spin_acceleration_rad_s2) {
        body("body", acceleration, spin);
    }
    for one in &motion.bodies {
        body(&one.name, one.acceleration_m_s2, one.spin_acceleration_rad_s2);
    }
    if motion.indeterminate {
        text.push_str("the forces are one choice of many that give this motion\n");
    }
    text
}
