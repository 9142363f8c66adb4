//! `carom roll`: follows a body through its strikes.

mod body_text;
mod poses;
mod spatial;
mod spatial_text;
mod throws;

use crate::args::{Format, Output, RollOptions, RollWord, is_stdin};
use crate::failure::Failure;
use crate::files;
use crate::impact::text::{HYPOTHESIS, in_two_columns};
use crate::lines::answer_lines;
use crate::printed::tell;
use crate::table::{fixed, signed};
use carom::tasks::roll::{RollStudy, lead};
use carom_scene::{RollKind, RollProblem, RollReport, RollStrikeReport, SpatialRollKind, toml_of_json};
use carom_words::Words;
use carom_words::aligned;
use std::fmt::Write as _;
use std::io::Write;

/// Strikes in the table, and kinds of strike whose hypotheses are shown to a person.
const MOST_STRIKES: usize = 40;
const MOST_IN_FULL: usize = 4;
/// Strikes alike that are named.
const MOST_NAMED: usize = 12;

pub(crate) fn roll(options: &RollOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    if options.throws.is_some() && !matches!(options.kind, RollWord::Body) {
        return Err(Failure::Usage(
            "--throws is for `carom roll body`: the others start as they are written".to_owned(),
        ));
    }
    let every = poses::interval(options)?;
    if options.file.as_deref().is_some_and(is_stdin) {
        return lines(options, every, out);
    }
    let kind = match kind(options.kind) {
        Ok(kind) => kind,
        Err(kind) => return spatial::roll(kind, options, every, output, out),
    };
    let (name, source) = match &options.file {
        Some(path) => (path.display().to_string(), files::read_input(path)?),
        None => (format!("roll {}", kind.word()), String::new()),
    };
    let problem =
        RollProblem::parse(kind, &name, &source, &options.set).map_err(|found| Failure::Input(found.0))?;
    let run = poses::planar(&name, &problem, every)?;
    let study = RollStudy::of_run(problem, run);
    let RollStudy { run, report, .. } = &study;
    match output.format {
        Format::Text => out.write_all(text(report).as_bytes())?,
        Format::Json => writeln!(out, "{}", serde_json::to_string_pretty(report)?)?,
    }
    let folder = output.folder(kind.word());
    let json = files::write(&folder, "roll.json", &format!("{}\n", serde_json::to_string_pretty(report)?))?;
    let path = files::write(&folder, "report.html", &study.page(&name))?;
    match output.format {
        Format::Text => {
            poses::tell_where(run.poses.as_ref().map(Vec::len), &json, out)?;
            writeln!(out, "report {}", path.display())?;
        }
        // Stdout is the result's alone.
        Format::Json => tell(&format!("report {}", path.display())),
    }
    if options.open { files::open(&path) } else { Ok(()) }
}

/// What rolls in the plane; else what rolls in space.
fn kind(word: RollWord) -> Result<RollKind, SpatialRollKind> {
    match word {
        RollWord::Cylinder => Ok(RollKind::Cylinder),
        RollWord::Prism => Ok(RollKind::Prism),
        RollWord::Rod => Ok(RollKind::Rod),
        RollWord::Pyramid => Err(SpatialRollKind::Pyramid),
        RollWord::Stool => Err(SpatialRollKind::Stool),
        RollWord::Body => Err(SpatialRollKind::Body),
    }
}

/// One roll a line in, one result a line out; no reports are written.
fn lines(options: &RollOptions, every: Option<f64>, out: &mut impl Write) -> Result<(), Failure> {
    if options.throws.is_some() || options.open {
        let message = "- takes rolls from stdin: neither --throws nor --open goes with it";
        return Err(Failure::Usage(message.to_owned()));
    }
    answer_lines(&mut std::io::stdin().lock(), out, |name, line| {
        let source = toml_of_json(name, line)?;
        match kind(options.kind) {
            Err(kind) => spatial::answer(kind, name, &source, options, every),
            Ok(kind) => {
                let problem = RollProblem::parse(kind, name, &source, &options.set)
                    .map_err(|found| Failure::Input(found.0))?;
                let run = poses::planar(name, &problem, every)?;
                Ok(serde_json::to_string(&RollReport::new(&problem, &run))?)
            }
        }
    })
}

/// Everything about one roll, the verdict first.
fn text(report: &RollReport) -> String {
    let mut text = format!("{}\n", verdict(report));
    if !report.strikes.is_empty() {
        let _ = write!(text, "\n{}", table(report));
    }
    for accumulation in &report.accumulations {
        let _ = writeln!(
            text,
            "infinitely many strikes from {:.4} s on, closed at their limit {:.4} s",
            accumulation.from_s, accumulation.to_s
        );
    }
    let groups = alike(&report.strikes);
    for group in groups.iter().take(MOST_IN_FULL) {
        text.push_str(&in_full(&report.strikes, group));
    }
    let left: usize = groups.iter().skip(MOST_IN_FULL).map(Vec::len).sum();
    if left > 0 {
        let _ = writeln!(text, "\n… {left} more strikes with their hypotheses with --format json");
    }
    text.push('\n');
    text
}

/// The numbers of strikes that end alike and reject the others by the same inequalities.
fn alike(strikes: &[RollStrikeReport]) -> Vec<Vec<usize>> {
    let found =
        |s: &RollStrikeReport| s.end_states.iter().map(|end| end.hypothesis.clone()).collect::<Vec<_>>();
    // The amounts of two strikes differ; their words say what is alike.
    let rejected = |s: &RollStrikeReport| {
        s.rejected.iter().map(|r| (r.hypothesis.clone(), r.because.clone())).collect::<Vec<_>>()
    };
    let mut groups: Vec<Vec<usize>> = vec![];
    for (i, strike) in strikes.iter().enumerate() {
        let same = |group: &&mut Vec<usize>| {
            let first = group.first().and_then(|first| strikes.get(*first));
            first.is_some_and(|first| {
                first.state == strike.state
                    && rejected(first) == rejected(strike)
                    && first.certainty() == strike.certainty()
                    && found(first) == found(strike)
            })
        };
        match groups.iter_mut().find(same) {
            Some(group) => group.push(i),
            None => groups.push(vec![i]),
        }
    }
    groups
}

fn verdict(report: &RollReport) -> String {
    let mut parts = vec![format!("{} at {:.4} s", report.end.state.as_str().to_uppercase(), report.end.t_s)];
    parts.extend(lead(report));
    let law = match report.friction {
        Some(friction) => format!("friction {friction}"),
        None => "contacts that keep do not slide".to_owned(),
    };
    parts.push(law);
    parts.join("   ")
}

fn table(report: &RollReport) -> String {
    let head = ["#", "t s", "roll rate 1/s", "speed m/s", "tilt°", "energy J", "", "state"];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    for (i, strike) in report.strikes.iter().enumerate().take(MOST_STRIKES) {
        rows.push(row(i, strike));
    }
    let mut text = aligned(&rows);
    if let Some(more) = report.strikes.len().checked_sub(MOST_STRIKES).filter(|more| *more > 0) {
        let _ = writeln!(text, "… {more} more, all with --format json");
    }
    text
}

fn row(i: usize, strike: &RollStrikeReport) -> Vec<String> {
    let speed = |[x, y]: [f64; 2]| fixed((x * x + y * y).sqrt(), 4);
    let change = 100.0 * (strike.energy_after - strike.energy_before) / strike.energy_before;
    vec![
        (i + 1).to_string(),
        fixed(strike.t_s, 4),
        format!("{}→{}", fixed(strike.roll_rate_before_rad_s, 4), fixed(strike.roll_rate_rad_s, 4)),
        format!("{}→{}", speed(strike.velocity_before_m_s), speed(strike.velocity_m_s)),
        fixed(strike.tilt_rad * 180.0 / std::f64::consts::PI, 2),
        format!("{}→{}", fixed(strike.energy_before, 5), fixed(strike.energy_after, 5)),
        if change.is_finite() { format!("{} %", signed(change, 1)) } else { String::new() },
        strike.state.clone(),
    ]
}

/// The first strike of a group: its impulses, and every hypothesis about its end.
fn in_full(strikes: &[RollStrikeReport], group: &[usize]) -> String {
    let Some((i, strike)) = group.first().and_then(|i| Some((*i, strikes.get(*i)?))) else {
        return String::new();
    };
    let mut text = format!("\nstrike {}   {}\n", i + 1, strike.state);
    if let Some(words) = &strike.words {
        let _ = writeln!(text, "  in the literature: {words}");
    }
    let head = ["  contact", "", "p_n N s", "p_t N s", "u_n m/s", "slip m/s"].map(str::to_owned).to_vec();
    let mut rows = vec![head];
    rows.extend(strike.contacts.iter().map(|c| {
        let numbers = [c.normal_impulse, c.tangential_impulse, c.normal_velocity_m_s, c.slip_m_s];
        let mut row = vec![format!("  {}", c.name), c.state.to_string()];
        row.extend(numbers.map(|number| fixed(number, 6)));
        row
    }));
    text.push_str(&aligned(&rows));
    let _ = writeln!(text, "  {}", strike.certainty().words());
    let consistent = strike.end_states.iter().map(|end| [end.hypothesis.clone(), "consistent".to_owned()]);
    let rejected = strike.rejected.iter().map(|other| [other.hypothesis.clone(), other.because.clone()]);
    text.push_str(&in_two_columns(&consistent.chain(rejected).collect::<Vec<_>>(), HYPOTHESIS));
    let others: Vec<String> = group.iter().skip(1).map(|i| (i + 1).to_string()).collect();
    if !others.is_empty() {
        let more = if others.len() > MOST_NAMED { ", …" } else { "" };
        let named = others.iter().take(MOST_NAMED).cloned().collect::<Vec<_>>().join(", ");
        let _ = writeln!(text, "  and so strike{} {named}{more}", if others.len() > 1 { "s" } else { "" });
    }
    text
}
