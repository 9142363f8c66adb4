//! A space of layouts that the examples of this module share.

use super::{Layout, Space, Varying};
use carom_feeder::examples::rod_on_a_slope;
use carom_feeder::{Feeder, Outcome, Run};

/// The friction of a slope of 3 in 4, from 0 to 1: a rod is to be held on it, and nothing varies. The example of [`Space`] shows how it is written.
#[derive(Clone, Copy, Debug)]
pub struct FrictionOfASlope;

impl Space for FrictionOfASlope {
    type Feeder = Feeder;

    fn dimensions(&self) -> usize {
        1
    }

    fn varying(&self) -> usize {
        1
    }

    fn layout(&self, point: &[f64]) -> Option<Layout> {
        Some(Layout { feeder: rod_on_a_slope(*point.first()?), height: 3.0, width: 4.0 })
    }

    fn met(&self, _: &[f64], run: &Run) -> bool {
        run.outcome == Outcome::Stuck
    }

    fn varied(&self, point: &[f64], _: f64) -> Option<Varying<'_>> {
        let feeder = rod_on_a_slope(*point.first()?);
        Some(Box::new(move |_| Some(feeder.clone())))
    }
}
