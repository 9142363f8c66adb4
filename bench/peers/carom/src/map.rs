//! The verdict of each of 300 × 300 designs, by following the boundaries between verdicts, and whether each is what its own drop says.

use super::feeders::{self, Design};
use carom_motion::planar::Options;
use carom_study::regions::{Range, cells};
use std::time::Instant;

/// Slope of the upper plate, as in the paper's first case [degrees].
const SLOPE_DEG: f64 = 15.0;
/// Designs along each axis.
const COUNT: usize = 300;
/// Where the lower plate's line meets the upper one's axis and its normal [m].
const ALONG: Range = Range { from: 0.2, to: 0.6, count: COUNT };
const NORMAL: Range = Range { from: 0.19, to: 0.4, count: COUNT };

/// Draws the map on one thread, and says in JSON how long it took, how many drops, and how many cells are wrong.
pub fn draw(thickness: f64, options: Options) -> Result<(), String> {
    let verdict = |along: f64, normal: f64| {
        let design = Design { slope_deg: SLOPE_DEG, along, normal };
        feeders::feeder(design, thickness).map_or("none", |feeder| feeders::verdict(&feeder, options))
    };
    let started = Instant::now();
    let found = cells(ALONG, NORMAL, verdict).map_err(|error| error.to_string())?;
    let seconds = started.elapsed().as_secs_f64();
    let middle = |axis: Range, k: usize| axis.at((k as f64 + 0.5) / COUNT as f64);
    let own = |k: usize| verdict(middle(ALONG, k % COUNT), middle(NORMAL, k / COUNT));
    let wrong = found.labels.iter().enumerate().filter(|(k, label)| own(*k) != **label).count();
    let (cells, drops) = (found.labels.len(), found.evaluations);
    println!("{{\"seconds\": {seconds}, \"cells\": {cells}, \"drops\": {drops}, \"wrong\": {wrong}}}");
    Ok(())
}
