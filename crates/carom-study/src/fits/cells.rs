//! Cells over the range of the parameters, halved where the posterior is.

use super::likelihood::{Likelihood, Stats};
use super::{FitError, Plan, Simulated};
use carom_num::elementary::{exp, ln};
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// Halvings of a side at most: coordinates of nodes are whole numbers up to 2²⁰.
const DEPTH: u32 = 20;
/// Cells of the first division along each side, as a power of two, by how many parameters there are.
const FIRST: [u32; 5] = [0, 6, 4, 3, 2];
/// Cells that are halved before the next look.
const ROUND: usize = 64;
/// A cell that holds less than this share of the posterior, at the best that may lie in it, is left as it is.
const NOTICED: f64 = 1.0e-3;
/// Corners whose logarithms of the likelihood differ by less are alike: the density changes by a half between them.
const ALIKE: f64 = 0.4;
/// Differences of the logarithm that are larger all count as this: both sides of it are worlds apart.
const APART: f64 = 50.0;

/// Drops the part once: parameters, condition, point of what varies.
pub(super) type Simulate<'a> = &'a (dyn Fn(&[f64], usize, &[f64]) -> Simulated + Sync);

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
    /// Logarithm of the likelihood that may lie in it.
    best: f64,
    /// Its least one at a corner.
    least: f64,
    /// Its mean, not its logarithm's.
    mean: f64,
}

/// All cells and nodes.
pub(super) struct Grid<'a> {
    plan: &'a Plan,
    likelihood: &'a Likelihood,
    points: &'a [Vec<f64>],
    simulate: Simulate<'a>,
    pub(super) nodes: BTreeMap<Vec<u32>, Node>,
    pub(super) cells: Vec<Cell>,
}

/// The corners of a box, by the bits of their number: of each side the low or the high end.
fn corners(low: &[u32], high: &[u32]) -> Vec<Vec<u32>> {
    let corner = |bits: usize| {
        (0..low.len()).map(|axis| if bits >> axis & 1 == 1 { high[axis] } else { low[axis] }).collect()
    };
    (0..1 << low.len()).map(corner).collect()
}

impl<'a> Grid<'a> {
    pub(super) fn new(
        plan: &'a Plan,
        likelihood: &'a Likelihood,
        points: &'a [Vec<f64>],
        simulate: Simulate<'a>,
    ) -> Self {
        let mut grid = Self { plan, likelihood, points, simulate, nodes: BTreeMap::new(), cells: vec![] };
        let axes = plan.ranges.len();
        // A small budget makes the first division coarser, not larger.
        let mut digits = FIRST[axes];
        while digits > 1 && ((1usize << digits) + 1).pow(axes as u32) > plan.nodes / 2 {
            digits -= 1;
        }
        let (side, step) = (1usize << digits, 1u32 << (DEPTH - digits));
        let boxes: Vec<(Vec<u32>, Vec<u32>)> = (0..side.pow(axes as u32))
            .map(|number| {
                let place = |axis: usize| (number / side.pow(axis as u32) % side) as u32 * step;
                let low: Vec<u32> = (0..axes).map(place).collect();
                let high = low.iter().map(|low| low + step).collect();
                (low, high)
            })
            .collect();
        grid.add(boxes);
        grid
    }

    /// The values of the parameters at a node.
    pub(super) fn values(&self, place: &[u32]) -> Vec<f64> {
        let at = |(place, [low, high]): (&u32, &[f64; 2])| {
            let share = f64::from(*place) / f64::from(1u32 << DEPTH);
            low * (1.0 - share) + high * share
        };
        place.iter().zip(&self.plan.ranges).map(at).collect()
    }

    /// Asks the nodes of these boxes that are new, on all cores, and takes the boxes as cells.
    fn add(&mut self, boxes: Vec<(Vec<u32>, Vec<u32>)>) {
        let of_boxes = boxes.iter().flat_map(|(low, high)| corners(low, high));
        let new: BTreeSet<Vec<u32>> = of_boxes.filter(|place| !self.nodes.contains_key(place)).collect();
        let new: Vec<Vec<u32>> = new.into_iter().collect();
        let asked: Vec<Node> = new.par_iter().map(|place| self.ask(place)).collect();
        self.nodes.extend(new.into_iter().zip(asked));
        let cells: Vec<Cell> = boxes.into_par_iter().map(|(low, high)| self.cell(low, high)).collect();
        self.cells.extend(cells);
    }

    fn ask(&self, place: &[u32]) -> Node {
        let values = self.values(place);
        let under = |condition: usize| -> Vec<Simulated> {
            let drops = self.points.par_iter().map(|point| (self.simulate)(&values, condition, point));
            drops.collect()
        };
        let drops: Vec<Vec<Simulated>> = (0..self.plan.conditions).map(under).collect();
        let stats = self.likelihood.stats(&drops);
        let log = self.likelihood.log(&stats);
        Node { stats, log }
    }

    /// The nodes at the corners of a box: all of them have been asked.
    pub(super) fn around(&self, low: &[u32], high: &[u32]) -> Vec<&Node> {
        corners(low, high).iter().filter_map(|place| self.nodes.get(place)).collect()
    }

    fn cell(&self, low: Vec<u32>, high: Vec<u32>) -> Cell {
        let around = self.around(&low, &high);
        let stats: Vec<&[Stats]> = around.iter().map(|node| node.stats.as_slice()).collect();
        let between = self.likelihood.log(&self.likelihood.between(&stats));
        let most = around.iter().map(|node| node.log).fold(f64::NEG_INFINITY, f64::max);
        let least = around.iter().map(|node| node.log).fold(f64::INFINITY, f64::min);
        let mean = match most {
            f64::NEG_INFINITY => most,
            _ => most + ln(around.iter().map(|node| exp(node.log - most)).sum::<f64>() / around.len() as f64),
        };
        Cell { low, high, best: between.max(most), least, mean }
    }

    /// Halves cells until none holds a noticeable share that its corners do not show; false where the budget ended first.
    pub(super) fn refine(&mut self) -> bool {
        loop {
            let weight = |cell: &Cell, log: f64| log + cell.log_volume();
            let most =
                self.cells.iter().map(|cell| weight(cell, cell.mean)).fold(f64::NEG_INFINITY, f64::max);
            let whole = match most {
                f64::NEG_INFINITY => most,
                _ => {
                    most + ln(self.cells.iter().map(|cell| exp(weight(cell, cell.mean) - most)).sum::<f64>())
                }
            };
            let noticed = whole + ln(NOTICED);
            let mut open: Vec<(usize, f64)> = (0..self.cells.len())
                .filter(|k| self.cells[*k].is_open())
                .map(|k| (k, weight(&self.cells[k], self.cells[k].best)))
                .filter(|(_, weight)| weight.is_finite() && *weight > noticed)
                .collect();
            if open.is_empty() {
                return true;
            }
            if self.nodes.len() >= self.plan.nodes {
                return false;
            }
            // The heaviest first; of equal ones the first.
            open.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
            open.truncate(ROUND);
            let mut halved: Vec<usize> = open.into_iter().map(|(k, _)| k).collect();
            halved.sort_unstable();
            let boxes = halved.iter().flat_map(|k| self.halves(&self.cells[*k])).collect();
            for k in halved.into_iter().rev() {
                self.cells.swap_remove(k);
            }
            self.add(boxes);
        }
    }

    /// Both halves of a cell, across the side along which the likelihood changes most; of equal ones the longest.
    fn halves(&self, cell: &Cell) -> [(Vec<u32>, Vec<u32>); 2] {
        let around = self.around(&cell.low, &cell.high);
        let change = |axis: usize| {
            let pairs = (0..around.len()).filter(|bits| bits >> axis & 1 == 0);
            let change = pairs.map(|bits| apart(around[bits].log, around[bits | 1 << axis].log));
            change.fold(0.0, f64::max)
        };
        let length = |axis: usize| cell.high[axis] - cell.low[axis];
        let sides = (0..cell.low.len()).filter(|axis| length(*axis) > 1);
        let across = sides.max_by(|a, b| {
            change(*a).total_cmp(&change(*b)).then(length(*a).cmp(&length(*b))).then(b.cmp(a))
        });
        let axis = across.unwrap_or(0);
        let middle = cell.low[axis] + length(axis) / 2;
        let (mut under, mut over) = (cell.high.clone(), cell.low.clone());
        (under[axis], over[axis]) = (middle, middle);
        [(cell.low.clone(), under), (over, cell.high.clone())]
    }

    /// What makes the likelihood zero at every node, where it is.
    pub(super) fn contradiction(&self) -> Option<FitError> {
        if self.nodes.values().any(|node| node.log > f64::NEG_INFINITY) {
            return self.never();
        }
        let classes = &self.likelihood.classes;
        let lost = |missing: &[usize]| missing.iter().map(|class| classes[*class].count).sum::<f64>();
        let missing = |node: &Node| self.likelihood.missing(&node.stats);
        let nodes = self.nodes.iter().map(|(place, node)| (place, missing(node)));
        let (place, missing) = nodes.min_by(|a, b| lost(&a.1).total_cmp(&lost(&b.1)))?;
        let observations = missing.iter().map(|class| classes[*class].first).collect();
        self.never().or(Some(FitError::Contradiction { observations, at: self.values(place) }))
    }

    fn never(&self) -> Option<FitError> {
        let classes = self.likelihood.classes.iter().enumerate();
        let none = classes.filter(|(k, _)| self.nodes.values().all(|node| node.stats[*k].like == 0.0));
        let observations: Vec<usize> = none.map(|(_, class)| class.first).collect();
        (!observations.is_empty()).then_some(FitError::Never { observations })
    }
}

/// How far two logarithms are apart, as far as that matters.
fn apart(a: f64, b: f64) -> f64 {
    if a == b { 0.0 } else { (a - b).abs().min(APART) }
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

    /// True where it may hold what its corners do not show.
    fn is_open(&self) -> bool {
        let divisible = self.low.iter().zip(&self.high).any(|(low, high)| high - low > 1);
        divisible && apart(self.best, self.least) > ALIKE
    }
}
