//! By how much a hypothesis is rejected in space: a share in 0…1, and of the broken inequalities the one with the largest.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test fails by panicking, and says what it measured"
)]

use carom_impact::Load;
use carom_impact::spatial::{Condition, ContactSet, Guess, Mode, RateProblem, RigidBody, Touch};
use carom_num::solve::solve_regular;
use carom_num::{Mat3, Vec3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

const IMPACTS: u32 = 100_000;
/// Shares that differ by less are the same but for rounding.
const SAME: f64 = 1e-9;
/// Equations with a smaller pivot than this fraction of the largest are left out: their rates are open, or rounding.
const REGULAR: f64 = 1e-6;

type Problem<'a> = RateProblem<'a, 3>;
/// Three unknown rates of each of three contacts.
const UNKNOWNS: usize = 9;

fn drawn(random: &mut Pcg64) -> (ContactSet<3>, [[f64; 2]; 3], [Load; 3]) {
    let mut number = |low: f64, high: f64| random.random_range(low..high);
    let inertia = Mat3::diagonal(number(0.1, 0.2), number(0.1, 0.2), number(0.1, 0.2));
    let mut vector = || Vec3::new(number(-1.0, 1.0), number(-1.0, 1.0), number(-1.0, 1.0));
    let body = RigidBody { mass: 0.7, inertia, velocity: vector(), spin: vector() };
    let places: [Vec3; 6] = std::array::from_fn(|_| vector());
    let count = [1, 1, 1, 2, 2, 3][random.random_range(0..6)];
    let touches: Vec<Touch> = (0..count)
        .map(|i| Touch {
            arm: places[i],
            normal: places[i + 3].unit().unwrap(),
            friction: [0.0, random.random_range(0.0..1.0), random.random_range(0.0..5.0)]
                [random.random_range(0..3)],
            restitution: 0.0,
        })
        .collect();
    let set = ContactSet::of_free_body(&body, &touches).unwrap();
    // Of several contacts the first may stick: which ways several slips start is another matter.
    let rests = random.random_bool(0.6);
    let slip =
        std::array::from_fn(
            |i| if i == 0 && rests { [0.0; 2] } else { [set.velocity[i].x, set.velocity[i].y] },
        );
    let restitutes = random.random_bool(0.3);
    let load = std::array::from_fn(|i| match (i < count, restitutes) {
        (false, _) => Load::Absent,
        (true, false) => Load::Touching(0.0),
        (true, true) => Load::Touching(random.random_range(0.0..1.0)),
    });
    (set, slip, load)
}

/// The rates that a hypothesis without starting slips demands, by its equations; `None` where they leave rates open.
fn rates(problem: &Problem, guess: &[Guess; 3]) -> Option<[Vec3; 3]> {
    let base = |i: usize| match problem.load[i] {
        Load::Touching(base) | Load::Prescribed(base) => base,
        Load::Absent => 0.0,
    };
    // What a normal rate of 1 brings about, friction included where the contact slips.
    let push: [Vec3; 3] = std::array::from_fn(|i| {
        let [x, y] = problem.slip[i];
        let speed = (x * x + y * y).sqrt();
        let mu = if guess[i].mode == Mode::Slips && speed > 0.0 { problem.friction[i] / speed } else { 0.0 };
        Vec3::new(-mu * x, -mu * y, 1.0)
    });
    let mut known = [Vec3::ZERO; 3];
    let mut unknown: Vec<(usize, Vec3, Vec3)> = vec![];
    for i in 0..problem.count {
        if guess[i].holds {
            unknown.push((i, push[i], Vec3::Z));
        } else if guess[i].mode != Mode::Open {
            known[i] = push[i] * base(i);
        }
        if guess[i].mode == Mode::Sticks {
            unknown.extend([(i, Vec3::X, Vec3::X), (i, Vec3::Y, Vec3::Y)]);
        }
    }
    let (mut matrix, mut right) = ([[0.0; UNKNOWNS]; UNKNOWNS], [0.0; UNKNOWNS]);
    for (k, (i, _, axis)) in unknown.iter().enumerate() {
        let of = |j: usize, rate: Vec3| (problem.operator[*i][j] * rate).dot(*axis);
        right[k] = -problem.drive[*i].dot(*axis) - (0..problem.count).map(|j| of(j, known[j])).sum::<f64>();
        for (l, (j, by, _)) in unknown.iter().enumerate() {
            matrix[k][l] = of(*j, *by);
        }
    }
    let found = solve_regular(matrix, right, unknown.len(), REGULAR)?;
    for ((i, by, _), x) in unknown.iter().zip(found) {
        known[*i] += *by * x;
    }
    Some(known)
}

/// Every inequality of a hypothesis without starting slips, with the share by which it is broken.
fn shares(problem: &Problem, guess: &[Guess; 3], rates: &[Vec3; 3]) -> Vec<(Condition, f64)> {
    let quotient = |lack: f64, size: f64| if size == 0.0 { 0.0 } else { lack / size };
    let base = |i: usize| if let Load::Touching(base) = problem.load[i] { base } else { 0.0 };
    let all: f64 = (0..problem.count).map(|i| rates[i].norm() + base(i)).sum();
    let mut out = vec![];
    for (i, (g, p)) in guess.iter().zip(rates).enumerate().take(problem.count) {
        if g.holds {
            out.push((Condition::Pushes(i), quotient(base(i) - p.z, all)));
        } else {
            let mut terms = vec![problem.drive[i].z];
            for (block, rate) in problem.operator[i].iter().zip(rates).take(problem.count) {
                let row = block.rows[2];
                terms.extend([row.x * rate.x, row.y * rate.y, row.z * rate.z]);
            }
            let size: f64 = terms.iter().map(|term| term.abs()).sum();
            out.push((Condition::Opens(i), quotient(-terms.iter().sum::<f64>(), size)));
        }
        // Only a push has a cone.
        if g.mode == Mode::Sticks && p.z >= 0.0 {
            let (friction, bound) = ((p.x * p.x + p.y * p.y).sqrt(), problem.friction[i] * p.z);
            out.push((Condition::WithinCone(i), quotient(friction - bound, friction + bound)));
        }
    }
    out
}

#[test]
fn every_share_in_space_is_in_zero_to_one_and_the_largest_is_named() {
    let mut random = Pcg64::seed_from_u64(24);
    let (mut rejected, mut compared) = (0_u32, 0_u32);
    for impact in 0..IMPACTS {
        let (set, slip, load) = drawn(&mut random);
        let (count, operator, friction, drive) = (set.count, &set.operator, &set.friction, set.velocity);
        let problem = Problem { count, operator, friction, drive, slip, load };
        problem.solve_observed(&mut |guess, named, slack| {
            rejected += 1;
            let by = -slack;
            assert!(by > 0.0 && by <= 1.0, "impact {impact}: {named:?} is broken by {by}");
            let starts = guess[..count].iter().any(|g| g.mode == Mode::Starts);
            let Some(rates) = (!starts).then(|| rates(&problem, guess)).flatten() else { return };
            let all = shares(&problem, guess, &rates);
            let most = all.iter().fold(0.0_f64, |most, (_, share)| most.max(*share));
            let share = all.iter().find(|(condition, _)| *condition == named).map(|(_, share)| *share);
            let share = share.unwrap_or_else(|| panic!("impact {impact}: {named:?} is none of {all:?}"));
            assert!((share - by).abs() < SAME, "impact {impact}: {named:?} by {by}, and not {share}");
            assert!(
                share > most - SAME,
                "impact {impact}: {named:?} by {share}, but there is {most}: {all:?}"
            );
            compared += 1;
        });
    }
    println!(
        "{rejected} hypotheses are rejected, {compared} of them by the largest share of all their inequalities"
    );
    assert!(compared > IMPACTS, "{compared}");
}
