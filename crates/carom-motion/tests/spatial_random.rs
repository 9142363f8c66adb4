//! Random bodies in space: what holds for all of them.

#![allow(clippy::print_stdout, reason = "what random bodies come to is a measurement")]

use crate::bodies;

use carom_motion::spatial::{Budget, End, Options, Run, Samples, World, run};
use std::collections::BTreeMap;

const CASES: u64 = 3000;
/// What an impact may add to the kinetic energy by rounding, as a fraction of it.
const GAIN: f64 = 1e-14;
/// Of the energy between events, in m g × reach + kinetic energy.
const DRIFT: f64 = 1e-12;
/// How deep a support may be below the plane between events, at samples of dense output, in units of the reach.
const DEPTH: f64 = 1e-12;

/// The same where steps have a tolerance of 1e-8: their dense output is that much coarser.
const LONG_STEP_DEPTH: f64 = 1e-6;

fn name(end: &End) -> &'static str {
    match end {
        End::AtRest { .. } => "at rest",
        End::Balanced { .. } => "balanced",
        End::NoConsistentOutcome(_) => "no consistent outcome",
        End::BudgetSpent(Budget::Time) => "still moves",
        End::Overturned
        | End::FliesAway
        | End::Flat { .. }
        | End::Several(_)
        | End::BudgetSpent(_)
        | End::Stopped => "unexpected",
    }
}

fn deepest(world: &World, samples: &Samples) -> f64 {
    let supports = world.body().supports();
    let lowest = |state: &carom_motion::spatial::State| {
        supports.iter().map(|r| state.place(*r).z).fold(f64::INFINITY, f64::min)
    };
    -samples.instants.iter().map(|(_, _, state)| lowest(state)).fold(f64::INFINITY, f64::min)
        / world.scales().length
}

fn gain(run: &Run) -> f64 {
    let of = |i: &carom_motion::spatial::Impact| (i.kinetic_after - i.kinetic_before) / i.kinetic_before;
    run.impacts.iter().map(of).fold(f64::NEG_INFINITY, f64::max)
}

#[test]
fn energy_never_grows_and_nothing_sinks_into_the_plane() {
    let mut ends: BTreeMap<&str, u32> = BTreeMap::new();
    let (mut worst, mut impacts, mut evaluations) = ([f64::NEG_INFINITY; 3], 0, 0);
    for case in 0..CASES {
        let (world, start) = bodies::drawn(case);
        let mut samples = Samples::default();
        let options = Options { most_time: 5.0, ..Options::default() };
        let run = run(&world, &start, &options, &mut samples).unwrap();
        *ends.entry(name(&run.end)).or_default() += 1;
        let own = [run.drift, gain(&run), deepest(&world, &samples)];
        assert!(own[0] < DRIFT && own[1] < GAIN && own[2] < DEPTH, "case {case}: {own:?}");
        assert_ne!(name(&run.end), "unexpected", "case {case}: {:?} {:?}", run.end, run.effort);
        worst = std::array::from_fn(|i| worst[i].max(own[i]));
        (impacts, evaluations) = (impacts + run.impacts.len(), evaluations + run.effort.evaluations);
    }
    println!("{CASES} bodies, {impacts} impacts, {evaluations} evaluations: {ends:?}");
    println!("drift {:e}, gain {:e}, depth {:e}", worst[0], worst[1], worst[2]);
    assert!(ends["at rest"] > 500 && ends["no consistent outcome"] > 500, "all kinds are met: {ends:?}");
}

/// Longer steps are a harder trial: whatever comes down and leaves again within one must be seen.
#[test]
fn no_touch_is_passed_over_by_long_steps() {
    let mut worst = f64::NEG_INFINITY;
    for case in 0..600 {
        let (world, start) = bodies::drawn(case);
        let mut samples = Samples::default();
        let options = Options { tolerance: 1e-8, most_time: 2.0, most_impacts: 100, ..Options::default() };
        run(&world, &start, &options, &mut samples).unwrap();
        worst = worst.max(deepest(&world, &samples));
    }
    println!("depth with a tolerance of 1e-8: {worst:e}");
    assert!(worst < LONG_STEP_DEPTH, "{worst:e}");
}

#[test]
fn a_run_is_the_same_whoever_looks_on() {
    for case in 0..100 {
        let (world, start) = bodies::drawn(case);
        let options = Options { most_time: 2.0, ..Options::default() };
        let alone = run(&world, &start, &options, &mut ()).unwrap();
        let seen = run(&world, &start, &options, &mut Samples::default()).unwrap();
        assert_eq!(alone, seen, "case {case}");
    }
}

#[test]
fn when_a_series_is_closed_hardly_moves_the_time_of_rest() {
    let mut apart = vec![];
    for case in 0..1000 {
        let (world, start) = bodies::drawn(case);
        let ended = |closing: f64| {
            let options = Options { closing, most_time: 5.0, ..Options::default() };
            run(&world, &start, &options, &mut ()).unwrap()
        };
        let (early, late) = (ended(1e-4), ended(1e-5));
        if let (true, End::AtRest { .. }) = (early.end == late.end, late.end) {
            apart.push((early.time - late.time).abs() / world.scales().time);
        }
    }
    apart.sort_by(f64::total_cmp);
    let at = |part: usize| apart[(apart.len() - 1) * part / 100];
    println!("{} bodies: half within {:e}, 90 % {:e}, all {:e}", apart.len(), at(50), at(90), at(100));
    assert!(apart.len() > 200 && at(50) < 1e-10 && at(90) < 1e-6 && at(100) < 1e-4, "{:e}", at(100));
}
