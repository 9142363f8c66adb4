//! The text of one run: the verdict first, then its stages and strikes in order of time.

use carom_feeder::{Feeder, Outcome, PartKind, Run, Stage, Verdict};
use carom_figure::words::{forward_sense, tilt};
use carom_motion::planar::{
    Pose, Twist,
    trace::{Impact, ImpactContact},
};
use carom_scene::{Scene, impact_note, names::stage_word};
use std::fmt::Write as _;

/// Rows of a table for a person; the middle of a longer one is left out.
const MOST_ROWS: usize = 60;

/// Least widths of the columns; the last one is as wide as it likes.
const COLUMNS: [usize; 8] = [8, 8, 8, 7, 14, 15, 15, 0];

/// The verdict in a word or two: TURNED, SAME SIDE, FACE 2, or how else the run ended.
pub(crate) fn headline(feeder: &Feeder, run: &Run) -> String {
    let last = run.landings.last();
    let on = last.map(|landing| format!(" on \"{}\"", feeder.obstacle_name(landing.plate)));
    let on = on.unwrap_or_default();
    let by_face = feeder.part.kind == PartKind::Polygon;
    let verdict = match last.and_then(|landing| landing.verdict) {
        Some(_) if by_face => last.and_then(|landing| landing.face).map(|face| format!("FACE {face}")),
        Some(Verdict::Turned) => Some("TURNED".to_owned()),
        Some(Verdict::Same) => Some("SAME SIDE".to_owned()),
        Some(Verdict::Face(face)) => Some(format!("FACE {face}")),
        None => None,
    };
    match (run.outcome, verdict) {
        (Outcome::Landed, Some(verdict)) => format!("{verdict}{on}"),
        (Outcome::Landed, None) => format!("LANDED{on}"),
        (Outcome::Delivered, Some(verdict)) => format!("DELIVERED, {verdict}{on}"),
        (Outcome::Delivered, None) => "DELIVERED".to_owned(),
        (Outcome::Stuck, _) => "STUCK: friction holds it".to_owned(),
        (Outcome::OnEnd, _) => "ON END: it rests on an end".to_owned(),
        (Outcome::Jammed, _) => "JAMMED: it rests wedged".to_owned(),
        (Outcome::Missed, _) => "MISSED: it fell past the last plate".to_owned(),
        (Outcome::Escaped, _) => "ESCAPED: it left the last plate before it lay flat".to_owned(),
        (Outcome::NeverFlat, _) => "NEVER FLAT: the budget of events or time ran out".to_owned(),
    }
}

/// The first strike on the plate of the last landing.
pub(crate) fn deciding_strike(run: &Run) -> Option<&Impact> {
    let landing = run.landings.last()?;
    let on_plate = |impact: &&Impact| impact.contacts.first().is_some_and(|c| c.obstacle == landing.plate);
    run.trace.impacts.iter().find(on_plate)
}

/// Speed of the striking point before an impact [m/s].
pub(crate) fn strike_speed(impact: &Impact) -> Option<f64> {
    let before = impact.contacts.first()?.before;
    Some((before.slip * before.slip + before.normal * before.normal).sqrt())
}

/// Change of kinetic energy in an impact [%].
pub(crate) fn energy_change(impact: &Impact) -> Option<f64> {
    let change = 100.0 * (impact.energy_after - impact.energy_before) / impact.energy_before;
    change.is_finite().then_some(change)
}

/// Everything about one run.
pub(crate) fn text(scene: &Scene, run: &Run) -> String {
    let feeder = scene.feeder();
    let mut parts = vec![headline(feeder, run)];
    match run.landings.last().and_then(|landing| landing.flat) {
        Some(flat) => parts.push(format!("flat at {flat:.3} s")),
        None => parts.push(format!("ended at {:.3} s", run.end_time)),
    }
    if let Some(strike) = deciding_strike(run) {
        parts.extend(strike_speed(strike).map(|speed| format!("struck at {speed:.2} m/s")));
        parts.extend(energy_change(strike).map(|change| format!("{} % energy", signed(change, 0))));
    }
    parts.extend(as_wanted(scene, run));
    let mut text = format!("{}\n\n", parts.join("   "));
    text.push_str(&rows(feeder, run));
    if run.margin.is_finite() {
        // Writing to a String cannot fail.
        let _ = write!(text, "\nmargin {:.2e}   {}\n", run.margin, run.margin_of);
    }
    text
}

/// A row with the time it belongs to.
struct Row {
    time: f64,
    strike: bool,
    cells: [String; 8],
}

/// Whether the run ended as the scene wants; `None` where it wants nothing.
pub(crate) fn as_wanted(scene: &Scene, run: &Run) -> Option<String> {
    let wanted = scene.wanted(run);
    let missed: Vec<String> = wanted
        .iter()
        .filter(|wanted| !wanted.met)
        .map(|wanted| format!("{} on \"{}\"", wanted.want, wanted.plate))
        .collect();
    match (wanted.is_empty(), missed.is_empty()) {
        (true, _) => None,
        (false, true) => Some("as wanted".to_owned()),
        (false, false) => Some(format!("NOT AS WANTED: {}", missed.join(", "))),
    }
}

fn rows(feeder: &Feeder, run: &Run) -> String {
    let head = ["stage", "plate", "from s", "ms", "speed m/s", "tilt°", "spin 1/s", "ended by"];
    let head = head.map(str::to_owned);
    let shown = with_clatter(feeder, run, in_order(feeder, run));
    let (first, last) = if shown.len() > MOST_ROWS {
        (&shown[..MOST_ROWS / 2], &shown[shown.len() - MOST_ROWS / 2..])
    } else {
        (&shown[..], &shown[..0])
    };
    let width = |column: usize| {
        let cells = shown.iter().map(|row| row.cells[column].chars().count());
        cells.fold(COLUMNS[column], usize::max)
    };
    let widths: [usize; 8] = std::array::from_fn(width);
    let mut lines = vec![line(&head, &widths)];
    lines.extend(first.iter().map(|row| line(&row.cells, &widths)));
    if !last.is_empty() {
        lines.push(format!("… {} more, all in run.json …", shown.len() - MOST_ROWS));
    }
    lines.extend(last.iter().map(|row| line(&row.cells, &widths)));
    lines.iter().map(|line| format!("{line}\n")).collect()
}

/// Stages and strikes in order of time; a strike comes before the stage that begins with it.
fn in_order(feeder: &Feeder, run: &Run) -> Vec<Row> {
    let mut rows = vec![];
    let mut impacts = run.trace.impacts.iter().peekable();
    let strike =
        |impact: &Impact| Row { time: impact.time, strike: true, cells: strike_cells(feeder, run, impact) };
    for stage in &run.stages {
        while let Some(impact) = impacts.next_if(|impact| impact.time <= stage.start_time) {
            rows.push(strike(impact));
        }
        rows.push(Row { time: stage.start_time, strike: false, cells: stage_cells(feeder, run, stage) });
    }
    rows.extend(impacts.map(strike));
    rows
}

/// Puts one row in place of each accumulation of infinitely many impacts.
fn with_clatter(feeder: &Feeder, run: &Run, rows: Vec<Row>) -> Vec<Row> {
    let mut shown: Vec<Row> = vec![];
    let mut written = vec![false; run.trace.accumulations.len()];
    for row in rows {
        let inside =
            |(from, to): &(f64, f64)| row.time > *from && (row.time < *to || (row.strike && row.time <= *to));
        let Some(which) = run.trace.accumulations.iter().position(inside) else {
            shown.push(row);
            continue;
        };
        if !written[which] {
            written[which] = true;
            let (from, to) = run.trace.accumulations[which];
            shown.push(Row { time: row.time, strike: true, cells: clatter_cells(feeder, run, from, to) });
        }
    }
    shown
}

fn clatter_cells(feeder: &Feeder, run: &Run, from: f64, to: f64) -> [String; 8] {
    let within = |impact: &&Impact| impact.time > from && impact.time <= to;
    let count = run.trace.impacts.iter().filter(within).count();
    let plate = run.trace.impacts.iter().find(within).and_then(|impact| impact.contacts.first());
    [
        "clatter".to_owned(),
        plate.map_or("-".to_owned(), |contact| feeder.obstacle_name(contact.obstacle).to_owned()),
        format!("{from:.4}"),
        format!("{:.1}", 1e3 * (to - from)),
        String::new(),
        String::new(),
        String::new(),
        format!("ever smaller impacts, {count} of them followed, then their limit"),
    ]
}

fn line(cells: &[String; 8], widths: &[usize; 8]) -> String {
    let padded: Vec<String> = cells
        .iter()
        .zip(widths)
        .map(|(cell, width)| {
            let blank = width.saturating_sub(cell.chars().count());
            format!("{cell}{}", " ".repeat(blank))
        })
        .collect();
    padded.join(" ").trim_end().to_owned()
}

/// Tilt in degrees, without the whole turns of the starting angle.
fn degrees(feeder: &Feeder, run: &Run, pose: Pose) -> f64 {
    let full = 360.0;
    let of = |pose: Pose| tilt(feeder, pose) * 180.0 / std::f64::consts::PI;
    let start = run.stages.first().map_or(0.0, |stage| of(stage.start.pose));
    of(pose) - (start / full).round() * full
}

fn speed(twist: &Twist) -> f64 {
    twist.velocity.norm()
}

fn stage_cells(feeder: &Feeder, run: &Run, stage: &Stage) -> [String; 8] {
    let sense = forward_sense(feeder);
    let (start, end) = (&stage.start, &stage.end);
    [
        stage_word(stage.name).to_owned(),
        stage.obstacle.map_or("-".to_owned(), |obstacle| feeder.obstacle_name(obstacle).to_owned()),
        format!("{:.4}", stage.start_time),
        format!("{:.1}", 1e3 * (stage.end_time - stage.start_time)),
        from_to(fixed(speed(&start.twist), 3), fixed(speed(&end.twist), 3)),
        from_to(fixed(degrees(feeder, run, start.pose), 1), fixed(degrees(feeder, run, end.pose), 1)),
        from_to(fixed(sense * start.twist.spin, 2), fixed(sense * end.twist.spin, 2)),
        stage.ended_by.clone(),
    ]
}

fn strike_cells(feeder: &Feeder, run: &Run, impact: &Impact) -> [String; 8] {
    let sense = forward_sense(feeder);
    let plate = impact.contacts.first().map_or("-", |contact| feeder.obstacle_name(contact.obstacle));
    [
        "STRIKE".to_owned(),
        plate.to_owned(),
        format!("{:.4}", impact.time),
        String::new(),
        from_to(fixed(speed(&impact.before), 3), fixed(speed(&impact.after), 3)),
        fixed(degrees(feeder, run, impact.pose), 1),
        from_to(fixed(sense * impact.before.spin, 2), fixed(sense * impact.after.spin, 2)),
        what_happened(feeder, impact),
    ]
}

fn what_happened(feeder: &Feeder, impact: &Impact) -> String {
    let contact =
        |contact: &ImpactContact| format!("{} {}", feeder.feature_name(contact.feature), contact.state);
    let mut text = match impact.kind {
        Some(kind) => {
            let feature = impact.contacts.first().map(|c| feeder.feature_name(c.feature));
            format!("{}: type {}, {kind}", feature.unwrap_or_default(), kind.number())
        }
        None => impact.contacts.iter().map(contact).collect::<Vec<_>>().join(", "),
    };
    if let Some(note) = impact_note(impact) {
        text.push_str("; ");
        text.push_str(&note);
    }
    text
}

/// One value, or two with an arrow.
fn from_to(from: String, to: String) -> String {
    if from == to { from } else { format!("{from}→{to}") }
}

/// A fixed number of digits, without the sign of a zero, and a plain 0.
pub(crate) fn fixed(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$}");
    if text.trim_start_matches('-').chars().all(|c| matches!(c, '0' | '.')) { "0".to_owned() } else { text }
}

/// With a sign, the minus being a minus.
pub(crate) fn signed(value: f64, digits: usize) -> String {
    let size = format!("{:.digits$}", value.abs());
    if value < 0.0 { format!("−{size}") } else { format!("+{size}") }
}
