//! How closely solid parts may follow each other.

use super::path::Way;
use super::{End, Feeds, FeedsError, Happens, Meets, Plan, leaves, refused, smallest};
use crate::ending::Ending;
use crate::stretches::{self, Stretches};
use carom_feeder::{Stop, spatial};
use carom_motion::spatial::Form;

/// Searches all intervals at which solid parts may be fed to this feeder, as [`search`](super::search) does for parts in the plane; `step` is called after each interval.
///
/// # Guarantees
/// Until parts touch, each does what the one before did, an interval later. So whether they touch, and which of their touches is the first, is told by the way of one part alone, and for any
/// number of parts. The result does not depend on the number of threads.
///
/// # Limits
/// What becomes of parts that touch is not followed: [`Kind::Touching`](super::Kind::Touching). Between samples the motion is taken as cubics. As of parts in the plane, a stretch of intervals
/// that is shorter than the distance of two nodes may be missed below the answer; [`Feeds::longest`] misses none.
///
/// # Errors
/// [`FeedsError`].
///
/// # Example
/// Bars that lie 40 mm long down a slope start from rest with an acceleration a, and tip over its end into the open. They may follow each other after `√(2·0.04/a)` s.
/// ```
/// use carom_feeder::spatial::examples;
/// use carom_study::feeds::{Plan, search_solid};
/// let mut feeder = examples::two_plates();
/// feeder.plates.truncate(1);
/// let found = search_solid(&feeder, &Plan { nodes: 16, ..Plan::default() }, |_| None, || ()).unwrap();
/// let down = (feeder.plates[0].edge - feeder.plates[0].uphill).unit().unwrap();
/// let a = 9.81 * (-down.y - 0.15 * down.x);
/// assert!((found.smallest.unwrap().free - (0.08 / a).sqrt()).abs() < 1e-6);
/// ```
pub fn search_solid(
    feeder: &spatial::Feeder,
    plan: &Plan,
    wanted: impl Fn(&spatial::Run) -> Option<bool>,
    step: impl Fn() + Sync,
) -> Result<Feeds<spatial::Run>, FeedsError> {
    plan.check()?;
    let feeder = spatial::Feeder { stop: Stop::Delivered, ..feeder.clone() };
    let alone = feeder.run().map_err(refused)?;
    let form = Form::of(&feeder.part.body).map_err(|problem| FeedsError::Form(problem.to_string()))?;
    let ending = Ending::of(&alone, feeder.plates.len() - 1);
    let leaves = leaves(alone.outcome)?;
    let way = way(&form, &alone, leaves);
    let longest = way.as_ref().filter(|_| leaves).map(|way| way.search(0.1 * plan.accuracy));
    let as_wanted = wanted(&alone).unwrap_or(true);
    let classify = |interval: f64| {
        let touch = way.as_ref().and_then(|way| way.first_touch(interval));
        step();
        let meets = touch.map(|time| Meets {
            parts: [0, 1],
            doing: [time + interval, time].map(|time| alone.doing_until(time)),
            blocked: time == 0.0,
        });
        let own = End { ending, outcome: alone.outcome, as_wanted };
        let ends = if meets.is_some() { vec![] } else { vec![own] };
        Happens { meets, ends, broken_off: false }
    };
    let nodes = plan.intervals(longest.as_ref(), alone.end_time);
    let options = stretches::Options { accuracy: plan.accuracy, most: plan.most };
    let found: Stretches<Happens> = stretches::find(&nodes, options, classify, Happens::is_free);
    let (smallest, unresolved) = (smallest(&found), found.unresolved);
    let rests_on = alone.stages.last().and_then(|stage| stage.obstacle).filter(|_| !leaves);
    Ok(Feeds { ending, rests_on, longest, smallest, stretches: found.pieces, unresolved, runs: 1, alone })
}

/// The way of a part, piece by piece.
fn way<'f>(form: &'f Form, run: &spatial::Run, gone: bool) -> Option<Way<'f, Form>> {
    let samples = &run.samples;
    let pieces = samples.pieces.iter().map(|piece| {
        let from = samples.instants.partition_point(|(time, ..)| *time <= piece.start_time);
        let until = samples.instants.partition_point(|(time, ..)| *time < piece.end_time);
        let inner = samples.instants[from..until.max(from)].iter().map(|(time, _, state)| (*time, *state));
        std::iter::once((piece.start_time, piece.start)).chain(inner).chain([(piece.end_time, piece.end)])
    });
    Way::of(form, pieces, gone)
}
