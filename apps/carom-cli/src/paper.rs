//! Table 1 of the gravity-impact feeder's paper, beside our values in its letters and frames.

use carom_feeder::Run;
use carom_scene::Scene;

/// The table.
pub(crate) fn text(_scene: &Scene, _run: &Run) -> String {
    String::new()
}
