//! How the drop at the middle of every cell of a map ends: as a table and as JSON.

use super::MapStudy;
use carom_scene::columns::{Column, ColumnsError};
use carom_scene::{CellsEndingReport, CellsReport, Drawn, EndingWord};
use carom_study::Ending;
use carom_study::regions::Range;
use carom_words::study;
use std::collections::BTreeMap;

/// Cells of a map.
///
/// # Example
/// ```
/// use carom::{prelude::*, tasks::{axes::Asker, map::{MapAsked, MapStudy}}};
/// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
/// let axes = ["contact.friction=0.05..0.17:24", "contact.restitution=0..0.4:24"];
/// let asked = MapAsked { cells: true, ..MapAsked::over(axes, Asker::Command) };
/// let (scene, plate, plane) = asked.read(&scene).unwrap();
/// let study = MapStudy::drawn(&scene, plate, plane, &asked, || {}).unwrap();
/// let table = study.cells_csv().unwrap();
/// assert_eq!(table.lines().nth(1), Some("0.0525,0.008333333333333333,same side"));
/// assert_eq!(table.lines().count(), 1 + 24 * 24);
/// assert!(study.map.map.drops < 24 * 24);
/// # Ok::<(), carom::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct MapCells {
    /// Abscissa and ordinate, in the units they are shown in, with the number of cells.
    pub ranges: [Range; 2],
    /// How each cell ends, row by row from the lowest ordinate up.
    pub labels: Vec<Ending>,
}

impl MapCells {
    /// Columns and rows.
    pub fn counts(&self) -> [usize; 2] {
        self.ranges.map(|range| range.count)
    }

    /// How many cells end in which way.
    pub fn endings(&self) -> BTreeMap<Ending, usize> {
        let mut counted = BTreeMap::new();
        self.labels.iter().for_each(|ending| *counted.entry(*ending).or_default() += 1);
        counted
    }

    /// The middle of each cell, as it is shown, and how it ends.
    fn each(&self) -> impl Iterator<Item = ([f64; 2], Ending)> {
        let middle = |axis: usize, k: usize| {
            let range = self.ranges[axis];
            range.at((k as f64 + 0.5) / range.count as f64)
        };
        let columns = self.ranges[0].count;
        let labels = self.labels.iter().enumerate();
        labels.map(move |(k, ending)| ([middle(0, k % columns), middle(1, k / columns)], *ending))
    }

    pub(super) fn report(&self) -> CellsReport {
        let [columns, rows] = self.counts();
        let counted = |(ending, cells)| CellsEndingReport { ending: EndingWord(ending), cells };
        let endings = self.endings().into_iter().map(counted);
        CellsReport { columns, rows, endings: endings.collect() }
    }
}

impl<S: Drawn> MapStudy<'_, S> {
    /// How every cell ends, as CSV: the middle of each, with axes as the picture has them. `None` where cells were not asked for.
    pub fn cells_csv(&self) -> Option<String> {
        let cells = self.cells.as_ref()?;
        let [x, y] = self.headings();
        let head = format!("{},{},ending\n", carom_figure::csv_cell(&x), carom_figure::csv_cell(&y));
        let rows = cells
            .each()
            .map(|([x, y], ending)| format!("{x},{y},{}\n", carom_figure::csv_cell(&study::ending(ending))));
        Some(std::iter::once(head).chain(rows).collect())
    }

    /// The same as Parquet, in SI.
    ///
    /// # Errors
    /// A build without Parquet.
    pub fn cells_table(&self) -> Option<Result<Vec<u8>, ColumnsError>> {
        let cells = self.cells.as_ref()?;
        let place = |axis: usize| {
            let si = &self.plane.axes[axis];
            Column::Number(cells.each().map(|(at, _)| Some(si.si(at[axis]))).collect())
        };
        let endings = Column::Word(cells.labels.iter().map(|ending| Some(study::ending(*ending))).collect());
        Some(self.table([place(0), place(1)], vec![("ending", "", endings)]))
    }
}
