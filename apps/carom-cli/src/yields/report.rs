//! What a yield study says in words.

use crate::printed::notes;
use crate::table::fixed;
use carom::tasks::yields::{RESTITUTIONS, YieldStudy};
use carom_scene::{Drawn, labelled};
use carom_study::yields::Spread;
use carom_words::aligned;
use carom_words::study::percent;
use carom_words::{Words, part, study};
use std::fmt::Write as _;
use std::path::PathBuf;

/// For a person.
pub(super) fn text(studied: &YieldStudy<'_, impl Drawn>, files: &[PathBuf], seconds: f64) -> String {
    let found = &studied.found;
    let [share, interval] = percent(&found.wanted);
    let mut text =
        format!("{}: {share} % end as wanted ({interval}): {}\n", studied.scene.name(), studied.wanted());
    if studied.limits.is_some() {
        let [share, interval] = percent(&found.kept);
        text += &format!("{share} % end as wanted within the limits of [design] ({interval})\n");
    }
    text += elsewhere(studied);
    text.push('\n');
    let mut rows = vec![["outcome", "%", "95 % interval", "drops"].map(str::to_owned).to_vec()];
    rows.extend(found.endings.iter().map(|(ending, estimate)| {
        let [share, interval] = percent(estimate);
        vec![study::ending(*ending), share, interval, estimate.count.to_string()]
    }));
    text += &aligned(&rows);
    text += &plates(studied);
    text += &transitions(studied);
    text += &recirculation(studied);
    text += &deciders(studied);
    text += &laws(studied);
    // Writing to a String cannot fail.
    if let Some(time) = &found.time {
        let _ = writeln!(
            text,
            "\ntime: mean {:.3} s, 5 to 95 % {:.3} to {:.3} s; {:.1} parts a minute, one at a time",
            time.mean,
            time.p05,
            time.p95,
            60.0 / time.mean
        );
    }
    text += &notes(studied.scene.notes());
    let _ = writeln!(text, "{} drops, seed {}, {:.2} s\n", studied.drops, studied.plan.seed, seconds);
    for file in files {
        let _ = writeln!(text, "{}", file.display());
    }
    text
}

/// Where to go from a layout that never does what is wanted.
fn elsewhere(studied: &YieldStudy<'_, impl Drawn>) -> &'static str {
    let kept = if studied.limits.is_some() { &studied.found.kept } else { &studied.found.wanted };
    match kept.count {
        0 => {
            "no drop does: `carom design` looks for a layout whose drops do, within what [design] leaves free\n"
        }
        _ => "",
    }
}

/// Speeds on each plate.
fn plates(studied: &YieldStudy<'_, impl Drawn>) -> String {
    let heads = ["plate", "strikes at m/s", "5 to 95 %", "slides up to m/s"];
    let mut rows = vec![heads.map(str::to_owned).to_vec()];
    for (plate, spread) in studied.found.plates.iter().enumerate().skip(1) {
        let show =
            |spread: &Option<Spread>, of: fn(&Spread) -> String| spread.as_ref().map_or("-".to_owned(), of);
        rows.push(vec![
            part::obstacle(studied.scene.feeder(), plate),
            show(&spread.impact_speed, |s| fixed(s.median, 3)),
            show(&spread.impact_speed, |s| format!("{} to {}", fixed(s.p05, 3), fixed(s.p95, 3))),
            show(&spread.sliding_speed, |s| fixed(s.high, 3)),
        ]);
    }
    format!("\n{}", aligned(&rows))
}

/// From which face to which.
fn transitions(studied: &YieldStudy<'_, impl Drawn>) -> String {
    let found = &studied.found.transitions;
    if found.is_empty() {
        return String::new();
    }
    let mut rows =
        vec![["to plate", "from", "to", "%", "95 % interval", "drops"].map(str::to_owned).to_vec()];
    let mut last = None;
    rows.extend(found.iter().map(|transition| {
        let [share, interval] = percent(&transition.share);
        let place = (transition.plate, transition.from);
        let [plate, from] = match last.replace(place) == Some(place) {
            true => [String::new(), String::new()],
            false => {
                [part::obstacle(studied.scene.feeder(), transition.plate), study::ending(transition.from)]
            }
        };
        vec![plate, from, study::ending(transition.to), share, interval, transition.share.count.to_string()]
    }));
    format!("\n{}", aligned(&rows))
}

/// What a loop comes to, where rejected parts come back on a face of their own.
fn recirculation(studied: &YieldStudy<'_, impl Drawn>) -> String {
    let Some(found) = studied.found.recirculation.as_ref().filter(|found| found.starts.len() > 1) else {
        return String::new();
    };
    let starts = found.starts.iter().map(|(face, share)| format!("{} % on face {face}", percent(share)[0]));
    let [share, interval] = percent(&found.wanted);
    format!(
        "\nrejected parts thrown back: {share} % end as wanted in one pass ({interval}), {} passes for each; they start {}\n",
        fixed(found.passes, 2),
        starts.collect::<Vec<_>>().join(", ")
    )
}

fn deciders(studied: &YieldStudy<'_, impl Drawn>) -> String {
    let ranked = match studied.ranked() {
        Ok(ranked) => ranked,
        Err(why) => return format!("\nwhich tolerance decides: {why}\n"),
    };
    let mut rows = vec![["which tolerance decides", "alone", "with others"].map(str::to_owned).to_vec()];
    let show = |index: f64, error: f64| format!("{} ± {}", fixed(index, 2), fixed(error, 2));
    rows.extend(ranked.into_iter().map(|(path, s)| {
        vec![labelled(&path).into_owned(), show(s.first, s.first_error), show(s.total, s.total_error)]
    }));
    format!("\n{}", aligned(&rows))
}

/// Laws by restitution.
fn laws(studied: &YieldStudy<'_, impl Drawn>) -> String {
    let mut rows = vec![vec!["law, nothing varies".to_owned()]];
    rows[0].extend(RESTITUTIONS.iter().map(|e| format!("e = {e}")));
    for row in studied.laws.chunks(RESTITUTIONS.len()) {
        let mut cells: Vec<String> = row.iter().take(1).map(|(law, _, _)| law.word().to_owned()).collect();
        cells.extend(row.iter().map(|(_, _, ending)| study::ending(*ending)));
        rows.push(cells);
    }
    format!("\n{}", aligned(&rows))
}
