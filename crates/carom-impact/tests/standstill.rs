//! Hypotheses that leave no response are not tried one by one: the answer is the one that trying all of them gives.

#![allow(clippy::print_stdout, reason = "how many answers there are is a measurement")]

use crate::random::numbers;
use carom_impact::Load;
use carom_impact::planar::rate::RateProblem;
use carom_impact::planar::{Answer, ContactSet6, Slip, Solution, Touch};
use carom_num::Vec2;

const CASES: u32 = 30_000;
/// Motions that differ by less than this fraction of the largest velocity are one, as the engine has it.
const SAME_MOTION: f64 = 1e-8;
/// Forces and margins differ by what the order of a sum does.
const ROUNDING: f64 = 1e-9;

/// Contacts of a case: all around a body, or feet on one floor, which hold two velocities however many they are.
fn set(case: u32, number: &impl Fn(usize) -> f64) -> ContactSet6 {
    let on_floor = case.is_multiple_of(3);
    let touch = |i: usize| {
        let share =
            |k: usize| (number(k) + (i as f64 + 1.0) * [0.618_034, 0.754_878, 0.569_840][k % 3]).fract();
        let normal = if on_floor { Vec2::new(0.0, 1.0) } else { Vec2::at_angle(6.3 * share(0)) };
        let height = if on_floor { 0.5 } else { share(1) };
        let friction = match (case / 3 + i as u32) % 7 {
            0 => 0.0,
            1 => f64::INFINITY,
            _ => 1.5 * share(2),
        };
        Touch {
            arm: normal.turned_left() * (share(3) - 0.5) - normal * height,
            normal,
            friction,
            restitution: 0.0,
        }
    };
    let touches: Vec<Touch> = (0..3 + case as usize % 4).map(touch).collect();
    let (velocity, spin) = (Vec2::new(number(4) - 0.5, number(5) - 0.5), number(6) - 0.5);
    ContactSet6::of_free_body(1.0, 0.02 + number(7), velocity, spin, &touches).unwrap()
}

/// Its rate problem: driven by the velocities that it has, in every fifth case by any; some contacts slip, some are loaded.
fn problem<'s>(case: u32, set: &'s ContactSet6, number: &impl Fn(usize) -> f64) -> RateProblem<'s, 6, 12> {
    let any = |i: usize| [number(8 + i % 4) - 0.5, number(9 + i % 3) - 0.6];
    let drive = |i: usize| if case.is_multiple_of(5) { any(i) } else { [set.slip[i], set.normal[i]] };
    let slip = |i: usize| if (case / 7 + i as u32).is_multiple_of(4) { number(12) - 0.5 } else { 0.0 };
    let load = |i: usize| match (case / 11 + i as u32) % 9 {
        _ if i >= set.count => Load::Absent,
        0 | 1 if case.is_multiple_of(2) => Load::Touching(0.3 * number(13)),
        2 if case.is_multiple_of(2) => Load::Prescribed(0.3 * number(14)),
        _ => Load::Touching(0.0),
    };
    RateProblem {
        count: set.count,
        operator: &set.operator,
        friction: &set.friction,
        drive: std::array::from_fn(drive),
        slip: std::array::from_fn(slip),
        load: std::array::from_fn(load),
    }
}

/// True where each solution of `a` is one of `b`: the same motion, and forces as far from being rejected.
fn within(a: &Answer<6>, b: &Answer<6>) -> bool {
    let apart = |x: &[[f64; 2]; 6], y: &[[f64; 2]; 6]| {
        x.iter().flatten().zip(y.iter().flatten()).fold(0.0, |m: f64, (x, y)| m.max((x - y).abs()))
    };
    let same = |x: &Solution<6>, y: &Solution<6>| {
        x.guess == y.guess
            && x.indeterminate == y.indeterminate
            && apart(&x.response, &y.response) < SAME_MOTION
            && apart(&x.rates, &y.rates) < ROUNDING
            && (x.margin - y.margin).abs() < ROUNDING
    };
    a.iter().all(|x| b.iter().any(|y| same(x, y)))
}

#[test]
fn what_leaves_no_response_is_answered_at_once_as_if_all_of_it_were_tried() {
    let (mut none, mut one, mut several, mut still) = (0, 0, 0, 0);
    for case in 0..CASES {
        let number = numbers(case);
        let set = set(case, &number);
        let problem = problem(case, &set, &number);
        let (quick, tried) = (problem.solve(), problem.solve_observed(&mut |_, _| {}));
        let holds = |s: &Solution<6>| s.guess[..set.count].iter().all(|g| g.holds && g.slip == Slip::Sticks);
        // Beyond those that are kept, one motion counts as often as it is found.
        let many = quick.count > Answer::<6>::KEPT && tried.count >= quick.count;
        assert_eq!(quick.iter().any(holds), tried.iter().any(holds), "case {case}: it stays, or not");
        assert!(
            many || quick.count == tried.count && within(&quick, &tried) && within(&tried, &quick),
            "case {case}: {quick:#?}\nand not\n{tried:#?}"
        );
        *[&mut none, &mut one, &mut several][quick.count.min(2)] += 1;
        still += u32::from(quick.iter().any(holds));
    }
    println!("no solution {none}, one {one}, several {several}; all contacts stick in {still}");
    assert!(none.min(one).min(several).min(still) > CASES / 100, "{none}, {one}, {several}, {still}");
}

#[test]
fn more_contacts_than_there_is_room_for_have_no_solution() {
    let set = set(1, &numbers(1));
    let problem = RateProblem { count: 7, ..problem(1, &set, &numbers(1)) };
    let counts = (problem.solve().count, problem.solve_observed(&mut |_, _| {}).count);
    assert_eq!(counts, (0, 0), "seven contacts in a problem of six");
    let operator = std::array::from_fn::<_, 4, _>(|i| std::array::from_fn(|j| set.operator[i % 3][j % 3]));
    let small = RateProblem::<4, 8> {
        count: 5,
        operator: &operator,
        friction: &[0.5; 4],
        drive: [[0.0, -1.0]; 4],
        slip: [0.0; 4],
        load: [Load::Touching(0.0); 4],
    };
    assert_eq!(small.solve().count, 0, "five contacts in a problem of four");
}
