//! A budget that runs out anywhere: the run says so, and what it said before is what the whole run says.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod random;

use carom_feeder::{Feeder, Landing, Outcome, Run};
use carom_motion::planar::Options;

/// Feeders that are cut short everywhere, and the most events of one that is.
const FEEDERS: usize = 60;
const MOST_EVENTS: u64 = 400;

fn verdict(feeder: &Feeder, options: Options) -> Run {
    let prepared = feeder.prepare(options).unwrap();
    prepared.verdict().unwrap_or_else(|error| panic!("{error}: {feeder:?}"))
}

/// Random feeders with their whole runs, none of them cut short.
fn whole_runs() -> Vec<(Feeder, Run)> {
    let runs = (0..).map(random::feeder).filter_map(|feeder| {
        let run = feeder.prepare(Options::default()).ok()?.verdict().ok()?;
        (run.outcome != Outcome::NeverFlat && run.work.events <= MOST_EVENTS).then_some((feeder, run))
    });
    runs.take(FEEDERS).collect()
}

/// True where a landing of a run that was cut short is no other than that of the whole run, as far as it got.
fn begins(cut: &Landing, whole: &Landing) -> bool {
    let same_end = cut.flat == whole.flat && cut.verdict == whole.verdict && cut.face == whole.face;
    let not_yet = cut.flat.is_none();
    cut.plate == whole.plate && cut.first_touch == whole.first_touch && (same_end || not_yet)
}

/// A run that was cut short says so, or says what the whole one does.
fn check(feeder: &Feeder, cut: &Run, whole: &Run, at: &str) {
    if cut.outcome != Outcome::NeverFlat {
        assert_eq!(cut.outcome, whole.outcome, "{at}: {feeder:?}");
        assert_eq!(cut.end_time, whole.end_time, "{at}: {feeder:?}");
        assert_eq!(cut.landings, whole.landings, "{at}: {feeder:?}");
        assert_eq!(cut.exit, whole.exit, "{at}: {feeder:?}");
        return;
    }
    assert!(cut.exit.is_none(), "{at}, it has not left: {feeder:?}");
    assert!(cut.end_time <= whole.end_time, "{at}, it ends at {} s: {feeder:?}", cut.end_time);
    assert!(cut.landings.len() <= whole.landings.len(), "{at}: {:?} {feeder:?}", cut.landings);
    for (cut, whole) in cut.landings.iter().zip(&whole.landings) {
        assert!(begins(cut, whole), "{at}: {cut:?} is not the beginning of {whole:?}: {feeder:?}");
    }
}

#[test]
fn events_that_run_out_anywhere_are_said() {
    let mut spent = 0;
    for (feeder, whole) in whole_runs() {
        let events = whole.work.events;
        for most_events in 1..=events + 1 {
            let cut = verdict(&feeder, Options { most_events, ..Options::default() });
            check(&feeder, &cut, &whole, &format!("{most_events} of {events} events"));
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
            check(&feeder, &cut, &whole, &format!("{most_time} of {} s", whole.end_time));
            spent += usize::from(cut.outcome == Outcome::NeverFlat);
        }
        let cut = verdict(&feeder, Options { most_time: 1.001 * whole.end_time, ..Options::default() });
        assert_eq!(cut.outcome, whole.outcome, "more time than it takes: {feeder:?}");
    }
    assert!(spent > 10 * FEEDERS, "{spent} runs were cut short");
}
