//! What an inverse design says, and the files of its winner.

use super::Searched;
use crate::args::Output;
use crate::failure::Failure;
use crate::files;
use crate::progress::spent;
use crate::table::fixed;
use carom::tasks::design::{DesignStudy, Designed, Winner};
use carom_scene::labelled;
use carom_words::aligned;
use carom_words::study::percent_with_interval;
use std::fmt::Write as _;
use std::io::Write;
use std::path::PathBuf;

pub(super) fn deliver(
    searched: &Searched<'_, impl Designed>,
    output: &Output,
    json: bool,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let designed = &searched.study;
    let folder = output.folder(designed.scene.name()).join("design");
    let summary = designed.summary(spent(designed.drops, searched.seconds));
    let summary = format!("{}\n", serde_json::to_string_pretty(&summary)?);
    let mut written = vec![];
    if designed.winner.is_some() {
        files::bring_outline(designed.scene, &folder)?;
    }
    for (name, text) in designed.files() {
        written.push(files::write(&folder, name, &text)?);
    }
    written.push(files::write(&folder, "design.json", &summary)?);
    if designed.winner.is_none() {
        files::remove(&folder, &["design.toml", "drawing.dxf", "drawing.svg", "report.html"])?;
    }
    if json {
        out.write_all(summary.as_bytes())?;
    } else {
        out.write_all(text(searched, &written).as_bytes())?;
    }
    Ok(())
}

/// For a person.
fn text(searched: &Searched<'_, impl Designed>, files: &[PathBuf]) -> String {
    let designed = &searched.study;
    let mut text = match &designed.winner {
        Some(winner) => found(designed, winner),
        None => designed.impossible(),
    };
    // Writing to a String cannot fail.
    let found = &designed.found;
    let _ = writeln!(
        text,
        "\n{} of {} layouts of the first look meet every demand where nothing varies",
        found.met, found.scanned
    );
    text += &aligned(&designed.forbidden_rows());
    text += &front(designed);
    let _ = writeln!(text, "\n{} drops, seed {}, {:.2} s\n", designed.drops, designed.seed, searched.seconds);
    for file in files {
        let _ = writeln!(text, "{}", file.display());
    }
    text
}

fn found<S: Designed>(designed: &DesignStudy<'_, S>, winner: &Winner<S>) -> String {
    let judged = &winner.judged;
    let mut text = format!(
        "{}: {} end as wanted, within the limits; {} with every tolerance doubled\n",
        designed.scene.name(),
        percent_with_interval(&winner.yields),
        percent_with_interval(&winner.doubled)
    );
    let _ = writeln!(text, "{}", winner.delivered().join(", "));
    let _ = writeln!(text, "{}\n", winner.afterwards());
    let mut rows = vec![];
    for (quantity, value) in designed.space.quantities().zip(&winner.values) {
        rows.push(vec![
            labelled(&quantity.path).into_owned(),
            quantity.kind.dimension.show_digits(*value, 6),
        ]);
    }
    text += &aligned(&rows);
    let within = |limit: Option<f64>| limit.map_or(String::new(), |limit| format!(" (at most {limit})"));
    let limits = &designed.limits;
    let _ = writeln!(
        text,
        "\nwhere nothing varies its striking point is {:.3} m/s fast at most, it slides at {:.3} m/s at most, and it lies flat on the last plate after {:.3} s; {:.4} m high{}, {:.4} m wide{}",
        judged.impact_speed,
        judged.sliding_speed,
        judged.time,
        judged.height,
        within(limits.height),
        judged.width,
        within(limits.width),
    );
    for sentence in designed.said() {
        let _ = writeln!(text, "{sentence}");
    }
    text
}

/// Rows of the table of what else there is.
const MOST_ROWS: usize = 12;

/// Yield against height and impact speed.
fn front(designed: &DesignStudy<'_, impl Designed>) -> String {
    if designed.found.front.is_empty() {
        return String::new();
    }
    let mut rows = vec![vec![
        "yield %".to_owned(),
        "doubled %".to_owned(),
        "height m".to_owned(),
        "strikes m/s".to_owned(),
    ]];
    let head = designed.space.quantities().map(|quantity| labelled(&quantity.path).into_owned());
    rows[0].extend(head);
    for design in designed.found.front.iter().take(MOST_ROWS) {
        let mut row = vec![
            fixed(100.0 * design.yields.share, 2),
            fixed(100.0 * design.doubled.share, 2),
            fixed(design.judged.height, 4),
            fixed(design.judged.impact_speed, 3),
        ];
        let values = designed.space.values(&design.point);
        let quantities = designed.space.quantities().zip(values);
        row.extend(quantities.map(|(quantity, value)| quantity.kind.dimension.show_digits(value, 4)));
        rows.push(row);
    }
    let more = designed.found.front.len().saturating_sub(MOST_ROWS);
    let more = if more > 0 { format!("and {more} more in design.json\n") } else { String::new() };
    format!(
        "\nno layout is better than these in yield, height and impact speed at once\n{}{more}",
        aligned(&rows)
    )
}
