//! The label of every cell of a fine grid, by following boundaries, against asking every cell.

#![allow(clippy::print_stdout, reason = "how many drops a map takes is a measurement")]

use crate::paper;

use carom_study::regions::{Range, cells};
use paper::{ending, layout};
use rayon::prelude::*;

/// Cells along a side.
const SIDE: usize = 300;

/// The paper's drop on 300 by 300 layouts: every cell is what its own drop says, for a tenth of the drops.
#[test]
fn a_map_is_right_at_every_cell() {
    let ranges = [(0.1, 0.5), (0.1, 0.6)].map(|(from, to)| Range { from, to, count: SIDE });
    let ending = |normal: f64, along: f64| ending(layout(normal, along, 0.15, 0.26, 0.1).as_ref());
    let drawn = cells(ranges[0], ranges[1], ending).unwrap();
    let middle = |axis: usize, k: usize| ranges[axis].at((k as f64 + 0.5) / SIDE as f64);
    let asked: Vec<_> = (0..SIDE * SIDE)
        .into_par_iter()
        .map(|cell| ending(middle(0, cell % SIDE), middle(1, cell / SIDE)))
        .collect();
    let labels: std::collections::BTreeSet<_> = asked.iter().collect();
    let wrong = asked.iter().zip(&drawn.labels).filter(|(a, b)| a != b).count();
    println!(
        "{} drops for {} cells of {} outcomes, {wrong} wrong",
        drawn.evaluations,
        SIDE * SIDE,
        labels.len()
    );
    assert!(labels.len() > 2, "{labels:?}");
    assert_eq!(wrong, 0);
    assert!(8 * drawn.evaluations < SIDE * SIDE, "{} drops", drawn.evaluations);
}
