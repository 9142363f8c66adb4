//! What the engine says of one drop, as far as an observer would see it.

use crate::ending::{Dropped, Ending};

/// One drop of the engine.
///
/// # Example
/// A disc slides 2 m down at 6 m/s², then falls 1.25 m: it touches the tray after `√(2·2/6)` and the fall.
/// ```
/// use carom_feeder::examples;
/// use carom_motion::planar::Options;
/// use carom_study::{Dropped, Ending, fits::Simulated};
/// let feeder = examples::disc_above_a_tray();
/// let drop = Simulated::of(&Dropped::of(Some(&feeder), 1, &Options::default()), 1);
/// assert_eq!((drop.ending, drop.face), (Ending::Stays, None));
/// assert!(drop.time.unwrap() > (2.0 * 2.0 / 6.0_f64).sqrt());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Simulated {
    /// How it ends on the plate that is looked at.
    pub ending: Ending,
    /// Number of the face that is down there; none where it never lies there, or is a disc.
    pub face: Option<usize>,
    /// When it first lies flat there, or a disc first touches it; of all other drops when they end [s]. None where there was no drop.
    pub time: Option<f64>,
}

impl Simulated {
    /// Of a drop, on the plate that is looked at.
    pub fn of(dropped: &Dropped, plate: usize) -> Self {
        let landing = dropped.run.iter().flat_map(|run| &run.landings).find(|landing| landing.plate == plate);
        let lain = landing.map(|landing| landing.flat.unwrap_or(landing.first_touch));
        Self {
            ending: dropped.ending,
            face: landing.and_then(|landing| landing.face),
            time: lain.or(dropped.run.as_ref().map(|run| run.end_time)),
        }
    }

    /// True where there was a drop that could be followed.
    pub(super) fn is_possible(&self) -> bool {
        !matches!(self.ending, Ending::Impossible | Ending::Failed)
    }
}
