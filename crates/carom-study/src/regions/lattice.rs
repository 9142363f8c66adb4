//! The nodes of the finest grid, the sides between them, and the crossings on these.

use super::nodes::Nodes;
use super::{Classifier, Label, Options, Range};
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Most crossings that are told apart on one line. A classifier that is noise, and has no regions, must not be followed to the last digit.
const MOST_CROSSINGS: usize = 64;

/// A side of a cell: from a node along an axis (0: x, 1: y), so many finest steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Side {
    pub(super) axis: usize,
    pub(super) start: [usize; 2],
    pub(super) length: usize,
}

impl Side {
    /// The node a number of steps along.
    pub(super) fn node(&self, steps: usize) -> [usize; 2] {
        let mut node = self.start;
        node[self.axis] += steps;
        node
    }

    /// Its two halves.
    pub(super) fn halves(&self) -> [Side; 2] {
        let length = self.length / 2;
        [Side { length, ..*self }, Side { length, start: self.node(length), ..*self }]
    }
}

/// A change of label along a line.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crossing<L> {
    /// In units of the axes.
    pub(super) at: [f64; 2],
    /// The labels before and after it, along the axis.
    pub(super) pair: [L; 2],
}

/// One end of a bracket: a share of the range, and the label there.
#[derive(Clone, Copy, Debug)]
pub(super) struct End<L> {
    pub(super) share: f64,
    pub(super) label: L,
}

/// The grid and what is known on it.
pub(super) struct Lattice<'a, L> {
    pub(super) ranges: [Range; 2],
    /// Finest steps along each axis.
    pub(super) steps: [usize; 2],
    /// Finest steps of a cell that is not halved.
    pub(super) coarse: usize,
    pub(super) accuracy: f64,
    pub(super) crossings: Vec<Crossing<L>>,
    evaluations: AtomicUsize,
    classify: Classifier<'a, L>,
    known: Nodes<L>,
    /// Found ahead of time, and not numbered yet.
    ready: BTreeMap<Side, Vec<Crossing<L>>>,
    crossed: BTreeMap<Side, Vec<usize>>,
    split: BTreeSet<Side>,
}

impl<'a, L: Label> Lattice<'a, L> {
    pub(super) fn new(ranges: [Range; 2], options: &Options, classify: Classifier<'a, L>) -> Self {
        let coarse = 1usize << options.depth;
        let steps = ranges.map(|range| range.count * coarse);
        Self {
            ranges,
            steps,
            coarse,
            accuracy: options.accuracy,
            crossings: vec![],
            evaluations: AtomicUsize::new(0),
            classify,
            known: Nodes::new(steps, coarse),
            ready: BTreeMap::new(),
            crossed: BTreeMap::new(),
            split: BTreeSet::new(),
        }
    }

    /// Takes the labels of the grid's nodes, row by row, for known.
    pub(super) fn know(&mut self, labels: Vec<L>) {
        let columns = self.ranges[0].count + 1;
        for (k, label) in labels.into_iter().enumerate() {
            self.known.insert([k % columns * self.coarse, k / columns * self.coarse], label);
        }
    }

    /// The shares of the ranges at which a node lies.
    pub(super) fn shares(&self, node: [usize; 2]) -> [f64; 2] {
        [0, 1].map(|axis| node[axis] as f64 / self.steps[axis] as f64)
    }

    /// A place in units of the axes.
    pub(super) fn point(&self, shares: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| self.ranges[axis].at(shares[axis]))
    }

    /// The label at a place that is no node.
    pub(super) fn ask(&self, shares: [f64; 2]) -> L {
        let [x, y] = self.point(shares);
        self.evaluations.fetch_add(1, Ordering::Relaxed);
        (self.classify)(x, y)
    }

    /// How often the classifier was asked.
    pub(super) fn evaluations(&self) -> usize {
        self.evaluations.load(Ordering::Relaxed)
    }

    /// Asks for the labels of all these nodes at once.
    pub(super) fn learn(&mut self, nodes: impl Iterator<Item = [usize; 2]>) {
        let unknown: BTreeSet<[usize; 2]> = nodes.filter(|node| self.known.get(*node).is_none()).collect();
        let unknown: Vec<[usize; 2]> = unknown.into_iter().collect();
        let labels: Vec<L> =
            unknown.par_iter().panic_fuse().map(|node| self.ask(self.shares(*node))).collect();
        unknown.into_iter().zip(labels).for_each(|(node, label)| self.known.insert(node, label));
    }

    /// Looks for the crossings of all these sides at once; their ends must be known.
    pub(super) fn cross(&mut self, sides: impl Iterator<Item = Side>) {
        let differs = |side: &Side| {
            let [a, b] = [side.start, side.node(side.length)].map(|node| self.known.get(node));
            a != b && !self.crossed.contains_key(side) && !self.ready.contains_key(side)
        };
        let sides: BTreeSet<Side> = sides.filter(differs).collect();
        let sides: Vec<Side> = sides.into_iter().collect();
        let found: Vec<Option<Vec<Crossing<L>>>> =
            sides.par_iter().panic_fuse().map(|side| self.between(*side)).collect();
        let both = sides.into_iter().zip(found);
        self.ready.extend(both.filter_map(|(side, found)| Some((side, found?))));
    }

    /// The crossings of a side whose ends are known.
    fn between(&self, side: Side) -> Option<Vec<Crossing<L>>> {
        let end = |node: [usize; 2]| {
            let label = self.known.get(node)?;
            Some(End { share: self.shares(node)[side.axis], label })
        };
        let ends = [end(side.start)?, end(side.node(side.length))?];
        let fixed = self.shares(side.start)[1 - side.axis];
        Some(self.crossings_between(side.axis, fixed, self.accuracy, ends))
    }

    pub(super) fn label(&mut self, node: [usize; 2]) -> L {
        if let Some(label) = self.known.get(node) {
            return label;
        }
        let label = self.ask(self.shares(node));
        self.known.insert(node, label);
        label
    }

    /// Says that a cell beside this side is halved.
    pub(super) fn split(&mut self, side: Side) {
        self.split.insert(side);
    }

    pub(super) fn is_split(&self, side: &Side) -> bool {
        self.split.contains(side)
    }

    /// The crossings of a side that is not split, in order.
    pub(super) fn crossings_of(&mut self, side: Side) -> Vec<usize> {
        if let Some(found) = self.crossed.get(&side) {
            return found.clone();
        }
        let [low, high] = [0, side.length].map(|steps| self.label(side.node(steps)));
        if low == high {
            return vec![];
        }
        let found = self.ready.remove(&side).or_else(|| self.between(side)).unwrap_or_default();
        let first = self.crossings.len();
        self.crossings.extend(found);
        let numbers: Vec<usize> = (first..self.crossings.len()).collect();
        self.crossed.insert(side, numbers.clone());
        numbers
    }

    /// Every change of label between two ends on a line, located to `within` (a share of the range). A label that is met on less than
    /// twice that is passed over: it cannot be told from an outcome at equality, which fills a line and no region.
    ///
    /// Ends that are equal are taken for a stretch without a change.
    pub(super) fn crossings_between(
        &self,
        axis: usize,
        fixed: f64,
        within: f64,
        ends: [End<L>; 2],
    ) -> Vec<Crossing<L>> {
        let mut found = vec![];
        self.isolate(axis, fixed, within, ends, &mut found);
        let range = self.ranges[axis];
        fused(found, |crossing| range.share(crossing.at[axis]), 2.0 * within)
    }

    /// Bisects.
    pub(super) fn isolate(
        &self,
        axis: usize,
        fixed: f64,
        within: f64,
        [low, high]: [End<L>; 2],
        found: &mut Vec<Crossing<L>>,
    ) {
        if low.label == high.label {
            return;
        }
        let share = 0.5 * (low.share + high.share);
        let shares = if axis == 0 { [share, fixed] } else { [fixed, share] };
        let resolved = share <= low.share || share >= high.share;
        if resolved || high.share - low.share <= within || found.len() >= MOST_CROSSINGS {
            found.push(Crossing { at: self.point(shares), pair: [low.label, high.label] });
            return;
        }
        let middle = End { share, label: self.ask(shares) };
        self.isolate(axis, fixed, within, [low, middle], found);
        self.isolate(axis, fixed, within, [middle, high], found);
    }
}

/// Crossings that lie within `span` of the first of them, as one.
fn fused<L: Copy + Ord>(
    found: Vec<Crossing<L>>,
    share: impl Fn(&Crossing<L>) -> f64,
    span: f64,
) -> Vec<Crossing<L>> {
    let mut out: Vec<Crossing<L>> = vec![];
    let mut first = f64::NEG_INFINITY;
    for crossing in found {
        let here = share(&crossing);
        match out.last_mut() {
            Some(last) if here - first <= span => {
                last.at = [0, 1].map(|axis| 0.5 * (last.at[axis] + crossing.at[axis]));
                last.pair[1] = crossing.pair[1];
                if last.pair[0] == last.pair[1] {
                    out.pop();
                    first = f64::NEG_INFINITY;
                }
            }
            _ => {
                first = here;
                out.push(crossing);
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shares(places: &[(f64, [u8; 2])]) -> Vec<(f64, [u8; 2])> {
        let found = places.iter().map(|&(x, pair)| Crossing { at: [x, 0.0], pair }).collect();
        fused(found, |crossing| crossing.at[0], 0.01).iter().map(|c| (c.at[0], c.pair)).collect()
    }

    #[test]
    fn a_label_that_fills_a_line_only_is_passed_over() {
        assert_eq!(shares(&[(0.5, [1, 9]), (0.5, [9, 2])]), [(0.5, [1, 2])], "between two regions");
        assert_eq!(shares(&[(0.5, [1, 9]), (0.508, [9, 1])]), [], "within one");
        let apart = [(0.5, [1, 9]), (0.6, [9, 2])];
        assert_eq!(shares(&apart), apart, "a region");
        let both = shares(&[(0.1, [3, 1]), (0.2, [1, 9]), (0.2, [9, 1]), (0.2, [1, 2])]);
        assert_eq!(both, [(0.1, [3, 1]), (0.2, [1, 2])], "changes beside it stay");
    }
}
