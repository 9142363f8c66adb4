//! Folding: many strikes on one obstacle, one soon after the other, are one stage of the table.

use crate::run::{Stage, StageEnd, StageName};
use std::ops::RangeInclusive;

/// A strike, as far as folding looks at it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Strike<S> {
    /// When [s].
    pub(crate) time: f64,
    /// The obstacle that is struck first.
    pub(crate) obstacle: Option<usize>,
    /// State before.
    pub(crate) before: S,
    /// State after.
    pub(crate) after: S,
}

/// What happened in a run, in the plane or in space.
#[derive(Clone, Debug)]
pub(crate) struct Happened<S> {
    pub(crate) strikes: Vec<Strike<S>>,
    /// Start and end of every piece of the motion [s].
    pub(crate) pieces: Vec<[f64; 2]>,
    /// Series of strikes that were closed at their limit: their last strikes, and the limits [s].
    pub(crate) series: Vec<(f64, f64)>,
}

/// Strikes that are folded even where no series was closed at its limit.
const MANY: usize = 4;
/// A stage longer than this share of all the bouncing on one obstacle keeps a row of its own. At most three stages can be so long.
const LONG: f64 = 0.25;

/// Stages shorter than this share of the part's own time are specks. The part's own time is that of a fall through about its size; in a speck the
/// part falls through 1/20 000 of its size.
const SPECK: f64 = 0.01;

/// How long a stage of a part of this size may last under this gravity and still be a speck [s].
pub(crate) fn moment(size: f64, gravity: f64) -> f64 {
    SPECK * (size / gravity).sqrt()
}

/// Folds the strikes that follow the first one on an obstacle, and the short stages between them, into one stage each.
///
/// Strikes on several obstacles with nothing but specks between them, no longer than `moment` [s], are folded as well.
pub(crate) fn fold<S: Copy, F: Clone>(
    stages: Vec<Stage<S, F>>,
    trace: &Happened<S>,
    moment: f64,
) -> Vec<Stage<S, F>> {
    let mut stages = stages;
    for run in runs(&stages, trace) {
        put_in_one(&mut stages, trace, &run);
    }
    for run in rattles(&stages, trace, moment) {
        put_in_one(&mut stages, trace, &run);
    }
    stages
}

/// Puts the stages of a run of strikes in one, where they are many or have a limit.
fn put_in_one<S: Copy, F: Clone>(
    stages: &mut Vec<Stage<S, F>>,
    trace: &Happened<S>,
    run: &RangeInclusive<usize>,
) {
    if let Some(clatter) = clatter(stages, trace, run) {
        let inside = |s: &Stage<S, F>| s.start_time >= clatter.start_time && s.end_time <= clatter.end_time;
        let at = stages.iter().position(|s| s.start_time >= clatter.start_time).unwrap_or(stages.len());
        stages.retain(|s| !inside(s));
        stages.insert(at, clatter);
    }
}

/// Runs of many strikes, by number, with nothing but specks between them; the first strike on each obstacle stands alone.
fn rattles<S, F>(stages: &[Stage<S, F>], trace: &Happened<S>, moment: f64) -> Vec<RangeInclusive<usize>> {
    let impacts = &trace.strikes;
    let is_first = |k: usize| impacts.iter().position(|i| i.obstacle == impacts[k].obstacle) == Some(k);
    let speck = |s: &Stage<S, F>| s.name == StageName::Clatter || s.end_time - s.start_time <= moment;
    let goes_on = |k: usize| between(stages, &impacts[k], &impacts[k + 1]).all(speck) && !is_first(k + 1);
    let mut runs = vec![];
    let mut first = 0;
    while first < impacts.len() {
        let last = (first..impacts.len() - 1).find(|k| !goes_on(*k)).unwrap_or(impacts.len() - 1);
        let from = if is_first(first) { first + 1 } else { first };
        if last + 1 >= from + MANY {
            runs.push(from..=last);
        }
        first = last + 1;
    }
    runs
}

/// The stages between two strikes.
fn between<'s, S, F>(
    stages: &'s [Stage<S, F>],
    from: &Strike<S>,
    to: &Strike<S>,
) -> impl Iterator<Item = &'s Stage<S, F>> {
    let (from, to) = (from.time, to.time);
    stages.iter().filter(move |s| s.start_time >= from && s.end_time <= to)
}

/// Limit of the series that was closed after strike `k`; without one, the time of the strike [s].
fn limit<S>(trace: &Happened<S>, k: usize) -> f64 {
    let Some(impact) = trace.strikes.get(k) else { return f64::INFINITY };
    let next = trace.strikes.get(k + 1).map_or(f64::INFINITY, |next| next.time);
    let closes = |(from, to): &&(f64, f64)| *from <= impact.time && impact.time <= *to && *to < next;
    trace.series.iter().rfind(closes).map_or(impact.time, |(_, to)| *to)
}

/// Runs of strikes, by number, with only short stages between them; the first strike on an obstacle stands alone.
fn runs<S, F>(stages: &[Stage<S, F>], trace: &Happened<S>) -> Vec<RangeInclusive<usize>> {
    let impacts = &trace.strikes;
    let bounces = |s: &Stage<S, F>| matches!(s.name, StageName::Flight | StageName::Swing | StageName::Stick);
    let goes_on = |k: usize| {
        let (this, next) = (&impacts[k], &impacts[k + 1]);
        this.obstacle == next.obstacle && between(stages, this, next).all(bounces)
    };
    let mut runs = vec![];
    let mut first = 0;
    while first < impacts.len() {
        let last = (first..impacts.len() - 1).find(|k| !goes_on(*k)).unwrap_or(impacts.len() - 1);
        let whole = limit(trace, last) - impacts[first].time;
        let mut from = first + 1;
        for k in first + 1..=last {
            let long = |s: &Stage<S, F>| s.end_time - s.start_time > LONG * whole;
            if k == last || between(stages, &impacts[k], &impacts[k + 1]).any(long) {
                runs.push(from..=k);
                from = k + 1;
            }
        }
        first = last + 1;
    }
    runs
}

/// The stage of a run of strikes; `None` where they are few and end.
fn clatter<S: Copy, F: Clone>(
    stages: &[Stage<S, F>],
    trace: &Happened<S>,
    run: &RangeInclusive<usize>,
) -> Option<Stage<S, F>> {
    let impacts = trace.strikes.get(run.clone())?;
    let (first, last) = (impacts.first()?, impacts.last()?);
    let end_time = limit(trace, *run.end());
    // A series that was closed at its limit goes on to it after the last strike that was followed.
    let closed = |since: f64| trace.series.iter().any(|(_, to)| since <= *to && *to <= end_time);
    let series = closed(first.time);
    if !series && impacts.len() < MANY {
        return None;
    }
    let pieces: Vec<usize> = (0..trace.pieces.len())
        .filter(|i| trace.pieces[*i][0] >= first.time && trace.pieces[*i][1] <= end_time)
        .collect();
    let start_piece = trace.pieces.iter().position(|[start, _]| *start >= first.time);
    let from = start_piece.unwrap_or(trace.pieces.len());
    // What follows a series starts at its last strike or at its limit.
    let next = stages.iter().find(|s| s.start_time >= last.time && s.start_time > first.time);
    let end_time = next.map_or(end_time, |next| next.start_time.max(last.time));
    let end = match next {
        Some(next) => next.start,
        None => last.after,
    };
    let mut struck = vec![];
    for on in impacts.iter().filter_map(|strike| strike.obstacle) {
        if !struck.contains(&on) {
            struck.push(on);
        }
    }
    Some(Stage {
        name: StageName::Clatter,
        obstacle: first.obstacle,
        start_time: first.time,
        end_time,
        start: first.before,
        end,
        // One that was closed on the way may be followed by strikes that come to no limit.
        ended_by: StageEnd::Strikes { count: impacts.len(), obstacles: struck, limit: closed(last.time) },
        pieces: from..pieces.last().map_or(from, |last| last + 1),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom_motion::planar::{Pose, State, Twist};

    /// Strikes at these times on these obstacles, with nothing but flights between them, folded; names and ends of what is left.
    fn folded(strikes: &[(f64, usize)], moment: f64) -> Vec<(StageName, f64, f64, StageEnd)> {
        let (pose, twist) = (Pose::default(), Twist::default());
        let still = State { pose, twist };
        let flight = |pair: &[(f64, usize)]| Stage {
            name: StageName::Flight,
            obstacle: None,
            start_time: pair[0].0,
            end_time: pair[1].0,
            start: still,
            end: still,
            ended_by: StageEnd::FliesAway,
            pieces: 0..0,
        };
        let strike = |(time, obstacle): &(f64, usize)| Strike {
            time: *time,
            obstacle: Some(*obstacle),
            before: still,
            after: still,
        };
        let all = strikes.iter().map(strike).collect();
        let trace = Happened { pieces: vec![], strikes: all, series: vec![] };
        let stages = fold(strikes.windows(2).map(flight).collect(), &trace, moment);
        stages.into_iter().map(|s| (s.name, s.start_time, s.end_time, s.ended_by)).collect()
    }

    fn strikes(count: usize, obstacles: &[usize]) -> StageEnd {
        StageEnd::Strikes { count, obstacles: obstacles.to_vec(), limit: false }
    }

    /// Of 1.3 s of bouncing one flight takes 0.5 s, more than a quarter: it stays a row, with the short ones before and after it folded.
    #[test]
    fn a_flight_of_more_than_a_quarter_of_the_bouncing_stays_a_row() {
        let times = [0.0, 0.1, 0.2, 0.3, 0.4, 0.9, 1.0, 1.1, 1.2, 1.3];
        let rows = folded(&times.map(|time| (time, 0)), 0.0);
        let names: Vec<StageName> = rows.iter().map(|row| row.0).collect();
        let (flight, clatter) = (StageName::Flight, StageName::Clatter);
        assert_eq!(names, [flight, clatter, flight, clatter], "{rows:?}");
        assert_eq!((rows[2].1, rows[2].2), (0.4, 0.9), "the long one");
        assert_eq!((rows[1].3.clone(), rows[3].3.clone()), (strikes(4, &[0]), strikes(5, &[0])));
    }

    #[test]
    fn strikes_on_several_obstacles_with_specks_between_them_are_one_row() {
        // First strikes on 1 and on 0, then ten in turn within 2 ms, then one after a while.
        let mut times = vec![(0.0, 1), (0.1, 0)];
        times.extend((0..10_u8).map(|i| (0.2 + 2e-4 * f64::from(i), usize::from(i % 2))));
        times.push((0.4, 1));
        let rows = folded(&times, 1e-3);
        let names: Vec<StageName> = rows.iter().map(|row| row.0).collect();
        let (flight, clatter) = (StageName::Flight, StageName::Clatter);
        assert_eq!(names, [flight, flight, clatter, flight], "{rows:?}");
        assert_eq!(rows[2].3, strikes(10, &[0, 1]), "all of them, on both");
        let apart = folded(&times, 1e-5);
        assert!(apart.iter().all(|row| row.0 == flight), "flights that are no specks stay: {apart:?}");
    }
}
