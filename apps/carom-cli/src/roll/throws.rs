//! `carom roll body --throws N`: how often a body comes to rest on which face.

use crate::args::{Format, Output, RollOptions};
use crate::failure::Failure;
use crate::files;
use crate::pipeline::MADE_BY;
use crate::printed::tell;
use crate::progress::{Progress, spent};
use crate::thrown::{headline, range, sampling, until_rest, verdict, without_way};
use carom::tasks::quoted;
use carom::tasks::solid::words::{about, named};
use carom::tasks::solid::{drawing, notes};
use carom_figure::{PoseBody, PoseEnd, PoseFigure, SolidInstant, pose_report};
use carom_scene::{PoseEndReport, PoseReport, ProbabilityReport, SpatialRollProblem, THROW_DIMENSIONS};
use carom_study::poses::{Plan, Pose, Poses};
use carom_study::yields::{Estimate, REPETITIONS};
use carom_words::aligned;
use carom_words::study::percent;
use std::fmt::Write as _;
use std::io::Write;

pub(super) fn study(
    name: &str,
    problem: &SpatialRollProblem,
    throws: u64,
    options: &RollOptions,
    output: &Output,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let plan = Plan {
        dimensions: THROW_DIMENSIONS,
        throws: throws.div_ceil(REPETITIONS as u64),
        seed: options.seed,
    };
    let (found, seconds) = thrown(name, problem, &plan)?;
    let run = spent(found.throws as usize, seconds);
    let report = PoseReport::new(problem, &plan, &found, &problem.law_in_words(), run)
        .ok_or_else(|| Failure::Usage(format!("{name}: no body is thrown")))?;
    let json = format!("{}\n", serde_json::to_string_pretty(&report)?);
    match output.format {
        Format::Text => out.write_all(text(name, &found, &report).as_bytes())?,
        Format::Json => out.write_all(json.as_bytes())?,
    }
    let folder = output.folder("throws");
    files::write(&folder, "throws.json", &json)?;
    let path = files::write(&folder, "throws.html", &page(name, options, problem, &found, &report))?;
    match output.format {
        Format::Text => writeln!(out, "page {}", path.display())?,
        // Stdout is the result's alone.
        Format::Json => tell(&format!("page {}", path.display())),
    }
    if options.open { files::open(&path) } else { Ok(()) }
}

/// Throws it, and how long that took \[s\].
fn thrown(name: &str, problem: &SpatialRollProblem, plan: &Plan) -> Result<(Poses, f64), Failure> {
    let progress = Progress::new("throws", Some(plan.rounded() as usize * REPETITIONS));
    let found = problem.throws(plan, || progress.step());
    let found = found.map_err(|error| Failure::Usage(format!("{name}: {error}")))?;
    Ok((found, progress.seconds()))
}

fn estimate(p: &ProbabilityReport) -> Estimate {
    Estimate { share: p.share, low: p.low, high: p.high, count: p.count }
}

/// Everything for a person, the verdict first.
fn text(name: &str, found: &Poses, report: &PoseReport) -> String {
    let mut text = verdict(name, found);
    let _ = writeln!(text, "{}", report.law);
    if let Some(line) = without_way(found) {
        let _ = writeln!(text, "{line}");
    }
    text.push('\n');
    for line in about(&report.body) {
        let _ = writeln!(text, "{line}");
    }
    let _ = writeln!(text, "{}\n", varied(report));
    let head =
        ["end", "vertices", "% of all", "95 % interval", "throws", "% of those at rest", "95 % interval"];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    rows.extend(report.ends.iter().map(row));
    text.push_str(&aligned(&rows));
    text.push_str(&until_rest(found));
    text.push_str("\nthe first throw of each end is in the page, with the options that make it again\n\n");
    text
}

/// What varies from throw to throw.
fn varied(report: &PoseReport) -> String {
    format!(
        "every attitude alike; height {}, horizontal speed {}, spin {} about any axis; seed {}",
        range(&report.height_m, "m"),
        range(&report.speed_m_s, "m/s"),
        range(&report.spin_rate_rad_s, "rad/s"),
        report.seed
    )
}

fn row(end: &PoseEndReport) -> Vec<String> {
    let [share, interval] = percent(&estimate(&end.probability));
    let [among, range] =
        end.of_resting.as_ref().map_or([String::new(), String::new()], |p| percent(&estimate(p)));
    vec![
        end.end.to_string(),
        named(&end.vertices),
        share,
        interval,
        end.probability.count.to_string(),
        among,
        range,
    ]
}

fn page(
    name: &str,
    options: &RollOptions,
    problem: &SpatialRollProblem,
    found: &Poses,
    report: &PoseReport,
) -> String {
    let ends: Vec<PoseEnd> = report.ends.iter().map(|end| shown(name, options, report, end)).collect();
    let lead = varied(report);
    let mut told = notes(problem, &about(&report.body));
    told.extend(without_way(found));
    told.push(sampling(found.throws, report.seed));
    let instants = [resting_instant(problem, found)];
    pose_report(&PoseFigure {
        title: name,
        verdict: &headline(found),
        lead: &lead,
        notes: &told,
        source: &problem.source,
        made_by: MADE_BY,
        body: PoseBody::Solid(drawing(problem), &instants),
        ends: &ends,
        resting: found.resting,
        time: found.time.as_ref(),
        strikes: found.impacts.as_ref(),
        throws: found.throws,
    })
}

/// The body on the face that comes up most; as it is released where none does.
fn resting_instant(problem: &SpatialRollProblem, found: &Poses) -> SolidInstant {
    let faces = found.ends.iter().filter_map(|end| match end.pose {
        Pose::Face(face) if end.probability.count > 0 => Some((face, end.probability.count)),
        _ => None,
    });
    let most = faces.max_by_key(|(_, count)| *count);
    let state = most.and_then(|(face, _)| problem.resting_on(face)).unwrap_or(problem.start);
    SolidInstant {
        time: 0.0,
        centre: state.centre,
        attitude: state.attitude,
        tilt: problem.tilt(&state),
        held: vec![],
        places: vec![],
    }
}

fn shown(name: &str, options: &RollOptions, report: &PoseReport, end: &PoseEndReport) -> PoseEnd {
    let stance = end.face.and_then(|face| report.body.faces.get(face));
    let command = end.first.as_ref().map(|first| {
        let file = if options.file.is_some() { format!(" {}", quoted(name)) } else { String::new() };
        let set = options.set.iter().chain(&first.set);
        let set: String = set.map(|set| format!(" --set {}", quoted(set))).collect();
        format!("carom roll body{file}{set}")
    });
    PoseEnd {
        name: end.end.to_string(),
        vertices: named(&end.vertices),
        is_face: end.face.is_some(),
        probability: estimate(&end.probability),
        of_resting: end.of_resting.as_ref().map(estimate),
        stance: stance.map(|face| [face.centre_height_m, face.margin_m]),
        command: command.unwrap_or_default(),
    }
}
