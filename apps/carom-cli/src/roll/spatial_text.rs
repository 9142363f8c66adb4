//! A body in space and its strikes, for a person at a terminal: the verdict first.

use super::body_text;
use crate::table::{capitals, fixed};
use crate::tolerance::PLAIN_FROM;
use carom::tasks::solid::words::{change, headline, lead, takes};
use carom_impact::spatial::Freedom;
use carom_scene::{
    SpatialContactReport, SpatialForkReport, SpatialRollProblem, SpatialRollReport, SpatialStrikeReport,
};
use carom_words::{aligned, roll_space};
use std::fmt::Write as _;

/// Strikes in the table, and kinds of strike that are shown with their states.
const MOST_STRIKES: usize = 40;
const MOST_IN_FULL: usize = 4;
/// Refused states of a strike that are shown.
const MOST_REFUSED: usize = 16;
/// Strikes alike that are named.
const MOST_NAMED: usize = 12;
/// Series that are named.
const MOST_SERIES: usize = 12;

/// Everything about one run.
pub(super) fn text(problem: &SpatialRollProblem, report: &SpatialRollReport) -> String {
    let mut text = format!("{}\n{}\n", verdict(report), report.end.words);
    if let Some(body) = &report.body {
        text.push_str(&body_text::text(&problem.law_in_words(), body, report.resting.as_ref()));
    }
    if !report.strikes.is_empty() {
        let _ = write!(text, "\n{}", table(report));
    }
    text.push_str(&series(report));
    let groups = alike(&report.strikes);
    for group in groups.iter().take(MOST_IN_FULL) {
        text.push_str(&in_full(&report.strikes, group));
    }
    let left: usize = groups.iter().skip(MOST_IN_FULL).map(Vec::len).sum();
    if left > 0 {
        let _ = writeln!(text, "\n… {left} more strikes with their states with --format json");
    }
    if !report.strikes.is_empty() && report.body.is_none() {
        let _ = writeln!(text, "\n{}", agreement(problem, report));
    }
    text.push('\n');
    text
}

fn verdict(report: &SpatialRollReport) -> String {
    let mut parts = vec![capitals(&headline(report))];
    parts.extend(lead(report));
    parts.join("   ")
}

fn size([x, y, z]: [f64; 3]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}

/// A number with so many significant digits, for columns over many orders of magnitude.
fn short(x: f64) -> String {
    let small = x != 0.0 && x.abs() < PLAIN_FROM;
    if small { format!("{x:.3e}") } else { fixed(x, 5) }
}

fn table(report: &SpatialRollReport) -> String {
    let head = ["#", "t s", "strikes", "state", "tilt°", "spin 1/s", "energy J", "", "friction", "law"];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    rows.extend(report.strikes.iter().enumerate().take(MOST_STRIKES).map(|(i, strike)| row(i, strike)));
    let mut text = aligned(&rows);
    if let Some(more) = report.strikes.len().checked_sub(MOST_STRIKES).filter(|more| *more > 0) {
        let _ = writeln!(text, "… {more} more, all with --format json");
    }
    text
}

fn dash() -> String {
    "-".to_owned()
}

fn row(i: usize, strike: &SpatialStrikeReport) -> Vec<String> {
    let spin = |spin: [f64; 3]| fixed(size(spin), 4);
    vec![
        (i + 1).to_string(),
        fixed(strike.t_s, 6),
        strike.struck.join(" "),
        strike.state.clone(),
        fixed(strike.tilt_rad * 180.0 / std::f64::consts::PI, 4),
        format!("{}→{}", spin(strike.spin_before_rad_s), strike.spin_rad_s.map_or_else(dash, spin)),
        format!("{}→{}", short(strike.energy_before), strike.energy_after.map_or_else(dash, short)),
        change(strike).unwrap_or_default(),
        strike.friction_demand.map_or_else(dash, |mu| {
            format!("{}{}", if strike.friction_is_bound { "≤" } else { "" }, fixed(mu, 4))
        }),
        strike.outcome.to_string(),
    ]
}

fn series(report: &SpatialRollReport) -> String {
    let mut text = String::new();
    for series in report.accumulations.iter().take(MOST_SERIES) {
        let _ = writeln!(
            text,
            "infinitely many strikes from {:.6} s on, closed at their limit {:.6} s: {} a period, each {:.6} of the one before; {} stay",
            series.from_s,
            series.to_s,
            series.period,
            series.ratio,
            series.kept.join(", ")
        );
    }
    text
}

/// The numbers of strikes with the same contacts that end alike.
fn alike(strikes: &[SpatialStrikeReport]) -> Vec<Vec<usize>> {
    let key = |s: &SpatialStrikeReport| {
        let case = s.closed_form.as_ref().map(|form| form.kept.len());
        // By how many touch and keep: a stool's supports differ by a turn only.
        (s.contacts.len(), s.kept.len(), s.struck.len(), s.outcome, case)
    };
    let mut groups: Vec<Vec<usize>> = vec![];
    for (i, strike) in strikes.iter().enumerate() {
        let same = |group: &&mut Vec<usize>| {
            group.first().and_then(|first| strikes.get(*first)).is_some_and(|first| key(first) == key(strike))
        };
        match groups.iter_mut().find(same) {
            Some(group) => group.push(i),
            None => groups.push(vec![i]),
        }
    }
    groups
}

/// The first strike of a group: its impulses, and every state of the law.
fn in_full(strikes: &[SpatialStrikeReport], group: &[usize]) -> String {
    let Some((i, strike)) = group.first().and_then(|i| Some((*i, strikes.get(*i)?))) else {
        return String::new();
    };
    let mut text = format!("\nstrike {} at {} s   {}\n", i + 1, fixed(strike.t_s, 6), strike.state);
    let spin = |[x, y, z]: [f64; 3]| format!("({}, {}, {})", fixed(x, 6), fixed(y, 6), fixed(z, 6));
    let (before, after) = (spin(strike.spin_before_rad_s), strike.spin_rad_s.map_or_else(dash, spin));
    let _ = writeln!(text, "  spin {before} → {after} rad/s, body axes");
    if !strike.contacts.is_empty() {
        text.push_str(&contacts(&strike.contacts));
    }
    text.push_str(&states(strike));
    if let Some(form) = &strike.closed_form {
        let _ = writeln!(text, "  closed form: {}", form.case);
        let _ = writeln!(text, "  {}", form.words);
        let impulses =
            form.impulse_difference.map_or_else(String::new, |d| format!(", normal impulses to {d:.1e}"));
        let verdict = if form.agrees { "agrees" } else { "DIFFERS" };
        let _ = writeln!(text, "  {verdict}: spins to {:.1e}{impulses}", form.spin_difference);
    }
    let others: Vec<String> = group.iter().skip(1).map(|i| (i + 1).to_string()).collect();
    if !others.is_empty() {
        let more = if others.len() > MOST_NAMED { ", …" } else { "" };
        let named = others.iter().take(MOST_NAMED).cloned().collect::<Vec<_>>().join(", ");
        let plural = if others.len() > 1 { "s" } else { "" };
        let _ = writeln!(text, "  as many touch and keep in strike{plural} {named}{more}");
    }
    text
}

fn contacts(contacts: &[SpatialContactReport]) -> String {
    let head = ["  contact", "before", "", "p_n N s", "p_t N s", "u_n m/s", "slip m/s"];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    rows.extend(contacts.iter().map(|c| {
        let [x, y, z] = c.velocity_m_s;
        let numbers = [c.normal_impulse, c.tangential_impulse, z, (x * x + y * y).sqrt()];
        let before = if c.strikes { "strikes" } else { "stands" };
        let mut row = vec![format!("  {}", c.name), before.to_owned(), c.state.to_string()];
        row.extend(numbers.map(|number| fixed(number, 6)));
        row
    }));
    aligned(&rows)
}

/// What else a strike with friction could have done.
fn forks(forks: &[SpatialForkReport]) -> String {
    let mut text = String::new();
    for fork in forks {
        let _ = writeln!(text, "  stage {}, {}: several ways on are consistent", fork.stage, fork.phase);
        let mut rows: Vec<Vec<String>> = vec![];
        rows.extend(fork.followed.iter().map(|way| vec![format!("    {way}"), "followed".to_owned()]));
        rows.extend(fork.others.iter().map(|way| vec![format!("    {way}"), "as consistent".to_owned()]));
        text.push_str(&aligned(&rows));
    }
    text
}

fn states(strike: &SpatialStrikeReport) -> String {
    // With friction a strike is walked through, and has no states.
    if strike.end_states.is_empty() && strike.rejected.is_empty() {
        let shared = strike.open.0 == Freedom::Motion;
        let shared = if shared { format!("  {}\n", roll_space::SHARED) } else { String::new() };
        return shared + &forks(&strike.forks);
    }
    let found = match strike.end_states.len() {
        0 => "no state is consistent".to_owned(),
        1 => "one state is consistent".to_owned(),
        n => format!("{n} states are consistent: the law leaves it open"),
    };
    let mut rows = vec![];
    for end in &strike.end_states {
        let friction = match end.friction_demand {
            Some(mu) => takes(mu, end.friction_is_bound, 6),
            None => "no friction keeps it from sliding".to_owned(),
        };
        let followed = if strike.end_states.len() > 1 && end.followed { ", followed" } else { "" };
        rows.push(vec![format!("  {}", end.hypothesis), format!("consistent{followed}: {friction}")]);
    }
    for rejected in strike.rejected.iter().take(MOST_REFUSED) {
        rows.push(vec![format!("  {}", rejected.hypothesis), rejected.because.clone()]);
    }
    let mut text = format!("  {found}\n{}", aligned(&rows));
    let hidden = strike.rejected.len().saturating_sub(MOST_REFUSED) + strike.rejected_left_out;
    if hidden > 0 {
        let _ = writeln!(text, "  … {hidden} more are refused");
    }
    text
}

/// How the strikes compare with the closed forms.
fn agreement(problem: &SpatialRollProblem, report: &SpatialRollReport) -> String {
    let forms: Vec<_> = report.strikes.iter().filter_map(|s| s.closed_form.as_ref()).collect();
    if forms.is_empty() {
        let homogeneous = problem.pyramid.is_none_or(|shape| shape.homogeneous);
        let why = if homogeneous {
            "no strike is one that a closed form covers"
        } else {
            "the closed form is for a homogeneous pyramid"
        };
        return format!("closed forms: {why}");
    }
    let worst = forms.iter().map(|form| form.spin_difference).fold(0.0, f64::max);
    let agree = forms.iter().filter(|form| form.agrees).count();
    format!(
        "closed forms: {agree} of {} strikes agree, of {} in all; spins to {worst:.1e}",
        forms.len(),
        report.strikes.len()
    )
}
