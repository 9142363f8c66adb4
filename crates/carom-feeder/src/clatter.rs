//! Folding: many strikes on one obstacle, one soon after the other, are one stage of the table.

use crate::run::{Stage, StageName};
use carom_motion::planar::State;
use carom_motion::planar::trace::{Impact, Trace};
use std::ops::RangeInclusive;

/// Strikes that are folded even where no series was closed at its limit.
const MANY: usize = 4;
/// A stage longer than this share of all the bouncing on one obstacle stays a row of its own: at most three can.
const LONG: f64 = 0.25;

/// Folds the strikes that follow the first one on an obstacle, and the short stages between them, into one stage each.
pub(crate) fn fold(stages: Vec<Stage>, trace: &Trace) -> Vec<Stage> {
    let mut stages = stages;
    for run in runs(&stages, trace) {
        if let Some(clatter) = clatter(&stages, trace, &run) {
            let inside = |s: &Stage| s.start_time >= clatter.start_time && s.end_time <= clatter.end_time;
            let at = stages.iter().position(|s| s.start_time >= clatter.start_time).unwrap_or(stages.len());
            stages.retain(|s| !inside(s));
            stages.insert(at, clatter);
        }
    }
    stages
}

fn obstacle(impact: &Impact) -> Option<usize> {
    impact.contacts.first().map(|contact| contact.obstacle)
}

/// The stages between two strikes.
fn between<'s>(stages: &'s [Stage], from: &Impact, to: &Impact) -> impl Iterator<Item = &'s Stage> {
    let (from, to) = (from.time, to.time);
    stages.iter().filter(move |s| s.start_time >= from && s.end_time <= to)
}

/// The limit of the series that strike `k` was the last one followed of, else the strike's own time [s].
fn limit(trace: &Trace, k: usize) -> f64 {
    let Some(impact) = trace.impacts.get(k) else { return f64::INFINITY };
    let next = trace.impacts.get(k + 1).map_or(f64::INFINITY, |next| next.time);
    let closes = |(from, to): &&(f64, f64)| *from <= impact.time && impact.time <= *to && *to < next;
    trace.accumulations.iter().find(closes).map_or(impact.time, |(_, to)| *to)
}

/// Runs of strikes, by number, with only short stages between them; the first strike on an obstacle stands alone.
fn runs(stages: &[Stage], trace: &Trace) -> Vec<RangeInclusive<usize>> {
    let impacts = &trace.impacts;
    let bounces = |s: &Stage| matches!(s.name, StageName::Flight | StageName::Swing | StageName::Stick);
    let goes_on = |k: usize| {
        let (this, next) = (&impacts[k], &impacts[k + 1]);
        obstacle(this) == obstacle(next) && between(stages, this, next).all(bounces)
    };
    let mut runs = vec![];
    let mut first = 0;
    while first < impacts.len() {
        let last = (first..impacts.len() - 1).find(|k| !goes_on(*k)).unwrap_or(impacts.len() - 1);
        let whole = limit(trace, last) - impacts[first].time;
        let mut from = first + 1;
        for k in first + 1..=last {
            let long = |s: &Stage| s.end_time - s.start_time > LONG * whole;
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
fn clatter(stages: &[Stage], trace: &Trace, run: &RangeInclusive<usize>) -> Option<Stage> {
    let impacts = trace.impacts.get(run.clone())?;
    let (first, last) = (impacts.first()?, impacts.last()?);
    let end_time = limit(trace, *run.end());
    let series = trace.accumulations.iter().any(|(_, to)| first.time <= *to && *to <= end_time);
    if !series && impacts.len() < MANY {
        return None;
    }
    let pieces: Vec<usize> = (0..trace.pieces.len())
        .filter(|i| trace.pieces[*i].start_time >= first.time && trace.pieces[*i].end_time <= end_time)
        .collect();
    let start_piece = trace.pieces.iter().position(|p| p.start_time >= first.time);
    let from = start_piece.unwrap_or(trace.pieces.len());
    let next = stages.iter().find(|s| s.start_time >= end_time && s.start_time > first.time);
    let end = match next {
        Some(next) => next.start,
        None => State { pose: last.pose, twist: last.after },
    };
    let count = impacts.len();
    Some(Stage {
        name: StageName::Clatter,
        obstacle: obstacle(first),
        start_time: first.time,
        end_time,
        start: State { pose: first.pose, twist: first.before },
        end,
        ended_by: match (series, count) {
            (true, 1) => "one strike, then the limit of ever smaller ones".to_owned(),
            (true, _) => format!("{count} strikes, ever smaller, then their limit"),
            (false, _) => format!("{count} strikes"),
        },
        pieces: from..pieces.last().map_or(from, |last| last + 1),
    })
}
