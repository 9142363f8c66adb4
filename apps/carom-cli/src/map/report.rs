//! What an outcome map says in words and as JSON.

use super::{Drawn, name};
use crate::progress::spent;
use crate::regions::report::{axis, boundaries, junctions, labels};
use crate::side_by_side::aligned;
use crate::table::fixed;
use crate::tolerance::ON_A_LINE;
use carom_feeder::Verdict;
use carom_scene::{MapReport, SpanReport, Want, labelled};
use carom_study::Ending;
use carom_study::map::Node;
use carom_words::{part, study};
use std::fmt::Write as _;
use std::path::PathBuf;

/// The quantities that the scene writes down and that are no axis.
pub(super) fn fixed_in_words(drawn: &Drawn<'_>) -> String {
    let axes = [0, 1].map(|k| drawn.plane.keys[drawn.plane.axes[k].key].name.as_str());
    let quantities = drawn.scene.quantities().into_iter();
    let fixed = quantities.filter(|q| q.written && !axes.contains(&q.path.as_str()));
    fixed
        .map(|q| format!("{} {}", labelled(&q.path), q.kind.dimension.show(q.value)))
        .collect::<Vec<_>>()
        .join(", ")
}

/// Below the title of the picture: how much of the plane was not looked into, and what is no axis.
pub(super) fn subtitle(drawn: &Drawn<'_>) -> String {
    let fixed = fixed_in_words(drawn);
    let crowded = 100.0 * drawn.map.regions.crowded;
    if crowded > 0.0 { format!("not looked into: {crowded:.3} % of the plane; {fixed}") } else { fixed }
}

/// How an ending is written in full: with a word where it is the one that the scene wants on the plate.
pub(super) fn words(drawn: &Drawn<'_>, ending: Ending) -> String {
    let wanted = match drawn.scene.wants().get(drawn.plate).copied().flatten() {
        Some(Want::Same) => Some(Ending::Lies(Verdict::Same)),
        Some(Want::Turned) => Some(Ending::Lies(Verdict::Turned)),
        Some(Want::Face(face)) => Some(Ending::Lies(Verdict::Face(face))),
        Some(Want::Any) | None => None,
    };
    if wanted == Some(ending) {
        format!("{}, as wanted", study::ending(ending))
    } else {
        study::ending(ending)
    }
}

/// For a person.
pub(super) fn text(drawn: &Drawn<'_>, files: &[PathBuf]) -> String {
    let regions = &drawn.map.regions;
    let plate = part::obstacle(drawn.scene.feeder(), drawn.plate);
    let mut text = format!("{}: how a drop ends on \"{plate}\"\n\n", drawn.scene.name());
    let mut rows = vec![["outcome", "", "area %", "grid nodes"].map(str::to_owned).to_vec()];
    // An outcome at equality fills a line and no region.
    let seen = regions.shares.iter().filter(|share| share.nodes > 0 || share.area > ON_A_LINE);
    rows.extend(seen.map(|share| {
        let name = name(share.label);
        vec![name.short, words(drawn, share.label), fixed(100.0 * share.area, 2), share.nodes.to_string()]
    }));
    text += &aligned(&rows);
    // Writing to a String cannot fail.
    let _ = writeln!(
        text,
        "\n{} boundaries, {} points where three or more outcomes meet, located to {:e} of the axes",
        regions.boundaries.len(),
        regions.junctions.len(),
        drawn.accuracy
    );
    if let Some(speed) = span(drawn, |node| node.impact_speed) {
        let _ = writeln!(text, "strikes \"{plate}\" at {:.3} to {:.3} m/s", speed.low, speed.high);
    }
    if regions.crowded > 0.0 {
        let share = 100.0 * regions.crowded;
        let _ = writeln!(
            text,
            "not looked into: {share:.3} % of the plane, where outcomes change from cell to cell"
        );
    }
    let _ = writeln!(text, "{} drops, {:.2} s\n", drawn.map.drops, drawn.seconds);
    for file in files {
        let _ = writeln!(text, "{}", file.display());
    }
    text
}

/// The lowest and the highest of a measure.
fn span(drawn: &Drawn<'_>, measure: impl Fn(&Node) -> Option<f64>) -> Option<SpanReport> {
    drawn.map.nodes.iter().filter_map(measure).fold(None, |span, value| {
        let span = span.unwrap_or(SpanReport { low: value, high: value });
        Some(SpanReport { low: span.low.min(value), high: span.high.max(value) })
    })
}

/// For a program.
pub(super) fn summary(drawn: &Drawn<'_>) -> MapReport {
    let regions = &drawn.map.regions;
    let word = study::ending;
    MapReport {
        scene: drawn.scene.name().to_owned(),
        approximations: drawn.scene.approximations().to_vec(),
        plate: drawn.scene.feeder().plates[drawn.plate].name.clone(),
        axes: [0, 1].map(|k| axis(&drawn.plane.axes[k], &drawn.plane.keys)),
        accuracy_share: drawn.accuracy,
        labels: labels(regions, &name),
        boundaries: boundaries(regions, &word),
        junctions: junctions(regions, &word),
        impact_speed_m_s: span(drawn, |node| node.impact_speed),
        flat_s: span(drawn, |node| node.flat),
        unresolved_share: regions.crowded,
        run: spent(drawn.map.drops, drawn.seconds),
    }
}
