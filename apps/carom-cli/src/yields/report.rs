//! What a yield study says in words and as JSON.

use super::{RESTITUTIONS, Studied, file_of};
use crate::printed::notes;
use crate::progress::spent;
use crate::quantities::wants;
use crate::side_by_side::aligned;
use crate::table::fixed;
use carom_feeder::Verdict;
use carom_scene::{
    EndingReport, EndingWord, FaceShareReport, LawReport, RecirculationReport, SensitivityReport,
    TransitionReport, Word, WorstReport, YieldPlateReport, YieldReport, labelled,
};
use carom_study::Ending;
use carom_study::yields::{Estimate, Recirculation, Sensitivity, Spread, Transition, Worst};
use carom_words::{Words, part, study};
use std::fmt::Write as _;
use std::path::PathBuf;

/// Why a drop is one to look at.
pub(super) fn why(studied: &Studied<'_>, worst: &Worst) -> String {
    let drops = studied.found.drops;
    match worst.among {
        _ if worst.hardest => {
            format!("the hardest first strike of {drops} drops on plates that the part comes to lie on")
        }
        1 => format!("the only one of {drops} drops that ends so"),
        like => format!("of the {like} of {drops} drops that end so, the most probable"),
    }
}

/// What stands above a scene that is saved.
pub(super) fn head_of(studied: &Studied<'_>, worst: &Worst) -> String {
    let why = why(studied, worst);
    format!(
        "# {}: {}, {why}; seed {}.\n",
        studied.scene.name(),
        study::ending(worst.ending),
        studied.plan.seed
    )
}

/// What is wanted, in words.
pub(super) fn wanted(studied: &Studied<'_>) -> String {
    wants(studied.scene).unwrap_or_else(|| {
        format!(
            "{} on \"{}\", as it ends where nothing varies",
            study::ending(studied.wanted.middle),
            plate_label(studied)
        )
    })
}

pub(super) fn plate_label(studied: &Studied<'_>) -> String {
    part::obstacle(studied.scene.feeder(), studied.plan.plate)
}

/// A share and its interval, in percent: `98.53`, `98.31 to 98.75`.
pub(crate) fn percent(estimate: &Estimate) -> [String; 2] {
    let show = |share: f64| format!("{:.2}", 100.0 * share);
    [show(estimate.share), format!("{} to {}", show(estimate.low), show(estimate.high))]
}

/// For a person.
pub(super) fn text(studied: &Studied<'_>, files: &[PathBuf]) -> String {
    let found = &studied.found;
    let [share, interval] = percent(&found.wanted);
    let mut text =
        format!("{}: {share} % end as wanted ({interval}): {}\n", studied.scene.name(), wanted(studied));
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
    let _ = writeln!(text, "{} drops, seed {}, {:.2} s\n", studied.drops, studied.plan.seed, studied.seconds);
    for file in files {
        let _ = writeln!(text, "{}", file.display());
    }
    text
}

/// Where to go from a layout that never does what is wanted.
fn elsewhere(studied: &Studied<'_>) -> &'static str {
    let kept = if studied.limits.is_some() { &studied.found.kept } else { &studied.found.wanted };
    match kept.count {
        0 => {
            "no drop does: `carom design` looks for a layout whose drops do, within what [design] leaves free\n"
        }
        _ => "",
    }
}

/// Speeds on each plate.
fn plates(studied: &Studied<'_>) -> String {
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
fn transitions(studied: &Studied<'_>) -> String {
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
fn recirculation(studied: &Studied<'_>) -> String {
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

/// The quantities, the one that decides most first.
pub(super) fn ranked<'s>(studied: &'s Studied<'_>) -> Result<Vec<(String, Sensitivity)>, &'s str> {
    let paths = studied.varied.paths();
    let mut ranked: Vec<(String, Sensitivity)> =
        paths.into_iter().zip(studied.deciders.as_ref().map_err(String::as_str)?.iter().copied()).collect();
    ranked.sort_by(|a, b| b.1.total.total_cmp(&a.1.total));
    Ok(ranked)
}

fn deciders(studied: &Studied<'_>) -> String {
    let ranked = match ranked(studied) {
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
fn laws(studied: &Studied<'_>) -> String {
    let mut rows = vec![vec!["law, nothing varies".to_owned()]];
    rows[0].extend(RESTITUTIONS.iter().map(|e| format!("e = {e}")));
    for row in studied.laws.chunks(RESTITUTIONS.len()) {
        let mut cells: Vec<String> = row.iter().take(1).map(|(law, _, _)| law.word().to_owned()).collect();
        cells.extend(row.iter().map(|(_, _, ending)| study::ending(*ending)));
        rows.push(cells);
    }
    format!("\n{}", aligned(&rows))
}

fn transition(studied: &Studied<'_>, found: &Transition) -> TransitionReport {
    let face = |ending| match ending {
        Ending::Lies(Verdict::Face(face)) => Some(face),
        _ => None,
    };
    let Estimate { share, low, high, count } = found.share;
    TransitionReport {
        plate: studied.scene.feeder().plates[found.plate].name.clone(),
        from: face(found.from),
        to: face(found.to),
        ending: EndingWord(found.to),
        share,
        low,
        high,
        drops: count,
    }
}

fn looped(found: &Recirculation) -> RecirculationReport {
    let start = |(face, share): &(usize, Estimate)| FaceShareReport { face: *face, share: (*share).into() };
    RecirculationReport {
        starts: found.starts.iter().map(start).collect(),
        probability: found.wanted.into(),
        passes: found.passes,
    }
}

/// For a program.
pub(super) fn summary(studied: &Studied<'_>) -> YieldReport {
    let found = &studied.found;
    let names = studied.scene.feeder().plates.iter();
    let plates = names.zip(&found.plates).map(|(plate, spread)| YieldPlateReport {
        plate: plate.name.clone(),
        impact_speed_m_s: spread.impact_speed.as_ref().map(Into::into),
        sliding_speed_m_s: spread.sliding_speed.as_ref().map(Into::into),
        flat_s: spread.flat.as_ref().map(Into::into),
    });
    let ending = |(ending, estimate): &(Ending, Estimate)| EndingReport {
        ending: EndingWord(*ending),
        probability: (*estimate).into(),
    };
    let worst = |worst: &Worst| WorstReport {
        file: file_of(worst),
        ending: EndingWord(worst.ending),
        why: if worst.hardest { "hardest" } else { "nearest" },
        impact_speed_m_s: worst.impact_speed,
    };
    let decider = |(quantity, s): (String, Sensitivity)| SensitivityReport {
        quantity,
        first: s.first,
        first_error: s.first_error,
        total: s.total,
        total_error: s.total_error,
    };
    let saved = |worst: &&Worst| studied.varied.text(&worst.point).is_ok();
    YieldReport {
        scene: studied.scene.name().to_owned(),
        approximations: studied.scene.approximations().to_vec(),
        notes: studied.scene.notes().to_vec(),
        plate: studied.scene.feeder().plates[studied.plan.plate].name.clone(),
        wanted: wanted(studied),
        probability: found.wanted.into(),
        yield_within_limits: studied.limits.map(|_| found.kept.into()),
        endings: found.endings.iter().map(ending).collect(),
        transitions: found.transitions.iter().map(|found| transition(studied, found)).collect(),
        recirculation: found.recirculation.as_ref().map(looped),
        plates: plates.collect(),
        time_s: found.time.as_ref().map(Into::into),
        parts_per_minute: found.time.as_ref().map(|time| 60.0 / time.mean),
        sensitivity: ranked(studied).ok().map(|ranked| ranked.into_iter().map(decider).collect()),
        laws: studied
            .laws
            .iter()
            .map(|(law, restitution, ending)| LawReport {
                law: Word(*law),
                restitution: *restitution,
                ending: EndingWord(*ending),
            })
            .collect(),
        worst: found.worst.iter().filter(saved).map(worst).collect(),
        samples: found.drops,
        seed: studied.plan.seed,
        run: spent(studied.drops, studied.seconds),
    }
}
