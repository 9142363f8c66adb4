//! What an outcome map says in words and as JSON.

use super::Drawn;
use crate::progress::spent;
use crate::regions::report::{axis, boundaries, junctions, labels};
use crate::side_by_side::aligned;
use crate::table::fixed;
use crate::tolerance::ON_A_LINE;
use carom::tasks::map::name;
use carom_scene::{MapReport, SpanReport};
use carom_study::map::Node;
use carom_words::{part, study};
use std::fmt::Write as _;
use std::path::PathBuf;

/// For a person.
pub(super) fn text(drawn: &Drawn<'_>, files: &[PathBuf]) -> String {
    let regions = &drawn.map.map.regions;
    let plate = part::obstacle(drawn.map.scene.feeder(), drawn.map.plate);
    let mut text = format!("{}: how a drop ends on \"{plate}\"\n\n", drawn.map.scene.name());
    let mut rows = vec![["outcome", "", "area %", "grid nodes"].map(str::to_owned).to_vec()];
    // An outcome at equality fills a line and no region.
    let seen = regions.shares.iter().filter(|share| share.nodes > 0 || share.area > ON_A_LINE);
    rows.extend(seen.map(|share| {
        let name = name(share.label);
        vec![name.short, drawn.map.words(share.label), fixed(100.0 * share.area, 2), share.nodes.to_string()]
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
    let _ = writeln!(text, "{} drops, {:.2} s\n", drawn.map.map.drops, drawn.seconds);
    for file in files {
        let _ = writeln!(text, "{}", file.display());
    }
    text
}

/// The lowest and the highest of a measure.
fn span(drawn: &Drawn<'_>, measure: impl Fn(&Node) -> Option<f64>) -> Option<SpanReport> {
    drawn.map.map.nodes.iter().filter_map(measure).fold(None, |span, value| {
        let span = span.unwrap_or(SpanReport { low: value, high: value });
        Some(SpanReport { low: span.low.min(value), high: span.high.max(value) })
    })
}

/// For a program.
pub(super) fn summary(drawn: &Drawn<'_>) -> MapReport {
    let regions = &drawn.map.map.regions;
    let word = study::ending;
    MapReport {
        scene: drawn.map.scene.name().to_owned(),
        approximations: drawn.map.scene.approximations().to_vec(),
        plate: drawn.map.scene.feeder().plates[drawn.map.plate].name.clone(),
        axes: [0, 1].map(|k| axis(&drawn.plane.axes[k], &drawn.plane.keys)),
        accuracy_share: drawn.accuracy,
        labels: labels(regions, &name),
        boundaries: boundaries(regions, &word),
        junctions: junctions(regions, &word),
        impact_speed_m_s: span(drawn, |node| node.impact_speed),
        flat_s: span(drawn, |node| node.flat),
        unresolved_share: regions.crowded,
        run: spent(drawn.map.map.drops, drawn.seconds),
    }
}
