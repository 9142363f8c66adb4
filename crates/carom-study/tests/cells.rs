//! The label of every cell of a fine grid, by following boundaries, against asking every cell.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]
#![allow(clippy::print_stdout, reason = "how many drops a map takes is a measurement")]

use carom_feeder::{Feeder, Part, Plate, Start, Stop};
use carom_impact::Law;
use carom_motion::planar::Options;
use carom_num::Vec2;
use carom_study::Ending;
use carom_study::regions::{Range, cells};
use rayon::prelude::*;

/// Cells along a side.
const SIDE: usize = 300;

/// The paper's part on two plates; where the lower plate's line meets the upper one's normal and its axis.
fn feeder(normal: f64, along: f64) -> Option<Feeder> {
    let x = Vec2::at_angle(-0.26);
    let (high, low) = (x * along, x.turned_right() * normal);
    let down = (low - high).unit()?;
    let plate = |name: &str, uphill: Vec2, edge: Vec2| Plate {
        name: name.into(),
        uphill,
        edge,
        friction: 0.15,
        restitution: 0.0,
        unbounded: true,
        form: Default::default(),
    };
    Some(Feeder {
        gravity: 9.81,
        stop: Stop::Landed,
        law: Law::Poisson,
        part: Part::rod(0.1, 0.3, 2.5e-4)?,
        start: Start { to_edge: 0.1, speed: 0.0, face: 0 },
        plates: vec![
            plate("upper", x * -0.5, Vec2::ZERO),
            plate("lower", high - down * 3.0, low + down * 3.0),
        ],
        walls: vec![],
    })
}

/// The paper's drop on 300 by 300 layouts: every cell is what its own drop says, for a tenth of the drops.
#[test]
fn a_map_is_right_at_every_cell() {
    let ranges = [(0.1, 0.5), (0.1, 0.6)].map(|(from, to)| Range { from, to, count: SIDE });
    let ending = |normal: f64, along: f64| {
        let feeder = feeder(normal, along);
        let run = feeder.as_ref().and_then(|f| f.prepare(Options::default()).ok()?.run_untraced().ok());
        run.map(|run| Ending::of(&run, 1))
    };
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
