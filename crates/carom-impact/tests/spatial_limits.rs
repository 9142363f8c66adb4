//! Several contacts with friction in space: limits that other programs know, symmetries, and bodies that meet.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test fails by panicking, and says what it measured"
)]

use crate::random;

use carom_impact::Law;
use carom_impact::spatial::{
    Conclusion, ContactSet, Meeting, RigidBody, StagedOutcome, Touch, staged, struck,
};
use carom_num::lemke::lemke;
use carom_num::{Mat3, Rotation, Vec3};
use random::numbers;

/// What a walk with slips that turn is exact to.
const EXACT: f64 = 1e-10;
/// The same with a slip that starts smoothly, which is followed by a rule of second order.
const ONSET: f64 = 2e-8;

fn many(case: u32) -> impl Fn(usize) -> f64 {
    let all: Vec<f64> = (0..5).flat_map(|k| (0..16).map(numbers(5 * case + k)).collect::<Vec<_>>()).collect();
    move |k| all[k]
}

fn vector(random: &impl Fn(usize) -> f64, k: usize) -> Vec3 {
    Vec3::new(random(k), random(k + 1), random(k + 2)) * 2.0 - Vec3::new(1.0, 1.0, 1.0)
}

fn random_body(random: &impl Fn(usize) -> f64, k: usize) -> RigidBody {
    let [a, b] = [0.3 + random(k), 0.3 + random(k + 1)];
    let third = (a - b).abs() + (a + b - (a - b).abs()) * (0.05 + 0.9 * random(k + 2));
    let turned = Rotation::by(vector(random, k + 3) * 3.0);
    RigidBody {
        mass: 0.5 + random(k + 9),
        inertia: turned.turn(Mat3::diagonal(a, b, third)) * 0.3,
        velocity: vector(random, k + 6),
        spin: vector(random, k + 10) * 3.0,
    }
}

/// Contacts below the body, their normals up to about 45° off the vertical.
fn below(random: &impl Fn(usize) -> f64, count: usize, tilt: f64) -> Vec<Touch> {
    let touch = |i: usize| Touch {
        arm: Vec3::new(
            2.0 * random(16 + 8 * i) - 1.0,
            2.0 * random(17 + 8 * i) - 1.0,
            -0.2 - 0.5 * random(18 + 8 * i),
        ),
        normal: (vector(random, 19 + 8 * i) * tilt + Vec3::Z).unit().unwrap(),
        friction: 1.2 * random(22 + 8 * i),
        restitution: random(23 + 8 * i),
    };
    (0..count).map(touch).collect()
}

fn largest(set: &ContactSet<4>) -> f64 {
    set.velocity[..set.count].iter().map(|u| u.norm()).fold(0.0, f64::max)
}

/// True where nothing was chosen and nothing was decided by rounding.
fn is_clear(out: &StagedOutcome<4>) -> bool {
    out.branches == 1 && out.margin > 1e-7
}

#[test]
fn without_friction_it_is_the_linear_complementarity_problem() {
    let mut worst = 0.0_f64;
    for case in 0..3000 {
        let random = many(case);
        let count = 1 + case as usize % 4;
        let mut touches = below(&random, count, 0.5);
        touches.iter_mut().for_each(|t| (t.friction, t.restitution) = (0.0, 0.0));
        let mut set = ContactSet::<4>::of_free_body(&random_body(&random, 0), &touches).unwrap();
        set.velocity.iter_mut().for_each(|u| u.z = -u.z.abs());
        let out = staged::resolve(&set, Law::Poisson).unwrap();
        let matrix: Vec<Vec<f64>> =
            (0..count).map(|i| (0..count).map(|j| set.operator[i][j].rows[2].z).collect()).collect();
        let approach: Vec<f64> = (0..count).map(|i| set.velocity[i].z).collect();
        let p = lemke(&matrix, &approach).unwrap();
        for i in 0..count {
            let u = approach[i] + (0..count).map(|j| matrix[i][j] * p[j]).sum::<f64>();
            worst = worst.max((out.velocity[i].z - u).abs() / largest(&set));
            assert!(worst < 1e-10, "case {case}: {out:?} {p:?}");
        }
    }
    println!("3000 smooth impacts: {worst:.1e} from their complementarity problems");
}

#[test]
fn with_friction_without_bound_it_is_the_law_that_nothing_slides() {
    let (mut worst, mut unique, mut jammed) = (0.0_f64, 0, 0);
    for case in 0..2000 {
        let random = many(case);
        let count = 1 + case as usize % 4;
        let mut touches = below(&random, count, if case % 8 < 4 { 0.0 } else { 0.4 });
        touches.iter_mut().for_each(|t| (t.friction, t.restitution) = (1e9, 0.0));
        let mut set = ContactSet::<4>::of_free_body(&random_body(&random, 0), &touches).unwrap();
        // Contacts that do not slip before: with a slip, the walk stops it on its way, and ends elsewhere.
        set.velocity.iter_mut().for_each(|u| *u = Vec3::Z * -u.z.abs());
        let states = set.states_of_keeping();
        if states.conclusion() != Conclusion::Unique {
            continue;
        }
        unique += 1;
        let Ok(out) = staged::resolve(&set, Law::Poisson) else {
            jammed += 1;
            continue;
        };
        let pairs = states.consistent[0].velocity[..count].iter().zip(&out.velocity);
        worst = worst.max(pairs.map(|(a, b)| (*a - *b).norm()).fold(0.0, f64::max) / largest(&set));
        assert!(worst < 1e-6, "case {case}: {worst:e} {out:?} {states:?}");
    }
    println!("{unique} impacts without slip before that have one state: {worst:.1e}; {jammed} refused");
    assert!(unique > 900 && jammed * 100 < unique, "{unique} {jammed}");
}

#[test]
fn turning_the_world_turns_the_outcome() {
    let (mut worst, mut compared) = ([0.0_f64; 2], 0);
    for case in 0..2000 {
        let random = many(case);
        let (body, touches) = (random_body(&random, 0), below(&random, 1 + case as usize % 4, 0.4));
        let about = Rotation::by(vector(&random, 60) * 3.0);
        let turned = RigidBody {
            inertia: about.turn(body.inertia),
            velocity: about.apply(body.velocity),
            spin: about.apply(body.spin),
            ..body
        };
        let turned_touches: Vec<Touch> = touches
            .iter()
            .map(|t| Touch { arm: about.apply(t.arm), normal: about.apply(t.normal).unit().unwrap(), ..*t })
            .collect();
        let [a, b] = [(&body, &touches), (&turned, &turned_touches)]
            .map(|(body, touches)| ContactSet::<4>::of_free_body(body, touches).unwrap());
        for (k, law) in [Law::Poisson, Law::Stronge].into_iter().enumerate() {
            let (Ok(one), Ok(other)) = (staged::resolve(&a, law), staged::resolve(&b, law)) else { continue };
            if !is_clear(&one) || !is_clear(&other) {
                continue;
            }
            compared += 1;
            for i in 0..a.count {
                let [world, there] =
                    [(&a, &one), (&b, &other)].map(|(set, out)| set.frame[i].transposed() * out.velocity[i]);
                worst[k] = worst[k].max((about.apply(world) - there).norm() / largest(&a));
            }
            assert!(worst.iter().all(|w| *w < 1e-9), "case {case} {law:?}: {worst:?} {one:?} {other:?}");
        }
    }
    println!("{compared} impacts, turned, Poisson's law and Stronge's: {:.1e} {:.1e}", worst[0], worst[1]);
    assert!(compared > 3000, "{compared}");
}

#[test]
fn the_order_of_the_contacts_does_not_matter() {
    let (mut worst, mut compared) = (0.0_f64, 0);
    for case in 0..2000 {
        let random = many(case);
        let count = 2 + case as usize % 3;
        let (body, touches) = (random_body(&random, 0), below(&random, count, 0.4));
        let mut reversed = touches.clone();
        reversed.reverse();
        let [a, b] = [&touches, &reversed].map(|t| ContactSet::<4>::of_free_body(&body, t).unwrap());
        let (one, other) =
            (staged::resolve(&a, Law::Poisson).unwrap(), staged::resolve(&b, Law::Poisson).unwrap());
        if !is_clear(&one) || !is_clear(&other) {
            continue;
        }
        compared += 1;
        for i in 0..count {
            worst = worst.max((one.velocity[i] - other.velocity[count - 1 - i]).norm() / largest(&a));
        }
        assert!(worst < 1e-9, "case {case}: {worst:e} {one:?} {other:?}");
    }
    println!("{compared} impacts in reverse order: {worst:.1e}");
    assert!(compared > 1500, "{compared}");
}

/// Two bodies meet at up to three points, and one of them touches what does not yield.
fn meetings(random: &impl Fn(usize) -> f64, count: usize) -> Vec<Meeting> {
    let mut touches = below(random, count, 0.4);
    // The other body lies below: its contact points are above its centre.
    let other =
        |i: usize| Vec3::new(random(16 + 8 * i) - 0.5, random(17 + 8 * i) - 0.5, 0.3 + 0.3 * random(56 + i));
    let mut out: Vec<Meeting> =
        (1..count).map(|i| Meeting { body: 0, touch: touches[i], other: Some((1, other(i))) }).collect();
    touches[0].arm.z -= 0.2;
    out.push(Meeting { body: 1, touch: touches[0], other: None });
    out
}

#[test]
fn two_bodies_keep_their_momentum_and_gain_no_energy() {
    let (mut greatest, mut worst, mut refused, mut smooth) = (f64::NEG_INFINITY, 0.0_f64, 0, 0);
    for case in 0..3000 {
        let random = many(case);
        let bodies = [random_body(&random, 0), random_body(&random, 64)];
        let meetings = meetings(&random, 2 + case as usize % 3);
        let set = ContactSet::<4>::of_bodies(&bodies, &meetings).unwrap();
        let out = match staged::resolve(&set, Law::Stronge) {
            Ok(out) => out,
            Err(why) => {
                println!("case {case}: {why}");
                refused += 1;
                continue;
            }
        };
        let after = struck(&bodies, &meetings, &out.impulse).unwrap();
        let energy = |all: &[RigidBody]| all.iter().map(RigidBody::energy).sum::<f64>();
        let gained = energy(&after) - energy(&bodies);
        let mut here = (gained - out.total_work()).abs() / energy(&bodies);
        if out.impulse != [Vec3::ZERO; 4] {
            greatest = greatest.max(gained / energy(&bodies));
        }
        // What the two exchange leaves their momentum: the floor gives the rest.
        let momentum = |all: &[RigidBody]| all.iter().fold(Vec3::ZERO, |p, b| p + b.velocity * b.mass);
        let last = meetings.len() - 1;
        let floor = set.frame[last].transposed() * out.impulse[last];
        let off = (momentum(&after) - momentum(&bodies) - floor).norm() / (1.0 + floor.norm());
        here = here.max(off);
        let again = ContactSet::<4>::of_bodies(&after, &meetings).unwrap();
        for i in 0..set.count {
            let approach =
                (-again.velocity[i].z).max((again.velocity[i] - out.velocity[i]).norm()) / largest(&set);
            here = here.max(approach);
        }
        if here < EXACT {
            worst = worst.max(here);
        } else {
            smooth += 1;
        }
        assert!(here < ONSET && greatest < 1e-11, "case {case}: {here:e} {greatest:e} {out:?}");
    }
    println!(
        "3000 meetings: energy at most {greatest:.1e}, momentum and work to {worst:.1e} but for {smooth}, {refused} refused"
    );
    // Contacts that hand the load to each other again and again are given up.
    assert!(refused <= 3 && smooth <= 3, "{refused} {smooth}");
}

#[test]
fn contacts_in_all_directions_gain_no_energy() {
    let (mut greatest, mut refused, mut paradox, mut branches, mut most) = (f64::NEG_INFINITY, 0, 0, 0, 0);
    for case in 0..1500 {
        let random = many(case);
        let (body, mut touches) = (random_body(&random, 0), below(&random, 1 + case as usize % 4, 1.0));
        touches.iter_mut().for_each(|t| t.friction *= 2.0);
        let set = ContactSet::<4>::of_free_body(&body, &touches).unwrap();
        for law in [Law::Poisson, Law::Stronge] {
            let out = match staged::resolve(&set, law) {
                Ok(out) => out,
                Err(why) => {
                    println!("case {case} {law:?}: {why}");
                    refused += 1;
                    continue;
                }
            };
            paradox += usize::from(out.without_approach);
            branches += usize::from(out.branches > 1);
            most = most.max(out.stages);
            let after = touches.iter().enumerate().fold(body, |b, (i, touch)| {
                b.pushed(touch.arm, set.frame[i].transposed() * out.impulse[i]).unwrap()
            });
            if out.impulse != [Vec3::ZERO; 4] {
                greatest = greatest.max((after.energy() - body.energy()) / body.energy());
            }
            assert!(greatest < 1e-11, "case {case}: {greatest:e} {out:?}");
            assert!(out.velocity[..set.count].iter().all(|u| u.z >= 0.0), "case {case}: {out:?}");
        }
    }
    println!(
        "3000 impacts: energy at most {greatest:.1e}, {refused} refused, {branches} with branches, {paradox} without approach, most {most} stages"
    );
    // Contacts that hold each other, or hand the load to each other again and again, are given up.
    assert!(refused <= 3, "{refused}");
}

/// With a slip before, ample friction stops it first. At one contact the end is then the law's that nothing slides; at several the slips stop one after another, and
/// contacts may open meanwhile: often it is another end.
#[test]
fn with_a_slip_before_ample_friction_comes_near_that_law() {
    for (count, friction, least) in [(1, 10.0, 0.9), (1, 1000.0, 0.99), (2, 10.0, 0.5), (2, 1000.0, 0.5)] {
        let (mut near, mut all, mut refused) = (0, 0, 0);
        for case in 0..300 {
            let random = many(case);
            let mut touches = below(&random, count, 0.0);
            touches.iter_mut().for_each(|t| (t.friction, t.restitution) = (friction, 0.0));
            let set = ContactSet::<4>::of_free_body(&random_body(&random, 0), &touches).unwrap();
            let states = set.states_of_keeping();
            if set.velocity[..count].iter().any(|u| u.z >= 0.0) || states.conclusion() != Conclusion::Unique {
                continue;
            }
            let Ok(out) = staged::resolve(&set, Law::Poisson) else {
                refused += 1;
                continue;
            };
            let pairs = states.consistent[0].velocity[..count].iter().zip(&out.velocity);
            let apart = pairs.map(|(a, b)| (*a - *b).norm()).fold(0.0, f64::max) / largest(&set);
            all += 1;
            near += u32::from(apart < 0.01);
        }
        println!("{count} at friction {friction}: {near} of {all} within 1 %, {refused} refused");
        assert!(all > 20 && f64::from(near) > least * f64::from(all), "{count} {friction}: {near} of {all}");
    }
}
