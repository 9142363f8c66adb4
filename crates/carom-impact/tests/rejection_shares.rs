//! By how much a hypothesis is rejected: a share in 0…1, and of the broken inequalities the one with the largest.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test fails by panicking, and says what it measured"
)]

use carom_impact::Load;
use carom_impact::planar::rate::RateProblem;
use carom_impact::planar::{Block, Broken, Condition, ContactSet6, Guess, Slip, Touch};
use carom_num::Vec2;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

const IMPACTS: u32 = 100_000;
/// Shares that differ by less are the same but for rounding.
const SAME: f64 = 1e-9;
/// A contradiction of equations below this fraction is rounding, as in the engine.
const CONTRADICTION: f64 = 1e-9;

type Problem<'a> = RateProblem<'a, 6, 12>;

fn drawn(rng: &mut Pcg64) -> ContactSet6 {
    let touch = |rng: &mut Pcg64| Touch {
        arm: Vec2::new(rng.random_range(-1.0..1.0), rng.random_range(-1.0..1.0)),
        normal: Vec2::at_angle(rng.random_range(-3.2..3.2)),
        friction: [0.0, rng.random_range(0.0..1.0), rng.random_range(0.0..8.0)][rng.random_range(0..3)],
        restitution: 0.0,
    };
    let count = [1, 1, 2, 2, 2, 2, 3][rng.random_range(0..7)];
    let touches: Vec<Touch> = (0..count).map(|_| touch(rng)).collect();
    let velocity = Vec2::new(rng.random_range(-1.0..1.0), rng.random_range(-1.0..1.0));
    ContactSet6::of_free_body(
        1.0,
        rng.random_range(0.02..1.0),
        velocity,
        rng.random_range(-2.0..2.0),
        &touches,
    )
    .unwrap()
}

/// The share by which an inequality `left ≥ right` between sums of these terms is broken, below 0 where it is not.
fn share(left: &[f64], right: &[f64]) -> f64 {
    let sum = |terms: &[f64]| terms.iter().sum::<f64>();
    let size: f64 = left.iter().chain(right).map(|term| term.abs()).sum();
    if size == 0.0 { 0.0 } else { (sum(right) - sum(left)) / size }
}

/// The terms of contact i's response along an axis.
fn terms(problem: &Problem, rates: &[[f64; 2]; 6], i: usize, axis: usize) -> Vec<f64> {
    let mut terms = vec![problem.drive[i][axis]];
    for (Block { tt, tn, nt, nn }, [q, r]) in problem.operator[i].iter().zip(rates).take(problem.count) {
        terms.extend(if axis == 0 { [tt * q, tn * r] } else { [nt * q, nn * r] });
    }
    terms
}

/// Every inequality of a hypothesis with its share; those of the motion alone where its forces are not determined.
fn shares(problem: &Problem, guess: &[Guess; 6]) -> Vec<(Condition, f64)> {
    let Some((rates, open)) = problem.rates_of(guess, CONTRADICTION) else {
        return vec![(Condition::Solvable, 1.0)];
    };
    let all: Vec<f64> = rates.iter().flatten().map(|rate| -rate.abs()).collect();
    let mut out = vec![];
    for i in 0..problem.count {
        let ([q, r], g) = (rates[i], guess[i]);
        let starts = problem.slip[i] == 0.0 && problem.friction[i] > 0.0;
        let along = terms(problem, &rates, i, 0);
        match g.slip {
            _ if !g.holds => out.push((Condition::Opens(i), share(&terms(problem, &rates, i, 1), &[]))),
            Slip::Forward if starts => out.push((Condition::StartsForward(i), share(&along, &[]))),
            Slip::Backward if starts => out.push((Condition::StartsBackward(i), share(&[], &along))),
            _ => {}
        }
        if g.holds && !open {
            // Against all rates: its own is one of them.
            let size: f64 = -all.iter().sum::<f64>();
            out.push((Condition::Pushes(i), if size == 0.0 { 0.0 } else { -r / size }));
            // Only a push has a cone.
            if g.slip == Slip::Sticks && r >= 0.0 {
                out.push((Condition::WithinCone(i), share(&[problem.friction[i] * r], &[q.abs()])));
            }
        }
    }
    out
}

#[test]
fn every_share_is_in_zero_to_one_and_the_largest_is_named() {
    let mut rng = Pcg64::seed_from_u64(24);
    let (mut rejected, mut largest) = (0_u32, 0.0_f64);
    for impact in 0..IMPACTS {
        let set = drawn(&mut rng);
        // Half of them slip as they do, the others end in any slip.
        let slip = if impact % 2 == 0 { [0.0; 6] } else { set.slip };
        let problem = Problem {
            count: set.count,
            operator: &set.operator,
            friction: &set.friction,
            drive: std::array::from_fn(|i| [set.slip[i], set.normal[i]]),
            slip,
            load: std::array::from_fn(|i| if i < set.count { Load::Touching(0.0) } else { Load::Absent }),
        };
        problem.solve_observed(&mut |guess, broken| {
            rejected += 1;
            let (named, by) = (broken.condition, broken.share);
            assert!(by > 0.0 && by <= 1.0, "impact {impact}: {named:?} is broken by {by}");
            largest = largest.max(by);
            let all = shares(&problem, guess);
            let of_named = all.iter().find(|(condition, _)| *condition == named).map(|(_, share)| *share);
            let most = all.iter().fold(0.0_f64, |most, (_, share)| most.max(*share));
            match of_named {
                Some(share) => {
                    assert!((share - by).abs() < SAME, "impact {impact}: {named:?} by {by}, and not {share}");
                    assert!(
                        share > most - SAME,
                        "impact {impact}: {named:?} by {share}, but there is {most}: {all:?}"
                    );
                }
                // Forces that are not determined were looked at after the motion, which is sound.
                None => assert!(most < SAME, "impact {impact}: {named:?}, but {all:?}"),
            }
        });
    }
    println!("{rejected} hypotheses are rejected, by {largest} at most");
    assert!(rejected > IMPACTS, "{rejected}");
}

/// To stick takes 4 N s along the contact and a pull of 1 N s: the pull is named, for only a push has a friction cone.
#[test]
fn a_pull_is_named_before_the_cone_that_it_does_not_have() {
    // Sticking takes q, r with (q, r) = −W⁻¹ (u_t, u_n) = (4, −1).
    let operator = [[Block { tt: 1.0, tn: 0.0, nt: 0.0, nn: 1.0 }]];
    let problem = RateProblem::<1, 2> {
        count: 1,
        operator: &operator,
        friction: &[0.5],
        drive: [[-4.0, 1.0]],
        slip: [0.0],
        load: [Load::Touching(0.0)],
    };
    let sticks = [Guess { holds: true, slip: Slip::Sticks }];
    let broken = Broken { condition: Condition::Pushes(0), amount: 1.0, share: 0.2 };
    assert_eq!(problem.try_guess(&sticks).unwrap_err(), broken);
}
