//! The text of one run: the verdict first, then its stages and strikes in order of time.

use carom_feeder::{Feeder, Run, Stage};
use carom_figure::{Row, milliseconds, rows as stage_rows, senses::forward_sense, shown_tilt};
use carom_motion::planar::{
    Pose, Twist,
    trace::{Impact, ImpactContact},
};
use carom_scene::{Scene, Wanted};
use carom_words::{Words, part, run as run_words};
use std::fmt::Write as _;

pub(crate) use carom_words::number::{ascii as fixed, with_sign as signed};

/// Rows of a table for a person; the middle of a longer one is left out.
const MOST_ROWS: usize = 60;

/// Least widths of the columns; the last one is as wide as it likes.
const COLUMNS: [usize; 8] = [8, 8, 8, 7, 14, 15, 15, 0];

/// The verdict in a word or two: TURNED, SAME SIDE, FACE 2, or how else the run ended.
pub(crate) fn headline(feeder: &Feeder, run: &Run) -> String {
    shouted(run_words::headline(feeder, run))
}

/// A verdict with its word in capitals.
pub(crate) fn shouted(headline: run_words::Headline) -> String {
    let mut text = headline.word.to_uppercase();
    if let Some(plate) = headline.plate {
        text.push_str(&format!(" on \"{plate}\""));
    }
    if !headline.because.is_empty() {
        text.push_str(": ");
        text.push_str(&headline.because);
    }
    text
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
    match run.final_landing().and_then(|landing| landing.flat) {
        Some(flat) => parts.push(format!("flat at {flat:.3} s")),
        None => parts.push(format!("ended at {:.3} s", run.end_time)),
    }
    parts.extend(run.struck_at().map(|speed| format!("struck at {speed:.2} m/s")));
    if let Some(strike) = run.deciding_strike() {
        parts.extend(energy_change(strike).map(|change| format!("{} % energy", signed(change, 0))));
    }
    parts.extend(as_wanted(scene, run));
    let mut text = format!("{}\n\n", parts.join("   "));
    text.push_str(&rows(feeder, run));
    if run.margin.is_finite() {
        // Writing to a String cannot fail.
        let _ = write!(text, "\nmargin {:.2e}   {}\n", run.margin, run_words::decided(run.margin_of));
    }
    text
}

/// Whether the run ended as the scene wants; `None` where it wants nothing.
pub(crate) fn as_wanted(scene: &Scene, run: &Run) -> Option<String> {
    met(&scene.wanted(run))
}

/// The same of what is wanted.
pub(crate) fn met(wanted: &[Wanted]) -> Option<String> {
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
    let shown: Vec<[String; 8]> = stage_rows(run).into_iter().map(|row| cells(feeder, run, row)).collect();
    stages(&shown)
}

/// The table of stages and strikes.
pub(crate) fn stages(shown: &[[String; 8]]) -> String {
    let head = ["stage", "plate", "from s", "ms", "speed m/s", "tilt°", "spin 1/s", "ended by"];
    let head = head.map(str::to_owned);
    let (first, last) = if shown.len() > MOST_ROWS {
        (&shown[..MOST_ROWS / 2], &shown[shown.len() - MOST_ROWS / 2..])
    } else {
        (shown, &shown[..0])
    };
    let width = |column: usize| {
        let cells = shown.iter().map(|row| row[column].chars().count());
        cells.fold(COLUMNS[column], usize::max)
    };
    let widths: [usize; 8] = std::array::from_fn(width);
    let mut lines = vec![line(&head, &widths)];
    lines.extend(first.iter().map(|row| line(row, &widths)));
    if !last.is_empty() {
        lines.push(format!("… {} more, all in run.json …", shown.len() - MOST_ROWS));
    }
    lines.extend(last.iter().map(|row| line(row, &widths)));
    lines.iter().map(|line| format!("{line}\n")).collect()
}

fn cells(feeder: &Feeder, run: &Run, row: Row<'_>) -> [String; 8] {
    match row {
        Row::Stage(_, stage) => stage_cells(feeder, run, stage),
        Row::Strike(_, impact) => strike_cells(feeder, run, impact),
    }
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

/// Tilt in degrees; a dash for a disc.
fn degrees(feeder: &Feeder, run: &Run, pose: Pose) -> String {
    let degrees = |tilt: f64| fixed(tilt * 180.0 / std::f64::consts::PI, 1);
    shown_tilt(feeder, run, pose).map_or("-".to_owned(), degrees)
}

fn speed(twist: &Twist) -> f64 {
    twist.velocity.norm()
}

fn stage_cells(feeder: &Feeder, run: &Run, stage: &Stage) -> [String; 8] {
    let sense = forward_sense(feeder);
    let (start, end) = (&stage.start, &stage.end);
    [
        stage.name.word().to_owned(),
        stage.obstacle.map_or("-".to_owned(), |obstacle| part::obstacle(feeder, obstacle)),
        format!("{:.4}", stage.start_time),
        milliseconds(stage.end_time - stage.start_time),
        from_to(fixed(speed(&start.twist), 3), fixed(speed(&end.twist), 3)),
        from_to(degrees(feeder, run, start.pose), degrees(feeder, run, end.pose)),
        from_to(fixed(sense * start.twist.spin, 2), fixed(sense * end.twist.spin, 2)),
        run_words::stage_end(feeder, &stage.ended_by),
    ]
}

fn strike_cells(feeder: &Feeder, run: &Run, impact: &Impact) -> [String; 8] {
    let sense = forward_sense(feeder);
    let plate =
        impact.contacts.first().map_or("-".to_owned(), |contact| part::obstacle(feeder, contact.obstacle));
    [
        "STRIKE".to_owned(),
        plate,
        format!("{:.4}", impact.time),
        String::new(),
        from_to(fixed(speed(&impact.before), 3), fixed(speed(&impact.after), 3)),
        degrees(feeder, run, impact.pose),
        from_to(fixed(sense * impact.before.spin, 2), fixed(sense * impact.after.spin, 2)),
        what_happened(feeder, impact),
    ]
}

fn what_happened(feeder: &Feeder, impact: &Impact) -> String {
    let contact = |contact: &ImpactContact| {
        format!("{} {}", part::feature(feeder, contact.feature), contact.state.word())
    };
    let mut text = match impact.kind {
        Some(kind) => {
            let feature = impact.contacts.first().map(|c| part::feature(feeder, c.feature));
            format!("{}: type {}, {}", feature.unwrap_or_default(), kind.number(), kind.word())
        }
        None => impact.contacts.iter().map(contact).collect::<Vec<_>>().join(", "),
    };
    if let Some(note) = run_words::note(impact) {
        text.push_str("; ");
        text.push_str(&note);
    }
    text
}

/// One value, or two with an arrow.
pub(crate) fn from_to(from: String, to: String) -> String {
    if from == to { from } else { format!("{from}→{to}") }
}

/// In capitals, but for what follows a number: a unit is written as it is.
pub(crate) fn capitals(text: &str) -> String {
    let mut after_number = false;
    let words = text.split(' ').map(|word| {
        let unit = after_number;
        after_number = word.parse::<f64>().is_ok();
        if unit { word.to_owned() } else { word.to_uppercase() }
    });
    words.collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_not_written_in_capitals() {
        assert_eq!(capitals("at rest at 0.132341 s"), "AT REST AT 0.132341 s");
        assert_eq!(capitals("slips, then rests"), "SLIPS, THEN RESTS");
    }
}
