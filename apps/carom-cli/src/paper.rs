//! Table 1 of the gravity-impact feeder's paper, beside our values in its letters and frames.

mod errata;

use crate::side_by_side::Done;
use crate::table::fixed;
use crate::tolerance::SAME_AS_PRINTED;
use carom_feeder::Run;
use carom_figure::senses::slope;
use carom_scene::Scene;
use carom_validation::feeder_paper::{self, Frames, STAGES};
use carom_validation::{Value, compare};
use carom_words::aligned;
use std::f64::consts::PI;

/// Which of the paper's cases a scene is, by its number.
fn case(scene: &Scene) -> Option<u8> {
    let first = scene.feeder().plates.first()?;
    let [along, normal] = scene.paper_line()?;
    let degrees = slope(first.uphill, first.edge) * 180.0 / PI;
    let near = |a: f64, b: f64| (a - b).abs() < SAME_AS_PRINTED;
    [(1, 15.0, 0.347, 0.2), (2, 10.0, 0.428, 0.3)]
        .into_iter()
        .find(|(_, upper, x, y)| near(degrees, *upper) && near(along, *x) && near(normal, *y))
        .map(|(case, ..)| case)
}

/// A printed value beside ours.
struct Compared {
    printed: String,
    /// Ours less what is printed.
    difference: String,
    verdict: &'static str,
    /// Why; empty where it agrees.
    reason: String,
}

/// One line of the table with ours beside it; a new stage has its heading.
struct Line {
    heading: Option<&'static str>,
    letter: String,
    unit: String,
    ours: String,
    compared: Option<Compared>,
}

fn lines(scene: &Scene, run: &Run) -> Vec<Line> {
    // The table is part of the program: its own test reads it.
    let Ok(table) = carom_validation::table(feeder_paper::NAME) else { return vec![] };
    let Some(frames) = Frames::new(scene.feeder(), run) else { return vec![] };
    let case = case(scene);
    let prefix = format!("case_{}.", case.unwrap_or(1));
    let mut stages = STAGES.iter().peekable();
    let mut lines = vec![];
    for row in &table.rows {
        let Some(key) = row.key.strip_prefix(&prefix) else { continue };
        let ours = frames.value(key);
        let digits = if row.unit.is_empty() { 0 } else { 4 };
        let compared = case.and(ours).map(|ours| {
            let found = compare(row, table.coarse.as_ref(), &Value::Number(ours));
            Compared {
                printed: row.printed.clone(),
                difference: found.difference.map_or("-".to_owned(), |d| fixed(d, digits)),
                verdict: found.verdict.word(),
                reason: found.reason,
            }
        });
        lines.push(Line {
            heading: stages.next_if(|(stage, _)| key.starts_with(stage)).map(|(_, heading)| *heading),
            letter: row.letter.clone(),
            unit: row.unit.clone(),
            ours: ours.map_or("-".to_owned(), |value| fixed(value, digits)),
            compared,
        });
    }
    lines
}

fn title(scene: &Scene) -> String {
    match case(scene) {
        Some(case) => format!("Table 1, case {case}"),
        None => "Table 1's quantities (no case of the paper)".to_owned(),
    }
}

/// The table for a terminal; only ours where the scene is none of the paper's two cases.
pub(crate) fn text(scene: &Scene, run: &Run) -> String {
    let lines = lines(scene, run);
    let head = ["", "unit", "printed", "ours", "difference", "verdict"].map(str::to_owned).to_vec();
    let values = lines.iter().map(|line| {
        let [printed, difference, verdict] = line.compared.as_ref().map_or_else(Default::default, |found| {
            let reason = if found.reason.is_empty() { String::new() } else { format!(": {}", found.reason) };
            [found.printed.clone(), found.difference.clone(), format!("{}{reason}", found.verdict)]
        });
        vec![line.letter.clone(), line.unit.clone(), printed, line.ours.clone(), difference, verdict]
    });
    let table = aligned(&std::iter::once(head).chain(values).collect::<Vec<_>>());
    let mut rows = table.lines();
    let mut text = format!("{}\n\n{}\n", title(scene), rows.next().unwrap_or_default());
    for (line, row) in lines.iter().zip(rows) {
        if let Some(heading) = line.heading {
            text.push_str(&format!("  {heading}\n"));
        }
        text.push_str(&format!("{row}\n"));
    }
    text
}

/// The tables of several scenes as a page in Markdown, with the errata.
pub(crate) fn markdown(done: &[Done]) -> String {
    let mut page = errata::HEAD.to_owned();
    for (scene, run) in done {
        page.push_str(&format!("\n## {}\n", title(scene)));
        for line in lines(scene, run) {
            if let Some(heading) = line.heading {
                page.push_str(&format!(
                    "\n### {}\n\n| | unit | printed | ours | difference | verdict | why |\n|---|---|---|---|---|---|---|\n",
                    capital(heading)
                ));
            }
            let (printed, difference, verdict, reason) = match &line.compared {
                Some(found) => {
                    (found.printed.as_str(), found.difference.as_str(), found.verdict, found.reason.as_str())
                }
                None => ("", "", "", ""),
            };
            page.push_str(&format!(
                "| {} | {} | {printed} | {} | {difference} | {verdict} | {reason} |\n",
                line.letter, line.unit, line.ours
            ));
        }
    }
    page.push_str(errata::ERRATA);
    page
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map(|first| first.to_uppercase().chain(letters).collect()).unwrap_or_default()
}
