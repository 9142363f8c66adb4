//! Which cells are halved, and what the finest ones hold.

use super::cell::{Around, Cell, Run, divide};
use super::junction::Window;
use super::lattice::{Lattice, Side};
use super::{Junction, Label, Patch};
use std::collections::BTreeSet;
use std::ops::Range;

/// What a line through a cell joins.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Vertex {
    /// A crossing, by number.
    Crossing(usize),
    /// A junction, by number.
    Junction(usize),
}

/// A straight piece of a boundary.
#[derive(Clone, Copy, Debug)]
pub(super) struct Link<L> {
    pub(super) ends: [Vertex; 2],
    pub(super) pair: [L; 2],
}

/// What the leaves hold.
pub(super) struct Drawn<L> {
    pub(super) links: Vec<Link<L>>,
    pub(super) junctions: Vec<Junction<L>>,
    pub(super) patches: Vec<Patch<L>>,
    /// Cells of the smallest size that hold more than one line.
    pub(super) crowded: usize,
}

/// Halves the cells of these rows until each holds one line at most, or is as small as allowed.
pub(super) fn leaves<L: Label>(lattice: &mut Lattice<'_, L>, rows: Range<usize>) -> BTreeSet<Cell> {
    let size = lattice.coarse;
    let columns = lattice.steps[0] / size;
    let cells = rows.flat_map(|j| (0..columns).map(move |i| (i, j)));
    let mut leaves: BTreeSet<Cell> =
        cells.map(|(i, j)| Cell { row: j * size, column: i * size, size }).collect();
    loop {
        look_ahead(lattice, &leaves);
        // A cell that is halved shows its neighbours more of the common side: they are judged again.
        let crowded: Vec<Cell> =
            leaves.iter().copied().filter(|cell| cell.size > 1 && is_crowded(lattice, cell)).collect();
        if crowded.is_empty() {
            return leaves;
        }
        for cell in crowded {
            leaves.remove(&cell);
            cell.sides().into_iter().for_each(|side| lattice.split(side));
            leaves.extend(cell.quarters());
        }
    }
}

/// Asks at once for all that the judgement of these cells will ask for.
fn look_ahead<L: Label>(lattice: &mut Lattice<'_, L>, leaves: &BTreeSet<Cell>) {
    let places = |cell: &Cell| {
        let half = cell.size / 2;
        let sides = cell.sides().into_iter();
        let on_sides = sides.flat_map(move |side| [0, half, side.length].map(|steps| side.node(steps)));
        on_sides.chain([[cell.column + half, cell.row + half]])
    };
    lattice.learn(leaves.iter().filter(|cell| cell.size > 1).flat_map(places));
    let sides: Vec<Side> =
        leaves.iter().flat_map(Cell::sides).filter(|side| !lattice.is_split(side)).collect();
    lattice.learn(sides.iter().flat_map(|side| [side.start, side.node(side.length)]));
    lattice.cross(sides.into_iter());
}

/// True where a cell holds more than one line can explain.
fn is_crowded<L: Label>(lattice: &mut Lattice<'_, L>, cell: &Cell) -> bool {
    let half = cell.size / 2;
    let centre = lattice.label([cell.column + half, cell.row + half]);
    let fits = match lattice.around(cell) {
        Around::Uniform(label) => centre == label,
        Around::Runs(runs) => runs.len() == 2 && runs.iter().any(|run| run.label == centre),
    };
    // Between different ends the bisection has looked at the middle already.
    !fits
        || cell.sides().into_iter().any(|side| {
            let [low, middle, high] = [0, half, side.length].map(|steps| lattice.label(side.node(steps)));
            low == high && middle != low
        })
}

/// Joins the crossings within every leaf, and finds the junctions.
pub(super) fn draw<L: Label>(lattice: &mut Lattice<'_, L>, leaves: &BTreeSet<Cell>) -> Drawn<L> {
    let mut drawn = Drawn { links: vec![], junctions: vec![], patches: vec![], crowded: 0 };
    for cell in leaves {
        match lattice.around(cell) {
            Around::Uniform(label) => {
                let corners = [(0, 0), (1, 0), (1, 1), (0, 1)];
                let outline = corners.map(|(u, v)| {
                    let node = [cell.column + u * cell.size, cell.row + v * cell.size];
                    lattice.point(lattice.shares(node))
                });
                drawn.patches.push(Patch { label, outline: outline.to_vec() });
            }
            Around::Runs(runs) => fill(lattice, cell, runs, &mut drawn),
        }
    }
    drawn
}

fn fill<L: Label>(lattice: &mut Lattice<'_, L>, cell: &Cell, runs: Vec<Run<L>>, drawn: &mut Drawn<L>) {
    let low = lattice.shares([cell.column, cell.row]);
    let high = lattice.shares([cell.column + cell.size, cell.row + cell.size]);
    drawn.crowded += usize::from(cell.size == 1 && runs.len() > 2);
    let window = Window { low, size: [high[0] - low[0], high[1] - low[1]] };
    let centre = lattice.ask([0, 1].map(|axis| 0.5 * (low[axis] + high[axis])));
    let division = divide(runs, centre);
    for [a, b] in division.joined {
        let pair = sorted(lattice.crossings[a].pair);
        drawn.links.push(Link { ends: [Vertex::Crossing(a), Vertex::Crossing(b)], pair });
    }
    drawn.patches.extend(division.pieces.into_iter().map(|(label, outline)| Patch { label, outline }));
    if !division.meeting.is_empty() {
        meet(lattice, window, division.meeting, drawn);
    }
}

/// Leads every crossing that is left to a junction between its two labels.
fn meet<L: Label>(lattice: &mut Lattice<'_, L>, window: Window, runs: Vec<Run<L>>, drawn: &mut Drawn<L>) {
    let mut found = lattice.junctions(window);
    if found.is_empty() {
        // The labels meet, but nowhere that a smaller window shows: the cell itself is the answer.
        let labels = runs.iter().map(|run| run.label).collect();
        let middle = [0, 1].map(|axis| window.low[axis] + 0.5 * window.size[axis]);
        let accuracy = 0.5 * window.size[0].max(window.size[1]);
        found.push(Junction { labels, at: lattice.point(middle), accuracy });
    }
    let same = 4.0 * lattice.accuracy;
    let found: Vec<usize> =
        found.into_iter().map(|junction| register(junction, lattice.ranges, same, drawn)).collect();
    let pair_of = |run: &Run<L>| sorted(lattice.crossings[run.enter].pair);
    let leads_to = |run: &Run<L>| {
        let labels = |number: &usize| &drawn.junctions[*number].labels;
        let fits = |number: &usize| pair_of(run).iter().all(|label| labels(number).contains(label));
        found.iter().copied().find(fits).unwrap_or(found[0])
    };
    let numbers: Vec<usize> = runs.iter().map(leads_to).collect();
    for (k, run) in runs.iter().enumerate() {
        let ends = [Vertex::Crossing(run.enter), Vertex::Junction(numbers[k])];
        drawn.links.push(Link { ends, pair: pair_of(run) });
        let mut outline = run.outline.clone();
        let next = numbers[(k + 1) % numbers.len()];
        outline.push(drawn.junctions[next].at);
        if next != numbers[k] {
            outline.push(drawn.junctions[numbers[k]].at);
        }
        drawn.patches.push(Patch { label: run.label, outline });
    }
    join(&found, drawn);
}

/// The number of a junction; one that a neighbouring cell has found already keeps its own.
fn register<L: Copy + Ord>(
    junction: Junction<L>,
    ranges: [super::Range; 2],
    same: f64,
    drawn: &mut Drawn<L>,
) -> usize {
    let near = |known: &Junction<L>| {
        (0..2).all(|axis| {
            (known.at[axis] - junction.at[axis]).abs() <= same * (ranges[axis].to - ranges[axis].from)
        })
    };
    match drawn.junctions.iter().position(near) {
        Some(number) => {
            if junction.labels.len() > drawn.junctions[number].labels.len() {
                drawn.junctions[number] = junction;
            }
            number
        }
        None => {
            drawn.junctions.push(junction);
            drawn.junctions.len() - 1
        }
    }
}

/// Draws a line between two junctions of a cell that have two labels in common.
fn join<L: Copy + Ord>(numbers: &[usize], drawn: &mut Drawn<L>) {
    for (k, &b) in numbers.iter().enumerate() {
        for &a in numbers[..k].iter().filter(|&&a| a != b) {
            let others = &drawn.junctions[b].labels;
            let common: Vec<L> =
                drawn.junctions[a].labels.iter().copied().filter(|label| others.contains(label)).collect();
            if let [p, q] = common[..] {
                drawn
                    .links
                    .push(Link { ends: [Vertex::Junction(a), Vertex::Junction(b)], pair: sorted([p, q]) });
            }
        }
    }
}

pub(super) fn sorted<L: Ord>([a, b]: [L; 2]) -> [L; 2] {
    if a <= b { [a, b] } else { [b, a] }
}
