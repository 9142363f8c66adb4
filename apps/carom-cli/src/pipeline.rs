//! The one place where the command calls the engine and the picture writers.

use crate::failure::Failure;
use carom::tasks;
use carom_feeder::{FeedRun, Run};
use carom_figure::ImpulsePlane;
use carom_scene::Scene;

pub(crate) use carom::tasks::{MADE_BY, draft, drawings, layout};

/// Runs a feeder and keeps everything.
pub(crate) fn run(scene: &Scene) -> Result<Run, Failure> {
    scene.feeder().run().map_err(|error| Failure::Undone(format!("{}: {error}", scene.name())))
}

/// Feeds several parts, where a scene wants that.
pub(crate) fn feed(scene: &Scene) -> Result<Option<FeedRun>, Failure> {
    tasks::feed(scene).map_err(|error| Failure::Undone(format!("{}: the feed: {error}", scene.name())))
}

/// An impulse plane for a terminal.
pub(crate) fn impulse_text(plane: &ImpulsePlane) -> String {
    carom_figure::impulse_text(plane, 60, 18)
}
