//! Cells over the range of the parameters, halved where the posterior is.

use super::Plan;
use super::likelihood::Likelihood;
use super::stats::Stats;
use carom_num::elementary::{exp, ln};
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// Halvings of a side at most: coordinates of nodes are whole numbers up to 2²⁰.
const DEPTH: u32 = 20;
/// Cells of the first division along each side, as a power of two, by how many parameters there are.
const FIRST: [u32; 5] = [0, 7, 6, 4, 2];
/// Cells that are halved before the next look.
const ROUND: usize = 64;
/// A cell that holds less than this share of the posterior, at the best that may lie in it, is left as it is.
const NOTICED: f64 = 1.0e-3;
/// How far, as a logarithm, the best that may lie in a cell is believed before anything near it has been found.
const BELIEVED: f64 = 3.0;
/// Corners whose logarithms of the likelihood differ by less are alike: the density changes by a half between them.
const ALIKE: f64 = 0.4;
/// A straight line between corners may be off by this much, in standard deviations of what was observed.
const STRAIGHT: f64 = 0.1;
/// Halving a side leaves this share of what a straight line along it is off, where what it stands for is smooth.
const LEFT: f64 = 0.25;
/// Differences of the logarithm that are larger all count as this: both sides of it are worlds apart.
const APART: f64 = 50.0;

/// What stands at a node.
pub(super) type Ask<'a> = &'a (dyn Fn(&[f64]) -> Vec<Stats> + Sync);

/// A box, by its lowest and its highest corner.
type Ends = (Vec<u32>, Vec<u32>);

/// When a cell is small enough.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Until {
    /// What the engine says is straight between its corners.
    Straight,
    /// The likelihood is alike at its corners.
    Alike,
}

/// A node: what the engine says there.
pub(super) struct Node {
    pub(super) stats: Vec<Stats>,
    /// Logarithm of the likelihood.
    pub(super) log: f64,
}

/// A box between nodes.
pub(super) struct Cell {
    low: Vec<u32>,
    high: Vec<u32>,
    /// How far a straight line between its corners may be off, along each side.
    off: Vec<f64>,
    /// Logarithm of the likelihood that may lie in it.
    best: f64,
    /// Its least one at a corner.
    least: f64,
    /// Logarithm of its mean.
    mean: f64,
}

/// What a box has become.
enum Branch {
    /// A cell, by its number.
    Cell(usize),
    /// Two halves across an axis, that below and that above this coordinate.
    Halved { axis: usize, at: u32, halves: [usize; 2] },
}

/// All cells and nodes.
pub(super) struct Grid<'a> {
    ranges: &'a [[f64; 2]],
    likelihood: &'a Likelihood,
    ask: Ask<'a>,
    pub(super) nodes: BTreeMap<Vec<u32>, Node>,
    pub(super) cells: Vec<Cell>,
    /// Where each cell stands among the branches.
    places: Vec<usize>,
    branches: Vec<Branch>,
    /// Cells of the first division along a side, as a power of two.
    digits: u32,
}

/// The corners of a box, by the bits of their number: of each side the low or the high end.
fn corners(low: &[u32], high: &[u32]) -> Vec<Vec<u32>> {
    let corner = |bits: usize| {
        (0..low.len()).map(|axis| if bits >> axis & 1 == 1 { high[axis] } else { low[axis] }).collect()
    };
    (0..1 << low.len()).map(corner).collect()
}

impl<'a> Grid<'a> {
    /// The first division; a small budget of nodes makes it coarser.
    pub(super) fn new(plan: &'a Plan, likelihood: &'a Likelihood, ask: Ask<'a>) -> Self {
        let axes = plan.ranges.len();
        let mut digits = FIRST[axes];
        while digits > 1 && ((1usize << digits) + 1).pow(axes as u32) > plan.nodes / 2 {
            digits -= 1;
        }
        let (nodes, cells, places, branches) = (BTreeMap::new(), vec![], vec![], vec![]);
        let ranges = &plan.ranges;
        let mut grid = Self { ranges, likelihood, ask, nodes, cells, places, branches, digits };
        let (side, step) = (1usize << digits, 1u32 << (DEPTH - digits));
        let boxes: Vec<Ends> = (0..side.pow(axes as u32))
            .map(|number| {
                let place = |axis: usize| (number / side.pow(axis as u32) % side) as u32 * step;
                let low: Vec<u32> = (0..axes).map(place).collect();
                let high = low.iter().map(|low| low + step).collect();
                (low, high)
            })
            .collect();
        grid.look_at(&boxes);
        for ends in boxes {
            let cell = grid.cell(ends, vec![f64::INFINITY; axes]);
            grid.branches.push(Branch::Cell(grid.cells.len()));
            grid.places.push(grid.branches.len() - 1);
            grid.cells.push(cell);
        }
        grid
    }

    /// The values of the parameters at a node.
    pub(super) fn values(&self, place: &[u32]) -> Vec<f64> {
        let at = |(place, [low, high]): (&u32, &[f64; 2])| {
            let share = f64::from(*place) / f64::from(1u32 << DEPTH);
            low * (1.0 - share) + high * share
        };
        place.iter().zip(self.ranges).map(at).collect()
    }

    /// Asks the nodes of these boxes that are new, on all cores.
    fn look_at(&mut self, boxes: &[Ends]) {
        let of_boxes = boxes.iter().flat_map(|(low, high)| corners(low, high));
        let new: BTreeSet<Vec<u32>> = of_boxes.filter(|place| !self.nodes.contains_key(place)).collect();
        let new: Vec<Vec<u32>> = new.into_iter().collect();
        let ask = |place: &Vec<u32>| {
            let stats = (self.ask)(&self.values(place));
            let log = self.likelihood.log(&stats);
            Node { stats, log }
        };
        let asked: Vec<Node> = new.par_iter().panic_fuse().map(ask).collect();
        self.nodes.extend(new.into_iter().zip(asked));
    }

    /// The nodes at the corners of a box: all of them have been asked.
    pub(super) fn around(&self, low: &[u32], high: &[u32]) -> Vec<&Node> {
        corners(low, high).iter().filter_map(|place| self.nodes.get(place)).collect()
    }

    fn cell(&self, (low, high): Ends, off: Vec<f64>) -> Cell {
        let around = self.around(&low, &high);
        let stats: Vec<&[Stats]> = around.iter().map(|node| node.stats.as_slice()).collect();
        let between = self.likelihood.log(&self.likelihood.between(&stats));
        let logs: Vec<f64> = around.iter().map(|node| node.log).collect();
        let most = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let least = logs.iter().copied().fold(f64::INFINITY, f64::min);
        let mean = sum_exp(logs.into_iter()) - ln(around.len() as f64);
        Cell { low, high, off, best: between.max(most), least, mean }
    }

    /// Halves cells that may hold a noticeable share of the posterior until they are small enough; false where the budget of nodes ended first.
    pub(super) fn refine(&mut self, until: Until, budget: usize) -> bool {
        loop {
            let found = self.found();
            let possible = self.cells.iter().map(Cell::weight).fold(f64::NEG_INFINITY, f64::max);
            let whole = match until {
                Until::Straight => found.max(possible - BELIEVED),
                Until::Alike => found,
            };
            let noticed = whole + ln(NOTICED);
            let mut open: Vec<(usize, f64)> = (0..self.cells.len())
                .filter(|k| self.cells[*k].is_open(until))
                .map(|k| (k, self.cells[k].weight()))
                .filter(|(_, weight)| weight.is_finite() && *weight > noticed)
                .collect();
            if open.is_empty() {
                return true;
            }
            if self.nodes.len() >= budget {
                return false;
            }
            // The heaviest first; of equal ones the first.
            open.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
            open.truncate(ROUND);
            self.halve(open.into_iter().map(|(k, _)| k).collect(), until);
        }
    }

    /// True where a cell that is still open may hold more than all that has been found: the posterior may lie elsewhere.
    pub(super) fn is_lost(&self) -> bool {
        let open = self.cells.iter().filter(|cell| cell.is_open(Until::Straight)).map(Cell::weight);
        open.fold(f64::NEG_INFINITY, f64::max) - BELIEVED > self.found()
    }

    /// The node where the observations are most probable.
    pub(super) fn best(&self) -> Option<&Node> {
        self.nodes.values().max_by(|a, b| a.log.total_cmp(&b.log))
    }

    /// Logarithm of what the corners of all cells show.
    fn found(&self) -> f64 {
        sum_exp(self.cells.iter().map(|cell| cell.mean + cell.log_volume()))
    }

    fn halve(&mut self, chosen: Vec<usize>, until: Until) {
        let axes: Vec<usize> = chosen.iter().map(|k| self.across(&self.cells[*k], until)).collect();
        let halves: Vec<[Ends; 2]> =
            chosen.iter().zip(&axes).map(|(k, axis)| self.cells[*k].halves(*axis)).collect();
        let boxes: Vec<Ends> = halves.iter().flatten().cloned().collect();
        self.look_at(&boxes);
        for ((k, axis), halves) in chosen.into_iter().zip(axes).zip(halves) {
            let mut off = self.cells[k].off.clone();
            off[axis] = LEFT * self.bent(&self.cells[k], axis);
            let at = halves[0].1[axis];
            let [below, above] = halves.map(|ends| self.cell(ends, off.clone()));
            // One half takes the number of the whole.
            let first = self.branches.len();
            self.branches.push(Branch::Cell(k));
            self.branches.push(Branch::Cell(self.cells.len()));
            self.branches[self.places[k]] = Branch::Halved { axis, at, halves: [first, first + 1] };
            self.places[k] = first;
            self.places.push(first + 1);
            self.cells[k] = below;
            self.cells.push(above);
        }
    }

    /// The axis across which a cell is halved; of equal ones that of the longest side.
    fn across(&self, cell: &Cell, until: Until) -> usize {
        let around = self.around(&cell.low, &cell.high);
        let change = |axis: usize| match until {
            Until::Straight => cell.off[axis],
            Until::Alike => {
                let pairs = (0..around.len()).filter(|bits| bits >> axis & 1 == 0);
                let change = pairs.map(|bits| apart(around[bits].log, around[bits | 1 << axis].log));
                change.fold(0.0, f64::max)
            }
        };
        let length = |axis: usize| cell.high[axis] - cell.low[axis];
        let sides = (0..cell.low.len()).filter(|axis| length(*axis) > 1);
        let across = sides.max_by(|a, b| {
            change(*a).total_cmp(&change(*b)).then(length(*a).cmp(&length(*b))).then(b.cmp(a))
        });
        across.unwrap_or(0)
    }

    /// How far the middles of a cell's sides along an axis are off the straight lines between their ends.
    fn bent(&self, cell: &Cell, axis: usize) -> f64 {
        let middle = |place: &Vec<u32>| {
            let mut place = place.clone();
            place[axis] = cell.low[axis] + (cell.high[axis] - cell.low[axis]) / 2;
            self.nodes.get(&place)
        };
        let places = corners(&cell.low, &cell.high);
        let sides = (0..places.len()).filter(|bits| bits >> axis & 1 == 0);
        let off = sides.filter_map(|bits| {
            let ends = [self.nodes.get(&places[bits])?, self.nodes.get(&places[bits | 1 << axis])?];
            let straight = Stats::mixed(&ends.map(|node| (0.5, node.stats.as_slice())));
            Some(self.likelihood.distance(&straight, &middle(&places[bits])?.stats))
        });
        off.fold(0.0, f64::max)
    }

    /// What stands at a point, by straight lines between the corners of its cell.
    pub(super) fn between(&self, values: &[f64]) -> Vec<Stats> {
        let whole = f64::from(1u32 << DEPTH);
        let at: Vec<f64> = values
            .iter()
            .zip(self.ranges)
            .map(|(value, [low, high])| ((value - low) / (high - low)).clamp(0.0, 1.0) * whole)
            .collect();
        let side = 1usize << self.digits;
        let index = |at: f64| ((at / whole * side as f64) as usize).min(side - 1);
        let mut branch = at.iter().rev().fold(0, |number, at| number * side + index(*at));
        let cell = loop {
            match &self.branches[branch] {
                Branch::Cell(k) => break &self.cells[*k],
                Branch::Halved { axis, at: border, halves } => {
                    branch = halves[usize::from(at[*axis] >= f64::from(*border))];
                }
            }
        };
        let (low, high) = (&cell.low, &cell.high);
        let share = |axis: usize| (at[axis] - f64::from(low[axis])) / f64::from(high[axis] - low[axis]);
        let shares: Vec<f64> = (0..at.len()).map(share).collect();
        let weight = |bits: usize| -> f64 {
            let side = |axis: usize| if bits >> axis & 1 == 1 { shares[axis] } else { 1.0 - shares[axis] };
            (0..at.len()).map(side).product()
        };
        let around = self.around(low, high);
        let weighted: Vec<(f64, &[Stats])> =
            around.iter().enumerate().map(|(bits, node)| (weight(bits), node.stats.as_slice())).collect();
        Stats::mixed(&weighted)
    }
}

/// How far two logarithms are apart, as far as that matters.
fn apart(a: f64, b: f64) -> f64 {
    if a == b { 0.0 } else { (a - b).abs().min(APART) }
}

/// Logarithm of the sum of what these are the logarithms of.
pub(super) fn sum_exp(logs: impl Iterator<Item = f64> + Clone) -> f64 {
    let most = logs.clone().fold(f64::NEG_INFINITY, f64::max);
    if most == f64::NEG_INFINITY { most } else { most + ln(logs.map(|log| exp(log - most)).sum::<f64>()) }
}

impl Cell {
    /// The ends of its sides.
    pub(super) fn ends(&self) -> (&[u32], &[u32]) {
        (&self.low, &self.high)
    }

    /// Logarithm of its volume, in shares of the range.
    pub(super) fn log_volume(&self) -> f64 {
        let share = |(low, high): (&u32, &u32)| ln(f64::from(high - low) / f64::from(1u32 << DEPTH));
        self.low.iter().zip(&self.high).map(share).sum()
    }

    /// Logarithm of what it may hold.
    fn weight(&self) -> f64 {
        self.best + self.log_volume()
    }

    fn halves(&self, axis: usize) -> [Ends; 2] {
        let middle = self.low[axis] + (self.high[axis] - self.low[axis]) / 2;
        let (mut under, mut over) = (self.high.clone(), self.low.clone());
        (under[axis], over[axis]) = (middle, middle);
        [(self.low.clone(), under), (over, self.high.clone())]
    }

    /// True where it may hold what its corners do not show.
    fn is_open(&self, until: Until) -> bool {
        let divisible = self.low.iter().zip(&self.high).any(|(low, high)| high - low > 1);
        divisible
            && match until {
                Until::Straight => self.off.iter().any(|off| *off > STRAIGHT),
                Until::Alike => apart(self.best, self.least) > ALIKE,
            }
    }
}
