//! Areas, and where names are best written.

use super::lattice::Lattice;
use super::{Label, Patch, Place, Range, Share};
use std::collections::{BTreeMap, VecDeque};

fn nodes_of<L: Label>(lattice: &mut Lattice<'_, L>) -> (Vec<L>, [usize; 2]) {
    let coarse = lattice.coarse;
    let size = lattice.steps.map(|steps| steps / coarse + 1);
    let nodes = (0..size[1]).flat_map(|j| (0..size[0]).map(move |i| [i * coarse, j * coarse]));
    lattice.learn(nodes.clone());
    (nodes.map(|node| lattice.label(node)).collect(), size)
}

/// Nodes of the grid with each label.
pub(super) fn counts<L: Label>(lattice: &mut Lattice<'_, L>) -> BTreeMap<L, usize> {
    let mut counts = BTreeMap::new();
    for label in nodes_of(lattice).0 {
        *counts.entry(label).or_default() += 1;
    }
    counts
}

/// What share of the plane each label takes.
pub(super) fn shares<L: Copy + Ord>(
    patches: &[Patch<L>],
    counts: &BTreeMap<L, usize>,
    ranges: [Range; 2],
) -> Vec<Share<L>> {
    let mut areas: BTreeMap<L, f64> = counts.keys().map(|label| (*label, 0.0)).collect();
    for patch in patches {
        let corner = |point: &[f64; 2]| [0, 1].map(|axis| ranges[axis].share(point[axis]));
        let corners: Vec<[f64; 2]> = patch.outline.iter().map(corner).collect();
        *areas.entry(patch.label).or_default() += area(&corners);
    }
    let share = |(label, area)| Share { label, area, nodes: counts.get(&label).copied().unwrap_or(0) };
    areas.into_iter().map(share).collect()
}

/// Gauss's formula, about the first corner.
fn area(corners: &[[f64; 2]]) -> f64 {
    let Some(&[x, y]) = corners.first() else { return 0.0 };
    let triangle = |w: &[[f64; 2]]| (w[0][0] - x) * (w[1][1] - y) - (w[1][0] - x) * (w[0][1] - y);
    0.5 * corners.windows(2).map(triangle).sum::<f64>()
}

/// The same patches, with rectangles that follow each other in a row made one.
pub(super) fn merged<L: Copy + Ord>(patches: Vec<Patch<L>>) -> Vec<Patch<L>> {
    let mut out: Vec<Patch<L>> = vec![];
    for patch in patches {
        if let Some(last) = out.last_mut()
            && last.label == patch.label
            && let ([_, b, c, _], [a, next_b, next_c, d]) = (&last.outline[..], &patch.outline[..])
            && [b, c] == [a, d]
        {
            (last.outline[1], last.outline[2]) = (*next_b, *next_c);
        } else {
            out.push(patch);
        }
    }
    out
}

/// The connected sets of grid nodes with one label, the largest first.
pub(super) fn places<L: Label>(lattice: &mut Lattice<'_, L>) -> Vec<Place<L>> {
    let (labels, size) = nodes_of(lattice);
    let clearance = clearances(&labels, size);
    let mut seen = vec![false; labels.len()];
    let mut found = vec![];
    for start in 0..labels.len() {
        if seen[start] {
            continue;
        }
        seen[start] = true;
        let mut members = vec![start];
        let mut k = 0;
        while let Some(&node) = members.get(k) {
            k += 1;
            for next in neighbours(node, size) {
                if !seen[next] && labels[next] == labels[start] {
                    seen[next] = true;
                    members.push(next);
                }
            }
        }
        let at = |node: usize| [(node % size[0]) as f64, (node / size[0]) as f64];
        let mean =
            [0, 1].map(|axis| members.iter().map(|&node| at(node)[axis]).sum::<f64>() / members.len() as f64);
        let off = |node: usize| (at(node)[0] - mean[0]).abs() + (at(node)[1] - mean[1]).abs();
        // The roomiest; of several, the one nearest to the middle of them all.
        let roomier = |a: &usize, b: &usize| {
            clearance[*a].cmp(&clearance[*b]).then(off(*b).total_cmp(&off(*a))).then(b.cmp(a))
        };
        let Some(best) = members.iter().copied().max_by(roomier) else { continue };
        let shares = [best % size[0], best / size[0]];
        let shares = [0, 1].map(|axis| shares[axis] as f64 / (size[axis] - 1) as f64);
        let at = lattice.point(shares);
        found.push(Place { label: labels[start], at, clearance: clearance[best], nodes: members.len() });
    }
    found.sort_by_key(|place| usize::MAX - place.nodes);
    found
}

fn neighbours(node: usize, [columns, rows]: [usize; 2]) -> impl Iterator<Item = usize> {
    let (i, j) = (node % columns, node / columns);
    let left = (i > 0).then(|| node - 1);
    let right = (i + 1 < columns).then_some(node + 1);
    let down = (j > 0).then(|| node - columns);
    let up = (j + 1 < rows).then_some(node + columns);
    [left, right, down, up].into_iter().flatten()
}

/// Steps from each node to the border or to a node with another label.
fn clearances<L: Copy + Ord>(labels: &[L], size: [usize; 2]) -> Vec<usize> {
    let mut clearance = vec![usize::MAX; labels.len()];
    let mut queue = VecDeque::new();
    for node in 0..labels.len() {
        let (mut inside, mut alike) = (0, true);
        for next in neighbours(node, size) {
            inside += 1;
            alike &= labels[next] == labels[node];
        }
        if inside < 4 || !alike {
            clearance[node] = 0;
            queue.push_back(node);
        }
    }
    while let Some(node) = queue.pop_front() {
        for next in neighbours(node, size) {
            if clearance[next] == usize::MAX {
                clearance[next] = clearance[node] + 1;
                queue.push_back(next);
            }
        }
    }
    clearance
}
