//! The drops that are compared: the grid, and random ones around it.

use crate::answer::Design;

/// The upper slope of the grid [deg].
const UPPER_SLOPE_DEG: f64 = 15.0;

/// The 98 designs of the grid that was solved by an independent program.
pub fn grid() -> Vec<Design> {
    let text = include_str!("../../../crates/carom-feeder/tests/reference/feeder_grid.csv");
    let numbers = |line: &str| -> Option<(f64, f64)> {
        let mut fields = line.split(',');
        Some((fields.next()?.trim().parse().ok()?, fields.next()?.trim().parse().ok()?))
    };
    text.lines()
        .skip(1)
        .filter_map(numbers)
        .map(|(slope_deg, line_b)| Design {
            upper_slope: UPPER_SLOPE_DEG.to_radians(),
            lower_slope: slope_deg.to_radians(),
            line_b,
            to_edge: 0.1,
            friction: 0.15,
        })
        .collect()
}
