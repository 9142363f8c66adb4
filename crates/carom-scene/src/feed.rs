//! Several parts on one feeder.

use crate::drawing::Drawing;
use crate::problem::{Problem, ProblemKind};
use carom_feeder::Feed;
use carom_motion::planar::Surface;

/// What `[feed]` says, with the friction and restitution between parts; every problem where it cannot be.
pub(crate) fn feed_of(drawing: &Drawing) -> Result<Option<Feed>, Vec<Problem>> {
    let Some(feed) = &drawing.feed else { return Ok(None) };
    let friction = feed.surface.friction.as_ref().or(drawing.contact.friction.as_ref());
    let restitution = feed.surface.restitution.as_ref().unwrap_or(&drawing.contact.restitution);
    let mut problems = vec![];
    if friction.is_none() && !drawing.contact.friction_written {
        let message = "missing: a plain number, the friction between parts, where [contact] has none";
        problems.push(Problem::new(
            ProblemKind::MissingKey,
            "feed.friction",
            message,
            Some(feed.span.clone()),
        ));
    }
    if !problems.is_empty() {
        return Err(problems);
    }
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a whole number from 1 to 100"
    )]
    let parts = feed.parts.value.round() as usize;
    let between = Surface { friction: friction.map_or(0.0, |f| f.value), restitution: restitution.value };
    Ok(Some(Feed { parts, interval: feed.interval.value, between }))
}
