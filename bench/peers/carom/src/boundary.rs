//! Designs close to the boundary between both verdicts.

use crate::feeders::{Design, THICKNESS, feeder, verdict};
use carom_motion::planar::Options;

/// Half the band's width [m]: no design is farther from the boundary, counted along `normal`.
const BAND: f64 = 0.015;
/// Step [m] of the search for a change of verdict.
const STRIDE: f64 = 0.004;
/// Where `normal` is looked for [m].
const RANGE: (f64, f64) = (0.1, 0.6);

/// The slopes of the upper plate [deg], and how many lines each is given.
const SLOPES: [f64; 5] = [9.0, 11.0, 13.0, 15.0, 17.0];
const LINES: u32 = 10;
/// `along` of the first line and from line to line [m].
const ALONGS: (f64, f64) = (0.26, 0.04);

fn exact(design: Design, thickness: f64) -> &'static str {
    let options = Options { tolerance: 1e-12, ..Options::default() };
    feeder(design, thickness).map_or("none", |feeder| verdict(&feeder, options))
}

/// Prints the list: two designs to every line, one on each side of the box's boundary.
pub fn write() {
    println!("upper_slope_deg,along_m,normal_m,verdict_rod,verdict_box_1mm,from_boundary_m");
    let mut share = 0.0;
    for slope_deg in SLOPES {
        for line in 0..LINES {
            let along = ALONGS.0 + ALONGS.1 * f64::from(line);
            let at = |normal: f64| Design { slope_deg, along, normal };
            let Some(boundary) = crossing(at) else {
                eprintln!("slope {slope_deg} deg, along {along:.2} m: no change of verdict");
                continue;
            };
            for side in [-1.0, 1.0] {
                // The golden ratio spreads the distances evenly over the band, whatever their number.
                share = (share + 0.618_033_988_749_894_9_f64).fract();
                let normal = ((boundary + side * BAND * share) * 1e6).round() / 1e6;
                let (rod, boxed) = (exact(at(normal), 0.0), exact(at(normal), THICKNESS));
                let from = normal - boundary;
                println!("{slope_deg},{along:.2},{normal:.6},{rod},{boxed},{from:.6}");
            }
        }
    }
}

/// The first `normal` at which the box's verdict changes, halved to rounding.
fn crossing(at: impl Fn(f64) -> Design) -> Option<f64> {
    let label = |normal: f64| exact(at(normal), THICKNESS);
    let strides = ((RANGE.1 - RANGE.0) / STRIDE) as u32;
    let node = |i: u32| RANGE.0 + STRIDE * f64::from(i);
    let changes = |(low, high): &(f64, f64)| label(*low) != label(*high);
    let (mut low, mut high) = (0..strides).map(|i| (node(i), node(i + 1))).find(changes)?;
    let before = label(low);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if label(middle) == before { low = middle } else { high = middle }
    }
    Some(0.5 * (low + high))
}
