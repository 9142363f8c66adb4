//! A cell: the labels around it, and how the crossings on its sides belong together.

use super::Label;
use super::lattice::{Crossing, Lattice, Side};

/// A square of the lattice: its lowest node and its size in finest steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Cell {
    /// y before x, so that cells of a row follow each other.
    pub(super) row: usize,
    pub(super) column: usize,
    pub(super) size: usize,
}

impl Cell {
    /// Bottom, right, top, left; the last two are walked backwards.
    pub(super) fn sides(&self) -> [Side; 4] {
        let Self { row, column, size } = *self;
        let side = |axis, x, y| Side { axis, start: [x, y], length: size };
        [side(0, column, row), side(1, column + size, row), side(0, column, row + size), side(1, column, row)]
    }

    pub(super) fn quarters(&self) -> [Cell; 4] {
        let half = self.size / 2;
        [(0, 0), (0, half), (half, 0), (half, half)].map(|(up, along)| Cell {
            row: self.row + up,
            column: self.column + along,
            size: half,
        })
    }
}

/// A stretch of a closed line on which the label stays the same, entered through a crossing.
#[derive(Clone, Debug)]
pub(super) struct Run<L> {
    pub(super) label: L,
    pub(super) enter: usize,
    /// From the crossing it is entered through to the one it is left through.
    pub(super) outline: Vec<[f64; 2]>,
}

/// What a closed line around a cell passes.
pub(super) enum Stop {
    Node([f64; 2]),
    Crossing { number: usize, forward: bool },
}

/// What stands around a cell.
pub(super) enum Around<L> {
    /// One label.
    Uniform(L),
    /// Several: at least two runs, in counter-clockwise order.
    Runs(Vec<Run<L>>),
}

impl<L: Label> Lattice<'_, L> {
    fn walk(&mut self, side: Side, forward: bool, stops: &mut Vec<Stop>) {
        if self.is_split(&side) {
            let [first, second] = side.halves();
            for half in if forward { [first, second] } else { [second, first] } {
                self.walk(half, forward, stops);
            }
            return;
        }
        let node = if forward { side.start } else { side.node(side.length) };
        stops.push(Stop::Node(self.point(self.shares(node))));
        let mut crossings = self.crossings_of(side);
        if !forward {
            crossings.reverse();
        }
        stops.extend(crossings.into_iter().map(|number| Stop::Crossing { number, forward }));
    }

    /// The labels around a cell, with all that its neighbours know of its sides.
    pub(super) fn around(&mut self, cell: &Cell) -> Around<L> {
        let mut stops = vec![];
        for (k, side) in cell.sides().into_iter().enumerate() {
            self.walk(side, k < 2, &mut stops);
        }
        let runs = runs(&stops, &self.crossings);
        if runs.is_empty() {
            Around::Uniform(self.label([cell.column, cell.row]))
        } else {
            Around::Runs(runs)
        }
    }
}

/// The runs of a closed line.
pub(super) fn runs<L: Copy>(stops: &[Stop], crossings: &[Crossing<L>]) -> Vec<Run<L>> {
    let mut runs: Vec<Run<L>> = vec![];
    let mut before_first = vec![];
    for stop in stops {
        match *stop {
            Stop::Node(point) => {
                runs.last_mut().map_or(&mut before_first, |run| &mut run.outline).push(point)
            }
            Stop::Crossing { number, forward } => {
                let Crossing { at, pair: [before, after] } = crossings[number];
                runs.last_mut().map_or(&mut before_first, |run| &mut run.outline).push(at);
                let label = if forward { after } else { before };
                runs.push(Run { label, enter: number, outline: vec![at] });
            }
        }
    }
    if let Some(last) = runs.last_mut() {
        last.outline.append(&mut before_first);
    }
    runs
}

/// How the runs around a cell divide it.
pub(super) struct Division<L> {
    /// Crossings that are joined by a line through the cell.
    pub(super) joined: Vec<[usize; 2]>,
    /// The pieces that are complete.
    pub(super) pieces: Vec<(L, Vec<[f64; 2]>)>,
    /// Runs whose regions must meet in the cell: three or more, or none.
    pub(super) meeting: Vec<Run<L>>,
}

/// Joins crossings in pairs for as long as a run lies between two of one label, and says what is left.
///
/// A run between equal neighbours is cut off by a line. Where several runs can be cut off, those are that differ from the label at the centre.
pub(super) fn divide<L: Copy + Ord>(mut runs: Vec<Run<L>>, centre: L) -> Division<L> {
    let mut division = Division { joined: vec![], pieces: vec![], meeting: vec![] };
    while runs.len() > 2 {
        let n = runs.len();
        let can = |k: &usize| runs[(k + n - 1) % n].label == runs[(k + 1) % n].label;
        let off_centre = (0..n).find(|k| can(k) && runs[*k].label != centre);
        let Some(k) = off_centre.or_else(|| (0..n).find(can)) else {
            division.meeting = runs;
            return division;
        };
        runs.rotate_left(k);
        // Now the run to cut off comes first, its neighbours are the second and the last.
        let cut = runs.remove(0);
        let next = runs.remove(0);
        division.joined.push([cut.enter, next.enter]);
        division.pieces.push((cut.label, cut.outline));
        if let Some(last) = runs.last_mut() {
            last.outline.extend(next.outline);
        }
    }
    if let [first, second] = &runs[..] {
        division.joined.push([first.enter, second.enter]);
    }
    division.pieces.extend(runs.into_iter().map(|run| (run.label, run.outline)));
    division
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(labels: &[u8]) -> Vec<Run<u8>> {
        labels.iter().enumerate().map(|(enter, &label)| Run { label, enter, outline: vec![] }).collect()
    }

    #[test]
    fn a_band_through_a_cell_needs_no_meeting_point() {
        let division = divide(ring(&[1, 2, 3, 2]), 2);
        assert_eq!((division.joined, division.meeting.len()), (vec![[0, 1], [2, 3]], 0), "1 | 2 | 3");
    }

    #[test]
    fn a_saddle_is_joined_as_its_centre_says() {
        assert_eq!(divide(ring(&[1, 2, 1, 2]), 2).joined, [[0, 1], [2, 3]], "the twos are one");
        assert_eq!(divide(ring(&[1, 2, 1, 2]), 1).joined, [[1, 2], [3, 0]], "the ones are one");
    }

    #[test]
    fn three_different_labels_must_meet() {
        let division = divide(ring(&[1, 2, 3]), 1);
        assert_eq!((division.joined.len(), division.meeting.len()), (0, 3), "a triple point");
        let division = divide(ring(&[1, 2, 4, 2, 3]), 1);
        assert_eq!(
            (division.joined, division.meeting.len()),
            (vec![[2, 3]], 3),
            "and a tongue of 4 beside it"
        );
    }
}
