//! Springs against closed forms, other conventions and themselves.

use super::super::staged;
use super::*;
use crate::planar::contacts::bodies::Meeting;
use crate::planar::contacts::bodies::RigidBody;
use crate::planar::contacts::set::Block;
use crate::planar::contacts::set::ContactSet2;
use crate::planar::contacts::set::Touch;
use crate::planar::contacts::single;
use carom_num::Vec2;
use carom_num::elementary::sin_cos;

/// What springs are followed to: a thousand steps of the error of one.
const FOLLOWED: f64 = 1e-8;

fn chain(second: f64) -> ContactSet2 {
    let cell = |nn, tt| Block { tt, tn: 0.0, nt: 0.0, nn };
    ContactSet {
        count: 2,
        operator: [[cell(2.0, 2.0), cell(-1.0, 0.0)], [cell(-1.0, 0.0), cell(2.0, 2.0)]],
        slip: [0.0; 2],
        normal: [-1.0, second],
        friction: [0.0; 2],
        restitution: [1.0; 2],
    }
}

/// Balls 0, 1, 2 of 1 kg with equal linear springs between them, ball 0 at 1 m/s: the closed form by normal modes while both springs
/// are loaded, then the last two alone.
fn three_balls() -> [f64; 3] {
    let root3 = 3.0_f64.sqrt();
    // δ₁,₂ = (sin t ± sin(√3 t)/√3)/2.
    let delta = |t: f64| {
        let (slow, fast) = (sin_cos(t).0, sin_cos(root3 * t).0 / root3);
        [(slow + fast) / 2.0, (slow - fast) / 2.0]
    };
    let rate = |t: f64| {
        let (slow, fast) = (sin_cos(t).1, sin_cos(root3 * t).1);
        [(slow + fast) / 2.0, (slow - fast) / 2.0]
    };
    let (mut low, mut high) = (1.5, 3.0);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if delta(middle)[0] > 0.0 { low = middle } else { high = middle }
    }
    let ([_, d2], [r1, r2]) = (delta(low), rate(low));
    // v₀ − v₁ = r₁, v₁ − v₂ = r₂, and the sum is 1.
    let v2 = (1.0 - r1 - 2.0 * r2) / 3.0;
    let (v1, v0) = (v2 + r2, v2 + r2 + r1);
    let (middle, apart) = (0.5 * (v1 + v2), (r2 * r2 + 2.0 * d2 * d2).sqrt());
    [v0, middle - 0.5 * apart, middle + 0.5 * apart]
}

#[test]
fn three_equal_balls_and_springs_move_as_their_normal_modes_do() {
    let out = by_stiffness(&chain(0.0), &[1.0, 1.0], 1.0).unwrap();
    let (p1, p2) = (out.impulse[0][1], out.impulse[1][1]);
    for (ours, closed) in [1.0 - p1, p1 - p2, p2].into_iter().zip(three_balls()) {
        assert!((ours - closed).abs() < 1e-9, "{ours} is not {closed}");
    }
    assert!(out.work.iter().flatten().sum::<f64>().abs() < 1e-10, "{out:?}");
}

#[test]
fn a_stiff_first_contact_is_over_before_the_second_begins() {
    let out = by_stiffness(&chain(0.0), &[1e8, 1.0], 1.5).unwrap();
    assert!((out.impulse[1][1] - 1.0).abs() < 1e-2 && (out.impulse[0][1] - 1.0).abs() < 1e-2, "{out:?}");
}

#[test]
fn one_contact_ends_as_stronges_law_says() {
    let set = ContactSet::<1, 2> {
        count: 1,
        operator: [[Block { tt: 3.0, tn: -0.8, nt: -0.8, nn: 1.5 }]],
        slip: [0.7],
        normal: [-1.0],
        friction: [0.6],
        restitution: [0.5],
    };
    let b = &set.operator[0][0];
    let contact = single::Contact {
        w_tt: b.tt,
        w_tn: b.tn,
        w_nn: b.nn,
        slip: 0.7,
        normal: -1.0,
        friction: 0.6,
        restitution: 0.5,
    };
    let stronge = single::resolve(&contact, Law::Stronge).unwrap();
    for exponent in [1.0, 1.5] {
        let out = by_stiffness(&set, &[1.0], exponent).unwrap();
        let off = (out.impulse[0][1] - stronge.normal_impulse).abs();
        assert!(
            off < FOLLOWED && (out.velocity[0][0] - stronge.slip).abs() < FOLLOWED,
            "{out:?} {stronge:?}"
        );
    }
}

#[test]
fn stiffness_of_symmetric_contacts_changes_nothing() {
    // Both ends of a symmetric rod close alike: any symmetric sharing ends as together.
    let mut set = chain(-1.0);
    set.restitution = [0.7; 2];
    let springs = by_stiffness(&set, &[2.0, 2.0], 1.0).unwrap();
    let together = staged::resolve(&set, Law::Poisson).unwrap();
    for i in 0..2 {
        assert!((springs.velocity[i][1] - together.velocity[i][1]).abs() < 1e-9, "{springs:?} {together:?}");
    }
}

#[test]
fn what_no_spring_can_do_is_refused() {
    let mut dead = chain(0.0);
    dead.restitution[1] = 0.0;
    let text = by_stiffness(&dead, &[1.0; 2], 1.0).unwrap_err().to_string();
    assert_eq!(text, "restitution of contact 1 is 0, allowed is 0.01 to 1 for sharing by stiffness");
    assert!(by_stiffness(&chain(0.0), &[1.0, 0.0], 1.0).is_err(), "no stiffness");
    assert!(by_stiffness(&chain(0.0), &[1.0; 2], 0.5).is_err(), "no such spring");
}

/// Three balls in a row of radius 30 mm and 1 kg but for the second, the first of which comes with 1 m/s and stands `off` the line; the second ball
/// touches the third at the height `high`.
fn row(off: f64, second: f64, high: f64) -> ContactSet2 {
    let ball = |x: f64, y: f64, v: f64, mass: f64| RigidBody {
        mass,
        inertia: 4e-4,
        centre: Vec2::new(x, y),
        velocity: Vec2::new(v, 0.0),
        spin: 0.0,
    };
    let bodies = [ball(0.0, off, 1.0, 1.0), ball(0.06, 0.0, 0.0, second), ball(0.12, 0.0, 0.0, 1.0)];
    let meet = |i: usize, y: f64| Meeting {
        into: i + 1,
        out_of: i,
        point: Vec2::new(0.03 + 0.06 * f64::from(u8::from(i == 1)), y),
        normal: Vec2::new(1.0, 0.0),
        friction: 0.0,
        restitution: 1.0,
    };
    ContactSet2::of_bodies(&bodies, &[meet(0, 0.0), meet(1, high)]).unwrap()
}

/// Without friction slips do not act: as they are, they turn round or run by rounding beside zero; added 3 m/s they do nothing of the kind, and
/// the normal impulses are the same.
#[test]
fn a_slip_without_friction_matters_to_nothing() {
    let slightly = [1e-9, 1e-6, 1e-5, 5e-4, -2e-3].map(|off| row(off, 1.0, 0.0));
    let others = [row(0.0, 1.0, 1e-12), row(0.0, 1e-3, -0.055_263_046_436_332_84)];
    for (k, set) in slightly.into_iter().chain(others).enumerate() {
        for exponent in [1.0, 1.5] {
            let plain = by_stiffness(&set, &[1.0, 1.0], exponent).unwrap();
            let mut sliding = set;
            sliding.slip = set.slip.map(|u| u + 3.0);
            let sliding = by_stiffness(&sliding, &[1.0, 1.0], exponent).unwrap();
            for i in 0..2 {
                let [a, b] = [plain, sliding].map(|out| out.impulse[i][1]);
                assert!(
                    (a - b).abs() < FOLLOWED && plain.impulse[i][0] == 0.0,
                    "{k}, contact {i}: {a} is not {b}"
                );
            }
            let energy: f64 = plain.work.iter().flatten().sum();
            assert!(energy.abs() < FOLLOWED, "{k}: {energy} J of 0.5 J are lost or gained without friction");
        }
    }
}

/// With friction that hardly acts a slip beside zero does hardly more than without.
#[test]
fn little_friction_does_little() {
    for off in [1e-6, 1e-4, 2e-3] {
        let smooth = row(off, 1.0, 0.0);
        for friction in [1e-12, 1e-9, 1e-6] {
            let mut rough = smooth;
            rough.friction = [friction; 2];
            let [a, b] = [smooth, rough].map(|set| by_stiffness(&set, &[1.0, 1.0], 1.5).unwrap());
            for i in 0..2 {
                // The row's arms are shorter than its radii of gyration: no more than a few times the friction.
                let off = (a.impulse[i][1] - b.impulse[i][1]).abs();
                assert!(off < 10.0 * friction + FOLLOWED, "friction {friction} changes an impulse by {off}");
            }
        }
    }
}

/// A body falls between two steep faces, whose friction could hold it at twice the slope: the springs stay loaded and hold each other. It comes to
/// rest, and all of its energy is gone.
#[test]
fn springs_that_hold_each_other_end_the_impact_at_rest() {
    let (sin, cos) = sin_cos(0.175);
    let face = |side: f64| Touch {
        arm: Vec2::new(-0.1 * side, 0.0),
        normal: Vec2::new(side * cos, sin),
        friction: 0.5,
        restitution: 0.5,
    };
    let set =
        ContactSet2::of_free_body(1.0, 0.01, Vec2::new(0.0, -1.0), 0.0, &[face(1.0), face(-1.0)]).unwrap();
    for (stiffness, exponent) in [([1.0; 2], 1.0), ([1.0; 2], 1.5), ([1.0, 3.0], 1.0)] {
        let out = by_stiffness(&set, &stiffness, exponent).unwrap();
        assert_eq!(out.velocity, [[0.0; 2]; 2], "{stiffness:?}, {exponent}: it rests");
        let energy: f64 = out.work.iter().flatten().sum();
        assert!((energy + 0.5).abs() < 1e-9, "{stiffness:?}, {exponent}: {energy} J of -0.5 J");
        for [along, push] in out.impulse {
            assert!(
                push > 0.0 && along.abs() <= 0.5 * push,
                "friction is within the cone: {:?}",
                out.impulse
            );
        }
    }
}

fn touch(arm: (f64, f64), normal: (f64, f64)) -> Touch {
    let [arm, normal] = [arm, normal].map(|(x, y)| Vec2::new(x, y));
    Touch { arm, normal, friction: 0.3377, restitution: 0.1999 }
}

/// The kinetic energy that springs leave of a free body's, as a share; every contact opens or rests.
fn left_over<const N: usize, const M: usize>(set: &ContactSet<N, M>, energy: f64, exponent: f64) -> f64 {
    let out = by_stiffness(set, &[1.0; N], exponent).unwrap();
    for [_, up] in &out.velocity[..set.count] {
        assert!(*up >= 0.0, "no contact still closes: {:?}", out.velocity);
    }
    1.0 + out.work.iter().flatten().sum::<f64>() / energy
}

/// Three feet on one line stick, and how they share the friction is open; all of it is used up at once. What was about to be loaded at the wall
/// was looked at ahead of its time there, and let the rate problem say that they stick still: 20 000 stages without a motion.
#[test]
fn feet_that_share_their_friction_let_go_together() {
    let feet = [-0.08, 0.0164, 0.08].map(|x| touch((x, -0.0434), (0.0, 1.0)));
    let touches = [feet[0], feet[1], feet[2], touch((-0.09, 0.0084), (1.0, 0.0))];
    let (mass, inertia, velocity, spin) = (0.314, 0.000_690_8, Vec2::new(-0.341, -1.6553), 0.695);
    let set = ContactSet::<4, 8>::of_free_body(mass, inertia, velocity, spin, &touches).unwrap();
    let energy = 0.5 * (mass * velocity.dot(velocity) + inertia * spin * spin);
    for exponent in [1.0, 1.5] {
        let left = left_over(&set, energy, exponent);
        // Springs return e² of what they hold, 4 %; friction returns nothing.
        assert!(left > 0.0 && left < 0.1, "{exponent}: {left} of the energy is left");
    }
}

/// Friction holds both contacts from the start: what is left of their cones begins at zero, and leaves it as the springs' loads do.
#[test]
fn contacts_that_stick_from_the_start_do_so_whatever_the_exponent() {
    let touches =
        [0.3, -0.25].map(|x| Touch { friction: 2.0, restitution: 0.5, ..touch((x, -1.0), (0.0, 1.0)) });
    let set = ContactSet::<2, 4>::of_free_body(1.0, 0.4, Vec2::new(0.0, -2.0), 0.0, &touches).unwrap();
    for exponent in [1.0, 1.5, 2.0, 2.1, 2.5, 2.9, 3.0] {
        let left = left_over(&set, 2.0, exponent);
        assert!(left > 0.0 && left < 1.0, "{exponent}: {left} of the energy is left");
    }
}

/// Bodies on up to six contacts, flat and wedged: of 600 all end, and none gains energy.
#[test]
fn random_contacts_come_to_an_end() {
    for case in 0..600 {
        let count = 1 + case as usize % 6;
        let at: [f64; 16] = std::array::from_fn(|dimension| carom_num::sobol::random(7, case, dimension));
        let touches: Vec<Touch> = (0..count)
            .map(|i| {
                let (sin, cos) = sin_cos(if i % 2 == 1 { 1.5 * (at[4 + i] - 0.5) } else { 0.0 });
                touch((2.0 * at[10 + i] - 1.0, -0.5), (-sin, cos))
            })
            .collect();
        let (velocity, spin) = (Vec2::new(2.0 * at[0] - 1.0, -at[1]), 2.0 * at[2] - 1.0);
        let set = ContactSet::<6, 12>::of_free_body(1.0, 0.3, velocity, spin, &touches).unwrap();
        let energy = 0.5 * (velocity.dot(velocity) + 0.3 * spin * spin);
        let exponent = [1.0, 1.5, 2.0, 2.5, 3.0][case as usize % 5];
        let left = left_over(&set, energy, exponent);
        assert!((-1e-9..=1.0 + 1e-9).contains(&left), "{count} contacts: {left} of the energy is left");
    }
}
