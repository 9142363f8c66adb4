//! What an outcome map says in words, as tables and as JSON.

use super::{MapStudy, name};
use crate::tasks::axes::Axis;
use crate::tasks::regions::report::{axis, boundaries, junctions, labels};
use crate::tasks::tolerance::ON_A_LINE;
use carom_figure::regions_csv;
use carom_scene::columns::{Column, ColumnsError, Table};
use carom_scene::{MapReport, SpanReport, StudyRunReport};
use carom_study::map::Node;
use carom_words::number::ascii as fixed;
use carom_words::{aligned, part, study};
use std::fmt::Write as _;

impl MapStudy<'_> {
    /// What it says to a person.
    pub fn text(&self, seconds: f64) -> String {
        let drawn = self;
        let regions = &drawn.map.map.regions;
        let plate = part::obstacle(drawn.map.scene.feeder(), drawn.map.plate);
        let mut text = format!("{}: how a drop ends on \"{plate}\"\n\n", drawn.map.scene.name());
        let mut rows = vec![["outcome", "", "area %", "grid nodes"].map(str::to_owned).to_vec()];
        // An outcome at equality fills a line and no region.
        let seen = regions.shares.iter().filter(|share| share.nodes > 0 || share.area > ON_A_LINE);
        rows.extend(seen.map(|share| {
            let name = name(share.label);
            vec![
                name.short,
                drawn.map.words(share.label),
                fixed(100.0 * share.area, 2),
                share.nodes.to_string(),
            ]
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
        let _ = writeln!(text, "{} drops, {:.2} s\n", drawn.map.map.drops, seconds);
        text
    }

    /// What it says to a program; `run` says what it took.
    pub fn summary(&self, run: StudyRunReport) -> MapReport {
        let drawn = self;
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
            run,
        }
    }

    /// The boundaries as CSV, with axes as the picture has them.
    pub fn csv(&self) -> String {
        let [x, y] = [0, 1].map(|k| {
            let axis = &self.plane.axes[k];
            let path = &self.plane.keys[axis.key].name;
            if axis.unit().is_empty() { path.clone() } else { format!("{path} [{}]", axis.unit()) }
        });
        regions_csv(&self.map.map.regions, [&x, &y], &name)
    }

    /// What every node of the grid measures, as Parquet.
    ///
    /// # Errors
    /// A build without Parquet.
    pub fn nodes(&self) -> Result<Vec<u8>, ColumnsError> {
        let nodes = &self.map.map.nodes;
        let number = |of: &dyn Fn(&Node) -> Option<f64>| Column::Number(nodes.iter().map(of).collect());
        let [x, y] = &self.plane.axes;
        let path = |axis: &Axis| self.plane.keys[axis.key].name.as_str();
        let columns = [
            (path(x), number(&|node| Some(x.si(node.x)))),
            (path(y), number(&|node| Some(y.si(node.y)))),
            ("ending", Column::Word(nodes.iter().map(|node| Some(study::ending(node.ending))).collect())),
            ("impact_speed_m_s", number(&|node| node.impact_speed)),
            ("flat_s", number(&|node| node.flat)),
            ("margin", number(&|node| node.margin)),
        ];
        let si = |axis: &Axis| self.plane.keys[axis.key].dimension.si();
        let units = [si(x), si(y), "", "m/s", "s", ""];
        let about = [
            ("scene", self.map.scene.source()),
            ("plate", &self.map.scene.feeder().plates[self.map.plate].name),
            ("version", env!("CARGO_PKG_VERSION")),
        ];
        let mut table = Table::new(&columns, &units, &about)?;
        table.push(&columns)?;
        table.finish()
    }
}

/// The lowest and the highest of a measure.
fn span(drawn: &MapStudy<'_>, measure: impl Fn(&Node) -> Option<f64>) -> Option<SpanReport> {
    drawn.map.map.nodes.iter().filter_map(measure).fold(None, |span, value| {
        let span = span.unwrap_or(SpanReport { low: value, high: value });
        Some(SpanReport { low: span.low.min(value), high: span.high.max(value) })
    })
}
