//! The labels of nodes that are known.

use std::collections::BTreeMap;

/// Labels by node. Every cell of the grid asks many times for its corners and the points half-way between them: these are in a table. What finer
/// cells ask for is little, and is in a tree.
pub(super) struct Nodes<L> {
    /// Finest steps between two nodes of the table.
    pitch: usize,
    columns: usize,
    table: Vec<Option<L>>,
    finer: BTreeMap<[usize; 2], L>,
}

impl<L: Copy> Nodes<L> {
    /// Of a grid with so many finest steps along each axis, so many of them a cell.
    pub(super) fn new(steps: [usize; 2], coarse: usize) -> Self {
        let pitch = (coarse / 2).max(1);
        let [columns, rows] = steps.map(|steps| steps / pitch + 1);
        Self { pitch, columns, table: vec![None; columns * rows], finer: BTreeMap::new() }
    }

    fn place(&self, [column, row]: [usize; 2]) -> Option<usize> {
        let on = column.is_multiple_of(self.pitch) && row.is_multiple_of(self.pitch);
        on.then(|| row / self.pitch * self.columns + column / self.pitch)
    }

    pub(super) fn get(&self, node: [usize; 2]) -> Option<L> {
        match self.place(node) {
            Some(place) => self.table.get(place).copied().flatten(),
            None => self.finer.get(&node).copied(),
        }
    }

    pub(super) fn insert(&mut self, node: [usize; 2], label: L) {
        match self.place(node).and_then(|place| self.table.get_mut(place)) {
            Some(known) => *known = Some(label),
            None => {
                self.finer.insert(node, label);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Nodes;

    #[test]
    fn every_node_keeps_its_own_label() {
        let steps = [3 * 8, 2 * 8];
        for coarse in [1, 2, 8] {
            let mut nodes = Nodes::new(steps, coarse);
            let all = || (0..=steps[1]).flat_map(|row| (0..=steps[0]).map(move |column| [column, row]));
            assert!(all().all(|node| nodes.get(node).is_none()), "nothing is known at first");
            all().for_each(|node| nodes.insert(node, node));
            assert!(all().all(|node| nodes.get(node) == Some(node)), "cells of {coarse} steps");
        }
    }
}
