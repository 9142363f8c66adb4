//! The floor and Carom say the same of every drop that the floor covers.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test fails by panicking, and says what it measured"
)]

use carom_floor::{Answer, Design, Landing, answer, coarse, fine, grid, options};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use std::collections::BTreeMap;

/// Carom's tolerance here: what is left of its error is far below what the floor promises.
const TIGHT: f64 = 1e-12;
/// Random variants of the grid's drops, and their seed.
const VARIANTS: usize = 3000;
const SEED: u64 = 20_261_121;
/// Share of the variants that move which the floor is to cover.
const COVERED: f64 = 0.95;
/// What the floor promises of times [s] and speeds [m/s], at its two settings.
const FINE: f64 = 1e-9;
const COARSE: f64 = 1e-6;
/// A few drops in a thousand stand so close to a border between two courses that errors grow: they are held to this much more.
const NEAR_A_BORDER: f64 = 30.0;

fn exact(design: &Design) -> Option<Answer> {
    answer(&design.feeder().unwrap().prepare(options(TIGHT)).unwrap()).unwrap()
}

/// Largest difference of two landings in touch, impact speed and lying flat; infinite where the verdicts differ.
fn difference(a: &Landing, b: &Landing) -> f64 {
    if a.turned != b.turned {
        return f64::INFINITY;
    }
    let parts = [a.first_touch - b.first_touch, a.impact_speed - b.impact_speed, a.flat - b.flat];
    parts.iter().fold(0.0, |worst, d| d.abs().max(worst))
}

fn random(rng: &mut Pcg64) -> Design {
    Design {
        upper_slope: rng.random_range(8.0..25.0_f64).to_radians(),
        lower_slope: rng.random_range(2.0..40.0_f64).to_radians(),
        line_b: rng.random_range(0.13..0.4),
        to_edge: rng.random_range(0.06..0.3),
        friction: rng.random_range(0.0..0.3),
    }
}

#[test]
fn all_98_designs_of_the_grid_agree() {
    let designs = grid();
    assert_eq!(designs.len(), 98, "the whole grid");
    for (name, run, within) in [("fine", fine as fn(&_) -> _, FINE), ("coarse", coarse, COARSE)] {
        let mut worst = 0.0_f64;
        for design in &designs {
            let pair = (run(&design.prepare()), exact(design));
            let (Answer::Lands(got), Some(Answer::Lands(exact))) = pair else {
                unreachable!("{name}: {design:?}: {pair:?}")
            };
            worst = worst.max(difference(&got, &exact));
        }
        println!("{name}: times and speeds of 98 designs within {worst:.1e}");
        assert!(worst < within, "{name}: {worst}");
    }
}

#[test]
fn the_floor_agrees_with_the_independent_solution_too() {
    let text = include_str!("../../../crates/carom-feeder/tests/reference/feeder_grid.csv");
    for (line, design) in text.lines().skip(1).zip(grid()) {
        let fields: Vec<&str> = line.split(',').map(str::trim).collect();
        let number = |i: usize| fields[i].parse::<f64>().unwrap();
        let Answer::Lands(got) = fine(&design.prepare()) else { unreachable!("it lands: {line}") };
        assert_eq!(got.turned, fields[2] == "turned", "{line}");
        // The table prints nine decimals, of a solution with relative tolerance 1e-10.
        let (touch, flat) = ((got.first_touch - number(7)).abs(), (got.flat - number(8)).abs());
        assert!(touch < 1e-7 && flat < 1e-7, "{touch} {flat}: {line}");
    }
}

#[test]
fn random_variants_agree_and_most_are_covered() {
    let mut rng = Pcg64::seed_from_u64(SEED);
    let (mut landed, mut not_covered, mut stuck) = (vec![], BTreeMap::new(), 0_u32);
    for _ in 0..VARIANTS {
        let design = random(&mut rng);
        match (fine(&design.prepare()), exact(&design)) {
            (Answer::Lands(got), Some(Answer::Lands(exact))) => {
                let difference = difference(&got, &exact);
                assert!(difference < FINE * NEAR_A_BORDER, "seed {SEED}: {design:?}: {got:?}, {exact:?}");
                landed.push(difference);
            }
            (Answer::Stuck, exact) => {
                assert_eq!(exact, Some(Answer::Stuck), "seed {SEED}: {design:?}");
                stuck += 1;
            }
            (Answer::NotCovered(why), _) => *not_covered.entry(why).or_insert(0_u32) += 1,
            (got, exact) => unreachable!("seed {SEED}: {design:?}: {got:?}, {exact:?}"),
        }
    }
    landed.sort_by(f64::total_cmp);
    let (worst, usual) = (landed[landed.len() - 1], landed[landed.len() * 99 / 100]);
    let left_out: u32 = not_covered.values().sum();
    let covered = landed.len() as f64 / (landed.len() as f64 + f64::from(left_out));
    println!(
        "{VARIANTS} variants: {} land alike within {worst:.1e} (99 of 100 within {usual:.1e}), {stuck} are stuck, not covered: {not_covered:?}",
        landed.len()
    );
    assert!(usual < FINE, "99 of 100 within {usual}");
    assert!(covered >= COVERED, "covered of those that move: {covered}");
}
