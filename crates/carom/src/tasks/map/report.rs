//! What an outcome map says in words, as tables and as JSON.

use super::{MapCells, MapStudy, name};
use crate::tasks::axes::Axis;
use crate::tasks::regions::report::{axis, boundaries, junctions, labels};
use crate::tasks::tolerance::ON_A_LINE;
use carom_figure::regions_csv;
use carom_scene::columns::{Column, ColumnsError, Table};
use carom_scene::{Drawn, MapReport, RegionsAxisReport, SpanReport, StudyRunReport};
use carom_study::Ending;
use carom_study::map::Node;
use carom_words::number::{ascii as fixed, plain};
use carom_words::part::{self, Names};
use carom_words::{aligned, study};
use std::fmt::Write as _;

impl<S: Drawn> MapStudy<'_, S> {
    /// What it says to a person.
    pub fn text(&self, seconds: f64) -> String {
        let drawn = self;
        let regions = &drawn.map.map.regions;
        let plate = part::obstacle(drawn.map.scene.feeder(), drawn.map.plate);
        let mut text = format!("{}: how a drop ends on \"{plate}\"\n\n", drawn.map.scene.name());
        let mut rows = vec![["outcome", "", "area %", "grid nodes"].map(str::to_owned).to_vec()];
        let cells = self.cells.as_ref().map(MapCells::endings);
        rows[0].extend(cells.as_ref().map(|_| "cells".to_owned()));
        let row = |ending: Ending, area: f64, nodes: usize| {
            let mut row =
                vec![name(ending).short, drawn.map.words(ending), fixed(100.0 * area, 2), nodes.to_string()];
            row.extend(cells.as_ref().map(|cells| cells.get(&ending).unwrap_or(&0).to_string()));
            row
        };
        // An outcome at equality fills a line and no region.
        let seen = regions.shares.iter().filter(|share| share.nodes > 0 || share.area > ON_A_LINE);
        rows.extend(seen.map(|share| row(share.label, share.area, share.nodes)));
        // Single cells beside a boundary may end as no node and no region does.
        let own = |ending: &&Ending| regions.shares.iter().all(|share| share.label != **ending);
        rows.extend(
            cells.iter().flat_map(|cells| cells.keys()).filter(own).map(|ending| row(*ending, 0.0, 0)),
        );
        text += &aligned(&rows);
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "\n{} boundaries, {} points where three or more outcomes meet, located to {} of the axes",
            regions.boundaries.len(),
            regions.junctions.len(),
            plain(drawn.accuracy, 2)
        );
        if let Some([columns, rows]) = self.cells.as_ref().map(MapCells::counts) {
            let _ = writeln!(
                text,
                "{columns} × {rows} cells, each by the drop at its middle or by the region it lies in"
            );
        }
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
            plate: drawn.map.scene.feeder().given(drawn.map.plate).to_owned(),
            axes: [0, 1].map(|k| RegionsAxisReport {
                // With cells, regions are sought on a coarser grid than the axes say.
                cells: [regions.x, regions.y][k].count,
                ..axis(&drawn.plane.axes[k], &drawn.plane.keys)
            }),
            accuracy_share: drawn.accuracy,
            labels: labels(regions, &name),
            boundaries: boundaries(regions, &word),
            junctions: junctions(regions, &word),
            impact_speed_m_s: span(drawn, |node| node.impact_speed),
            flat_s: span(drawn, |node| node.flat),
            unresolved_share: regions.crowded,
            cells: self.cells.as_ref().map(MapCells::report),
            run,
        }
    }

    /// The boundaries as CSV, with axes as the picture has them.
    pub fn csv(&self) -> String {
        let [x, y] = self.headings();
        regions_csv(&self.map.map.regions, [&x, &y], &name)
    }

    /// How the axes are called in tables that have their units.
    pub(super) fn headings(&self) -> [String; 2] {
        self.plane.axes.each_ref().map(|axis| {
            let path = &self.plane.keys[axis.key].name;
            if axis.unit().is_empty() { path.clone() } else { format!("{path} [{}]", axis.unit()) }
        })
    }

    /// What every node of the grid measures, as Parquet.
    ///
    /// # Errors
    /// A build without Parquet.
    pub fn nodes(&self) -> Result<Vec<u8>, ColumnsError> {
        let nodes = &self.map.map.nodes;
        let number = |of: &dyn Fn(&Node) -> Option<f64>| Column::Number(nodes.iter().map(of).collect());
        let [x, y] = &self.plane.axes;
        let measured = vec![
            ("ending", "", Column::Word(nodes.iter().map(|node| Some(study::ending(node.ending))).collect())),
            ("impact_speed_m_s", "m/s", number(&|node| node.impact_speed)),
            ("flat_s", "s", number(&|node| node.flat)),
            ("margin", "", number(&|node| node.margin)),
        ];
        self.table([number(&|node| Some(x.si(node.x))), number(&|node| Some(y.si(node.y)))], measured)
    }

    /// A table of places in SI and of what there is at them: a name, a unit and a column each.
    pub(super) fn table(
        &self,
        places: [Column; 2],
        found: Vec<(&str, &str, Column)>,
    ) -> Result<Vec<u8>, ColumnsError> {
        let key = |axis: &Axis| &self.plane.keys[axis.key];
        let mut columns = vec![];
        let mut units = vec![];
        for (axis, place) in self.plane.axes.iter().zip(places) {
            columns.push((key(axis).name.as_str(), place));
            units.push(key(axis).dimension.si());
        }
        for (name, unit, column) in found {
            columns.push((name, column));
            units.push(unit);
        }
        let about = [
            ("scene", self.map.scene.source()),
            ("plate", self.map.scene.feeder().given(self.map.plate)),
            ("version", env!("CARGO_PKG_VERSION")),
        ];
        let mut table = Table::new(&columns, &units, &about)?;
        table.push(&columns)?;
        table.finish()
    }
}

/// The lowest and the highest of a measure.
fn span(drawn: &MapStudy<'_, impl Drawn>, measure: impl Fn(&Node) -> Option<f64>) -> Option<SpanReport> {
    drawn.map.map.nodes.iter().filter_map(measure).fold(None, |span, value| {
        let span = span.unwrap_or(SpanReport { low: value, high: value });
        Some(SpanReport { low: span.low.min(value), high: span.high.max(value) })
    })
}
