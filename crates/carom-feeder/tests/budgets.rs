//! A budget that runs out anywhere: the run says so, and what it said before is what the whole run says.

use crate::random;

use carom_feeder::{Feeder, Landing, Outcome, Run};
use carom_motion::planar::Options;

/// Feeders that are cut short everywhere, and the most events of one that is.
const FEEDERS: usize = 200;
const MOST_EVENTS: u64 = 400;
/// How far times may move where the end of the time shortens a step of the integration: its tolerance, made larger by the impacts after it.
const SHORTENED: f64 = 1e-8;
/// The same for when a part jams: that is the end of a series of rebounds, each a little lower, and rounding decides which of the last ones counts.
const JAMMED: f64 = 1e-3;

fn verdict(feeder: &Feeder, options: Options) -> Run {
    let prepared = feeder.prepare(options).unwrap();
    prepared.run_untraced().unwrap_or_else(|error| panic!("{error}: {feeder:?}"))
}

/// Random feeders with their whole runs, none of them cut short.
fn whole_runs() -> Vec<(Feeder, Run)> {
    let runs = (0..).map(random::feeder).filter_map(|feeder| {
        let run = feeder.prepare(Options::default()).ok()?.run_untraced().ok()?;
        (run.outcome != Outcome::NeverFlat && run.effort.events <= MOST_EVENTS).then_some((feeder, run))
    });
    runs.take(FEEDERS).collect()
}

/// The same time, to a fraction of the whole.
fn same(a: Option<f64>, b: Option<f64>, within: f64) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => (a - b).abs() <= within,
        (a, b) => a.is_none() && b.is_none(),
    }
}

/// True where a landing of a run that was cut short is no other than that of the whole run, as far as it got.
fn begins(cut: &Landing, whole: &Landing, within: f64) -> bool {
    let flat = same(cut.flat, whole.flat, within) && cut.verdict == whole.verdict && cut.face == whole.face;
    let touched = same(Some(cut.first_touch), Some(whole.first_touch), within);
    cut.plate == whole.plate && touched && (flat || cut.flat.is_none())
}

/// A run that was cut short says so, or says what the whole one does; its times agree to this fraction of the whole.
fn check(feeder: &Feeder, cut: &Run, whole: &Run, fraction: f64, at: &str) {
    let jams = cut.outcome == Outcome::Jammed && fraction > 0.0;
    let within = if jams { JAMMED } else { fraction } * whole.end_time;
    let count = cut.landings.len();
    assert!(count <= whole.landings.len(), "{at}: {:?} {feeder:?}", cut.landings);
    for (cut, whole) in cut.landings.iter().zip(&whole.landings) {
        assert!(begins(cut, whole, within), "{at}: {cut:?} is not the beginning of {whole:?}: {feeder:?}");
    }
    if cut.outcome == Outcome::NeverFlat {
        assert!(cut.exit.is_none(), "{at}, it has not left: {feeder:?}");
        assert!(cut.end_time <= whole.end_time + within, "{at}, it ends at {} s: {feeder:?}", cut.end_time);
        return;
    }
    assert_eq!(cut.outcome, whole.outcome, "{at}: {feeder:?}");
    assert_eq!(count, whole.landings.len(), "{at}: {feeder:?}");
    let (ends, end) = (cut.end_time, whole.end_time);
    assert!(same(Some(ends), Some(end), within), "{at}: ends at {ends} s, not {end} s: {feeder:?}");
    assert!(same(cut.exit.map(|e| e.time), whole.exit.map(|e| e.time), within), "{at}: {feeder:?}");
}

#[test]
fn events_that_run_out_anywhere_are_said() {
    let mut spent = 0;
    for (feeder, whole) in whole_runs() {
        let events = whole.effort.events;
        for most_events in 1..=events + 1 {
            let cut = verdict(&feeder, Options { most_events, ..Options::default() });
            check(&feeder, &cut, &whole, 0.0, &format!("{most_events} of {events} events"));
            spent += usize::from(cut.outcome == Outcome::NeverFlat);
            let enough = most_events > events;
            assert!(!enough || cut.outcome == whole.outcome, "one event more than it takes: {feeder:?}");
        }
    }
    assert!(spent > 10 * FEEDERS, "{spent} runs were cut short");
}

#[test]
fn time_that_runs_out_at_every_event_and_between_is_said() {
    let mut spent = 0;
    for (feeder, whole) in whole_runs() {
        let run = feeder.prepare(Options::default()).unwrap().run().unwrap();
        let ends: Vec<f64> =
            run.trace.pieces.iter().flat_map(|p| [0.5 * (p.start_time + p.end_time), p.end_time]).collect();
        for most_time in ends {
            let cut = verdict(&feeder, Options { most_time, ..Options::default() });
            check(&feeder, &cut, &whole, SHORTENED, &format!("{most_time} of {} s", whole.end_time));
            spent += usize::from(cut.outcome == Outcome::NeverFlat);
        }
        let cut = verdict(&feeder, Options { most_time: 1.001 * whole.end_time, ..Options::default() });
        assert_eq!(cut.outcome, whole.outcome, "more time than it takes: {feeder:?}");
    }
    assert!(spent > 10 * FEEDERS, "{spent} runs were cut short");
}
