//! The designs of a sweep: a grid, or a list in a file.

use crate::DesignsAsked;
use crate::list_file::{Lines, ListFile};
use carom::tasks::StudyError;
use carom::tasks::axes::{Axis, Complaints, Key, quantity, read_axis, unknown};
use carom::tasks::axes::{keys, named};
use carom::tasks::records;
use carom_scene::{Drawn, Problem, ProblemKind, Problems};
use std::ops::{Range, RangeInclusive};
use std::path::Path;

/// Points of an axis of a grid: both ends are.
const POINTS: RangeInclusive<usize> = 2..=1_000_000;
/// Most designs of a sweep.
const MOST_DESIGNS: u64 = 1 << 40;
/// Problems of a list that are told one by one.
const MOST_TOLD: usize = 50;

/// The designs, by number.
pub(crate) enum Designs {
    /// Every combination, the last quantity running fastest.
    Grid { paths: Vec<String>, axes: Vec<Axis>, len: u64 },
    /// The rows of a file.
    List { paths: Vec<String>, keys: Vec<Key>, file: ListFile, len: u64 },
}

/// Reads a grid or a list.
pub(crate) fn read(
    scene: &impl Drawn,
    asked: DesignsAsked<'_>,
    complaints: &mut Complaints,
) -> Result<Designs, StudyError> {
    let keys = keys(scene, complaints.asker());
    match asked {
        DesignsAsked::List(file) => list(scene, keys, file),
        DesignsAsked::Grid(ranges) => Ok(grid(scene, &keys, ranges, complaints)),
    }
}

fn grid(scene: &impl Drawn, keys: &[Key], texts: &[String], complaints: &mut Complaints) -> Designs {
    let (mut paths, mut axes, mut len): (Vec<String>, Vec<Axis>, u64) = (vec![], vec![], 1);
    if texts.is_empty() {
        let list = complaints.asker().option("list");
        complaints.push("grid", format!("missing: PATH=A..B:POINTS, once for each quantity, or {list} FILE"));
    }
    for text in texts {
        let text = named(scene, text);
        let Some(axis) = read_axis(keys, "grid", &text, &("points", POINTS), complaints) else { continue };
        let path = keys[axis.key].name.clone();
        if paths.contains(&path) {
            complaints.push(&format!("grid {text}"), format!("{path} is in the grid already"));
        }
        len = len.saturating_mul(axis.range.count as u64);
        paths.push(path);
        axes.push(axis);
    }
    if len > MOST_DESIGNS {
        complaints.push("grid", format!("{len} designs: at most {MOST_DESIGNS} are swept"));
    }
    Designs::Grid { paths, axes, len }
}

fn problem(kind: ProblemKind, line: u64, message: String) -> Problem {
    Problem::new(kind, format!("line {line}"), message, None)
}

/// Reads the whole list once: how many designs there are, and what is wrong with any of them.
fn list(scene: &impl Drawn, keys: Vec<Key>, file: &Path) -> Result<Designs, StudyError> {
    let name = file.display().to_string();
    let file = ListFile::new(file)?;
    let mut lines = file.lines()?;
    let Some(head) = lines.next().transpose()? else {
        let message = "the file is empty: its first line names the quantities".to_owned();
        return Err(Problems::new(&name, "", vec![problem(ProblemKind::File, 1, message)]).into());
    };
    let mut problems = vec![];
    let (mut paths, mut columns): (Vec<String>, Vec<Key>) = (vec![], vec![]);
    let head = records::cells(head.trim_start_matches('\u{feff}'));
    let head = head.unwrap_or_else(|message| {
        problems.push(problem(ProblemKind::WrongValue, 1, message));
        vec![]
    });
    for path in head {
        let path = scene.canonical(&path);
        match keys.iter().find(|key| key.name == path) {
            Some(_) if paths.contains(&path) => {
                problems.push(problem(ProblemKind::Conflict, 1, format!("{path} is named twice")));
            }
            Some(key) => columns.push(key.clone()),
            None => {
                problems.push(problem(ProblemKind::UnknownKey, 1, unknown(&keys, &path)));
            }
        }
        paths.push(path);
    }
    let (mut len, mut more) = (0, 0);
    // Without good columns every row would be told as wrong.
    if problems.is_empty() {
        for (number, line) in (2..).zip(lines) {
            let line = line?;
            if line.trim().is_empty() {
                continue;
            }
            len += 1;
            if let Err(mut messages) = row(&columns, &line) {
                let room = MOST_TOLD.saturating_sub(problems.len()).min(messages.len());
                more += messages.split_off(room).len();
                let told = messages.into_iter().map(|text| problem(ProblemKind::WrongValue, number, text));
                problems.extend(told);
            }
        }
        if len == 0 {
            problems.push(problem(ProblemKind::File, 2, "there are no designs in the list".to_owned()));
        }
    }
    if problems.is_empty() {
        Ok(Designs::List { paths, keys: columns, file, len })
    } else {
        Err(StudyError::from(Problems::new(&name, "", problems).and_more(more)))
    }
}

/// The values of a row, SI, or everything that is wrong with it.
fn row(keys: &[Key], line: &str) -> Result<Vec<f64>, Vec<String>> {
    let cells = records::cells(line).map_err(|message| vec![message])?;
    if cells.len() != keys.len() {
        return Err(vec![format!("{} values for {} quantities", cells.len(), keys.len())]);
    }
    let (mut values, mut wrong) = (vec![], vec![]);
    for (key, cell) in keys.iter().zip(cells) {
        match quantity(&cell, key.dimension).map(|value| (value, key.outside(value))) {
            Ok((value, None)) => values.push(value),
            Ok((_, Some(message))) => wrong.push(format!("{}: {message}", key.name)),
            Err(message) => wrong.push(format!("{} \"{cell}\": {message}", key.name)),
        }
    }
    if wrong.is_empty() { Ok(values) } else { Err(wrong) }
}

impl Designs {
    /// The quantities that differ from design to design.
    pub(crate) fn paths(&self) -> &[String] {
        match self {
            Self::Grid { paths, .. } | Self::List { paths, .. } => paths,
        }
    }

    /// How many designs there are.
    pub(crate) fn len(&self) -> u64 {
        match self {
            Self::Grid { len, .. } | Self::List { len, .. } => *len,
        }
    }

    /// What is swept, in words that tell one sweep from another.
    pub(crate) fn described(&self) -> Result<Vec<String>, StudyError> {
        match self {
            Self::Grid { paths, axes, .. } => Ok(paths
                .iter()
                .zip(axes)
                .map(|(path, axis)| {
                    let range = axis.range;
                    format!("{path}={}..{} {}:{}", range.from, range.to, axis.unit(), range.count)
                })
                .collect()),
            Self::List { file, .. } => Ok(vec![format!("list of {}", file.fingerprint()?)]),
        }
    }

    /// Reads designs from the first to the last.
    pub(crate) fn reader(&self) -> Result<Reader<'_>, StudyError> {
        let lines = match self {
            Self::Grid { .. } => None,
            Self::List { file, .. } => {
                let mut lines = file.lines()?;
                lines.next().transpose()?;
                Some(lines)
            }
        };
        Ok(Reader { designs: self, lines, next: 0 })
    }
}

/// Designs in order.
pub(crate) struct Reader<'d> {
    designs: &'d Designs,
    lines: Option<Lines>,
    next: u64,
}

impl Reader<'_> {
    /// The values of these designs, SI; later ones than those taken before.
    pub(crate) fn take(&mut self, numbers: Range<u64>) -> Result<Vec<Vec<f64>>, StudyError> {
        match self.designs {
            Designs::Grid { axes, .. } => Ok(numbers.map(|number| on_grid(axes, number)).collect()),
            Designs::List { keys, file, .. } => self.listed(keys, file, numbers),
        }
    }

    fn listed(
        &mut self,
        keys: &[Key],
        file: &ListFile,
        numbers: Range<u64>,
    ) -> Result<Vec<Vec<f64>>, StudyError> {
        let mut found = vec![];
        while self.next < numbers.end {
            let Some(line) = self.lines.as_mut().and_then(Iterator::next) else {
                return Err(StudyError::Undone(format!(
                    "{} became shorter while it was read",
                    file.path().display()
                )));
            };
            let line = line?;
            if line.trim().is_empty() {
                continue;
            }
            // The list was checked as a whole before: a row that is bad now has been written since.
            if numbers.contains(&self.next) {
                let values = row(keys, &line).map_err(|wrong| {
                    StudyError::Undone(format!(
                        "{} changed while it was read: {}",
                        file.path().display(),
                        wrong.join("; ")
                    ))
                })?;
                found.push(values);
            }
            self.next += 1;
        }
        Ok(found)
    }
}

/// The values of a design of a grid.
fn on_grid(axes: &[Axis], number: u64) -> Vec<f64> {
    let mut left = number;
    let mut values: Vec<f64> = axes
        .iter()
        .rev()
        .map(|axis| {
            let count = axis.range.count as u64;
            let place = left % count;
            left /= count;
            let share = if count > 1 { place as f64 / (count - 1) as f64 } else { 0.0 };
            axis.si(axis.range.at(share))
        })
        .collect();
    values.reverse();
    values
}
