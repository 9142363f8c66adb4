//! The files of a sweep: steps, and the parts that they are put into.

use crate::folder::{Counts, ENDINGS, FINGERPRINT, Folder, ROWS, Rows, rows};
use crate::{Of, no_json};
use carom::tasks::StudyError;
use carom::tasks::axes::{Asker, keys};
use carom::tasks::sweep::{FOUND, found};
use carom_scene::columns::{Column, ColumnsError, SEAL, Table, sealed};
use carom_scene::{ColumnReport, Drawn};
use carom_study::{Dropped, Landed};
use carom_words::part::Names;
use carom_words::study;
use std::collections::BTreeMap;
use std::ops::Range;

/// The columns of a sweep and their units, in their order.
pub(crate) fn described(sweep: &Of<'_, impl Drawn>) -> Vec<ColumnReport> {
    let keys = keys(sweep.scene, Asker::Call);
    let unit = |path: &String| {
        let key = keys.iter().find(|key| key.name == *path);
        (path.clone(), key.map_or("", |key| key.dimension.si()))
    };
    let quantities = sweep.designs.paths().iter().map(unit);
    let found = FOUND.iter().map(|(name, unit)| ((*name).to_owned(), *unit));
    std::iter::once(("design".to_owned(), ""))
        .chain(quantities)
        .chain(found)
        .map(|(name, unit)| ColumnReport { name, unit: unit.to_owned() })
        .collect()
}

/// One step as a file.
pub(crate) fn step(
    sweep: &Of<'_, impl Drawn>,
    folder: &Folder<'_>,
    step: u64,
    (designs, drops): (&[Vec<f64>], &[Dropped<impl Landed>]),
) -> Result<Vec<u8>, StudyError> {
    let range = sweep.of_step(step);
    let quantity = |i: usize| Column::Number(designs.iter().map(|design| design.get(i).copied()).collect());
    let mut columns = vec![Column::Whole(range.clone().map(|row| i64::try_from(row).ok()).collect())];
    columns.extend((0..sweep.designs.paths().len()).map(quantity));
    columns.extend(found(drops, sweep.plate));
    let names = described(sweep).into_iter().map(|column| column.name);
    let mut file = File::new(sweep, folder, range, &counts(drops))?;
    file.push(&names.zip(columns).collect::<Rows>())?;
    file.finish()
}

/// How often each ending occurs.
fn counts<R>(drops: &[Dropped<R>]) -> Counts {
    let mut counts = BTreeMap::new();
    for dropped in drops {
        *counts.entry(study::ending(dropped.ending)).or_insert(0) += 1;
    }
    counts
}

/// A part file from its steps, and its endings; `None` where a step is no longer there as a whole.
pub(crate) fn part(
    sweep: &Of<'_, impl Drawn>,
    folder: &Folder<'_>,
    part: u64,
) -> Result<Option<(Vec<u8>, Counts)>, StudyError> {
    let steps = sweep.steps_of(part);
    let mut counts = Counts::new();
    for step in steps.clone() {
        let Some(of_step) = folder.of_step(step, &sweep.of_step(step))? else { return Ok(None) };
        for (ending, count) in of_step {
            *counts.entry(ending).or_insert(0) += count;
        }
    }
    let mut file = File::new(sweep, folder, sweep.of_part(part), &counts)?;
    let each = sweep.sizes.group / sweep.sizes.step;
    for first in steps.clone().step_by(usize::try_from(each).unwrap_or(1)) {
        let mut group: Rows = vec![];
        for step in first..(first + each).min(steps.end) {
            let Some(rows) = folder.columns(step, &sweep.of_step(step))? else { return Ok(None) };
            if group.is_empty() {
                group = rows;
                continue;
            }
            for ((_, column), (_, below)) in group.iter_mut().zip(rows) {
                column.append(below);
            }
        }
        file.push(&group)?;
    }
    Ok(Some((file.finish()?, counts)))
}

/// A file that is being written.
struct File {
    table: Table,
}

fn undone(error: ColumnsError) -> StudyError {
    StudyError::Undone(error.to_string())
}

fn named(rows: &Rows) -> Vec<(&str, Column)> {
    rows.iter().map(|(name, column)| (name.as_str(), column.clone())).collect()
}

impl File {
    /// A file of these designs, without rows as yet.
    fn new(
        sweep: &Of<'_, impl Drawn>,
        folder: &Folder<'_>,
        range: Range<u64>,
        counts: &Counts,
    ) -> Result<Self, StudyError> {
        let described = described(sweep);
        let units: Vec<&str> = described.iter().map(|column| column.unit.as_str()).collect();
        let counts = serde_json::to_string(counts).map_err(no_json)?;
        let about = [
            ("scene", sweep.scene.source()),
            ("plate", sweep.scene.feeder().given(sweep.plate)),
            ("version", env!("CARGO_PKG_VERSION")),
            (ENDINGS, &counts),
            (FINGERPRINT, folder.fingerprint()),
            (ROWS, &rows(&range)),
            SEAL,
        ];
        let columns: Rows =
            described.iter().map(|column| (column.name.clone(), empty(&column.name))).collect();
        Ok(Self { table: Table::new(&named(&columns), &units, &about).map_err(undone)? })
    }

    fn push(&mut self, rows: &Rows) -> Result<(), StudyError> {
        self.table.push(&named(rows)).map_err(undone)
    }

    fn finish(self) -> Result<Vec<u8>, StudyError> {
        let bytes = self.table.finish().map_err(undone)?;
        sealed(bytes).ok_or_else(|| StudyError::Undone("the table has no place for its seal".to_owned()))
    }
}

/// A column without rows, of the kind that the one of this name has.
fn empty(name: &str) -> Column {
    match name {
        "design" => Column::Whole(vec![]),
        "ending" | "outcome" => Column::Word(vec![]),
        _ => Column::Number(vec![]),
    }
}
