//! `carom impact`: resolves one impact, or a stream of them.

use crate::args::{Format, ImpactOptions, Output};
use crate::failure::Failure;
use crate::side_by_side::aligned;
use crate::{files, pipeline};
use carom_figure::{ImpulsePlane, ImpulsePoint};
use carom_impact::planar::{Phase, Slip, StageEnd};
use carom_scene::{
    EndReport, ImpactAnswer, ImpactAnswerReport, ImpactProblem, Problem, ProblemKind, Problems,
};
use serde_json::json;
use std::fmt::Write as _;
use std::io::{BufRead, Write};
use std::path::Path;

/// Rejected hypotheses shown to a person.
const MOST_REJECTED: usize = 16;

pub(crate) fn impact(options: &ImpactOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    if options.file == Path::new("-") {
        return stream(&mut std::io::stdin().lock(), out);
    }
    let file = options.file.display().to_string();
    let source = std::fs::read_to_string(&options.file).map_err(|error| {
        let message = match error.kind() {
            std::io::ErrorKind::NotFound => "there is no such file".to_owned(),
            _ => error.to_string(),
        };
        Failure::from(Problems::new(&file, "", vec![Problem::new(ProblemKind::File, "", message, None)]))
    })?;
    let problem = ImpactProblem::parse(&file, &source)?;
    let answer = problem.solve();
    let report = ImpactAnswerReport::new(&problem, &answer);
    match output.format {
        Format::Text => out.write_all(text(&problem, &answer, &report).as_bytes())?,
        Format::Json => writeln!(out, "{}", serde_json::to_string_pretty(&report)?)?,
    }
    if let Some(folder) = &output.out {
        for (name, plane) in planes(&problem, &answer) {
            let file = format!("impulse-plane-{}.svg", plain(&name));
            let path = files::write(folder, &file, &pipeline::impulse_svg(&plane))?;
            writeln!(std::io::stderr(), "impulse plane of {name} {}", path.display())?;
        }
    }
    Ok(())
}

/// A contact's name as part of a file's name.
fn plain(name: &str) -> String {
    name.chars().map(|c| if c.is_alphanumeric() { c } else { '-' }).collect()
}

/// One JSON object a line in, one a line out, in order. A line with problems is answered by them, and the exit code says so in the end.
fn stream(input: &mut impl BufRead, out: &mut impl Write) -> Result<(), Failure> {
    let mut bad = 0usize;
    for (i, line) in input.lines().enumerate() {
        let line = line.map_err(|error| Failure::file("read", Path::new("stdin"), &error))?;
        if line.trim().is_empty() {
            continue;
        }
        let text = match ImpactProblem::parse_json(&format!("line {}", i + 1), &line) {
            Ok(problem) => serde_json::to_string(&ImpactAnswerReport::new(&problem, &problem.solve()))?,
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

/// The impulse plane of each contact.
fn planes(problem: &ImpactProblem, answer: &ImpactAnswer) -> Vec<(String, ImpulsePlane)> {
    let Some(walk) = answer.walk.as_ref().ok().filter(|walk| !walk.stages.is_empty()) else { return vec![] };
    let set = &problem.contacts;
    let one = |(i, name): (usize, &String)| {
        let points = walk.stages.iter().map(|stage| ImpulsePoint {
            normal: stage.end.impulse[i][1],
            tangential: stage.end.impulse[i][0],
            phase: stage.phase,
            label: label(problem, stage.phase, stage.slip[i], stage.ended_by),
        });
        let block = &set.operator[i][i];
        let plane = ImpulsePlane {
            operator: (set.count == 1).then_some([block.tt, block.tn, block.nn]),
            slip: set.slip[i],
            approach: set.normal[i],
            friction: set.friction[i],
            points: points.collect(),
        };
        (name.clone(), plane)
    };
    problem.names.iter().enumerate().map(one).collect()
}

fn label(problem: &ImpactProblem, phase: Phase, slip: Slip, end: StageEnd) -> String {
    let slip = match slip {
        Slip::Open => "open",
        Slip::Sticks => "sticks",
        Slip::Forward => "slips +",
        Slip::Backward => "slips −",
    };
    let phase = match phase {
        Phase::Compression => "compression",
        Phase::Restitution => "restitution",
    };
    let name = |i: usize| problem.names.get(i).map_or("?", String::as_str);
    let end = match end {
        StageEnd::SlipStops(i) => format!("slip stops at {}", name(i)),
        StageEnd::Closes(i) => format!("{} closes", name(i)),
        StageEnd::CompressionEnds => "compression ends".to_owned(),
        StageEnd::RestitutionEnds => "restitution ends".to_owned(),
    };
    format!("{phase}: {slip}, until {end}")
}

fn text(problem: &ImpactProblem, answer: &ImpactAnswer, report: &ImpactAnswerReport) -> String {
    let mut text = String::new();
    let ends = match report.end_states.len() {
        0 => "no end state is consistent".to_owned(),
        1 => "one end state".to_owned(),
        n => format!("{n} end states"),
    };
    match (&report.staged, &report.not_staged) {
        (Some(staged), _) => {
            let idle = staged.end.contacts.iter().all(|c| c.normal_impulse == 0.0);
            let kind = match (&staged.class, staged.kind) {
                _ if idle => "NOTHING HAPPENS: no contact approaches".to_owned(),
                (Some(class), Some(kind)) => format!("{}, type {kind}", class.to_uppercase()),
                _ => staged
                    .end
                    .contacts
                    .iter()
                    .map(|c| format!("{} {}", c.name, c.state))
                    .collect::<Vec<_>>()
                    .join(", ")
                    .to_uppercase(),
            };
            text.push_str(&format!("{kind}   {ends}   {} law\n\n", problem.law));
            text.push_str(&end_text(&staged.end));
        }
        (None, because) => {
            let because = because.clone().unwrap_or_default();
            text.push_str(&format!("NO WALK: {because}   {ends}   {} law\n", problem.law));
        }
    }
    text.push_str(&how_text(problem, report));
    text.push_str(&sharing_text(report));
    text.push_str("\nend states\n");
    for end in &report.end_states {
        let _ = writeln!(text, "  {:<40} consistent", end.hypothesis);
    }
    for rejected in report.rejected.iter().take(MOST_REJECTED) {
        let _ = writeln!(text, "  {:<40} {}", rejected.hypothesis, rejected.because);
    }
    if let Some(more) = report.rejected.len().checked_sub(MOST_REJECTED).filter(|more| *more > 0) {
        let _ = writeln!(text, "  … {more} more rejected, all with --format json");
    }
    for (name, plane) in planes(problem, answer) {
        let _ = writeln!(text, "\nimpulse plane of {name}\n{}", pipeline::impulse_text(&plane).trim_end());
    }
    text
}

/// What decided, and the stages.
fn how_text(problem: &ImpactProblem, report: &ImpactAnswerReport) -> String {
    let mut text = String::new();
    // Writing to a String cannot fail.
    if let Some(decided) = &report.decided_by {
        let _ = writeln!(
            text,
            "\ndecided by  {}\n            P_d = {:.6}   P_q = {:.6}   μ_s = {:.6}",
            decided.because, decided.p_d, decided.p_q, decided.mu_s
        );
    }
    if let Some(staged) = &report.staged {
        text.push_str(if staged.stages.is_empty() { "\n" } else { "\nstages\n" });
        for stage in &staged.stages {
            let slips = stage.contacts.iter().zip(&problem.names);
            let slips: Vec<String> = slips.map(|(c, name)| format!("{name} {}", c.slip)).collect();
            let _ = writeln!(text, "  {:<12} {}, until {}", stage.phase, slips.join(", "), stage.ended_by);
        }
        if staged.path_dependent {
            text.push_str("  it ends in none of the end states below: the end depends on the way there\n");
        }
        if staged.branches > 1 {
            let _ = writeln!(text, "  up to {} ways on were consistent: one was chosen", staged.branches);
        }
        if staged.gained_energy {
            let _ = writeln!(text, "  {} law created energy", problem.law);
        }
    }
    text
}

/// What other conventions on sharing say, where several contacts act.
fn sharing_text(report: &ImpactAnswerReport) -> String {
    let mut text = String::new();
    if report.sharing.is_empty() {
        return text;
    }
    let all_agree = report.sharing.iter().all(|shared| shared.agrees);
    let verdict = if all_agree { "all conventions agree" } else { "the conventions disagree" };
    let _ = writeln!(text, "\nsharing     {verdict}");
    for shared in &report.sharing {
        let said = match (&shared.end, &shared.because) {
            (Some(end), _) => {
                let contact = |c: &carom_scene::EndContactReport| {
                    format!("{} u_n {:.6} slip {:.6}", c.name, c.normal_velocity_m_s, c.slip_m_s)
                };
                end.contacts.iter().map(contact).collect::<Vec<_>>().join("   ")
            }
            (None, because) => because.clone().unwrap_or_default(),
        };
        let word = if shared.agrees { "agrees" } else { "differs" };
        let _ = writeln!(text, "  {:<13} {word:<8} {said}", shared.sharing);
    }
    text
}

fn end_text(end: &EndReport) -> String {
    let head = ["contact", "", "p_n N s", "p_t N s", "u_n m/s", "slip m/s"].map(str::to_owned).to_vec();
    let mut rows = vec![head];
    rows.extend(end.contacts.iter().map(|c| {
        let numbers = [c.normal_impulse, c.tangential_impulse, c.normal_velocity_m_s, c.slip_m_s];
        let mut row = vec![c.name.clone(), c.state.clone()];
        row.extend(numbers.map(|number| crate::table::fixed(number, 6)));
        row
    }));
    let mut text = aligned(&rows);
    if let (Some([vx, vy]), Some(spin)) = (end.velocity_m_s, end.spin_rad_s) {
        let _ = writeln!(text, "\nbody        velocity {vx:.6}, {vy:.6} m/s   spin {spin:.6} 1/s");
    }
    if !end.bodies.is_empty() {
        text.push('\n');
    }
    for body in &end.bodies {
        let ([vx, vy], spin) = (body.velocity_m_s, body.spin_rad_s);
        let _ = writeln!(text, "{:<11} velocity {vx:.6}, {vy:.6} m/s   spin {spin:.6} 1/s", body.name);
    }
    if let (Some(before), Some(after)) = (end.energy_before, end.energy_after) {
        let _ = writeln!(text, "energy      {before:.6} → {after:.6} J");
    }
    text
}
