//! Yields by their boundary: intervals that hold, even where lines do not see everything, and far fewer drops.

#![allow(clippy::print_stdout, reason = "how often intervals hold is a measurement")]

use crate::paper;

use carom_feeder::Verdict;
use carom_study::Ending;
use carom_study::yields::{Plan, Points, locate, sample};
use paper::{ending, feeder};

fn plan(dimensions: usize, samples: u64, seed: u64) -> Plan {
    Plan { dimensions, samples, seed, points: Points::Sobol, plates: 2, plate: 1 }
}

/// How many of a hundred intervals hold the truth, and their mean half-width.
fn held(truth: f64, dimensions: usize, samples: u64, wanted: impl Fn(&[f64]) -> bool + Sync) -> (usize, f64) {
    let found: Vec<_> =
        (0..100).map(|seed| locate(&plan(dimensions, samples, seed), &wanted).unwrap().wanted).collect();
    let held = found.iter().filter(|one| one.low <= truth && truth <= one.high).count();
    (held, found.iter().map(|one| 0.5 * (one.high - one.low)).sum::<f64>() / 100.0)
}

#[test]
fn intervals_hold_the_volume_of_a_corner() {
    // u + v + w + x + y < 5/2 is a half, and 1/120 is the corner that 1 cuts off.
    for (limit, truth) in [(2.5, 0.5), (1.0, 1.0 / 120.0)] {
        let (held, half) = held(truth, 5, 16, |u| u.iter().sum::<f64>() < limit);
        println!("below {limit}: {held} of 100 hold {truth}, ± {half:.1e}");
        assert!(held >= 93, "{held} of 100");
    }
}

#[test]
fn what_lines_do_not_see_widens_the_interval_and_biases_nothing() {
    // A window between two nodes of every line, and a thin one: u < 0.4, but for 0.55 to 0.6 and 0.1 to 0.11.
    let wanted = |u: &[f64]| {
        let x = u[0] + 0.05 * (u[1] - 0.5);
        (x < 0.4) != ((0.55..0.6).contains(&x) || (0.1..0.11).contains(&x))
    };
    let truth = 0.4 + 0.05 - 0.01;
    let (held, half) = held(truth, 2, 32, wanted);
    println!("{held} of 100 hold {truth}, ± {half:.1e}");
    assert!(held >= 93, "{held} of 100");
    assert!(half > 5e-3, "{half:e}: half of these lines miss a twentieth of themselves");
}

/// The paper's drop with five tolerances: as sure as a thousandth, for a tenth of the drops.
#[test]
fn a_yield_is_known_to_a_thousandth_for_few_drops() {
    let ends = |point: &[f64]| ending(feeder(point).as_ref()) == Ending::Lies(Verdict::Turned);
    let truth = sample(&plan(5, 16_384, 77), feeder, paper::turns, |_| 0.0).unwrap();
    let found = locate(&plan(5, 8, 1), ends).unwrap();
    let [half, of_samples] = [found.wanted, truth.wanted].map(|one| 0.5 * (one.high - one.low));
    println!(
        "{:.5} ± {half:.1e} by {} drops along {}, {:.5} ± {of_samples:.1e} by {} drops",
        found.wanted.share, found.drops, found.along, truth.wanted.share, truth.drops
    );
    assert!((found.wanted.share - truth.wanted.share).abs() <= half + of_samples, "{found:?}");
    assert!(half <= 1e-3 && found.drops < 2500, "± {half:e} by {} drops", found.drops);
}

#[test]
fn what_nobody_sees_is_bounded_beside_the_interval() {
    // All, nothing, and a window of a hundredth that few checks meet.
    let all = locate(&plan(2, 8, 1), |_| true).unwrap();
    let none = locate(&plan(1, 1, 1), |_| false).unwrap();
    assert_eq!([all.wanted.share, none.wanted.share], [1.0, 0.0]);
    assert!(all.unseen < 4.0 / 128.0 && none.unseen < 4.0 / 16.0 && none.unseen > 0.1, "{all:?} {none:?}");
    let window = |u: &[f64]| (0.3..0.31).contains(&u[0]);
    let held = (0..100).filter(|seed| {
        let found = locate(&plan(2, 1, *seed), window).unwrap();
        (found.wanted.low - found.unseen..=found.wanted.high + found.unseen).contains(&0.01)
    });
    assert!(held.count() >= 95, "with what is unseen intervals hold");
    assert!(locate(&plan(2, 1 << 20, 1), window).is_err(), "a million lines in each repetition");
}
