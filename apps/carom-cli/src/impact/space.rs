//! An impact in space for a person: the walk, every way on at each of its stages, and the law under which nothing slides.

use crate::args::{Format, Output};
use crate::failure::Failure;
use crate::impact::text::hypotheses_text;
use crate::impact::write_all;
use crate::table::fixed;
use carom::tasks::impact::space::{SpatialImpactStudy, lead, triple, verdict};
use carom_impact::spatial::Freedom;
use carom_scene::{
    ImpactAxes, SpatialBodyReport, SpatialHypothesisReport, SpatialImpactContactReport,
    SpatialImpactEndReport, SpatialImpactProblem, SpatialWalkStageReport,
};
use carom_words::aligned;
use std::fmt::Write as _;
use std::io::Write;

/// An impact at so many contacts takes well below a second.
const QUICK: usize = 5;
/// Stages shown to a person.
const MOST_STAGES: usize = 12;

/// Resolves it and says what came out.
pub(super) fn impact(
    problem: &SpatialImpactProblem,
    (title, source): (&str, &str),
    output: &Output,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let count = problem.names.len();
    if count > QUICK {
        writeln!(
            std::io::stderr(),
            "{count} contacts: at every stage every hypothesis is tried, which may take seconds"
        )?;
    }
    let study = SpatialImpactStudy::of(problem.clone());
    let report = &study.report;
    match output.format {
        Format::Text => out.write_all(text(&study).as_bytes())?,
        Format::Json => writeln!(out, "{}", serde_json::to_string_pretty(report)?)?,
    }
    if output.out.is_some() {
        let json = format!("{}\n", serde_json::to_string_pretty(report)?);
        let files = [("impact.json", json), ("report.html", study.page(title, source))];
        write_all(&files, &output.folder(title))?;
    }
    Ok(())
}

fn text(study: &SpatialImpactStudy) -> String {
    let report = &study.report;
    let mut text = format!("{}\n{}\n\n", verdict(report).to_uppercase(), lead(report));
    if let Some(end) = &report.end {
        text += &end_text(end, report.axes);
    }
    if let Some(said) = study.closed_form() {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "\n{said}");
    }
    for (k, stage) in report.stages.iter().take(MOST_STAGES).enumerate() {
        text += &stage_text(k + 1, stage);
    }
    if let Some(more) = report.stages.len().checked_sub(MOST_STAGES).filter(|more| *more > 0) {
        let _ = writeln!(text, "\n… {more} more stages, all with --format json");
    }
    text += "\nif nothing could slide, without restitution\n";
    let kept = report.non_sliding.iter().map(|kept| {
        let needs = kept
            .friction_demand
            .map_or("no friction is enough".to_owned(), |mu| format!("needs friction {}", fixed(mu, 6)));
        [kept.hypothesis.clone(), format!("consistent, {needs}")]
    });
    if report.non_sliding.is_empty() {
        text += "  no state is consistent\n";
    }
    text + &hypotheses_text(
        kept.collect(),
        told(&report.non_sliding_rejected),
        report.non_sliding_rejected_left_out,
    )
}

/// Each of several bodies after the impact.
fn bodies_text(end: &SpatialImpactEndReport) -> String {
    if end.bodies.is_empty() {
        return String::new();
    }
    let head = ["body", "velocity m/s", "spin rad/s"].map(str::to_owned).to_vec();
    let row = |body: &SpatialBodyReport| {
        vec![body.name.clone(), triple(body.velocity_m_s), triple(body.spin_rad_s)]
    };
    aligned(&std::iter::once(head).chain(end.bodies.iter().map(row)).collect::<Vec<_>>()) + "\n"
}

fn end_text(end: &SpatialImpactEndReport, axes: ImpactAxes) -> String {
    let [impulse, velocity] = match axes {
        ImpactAxes::File => ["impulse N s", "velocity m/s"],
        ImpactAxes::Contact => ["impulse N s (t1, t2, n)", "velocity m/s (t1, t2, n)"],
    };
    let head = ["contact", "state", impulse, velocity].map(str::to_owned).to_vec();
    let row = |c: &SpatialImpactContactReport| {
        vec![c.name.clone(), c.state.as_str().to_owned(), triple(c.impulse), triple(c.velocity_m_s)]
    };
    let mut text = aligned(&std::iter::once(head).chain(end.contacts.iter().map(row)).collect::<Vec<_>>());
    text.push('\n');
    if let Some((velocity, spin)) = end.velocity_m_s.zip(end.spin_rad_s) {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "velocity  {} m/s", triple(velocity));
        let _ = writeln!(text, "spin      {} rad/s", triple(spin));
    }
    text += &bodies_text(end);
    if let Some((before, after)) = end.energy_before.zip(end.energy_after) {
        let _ = writeln!(text, "energy    {} J before, {} J after", fixed(before, 6), fixed(after, 6));
    }
    if end.open.0 != Freedom::None {
        let _ = writeln!(
            text,
            "open      {}: the contacts hold each other; they share as equal springs do",
            end.open
        );
    }
    if end.gained_energy {
        text += "it has more energy than before\n";
    }
    text
}

fn stage_text(number: usize, stage: &SpatialWalkStageReport) -> String {
    let does: Vec<String> =
        stage.contacts.iter().map(|c| format!("{} {}", c.name, c.state.as_str())).collect();
    let mut text =
        format!("\nstage {number}, {}: {}; until {}\n", stage.phase, does.join(", "), stage.ended_by);
    if let Some(forced) = &stage.forced {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "  no way on is consistent: {forced}");
    }
    let only = if stage.examined { "consistent" } else { "consistent; directions of others were looked for" };
    let ways = stage.ways_on.iter().map(|way| [way.clone(), only.to_owned()]);
    text + &hypotheses_text(ways.collect(), told(&stage.rejected), stage.rejected_left_out)
}

/// Rejected hypotheses, each with what rejects it.
fn told(rejected: &[SpatialHypothesisReport]) -> impl ExactSizeIterator<Item = [&String; 2]> {
    rejected.iter().map(|r| [&r.hypothesis, &r.because])
}
