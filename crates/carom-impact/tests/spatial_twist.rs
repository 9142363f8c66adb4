//! Bodies that fall flat on two or more supports while they spin about the normal: closed form, and all outcomes where they drift as well.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test fails by panicking, and says what it measured"
)]

use crate::random;

use carom_impact::Law;
use carom_impact::spatial::{ContactSet, Mode, Preference, RigidBody, StageEvent, Touch, staged};
use carom_num::elementary::sin_cos;
use carom_num::{Mat3, Vec3};
use carom_theory::spatial::{SpinStops, Twist};
use random::numbers;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// A slip that turns takes some hundred steps, each with the rounding of its velocities.
const ROUNDING: f64 = 1e-12;

/// Supports evenly on a circle below the mass centre.
fn supports(count: u32, radius: f64, height: f64, friction: f64, restitution: f64) -> Vec<Touch> {
    let touch = |i: u32| {
        let (sin, cos) = sin_cos(TAU * f64::from(i) / f64::from(count));
        Touch { arm: Vec3::new(radius * cos, radius * sin, -height), normal: Vec3::Z, friction, restitution }
    };
    (0..count).map(touch).collect()
}

#[test]
fn a_spin_about_the_normal_ends_as_its_closed_form_says() {
    let (mut worst, mut outcomes) = (0.0_f64, [0; 3]);
    for case in 0..3000 {
        let random = numbers(case);
        let count = 2 + case % 3;
        let twist = Twist {
            mass: 0.5 + random(0),
            inertia: 0.05 + 0.2 * random(1),
            circle_radius: 0.2 + random(2),
            approach: 0.1 + random(3),
            spin: 12.0 * random(4) - 6.0,
            friction: 1.5 * random(5),
            restitution: random(6),
        };
        let height = 0.8 * random(7);
        let body = RigidBody {
            mass: twist.mass,
            inertia: Mat3::diagonal(0.8 * twist.inertia, 0.9 * twist.inertia, twist.inertia),
            velocity: Vec3::Z * -twist.approach,
            spin: Vec3::Z * twist.spin,
        };
        let touches = supports(count, twist.circle_radius, height, twist.friction, twist.restitution);
        let set = ContactSet::<4>::of_free_body(&body, &touches).unwrap();
        let out = staged::resolve(&set, Law::Poisson).unwrap();
        let wanted = twist.after().unwrap();
        outcomes[wanted.stops as usize] += 1;
        let after = touches.iter().enumerate().fold(body, |b, (i, touch)| {
            b.pushed(touch.arm, set.frame[i].transposed() * out.impulse[i]).unwrap()
        });
        let normal: f64 = out.impulse.iter().map(|p| p.z).sum();
        let pairs = [
            (after.spin.z, wanted.spin),
            (after.velocity.z, wanted.rising),
            (normal, wanted.normal_impulse),
            (after.spin.x, 0.0),
            (after.spin.y, 0.0),
            (after.velocity.x, 0.0),
            (after.velocity.y, 0.0),
        ];
        for (ours, theirs) in pairs {
            worst = worst.max((ours - theirs).abs() / (1.0 + theirs.abs()));
        }
        assert!(worst < 1e-11, "case {case}: {twist:?} {wanted:?} {out:?}");
        let demand = out.friction_demand();
        assert!(demand <= twist.friction + 1e-9, "case {case}: {demand} {twist:?}");
        assert!(
            wanted.stops != SpinStops::Not
                || twist.spin.abs() < 1e-3
                || (demand - twist.friction).abs() < 1e-9
        );
    }
    println!(
        "3000 twists: {worst:.1e}; the spin goes on, stops in restitution, in compression: {outcomes:?}"
    );
    assert!(outcomes.iter().all(|n| *n > 200), "{outcomes:?}");
}

#[test]
fn up_to_sixteen_supports_share_a_spin_evenly() {
    for (count, friction) in [(5, 0.2), (6, 0.9), (8, 0.2), (8, 0.9), (13, 0.2), (16, 0.9)] {
        let twist = Twist {
            mass: 1.0,
            inertia: 0.1,
            circle_radius: 0.4,
            approach: 1.0,
            spin: 2.5,
            friction,
            restitution: 0.5,
        };
        let inertia = Mat3::diagonal(0.08, 0.09, twist.inertia);
        let body = RigidBody { mass: 1.0, inertia, velocity: -Vec3::Z, spin: Vec3::Z * twist.spin };
        let touches = supports(count, twist.circle_radius, 0.3, friction, twist.restitution);
        let set = ContactSet::<16>::of_free_body(&body, &touches).unwrap();
        let out = staged::resolve(&set, Law::Poisson).unwrap();
        let wanted = twist.after().unwrap();
        let each = wanted.normal_impulse / f64::from(count);
        let along: f64 = (0..set.count)
            .map(|i| {
                let p = set.frame[i].transposed() * out.impulse[i];
                Vec3::Z.cross(touches[i].arm).dot(p) / twist.circle_radius
            })
            .sum();
        println!("{count} supports, friction {friction}: {:?}, along the circle {along:.12}", wanted.stops);
        assert!((along - wanted.friction_impulse).abs() < ROUNDING, "{along} {wanted:?}");
        assert!(out.impulse[..set.count].iter().all(|p| (p.z - each).abs() < ROUNDING), "{out:?}");
    }
    let many = ContactSet::<17> {
        count: 17,
        ..ContactSet::of_free_body(
            &RigidBody { mass: 1.0, inertia: Mat3::IDENTITY, velocity: -Vec3::Z, spin: Vec3::ZERO },
            &supports(17, 1.0, 1.0, 0.1, 0.0),
        )
        .unwrap()
    };
    assert_eq!(
        staged::resolve(&many, Law::Poisson).unwrap_err().to_string(),
        "17 contacts at once: at most 16 are resolved"
    );
}

/// A rod of 1 kg and 1 m falls flat on its ends with 1 m/s, spins about the normal and drifts: its slips turn, and stop one after the other or not at
/// all. All ways there are, by the events of the walk, each with a friction, a drift (across the rod, along it) and a spin at which it is met.
#[test]
fn a_drifting_rod_has_these_outcomes() {
    let inertia = Mat3::diagonal(1e-4, 1.0 / 12.0, 1.0 / 12.0);
    let mut outcomes = BTreeMap::new();
    for i in 0..6 * 7 * 7 * 7_u32 {
        let [a, b, c, d] = [i % 6, i / 6 % 7, i / 42 % 7, i / 294].map(f64::from);
        let (friction, drift, spin) = (0.05 + 0.2 * a, Vec3::new(0.4 * b, 0.4 * c, -1.0), 0.9 * d);
        let rod = RigidBody { mass: 1.0, inertia, velocity: drift, spin: Vec3::Z * spin };
        let ends = supports(2, 0.5, 0.0, friction, 0.5);
        let set = ContactSet::<2>::of_free_body(&rod, &ends).unwrap();
        let mut events = vec![];
        let out = staged::resolve_observed(&set, Law::Poisson, Preference::default(), &mut |stage| {
            events.push((stage.mode, stage.ended_by))
        });
        let out = out.unwrap();
        assert!(out.branches == 1 && out.velocity.iter().all(|u| (u.z - 0.5).abs() < ROUNDING), "{out:?}");
        // Which end is which does not count.
        let name = |(mode, event): &([Mode; 2], StageEvent)| {
            let slipping = mode.iter().filter(|m| matches!(m, Mode::Slips | Mode::Starts)).count();
            let end = match event {
                StageEvent::SlipStops(_) => "an end stops",
                StageEvent::SlipStarts(_) => "an end starts",
                StageEvent::CompressionEnds => "compression ends",
                _ => "restitution ends",
            };
            format!("{slipping} slip until {end}")
        };
        let named: Vec<String> = events.iter().map(name).collect();
        let at = format!("friction {friction:.2}, drift {:.1} {:.1}, spin {spin:.1}", drift.y, drift.x);
        outcomes.entry(named).or_insert((0, at)).0 += 1;
    }
    for (events, (number, at)) in &outcomes {
        println!("{number:5} {events:?}, as {at}");
    }
    let all = |word: &str| outcomes.keys().any(|events| events.iter().any(|e| e.contains(word)));
    assert!(outcomes.len() >= 4 && all("0 slip") && all("1 slip") && all("2 slip"), "{outcomes:?}");
}
