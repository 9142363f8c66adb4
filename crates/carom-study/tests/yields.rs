//! Yields: intervals that hold, errors that fall, results that do not depend on threads.

#![allow(clippy::print_stdout, reason = "how often intervals hold is a measurement")]

use crate::paper;

use carom_feeder::{Outcome, Run};
use carom_num::elementary::ln;
use carom_num::sobol::MOST_DIMENSIONS;
use carom_study::Ending;
use carom_study::yields::{
    Contrasts, NoIndices, Plan, Points, Portion, REPETITIONS, Sensitivity, Worst, Yield, YieldError, sample,
    sensitivity,
};
use paper::{feeder, turns};

fn plan(dimensions: usize, samples: u64, seed: u64, points: Points) -> Plan {
    Plan { dimensions, samples, seed, points, plates: 2, plate: 1 }
}

fn turned(plan: &Plan) -> Yield {
    sample(plan, feeder, turns, from_middle).unwrap()
}

fn from_middle(point: &[f64]) -> f64 {
    point.iter().map(|u| (u - 0.5).powi(2)).sum::<f64>()
}

/// A portion that turns over, sent and read.
fn portion(plan: &Plan, number: u32, of: u32) -> Portion {
    let counted = Portion::sampled(plan, (number, of), feeder, (turns, |_: &Run| true), from_middle).unwrap();
    Portion::of_words(&counted.to_words()).unwrap()
}

#[test]
fn intervals_hold_what_is_true() {
    let truth = turned(&plan(5, 8192, 1000, Points::Sobol)).wanted;
    assert!(truth.share > 0.1 && truth.share < 0.9, "a place near the boundary: {truth:?}");
    let mut held = 0;
    for seed in 0..16 {
        let found = turned(&plan(5, 64, seed, Points::Sobol)).wanted;
        held += u32::from(found.low <= truth.share && truth.share <= found.high);
    }
    println!("{held} of 16 intervals hold {:.5}", truth.share);
    assert!(held >= 14, "{held} of 16");
    // Plain Monte Carlo comes to the same.
    let plain = turned(&plan(5, 1024, 5, Points::Random)).wanted;
    assert!(plain.low < truth.share && truth.share < plain.high, "{plain:?} {truth:?}");
}

#[test]
fn errors_fall_faster_than_those_of_random_points() {
    for dimensions in [1, 3, 5] {
        let truth = turned(&plan(dimensions, 8192, 77, Points::Sobol)).wanted.share;
        // Root mean square over seeds, and the slope of a line through four sizes.
        let sizes = [16, 64, 256];
        let errors = sizes.map(|n| {
            let square =
                |seed: u64| (turned(&plan(dimensions, n, seed, Points::Sobol)).wanted.share - truth).powi(2);
            ((0..8).map(square).sum::<f64>() / 8.0).sqrt().max(1e-6)
        });
        let slope = ln(errors[2] / errors[0]) / ln(sizes[2] as f64 / sizes[0] as f64);
        println!("{dimensions} quantities: errors {errors:?}, slope {slope:.2}");
        assert!(slope < -0.55, "{dimensions}: {slope}");
    }
}

#[test]
fn quantiles_and_histograms_are_those_of_the_drops() {
    let seen = std::sync::Mutex::new(vec![]);
    let wanted = |run: &carom_feeder::Run| {
        let landings = run.landings.iter().filter(|landing| landing.plate == 1);
        seen.lock().unwrap().extend(landings.map(|landing| landing.impact_speed));
        true
    };
    let found = sample(&plan(5, 128, 2, Points::Sobol), feeder, wanted, |_| 0.0).unwrap();
    let spread = found.plates[1].impact_speed.as_ref().unwrap();
    let mut speeds = seen.into_inner().unwrap();
    speeds.sort_by(f64::total_cmp);
    assert_eq!(spread.count, speeds.len(), "every landing once");
    assert!(spread.count > 1000, "enough of them: {}", spread.count);
    let quantiles = [spread.p01, spread.p05, spread.p25, spread.median, spread.p75, spread.p95, spread.p99];
    for (share, quantile) in [0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99].into_iter().zip(quantiles) {
        let below = speeds.iter().filter(|speed| **speed < quantile).count() as f64;
        let upto = speeds.iter().filter(|speed| **speed <= quantile).count() as f64;
        let rank = share * speeds.len() as f64;
        assert!(below <= rank + 1.0 && rank <= upto + 1.0, "{share}: {below} to {upto}, not {rank}");
    }
    let histogram = &spread.histogram;
    let (edges, last) = (&histogram.edges, histogram.counts.len() - 1);
    for (k, count) in histogram.counts.iter().enumerate() {
        let in_it = |v: &&f64| **v >= edges[k] && (**v < edges[k + 1] || k == last && **v == edges[k + 1]);
        assert_eq!(*count, speeds.iter().filter(in_it).count() as u64, "bin {k}");
    }
    let whole = histogram.below + histogram.counts.iter().sum::<u64>() + histogram.above;
    assert_eq!(whole, speeds.len() as u64, "every landing in one bin or outside all");
}

#[test]
fn threads_change_nothing() {
    let of = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let plan = plan(5, 100, 3, Points::Sobol);
            let deciders = sensitivity(&plan, 64, |point| point[0] + 0.5 * point[1] > 0.7);
            (turned(&plan), deciders)
        })
    };
    let one = of(1);
    assert_eq!(one, of(2));
    assert_eq!(one, of(5));
    assert_eq!(one.0.drops, 128 * REPETITIONS as u64, "rounded up to a power of two");
    let passed: u64 = one.0.transitions.iter().map(|transition| transition.share.count).sum();
    assert_eq!(passed, one.0.drops, "every drop is counted once");
    let whole: f64 = one.0.transitions.iter().map(|transition| transition.share.share).sum();
    assert!((whole - 1.0).abs() < 1e-12, "all start on one face: {whole}");
}

#[test]
fn portions_say_together_what_one_machine_says() {
    let decides = |point: &[f64]| point[0] + 0.5 * point[1] > 0.7;
    for (samples, of) in [(3, 2), (300, 3), (600, 7), (2, 40)] {
        let plan = plan(5, samples, 3, Points::Sobol);
        // The last one is the first to come.
        let portions: Vec<Portion> = (0..of).rev().map(|number| portion(&plan, number, of)).collect();
        assert_eq!(Yield::of(portions).unwrap(), turned(&plan), "{samples} samples in {of} portions");
        let contrasts = |number: u32| {
            let counted = Contrasts::counted(&plan, 100, (number, of), decides).unwrap();
            Contrasts::of_words(&counted.to_words()).unwrap()
        };
        let found = Sensitivity::of((0..of).rev().map(contrasts).collect());
        assert_eq!(found, sensitivity(&plan, 100, decides), "what decides, in {of} portions");
    }
}

#[test]
fn portions_that_do_not_belong_together_are_refused() {
    let (one, other) = (plan(5, 3, 3, Points::Sobol), plan(5, 3, 4, Points::Sobol));
    let refused = |portions: Vec<Portion>| Yield::of(portions).unwrap_err();
    assert_eq!(refused(vec![]), YieldError::Portions, "none");
    assert_eq!(refused(vec![portion(&one, 0, 2)]), YieldError::Portions, "one is not there");
    assert_eq!(refused(vec![portion(&one, 1, 2), portion(&one, 1, 2)]), YieldError::Portions, "one twice");
    assert_eq!(refused(vec![portion(&one, 0, 2), portion(&other, 1, 2)]), YieldError::Portions, "seeds");
    let none = Portion::sampled(&one, (2, 2), feeder, (turns, turns), from_middle);
    assert_eq!(none.unwrap_err(), YieldError::Portion { number: 2, of: 2 });
    let none = Contrasts::counted(&one, 64, (0, 0), |_| true);
    assert_eq!(none.unwrap_err(), NoIndices::Portion { number: 0, of: 0 });
    assert_eq!(Sensitivity::of(vec![]), Err(NoIndices::Portions));
}

#[test]
fn numbers_that_are_no_portion_are_refused() {
    let words = portion(&plan(5, 3, 3, Points::Sobol), 0, 2).to_words();
    let counts = Contrasts::counted(&plan(5, 3, 3, Points::Sobol), 8, (0, 2), |_| true).unwrap().to_words();
    for length in 0..words.len() {
        assert_eq!(Portion::of_words(&words[..length]).unwrap_err(), YieldError::Unread, "{length} numbers");
    }
    for length in 0..counts.len() {
        assert_eq!(
            Contrasts::of_words(&counts[..length]).unwrap_err(),
            NoIndices::Unread,
            "{length} numbers"
        );
    }
    for k in 0..words.len() {
        let mut damaged = words.clone();
        damaged[k] ^= 1 << (k % 64);
        assert_eq!(Portion::of_words(&damaged).unwrap_err(), YieldError::Unread, "number {k} was changed");
    }
}

#[test]
fn a_worst_case_is_what_it_says() {
    let found = turned(&plan(5, 256, 9, Points::Sobol));
    assert!(!found.worst.is_empty());
    for worst in &found.worst {
        let run = feeder(&worst.point).unwrap().run_untraced().unwrap();
        assert_eq!(Ending::of(&run, 1), worst.ending);
        let hardest = run.landings.iter().map(|landing| landing.impact_speed).reduce(f64::max);
        assert_eq!(hardest, worst.impact_speed);
    }
    let of = |among: &dyn Fn(&Worst) -> bool| {
        found.worst.iter().filter(|w| among(w)).map(|w| w.among).sum::<u64>()
    };
    assert_eq!(of(&|worst| worst.hardest), found.drops);
    assert_eq!(of(&|worst| !worst.hardest), found.drops - found.wanted.count, "each is chosen from its like");
}

#[test]
fn indices_find_what_decides() {
    // x + y > 1 in a square: each has 1/3 of the variance by itself and the rest with the other: S = 1/3, T = 2/3, and z has none.
    let found = sensitivity(&plan(3, 1, 1, Points::Sobol), 1 << 14, |p| p[0] + p[1] > 1.0).unwrap();
    for s in &found[..2] {
        assert!((s.first - 1.0 / 3.0).abs() < 0.02 && (s.total - 2.0 / 3.0).abs() < 0.02, "{s:?}");
    }
    assert!(found[2].first.abs() < 0.02 && found[2].total == 0.0, "{:?}", found[2]);
    let few = sensitivity(&plan(3, 1, 1, Points::Random), 1 << 12, |p| p[0] + p[1] > 1.0).unwrap();
    for (s, truth) in found.iter().chain(&few).zip([1.0, 1.0, 0.0].into_iter().cycle()) {
        // Twice the interval of 95 %: none of twelve is outside.
        assert!((s.first - truth / 3.0).abs() <= 2.0 * s.first_error, "{s:?}");
        assert!((s.total - 2.0 * truth / 3.0).abs() <= 2.0 * s.total_error, "{s:?}");
    }
    assert!(few[0].first_error > 2.0 * found[0].first_error && few[0].first_error < 0.2, "{few:?}");
    let alike = sensitivity(&plan(3, 1, 1, Points::Sobol), 64, |_| true);
    assert_eq!(alike, Err(NoIndices::Alike), "nothing to explain");
    let many = sensitivity(&plan(MOST_DIMENSIONS, 1, 1, Points::Sobol), 64, |p| p[0] > 0.5);
    assert_eq!(many, Err(NoIndices::Dimensions { found: MOST_DIMENSIONS }));
}

#[test]
fn a_plan_that_cannot_be_is_refused() {
    let refused =
        |plan: &Plan| sample(plan, feeder, |run| run.outcome == Outcome::Landed, |_| 0.0).unwrap_err();
    assert_eq!(refused(&plan(0, 1, 0, Points::Sobol)), YieldError::Dimensions { found: 0 });
    assert_eq!(refused(&plan(65, 1, 0, Points::Sobol)), YieldError::Dimensions { found: 65 });
    assert_eq!(refused(&plan(1, 0, 0, Points::Sobol)), YieldError::Samples { found: 0, most: 1 << 30 });
}
