//! What has been seen of a plate while a part goes over it, in the plane and in space.

use crate::run::Landing;

/// What has been seen of one plate.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Seen {
    pub(crate) first_touch: Option<f64>,
    /// Impacts on it.
    pub(crate) impacts: u64,
    /// Speed of the first impact on it [m/s].
    pub(crate) impact_speed: Option<f64>,
    max_impact_speed: f64,
    sliding_speed: f64,
}

impl Seen {
    /// The part touches the plate.
    pub(crate) fn touched(&mut self, time: f64) {
        self.first_touch.get_or_insert(time);
    }

    /// It strikes the plate with this speed [m/s].
    pub(crate) fn struck(&mut self, speed: f64) {
        self.impacts += 1;
        self.impact_speed.get_or_insert(speed);
        self.max_impact_speed = self.max_impact_speed.max(speed);
    }

    /// It slips on the plate with this speed [m/s].
    pub(crate) fn slid(&mut self, speed: f64) {
        self.sliding_speed = self.sliding_speed.max(speed);
    }
}

/// Landings with the speeds on their plates. The part may strike and slide faster on a plate after it has landed: its largest speeds are known only at
/// the end.
pub(crate) fn with_speeds(mut landings: Vec<Landing>, plates: &[Seen]) -> Vec<Landing> {
    for landing in &mut landings {
        let seen = &plates[landing.plate];
        landing.impact_speed = seen.impact_speed.unwrap_or(0.0);
        landing.max_impact_speed = seen.max_impact_speed;
        landing.max_sliding_speed = seen.sliding_speed;
    }
    landings
}
